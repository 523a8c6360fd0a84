/* Straight ways into the C of ekf_cal_online, for Python; see straight.h. */

#include "ekf_cal_online_straight.h"
#include "straight.h"

#include "ekf_cal_online/ekf_cal_online.h"

int32_t straight_ekf_cal_online_layout(void)
{
    return NPY_ABI_VERSION >> 24;
}

int32_t straight_ekf_cal_online_retract(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {25}},
        {NPY_DOUBLE, 8, true, 1, {26}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_retract(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_ekf_cal_online_retract_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {25}},
        {NPY_DOUBLE, 8, true, 1, {26}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_retract_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_ekf_cal_online_local(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, true, 1, {25}},
    };
    taken_t taken[3];
    extent_t extent;

    if (!take(given, wanted, 3, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_local(
        taken[0].at, taken[1].at, taken[2].at);
}

int32_t straight_ekf_cal_online_local_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, true, 1, {25}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[4];
    extent_t extent;

    if (!take(given, wanted, 4, true, &extent, taken) || !has_epochs(&extent, first, count)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_local_batch(
        count, epoch_of(&taken[0], &wanted[0], first), (int32_t)taken[0].step,
        epoch_of(&taken[1], &wanted[1], first), (int32_t)taken[1].step,
        epoch_of(&taken[2], &wanted[2], first), epoch_of(&taken[3], &wanted[3], first));
}

int32_t straight_ekf_cal_online_gps_1(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 25}},
        {NPY_DOUBLE, 8, true, 2, {3, 3}},
    };
    taken_t taken[7];
    extent_t extent;

    if (!take(given, wanted, 7, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_gps_1(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at, taken[6].at);
}

int32_t straight_ekf_cal_online_gps_1_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 25}},
        {NPY_DOUBLE, 8, true, 2, {3, 3}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[8];
    extent_t extent;

    if (!take(given, wanted, 8, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_ekf_cal_online_gps_1_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {25}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[8];
    extent_t extent;

    if (!take(given, wanted, 8, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_ekf_cal_online_gps_2(uintptr_t given)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 25}},
        {NPY_DOUBLE, 8, true, 2, {3, 3}},
    };
    taken_t taken[7];
    extent_t extent;

    if (!take(given, wanted, 7, false, &extent, taken)) {
        return UNFIT;
    }
    return (int32_t)ekf_cal_online_gps_2(
        taken[0].at, taken[1].at, taken[2].at, taken[3].at, taken[4].at, taken[5].at, taken[6].at);
}

int32_t straight_ekf_cal_online_gps_2_batch(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 2, {3, 25}},
        {NPY_DOUBLE, 8, true, 2, {3, 3}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[8];
    extent_t extent;

    if (!take(given, wanted, 8, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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

int32_t straight_ekf_cal_online_gps_2_batch_nz(uintptr_t given, int32_t first, int32_t count)
{
    static const wanted_t wanted[] = {
        {NPY_DOUBLE, 8, false, 1, {26}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, false, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_DOUBLE, 8, true, 1, {25}},
        {NPY_DOUBLE, 8, true, 1, {3}},
        {NPY_UINT8, 1, true, 0, {0}},
    };
    taken_t taken[8];
    extent_t extent;

    if (!take(given, wanted, 8, true, &extent, taken) || !has_epochs(&extent, first, count)) {
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
