/* Straight ways into the C of ekf_cal_gps, for Python; see straight.h. */

#include "ekf_cal_gps_straight.h"
#include "calls.h"

#include "ekf_cal_gps/ekf_cal_gps.h"

int32_t straight_ekf_cal_gps__layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

static const wanted_t wanted_ekf_cal_gps_retract_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {21}},
    {NPY_DOUBLE, 8, true, 1, {22}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_gps_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_retract_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_ekf_cal_gps_local_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {21}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_gps_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_local_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_ekf_cal_gps_gps_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_gps_gps_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_gps_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[6];
    extent_t extent;

    if (!take(tuple, 0, wanted, 6, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first),
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first));
}

static const wanted_t wanted_ekf_cal_gps_gps_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {21}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_gps_gps_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_gps_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[6];
    extent_t extent;

    if (!take(tuple, 0, wanted, 6, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first),
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first));
}

static const wanted_t wanted_ekf_cal_gps_gps_known_antenna_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_gps_gps_known_antenna_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_gps_known_antenna_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[7];
    extent_t extent;

    if (!take(tuple, 0, wanted, 7, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_known_antenna_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), epoch_of(&taken[4], &wanted[4], first),
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first));
}

static const wanted_t wanted_ekf_cal_gps_gps_known_antenna_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {12}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_gps_gps_known_antenna_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_gps_known_antenna_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[7];
    extent_t extent;

    if (!take(tuple, 0, wanted, 7, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_known_antenna_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), epoch_of(&taken[4], &wanted[4], first),
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first));
}

static const wanted_t wanted_ekf_cal_gps_local_fix_batch[] = {
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_gps_local_fix_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_local_fix_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[8];
    extent_t extent;

    if (!take(tuple, 0, wanted, 8, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_local_fix_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first),
        epoch_of(&taken[6], &wanted[6], first), epoch_of(&taken[7], &wanted[7], first));
}

static const wanted_t wanted_ekf_cal_gps_local_fix_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_gps_local_fix_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_local_fix_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[8];
    extent_t extent;

    if (!take(tuple, 0, wanted, 8, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_local_fix_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first),
        epoch_of(&taken[6], &wanted[6], first), epoch_of(&taken[7], &wanted[7], first));
}

static const wanted_t wanted_ekf_cal_gps_retract[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {21}},
    {NPY_DOUBLE, 8, true, 1, {22}},
};

