/**
 * @file gps_measurements.h
 * @brief The two functions of WarpTwin's GPSMeasurements<N> over the generated C of warpos_gps.
 *
 * N, the start of the position and the order of the flat Jacobian are chosen at run time; value and
 * non-zeros come from the generated functions, and only their places are worked out here. Link with
 * the sources in generated/warpos_gps/c/src.
 */

#ifndef GPS_MEASUREMENTS_H
#define GPS_MEASUREMENTS_H

#include <stdint.h>

#include <warpos_gps/warpos_gps.h>

#define GPS_MEASUREMENT_VECTOR_ELEMENTS 3
#define GPS_MEASUREMENT_OBSERVER_VECTOR_ELEMENTS 4

/** Order of the flat Jacobian, which the documentation leaves open. */
typedef enum {
    GPS_MEASUREMENTS_BY_ROW = 0,    /* element (i, j) at i * N + j */
    GPS_MEASUREMENTS_BY_COLUMN = 1  /* element (i, j) at j * 3 + i */
} gps_measurements_order_t;

/** Whose axes the prediction is resolved in, which the documentation leaves open as well. */
typedef enum {
    GPS_MEASUREMENTS_IN_STATE_FRAME = 0,    /* F: the observer's attitude is not read */
    GPS_MEASUREMENTS_IN_OBSERVER_FRAME = 1  /* REF: turned by the transpose of quat_F_REF */
} gps_measurements_frame_t;

/** What the constructor is told. */
typedef struct {
    uint32_t n;  /* length of the state; 0 when the indices were refused */
    uint32_t state_pos_index;
    gps_measurements_order_t order;
    gps_measurements_frame_t frame;
} gps_measurements_t;

/**
 * @brief Stands for the constructor.
 *
 * With three measured and four observer elements, either index of theirs can only be zero.
 *
 * @return 0, or WARPOS_GPS_INDEX when an index leaves no room; calls then return that as well.
 */
static inline int16_t gps_measurements_init(
    gps_measurements_t *self,
    uint32_t n,
    uint32_t state_pos_index,
    uint32_t observer_quat_index,
    uint32_t meas_pos_index,
    gps_measurements_order_t order,
    gps_measurements_frame_t frame)
{
    const int fits = n >= 3U && state_pos_index <= n - 3U;
    const int known = observer_quat_index == 0U && meas_pos_index == 0U;

    if (self == 0) {
        return (int16_t)WARPOS_GPS_NULL;
    }
    self->n = (fits && known) ? n : 0U;
    self->state_pos_index = state_pos_index;
    self->order = order;
    self->frame = frame;
    return (int16_t)(self->n != 0U ? WARPOS_GPS_OK : WARPOS_GPS_INDEX);
}

/** The state of warpos_gps with the position of the caller's. */
static inline warpos_gps_status_t gps_measurements_place(
    const gps_measurements_t *self,
    const warpos_gps_real_t *tar_state,
    warpos_gps_real_t x[WARPOS_GPS_STATE_SIZE])
{
    int32_t i;

    if (self == 0 || tar_state == 0) {
        return WARPOS_GPS_NULL;
    }
    if (self->n == 0U) {
        return WARPOS_GPS_INDEX;
    }
    for (i = 0; i < WARPOS_GPS_STATE_SIZE; ++i) {
        x[i] = 0;
    }
    for (i = 0; i < WARPOS_GPS_XSIZE_POSITION; ++i) {
        x[WARPOS_GPS_X_POSITION + i] = tar_state[self->state_pos_index + (uint32_t)i];
    }
    return WARPOS_GPS_OK;
}

/**
 * @brief Predicted measurement.
 *
 * @param[in]   self                  From gps_measurements_init.
 * @param[in]   time                  Not read.
 * @param[in]   tar_state             [n] State.
 * @param[in]   obs_state             [4] quat_F_REF, order w x y z; read in the observer's frame only.
 * @param[out]  expected_measurement  [3] m.
 * @return 0, or the status of the generated function; the output then stays untouched.
 */
