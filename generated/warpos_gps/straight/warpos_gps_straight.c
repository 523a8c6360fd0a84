/* Straight ways into the C of warpos_gps, for Python; see straight.h. */

#include "warpos_gps_straight.h"
#include "calls.h"

#include "warpos_gps/warpos_gps.h"

int32_t straight_warpos_gps__layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

static const wanted_t wanted_warpos_gps_retract_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {15}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_retract_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_warpos_gps_local_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {15}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_local_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_warpos_gps_measurement_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_measurement_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_measurement_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_measurement_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), epoch_of(&taken[2], &wanted[2], first),
        epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_warpos_gps_measurement_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_measurement_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_measurement_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_measurement_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), epoch_of(&taken[2], &wanted[2], first),
        epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_warpos_gps_measurement_by_column_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_measurement_by_column_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_measurement_by_column_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_measurement_by_column_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), epoch_of(&taken[2], &wanted[2], first),
        epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_warpos_gps_measurement_by_column_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_measurement_by_column_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_measurement_by_column_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_measurement_by_column_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), epoch_of(&taken[2], &wanted[2], first),
        epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_warpos_gps_observed_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_observed_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_observed_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[5];
    extent_t extent;

    if (!take(tuple, 0, wanted, 5, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_observed_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first),
        epoch_of(&taken[4], &wanted[4], first));
}

static const wanted_t wanted_warpos_gps_observed_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_observed_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_observed_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[5];
    extent_t extent;

    if (!take(tuple, 0, wanted, 5, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_observed_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first),
        epoch_of(&taken[4], &wanted[4], first));
}

static const wanted_t wanted_warpos_gps_observed_by_column_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_observed_by_column_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_observed_by_column_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[5];
    extent_t extent;

    if (!take(tuple, 0, wanted, 5, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_observed_by_column_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first),
        epoch_of(&taken[4], &wanted[4], first));
}

static const wanted_t wanted_warpos_gps_observed_by_column_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_observed_by_column_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_observed_by_column_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[5];
    extent_t extent;

    if (!take(tuple, 0, wanted, 5, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_observed_by_column_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first),
        epoch_of(&taken[4], &wanted[4], first));
}

static const wanted_t wanted_warpos_gps_to_state_frame_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_warpos_gps_to_state_frame_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_warpos_gps_to_state_frame_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[9];
    extent_t extent;

    if (!take(tuple, 0, wanted, 9, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)warpos_gps_to_state_frame_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), (int32_t)taken[4].step,
        epoch_of(&taken[5], &wanted[5], first), (int32_t)taken[5].step,
        epoch_of(&taken[6], &wanted[6], first), epoch_of(&taken[7], &wanted[7], first),
        epoch_of(&taken[8], &wanted[8], first));
}

static const wanted_t wanted_warpos_gps_retract[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {15}},
};

static PyObject *call_warpos_gps_retract(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_retract, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_retract(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static PyObject *bound_warpos_gps_retract(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_warpos_gps_retract;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)warpos_gps_retract(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_warpos_gps_local[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {15}},
};

static PyObject *call_warpos_gps_local(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_local, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_local(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static PyObject *bound_warpos_gps_local(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_warpos_gps_local;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)warpos_gps_local(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_warpos_gps_measurement[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
};

static PyObject *call_warpos_gps_measurement(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_measurement, 1, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_measurement(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static PyObject *bound_warpos_gps_measurement(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_warpos_gps_measurement;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)warpos_gps_measurement(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_warpos_gps_measurement_value[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_warpos_gps_measurement_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_measurement_value, 1, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[2];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_measurement_value(
        taken[0].at, taken[1].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static const wanted_t wanted_warpos_gps_measurement_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
};

static PyObject *call_warpos_gps_measurement_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_measurement_jacobian, 1, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[2];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_measurement_jacobian(
        taken[0].at, taken[1].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static const wanted_t wanted_warpos_gps_measurement_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_warpos_gps_measurement_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_measurement_nz, 1, 1, 1, 2};
    PyObject *arrays[2];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_measurement_nz(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static const wanted_t wanted_warpos_gps_observed[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
};

static PyObject *call_warpos_gps_observed(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_observed, 2, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[4];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_observed(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static PyObject *bound_warpos_gps_observed(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_warpos_gps_observed;
    taken_t taken[4];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 4, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)warpos_gps_observed(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at);
        step_back(aside);
    }
    return finish_bound(kept, 4, status);
}

static const wanted_t wanted_warpos_gps_observed_value[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_warpos_gps_observed_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_observed_value, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_observed_value(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static const wanted_t wanted_warpos_gps_observed_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
};

static PyObject *call_warpos_gps_observed_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_observed_jacobian, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_observed_jacobian(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static const wanted_t wanted_warpos_gps_observed_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
};

static PyObject *call_warpos_gps_observed_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_observed_nz, 2, 1, 1, 2};
    PyObject *arrays[2];
    taken_t taken[4];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_observed_nz(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static const wanted_t wanted_warpos_gps_to_state_frame[] = {
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {4}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
};

static PyObject *call_warpos_gps_to_state_frame(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_warpos_gps_to_state_frame, 6, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[8];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)warpos_gps_to_state_frame(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at, taken[7].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)WARPOS_GPS_PARTIAL);
}

static PyObject *bound_warpos_gps_to_state_frame(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_warpos_gps_to_state_frame;
    taken_t taken[8];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 8, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)warpos_gps_to_state_frame(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
            taken[6].at, taken[7].at);
        step_back(aside);
    }
    return finish_bound(kept, 8, status);
}

int32_t straight_warpos_gps__open(uintptr_t list, const char *name)
{
    static PyMethodDef methods[] = {
        {"retract", (PyCFunction)(void (*)(void))call_warpos_gps_retract,
         METH_FASTCALL, NULL},
        {"retract.bind", bound_warpos_gps_retract, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"local", (PyCFunction)(void (*)(void))call_warpos_gps_local,
         METH_FASTCALL, NULL},
        {"local.bind", bound_warpos_gps_local, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"measurement", (PyCFunction)(void (*)(void))call_warpos_gps_measurement,
         METH_FASTCALL, NULL},
        {"measurement.bind", bound_warpos_gps_measurement, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"measurement.value", (PyCFunction)(void (*)(void))call_warpos_gps_measurement_value,
         METH_FASTCALL, NULL},
        {"measurement.jacobian", (PyCFunction)(void (*)(void))call_warpos_gps_measurement_jacobian,
         METH_FASTCALL, NULL},
        {"measurement.nonzeros", (PyCFunction)(void (*)(void))call_warpos_gps_measurement_nz,
         METH_FASTCALL, NULL},
        {"observed", (PyCFunction)(void (*)(void))call_warpos_gps_observed,
         METH_FASTCALL, NULL},
        {"observed.bind", bound_warpos_gps_observed, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"observed.value", (PyCFunction)(void (*)(void))call_warpos_gps_observed_value,
         METH_FASTCALL, NULL},
        {"observed.jacobian", (PyCFunction)(void (*)(void))call_warpos_gps_observed_jacobian,
         METH_FASTCALL, NULL},
        {"observed.nonzeros", (PyCFunction)(void (*)(void))call_warpos_gps_observed_nz,
         METH_FASTCALL, NULL},
        {"to_state_frame", (PyCFunction)(void (*)(void))call_warpos_gps_to_state_frame,
         METH_FASTCALL, NULL},
        {"to_state_frame.bind", bound_warpos_gps_to_state_frame, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
    };

    return open_call(list, name, methods, (int)(sizeof methods / sizeof methods[0]));
}