static PyObject *call_ekf_cal_gps_retract(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_retract, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_retract(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static PyObject *bound_ekf_cal_gps_retract(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_retract;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_gps_retract(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_ekf_cal_gps_local[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, true, 1, {21}},
};

static PyObject *call_ekf_cal_gps_local(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_local, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_local(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static PyObject *bound_ekf_cal_gps_local(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_local;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_gps_local(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_ekf_cal_gps_gps[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
};

static PyObject *call_ekf_cal_gps_gps(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_gps, 2, 0, 3, 3};
    PyObject *arrays[3];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_gps(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static PyObject *bound_ekf_cal_gps_gps(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_gps;
    taken_t taken[5];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 5, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_gps_gps(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
        step_back(aside);
    }
    return finish_bound(kept, 5, status);
}

static const wanted_t wanted_ekf_cal_gps_gps_value[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_ekf_cal_gps_gps_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_gps_value, 2, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[4];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_gps_value(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static const wanted_t wanted_ekf_cal_gps_gps_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
};

static PyObject *call_ekf_cal_gps_gps_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_gps_jacobian, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_gps_jacobian(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static const wanted_t wanted_ekf_cal_gps_gps_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {21}},
};

static PyObject *call_ekf_cal_gps_gps_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_gps_nz, 2, 2, 1, 3};
    PyObject *arrays[3];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_gps_nz(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static const wanted_t wanted_ekf_cal_gps_gps_known_antenna[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
};

static PyObject *call_ekf_cal_gps_gps_known_antenna(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_gps_known_antenna, 3, 0, 3, 3};
    PyObject *arrays[3];
    taken_t taken[6];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_gps_known_antenna(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static PyObject *bound_ekf_cal_gps_gps_known_antenna(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_gps_known_antenna;
    taken_t taken[6];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 6, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_gps_gps_known_antenna(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
        step_back(aside);
    }
    return finish_bound(kept, 6, status);
}

static const wanted_t wanted_ekf_cal_gps_gps_known_antenna_value[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_ekf_cal_gps_gps_known_antenna_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_gps_known_antenna_value, 3, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_gps_known_antenna_value(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static const wanted_t wanted_ekf_cal_gps_gps_known_antenna_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 21}},
};

static PyObject *call_ekf_cal_gps_gps_known_antenna_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_gps_known_antenna_jacobian, 3, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[4];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_gps_known_antenna_jacobian(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static const wanted_t wanted_ekf_cal_gps_gps_known_antenna_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {22}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {12}},
};

static PyObject *call_ekf_cal_gps_gps_known_antenna_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_gps_known_antenna_nz, 3, 2, 1, 3};
    PyObject *arrays[3];
    taken_t taken[6];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_gps_known_antenna_nz(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static const wanted_t wanted_ekf_cal_gps_local_fix[] = {
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
};

static PyObject *call_ekf_cal_gps_local_fix(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_local_fix, 4, 0, 3, 3};
    PyObject *arrays[3];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_local_fix(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static PyObject *bound_ekf_cal_gps_local_fix(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_gps_local_fix;
    taken_t taken[7];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 7, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_gps_local_fix(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
            taken[6].at);
        step_back(aside);
    }
    return finish_bound(kept, 7, status);
}

static const wanted_t wanted_ekf_cal_gps_local_fix_value[] = {
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {9}},
};

static PyObject *call_ekf_cal_gps_local_fix_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_local_fix_value, 4, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[6];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_local_fix_value(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

static const wanted_t wanted_ekf_cal_gps_local_fix_jacobian[] = {
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
};

static PyObject *call_ekf_cal_gps_local_fix_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_gps_local_fix_jacobian, 4, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_gps_local_fix_jacobian(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_GPS_PARTIAL);
}

int32_t straight_ekf_cal_gps__open(uintptr_t list, const char *name)
{
    static PyMethodDef methods[] = {
        {"retract", (PyCFunction)(void (*)(void))call_ekf_cal_gps_retract,
         METH_FASTCALL, NULL},
        {"retract.bind", bound_ekf_cal_gps_retract, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"local", (PyCFunction)(void (*)(void))call_ekf_cal_gps_local,
         METH_FASTCALL, NULL},
        {"local.bind", bound_ekf_cal_gps_local, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"gps", (PyCFunction)(void (*)(void))call_ekf_cal_gps_gps,
         METH_FASTCALL, NULL},
        {"gps.bind", bound_ekf_cal_gps_gps, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"gps.value", (PyCFunction)(void (*)(void))call_ekf_cal_gps_gps_value,
         METH_FASTCALL, NULL},
        {"gps.jacobian", (PyCFunction)(void (*)(void))call_ekf_cal_gps_gps_jacobian,
         METH_FASTCALL, NULL},
        {"gps.nonzeros", (PyCFunction)(void (*)(void))call_ekf_cal_gps_gps_nz,
         METH_FASTCALL, NULL},
        {"gps_known_antenna", (PyCFunction)(void (*)(void))call_ekf_cal_gps_gps_known_antenna,
         METH_FASTCALL, NULL},
        {"gps_known_antenna.bind", bound_ekf_cal_gps_gps_known_antenna, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"gps_known_antenna.value", (PyCFunction)(void (*)(void))call_ekf_cal_gps_gps_known_antenna_value,
         METH_FASTCALL, NULL},
        {"gps_known_antenna.jacobian", (PyCFunction)(void (*)(void))call_ekf_cal_gps_gps_known_antenna_jacobian,
         METH_FASTCALL, NULL},
        {"gps_known_antenna.nonzeros", (PyCFunction)(void (*)(void))call_ekf_cal_gps_gps_known_antenna_nz,
         METH_FASTCALL, NULL},
        {"local_fix", (PyCFunction)(void (*)(void))call_ekf_cal_gps_local_fix,
         METH_FASTCALL, NULL},
        {"local_fix.bind", bound_ekf_cal_gps_local_fix, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"local_fix.value", (PyCFunction)(void (*)(void))call_ekf_cal_gps_local_fix_value,
         METH_FASTCALL, NULL},
        {"local_fix.jacobian", (PyCFunction)(void (*)(void))call_ekf_cal_gps_local_fix_jacobian,
         METH_FASTCALL, NULL},
    };

    return open_call(list, name, methods, (int)(sizeof methods / sizeof methods[0]));
}
