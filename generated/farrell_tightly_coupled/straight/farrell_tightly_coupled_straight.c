/* Straight ways into the C of farrell_tightly_coupled, for Python; see straight.h. */

#include "farrell_tightly_coupled_straight.h"
#include "straight.h"

#include "farrell_tightly_coupled/farrell_tightly_coupled.h"

int32_t straight_farrell_tightly_coupled_layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

int32_t straight_farrell_tightly_coupled_retract(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {18}},
        {NPY_DOUBLE, 8, false, 1, {17}},
        {NPY_DOUBLE, 8, true, 1, {18}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_retract(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_farrell_tightly_coupled_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {18}},
        {NPY_DOUBLE, 8, false, 1, {17}},
        {NPY_DOUBLE, 8, true, 1, {18}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_farrell_tightly_coupled_local(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {18}},
        {NPY_DOUBLE, 8, false, 1, {18}},
        {NPY_DOUBLE, 8, true, 1, {17}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_local(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_farrell_tightly_coupled_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {18}},
        {NPY_DOUBLE, 8, false, 1, {18}},
        {NPY_DOUBLE, 8, true, 1, {17}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_farrell_tightly_coupled_pseudorange(uintptr_t given)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[9];
    extent_t extent;

    if (!take(given, wanted, 9, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_pseudorange(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at, taken[8].at);
}

int32_t straight_farrell_tightly_coupled_pseudorange_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[10];
    extent_t extent;

    if (!take(given, wanted, 10, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_farrell_tightly_coupled_pseudorange_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[10];
    extent_t extent;

    if (!take(given, wanted, 10, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {18}},
        {NPY_DOUBLE, 8, false, 1, {9}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 2, {ITEMS, 3}},
        {NPY_DOUBLE, 8, true, 1, {ITEMS}},
        {NPY_DOUBLE, 8, true, 2, {ITEMS, 17}},
        {NPY_UINT8, 1, true, 1, {ITEMS}},
    };
    taken_t taken[8];
    extent_t extent;

    if (!take(given, wanted, 8, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)farrell_tightly_coupled_pseudorange_lever_arm(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at);
}

int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[9];
    extent_t extent;

    if (!take(given, wanted, 9, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[9];
    extent_t extent;

    if (!take(given, wanted, 9, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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
