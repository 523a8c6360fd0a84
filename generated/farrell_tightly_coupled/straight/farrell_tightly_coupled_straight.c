/* Straight ways into the C of farrell_tightly_coupled, for Python; see straight.h. */

#include "farrell_tightly_coupled_straight.h"
#include "calls.h"

#include "farrell_tightly_coupled/farrell_tightly_coupled.h"

int32_t straight_farrell_tightly_coupled__layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

static const wanted_t wanted_farrell_tightly_coupled_retract_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {17}},
    {NPY_DOUBLE, 8, true, 1, {18}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_farrell_tightly_coupled_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_retract_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_farrell_tightly_coupled_local_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, true, 1, {17}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_farrell_tightly_coupled_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_local_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 17}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_farrell_tightly_coupled_pseudorange_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_pseudorange_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[10];
    extent_t extent;

    if (!take(tuple, 0, wanted, 10, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_pseudorange_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first), epoch_of(&taken[8], &wanted[8], first),
        epoch_of(&taken[9], &wanted[9], first));
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {4, ITEMS}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_farrell_tightly_coupled_pseudorange_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_pseudorange_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[10];
    extent_t extent;

    if (!take(tuple, 0, wanted, 10, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_pseudorange_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first), epoch_of(&taken[8], &wanted[8], first),
        epoch_of(&taken[9], &wanted[9], first));
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_lever_arm_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 17}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_pseudorange_lever_arm_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[9];
    extent_t extent;

    if (!take(tuple, 0, wanted, 9, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_pseudorange_lever_arm_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first), epoch_of(&taken[8], &wanted[8], first));
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_lever_arm_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {7, ITEMS}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_pseudorange_lever_arm_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[9];
    extent_t extent;

    if (!take(tuple, 0, wanted, 9, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_pseudorange_lever_arm_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first), epoch_of(&taken[8], &wanted[8], first));
}

static const wanted_t wanted_farrell_tightly_coupled_retract[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {17}},
    {NPY_DOUBLE, 8, true, 1, {18}},
};

