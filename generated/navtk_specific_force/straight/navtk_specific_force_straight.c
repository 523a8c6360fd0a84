/* Straight ways into the C of navtk_specific_force, for Python; see straight.h. */

#include "navtk_specific_force_straight.h"
#include "calls.h"

#include "navtk_specific_force/navtk_specific_force.h"

int32_t straight_navtk_specific_force__layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

static const wanted_t wanted_navtk_specific_force_retract_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {16}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_navtk_specific_force_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_retract_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_navtk_specific_force_local_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, true, 1, {15}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_navtk_specific_force_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_local_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[4];
    extent_t extent;

    if (!take(tuple, 0, wanted, 4, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

static const wanted_t wanted_navtk_specific_force_calc_force_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 1}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_navtk_specific_force_calc_force_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_calc_force_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[10];
    extent_t extent;

    if (!take(tuple, 0, wanted, 10, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_calc_force_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first),
        epoch_of(&taken[6], &wanted[6], first), epoch_of(&taken[7], &wanted[7], first),
        epoch_of(&taken[8], &wanted[8], first), epoch_of(&taken[9], &wanted[9], first));
}

static const wanted_t wanted_navtk_specific_force_calc_force_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {6}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_navtk_specific_force_calc_force_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_calc_force_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[10];
    extent_t extent;

    if (!take(tuple, 0, wanted, 10, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_calc_force_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first),
        epoch_of(&taken[6], &wanted[6], first), epoch_of(&taken[7], &wanted[7], first),
        epoch_of(&taken[8], &wanted[8], first), epoch_of(&taken[9], &wanted[9], first));
}

static const wanted_t wanted_navtk_specific_force_force_batch[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 1}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_navtk_specific_force_force_batch(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_force_batch;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[10];
    extent_t extent;

    if (!take(tuple, 0, wanted, 10, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_force_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first),
        epoch_of(&taken[6], &wanted[6], first), epoch_of(&taken[7], &wanted[7], first),
        epoch_of(&taken[8], &wanted[8], first), epoch_of(&taken[9], &wanted[9], first));
}

static const wanted_t wanted_navtk_specific_force_force_batch_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {24}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_UINT8, 1, true, 0, {0}},
};

int32_t straight_navtk_specific_force_force_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_force_batch_nz;
    PyObject *const tuple = (PyObject *)given;
    taken_t taken[10];
    extent_t extent;

    if (!take(tuple, 0, wanted, 10, true, &extent, taken)
        || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_force_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), (int32_t)taken[3].step,
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first),
        epoch_of(&taken[6], &wanted[6], first), epoch_of(&taken[7], &wanted[7], first),
        epoch_of(&taken[8], &wanted[8], first), epoch_of(&taken[9], &wanted[9], first));
}

static const wanted_t wanted_navtk_specific_force_retract[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {15}},
    {NPY_DOUBLE, 8, true, 1, {16}},
};

static PyObject *call_navtk_specific_force_retract(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_retract, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_retract(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static PyObject *bound_navtk_specific_force_retract(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_retract;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)navtk_specific_force_retract(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_navtk_specific_force_local[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, true, 1, {15}},
};

static PyObject *call_navtk_specific_force_local(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_local, 2, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[3];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_local(
        taken[0].at, taken[1].at, taken[2].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static PyObject *bound_navtk_specific_force_local(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_local;
    taken_t taken[3];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 3, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)navtk_specific_force_local(
            taken[0].at, taken[1].at, taken[2].at);
        step_back(aside);
    }
    return finish_bound(kept, 3, status);
}

static const wanted_t wanted_navtk_specific_force_calc_force[] = {
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 1}},
};

static PyObject *call_navtk_specific_force_calc_force(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_calc_force, 4, 0, 5, 5};
    PyObject *arrays[5];
    taken_t taken[9];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_calc_force(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at, taken[7].at, taken[8].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static PyObject *bound_navtk_specific_force_calc_force(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_calc_force;
    taken_t taken[9];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 9, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)navtk_specific_force_calc_force(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
            taken[6].at, taken[7].at, taken[8].at);
        step_back(aside);
    }
    return finish_bound(kept, 9, status);
}

static const wanted_t wanted_navtk_specific_force_calc_force_value[] = {
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_navtk_specific_force_calc_force_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_calc_force_value, 4, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_calc_force_value(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static const wanted_t wanted_navtk_specific_force_calc_force_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 1}},
};

static PyObject *call_navtk_specific_force_calc_force_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_calc_force_jacobian, 4, 0, 4, 4};
    PyObject *arrays[4];
    taken_t taken[8];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_calc_force_jacobian(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at, taken[7].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static const wanted_t wanted_navtk_specific_force_calc_force_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {9}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {6}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_navtk_specific_force_calc_force_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_calc_force_nz, 4, 1, 4, 5};
    PyObject *arrays[5];
    taken_t taken[9];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_calc_force_nz(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at, taken[7].at, taken[8].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static const wanted_t wanted_navtk_specific_force_force[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 1}},
};

