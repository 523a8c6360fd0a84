/*
 * What Python hands to the functions of this package, read where it lies.
 *
 * Looking at an array from Python costs more than most of these functions take. Whatever is not
 * exactly as the C wants it is UNFIT, and takes the general way. There are two ways in:
 *
 * - For many epochs a tuple of everything comes by its address, as `id` gives it: first the type of
 *   NumPy's arrays, then inputs, then outputs. Its owner keeps it alive during the call. Nothing of
 *   Python is changed, no reference is counted, so that other threads may go on meanwhile.
 * - A call of Python's for one epoch is given inputs and, as `out`, None or what holds arrays for
 *   its outputs. It makes what it was not given and returns its result, or None. A bound call keeps
 *   a tuple of everything and is given nothing.
 *
 * Part of the extension for Python, not of the exported C.
 */
#ifndef SYMNAV_STRAIGHT_H
#define SYMNAV_STRAIGHT_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_1_7_API_VERSION
#include <numpy/arrayobject.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

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

/* What a call of Python's keeps, in a tuple: the type of NumPy's arrays, that of its result (or
   None for outputs alone), and the statuses of what went well and of what some items failed in. */
enum { ARRAY_TYPE, RESULT_TYPE, WENT_WELL, WENT_PARTLY };

/* What a bound call keeps behind everything it takes: its result, and what is called with the
   status when something went otherwise. */
enum { BOUND_RESULT, OTHERWISE, BOUND_MORE };

/* More items than that are evaluated while other threads run. */
enum { MANY_ITEMS = 256 };

/* What a call wants: inputs, then what its entry point writes: outputs that nobody asked for, those
   that a caller may give, and statuses of items, which only results of a type of their own have. */
typedef struct {
    const wanted_t *wanted;
    int inputs;
    int idle;
    int outputs;
    int written; /* all of them */
} call_t;

/* A new array as it is wanted. */
static PyObject *make_array(const wanted_t *wanted, const extent_t *extent, taken_t *taken)
{
    npy_intp shape[3] = {0, 0, 0};
    PyObject *array;

    for (int axis = 0; axis < wanted->rank; ++axis) {
        shape[axis] = wanted->shape[axis];
        if (shape[axis] < 0) {
            shape[axis] = extent->items - ((shape[axis] == OTHERS) ? 1 : 0);
        }
    }
    array = PyArray_SimpleNew(wanted->rank, shape, wanted->kind);
    if (array != NULL) {
        taken->at = PyArray_DATA((PyArrayObject *)array);
        taken->bytes = 0; /* of memory that nobody else has */
    }
    return array;
}

/* Let go of arrays. */
static void release(PyObject *const arrays[], int first, int end)
{
    for (int place = first; place < end; ++place) {
        Py_DECREF(arrays[place]);
    }
}

/* Nothing for Python, which then takes the general way and says what is wrong; memory that has run
   out does so there again. */
static PyObject *decline(PyObject *const arrays[], int count)
{
    release(arrays, 0, count);
    PyErr_Clear();
    Py_RETURN_NONE;
}

/* True for a list or tuple whose elements are what Python iterates over. */
static bool is_plain_sequence(PyObject *object, PyObject *result_type)
{
    return PyTuple_CheckExact(object) || PyList_CheckExact(object)
        || ((PyObject *)Py_TYPE(object) == result_type);
}

/* The arrays that `out` holds, one, several or a result; nothing where it holds another number. */
static PyObject *const *held_by(PyObject *const *out, PyObject *kept, const call_t *call)
{
    const PyTypeObject *const type = (PyTypeObject *)PyTuple_GET_ITEM(kept, ARRAY_TYPE);
    PyObject *const result_type = PyTuple_GET_ITEM(kept, RESULT_TYPE);
    PyObject *const *arrays = NULL;

    if (Py_TYPE(*out) == type) {
        arrays = (call->outputs == 1) ? out : NULL;
    } else if (is_plain_sequence(*out, result_type)) {
        const Py_ssize_t size = PySequence_Fast_GET_SIZE(*out);
        const bool whole = (result_type != Py_None) && (size == (call->written + 1));

        arrays = (whole || (size == call->outputs)) ? PySequence_Fast_ITEMS(*out) : NULL;
    }
    return arrays;
}

