/* Both languages behind one C interface: the constructor, then both functions. */
#include <stdint.h>

#ifdef __cplusplus
extern "C"
#endif
int16_t both(
    uint32_t n,
    const uint32_t indices[3],
    int by_column,
    int in_observer_frame,
    const double *tar_state,
    const double *obs_state,
    double *value,
    double *jacobian);
