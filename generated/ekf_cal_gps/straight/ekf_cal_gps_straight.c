/* Straight ways into the C of ekf_cal_gps, for Python; see straight.h. */

#include "ekf_cal_gps_straight.h"
#include "straight.h"

#include "ekf_cal_gps/ekf_cal_gps.h"

int32_t straight_ekf_cal_gps_layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

int32_t straight_ekf_cal_gps_retract(uintptr_t given)
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
    return (int32_t)ekf_cal_gps_retract(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_ekf_cal_gps_retract_batch(uintptr_t given, int32_t first, int32_t count)
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
    return (int32_t)ekf_cal_gps_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_ekf_cal_gps_local(uintptr_t given)
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
    return (int32_t)ekf_cal_gps_local(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_ekf_cal_gps_local_batch(uintptr_t given, int32_t first, int32_t count)
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
    return (int32_t)ekf_cal_gps_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_ekf_cal_gps_gps(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 21}},
    };
    taken_t taken[5];
    extent_t extent;

    if (!take(given, wanted, 5, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at);
}

int32_t straight_ekf_cal_gps_gps_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 21}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[6];
    extent_t extent;

    if (!take(given, wanted, 6, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first),
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first));
}

int32_t straight_ekf_cal_gps_gps_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {21}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[6];
    extent_t extent;

    if (!take(given, wanted, 6, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first),
        epoch_of(&taken[4], &wanted[4], first), epoch_of(&taken[5], &wanted[5], first));
}

int32_t straight_ekf_cal_gps_gps_known_antenna(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 21}},
    };
    taken_t taken[6];
    extent_t extent;

    if (!take(given, wanted, 6, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_known_antenna(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at);
}

int32_t straight_ekf_cal_gps_gps_known_antenna_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 21}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[7];
    extent_t extent;

    if (!take(given, wanted, 7, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_known_antenna_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), epoch_of(&taken[4], &wanted[4], first),
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first));
}

int32_t straight_ekf_cal_gps_gps_known_antenna_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {22}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {12}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[7];
    extent_t extent;

    if (!take(given, wanted, 7, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_gps_known_antenna_batch_nz(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), (int32_t)taken[2].step,
        epoch_of(&taken[3], &wanted[3], first), epoch_of(&taken[4], &wanted[4], first),
        epoch_of(&taken[5], &wanted[5], first), epoch_of(&taken[6], &wanted[6], first));
}

int32_t straight_ekf_cal_gps_local_fix(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 0, {0}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {9}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 3}},
        {NPY_DOUBLE, 8, true, 1, {9}},
    };
    taken_t taken[7];
    extent_t extent;

    if (!take(given, wanted, 7, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_gps_local_fix(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at, taken[6].at);
}

int32_t straight_ekf_cal_gps_local_fix_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 0, {0}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {9}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 3}},
        {NPY_DOUBLE, 8, true, 1, {9}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[8];
    extent_t extent;

    if (!take(given, wanted, 8, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_ekf_cal_gps_local_fix_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 0, {0}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {9}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {9}},
        {NPY_DOUBLE, 8, true, 1, {9}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[8];
    extent_t extent;

    if (!take(given, wanted, 8, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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
