"""The functions of ``ekf_cal_gps`` in pure NumPy: no compiler, no dependency.

Leading axes broadcast. Arrays of another library that follows the array API standard (JAX among
them, also under ``jax.jit``) stay in that library; complex arguments carry derivatives.
Names that are not read any more are deleted, so that arrays find room in the cache.
"""

from __future__ import annotations

from typing import Any

from . import _arrays, _calls, _interface


def _retract_kernel(xp: Any, guards: _arrays.Guards, x: Any, d: Any) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    velocity_x = x[3]
    velocity_y = x[4]
    velocity_z = x[5]
    acceleration_x = x[6]
    acceleration_y = x[7]
    acceleration_z = x[8]
    attitude_w = x[9]
    attitude_x = x[10]
    attitude_y = x[11]
    attitude_z = x[12]
    angular_rate_x = x[13]
    angular_rate_y = x[14]
    angular_rate_z = x[15]
    angular_acceleration_x = x[16]
    angular_acceleration_y = x[17]
    angular_acceleration_z = x[18]
    antenna_x = x[19]
    antenna_y = x[20]
    antenna_z = x[21]
    d_position_x = d[0]
    d_position_y = d[1]
    d_position_z = d[2]
    d_velocity_x = d[3]
    d_velocity_y = d[4]
    d_velocity_z = d[5]
    d_acceleration_x = d[6]
    d_acceleration_y = d[7]
    d_acceleration_z = d[8]
    d_attitude_x = d[9]
    d_attitude_y = d[10]
    d_attitude_z = d[11]
    d_angular_rate_x = d[12]
    d_angular_rate_y = d[13]
    d_angular_rate_z = d[14]
    d_angular_acceleration_x = d[15]
    d_angular_acceleration_y = d[16]
    d_angular_acceleration_z = d[17]
    d_antenna_x = d[18]
    d_antenna_y = d[19]
    d_antenna_z = d[20]
    attitude_exp_angle_squared = (
        d_attitude_x * d_attitude_x + d_attitude_y * d_attitude_y + d_attitude_z * d_attitude_z
    )
    s0 = xp.less(attitude_exp_angle_squared, 0.01)
    attitude_exp_safe_squared = xp.where(s0, guards.constant(1.0), attitude_exp_angle_squared)
    attitude_exp_angle = xp.sqrt(attitude_exp_safe_squared)
    attitude_exp_near_cosine = (
        1.0 + attitude_exp_angle_squared * (attitude_exp_angle_squared * (0.0026041666666666665
        + attitude_exp_angle_squared * (9.68812003968254e-8 * attitude_exp_angle_squared
        - 2.170138888888889e-5)) - 0.125)
    )
    attitude_exp_near_sinc = (
        0.5 + attitude_exp_angle_squared * (attitude_exp_angle_squared * (2.6041666666666666e-4
        + attitude_exp_angle_squared * (5.382288910934745e-9 * attitude_exp_angle_squared
        - 1.5500992063492063e-6)) - 0.020833333333333332)
    )
    attitude_exp_half = 0.5 * attitude_exp_angle
    attitude_exp_far_cosine = xp.cos(attitude_exp_half)
    attitude_exp_far_sinc = xp.sin(attitude_exp_half) / attitude_exp_angle
    attitude_exp_cosine = xp.where(s0, attitude_exp_near_cosine, attitude_exp_far_cosine)
    del attitude_exp_safe_squared, attitude_exp_angle_squared, attitude_exp_angle
    del attitude_exp_half, attitude_exp_near_cosine, attitude_exp_far_cosine
    attitude_exp_sinc = xp.where(s0, attitude_exp_near_sinc, attitude_exp_far_sinc)
    attitude_step_w = attitude_exp_cosine
    attitude_step_x = attitude_exp_sinc * d_attitude_x
    attitude_step_y = attitude_exp_sinc * d_attitude_y
    attitude_step_z = attitude_exp_sinc * d_attitude_z
    return (
        (
            d_position_x + position_x,
            d_position_y + position_y,
            d_position_z + position_z,
            d_velocity_x + velocity_x,
            d_velocity_y + velocity_y,
            d_velocity_z + velocity_z,
            acceleration_x + d_acceleration_x,
            acceleration_y + d_acceleration_y,
            acceleration_z + d_acceleration_z,
            attitude_step_w * attitude_w - attitude_step_x * attitude_x
            - attitude_step_y * attitude_y - attitude_step_z * attitude_z,
            attitude_step_w * attitude_x + attitude_step_x * attitude_w
            + attitude_step_z * attitude_y - attitude_step_y * attitude_z,
            attitude_step_w * attitude_y + attitude_step_x * attitude_z
            + attitude_step_y * attitude_w - attitude_step_z * attitude_x,
            attitude_step_w * attitude_z + attitude_step_y * attitude_x
            + attitude_step_z * attitude_w - attitude_step_x * attitude_y,
            angular_rate_x + d_angular_rate_x,
            angular_rate_y + d_angular_rate_y,
            angular_rate_z + d_angular_rate_z,
            angular_acceleration_x + d_angular_acceleration_x,
            angular_acceleration_y + d_angular_acceleration_y,
            angular_acceleration_z + d_angular_acceleration_z,
            antenna_x + d_antenna_x,
            antenna_y + d_antenna_y,
            antenna_z + d_antenna_z,
        ),
    )


