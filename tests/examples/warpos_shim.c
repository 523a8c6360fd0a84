#include "warpos_shim.h"

#include "gps_measurements.h"

int16_t both(
    uint32_t n,
    const uint32_t indices[3],
    int by_column,
    int in_observer_frame,
    const double *tar_state,
    const double *obs_state,
    double *value,
    double *jacobian)
{
    gps_measurements_t model;
    const int16_t made = gps_measurements_init(
        &model, n, indices[0], indices[1], indices[2],
        by_column ? GPS_MEASUREMENTS_BY_COLUMN : GPS_MEASUREMENTS_BY_ROW,
        in_observer_frame ? GPS_MEASUREMENTS_IN_OBSERVER_FRAME : GPS_MEASUREMENTS_IN_STATE_FRAME);
    const int16_t first =
        gps_measurements_calculate(&model, 0.0, tar_state, obs_state, value);
    const int16_t second =
        gps_measurements_calculate_matrix(&model, 0.0, tar_state, obs_state, jacobian);

    /* A refused constructor is reported again by every call. */
    return (int16_t)((made != 0 && (first != made || second != made)) ? -1
                     : first != 0                                      ? first
                                                                       : second);
}
