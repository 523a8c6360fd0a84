"""The functions of ``single_point`` in pure NumPy: no compiler, no dependency.

Leading axes broadcast. Arrays of another library that follows the array API standard (JAX among
them, also under ``jax.jit``) stay in that library; complex arguments carry derivatives.
Names that are not read any more are deleted, so that arrays find room in the cache.
"""

from __future__ import annotations

from typing import Any

from . import _arrays, _calls, _interface, _runtime


def _retract_kernel(xp: Any, guards: _arrays.Guards, x: Any, d: Any) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    clock_bias = x[3]
    d_position_x = d[0]
    d_position_y = d[1]
    d_position_z = d[2]
    d_clock_bias = d[3]
    return (
        (
            d_position_x + position_x,
            d_position_y + position_y,
            d_position_z + position_z,
            clock_bias + d_clock_bias,
        ),
    )


retract = _calls.publish(_arrays.ArrayFunction(_interface.RETRACT, _retract_kernel), __name__)


def _local_kernel(xp: Any, guards: _arrays.Guards, x: Any, y: Any) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    clock_bias = x[3]
    y_position_x = y[0]
    y_position_y = y[1]
    y_position_z = y[2]
    y_clock_bias = y[3]
    return (
        (
            y_position_x - position_x,
            y_position_y - position_y,
            y_position_z - position_z,
            y_clock_bias - clock_bias,
        ),
    )


local = _calls.publish(_arrays.ArrayFunction(_interface.LOCAL, _local_kernel), __name__)


def _pseudorange_kernel(xp: Any, guards: _arrays.Guards, x: Any) -> _arrays.Mapped:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    clock_bias = x[3]
    antenna_x = position_x
    antenna_y = position_y
    antenna_z = position_z

    def item(
        satellite_position: Any, satellite_clock: Any, troposphere: Any, ionosphere: Any
    ) -> _arrays.Nonzeros:
        satellite_position_x = satellite_position[0]
        satellite_position_y = satellite_position[1]
        satellite_position_z = satellite_position[2]
        range_vector_x = antenna_x - satellite_position_x
        range_vector_y = antenna_y - satellite_position_y
        range_vector_z = antenna_z - satellite_position_z
        # squared range
        range_squared = guards.check_item(
            range_vector_x * range_vector_x + range_vector_y * range_vector_y
            + range_vector_z * range_vector_z,
            1e-12,
            1e30,
            4.0,
            _runtime.Status.DOMAIN,
        )
        range = xp.sqrt(range_squared)
        s0 = 1.0 / range
        range_direction_x = range_vector_x * s0
        range_direction_y = range_vector_y * s0
        range_direction_z = range_vector_z * s0
        turned_satellite_0 = 2.4323877909897254e-13 * satellite_position_x
        turned_satellite_1 = 2.4323877909897254e-13 * satellite_position_y
        value_out = (
            clock_bias + ionosphere + range + troposphere + antenna_y * turned_satellite_0
            - 299792458.0 * satellite_clock - antenna_x * turned_satellite_1
        )
        del range_squared, range_vector_x, range_vector_y, range_vector_z, s0, range
        value_out_by_position_x = range_direction_x - turned_satellite_1
        value_out_by_position_y = range_direction_y + turned_satellite_0
        return (
            (value_out,), (value_out_by_position_x, value_out_by_position_y, range_direction_z, 1.0)
        )

    return (), item


pseudorange = _calls.publish(
    _arrays.ArrayFunction(_interface.PSEUDORANGE, _pseudorange_kernel), __name__
)