retract = _calls.publish(_arrays.ArrayFunction(_interface.RETRACT, _retract_kernel), __name__)


def _local_kernel(xp: Any, guards: _arrays.Guards, x: Any, y: Any) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    velocity_x = x[3]
    velocity_y = x[4]
    velocity_z = x[5]
    acceleration_x = x[6]
    acceleration_y = x[7]
    acceleration_z = x[8]
    attitude_w = x[9]
    attitude_x = x[10]
    attitude_y = x[11]
    attitude_z = x[12]
    angular_rate_x = x[13]
    angular_rate_y = x[14]
    angular_rate_z = x[15]
    angular_acceleration_x = x[16]
    angular_acceleration_y = x[17]
    angular_acceleration_z = x[18]
    antenna_x = x[19]
    antenna_y = x[20]
    antenna_z = x[21]
    y_position_x = y[0]
    y_position_y = y[1]
    y_position_z = y[2]
    y_velocity_x = y[3]
    y_velocity_y = y[4]
    y_velocity_z = y[5]
    y_acceleration_x = y[6]
    y_acceleration_y = y[7]
    y_acceleration_z = y[8]
    y_attitude_w = y[9]
    y_attitude_x = y[10]
    y_attitude_y = y[11]
    y_attitude_z = y[12]
    y_angular_rate_x = y[13]
    y_angular_rate_y = y[14]
    y_angular_rate_z = y[15]
    y_angular_acceleration_x = y[16]
    y_angular_acceleration_y = y[17]
    y_angular_acceleration_z = y[18]
    y_antenna_x = y[19]
    y_antenna_y = y[20]
    y_antenna_z = y[21]
    attitude_log_of_w = (
        attitude_w * y_attitude_w + attitude_x * y_attitude_x + attitude_y * y_attitude_y
        + attitude_z * y_attitude_z
    )
    attitude_log_of_x = (
        attitude_w * y_attitude_x + attitude_z * y_attitude_y - attitude_x * y_attitude_w
        - attitude_y * y_attitude_z
    )
    attitude_log_of_y = (
        attitude_w * y_attitude_y + attitude_x * y_attitude_z - attitude_y * y_attitude_w
        - attitude_z * y_attitude_x
    )
    attitude_log_of_z = (
        attitude_w * y_attitude_z + attitude_y * y_attitude_x - attitude_x * y_attitude_y
        - attitude_z * y_attitude_w
    )
    attitude_log_sign = xp.where(xp.less(attitude_log_of_w, 0.0), guards.constant(-1.0), 1.0)
    attitude_log_w = attitude_log_of_w * attitude_log_sign
    attitude_log_sine_squared = (
        attitude_log_of_x * attitude_log_of_x + attitude_log_of_y * attitude_log_of_y
        + attitude_log_of_z * attitude_log_of_z
    )
    s0 = xp.less(attitude_log_sine_squared, 0.01)
    attitude_log_safe_squared = xp.where(s0, guards.constant(1.0), attitude_log_sine_squared)
    attitude_log_sine = xp.sqrt(attitude_log_safe_squared)
    attitude_log_cosine = xp.where(xp.less(0.5, attitude_log_w), attitude_log_w, 1.0)
    attitude_log_tangent_squared = (
        attitude_log_sine_squared / (attitude_log_cosine * attitude_log_cosine)
    )
    attitude_log_series = (
        1.0 + attitude_log_tangent_squared * (attitude_log_tangent_squared * (0.2
        + attitude_log_tangent_squared * (attitude_log_tangent_squared * (0.1111111111111111
        + attitude_log_tangent_squared * (attitude_log_tangent_squared * (0.07692307692307693
        + attitude_log_tangent_squared * (0.058823529411764705 * attitude_log_tangent_squared
        - 0.06666666666666667)) - 0.09090909090909091)) - 0.14285714285714285))
        - 0.3333333333333333)
    )
    attitude_log_far = 2.0 * xp.atan2(attitude_log_sine, attitude_log_w) / attitude_log_sine
    del attitude_log_of_w, attitude_log_safe_squared, attitude_log_sine_squared
    del attitude_log_tangent_squared, attitude_log_w, attitude_log_sine
    attitude_log_scale = (
        xp.where(s0, 2.0 * attitude_log_series / attitude_log_cosine, attitude_log_far)
    )
    attitude_log_signed_scale = attitude_log_scale * attitude_log_sign
    del s0, attitude_log_cosine, attitude_log_series, attitude_log_far, attitude_log_sign
    del attitude_log_scale
    return (
        (
            y_position_x - position_x,
            y_position_y - position_y,
            y_position_z - position_z,
            y_velocity_x - velocity_x,
            y_velocity_y - velocity_y,
            y_velocity_z - velocity_z,
            y_acceleration_x - acceleration_x,
            y_acceleration_y - acceleration_y,
            y_acceleration_z - acceleration_z,
            attitude_log_of_x * attitude_log_signed_scale,
            attitude_log_of_y * attitude_log_signed_scale,
            attitude_log_of_z * attitude_log_signed_scale,
            y_angular_rate_x - angular_rate_x,
            y_angular_rate_y - angular_rate_y,
            y_angular_rate_z - angular_rate_z,
            y_angular_acceleration_x - angular_acceleration_x,
            y_angular_acceleration_y - angular_acceleration_y,
            y_angular_acceleration_z - angular_acceleration_z,
            y_antenna_x - antenna_x,
            y_antenna_y - antenna_y,
            y_antenna_z - antenna_z,
        ),
    )


