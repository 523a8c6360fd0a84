/* Straight ways into the C of navtk_specific_force, for Python; see straight.h. */

#include "navtk_specific_force_straight.h"
#include "straight.h"

#include "navtk_specific_force/navtk_specific_force.h"

int32_t straight_navtk_specific_force_layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

int32_t straight_navtk_specific_force_retract(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {16}},
        {NPY_DOUBLE, 8, false, 1, {15}},
        {NPY_DOUBLE, 8, true, 1, {16}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_retract(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_navtk_specific_force_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {16}},
        {NPY_DOUBLE, 8, false, 1, {15}},
        {NPY_DOUBLE, 8, true, 1, {16}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_navtk_specific_force_local(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {16}},
        {NPY_DOUBLE, 8, false, 1, {16}},
        {NPY_DOUBLE, 8, true, 1, {15}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_local(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_navtk_specific_force_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {16}},
        {NPY_DOUBLE, 8, false, 1, {16}},
        {NPY_DOUBLE, 8, true, 1, {15}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_navtk_specific_force_calc_force(uintptr_t given)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[9];
    extent_t extent;

    if (!take(given, wanted, 9, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_calc_force(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at, taken[6].at,
        taken[7].at, taken[8].at);
}

int32_t straight_navtk_specific_force_calc_force_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[10];
    extent_t extent;

    if (!take(given, wanted, 10, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_navtk_specific_force_calc_force_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[10];
    extent_t extent;

    if (!take(given, wanted, 10, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_navtk_specific_force_force(uintptr_t given)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[9];
    extent_t extent;

    if (!take(given, wanted, 9, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)navtk_specific_force_force(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at, taken[6].at,
        taken[7].at, taken[8].at);
}

int32_t straight_navtk_specific_force_force_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[10];
    extent_t extent;

    if (!take(given, wanted, 10, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_navtk_specific_force_force_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[10];
    extent_t extent;

    if (!take(given, wanted, 10, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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