/* Take what is given and make what is not; false where something is not as it must be. */
static bool begin(
    const call_t *call,
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count,
    PyObject *arrays[],
    taken_t taken[],
    extent_t *extent)
{
    const PyTypeObject *const type = (PyTypeObject *)PyTuple_GET_ITEM(kept, ARRAY_TYPE);
    PyObject *const *held = NULL;
    bool fits = count == (call->inputs + 1);

    extent->epochs = -1;
    extent->items = -1;
    if (fits && (given[call->inputs] != Py_None)) {
        held = held_by(&given[call->inputs], kept, call);
        fits = held != NULL;
    }
    if (!fits || !take_more(type, given, call->wanted, 0, call->inputs, false, extent, taken)) {
        return false;
    }
    for (int made = 0; made < call->written; ++made) {
        const int place = call->inputs + made;
        const int output = made - call->idle;

        if ((held != NULL) && (output >= 0) && (output < call->outputs)) {
            fits = take_more(
                type, &held[output], call->wanted, place, place + 1, false, extent, taken);
            arrays[made] = fits ? held[output] : NULL;
            Py_XINCREF(arrays[made]);
        } else {
            arrays[made] = make_array(&call->wanted[place], extent, &taken[place]);
        }
        if (arrays[made] == NULL) {
            release(arrays, 0, made);
            PyErr_Clear();
            return false;
        }
    }
    return true;
}

/* Outputs alone: the array, or a tuple of arrays, which owns them from now on. */
static PyObject *finish_plain(const call_t *call, PyObject *const arrays[])
{
    PyObject *const *const outputs = &arrays[call->idle];
    PyObject *result = (call->outputs == 1) ? outputs[0] : PyTuple_New(call->outputs);

    if (result == NULL) {
        return decline(arrays, call->written);
    }
    for (int place = 0; (call->outputs > 1) && (place < call->outputs); ++place) {
        PyTuple_SET_ITEM(result, place, outputs[place]);
    }
    release(arrays, 0, call->idle);
    release(arrays, call->idle + call->outputs, call->written);
    return result;
}

/* The result of a call that went well or partly so, which owns the arrays from now on. */
static PyObject *finish(
    const call_t *call,
    PyObject *kept,
    PyObject *const arrays[],
    int32_t status,
    int32_t partly)
{
    PyTypeObject *const type = (PyTypeObject *)PyTuple_GET_ITEM(kept, RESULT_TYPE);
    PyObject *const outcome = PyTuple_GET_ITEM(kept, (status == 0) ? WENT_WELL : WENT_PARTLY);
    PyObject *result;

    if ((status != 0) && (status != partly)) {
        return decline(arrays, call->written);
    }
    if ((PyObject *)type == Py_None) {
        return finish_plain(call, arrays);
    }
    result = type->tp_alloc(type, call->written + 1);
    if (result == NULL) {
        return decline(arrays, call->written);
    }
#if PY_VERSION_HEX >= 0x030E0000
    ((PyTupleObject *)result)->ob_hash = -1; /* not known yet */
#endif
    for (int place = 0; place < call->written; ++place) {
        PyTuple_SET_ITEM(result, place + (place >= call->outputs), arrays[place]);
    }
    Py_INCREF(outcome);
    PyTuple_SET_ITEM(result, call->outputs, outcome);
    return result;
}

/* The result of a bound call, whose arrays have been written. */
static PyObject *finish_bound(PyObject *kept, int count, int32_t status)
{
    PyObject *const *const more = PySequence_Fast_ITEMS(kept) + 1 + count;
    PyObject *result = more[BOUND_RESULT];

    if (status == 0) {
        Py_INCREF(result);
    } else {
        result = PyObject_CallFunction(more[OTHERWISE], "i", (int)status);
    }
    return result;
}

/* Let other threads of Python run while many items are evaluated. */
static inline PyThreadState *step_aside(const extent_t *extent)
{
    return (extent->items > MANY_ITEMS) ? PyEval_SaveThread() : NULL;
}

static inline void step_back(PyThreadState *aside)
{
    if (aside != NULL) {
        PyEval_RestoreThread(aside);
    }
}

/* Put the call of a name into a list of Python's, by its address, in the place of what the call
   keeps. Where that fails, for want of memory or of NumPy, everything takes the general way. */
static int32_t open_call(uintptr_t given, const char *name, PyMethodDef methods[], int count)
{
    PyObject *const list = (PyObject *)given;
    const PyGILState_STATE held = PyGILState_Ensure();
    bool opened = false;

    for (int place = 0; place < count; ++place) {
        if ((strcmp(methods[place].ml_name, name) == 0) && (_import_array() == 0)) {
            PyObject *const call = PyCFunction_New(&methods[place], PyList_GET_ITEM(list, 0));

            opened = (call != NULL) && (PyList_SetItem(list, 0, call) == 0);
        }
    }
    PyErr_Clear();
    PyGILState_Release(held);
    return opened ? 1 : 0;
}

#endif
