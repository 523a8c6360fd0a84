/* Straight ways into the C of rover, for Python; see straight.h. */

#include "rover_straight.h"
#include "calls.h"

#include "rover/rover.h"

int32_t straight_rover__layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

static const wanted_t wanted_rover_retract_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {21}},
    {NPY_DOUBLE, 8, true, 1, {22}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_rover_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_rover_retract_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_rover_local_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {21}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_rover_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_rover_local_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_rover_gps_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_rover_gps_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_rover_gps_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_gps_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), epoch_of(&taken[2], &wanted[2], first),
        epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_rover_gps_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {21}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_rover_gps_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_rover_gps_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_gps_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), epoch_of(&taken[2], &wanted[2], first),
        epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_rover_range_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_INT32, 4, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 21}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_rover_range_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_rover_range_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[14];
    extent_t extent;

    if (!take(tuple, 0, wanted, 14, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_range_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), (int32_t)taken[5].step,
        epoch_of(&taken[6], &wanted[6], first), (int32_t)taken[6].step,
        epoch_of(&taken[7], &wanted[7], first), (int32_t)taken[7].step,
        epoch_of(&taken[8], &wanted[8], first), (int32_t)taken[8].step,
        epoch_of(&taken[9], &wanted[9], first), epoch_of(&taken[10], &wanted[10], first),
        epoch_of(&taken[11], &wanted[11], first), epoch_of(&taken[12], &wanted[12], first),
        epoch_of(&taken[13], &wanted[13], first));
}

static const wanted_t wanted_rover_range_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_INT32, 4, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {11, ITEMS}},
    {NPY_UINT8, 1, true, 0, {0}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

int32_t straight_rover_range_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_rover_range_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[14];
    extent_t extent;

    if (!take(tuple, 0, wanted, 14, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_range_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        (int32_t)extent.items, epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), (int32_t)taken[5].step,
        epoch_of(&taken[6], &wanted[6], first), (int32_t)taken[6].step,
        epoch_of(&taken[7], &wanted[7], first), (int32_t)taken[7].step,
        epoch_of(&taken[8], &wanted[8], first), (int32_t)taken[8].step,
        epoch_of(&taken[9], &wanted[9], first), epoch_of(&taken[10], &wanted[10], first),
        epoch_of(&taken[11], &wanted[11], first), epoch_of(&taken[12], &wanted[12], first),
        epoch_of(&taken[13], &wanted[13], first));
}

static const wanted_t wanted_rover_imu_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_rover_imu_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_rover_imu_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[7];
    extent_t extent;

    if (!take(tuple, 0, wanted, 7, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_imu_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first),
        epoch_of(&taken[6], &wanted[6], first));
}

static const wanted_t wanted_rover_imu_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {27}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_rover_imu_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_rover_imu_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[7];
    extent_t extent;

    if (!take(tuple, 0, wanted, 7, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_imu_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first),
        epoch_of(&taken[6], &wanted[6], first));
}

static const wanted_t wanted_rover_retract[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {21}},
    {NPY_DOUBLE, 8, true, 1, {22}},
};

