#include "warpos_shim.h"

#include <algorithm>

#include "GPSMeasurements.hpp"

namespace {

template <std::uint32_t N>
std::int16_t run(
    const std::uint32_t indices[3],
    bool by_column,
    bool in_observer_frame,
    const double *tar_state,
    const double *obs_state,
    double *value,
    double *jacobian)
{
    const GPSMeasurements<N> model(
        indices[0], indices[1], indices[2],
        by_column ? GPS_MEASUREMENTS_BY_COLUMN : GPS_MEASUREMENTS_BY_ROW,
        in_observer_frame ? GPS_MEASUREMENTS_IN_OBSERVER_FRAME : GPS_MEASUREMENTS_IN_STATE_FRAME);
    std::array<double, N> x;
    std::array<double, 4> q;
    std::copy_n(tar_state, N, x.begin());
    std::copy_n(obs_state, 4, q.begin());
    const std::int16_t first = model.calculateMeasurements(0.0, x, q, value);
    return first != 0 ? first : model.calculateMeasurementsMatrix(0.0, x, q, jacobian);
}

}  // namespace

extern "C" int16_t both(
    uint32_t n,
    const uint32_t indices[3],
    int by_column,
    int in_observer_frame,
    const double *tar_state,
    const double *obs_state,
    double *value,
    double *jacobian)
{
    const auto call = n == 3 ? run<3> : n == 7 ? run<7> : n == 15 ? run<15> : run<40>;
    return call(
        indices, by_column != 0, in_observer_frame != 0, tar_state, obs_state, value, jacobian);
}
