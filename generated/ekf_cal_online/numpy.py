"""The functions of ``ekf_cal_online`` in pure NumPy: no compiler, no dependency.

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
    heading = x[19]
    antenna_1_x = x[20]
    antenna_1_y = x[21]
    antenna_1_z = x[22]
    antenna_2_x = x[23]
    antenna_2_y = x[24]
    antenna_2_z = x[25]
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
    d_heading = d[18]
    d_antenna_1_x = d[19]
    d_antenna_1_y = d[20]
    d_antenna_1_z = d[21]
    d_antenna_2_x = d[22]
    d_antenna_2_y = d[23]
    d_antenna_2_z = d[24]
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
    heading_moved = d_heading + heading
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
            heading_moved + 6.283185307179586 * xp.floor(0.5 - 0.15915494309189535 * heading_moved),
            antenna_1_x + d_antenna_1_x,
            antenna_1_y + d_antenna_1_y,
            antenna_1_z + d_antenna_1_z,
            antenna_2_x + d_antenna_2_x,
            antenna_2_y + d_antenna_2_y,
            antenna_2_z + d_antenna_2_z,
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
    heading = x[19]
    antenna_1_x = x[20]
    antenna_1_y = x[21]
    antenna_1_z = x[22]
    antenna_2_x = x[23]
    antenna_2_y = x[24]
    antenna_2_z = x[25]
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
    y_heading = y[19]
    y_antenna_1_x = y[20]
    y_antenna_1_y = y[21]
    y_antenna_1_z = y[22]
    y_antenna_2_x = y[23]
    y_antenna_2_y = y[24]
    y_antenna_2_z = y[25]
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
    heading_difference = y_heading - heading
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
            heading_difference + 6.283185307179586 * xp.floor(0.5
            - 0.15915494309189535 * heading_difference),
            y_antenna_1_x - antenna_1_x,
            y_antenna_1_y - antenna_1_y,
            y_antenna_1_z - antenna_1_z,
            y_antenna_2_x - antenna_2_x,
            y_antenna_2_y - antenna_2_y,
            y_antenna_2_z - antenna_2_z,
        ),
    )


local = _calls.publish(_arrays.ArrayFunction(_interface.LOCAL, _local_kernel), __name__)


def _gps_1_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, origin: Any, measured: Any
) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    attitude_w = x[9]
    attitude_x = x[10]
    attitude_y = x[11]
    attitude_z = x[12]
    heading = x[19]
    antenna_1_x = x[20]
    antenna_1_y = x[21]
    antenna_1_z = x[22]
    origin_x = origin[0]
    origin_y = origin[1]
    origin_z = origin[2]
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
    heading_cosine = xp.cos(heading)
    heading_sine = xp.sin(heading)
    attitude_arm_x = (
        antenna_1_x * attitude_00 + antenna_1_y * attitude_01 + antenna_1_z * attitude_02
    )
    attitude_arm_y = (
        antenna_1_x * attitude_10 + antenna_1_y * attitude_11 + antenna_1_z * attitude_12
    )
    attitude_arm_z = (
        antenna_1_x * attitude_20 + antenna_1_y * attitude_21 + antenna_1_z * attitude_22
    )
    antenna_x = attitude_arm_x + position_x
    antenna_y = attitude_arm_y + position_y
    antenna_z = attitude_arm_z + position_z
    observed_x = antenna_x * heading_cosine + antenna_y * heading_sine
    observed_y = antenna_y * heading_cosine - antenna_x * heading_sine
    observed_z = antenna_z
    del attitude_arm_x, attitude_arm_y, attitude_arm_z, antenna_x, antenna_y, antenna_z
    value_out_x = observed_x + origin_x
    value_out_y = observed_y + origin_y
    value_out_z = observed_z + origin_z
    value_by_attitude_arm_inner_x_z = attitude_02 * heading_cosine + attitude_12 * heading_sine
    value_by_attitude_arm_inner_y_x = attitude_10 * heading_cosine - attitude_00 * heading_sine
    value_by_attitude_arm_inner_x_x = attitude_00 * heading_cosine + attitude_10 * heading_sine
    value_by_attitude_arm_inner_x_y = attitude_01 * heading_cosine + attitude_11 * heading_sine
    value_by_attitude_arm_inner_y_y = attitude_11 * heading_cosine - attitude_01 * heading_sine
    value_by_attitude_arm_inner_y_z = attitude_12 * heading_cosine - attitude_02 * heading_sine
    del observed_z, attitude_00, attitude_10, attitude_01, attitude_11, attitude_02, attitude_12
    value_by_attitude_tangent_z_y = antenna_1_z * attitude_20 - antenna_1_x * attitude_22
    value_by_attitude_tangent_x_z = (
        antenna_1_x * value_by_attitude_arm_inner_x_y
        - antenna_1_y * value_by_attitude_arm_inner_x_x
    )
    value_by_attitude_tangent_y_x = (
        antenna_1_y * value_by_attitude_arm_inner_y_z
        - antenna_1_z * value_by_attitude_arm_inner_y_y
    )
    value_by_attitude_tangent_x_x = (
        antenna_1_y * value_by_attitude_arm_inner_x_z
        - antenna_1_z * value_by_attitude_arm_inner_x_y
    )
    value_by_attitude_tangent_x_y = (
        antenna_1_z * value_by_attitude_arm_inner_x_x
        - antenna_1_x * value_by_attitude_arm_inner_x_z
    )
    value_by_attitude_tangent_y_y = (
        antenna_1_z * value_by_attitude_arm_inner_y_x
        - antenna_1_x * value_by_attitude_arm_inner_y_z
    )
    value_by_attitude_tangent_y_z = (
        antenna_1_x * value_by_attitude_arm_inner_y_y
        - antenna_1_y * value_by_attitude_arm_inner_y_x
    )
    value_by_attitude_tangent_z_x = antenna_1_y * attitude_22 - antenna_1_z * attitude_21
    value_by_attitude_tangent_z_z = antenna_1_x * attitude_21 - antenna_1_y * attitude_20
    return (
        (value_out_x, value_out_y, value_out_z),
        (measured_x - value_out_x, measured_y - value_out_y, measured_z - value_out_z),
        (
            heading_cosine, heading_sine, value_by_attitude_tangent_x_x,
            value_by_attitude_tangent_x_y, value_by_attitude_tangent_x_z, observed_y,
            value_by_attitude_arm_inner_x_x, value_by_attitude_arm_inner_x_y,
            value_by_attitude_arm_inner_x_z, -heading_sine, heading_cosine,
            value_by_attitude_tangent_y_x, value_by_attitude_tangent_y_y,
            value_by_attitude_tangent_y_z, -observed_x, value_by_attitude_arm_inner_y_x,
            value_by_attitude_arm_inner_y_y, value_by_attitude_arm_inner_y_z, 1.0,
            value_by_attitude_tangent_z_x, value_by_attitude_tangent_z_y,
            value_by_attitude_tangent_z_z, attitude_20, attitude_21, attitude_22,
        ),
        (1.0, 1.0, 1.0),
    )


gps_1 = _calls.publish(_arrays.ArrayFunction(_interface.GPS_1, _gps_1_kernel), __name__)


def _gps_2_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, origin: Any, measured: Any
) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    attitude_w = x[9]
    attitude_x = x[10]
    attitude_y = x[11]
    attitude_z = x[12]
    heading = x[19]
    antenna_2_x = x[23]
    antenna_2_y = x[24]
    antenna_2_z = x[25]
    origin_x = origin[0]
    origin_y = origin[1]
    origin_z = origin[2]
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
    heading_cosine = xp.cos(heading)
    heading_sine = xp.sin(heading)
    attitude_arm_x = (
        antenna_2_x * attitude_00 + antenna_2_y * attitude_01 + antenna_2_z * attitude_02
    )
    attitude_arm_y = (
        antenna_2_x * attitude_10 + antenna_2_y * attitude_11 + antenna_2_z * attitude_12
    )
    attitude_arm_z = (
        antenna_2_x * attitude_20 + antenna_2_y * attitude_21 + antenna_2_z * attitude_22
    )
    antenna_x = attitude_arm_x + position_x
    antenna_y = attitude_arm_y + position_y
    antenna_z = attitude_arm_z + position_z
    observed_x = antenna_x * heading_cosine + antenna_y * heading_sine
    observed_y = antenna_y * heading_cosine - antenna_x * heading_sine
    observed_z = antenna_z
    del attitude_arm_x, attitude_arm_y, attitude_arm_z, antenna_x, antenna_y, antenna_z
    value_out_x = observed_x + origin_x
    value_out_y = observed_y + origin_y
    value_out_z = observed_z + origin_z
    value_by_attitude_arm_inner_x_z = attitude_02 * heading_cosine + attitude_12 * heading_sine
    value_by_attitude_arm_inner_y_x = attitude_10 * heading_cosine - attitude_00 * heading_sine
    value_by_attitude_arm_inner_x_x = attitude_00 * heading_cosine + attitude_10 * heading_sine
    value_by_attitude_arm_inner_x_y = attitude_01 * heading_cosine + attitude_11 * heading_sine
    value_by_attitude_arm_inner_y_y = attitude_11 * heading_cosine - attitude_01 * heading_sine
    value_by_attitude_arm_inner_y_z = attitude_12 * heading_cosine - attitude_02 * heading_sine
    del observed_z, attitude_00, attitude_10, attitude_01, attitude_11, attitude_02, attitude_12
    value_by_attitude_tangent_z_y = antenna_2_z * attitude_20 - antenna_2_x * attitude_22
    value_by_attitude_tangent_x_z = (
        antenna_2_x * value_by_attitude_arm_inner_x_y
        - antenna_2_y * value_by_attitude_arm_inner_x_x
    )
    value_by_attitude_tangent_y_x = (
        antenna_2_y * value_by_attitude_arm_inner_y_z
        - antenna_2_z * value_by_attitude_arm_inner_y_y
    )
    value_by_attitude_tangent_x_x = (
        antenna_2_y * value_by_attitude_arm_inner_x_z
        - antenna_2_z * value_by_attitude_arm_inner_x_y
    )
    value_by_attitude_tangent_x_y = (
        antenna_2_z * value_by_attitude_arm_inner_x_x
        - antenna_2_x * value_by_attitude_arm_inner_x_z
    )
    value_by_attitude_tangent_y_y = (
        antenna_2_z * value_by_attitude_arm_inner_y_x
        - antenna_2_x * value_by_attitude_arm_inner_y_z
    )
    value_by_attitude_tangent_y_z = (
        antenna_2_x * value_by_attitude_arm_inner_y_y
        - antenna_2_y * value_by_attitude_arm_inner_y_x
    )
    value_by_attitude_tangent_z_x = antenna_2_y * attitude_22 - antenna_2_z * attitude_21
    value_by_attitude_tangent_z_z = antenna_2_x * attitude_21 - antenna_2_y * attitude_20
    return (
        (value_out_x, value_out_y, value_out_z),
        (measured_x - value_out_x, measured_y - value_out_y, measured_z - value_out_z),
        (
            heading_cosine, heading_sine, value_by_attitude_tangent_x_x,
            value_by_attitude_tangent_x_y, value_by_attitude_tangent_x_z, observed_y,
            value_by_attitude_arm_inner_x_x, value_by_attitude_arm_inner_x_y,
            value_by_attitude_arm_inner_x_z, -heading_sine, heading_cosine,
            value_by_attitude_tangent_y_x, value_by_attitude_tangent_y_y,
            value_by_attitude_tangent_y_z, -observed_x, value_by_attitude_arm_inner_y_x,
            value_by_attitude_arm_inner_y_y, value_by_attitude_arm_inner_y_z, 1.0,
            value_by_attitude_tangent_z_x, value_by_attitude_tangent_z_y,
            value_by_attitude_tangent_z_z, attitude_20, attitude_21, attitude_22,
        ),
        (1.0, 1.0, 1.0),
    )


gps_2 = _calls.publish(_arrays.ArrayFunction(_interface.GPS_2, _gps_2_kernel), __name__)