static PyObject *call_farrell_tightly_coupled_retract(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_retract, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_retract(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static PyObject *bound_farrell_tightly_coupled_retract(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_retract;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)farrell_tightly_coupled_retract(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_farrell_tightly_coupled_local[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, true, 1, {17}},
};

static PyObject *call_farrell_tightly_coupled_local(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_local, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_local(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static PyObject *bound_farrell_tightly_coupled_local(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_local;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)farrell_tightly_coupled_local(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 17}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_farrell_tightly_coupled_pseudorange(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_pseudorange, 5, 0, 3, 4};
    PyObject *arrays[4];
    taken_t taken[9];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_pseudorange(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at, taken[8].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static PyObject *bound_farrell_tightly_coupled_pseudorange(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_pseudorange;
    taken_t taken[9];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 9, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)farrell_tightly_coupled_pseudorange(
            taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
            taken[5].at, taken[6].at, taken[7].at, taken[8].at);
        step_back(aside);
    }
    return finish_bound(kept, 9, status);
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_value[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_farrell_tightly_coupled_pseudorange_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_pseudorange_value, 5, 0, 2, 3};
    PyObject *arrays[3];
    taken_t taken[8];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_pseudorange_value(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 17}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_farrell_tightly_coupled_pseudorange_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_pseudorange_jacobian, 5, 0, 1, 2};
    PyObject *arrays[2];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_pseudorange_jacobian(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_sd[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_INT32, 4, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {OTHERS}},
    {NPY_DOUBLE, 8, true, 1, {OTHERS}},
    {NPY_DOUBLE, 8, true, 2, {OTHERS, 17}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_farrell_tightly_coupled_pseudorange_sd(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_pseudorange_sd, 6, 0, 3, 4};
    PyObject *arrays[4];
    taken_t taken[10];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_pseudorange_sd(
        taken[0].at, (int32_t)extent.items, integer_of(&taken[1]), taken[2].at, taken[3].at,
        taken[4].at, taken[5].at, taken[6].at, taken[7].at, taken[8].at, taken[9].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_lever_arm[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 17}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_farrell_tightly_coupled_pseudorange_lever_arm(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_pseudorange_lever_arm, 5, 0, 2, 3};
    PyObject *arrays[3];
    taken_t taken[8];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_pseudorange_lever_arm(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static PyObject *bound_farrell_tightly_coupled_pseudorange_lever_arm(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_farrell_tightly_coupled_pseudorange_lever_arm;
    taken_t taken[8];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 8, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)farrell_tightly_coupled_pseudorange_lever_arm(
            taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
            taken[5].at, taken[6].at, taken[7].at);
        step_back(aside);
    }
    return finish_bound(kept, 8, status);
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_lever_arm_value[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_farrell_tightly_coupled_pseudorange_lever_arm_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_pseudorange_lever_arm_value, 5, 0, 1, 2};
    PyObject *arrays[2];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_pseudorange_lever_arm_value(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_lever_arm_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 17}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_farrell_tightly_coupled_pseudorange_lever_arm_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_pseudorange_lever_arm_jacobian, 5, 0, 1, 2};
    PyObject *arrays[2];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_pseudorange_lever_arm_jacobian(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

static const wanted_t wanted_farrell_tightly_coupled_pseudorange_lever_arm_sd[] = {
    {NPY_DOUBLE, 8, false, 1, {18}},
    {NPY_INT32, 4, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, true, 1, {OTHERS}},
    {NPY_DOUBLE, 8, true, 2, {OTHERS, 17}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_farrell_tightly_coupled_pseudorange_lever_arm_sd(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_farrell_tightly_coupled_pseudorange_lever_arm_sd, 6, 0, 2, 3};
    PyObject *arrays[3];
    taken_t taken[9];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)farrell_tightly_coupled_pseudorange_lever_arm_sd(
        taken[0].at, (int32_t)extent.items, integer_of(&taken[1]), taken[2].at, taken[3].at,
        taken[4].at, taken[5].at, taken[6].at, taken[7].at, taken[8].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)FARRELL_TIGHTLY_COUPLED_PARTIAL);
}

int32_t straight_farrell_tightly_coupled__open(uintptr_t list, const char *name)
{
    static PyMethodDef methods[] = {
        {"retract", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_retract,
         METH_FASTCALL, NULL},
        {"retract.bind", bound_farrell_tightly_coupled_retract, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"local", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_local,
         METH_FASTCALL, NULL},
        {"local.bind", bound_farrell_tightly_coupled_local, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"pseudorange", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_pseudorange,
         METH_FASTCALL, NULL},
        {"pseudorange.bind", bound_farrell_tightly_coupled_pseudorange, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"pseudorange.value", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_pseudorange_value,
         METH_FASTCALL, NULL},
        {"pseudorange.jacobian", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_pseudorange_jacobian,
         METH_FASTCALL, NULL},
        {"pseudorange.single_difference", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_pseudorange_sd,
         METH_FASTCALL, NULL},
        {"pseudorange_lever_arm", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_pseudorange_lever_arm,
         METH_FASTCALL, NULL},
        {"pseudorange_lever_arm.bind", bound_farrell_tightly_coupled_pseudorange_lever_arm, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"pseudorange_lever_arm.value", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_pseudorange_lever_arm_value,
         METH_FASTCALL, NULL},
        {"pseudorange_lever_arm.jacobian", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_pseudorange_lever_arm_jacobian,
         METH_FASTCALL, NULL},
        {"pseudorange_lever_arm.single_difference", (PyCFunction)(void (*)(void))call_farrell_tightly_coupled_pseudorange_lever_arm_sd,
         METH_FASTCALL, NULL},
    };

    return open_call(list, name, methods, (int)(sizeof methods / sizeof methods[0]));
}
