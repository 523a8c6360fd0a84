/*
 * What Python hands to the functions of this package, read where it lies.
 *
 * Looking at an array from Python costs more than most of these functions take. Whatever is not
 * exactly as the C wants it is UNFIT, and takes the general way.
 *
 * For many epochs a tuple of everything comes by its address, as `id` gives it: first the type of
 * NumPy's arrays, then inputs, then outputs. Its owner keeps it alive during the call. Nothing of
 * Python is changed, no reference is counted, so that other threads may go on meanwhile. For one
 * epoch there are calls of Python's own; see calls.h.
 *
 * Part of the extension for Python, not of the exported C.
 */
#ifndef SYMNAV_STRAIGHT_H
#define SYMNAV_STRAIGHT_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_1_7_API_VERSION
#include <numpy/ndarraytypes.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Answer to what must take the general way; every status is larger. */
#define UNFIT (-1)

/* An axis as long as there are items, and one without the item that is subtracted from them. */
#define ITEMS (-1)
#define OTHERS (-2)

/* What the C wants: kind of number and its bytes, whether it is written, and the axes of one
   epoch. */
typedef struct {
    int kind;
    int32_t size;
    bool written;
    int rank;
    npy_intp shape[3];
} wanted_t;

/* What there was: the first element and the number of elements of an epoch, zero where all epochs
   share one. A number that is no array is kept here. */
typedef struct {
    void *at;
    ptrdiff_t step;
    ptrdiff_t bytes;
    union {
        double real;
        float single;
        int32_t integer;
    } number;
} taken_t;

/* Lengths of the axes that are known at run time; negative until an array shows them. */
typedef struct {
    npy_intp epochs;
    npy_intp items;
} extent_t;

/* A number of Python where the C wants an array of one element. */
static inline bool take_number(PyObject *object, const wanted_t *wanted, taken_t *taken)
{
    bool fits = !wanted->written && (wanted->rank == 0);

    taken->at = &taken->number;
    taken->step = 0;
    taken->bytes = wanted->size;
    if (fits && PyFloat_Check(object)) {
        const double real = PyFloat_AS_DOUBLE(object);

        fits = (wanted->kind == NPY_DOUBLE) || (wanted->kind == NPY_FLOAT);
        if (wanted->kind == NPY_FLOAT) {
            taken->number.single = (float)real;
        } else {
            taken->number.real = real;
        }
    } else if (fits && PyLong_CheckExact(object)) {
        int beyond = 0;
        const long integer = PyLong_AsLongAndOverflow(object, &beyond);

        fits = (wanted->kind == NPY_INT32) && (beyond == 0) && (integer == (int32_t)integer);
        taken->number.integer = (int32_t)integer;
    } else {
        fits = false;
    }
    return fits;
}

/* True when the axes of one epoch are as wanted; counts their elements. */
static inline bool take_shape(
    const npy_intp shape[],
    const wanted_t *wanted,
    extent_t *extent,
    ptrdiff_t *elements)
{
    bool fits = true;

    *elements = 1;
    for (int axis = 0; axis < wanted->rank; ++axis) {
        npy_intp length = wanted->shape[axis];

        if (length == ITEMS) {
            if (extent->items < 0) {
                extent->items = shape[axis];
            }
            length = extent->items;
        } else if (length == OTHERS) {
            length = extent->items - 1;
        }
        fits = fits && (shape[axis] == length);
        *elements *= shape[axis];
    }
    return fits;
}

/* An array, with an axis of epochs in front where there are many and they do not share it. */
static inline bool take_array(
    PyArrayObject *array,
    const wanted_t *wanted,
    bool many,
    extent_t *extent,
    taken_t *taken)
{
    const int flags = wanted->written ? NPY_ARRAY_CARRAY : NPY_ARRAY_CARRAY_RO;
    const npy_intp *shape = PyArray_DIMS(array);
    const int lead = PyArray_NDIM(array) - wanted->rank;
    ptrdiff_t elements = 0;
    ptrdiff_t epochs = 1;

    if ((lead < ((many && wanted->written) ? 1 : 0)) || (lead > (many ? 1 : 0))) {
        return false;
    }
    if (lead == 1) {
        if (extent->epochs < 0) {
            extent->epochs = shape[0];
        }
        epochs = shape[0];
        if (epochs != extent->epochs) {
            return false;
        }
    }
    if ((PyArray_TYPE(array) != wanted->kind) || !PyArray_ISNBO(PyArray_DESCR(array)->byteorder)
        || ((PyArray_FLAGS(array) & flags) != flags)
        || !take_shape(&shape[lead], wanted, extent, &elements)) {
        return false;
    }
    taken->at = PyArray_DATA(array);
    taken->step = (lead == 1) ? elements : 0;
    taken->bytes = epochs * elements * wanted->size;
    return true;
}

/* True when what is written shares no memory with anything in front of it. */
static inline bool lies_apart(const taken_t taken[], int place)
{
    const char *const begin = taken[place].at;
    bool apart = true;

    for (int other = 0; other < place; ++other) {
        const char *const start = taken[other].at;

        apart = apart && ((begin >= (start + taken[other].bytes))
                          || (start >= (begin + taken[place].bytes)));
    }
    return apart;
}

/* Take the objects that follow what was taken; false where one is not as it must be. */
static bool take_more(
    const PyTypeObject *type,
    PyObject *const objects[],
    const wanted_t wanted[],
    int first,
    int end,
    bool many,
    extent_t *extent,
    taken_t taken[])
{
    for (int place = first; place < end; ++place) {
        PyObject *const object = objects[place - first];
        const bool fits = (Py_TYPE(object) == type)
            ? take_array((PyArrayObject *)object, &wanted[place], many, extent, &taken[place])
            : take_number(object, &wanted[place], &taken[place]);

        if (!fits || (wanted[place].written && !lies_apart(taken, place))) {
            return false;
        }
    }
    return (extent->epochs <= INT32_MAX) && (extent->items <= INT32_MAX);
}

/* Take what is in a tuple behind the type of NumPy's arrays and in front of `more` other things. */
static bool take(
    PyObject *tuple,
    Py_ssize_t more,
    const wanted_t wanted[],
    int count,
    bool many,
    extent_t *extent,
    taken_t taken[])
{
    PyObject *const *const objects = PySequence_Fast_ITEMS(tuple);
    const PyTypeObject *const type = (PyTypeObject *)objects[0];

    extent->epochs = -1;
    extent->items = -1;
    return (PyTuple_GET_SIZE(tuple) == (1 + count + more))
        && take_more(type, &objects[1], wanted, 0, count, many, extent, taken);
}

/* Memory of an epoch. */
static inline void *epoch_of(const taken_t *taken, const wanted_t *wanted, int32_t epoch)
{
    return (char *)taken->at + (epoch * taken->step * wanted->size);
}

/* The number that was taken where the C wants an integer by value. */
static inline int32_t integer_of(const taken_t *taken)
{
    return *(const int32_t *)taken->at;
}

/* True when these epochs are among those given. */
static inline bool has_epochs(const extent_t *extent, int32_t first, int32_t count)
{
    return (first >= 0) && (count >= 0) && ((npy_intp)first + count <= extent->epochs);
}

#endif