def _pseudorange_without_sagnac_kernel(xp: Any, guards: _arrays.Guards, x: Any) -> _arrays.Mapped:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    clock_bias = x[3]
    antenna_x = position_x
    antenna_y = position_y
    antenna_z = position_z

    def item(
        satellite_position: Any, satellite_clock: Any, troposphere: Any, ionosphere: Any
    ) -> _arrays.Nonzeros:
        satellite_position_x = satellite_position[0]
        satellite_position_y = satellite_position[1]
        satellite_position_z = satellite_position[2]
        range_vector_x = antenna_x - satellite_position_x
        range_vector_y = antenna_y - satellite_position_y
        range_vector_z = antenna_z - satellite_position_z
        # squared range
        range_squared = guards.check_item(
            range_vector_x * range_vector_x + range_vector_y * range_vector_y
            + range_vector_z * range_vector_z,
            1e-12,
            1e30,
            4.0,
            _runtime.Status.DOMAIN,
        )
        range = xp.sqrt(range_squared)
        s0 = 1.0 / range
        range_direction_x = range_vector_x * s0
        range_direction_y = range_vector_y * s0
        range_direction_z = range_vector_z * s0
        value_out = clock_bias + ionosphere + range + troposphere - 299792458.0 * satellite_clock
        del range_squared, range_vector_x, range_vector_y, range_vector_z, s0, range
        return ((value_out,), (range_direction_x, range_direction_y, range_direction_z, 1.0))

    return (), item


pseudorange_without_sagnac = _calls.publish(
    _arrays.ArrayFunction(
        _interface.PSEUDORANGE_WITHOUT_SAGNAC, _pseudorange_without_sagnac_kernel
    ),
    __name__,
)