static PyObject *call_rover_retract(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_retract, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_retract(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static PyObject *bound_rover_retract(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_rover_retract;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)rover_retract(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_rover_local[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {21}},
};

static PyObject *call_rover_local(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_local, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_local(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static PyObject *bound_rover_local(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_rover_local;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)rover_local(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_rover_gps[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
};

static PyObject *call_rover_gps(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_gps, 1, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_gps(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static PyObject *bound_rover_gps(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_rover_gps;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)rover_gps(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_rover_gps_value[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_rover_gps_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_gps_value, 1, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[2];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_gps_value(
        taken[0].at, taken[1].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static const wanted_t wanted_rover_gps_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
};

static PyObject *call_rover_gps_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_gps_jacobian, 1, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[2];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_gps_jacobian(
        taken[0].at, taken[1].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static const wanted_t wanted_rover_gps_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {21}},
};

static PyObject *call_rover_gps_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_gps_nz, 1, 1, 1, 2};
    PyObject *arrays[2];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_gps_nz(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static const wanted_t wanted_rover_range[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_INT32, 4, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 21}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_rover_range(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_range, 9, 0, 3, 4};
    PyObject *arrays[4];
    taken_t taken[13];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_range(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at, taken[8].at, taken[9].at, taken[10].at,
        taken[11].at, taken[12].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static PyObject *bound_rover_range(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_rover_range;
    taken_t taken[13];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 13, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)rover_range(
            taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
            taken[5].at, taken[6].at, taken[7].at, taken[8].at, taken[9].at, taken[10].at,
            taken[11].at, taken[12].at);
        step_back(aside);
    }
    return finish_bound(kept, 13, status);
}

static const wanted_t wanted_rover_range_value[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_INT32, 4, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 1, {ITEMS}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_rover_range_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_range_value, 9, 0, 2, 3};
    PyObject *arrays[3];
    taken_t taken[12];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_range_value(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at, taken[8].at, taken[9].at, taken[10].at,
        taken[11].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static const wanted_t wanted_rover_range_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_INT32, 4, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, false, 1, {ITEMS}},
    {NPY_DOUBLE, 8, true, 2, {ITEMS, 21}},
    {NPY_UINT8, 1, true, 1, {ITEMS}},
};

static PyObject *call_rover_range_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_range_jacobian, 9, 0, 1, 2};
    PyObject *arrays[2];
    taken_t taken[11];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_range_jacobian(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at, taken[8].at, taken[9].at, taken[10].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static const wanted_t wanted_rover_imu[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
};

static PyObject *call_rover_imu(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_imu, 4, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[6];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_imu(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static PyObject *bound_rover_imu(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_rover_imu;
    taken_t taken[6];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 6, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)rover_imu(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
        step_back(aside);
    }
    return finish_bound(kept, 6, status);
}

static const wanted_t wanted_rover_imu_value[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_rover_imu_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_imu_value, 4, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_imu_value(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static const wanted_t wanted_rover_imu_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
};

static PyObject *call_rover_imu_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_imu_jacobian, 4, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_imu_jacobian(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

static const wanted_t wanted_rover_imu_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 1, {6}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {27}},
};

static PyObject *call_rover_imu_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_rover_imu_nz, 4, 1, 1, 2};
    PyObject *arrays[2];
    taken_t taken[6];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)rover_imu_nz(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)ROVER_PARTIAL);
}

int32_t straight_rover__open(uintptr_t list, const char *name)
{
    static PyMethodDef methods[] = {
        {"retract", (PyCFunction)(void (*)(void))call_rover_retract,
         METH_FASTCALL, NULL},
        {"retract.bind", bound_rover_retract, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"local", (PyCFunction)(void (*)(void))call_rover_local,
         METH_FASTCALL, NULL},
        {"local.bind", bound_rover_local, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"gps", (PyCFunction)(void (*)(void))call_rover_gps,
         METH_FASTCALL, NULL},
        {"gps.bind", bound_rover_gps, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"gps.value", (PyCFunction)(void (*)(void))call_rover_gps_value,
         METH_FASTCALL, NULL},
        {"gps.jacobian", (PyCFunction)(void (*)(void))call_rover_gps_jacobian,
         METH_FASTCALL, NULL},
        {"gps.nonzeros", (PyCFunction)(void (*)(void))call_rover_gps_nz,
         METH_FASTCALL, NULL},
        {"range", (PyCFunction)(void (*)(void))call_rover_range,
         METH_FASTCALL, NULL},
        {"range.bind", bound_rover_range, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"range.value", (PyCFunction)(void (*)(void))call_rover_range_value,
         METH_FASTCALL, NULL},
        {"range.jacobian", (PyCFunction)(void (*)(void))call_rover_range_jacobian,
         METH_FASTCALL, NULL},
        {"imu", (PyCFunction)(void (*)(void))call_rover_imu,
         METH_FASTCALL, NULL},
        {"imu.bind", bound_rover_imu, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"imu.value", (PyCFunction)(void (*)(void))call_rover_imu_value,
         METH_FASTCALL, NULL},
        {"imu.jacobian", (PyCFunction)(void (*)(void))call_rover_imu_jacobian,
         METH_FASTCALL, NULL},
        {"imu.nonzeros", (PyCFunction)(void (*)(void))call_rover_imu_nz,
         METH_FASTCALL, NULL},
    };

    return open_call(list, name, methods, (int)(sizeof methods / sizeof methods[0]));
}
