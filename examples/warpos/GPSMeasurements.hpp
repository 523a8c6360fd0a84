/**
 * @file GPSMeasurements.hpp
 * @brief Class template with the constructor and the two functions that WarpTwin documents.
 */

#ifndef GPS_MEASUREMENTS_HPP
#define GPS_MEASUREMENTS_HPP

#include <array>
#include <cstdint>

#include "gps_measurements.h"

/**
 * @brief Position measured by a GPS receiver, of a state of N elements.
 *
 * A constructor cannot return a status: indices that leave no room make every call return
 * WARPOS_GPS_INDEX instead of zero.
 */
template <std::uint32_t N>
class GPSMeasurements {
public:
    using floating_point = warpos_gps_real_t;

    static constexpr std::uint32_t M = GPS_MEASUREMENT_VECTOR_ELEMENTS;
    static constexpr std::uint32_t O = GPS_MEASUREMENT_OBSERVER_VECTOR_ELEMENTS;

    explicit GPSMeasurements(
        std::uint32_t state_pos_index,
        std::uint32_t observer_quat_index = 0,
        std::uint32_t meas_pos_index = 0,
        gps_measurements_order_t order = GPS_MEASUREMENTS_BY_ROW,
        gps_measurements_frame_t frame = GPS_MEASUREMENTS_IN_STATE_FRAME)
    {
        (void)gps_measurements_init(
            &self_, N, state_pos_index, observer_quat_index, meas_pos_index, order, frame);
    }

    std::int16_t calculateMeasurements(
        floating_point time,
        const std::array<floating_point, N> &tar_state,
        const std::array<floating_point, O> &obs_state,
        floating_point expected_measurement[M]) const
    {
        return gps_measurements_calculate(
            &self_, time, tar_state.data(), obs_state.data(), expected_measurement);
    }

    std::int16_t calculateMeasurementsMatrix(
        floating_point time,
        const std::array<floating_point, N> &tar_state,
        const std::array<floating_point, O> &obs_state,
        floating_point measurement_Jacobian[N * M]) const
    {
        return gps_measurements_calculate_matrix(
            &self_, time, tar_state.data(), obs_state.data(), measurement_Jacobian);
    }

private:
    gps_measurements_t self_{};
};

#endif /* GPS_MEASUREMENTS_HPP */
