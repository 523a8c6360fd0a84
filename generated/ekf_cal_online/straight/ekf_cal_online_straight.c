/* Straight ways into the C of ekf_cal_online, for Python; see straight.h. */

#include "ekf_cal_online_straight.h"
#include "calls.h"

#include "ekf_cal_online/ekf_cal_online.h"

int32_t straight_ekf_cal_online__layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

static const wanted_t wanted_ekf_cal_online_retract_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {25}},
    {NPY_DOUBLE, 8, true, 1, {26}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_online_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_retract_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_ekf_cal_online_local_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, true, 1, {25}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_online_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_local_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_ekf_cal_online_gps_1_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 25}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_online_gps_1_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_gps_1_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[8];
    extent_t extent;

    if (!take(tuple, 0, wanted, 8, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_gps_1_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), epoch_of(&taken[4], &wanted[4], first),
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first));
}

static const wanted_t wanted_ekf_cal_online_gps_1_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {25}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_online_gps_1_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_gps_1_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[8];
    extent_t extent;

    if (!take(tuple, 0, wanted, 8, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_gps_1_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), epoch_of(&taken[4], &wanted[4], first),
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first));
}

static const wanted_t wanted_ekf_cal_online_gps_2_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 25}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_online_gps_2_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_gps_2_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[8];
    extent_t extent;

    if (!take(tuple, 0, wanted, 8, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_gps_2_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), epoch_of(&taken[4], &wanted[4], first),
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first));
}

static const wanted_t wanted_ekf_cal_online_gps_2_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {25}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_ekf_cal_online_gps_2_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_gps_2_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[8];
    extent_t extent;

    if (!take(tuple, 0, wanted, 8, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_gps_2_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), epoch_of(&taken[4], &wanted[4], first),
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first),
        epoch_of(&taken[7], &wanted[7], first));
}

static const wanted_t wanted_ekf_cal_online_retract[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {25}},
    {NPY_DOUBLE, 8, true, 1, {26}},
};

static PyObject *call_ekf_cal_online_retract(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_retract, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_retract(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static PyObject *bound_ekf_cal_online_retract(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_retract;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_online_retract(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_ekf_cal_online_local[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, true, 1, {25}},
};

static PyObject *call_ekf_cal_online_local(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_local, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_local(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static PyObject *bound_ekf_cal_online_local(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_local;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_online_local(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_ekf_cal_online_gps_1[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 25}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
};

static PyObject *call_ekf_cal_online_gps_1(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_gps_1, 3, 0, 4, 4};
    PyObject *arrays[4];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_gps_1(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static PyObject *bound_ekf_cal_online_gps_1(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_gps_1;
    taken_t taken[7];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 7, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_online_gps_1(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
            taken[6].at);
        step_back(aside);
    }
    return finish_bound(kept, 7, status);
}

static const wanted_t wanted_ekf_cal_online_gps_1_value[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_ekf_cal_online_gps_1_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_gps_1_value, 3, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_gps_1_value(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static const wanted_t wanted_ekf_cal_online_gps_1_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 25}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
};

static PyObject *call_ekf_cal_online_gps_1_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_gps_1_jacobian, 3, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_gps_1_jacobian(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static const wanted_t wanted_ekf_cal_online_gps_1_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {25}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_ekf_cal_online_gps_1_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_gps_1_nz, 3, 2, 2, 4};
    PyObject *arrays[4];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_gps_1_nz(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static const wanted_t wanted_ekf_cal_online_gps_2[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 25}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
};

static PyObject *call_ekf_cal_online_gps_2(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_gps_2, 3, 0, 4, 4};
    PyObject *arrays[4];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_gps_2(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static PyObject *bound_ekf_cal_online_gps_2(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_ekf_cal_online_gps_2;
    taken_t taken[7];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 7, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)ekf_cal_online_gps_2(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
            taken[6].at);
        step_back(aside);
    }
    return finish_bound(kept, 7, status);
}

static const wanted_t wanted_ekf_cal_online_gps_2_value[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_ekf_cal_online_gps_2_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_gps_2_value, 3, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_gps_2_value(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static const wanted_t wanted_ekf_cal_online_gps_2_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 25}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
};

static PyObject *call_ekf_cal_online_gps_2_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_gps_2_jacobian, 3, 0, 2, 2};
    PyObject *arrays[2];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_gps_2_jacobian(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

static const wanted_t wanted_ekf_cal_online_gps_2_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {26}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {25}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_ekf_cal_online_gps_2_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_ekf_cal_online_gps_2_nz, 3, 2, 2, 4};
    PyObject *arrays[4];
    taken_t taken[7];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)ekf_cal_online_gps_2_nz(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)EKF_CAL_ONLINE_PARTIAL);
}

int32_t straight_ekf_cal_online__open(uintptr_t list, const char *name)
{
    static PyMethodDef methods[] = {
        {"retract", (PyCFunction)(void (*)(void))call_ekf_cal_online_retract,
         METH_FASTCALL, NULL},
        {"retract.bind", bound_ekf_cal_online_retract, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"local", (PyCFunction)(void (*)(void))call_ekf_cal_online_local,
         METH_FASTCALL, NULL},
        {"local.bind", bound_ekf_cal_online_local, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"gps_1", (PyCFunction)(void (*)(void))call_ekf_cal_online_gps_1,
         METH_FASTCALL, NULL},
        {"gps_1.bind", bound_ekf_cal_online_gps_1, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"gps_1.value", (PyCFunction)(void (*)(void))call_ekf_cal_online_gps_1_value,
         METH_FASTCALL, NULL},
        {"gps_1.jacobian", (PyCFunction)(void (*)(void))call_ekf_cal_online_gps_1_jacobian,
         METH_FASTCALL, NULL},
        {"gps_1.nonzeros", (PyCFunction)(void (*)(void))call_ekf_cal_online_gps_1_nz,
         METH_FASTCALL, NULL},
        {"gps_2", (PyCFunction)(void (*)(void))call_ekf_cal_online_gps_2,
         METH_FASTCALL, NULL},
        {"gps_2.bind", bound_ekf_cal_online_gps_2, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"gps_2.value", (PyCFunction)(void (*)(void))call_ekf_cal_online_gps_2_value,
         METH_FASTCALL, NULL},
        {"gps_2.jacobian", (PyCFunction)(void (*)(void))call_ekf_cal_online_gps_2_jacobian,
         METH_FASTCALL, NULL},
        {"gps_2.nonzeros", (PyCFunction)(void (*)(void))call_ekf_cal_online_gps_2_nz,
         METH_FASTCALL, NULL},
    };

    return open_call(list, name, methods, (int)(sizeof methods / sizeof methods[0]));
}
