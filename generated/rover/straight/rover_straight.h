/* Straight ways into the C of rover, for Python; see straight.h.
   An epoch by the address of a tuple; many by that, the first epoch and their number. */
#ifndef ROVER_STRAIGHT_H
#define ROVER_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_rover_layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_rover_retract(uintptr_t given);
int32_t straight_rover_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_local(uintptr_t given);
int32_t straight_rover_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_gps(uintptr_t given);
int32_t straight_rover_gps_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_gps_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_range(uintptr_t given);
int32_t straight_rover_range_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_range_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_imu(uintptr_t given);
int32_t straight_rover_imu_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_imu_batch_nz(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