def _broadcast_orbit_kernel(
    xp: Any,
    guards: _arrays.Guards,
    time: Any,
    toe: Any,
    toc: Any,
    sqrt_a: Any,
    eccentricity: Any,
    mean_anomaly: Any,
    mean_motion_difference: Any,
    inclination: Any,
    inclination_rate: Any,
    right_ascension: Any,
    right_ascension_rate: Any,
    argument_of_perigee: Any,
    cuc: Any,
    cus: Any,
    crc: Any,
    crs: Any,
    cic: Any,
    cis: Any,
    af0: Any,
    af1: Any,
    af2: Any,
    group_delay: Any,
) -> _arrays.Nonzeros:
    semi_major_axis = sqrt_a * sqrt_a
    computed_motion = (
        19964981.843217388 * xp.sqrt(1.0 / (semi_major_axis * semi_major_axis * semi_major_axis))
    )
    mean_motion = computed_motion + mean_motion_difference
    since_toe_raw = time - toe
    since_toe_weeks = xp.floor(0.5 + 1.6534391534391535e-6 * since_toe_raw)
    since_toe = since_toe_raw - 6.048e5 * since_toe_weeks
    mean_anomaly_now = mean_anomaly + mean_motion * since_toe
    anomaly_0 = mean_anomaly_now + eccentricity * xp.sin(mean_anomaly_now)
    anomaly_1 = (
        anomaly_0 - (anomaly_0 - mean_anomaly_now - eccentricity * xp.sin(anomaly_0)) / (1.0
        - eccentricity * xp.cos(anomaly_0))
    )
    anomaly_2 = (
        anomaly_1 - (anomaly_1 - mean_anomaly_now - eccentricity * xp.sin(anomaly_1)) / (1.0
        - eccentricity * xp.cos(anomaly_1))
    )
    anomaly_3 = (
        anomaly_2 - (anomaly_2 - mean_anomaly_now - eccentricity * xp.sin(anomaly_2)) / (1.0
        - eccentricity * xp.cos(anomaly_2))
    )
    del computed_motion, since_toe_raw, since_toe_weeks, anomaly_0, anomaly_1, anomaly_2
    eccentric_anomaly = (
        anomaly_3 - (anomaly_3 - mean_anomaly_now - eccentricity * xp.sin(anomaly_3)) / (1.0
        - eccentricity * xp.cos(anomaly_3))
    )
    s0 = xp.cos(eccentric_anomaly)
    anomaly_slope_mean = 1.0 / (1.0 - eccentricity * s0)
    cos_anomaly = s0
    lead_ratio = eccentricity / (1.0 + xp.sqrt(1.0 - eccentricity * eccentricity))
    s1 = xp.sin(eccentric_anomaly)
    sin_anomaly = s1
    lead_y = lead_ratio * sin_anomaly
    lead_x = 1.0 - cos_anomaly * lead_ratio
    lead = xp.atan2(lead_y, lead_x)
    true_anomaly = eccentric_anomaly + 2.0 * lead
    del mean_anomaly_now, anomaly_3, s0, sin_anomaly, eccentric_anomaly, lead
    latitude_argument = argument_of_perigee + true_anomaly
    doubled_argument = 2.0 * latitude_argument
    cos_doubled = xp.cos(doubled_argument)
    sin_doubled = xp.sin(doubled_argument)
    corrected_argument = latitude_argument + cos_doubled * cuc + cus * sin_doubled
    radius = (
        cos_doubled * crc + crs * sin_doubled + semi_major_axis * (1.0 - cos_anomaly * eccentricity)
    )
    inclination_now = (
        inclination + cic * cos_doubled + cis * sin_doubled + inclination_rate * since_toe
    )
    node_rate = right_ascension_rate - 7.2921151467e-5
    node = right_ascension + node_rate * since_toe - 7.2921151467e-5 * toe
    cos_argument = xp.cos(corrected_argument)
    in_plane_x = cos_argument * radius
    sin_argument = xp.sin(corrected_argument)
    in_plane_y = radius * sin_argument
    cos_inclination = xp.cos(inclination_now)
    cos_node = xp.cos(node)
    in_plane_level = cos_inclination * in_plane_y
    sin_node = xp.sin(node)
    del true_anomaly, doubled_argument, latitude_argument, since_toe, corrected_argument, node
    position_x = cos_node * in_plane_x - in_plane_level * sin_node
    position_y = cos_node * in_plane_level + in_plane_x * sin_node
    sin_inclination = xp.sin(inclination_now)
    position_z = in_plane_y * sin_inclination
    since_toc_raw = time - toc
    since_toc_weeks = xp.floor(0.5 + 1.6534391534391535e-6 * since_toc_raw)
    since_toc = since_toc_raw - 6.048e5 * since_toc_weeks
    s2 = af2 * since_toc
    clock_drift = af1 + s2
    eccentric_root = eccentricity * sqrt_a
    s3 = 4.442807633e-10 * eccentric_root
    sin_anomaly_clock = s1
    relativity = -(s3 * sin_anomaly_clock)
    clock = af0 + relativity + clock_drift * since_toc - group_delay
    del inclination_now, since_toc_raw, since_toc_weeks, eccentric_root, s1, since_toc, relativity
    s4 = 1.0 / (lead_x * lead_x + lead_y * lead_y)
    lead_by_lead_x = -(lead_y * s4)
    lead_by_lead_y = lead_x * s4
    radius_by_cos_anomaly = -(eccentricity * semi_major_axis)
    eccentric_anomaly_by_time = anomaly_slope_mean * mean_motion
    del lead_y, lead_x, s4, semi_major_axis, mean_motion, anomaly_slope_mean
    cos_anomaly_by_time = -(eccentric_anomaly_by_time * sin_anomaly_clock)
    lead_x_by_time = -(cos_anomaly_by_time * lead_ratio)
    radius_by_time = cos_anomaly_by_time * radius_by_cos_anomaly
    sin_anomaly_by_time = cos_anomaly * eccentric_anomaly_by_time
    lead_y_by_time = lead_ratio * sin_anomaly_by_time
    lead_by_time = lead_by_lead_y * lead_y_by_time
    del sin_anomaly_clock, radius_by_cos_anomaly, cos_anomaly_by_time, cos_anomaly, lead_ratio
    del lead_by_lead_y, lead_y_by_time
    lead_by_time_2 = lead_by_time + lead_by_lead_x * lead_x_by_time
    true_anomaly_by_time = eccentric_anomaly_by_time + 2.0 * lead_by_time_2
    doubled_argument_by_time = 2.0 * true_anomaly_by_time
    cos_doubled_by_time = -(doubled_argument_by_time * sin_doubled)
    del lead_by_lead_x, lead_x_by_time, lead_by_time, eccentric_anomaly_by_time, lead_by_time_2
    del sin_doubled
    inclination_now_by_time = inclination_rate + cic * cos_doubled_by_time
    corrected_argument_by_time = true_anomaly_by_time + cos_doubled_by_time * cuc
    radius_by_time_2 = radius_by_time + cos_doubled_by_time * crc
    sin_doubled_by_time = cos_doubled * doubled_argument_by_time
    inclination_now_by_time_2 = inclination_now_by_time + cis * sin_doubled_by_time
    del true_anomaly_by_time, radius_by_time, cos_doubled_by_time, cos_doubled
    del doubled_argument_by_time, inclination_now_by_time
    corrected_argument_by_time_2 = corrected_argument_by_time + cus * sin_doubled_by_time
    radius_by_time_3 = radius_by_time_2 + crs * sin_doubled_by_time
    cos_argument_by_time = -(corrected_argument_by_time_2 * sin_argument)
    in_plane_y_by_time = radius_by_time_3 * sin_argument
    in_plane_x_by_time = cos_argument * radius_by_time_3
    cos_inclination_by_time = -(inclination_now_by_time_2 * sin_inclination)
    cos_node_by_time = -(node_rate * sin_node)
    in_plane_x_by_time_2 = in_plane_x_by_time + cos_argument_by_time * radius
    del corrected_argument_by_time, radius_by_time_2, sin_doubled_by_time, sin_argument
    del radius_by_time_3, cos_argument_by_time, in_plane_x_by_time
    position_by_time_x = cos_node * in_plane_x_by_time_2
    position_by_time_y = in_plane_x_by_time_2 * sin_node
    sin_argument_by_time = corrected_argument_by_time_2 * cos_argument
    in_plane_y_by_time_2 = in_plane_y_by_time + radius * sin_argument_by_time
    del in_plane_x_by_time_2, cos_argument, corrected_argument_by_time_2, radius
    del in_plane_y_by_time, sin_argument_by_time
    position_by_time_z = in_plane_y_by_time_2 * sin_inclination
    in_plane_level_by_time = cos_inclination * in_plane_y_by_time_2
    in_plane_level_by_time_2 = in_plane_level_by_time + cos_inclination_by_time * in_plane_y
    sin_inclination_by_time = cos_inclination * inclination_now_by_time_2
    del sin_inclination, in_plane_y_by_time_2, cos_inclination_by_time, in_plane_level_by_time
    del cos_inclination, inclination_now_by_time_2
    position_by_time_z_2 = position_by_time_z + in_plane_y * sin_inclination_by_time
    position_by_time_x_2 = position_by_time_x + cos_node_by_time * in_plane_x
    position_by_time_y_2 = position_by_time_y + cos_node_by_time * in_plane_level
    del in_plane_y, position_by_time_z, sin_inclination_by_time, position_by_time_x
    del cos_node_by_time, position_by_time_y
    sin_node_by_time = cos_node * node_rate
    position_by_time_x_3 = position_by_time_x_2 - in_plane_level * sin_node_by_time
    position_by_time_y_3 = position_by_time_y_2 + in_plane_x * sin_node_by_time
    del node_rate, in_plane_level, position_by_time_x_2, in_plane_x, position_by_time_y_2
    del sin_node_by_time
    position_by_time_x_4 = position_by_time_x_3 - in_plane_level_by_time_2 * sin_node
    position_by_time_y_4 = position_by_time_y_3 + cos_node * in_plane_level_by_time_2
    clock_by_time = clock_drift + s2
    del sin_node, position_by_time_x_3, cos_node, in_plane_level_by_time_2, position_by_time_y_3
    del s2, clock_drift
    relativity_by_time = -(s3 * sin_anomaly_by_time)
    clock_by_time_2 = clock_by_time + relativity_by_time
    return (
        (position_x, position_y, position_z),
        (clock,),
        (position_by_time_x_4, position_by_time_y_4, position_by_time_z_2),
        (clock_by_time_2,),
    )


broadcast_orbit = _calls.publish(
    _arrays.ArrayFunction(_interface.BROADCAST_ORBIT, _broadcast_orbit_kernel), __name__
)
