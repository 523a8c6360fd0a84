/*
 * Calls of Python's for one epoch, which the extension has beside what cffi calls.
 *
 * A call is given inputs and, as `out`, None or what holds arrays for its outputs. It makes what it
 * was not given and returns its result, or None: then Python takes the general way. A bound call
 * keeps a tuple of everything and is given nothing.
 *
 * Part of the extension for Python, not of the exported C.
 */
#ifndef SYMNAV_CALLS_H
#define SYMNAV_CALLS_H

#include "straight.h"

#include <numpy/arrayobject.h>

#include <string.h>

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