static PyObject *call_navtk_specific_force_force(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_force, 4, 0, 5, 5};
    PyObject *arrays[5];
    taken_t taken[9];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_force(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at, taken[7].at, taken[8].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static PyObject *bound_navtk_specific_force_force(PyObject *kept, PyObject *nothing)
{
    const wanted_t *const wanted = wanted_navtk_specific_force_force;
    taken_t taken[9];
    extent_t extent;
    int32_t status = UNFIT;

    (void)nothing;
    if (take(kept, BOUND_MORE, wanted, 9, false, &extent, taken)) {
        PyThreadState *const aside = step_aside(&extent);

        status = (int32_t)navtk_specific_force_force(
            taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
            taken[6].at, taken[7].at, taken[8].at);
        step_back(aside);
    }
    return finish_bound(kept, 9, status);
}

static const wanted_t wanted_navtk_specific_force_force_value[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_navtk_specific_force_force_value(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_force_value, 4, 0, 1, 1};
    PyObject *arrays[1];
    taken_t taken[5];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_force_value(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static const wanted_t wanted_navtk_specific_force_force_jacobian[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 2, {3, 15}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 3}},
    {NPY_DOUBLE, 8, true, 2, {3, 1}},
};

static PyObject *call_navtk_specific_force_force_jacobian(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_force_jacobian, 4, 0, 4, 4};
    PyObject *arrays[4];
    taken_t taken[8];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_force_jacobian(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at, taken[7].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

static const wanted_t wanted_navtk_specific_force_force_nz[] = {
    {NPY_DOUBLE, 8, false, 1, {16}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 1, {3}},
    {NPY_DOUBLE, 8, false, 0, {0}},
    {NPY_DOUBLE, 8, true, 1, {3}},
    {NPY_DOUBLE, 8, true, 1, {24}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {9}},
    {NPY_DOUBLE, 8, true, 1, {3}},
};

static PyObject *call_navtk_specific_force_force_nz(
    PyObject *kept,
    PyObject *const given[],
    Py_ssize_t count)
{
    static const call_t call = {
        wanted_navtk_specific_force_force_nz, 4, 1, 4, 5};
    PyObject *arrays[5];
    taken_t taken[9];
    extent_t extent;
    PyThreadState *aside;
    int32_t status;

    if (!begin(&call, kept, given, count, arrays, taken, &extent)) {
        Py_RETURN_NONE;
    }
    aside = step_aside(&extent);
    status = (int32_t)navtk_specific_force_force_nz(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at,
        taken[6].at, taken[7].at, taken[8].at);
    step_back(aside);
    return finish(&call, kept, arrays, status, (int32_t)NAVTK_SPECIFIC_FORCE_PARTIAL);
}

int32_t straight_navtk_specific_force__open(uintptr_t list, const char *name)
{
    static PyMethodDef methods[] = {
        {"retract", (PyCFunction)(void (*)(void))call_navtk_specific_force_retract,
         METH_FASTCALL, NULL},
        {"retract.bind", bound_navtk_specific_force_retract, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"local", (PyCFunction)(void (*)(void))call_navtk_specific_force_local,
         METH_FASTCALL, NULL},
        {"local.bind", bound_navtk_specific_force_local, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"calc_force", (PyCFunction)(void (*)(void))call_navtk_specific_force_calc_force,
         METH_FASTCALL, NULL},
        {"calc_force.bind", bound_navtk_specific_force_calc_force, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"calc_force.value", (PyCFunction)(void (*)(void))call_navtk_specific_force_calc_force_value,
         METH_FASTCALL, NULL},
        {"calc_force.jacobian", (PyCFunction)(void (*)(void))call_navtk_specific_force_calc_force_jacobian,
         METH_FASTCALL, NULL},
        {"calc_force.nonzeros", (PyCFunction)(void (*)(void))call_navtk_specific_force_calc_force_nz,
         METH_FASTCALL, NULL},
        {"force", (PyCFunction)(void (*)(void))call_navtk_specific_force_force,
         METH_FASTCALL, NULL},
        {"force.bind", bound_navtk_specific_force_force, METH_NOARGS,
         "bind($self, /)\n--\n\nThe function over these very arrays."},
        {"force.value", (PyCFunction)(void (*)(void))call_navtk_specific_force_force_value,
         METH_FASTCALL, NULL},
        {"force.jacobian", (PyCFunction)(void (*)(void))call_navtk_specific_force_force_jacobian,
         METH_FASTCALL, NULL},
        {"force.nonzeros", (PyCFunction)(void (*)(void))call_navtk_specific_force_force_nz,
         METH_FASTCALL, NULL},
    };

    return open_call(list, name, methods, (int)(sizeof methods / sizeof methods[0]));
}