static inline int16_t gps_measurements_calculate(
    const gps_measurements_t *self,
    warpos_gps_real_t time,
    const warpos_gps_real_t *tar_state,
    const warpos_gps_real_t *obs_state,
    warpos_gps_real_t *expected_measurement)
{
    warpos_gps_real_t x[WARPOS_GPS_STATE_SIZE];
    const warpos_gps_status_t placed = gps_measurements_place(self, tar_state, x);

    (void)time;
    if (placed != WARPOS_GPS_OK) {
        return (int16_t)placed;
    }
    if (self->frame == GPS_MEASUREMENTS_IN_OBSERVER_FRAME) {
        return (int16_t)warpos_gps_observed_value(x, obs_state, expected_measurement);
    }
    return (int16_t)warpos_gps_measurement_value(x, expected_measurement);
}

/** Every element of the flat Jacobian: the non-zeros at their places, zeros elsewhere. */
static inline void gps_measurements_scatter(
    const gps_measurements_t *self,
    int32_t count,
    const int32_t *rows,
    const int32_t *columns,
    const warpos_gps_real_t *nonzeros,
    warpos_gps_real_t *jacobian)
{
    const uint32_t m = GPS_MEASUREMENT_VECTOR_ELEMENTS;
    uint32_t k;
    int32_t e;

    for (k = 0U; k < m * self->n; ++k) {
        jacobian[k] = 0;
    }
    for (e = 0; e < count; ++e) {
        const uint32_t i = (uint32_t)rows[e];
        const uint32_t j = self->state_pos_index + (uint32_t)(columns[e] - WARPOS_GPS_E_POSITION);

        jacobian[self->order == GPS_MEASUREMENTS_BY_COLUMN ? j * m + i : i * self->n + j] =
            nonzeros[e];
    }
}

/**
 * @brief Jacobian of the measurement by the state, flat.
 *
 * @param[in]   self                  From gps_measurements_init.
 * @param[in]   time                  Not read.
 * @param[in]   tar_state             [n] State.
 * @param[in]   obs_state             [4] quat_F_REF, order w x y z; read in the observer's frame only.
 * @param[out]  measurement_jacobian  [3 n] In the order chosen.
 * @return 0, or the status of the generated function; the output then stays untouched.
 */
static inline int16_t gps_measurements_calculate_matrix(
    const gps_measurements_t *self,
    warpos_gps_real_t time,
    const warpos_gps_real_t *tar_state,
    const warpos_gps_real_t *obs_state,
    warpos_gps_real_t *measurement_jacobian)
{
    warpos_gps_real_t x[WARPOS_GPS_STATE_SIZE];
    warpos_gps_real_t value[GPS_MEASUREMENT_VECTOR_ELEMENTS];
    warpos_gps_status_t status = gps_measurements_place(self, tar_state, x);

    (void)time;
    if (status == WARPOS_GPS_OK && measurement_jacobian == 0) {
        status = WARPOS_GPS_NULL;
    }
    if (status != WARPOS_GPS_OK) {
        return (int16_t)status;
    }
    if (self->frame == GPS_MEASUREMENTS_IN_OBSERVER_FRAME) {
        warpos_gps_real_t turned[WARPOS_GPS_OBSERVED_JACOBIAN_NNZ];

        status = warpos_gps_observed_nz(x, obs_state, value, turned);
        if (status == WARPOS_GPS_OK) {
            gps_measurements_scatter(
                self, WARPOS_GPS_OBSERVED_JACOBIAN_NNZ, warpos_gps_observed_jacobian_rows,
                warpos_gps_observed_jacobian_columns, turned, measurement_jacobian);
        }
    } else {
        warpos_gps_real_t plain[WARPOS_GPS_MEASUREMENT_JACOBIAN_NNZ];

        status = warpos_gps_measurement_nz(x, value, plain);
        if (status == WARPOS_GPS_OK) {
            gps_measurements_scatter(
                self, WARPOS_GPS_MEASUREMENT_JACOBIAN_NNZ, warpos_gps_measurement_jacobian_rows,
                warpos_gps_measurement_jacobian_columns, plain, measurement_jacobian);
        }
    }
    return (int16_t)status;
}

#endif /* GPS_MEASUREMENTS_H */