local = _calls.publish(_arrays.ArrayFunction(_interface.LOCAL, _local_kernel), __name__)


def _gps_kernel(xp: Any, guards: _arrays.Guards, x: Any, measured: Any) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    attitude_w = x[9]
    attitude_x = x[10]
    attitude_y = x[11]
    attitude_z = x[12]
    antenna_x = x[19]
    antenna_y = x[20]
    antenna_z = x[21]
    measured_x = measured[0]
    measured_y = measured[1]
    measured_z = measured[2]
    attitude_twice_x = 2.0 * attitude_x
    attitude_twice_y = 2.0 * attitude_y
    attitude_twice_z = 2.0 * attitude_z
    attitude_twice_xx = attitude_twice_x * attitude_x
    attitude_twice_yy = attitude_twice_y * attitude_y
    attitude_twice_zz = attitude_twice_z * attitude_z
    attitude_twice_xy = attitude_twice_y * attitude_x
    attitude_twice_xz = attitude_twice_z * attitude_x
    attitude_twice_yz = attitude_twice_z * attitude_y
    attitude_twice_wx = attitude_twice_x * attitude_w
    attitude_twice_wy = attitude_twice_y * attitude_w
    attitude_twice_wz = attitude_twice_z * attitude_w
    s0 = attitude_twice_zz - 1.0
    attitude_00 = -attitude_twice_yy - s0
    attitude_01 = attitude_twice_xy - attitude_twice_wz
    attitude_02 = attitude_twice_wy + attitude_twice_xz
    attitude_10 = attitude_twice_wz + attitude_twice_xy
    del attitude_twice_x, attitude_twice_y, attitude_twice_z, attitude_twice_zz, attitude_twice_xy
    del attitude_twice_wz
    attitude_11 = -attitude_twice_xx - s0
    attitude_12 = attitude_twice_yz - attitude_twice_wx
    attitude_20 = attitude_twice_xz - attitude_twice_wy
    attitude_21 = attitude_twice_wx + attitude_twice_yz
    attitude_22 = 1.0 - attitude_twice_xx - attitude_twice_yy
    del s0, attitude_twice_xz, attitude_twice_wy, attitude_twice_yz, attitude_twice_wx
    del attitude_twice_xx, attitude_twice_yy
    attitude_arm_x = antenna_x * attitude_00 + antenna_y * attitude_01 + antenna_z * attitude_02
    attitude_arm_y = antenna_x * attitude_10 + antenna_y * attitude_11 + antenna_z * attitude_12
    attitude_arm_z = antenna_x * attitude_20 + antenna_y * attitude_21 + antenna_z * attitude_22
    value_out_x = attitude_arm_x + position_x
    value_out_y = attitude_arm_y + position_y
    value_out_z = attitude_arm_z + position_z
    attitude_arm_by_attitude_z_y = antenna_z * attitude_20 - antenna_x * attitude_22
    attitude_arm_by_attitude_x_z = antenna_x * attitude_01 - antenna_y * attitude_00
    attitude_arm_by_attitude_y_x = antenna_y * attitude_12 - antenna_z * attitude_11
    attitude_arm_by_attitude_x_x = antenna_y * attitude_02 - antenna_z * attitude_01
    attitude_arm_by_attitude_x_y = antenna_z * attitude_00 - antenna_x * attitude_02
    attitude_arm_by_attitude_y_y = antenna_z * attitude_10 - antenna_x * attitude_12
    attitude_arm_by_attitude_y_z = antenna_x * attitude_11 - antenna_y * attitude_10
    attitude_arm_by_attitude_z_x = antenna_y * attitude_22 - antenna_z * attitude_21
    attitude_arm_by_attitude_z_z = antenna_x * attitude_21 - antenna_y * attitude_20
    return (
        (value_out_x, value_out_y, value_out_z),
        (measured_x - value_out_x, measured_y - value_out_y, measured_z - value_out_z),
        (
            1.0, attitude_arm_by_attitude_x_x, attitude_arm_by_attitude_x_y,
            attitude_arm_by_attitude_x_z, attitude_00, attitude_01, attitude_02, 1.0,
            attitude_arm_by_attitude_y_x, attitude_arm_by_attitude_y_y,
            attitude_arm_by_attitude_y_z, attitude_10, attitude_11, attitude_12, 1.0,
            attitude_arm_by_attitude_z_x, attitude_arm_by_attitude_z_y,
            attitude_arm_by_attitude_z_z, attitude_20, attitude_21, attitude_22,
        ),
    )


