/* Straight ways into the C of farrell_tightly_coupled, for Python; see straight.h.
   Many epochs by the address of a tuple, the first of them and their number. No function of a
   specification has a name that begins with an underscore. */
#ifndef FARRELL_TIGHTLY_COUPLED_STRAIGHT_H
#define FARRELL_TIGHTLY_COUPLED_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_farrell_tightly_coupled__layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_farrell_tightly_coupled__open(uintptr_t list, const char *name);
int32_t straight_farrell_tightly_coupled_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_pseudorange_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_pseudorange_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm_batch_nz(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
