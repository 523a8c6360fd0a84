/* Straight ways into the C of warpos_gps, for Python; see straight.h.
   Many epochs by the address of a tuple, the first of them and their number. No function of a
   specification has a name that begins with an underscore. */
#ifndef WARPOS_GPS_STRAIGHT_H
#define WARPOS_GPS_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_warpos_gps__layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_warpos_gps__open(uintptr_t list, const char *name);
int32_t straight_warpos_gps_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_measurement_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_measurement_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_measurement_by_column_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_measurement_by_column_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_observed_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_observed_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_observed_by_column_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_observed_by_column_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_warpos_gps_to_state_frame_batch(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