gps = _calls.publish(_arrays.ArrayFunction(_interface.GPS, _gps_kernel), __name__)


def _gps_known_antenna_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, lever_arm: Any, measured: Any
) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    attitude_w = x[9]
    attitude_x = x[10]
    attitude_y = x[11]
    attitude_z = x[12]
    lever_arm_x = lever_arm[0]
    lever_arm_y = lever_arm[1]
    lever_arm_z = lever_arm[2]
    measured_x = measured[0]
    measured_y = measured[1]
    measured_z = measured[2]
    attitude_twice_x = 2.0 * attitude_x
    attitude_twice_y = 2.0 * attitude_y
    attitude_twice_z = 2.0 * attitude_z
    attitude_twice_xx = attitude_twice_x * attitude_x
    attitude_twice_yy = attitude_twice_y * attitude_y
    attitude_twice_zz = attitude_twice_z * attitude_z
    attitude_twice_xy = attitude_twice_y * attitude_x
    attitude_twice_xz = attitude_twice_z * attitude_x
    attitude_twice_yz = attitude_twice_z * attitude_y
    attitude_twice_wx = attitude_twice_x * attitude_w
    attitude_twice_wy = attitude_twice_y * attitude_w
    attitude_twice_wz = attitude_twice_z * attitude_w
    s0 = attitude_twice_zz - 1.0
    attitude_00 = -attitude_twice_yy - s0
    attitude_01 = attitude_twice_xy - attitude_twice_wz
    attitude_02 = attitude_twice_wy + attitude_twice_xz
    attitude_10 = attitude_twice_wz + attitude_twice_xy
    del attitude_twice_x, attitude_twice_y, attitude_twice_z, attitude_twice_zz, attitude_twice_xy
    del attitude_twice_wz
    attitude_11 = -attitude_twice_xx - s0
    attitude_12 = attitude_twice_yz - attitude_twice_wx
    attitude_20 = attitude_twice_xz - attitude_twice_wy
    attitude_21 = attitude_twice_wx + attitude_twice_yz
    attitude_22 = 1.0 - attitude_twice_xx - attitude_twice_yy
    del s0, attitude_twice_xz, attitude_twice_wy, attitude_twice_yz, attitude_twice_wx
    del attitude_twice_xx, attitude_twice_yy
    attitude_arm_x = (
        attitude_00 * lever_arm_x + attitude_01 * lever_arm_y + attitude_02 * lever_arm_z
    )
    attitude_arm_y = (
        attitude_10 * lever_arm_x + attitude_11 * lever_arm_y + attitude_12 * lever_arm_z
    )
    attitude_arm_z = (
        attitude_20 * lever_arm_x + attitude_21 * lever_arm_y + attitude_22 * lever_arm_z
    )
    value_out_x = attitude_arm_x + position_x
    value_out_y = attitude_arm_y + position_y
    value_out_z = attitude_arm_z + position_z
    attitude_arm_by_attitude_z_y = attitude_20 * lever_arm_z - attitude_22 * lever_arm_x
    attitude_arm_by_attitude_x_z = attitude_01 * lever_arm_x - attitude_00 * lever_arm_y
    attitude_arm_by_attitude_y_x = attitude_12 * lever_arm_y - attitude_11 * lever_arm_z
    attitude_arm_by_attitude_x_x = attitude_02 * lever_arm_y - attitude_01 * lever_arm_z
    attitude_arm_by_attitude_x_y = attitude_00 * lever_arm_z - attitude_02 * lever_arm_x
    del attitude_arm_x, attitude_arm_y, attitude_arm_z, attitude_01, attitude_00, attitude_02
    attitude_arm_by_attitude_y_y = attitude_10 * lever_arm_z - attitude_12 * lever_arm_x
    attitude_arm_by_attitude_y_z = attitude_11 * lever_arm_x - attitude_10 * lever_arm_y
    attitude_arm_by_attitude_z_x = attitude_22 * lever_arm_y - attitude_21 * lever_arm_z
    attitude_arm_by_attitude_z_z = attitude_21 * lever_arm_x - attitude_20 * lever_arm_y
    del attitude_12, attitude_10, attitude_11, attitude_22, attitude_20, attitude_21
    return (
        (value_out_x, value_out_y, value_out_z),
        (measured_x - value_out_x, measured_y - value_out_y, measured_z - value_out_z),
        (
            1.0, attitude_arm_by_attitude_x_x, attitude_arm_by_attitude_x_y,
            attitude_arm_by_attitude_x_z, 1.0, attitude_arm_by_attitude_y_x,
            attitude_arm_by_attitude_y_y, attitude_arm_by_attitude_y_z, 1.0,
            attitude_arm_by_attitude_z_x, attitude_arm_by_attitude_z_y,
            attitude_arm_by_attitude_z_z,
        ),
    )


