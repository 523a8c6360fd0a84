/* Straight ways into the C of single_point, for Python; see straight.h. */

#include "single_point_straight.h"
#include "calls.h"

#include "single_point/single_point.h"

int32_t straight_single_point__layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

static const wanted_t wanted_single_point_retract_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {4}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_single_point_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_single_point_retract_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)single_point_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_single_point_local_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {4}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_single_point_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_single_point_local_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)single_point_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_single_point_pseudorange_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 4}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_single_point_pseudorange_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_single_point_pseudorange_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[9];
    extent_t extent;

    if (!take(tuple, 0, wanted, 9, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)single_point_pseudorange_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first), epoch_of(&taken[8], &wanted[8], first));
}

static const wanted_t wanted_single_point_pseudorange_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {4, ITEMS}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_single_point_pseudorange_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_single_point_pseudorange_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[9];
    extent_t extent;

    if (!take(tuple, 0, wanted, 9, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)single_point_pseudorange_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first), epoch_of(&taken[8], &wanted[8], first));
}

static const wanted_t wanted_single_point_pseudorange_without_sagnac_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 4}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_single_point_pseudorange_without_sagnac_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_single_point_pseudorange_without_sagnac_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[9];
    extent_t extent;

    if (!take(tuple, 0, wanted, 9, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)single_point_pseudorange_without_sagnac_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first), epoch_of(&taken[8], &wanted[8], first));
}

static const wanted_t wanted_single_point_pseudorange_without_sagnac_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {4, ITEMS}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_single_point_pseudorange_without_sagnac_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_single_point_pseudorange_without_sagnac_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[9];
    extent_t extent;

    if (!take(tuple, 0, wanted, 9, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)single_point_pseudorange_without_sagnac_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first), epoch_of(&taken[8], &wanted[8], first));
}

static const wanted_t wanted_single_point_broadcast_orbit_batch[] = {
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 0, {0}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_single_point_broadcast_orbit_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_single_point_broadcast_orbit_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[27];
    extent_t extent;

    if (!take(tuple, 0, wanted, 27, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)single_point_broadcast_orbit_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), (int32_t)taken[5].step,
        epoch_of(&taken[6], &wanted[6], first), (int32_t)taken[6].step,
        epoch_of(&taken[7], &wanted[7], first), (int32_t)taken[7].step,
        epoch_of(&taken[8], &wanted[8], first), (int32_t)taken[8].step,
        epoch_of(&taken[9], &wanted[9], first), (int32_t)taken[9].step,
        epoch_of(&taken[10], &wanted[10], first), (int32_t)taken[10].step,
        epoch_of(&taken[11], &wanted[11], first), (int32_t)taken[11].step,
        epoch_of(&taken[12], &wanted[12], first), (int32_t)taken[12].step,
        epoch_of(&taken[13], &wanted[13], first), (int32_t)taken[13].step,
        epoch_of(&taken[14], &wanted[14], first), (int32_t)taken[14].step,
        epoch_of(&taken[15], &wanted[15], first), (int32_t)taken[15].step,
        epoch_of(&taken[16], &wanted[16], first), (int32_t)taken[16].step,
        epoch_of(&taken[17], &wanted[17], first), (int32_t)taken[17].step,
        epoch_of(&taken[18], &wanted[18], first), (int32_t)taken[18].step,
        epoch_of(&taken[19], &wanted[19], first), (int32_t)taken[19].step,
        epoch_of(&taken[20], &wanted[20], first), (int32_t)taken[20].step,
        epoch_of(&taken[21], &wanted[21], first), (int32_t)taken[21].step,
        epoch_of(&taken[22], &wanted[22], first), epoch_of(&taken[23], &wanted[23], first),
        epoch_of(&taken[24], &wanted[24], first), epoch_of(&taken[25], &wanted[25], first),
        epoch_of(&taken[26], &wanted[26], first));
}

static const wanted_t wanted_single_point_retract[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {4}},
};

