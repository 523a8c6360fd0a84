/* Straight ways into the C of ekf_cal_online, for Python; see straight.h.
   Many epochs by the address of a tuple, the first of them and their number. No function of a
   specification has a name that begins with an underscore. */
#ifndef EKF_CAL_ONLINE_STRAIGHT_H
#define EKF_CAL_ONLINE_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_ekf_cal_online__layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_ekf_cal_online__open(uintptr_t list, const char *name);
int32_t straight_ekf_cal_online_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_gps_1_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_gps_1_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_gps_2_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_ekf_cal_online_gps_2_batch_nz(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
