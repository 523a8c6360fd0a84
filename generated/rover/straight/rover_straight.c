/* Straight ways into the C of rover, for Python; see straight.h. */

#include "rover_straight.h"
#include "straight.h"

#include "rover/rover.h"

int32_t straight_rover_layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

int32_t straight_rover_retract(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {21}},
        {NPY_DOUBLE, 8, true, 1, {22}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)rover_retract(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_rover_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {21}},
        {NPY_DOUBLE, 8, true, 1, {22}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_rover_local(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, true, 1, {21}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)rover_local(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_rover_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, true, 1, {21}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_rover_gps(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 21}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)rover_gps(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_rover_gps_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 21}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_gps_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), epoch_of(&taken[2], &wanted[2], first),
        epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_rover_gps_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {21}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)rover_gps_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), epoch_of(&taken[2], &wanted[2], first),
        epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_rover_range(uintptr_t given)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[13];
    extent_t extent;

    if (!take(given, wanted, 13, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)rover_range(
        taken[0].at, (int32_t)extent.items, taken[1].at, taken[2].at, taken[3].at, taken[4].at,
        taken[5].at, taken[6].at, taken[7].at, taken[8].at, taken[9].at, taken[10].at, taken[11].at,
        taken[12].at);
}

int32_t straight_rover_range_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[14];
    extent_t extent;

    if (!take(given, wanted, 14, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_rover_range_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
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
    taken_t taken[14];
    extent_t extent;

    if (!take(given, wanted, 14, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_rover_imu(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {6}},
        {NPY_DOUBLE, 8, false, 1, {6}},
        {NPY_DOUBLE, 8, false, 0, {0}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 21}},
    };
    taken_t taken[6];
    extent_t extent;

    if (!take(given, wanted, 6, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)rover_imu(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
}

int32_t straight_rover_imu_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {6}},
        {NPY_DOUBLE, 8, false, 1, {6}},
        {NPY_DOUBLE, 8, false, 0, {0}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 21}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[7];
    extent_t extent;

    if (!take(given, wanted, 7, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_rover_imu_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {6}},
        {NPY_DOUBLE, 8, false, 1, {6}},
        {NPY_DOUBLE, 8, false, 0, {0}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {27}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[7];
    extent_t extent;

    if (!take(given, wanted, 7, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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
