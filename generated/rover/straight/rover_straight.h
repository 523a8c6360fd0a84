/* Straight ways into the C of rover, for Python; see straight.h.
   Many epochs by the address of a tuple, the first of them and their number. No function of a
   specification has a name that begins with an underscore. */
#ifndef ROVER_STRAIGHT_H
#define ROVER_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_rover__layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_rover__open(uintptr_t list, const char *name);
int32_t straight_rover_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_gps_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_gps_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_range_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_range_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_imu_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_rover_imu_batch_nz(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