gps_known_antenna = _calls.publish(
    _arrays.ArrayFunction(_interface.GPS_KNOWN_ANTENNA, _gps_known_antenna_kernel), __name__
)


def _local_fix_kernel(
    xp: Any, guards: _arrays.Guards, heading: Any, fix: Any, reference: Any, covariance: Any
) -> _arrays.Nonzeros:
    fix_latitude = fix[0]
    fix_longitude = fix[1]
    fix_height = fix[2]
    reference_latitude = reference[0]
    reference_longitude = reference[1]
    reference_height = reference[2]
    covariance_0 = covariance[0]
    covariance_1 = covariance[1]
    covariance_2 = covariance[2]
    covariance_3 = covariance[3]
    covariance_4 = covariance[4]
    covariance_5 = covariance[5]
    covariance_6 = covariance[6]
    covariance_7 = covariance[7]
    covariance_8 = covariance[8]
    heading_cosine = xp.cos(heading)
    heading_sine = xp.sin(heading)
    s0 = 0.5 * fix_latitude
    s1 = 0.5 * reference_latitude
    half_latitude_change = s0 - s1
    half_longitude_change = 0.5 * fix_longitude - 0.5 * reference_longitude
    mean_latitude = s0 + s1
    c_mean = xp.cos(mean_latitude)
    cos_reference = xp.cos(reference_latitude)
    cos_latitude = xp.cos(fix_latitude)
    sin_latitude = xp.sin(fix_latitude)
    w_deficit = 0.006694379990141317 * (sin_latitude * sin_latitude)
    w_squared = 1.0 - w_deficit
    s2 = xp.sqrt(w_squared)
    w = s2
    sin_reference = xp.sin(reference_latitude)
    w_reference_deficit = 0.006694379990141317 * (sin_reference * sin_reference)
    w_reference_squared = 1.0 - w_reference_deficit
    w_reference = xp.sqrt(w_reference_squared)
    del s0, s1, w_deficit, w_squared, w_reference_deficit, w_reference_squared
    inverse_w = 1.0 / w
    normal = 6378137.0 * inverse_w
    c_half = xp.cos(half_latitude_change)
    s5 = w + w_reference
    s6 = w * w_reference
    w_product = s5 * s6
    inverse_w_product = 1.0 / w_product
    s_half = xp.sin(half_latitude_change)
    s_mean = xp.sin(mean_latitude)
    s3 = s_half * s_mean
    s4 = c_mean * s3
    sine_product = c_half * s4
    s7 = 170790.69082871987 * sine_product
    normal_change = inverse_w_product * s7
    height_change = fix_height - reference_height
    s8 = fix_height + normal
    axis_distance = cos_latitude * s8
    s9 = 2.0 * s_half
    s10 = s9 * s_mean
    outward = cos_reference * (height_change + normal_change) - s10 * s8
    c_half_lon = xp.cos(half_longitude_change)
    s_half_lon = xp.sin(half_longitude_change)
    s11 = s_half_lon * s_half_lon
    sagitta = axis_distance * s11
    inward = outward - 2.0 * sagitta
    del inverse_w, half_latitude_change, mean_latitude, sine_product, half_longitude_change
    del outward, sagitta
    polar_normal = fix_height + 0.9933056200098587 * normal
    s12 = polar_normal * s9
    rise = c_mean * s12 + sin_reference * (height_change + 0.9933056200098587 * normal_change)
    north = cos_reference * rise - inward * sin_reference
    s13 = 2.0 * s_half_lon
    s14 = axis_distance * s13
    east = c_half_lon * s14
    up = cos_reference * inward + rise * sin_reference
    level_position_x = east
    del normal, normal_change, height_change, inward, rise, east
    level_position_y = north
    level_position_z = up
    local_x = heading_cosine * level_position_x - heading_sine * level_position_y
    local_y = heading_cosine * level_position_y + heading_sine * level_position_x
    local_z = level_position_z
    rise_by_c_mean = s12
    del north, up, level_position_x, level_position_y, level_position_z, s12
    rise_by_normal_change = 0.9933056200098587 * sin_reference
    rise_by_polar_normal = c_mean * s9
    rise_by_s_half = 2.0 * c_mean * polar_normal
    inverse_w_by_w = -(1.0 / (w * w))
    w_by_w_squared = 0.5 / s2
    w_deficit_by_sin_latitude = 0.013388759980282635 * sin_latitude
    normal_change_by_inverse_w_product = s7
    normal_change_by_sine_product = 170790.69082871987 * inverse_w_product
    inverse_w_product_by_w_product = -(1.0 / (w_product * w_product))
    del polar_normal, w, s2, s7, inverse_w_product, w_product
    w_product_by_w = s6 + s5 * w_reference
    axis_distance_by_cos_latitude = s8
    outward_by_fix_z = -s10
    outward_by_s_half = -2.0 * s8 * s_mean
    outward_by_s_mean = -(s8 * s9)
    del w_reference, s5, s6, s10, s8, s9
    east_by_axis_distance = c_half_lon * s13
    east_by_s_half_lon = 2.0 * axis_distance * c_half_lon
    c_half_by_fix_x = -0.5 * s_half
    c_half_lon_by_fix_y = -0.5 * s_half_lon
    c_mean_by_fix_x = -0.5 * s_mean
    s_half_by_fix_x = 0.5 * c_half
    rise_by_fix_x = rise_by_s_half * s_half_by_fix_x
    outward_by_fix_x = outward_by_s_half * s_half_by_fix_x
    s_mean_by_fix_x = 0.5 * c_mean
    outward_by_fix_x_2 = outward_by_fix_x + outward_by_s_mean * s_mean_by_fix_x
    del s13, axis_distance, s_half_lon, rise_by_s_half, outward_by_s_half, outward_by_s_mean
    del outward_by_fix_x
    rise_by_fix_x_2 = rise_by_fix_x + c_mean_by_fix_x * rise_by_c_mean
    w_deficit_by_fix_x = cos_latitude * w_deficit_by_sin_latitude
    axis_distance_by_fix_x = -(axis_distance_by_cos_latitude * sin_latitude)
    w_by_fix_x = -(w_by_w_squared * w_deficit_by_fix_x)
    del rise_by_c_mean, rise_by_fix_x, w_deficit_by_sin_latitude, sin_latitude
    del axis_distance_by_cos_latitude, w_by_w_squared, w_deficit_by_fix_x
    inverse_w_by_fix_x = inverse_w_by_w * w_by_fix_x
    w_product_by_fix_x = w_by_fix_x * w_product_by_w
    normal_by_fix_x = 6378137.0 * inverse_w_by_fix_x
    polar_normal_by_fix_x = 0.9933056200098587 * normal_by_fix_x
    axis_distance_by_fix_x_2 = axis_distance_by_fix_x + cos_latitude * normal_by_fix_x
    outward_by_fix_x_3 = outward_by_fix_x_2 + normal_by_fix_x * outward_by_fix_z
    del inverse_w_by_w, w_product_by_w, w_by_fix_x, inverse_w_by_fix_x, axis_distance_by_fix_x
    del outward_by_fix_x_2, normal_by_fix_x
    sine_product_by_c_half = s4
    sine_product_by_c_mean = c_half * s3
    s15 = c_half * c_mean
    sine_product_by_s_half = s15 * s_mean
    sine_product_by_fix_x = s_half_by_fix_x * sine_product_by_s_half
    del s4, s3, c_mean, c_half, s_mean, s_half_by_fix_x, sine_product_by_s_half
    sine_product_by_s_mean = s15 * s_half
    sine_product_by_fix_x_2 = sine_product_by_fix_x + s_mean_by_fix_x * sine_product_by_s_mean
    sine_product_by_fix_x_3 = sine_product_by_fix_x_2 + c_mean_by_fix_x * sine_product_by_c_mean
    del s_half, s15, s_mean_by_fix_x, sine_product_by_fix_x, sine_product_by_s_mean
    del c_mean_by_fix_x, sine_product_by_c_mean, sine_product_by_fix_x_2
    sine_product_by_fix_x_4 = sine_product_by_fix_x_3 + c_half_by_fix_x * sine_product_by_c_half
    normal_change_by_fix_x = normal_change_by_sine_product * sine_product_by_fix_x_4
    inverse_w_product_by_fix_x = inverse_w_product_by_w_product * w_product_by_fix_x
    del c_half_by_fix_x, sine_product_by_c_half, sine_product_by_fix_x_3
    del normal_change_by_sine_product, sine_product_by_fix_x_4, inverse_w_product_by_w_product
    del w_product_by_fix_x
    normal_change_by_fix_x_2 = (
        normal_change_by_fix_x + inverse_w_product_by_fix_x * normal_change_by_inverse_w_product
    )
    rise_by_fix_x_3 = rise_by_fix_x_2 + normal_change_by_fix_x_2 * rise_by_normal_change
    outward_by_fix_x_4 = outward_by_fix_x_3 + cos_reference * normal_change_by_fix_x_2
    del normal_change_by_inverse_w_product, normal_change_by_fix_x, inverse_w_product_by_fix_x
    del rise_by_normal_change, rise_by_fix_x_2, outward_by_fix_x_3, normal_change_by_fix_x_2
    outward_by_fix_z_2 = cos_reference + outward_by_fix_z
    east_by_fix_x = axis_distance_by_fix_x_2 * east_by_axis_distance
    east_by_fix_z = cos_latitude * east_by_axis_distance
    s_half_lon_by_fix_y = 0.5 * c_half_lon
    east_by_fix_y = east_by_s_half_lon * s_half_lon_by_fix_y
    sagitta_by_s_half_lon = s14
    east_by_fix_y_2 = east_by_fix_y + c_half_lon_by_fix_y * sagitta_by_s_half_lon
    del outward_by_fix_z, east_by_axis_distance, c_half_lon, east_by_s_half_lon, s14
    del c_half_lon_by_fix_y, east_by_fix_y
    sagitta_by_axis_distance = s11
    sagitta_by_fix_x = axis_distance_by_fix_x_2 * sagitta_by_axis_distance
    inward_by_fix_x = outward_by_fix_x_4 - 2.0 * sagitta_by_fix_x
    sagitta_by_fix_y = s_half_lon_by_fix_y * sagitta_by_s_half_lon
    del s11, axis_distance_by_fix_x_2, outward_by_fix_x_4, sagitta_by_fix_x, s_half_lon_by_fix_y
    del sagitta_by_s_half_lon
    inward_by_fix_y = -2.0 * sagitta_by_fix_y
    sagitta_by_fix_z = cos_latitude * sagitta_by_axis_distance
    inward_by_fix_z = outward_by_fix_z_2 - 2.0 * sagitta_by_fix_z
    up_by_fix_x = cos_reference * inward_by_fix_x
    up_by_fix_y = cos_reference * inward_by_fix_y
    up_by_fix_z = cos_reference * inward_by_fix_z
    north_by_fix_x = -(inward_by_fix_x * sin_reference)
    del sagitta_by_fix_y, cos_latitude, sagitta_by_axis_distance, outward_by_fix_z_2
    del sagitta_by_fix_z, inward_by_fix_x
    north_by_fix_y = -(inward_by_fix_y * sin_reference)
    north_by_fix_z = -(inward_by_fix_z * sin_reference)
    rise_by_fix_x_4 = rise_by_fix_x_3 + polar_normal_by_fix_x * rise_by_polar_normal
    rise_by_fix_z = rise_by_polar_normal + sin_reference
    up_by_fix_x_2 = up_by_fix_x + rise_by_fix_x_4 * sin_reference
    del inward_by_fix_y, inward_by_fix_z, polar_normal_by_fix_x, rise_by_fix_x_3
    del rise_by_polar_normal, up_by_fix_x
    up_by_fix_z_2 = up_by_fix_z + rise_by_fix_z * sin_reference
    north_by_fix_x_2 = north_by_fix_x + cos_reference * rise_by_fix_x_4
    north_by_fix_z_2 = north_by_fix_z + cos_reference * rise_by_fix_z
    del sin_reference, up_by_fix_z, north_by_fix_x, rise_by_fix_x_4, cos_reference, north_by_fix_z
    del rise_by_fix_z
    local_by_fix_x_z = east_by_fix_z * heading_cosine - heading_sine * north_by_fix_z_2
    local_by_fix_y_x = east_by_fix_x * heading_sine + heading_cosine * north_by_fix_x_2
    local_by_fix_x_x = east_by_fix_x * heading_cosine - heading_sine * north_by_fix_x_2
    local_by_fix_x_y = east_by_fix_y_2 * heading_cosine - heading_sine * north_by_fix_y
    local_by_fix_y_y = east_by_fix_y_2 * heading_sine + heading_cosine * north_by_fix_y
    local_by_fix_y_z = east_by_fix_z * heading_sine + heading_cosine * north_by_fix_z_2
    del east_by_fix_x, north_by_fix_x_2, east_by_fix_y_2, north_by_fix_y, heading_cosine
    del heading_sine, east_by_fix_z, north_by_fix_z_2
    value_covariance_half_0 = (
        covariance_0 * local_by_fix_x_x + covariance_3 * local_by_fix_x_y
        + covariance_6 * local_by_fix_x_z
    )
    value_covariance_half_1 = (
        covariance_1 * local_by_fix_x_x + covariance_4 * local_by_fix_x_y
        + covariance_7 * local_by_fix_x_z
    )
    value_covariance_half_2 = (
        covariance_2 * local_by_fix_x_x + covariance_5 * local_by_fix_x_y
        + covariance_8 * local_by_fix_x_z
    )
    value_covariance_half_3 = (
        covariance_0 * local_by_fix_y_x + covariance_3 * local_by_fix_y_y
        + covariance_6 * local_by_fix_y_z
    )
    value_covariance_half_4 = (
        covariance_1 * local_by_fix_y_x + covariance_4 * local_by_fix_y_y
        + covariance_7 * local_by_fix_y_z
    )
    value_covariance_half_5 = (
        covariance_2 * local_by_fix_y_x + covariance_5 * local_by_fix_y_y
        + covariance_8 * local_by_fix_y_z
    )
    value_covariance_half_6 = (
        covariance_0 * up_by_fix_x_2 + covariance_3 * up_by_fix_y + covariance_6 * up_by_fix_z_2
    )
    value_covariance_half_7 = (
        covariance_1 * up_by_fix_x_2 + covariance_4 * up_by_fix_y + covariance_7 * up_by_fix_z_2
    )
    value_covariance_half_8 = (
        covariance_2 * up_by_fix_x_2 + covariance_5 * up_by_fix_y + covariance_8 * up_by_fix_z_2
    )
    value_covariance_out_0 = (
        local_by_fix_x_x * value_covariance_half_0 + local_by_fix_x_y * value_covariance_half_1
        + local_by_fix_x_z * value_covariance_half_2
    )
    value_covariance_out_1 = (
        local_by_fix_y_x * value_covariance_half_0 + local_by_fix_y_y * value_covariance_half_1
        + local_by_fix_y_z * value_covariance_half_2
    )
    value_covariance_out_2 = (
        up_by_fix_x_2 * value_covariance_half_0 + up_by_fix_y * value_covariance_half_1
        + up_by_fix_z_2 * value_covariance_half_2
    )
    value_covariance_out_3 = (
        local_by_fix_x_x * value_covariance_half_3 + local_by_fix_x_y * value_covariance_half_4
        + local_by_fix_x_z * value_covariance_half_5
    )
    value_covariance_out_4 = (
        local_by_fix_y_x * value_covariance_half_3 + local_by_fix_y_y * value_covariance_half_4
        + local_by_fix_y_z * value_covariance_half_5
    )
    value_covariance_out_5 = (
        up_by_fix_x_2 * value_covariance_half_3 + up_by_fix_y * value_covariance_half_4
        + up_by_fix_z_2 * value_covariance_half_5
    )
    del value_covariance_half_0, value_covariance_half_1, value_covariance_half_2
    del value_covariance_half_3, value_covariance_half_4, value_covariance_half_5
    value_covariance_out_6 = (
        local_by_fix_x_x * value_covariance_half_6 + local_by_fix_x_y * value_covariance_half_7
        + local_by_fix_x_z * value_covariance_half_8
    )
    value_covariance_out_7 = (
        local_by_fix_y_x * value_covariance_half_6 + local_by_fix_y_y * value_covariance_half_7
        + local_by_fix_y_z * value_covariance_half_8
    )
    value_covariance_out_8 = (
        up_by_fix_x_2 * value_covariance_half_6 + up_by_fix_y * value_covariance_half_7
        + up_by_fix_z_2 * value_covariance_half_8
    )
    return (
        (local_x, local_y, local_z),
        (
            local_by_fix_x_x, local_by_fix_x_y, local_by_fix_x_z, local_by_fix_y_x,
            local_by_fix_y_y, local_by_fix_y_z, up_by_fix_x_2, up_by_fix_y, up_by_fix_z_2,
        ),
        (
            value_covariance_out_0, value_covariance_out_1, value_covariance_out_2,
            value_covariance_out_3, value_covariance_out_4, value_covariance_out_5,
            value_covariance_out_6, value_covariance_out_7, value_covariance_out_8,
        ),
    )


local_fix = _calls.publish(_arrays.ArrayFunction(_interface.LOCAL_FIX, _local_fix_kernel), __name__)
