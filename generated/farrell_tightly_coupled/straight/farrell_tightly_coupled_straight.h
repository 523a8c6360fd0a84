/* Straight ways into the C of farrell_tightly_coupled, for Python; see straight.h.
   An epoch by the address of a tuple; many by that, the first epoch and their number. */
#ifndef FARRELL_TIGHTLY_COUPLED_STRAIGHT_H
#define FARRELL_TIGHTLY_COUPLED_STRAIGHT_H

#include <stdint.h>

/* Interface begins. */
int32_t straight_farrell_tightly_coupled_layout(void); /* generation of NumPy whose arrays are read */
int32_t straight_farrell_tightly_coupled_retract(uintptr_t given);
int32_t straight_farrell_tightly_coupled_retract_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_local(uintptr_t given);
int32_t straight_farrell_tightly_coupled_local_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_pseudorange(uintptr_t given);
int32_t straight_farrell_tightly_coupled_pseudorange_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_pseudorange_batch_nz(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm(uintptr_t given);
int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm_batch(uintptr_t given, int32_t first, int32_t count);
int32_t straight_farrell_tightly_coupled_pseudorange_lever_arm_batch_nz(uintptr_t given, int32_t first, int32_t count);
/* Interface ends. */

#endif
