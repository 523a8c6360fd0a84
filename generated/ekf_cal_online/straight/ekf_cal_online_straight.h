/* Straight ways into the C of ekf_cal_online, for Python; see straight.h.
   An epoch by the address of a tuple; many by that, the first epoch and their number. */
#ifndef EKF_CAL_ONLINE_STRAIGHT_H
#define EKF_CAL_ONLINE_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_ekf_cal_online_layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_ekf_cal_online_retract(uintptr_t given);
int32_t straight_ekf_cal_online_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_local(uintptr_t given);
int32_t straight_ekf_cal_online_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_gps_1(uintptr_t given);
int32_t straight_ekf_cal_online_gps_1_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_gps_1_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_gps_2(uintptr_t given);
int32_t straight_ekf_cal_online_gps_2_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_gps_2_batch_nz(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