static PyObject *call_single_point_retract(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_retract, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_retract(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static PyObject *bound_single_point_retract(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_single_point_retract;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)single_point_retract(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_single_point_local[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {4}},
};

static PyObject *call_single_point_local(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_local, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_local(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static PyObject *bound_single_point_local(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_single_point_local;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)single_point_local(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_single_point_pseudorange[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 4}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_single_point_pseudorange(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_pseudorange, 5, 0, 2, 3};
    PyObject *arrays[3];
    taken_t taken[8];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_pseudorange(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static PyObject *bound_single_point_pseudorange(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_single_point_pseudorange;
    taken_t taken[8];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 8, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)single_point_pseudorange(
            taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
            taken[5].at, taken[6].at, taken[7].at);
        step_back(aside);
    }
    return finish_bound(kept, 8, status);
}

static const wanted_t wanted_single_point_pseudorange_value[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_single_point_pseudorange_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_pseudorange_value, 5, 0, 1, 2};
    PyObject *arrays[2];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_pseudorange_value(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static const wanted_t wanted_single_point_pseudorange_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 4}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_single_point_pseudorange_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_pseudorange_jacobian, 5, 0, 1, 2};
    PyObject *arrays[2];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_pseudorange_jacobian(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static const wanted_t wanted_single_point_pseudorange_without_sagnac[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 4}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_single_point_pseudorange_without_sagnac(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_pseudorange_without_sagnac, 5, 0, 2, 3};
    PyObject *arrays[3];
    taken_t taken[8];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_pseudorange_without_sagnac(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static PyObject *bound_single_point_pseudorange_without_sagnac(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_single_point_pseudorange_without_sagnac;
    taken_t taken[8];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 8, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)single_point_pseudorange_without_sagnac(
            taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
            taken[5].at, taken[6].at, taken[7].at);
        step_back(aside);
    }
    return finish_bound(kept, 8, status);
}

static const wanted_t wanted_single_point_pseudorange_without_sagnac_value[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_single_point_pseudorange_without_sagnac_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_pseudorange_without_sagnac_value, 5, 0, 1, 2};
    PyObject *arrays[2];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_pseudorange_without_sagnac_value(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static const wanted_t wanted_single_point_pseudorange_without_sagnac_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 4}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_single_point_pseudorange_without_sagnac_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_pseudorange_without_sagnac_jacobian, 5, 0, 1, 2};
    PyObject *arrays[2];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_pseudorange_without_sagnac_jacobian(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static const wanted_t wanted_single_point_broadcast_orbit[] = {
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 0, {0}},
};

static PyObject *call_single_point_broadcast_orbit(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_single_point_broadcast_orbit, 22, 0, 4, 4};
    PyObject *arrays[4];
    taken_t taken[26];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)single_point_broadcast_orbit(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at, taken[7].at, taken[8].at, taken[9].at, taken[10].at, taken[11].at,
        taken[12].at, taken[13].at, taken[14].at, taken[15].at, taken[16].at, taken[17].at,
        taken[18].at, taken[19].at, taken[20].at, taken[21].at, taken[22].at, taken[23].at,
        taken[24].at, taken[25].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)SINGLE_POINT_PARTIAL);
}

static PyObject *bound_single_point_broadcast_orbit(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_single_point_broadcast_orbit;
    taken_t taken[26];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 26, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)single_point_broadcast_orbit(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
            taken[6].at, taken[7].at, taken[8].at, taken[9].at, taken[10].at, taken[11].at,
            taken[12].at, taken[13].at, taken[14].at, taken[15].at, taken[16].at, taken[17].at,
            taken[18].at, taken[19].at, taken[20].at, taken[21].at, taken[22].at, taken[23].at,
            taken[24].at, taken[25].at);
        step_back(aside);
    }
    return finish_bound(kept, 26, status);
}

int32_t straight_single_point__open(uintptr_t list, const char *name)
{
    static PyMethodDef methods[] = {
        {"retract", (PyCFunction)(void (*)(void))call_single_point_retract,
         METH_FASTCALL, NULL},
        {"retract.bind", bound_single_point_retract, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"local", (PyCFunction)(void (*)(void))call_single_point_local,
         METH_FASTCALL, NULL},
        {"local.bind", bound_single_point_local, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"pseudorange", (PyCFunction)(void (*)(void))call_single_point_pseudorange,
         METH_FASTCALL, NULL},
        {"pseudorange.bind", bound_single_point_pseudorange, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"pseudorange.value", (PyCFunction)(void (*)(void))call_single_point_pseudorange_value,
         METH_FASTCALL, NULL},
        {"pseudorange.jacobian", (PyCFunction)(void (*)(void))call_single_point_pseudorange_jacobian,
         METH_FASTCALL, NULL},
        {"pseudorange_without_sagnac", (PyCFunction)(void (*)(void))call_single_point_pseudorange_without_sagnac,
         METH_FASTCALL, NULL},
        {"pseudorange_without_sagnac.bind", bound_single_point_pseudorange_without_sagnac, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"pseudorange_without_sagnac.value", (PyCFunction)(void (*)(void))call_single_point_pseudorange_without_sagnac_value,
         METH_FASTCALL, NULL},
        {"pseudorange_without_sagnac.jacobian", (PyCFunction)(void (*)(void))call_single_point_pseudorange_without_sagnac_jacobian,
         METH_FASTCALL, NULL},
        {"broadcast_orbit", (PyCFunction)(void (*)(void))call_single_point_broadcast_orbit,
         METH_FASTCALL, NULL},
        {"broadcast_orbit.bind", bound_single_point_broadcast_orbit, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
    };

    return open_call(list, name, methods, (int)(sizeof methods / sizeof methods[0]));
}
