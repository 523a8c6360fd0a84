/* Straight ways into the C of navtk_specific_force, for Python; see straight.h.
   Many epochs by the address of a tuple, the first of them and their number. No function of a
   specification has a name that begins with an underscore. */
#ifndef NAVTK_SPECIFIC_FORCE_STRAIGHT_H
#define NAVTK_SPECIFIC_FORCE_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_navtk_specific_force__layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_navtk_specific_force__open(uintptr_t list, const char *name);
int32_t straight_navtk_specific_force_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_navtk_specific_force_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_navtk_specific_force_calc_force_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_navtk_specific_force_calc_force_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_navtk_specific_force_force_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_navtk_specific_force_force_batch_nz(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
