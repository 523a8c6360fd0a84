/* Straight ways into the C of single_point, for Python; see straight.h.
   Many epochs by the address of a tuple, the first of them and their number. No function of a
   specification has a name that begins with an underscore. */
#ifndef SINGLE_POINT_STRAIGHT_H
#define SINGLE_POINT_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_single_point__layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_single_point__open(uintptr_t list, const char *name);
int32_t straight_single_point_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_single_point_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_single_point_pseudorange_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_single_point_pseudorange_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_single_point_pseudorange_without_sagnac_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_single_point_pseudorange_without_sagnac_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_single_point_broadcast_orbit_batch(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
