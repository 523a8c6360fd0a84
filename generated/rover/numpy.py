"""The functions of ``rover`` in pure NumPy: no compiler, no dependency.

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
    velocity_x = x[3]
    velocity_y = x[4]
    velocity_z = x[5]
    attitude_w = x[6]
    attitude_x = x[7]
    attitude_y = x[8]
    attitude_z = x[9]
    accelerometer_bias_x = x[10]
    accelerometer_bias_y = x[11]
    accelerometer_bias_z = x[12]
    gyro_bias_x = x[13]
    gyro_bias_y = x[14]
    gyro_bias_z = x[15]
    antenna_x = x[16]
    antenna_y = x[17]
    antenna_z = x[18]
    b_gps = x[19]
    b_galileo = x[20]
    drift = x[21]
    d_position_x = d[0]
    d_position_y = d[1]
    d_position_z = d[2]
    d_velocity_x = d[3]
    d_velocity_y = d[4]
    d_velocity_z = d[5]
    d_attitude_x = d[6]
    d_attitude_y = d[7]
    d_attitude_z = d[8]
    d_accelerometer_bias_x = d[9]
    d_accelerometer_bias_y = d[10]
    d_accelerometer_bias_z = d[11]
    d_gyro_bias_x = d[12]
    d_gyro_bias_y = d[13]
    d_gyro_bias_z = d[14]
    d_antenna_x = d[15]
    d_antenna_y = d[16]
    d_antenna_z = d[17]
    d_b_gps = d[18]
    d_b_galileo = d[19]
    d_drift = d[20]
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
            attitude_step_w * attitude_w - attitude_step_x * attitude_x
            - attitude_step_y * attitude_y - attitude_step_z * attitude_z,
            attitude_step_w * attitude_x + attitude_step_x * attitude_w
            + attitude_step_z * attitude_y - attitude_step_y * attitude_z,
            attitude_step_w * attitude_y + attitude_step_x * attitude_z
            + attitude_step_y * attitude_w - attitude_step_z * attitude_x,
            attitude_step_w * attitude_z + attitude_step_y * attitude_x
            + attitude_step_z * attitude_w - attitude_step_x * attitude_y,
            accelerometer_bias_x + d_accelerometer_bias_x,
            accelerometer_bias_y + d_accelerometer_bias_y,
            accelerometer_bias_z + d_accelerometer_bias_z,
            d_gyro_bias_x + gyro_bias_x,
            d_gyro_bias_y + gyro_bias_y,
            d_gyro_bias_z + gyro_bias_z,
            antenna_x + d_antenna_x,
            antenna_y + d_antenna_y,
            antenna_z + d_antenna_z,
            b_gps + d_b_gps,
            b_galileo + d_b_galileo,
            d_drift + drift,
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
    attitude_w = x[6]
    attitude_x = x[7]
    attitude_y = x[8]
    attitude_z = x[9]
    accelerometer_bias_x = x[10]
    accelerometer_bias_y = x[11]
    accelerometer_bias_z = x[12]
    gyro_bias_x = x[13]
    gyro_bias_y = x[14]
    gyro_bias_z = x[15]
    antenna_x = x[16]
    antenna_y = x[17]
    antenna_z = x[18]
    b_gps = x[19]
    b_galileo = x[20]
    drift = x[21]
    y_position_x = y[0]
    y_position_y = y[1]
    y_position_z = y[2]
    y_velocity_x = y[3]
    y_velocity_y = y[4]
    y_velocity_z = y[5]
    y_attitude_w = y[6]
    y_attitude_x = y[7]
    y_attitude_y = y[8]
    y_attitude_z = y[9]
    y_accelerometer_bias_x = y[10]
    y_accelerometer_bias_y = y[11]
    y_accelerometer_bias_z = y[12]
    y_gyro_bias_x = y[13]
    y_gyro_bias_y = y[14]
    y_gyro_bias_z = y[15]
    y_antenna_x = y[16]
    y_antenna_y = y[17]
    y_antenna_z = y[18]
    y_b_gps = y[19]
    y_b_galileo = y[20]
    y_drift = y[21]
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
            attitude_log_of_x * attitude_log_signed_scale,
            attitude_log_of_y * attitude_log_signed_scale,
            attitude_log_of_z * attitude_log_signed_scale,
            y_accelerometer_bias_x - accelerometer_bias_x,
            y_accelerometer_bias_y - accelerometer_bias_y,
            y_accelerometer_bias_z - accelerometer_bias_z,
            y_gyro_bias_x - gyro_bias_x,
            y_gyro_bias_y - gyro_bias_y,
            y_gyro_bias_z - gyro_bias_z,
            y_antenna_x - antenna_x,
            y_antenna_y - antenna_y,
            y_antenna_z - antenna_z,
            y_b_gps - b_gps,
            y_b_galileo - b_galileo,
            y_drift - drift,
        ),
    )


local = _calls.publish(_arrays.ArrayFunction(_interface.LOCAL, _local_kernel), __name__)


def _gps_kernel(xp: Any, guards: _arrays.Guards, x: Any) -> _arrays.Nonzeros:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    attitude_w = x[6]
    attitude_x = x[7]
    attitude_y = x[8]
    attitude_z = x[9]
    antenna_x = x[16]
    antenna_y = x[17]
    antenna_z = x[18]
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


def _range_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, nav_to_ecef: Any, origin: Any
) -> _arrays.Mapped:
    position_x = x[0]
    position_y = x[1]
    position_z = x[2]
    attitude_w = x[6]
    attitude_x = x[7]
    attitude_y = x[8]
    attitude_z = x[9]
    antenna_x = x[16]
    antenna_y = x[17]
    antenna_z = x[18]
    b_gps = x[19]
    b_galileo = x[20]
    nav_to_ecef_w = nav_to_ecef[0]
    nav_to_ecef_x = nav_to_ecef[1]
    nav_to_ecef_y = nav_to_ecef[2]
    nav_to_ecef_z = nav_to_ecef[3]
    origin_x = origin[0]
    origin_y = origin[1]
    origin_z = origin[2]
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
    nav_to_ecef_twice_x = 2.0 * nav_to_ecef_x
    nav_to_ecef_twice_y = 2.0 * nav_to_ecef_y
    nav_to_ecef_twice_z = 2.0 * nav_to_ecef_z
    nav_to_ecef_twice_xx = nav_to_ecef_twice_x * nav_to_ecef_x
    nav_to_ecef_twice_yy = nav_to_ecef_twice_y * nav_to_ecef_y
    nav_to_ecef_twice_zz = nav_to_ecef_twice_z * nav_to_ecef_z
    nav_to_ecef_twice_xy = nav_to_ecef_twice_y * nav_to_ecef_x
    nav_to_ecef_twice_xz = nav_to_ecef_twice_z * nav_to_ecef_x
    nav_to_ecef_twice_yz = nav_to_ecef_twice_z * nav_to_ecef_y
    nav_to_ecef_twice_wx = nav_to_ecef_twice_x * nav_to_ecef_w
    nav_to_ecef_twice_wy = nav_to_ecef_twice_y * nav_to_ecef_w
    nav_to_ecef_twice_wz = nav_to_ecef_twice_z * nav_to_ecef_w
    s1 = nav_to_ecef_twice_zz - 1.0
    nav_to_ecef_00 = -nav_to_ecef_twice_yy - s1
    nav_to_ecef_01 = nav_to_ecef_twice_xy - nav_to_ecef_twice_wz
    nav_to_ecef_02 = nav_to_ecef_twice_wy + nav_to_ecef_twice_xz
    nav_to_ecef_10 = nav_to_ecef_twice_wz + nav_to_ecef_twice_xy
    del nav_to_ecef_twice_x, nav_to_ecef_twice_y, nav_to_ecef_twice_z, nav_to_ecef_twice_zz
    del nav_to_ecef_twice_xy, nav_to_ecef_twice_wz
    nav_to_ecef_11 = -nav_to_ecef_twice_xx - s1
    nav_to_ecef_12 = nav_to_ecef_twice_yz - nav_to_ecef_twice_wx
    nav_to_ecef_20 = nav_to_ecef_twice_xz - nav_to_ecef_twice_wy
    nav_to_ecef_21 = nav_to_ecef_twice_wx + nav_to_ecef_twice_yz
    nav_to_ecef_22 = 1.0 - nav_to_ecef_twice_xx - nav_to_ecef_twice_yy
    del s1, nav_to_ecef_twice_xz, nav_to_ecef_twice_wy, nav_to_ecef_twice_yz, nav_to_ecef_twice_wx
    del nav_to_ecef_twice_xx, nav_to_ecef_twice_yy
    attitude_arm_x = antenna_x * attitude_00 + antenna_y * attitude_01 + antenna_z * attitude_02
    attitude_arm_y = antenna_x * attitude_10 + antenna_y * attitude_11 + antenna_z * attitude_12
    attitude_arm_z = antenna_x * attitude_20 + antenna_y * attitude_21 + antenna_z * attitude_22
    antenna_nav_x = attitude_arm_x + position_x
    antenna_nav_y = attitude_arm_y + position_y
    antenna_nav_z = attitude_arm_z + position_z
    antenna_ecef_x = (
        antenna_nav_x * nav_to_ecef_00 + antenna_nav_y * nav_to_ecef_01
        + antenna_nav_z * nav_to_ecef_02
    )
    antenna_ecef_y = (
        antenna_nav_x * nav_to_ecef_10 + antenna_nav_y * nav_to_ecef_11
        + antenna_nav_z * nav_to_ecef_12
    )
    antenna_ecef_z = (
        antenna_nav_x * nav_to_ecef_20 + antenna_nav_y * nav_to_ecef_21
        + antenna_nav_z * nav_to_ecef_22
    )
    del attitude_arm_x, attitude_arm_y, attitude_arm_z, antenna_nav_x, antenna_nav_y, antenna_nav_z
    antenna_x_2 = antenna_ecef_x + origin_x
    antenna_y_2 = antenna_ecef_y + origin_y
    antenna_z_2 = antenna_ecef_z + origin_z

    def item(
        system: Any,
        satellite_position: Any,
        satellite_clock: Any,
        troposphere: Any,
        ionosphere: Any,
        measured: Any,
    ) -> _arrays.Nonzeros:
        satellite_position_x = satellite_position[0]
        satellite_position_y = satellite_position[1]
        satellite_position_z = satellite_position[2]
        is_gps = xp.where(xp.equal(system, 0.0), guards.constant(1.0), 0.0)
        is_galileo = xp.where(xp.equal(system, 1.0), guards.constant(1.0), 0.0)
        clock_bias = b_galileo * is_galileo + b_gps * is_gps
        range_vector_x = antenna_x_2 - satellite_position_x
        range_vector_y = antenna_y_2 - satellite_position_y
        range_vector_z = antenna_z_2 - satellite_position_z
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
        s2 = 1.0 / range
        range_direction_x = range_vector_x * s2
        range_direction_y = range_vector_y * s2
        range_direction_z = range_vector_z * s2
        turned_satellite_0 = 2.4323877909897254e-13 * satellite_position_x
        turned_satellite_1 = 2.4323877909897254e-13 * satellite_position_y
        value_out = (
            clock_bias + ionosphere + range + troposphere + antenna_y_2 * turned_satellite_0
            - 299792458.0 * satellite_clock - antenna_x_2 * turned_satellite_1
        )
        del range_squared, range_vector_x, range_vector_y, range_vector_z, s2, clock_bias, range
        value_by_antenna_2_x = range_direction_x - turned_satellite_1
        value_by_antenna_2_y = range_direction_y + turned_satellite_0
        value_by_antenna_nav_x = (
            nav_to_ecef_00 * value_by_antenna_2_x + nav_to_ecef_10 * value_by_antenna_2_y
            + nav_to_ecef_20 * range_direction_z
        )
        value_by_antenna_nav_y = (
            nav_to_ecef_01 * value_by_antenna_2_x + nav_to_ecef_11 * value_by_antenna_2_y
            + nav_to_ecef_21 * range_direction_z
        )
        value_by_antenna_nav_z = (
            nav_to_ecef_02 * value_by_antenna_2_x + nav_to_ecef_12 * value_by_antenna_2_y
            + nav_to_ecef_22 * range_direction_z
        )
        del range_direction_x, turned_satellite_1, range_direction_y, turned_satellite_0
        del range_direction_z, value_by_antenna_2_x, value_by_antenna_2_y
        value_by_attitude_arm_inner_x = (
            attitude_00 * value_by_antenna_nav_x + attitude_10 * value_by_antenna_nav_y
            + attitude_20 * value_by_antenna_nav_z
        )
        value_by_attitude_arm_inner_y = (
            attitude_01 * value_by_antenna_nav_x + attitude_11 * value_by_antenna_nav_y
            + attitude_21 * value_by_antenna_nav_z
        )
        value_by_attitude_arm_inner_z = (
            attitude_02 * value_by_antenna_nav_x + attitude_12 * value_by_antenna_nav_y
            + attitude_22 * value_by_antenna_nav_z
        )
        value_by_attitude_tangent_x = (
            antenna_y * value_by_attitude_arm_inner_z - antenna_z * value_by_attitude_arm_inner_y
        )
        value_by_attitude_tangent_y = (
            antenna_z * value_by_attitude_arm_inner_x - antenna_x * value_by_attitude_arm_inner_z
        )
        value_by_attitude_tangent_z = (
            antenna_x * value_by_attitude_arm_inner_y - antenna_y * value_by_attitude_arm_inner_x
        )
        return (
            (value_out,),
            (measured - value_out,),
            (
                value_by_antenna_nav_x, value_by_antenna_nav_y, value_by_antenna_nav_z,
                value_by_attitude_tangent_x, value_by_attitude_tangent_y,
                value_by_attitude_tangent_z, value_by_attitude_arm_inner_x,
                value_by_attitude_arm_inner_y, value_by_attitude_arm_inner_z, is_gps, is_galileo,
            ),
        )

    return (), item


range = _calls.publish(_arrays.ArrayFunction(_interface.RANGE, _range_kernel), __name__)


def _imu_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, delta_theta: Any, delta_velocity: Any, dt: Any
) -> _arrays.Nonzeros:
    attitude_w = x[6]
    attitude_x = x[7]
    attitude_y = x[8]
    attitude_z = x[9]
    accelerometer_bias_x = x[10]
    accelerometer_bias_y = x[11]
    accelerometer_bias_z = x[12]
    gyro_bias_x = x[13]
    gyro_bias_y = x[14]
    gyro_bias_z = x[15]
    delta_theta_0 = delta_theta[0]
    delta_theta_1 = delta_theta[1]
    delta_theta_2 = delta_theta[2]
    delta_theta_3 = delta_theta[3]
    delta_theta_4 = delta_theta[4]
    delta_theta_5 = delta_theta[5]
    delta_velocity_0 = delta_velocity[0]
    delta_velocity_1 = delta_velocity[1]
    delta_velocity_2 = delta_velocity[2]
    delta_velocity_3 = delta_velocity[3]
    delta_velocity_4 = delta_velocity[4]
    delta_velocity_5 = delta_velocity[5]
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
    s1 = 0.5 * dt
    delta_theta_dt = s1
    gyro_bias_step_x = delta_theta_dt * gyro_bias_x
    gyro_bias_step_y = delta_theta_dt * gyro_bias_y
    gyro_bias_step_z = delta_theta_dt * gyro_bias_z
    s2 = -gyro_bias_step_x
    a1_x = delta_theta_0 + s2
    s3 = -gyro_bias_step_y
    a1_y = delta_theta_1 + s3
    s4 = -gyro_bias_step_z
    a1_z = delta_theta_2 + s4
    a2_x = delta_theta_3 + s2
    a2_y = delta_theta_4 + s3
    del delta_theta_dt, gyro_bias_step_x, gyro_bias_step_y, gyro_bias_step_z, s2, s3
    a2_z = delta_theta_5 + s4
    delta_velocity_dt = s1
    accelerometer_bias_step_x = accelerometer_bias_x * delta_velocity_dt
    accelerometer_bias_step_y = accelerometer_bias_y * delta_velocity_dt
    accelerometer_bias_step_z = accelerometer_bias_z * delta_velocity_dt
    v1_x = delta_velocity_0 - accelerometer_bias_step_x
    v1_y = delta_velocity_1 - accelerometer_bias_step_y
    v1_z = delta_velocity_2 - accelerometer_bias_step_z
    v2_x = delta_velocity_3 - accelerometer_bias_step_x
    v2_y = delta_velocity_4 - accelerometer_bias_step_y
    v2_z = delta_velocity_5 - accelerometer_bias_step_z
    del s4, s1, delta_velocity_dt, accelerometer_bias_step_x, accelerometer_bias_step_y
    del accelerometer_bias_step_z
    theta_x = a1_x + a2_x
    theta_y = a1_y + a2_y
    theta_z = a1_z + a2_z
    velocity_x = v1_x + v2_x
    velocity_y = v1_y + v2_y
    velocity_z = v1_z + v2_z
    half_theta_x = 0.5 * theta_x
    half_theta_y = 0.5 * theta_y
    half_theta_z = 0.5 * theta_z
    s5 = 1.0 / dt
    sculling2_angle_y = 0.6666666666666666 * a1_y
    sculling2_angle_z = 0.6666666666666666 * a1_z
    sculling2_velocity_y = 0.6666666666666666 * v1_y
    del theta_x, theta_y, theta_z, a1_y, a1_z, v1_y
    sculling2_velocity_z = 0.6666666666666666 * v1_z
    force_x = (
        s5 * (velocity_x + a2_z * sculling2_velocity_y + half_theta_y * velocity_z
        + sculling2_angle_y * v2_z - a2_y * sculling2_velocity_z - half_theta_z * velocity_y
        - sculling2_angle_z * v2_y)
    )
    sculling2_angle_x = 0.6666666666666666 * a1_x
    sculling2_velocity_x = 0.6666666666666666 * v1_x
    force_y = (
        s5 * (velocity_y + a2_x * sculling2_velocity_z + half_theta_z * velocity_x
        + sculling2_angle_z * v2_x - a2_z * sculling2_velocity_x - half_theta_x * velocity_z
        - sculling2_angle_x * v2_z)
    )
    force_z = (
        s5 * (velocity_z + a2_y * sculling2_velocity_x + half_theta_x * velocity_y
        + sculling2_angle_x * v2_y - a2_x * sculling2_velocity_y - half_theta_y * velocity_x
        - sculling2_angle_y * v2_x)
    )
    corrected_x = force_x
    corrected_y = force_y
    del v1_z, a1_x, v1_x, s5, force_x, force_y
    corrected_z = force_z
    resolved_x = attitude_00 * corrected_x + attitude_01 * corrected_y + attitude_02 * corrected_z
    resolved_y = attitude_10 * corrected_x + attitude_11 * corrected_y + attitude_12 * corrected_z
    resolved_z = attitude_20 * corrected_x + attitude_21 * corrected_y + attitude_22 * corrected_z
    force_by_accelerometer_bias_z_y = -half_theta_x - 0.5 * sculling2_angle_x
    force_by_accelerometer_bias_x_z = -half_theta_y - 0.5 * sculling2_angle_y
    force_by_accelerometer_bias_y_x = -half_theta_z - 0.5 * sculling2_angle_z
    del force_z, half_theta_x, sculling2_angle_x, half_theta_y, sculling2_angle_y, half_theta_z
    del sculling2_angle_z
    force_by_gyro_bias_z_y = 0.3333333333333333 * v2_x - 0.5 * sculling2_velocity_x
    force_by_gyro_bias_x_z = 0.3333333333333333 * v2_y - 0.5 * sculling2_velocity_y
    force_by_gyro_bias_y_x = 0.3333333333333333 * v2_z - 0.5 * sculling2_velocity_z
    del v2_x, sculling2_velocity_x, v2_y, sculling2_velocity_y, v2_z, sculling2_velocity_z
    force_by_accelerometer_bias_z_y_2 = force_by_accelerometer_bias_z_y + 0.3333333333333333 * a2_x
    force_by_accelerometer_bias_x_z_2 = force_by_accelerometer_bias_x_z + 0.3333333333333333 * a2_y
    force_by_accelerometer_bias_y_x_2 = force_by_accelerometer_bias_y_x + 0.3333333333333333 * a2_z
    del a2_x, force_by_accelerometer_bias_z_y, a2_y, force_by_accelerometer_bias_x_z, a2_z
    del force_by_accelerometer_bias_y_x
    force_by_gyro_bias_z_y_2 = force_by_gyro_bias_z_y + 0.5 * velocity_x
    force_by_gyro_bias_x_z_2 = force_by_gyro_bias_x_z + 0.5 * velocity_y
    force_by_gyro_bias_y_x_2 = force_by_gyro_bias_y_x + 0.5 * velocity_z
    del velocity_x, force_by_gyro_bias_z_y, velocity_y, force_by_gyro_bias_x_z, velocity_z
    del force_by_gyro_bias_y_x
    resolved_by_attitude_z_y = attitude_20 * corrected_z - attitude_22 * corrected_x
    resolved_by_attitude_x_z = attitude_01 * corrected_x - attitude_00 * corrected_y
    resolved_by_attitude_y_x = attitude_12 * corrected_y - attitude_11 * corrected_z
    resolved_by_attitude_x_x = attitude_02 * corrected_y - attitude_01 * corrected_z
    resolved_by_attitude_x_y = attitude_00 * corrected_z - attitude_02 * corrected_x
    resolved_by_attitude_y_y = attitude_10 * corrected_z - attitude_12 * corrected_x
    resolved_by_attitude_y_z = attitude_11 * corrected_x - attitude_10 * corrected_y
    resolved_by_attitude_z_x = attitude_22 * corrected_y - attitude_21 * corrected_z
    resolved_by_attitude_z_z = attitude_21 * corrected_x - attitude_20 * corrected_y
    resolved_by_gyro_bias_z_y = (
        attitude_22 * force_by_gyro_bias_z_y_2 - attitude_20 * force_by_gyro_bias_y_x_2
    )
    resolved_by_gyro_bias_x_z = (
        attitude_00 * force_by_gyro_bias_x_z_2 - attitude_01 * force_by_gyro_bias_z_y_2
    )
    resolved_by_gyro_bias_y_x = (
        attitude_11 * force_by_gyro_bias_y_x_2 - attitude_12 * force_by_gyro_bias_x_z_2
    )
    resolved_by_gyro_bias_x_x = (
        attitude_01 * force_by_gyro_bias_y_x_2 - attitude_02 * force_by_gyro_bias_x_z_2
    )
    resolved_by_gyro_bias_x_y = (
        attitude_02 * force_by_gyro_bias_z_y_2 - attitude_00 * force_by_gyro_bias_y_x_2
    )
    resolved_by_gyro_bias_y_y = (
        attitude_12 * force_by_gyro_bias_z_y_2 - attitude_10 * force_by_gyro_bias_y_x_2
    )
    resolved_by_gyro_bias_y_z = (
        attitude_10 * force_by_gyro_bias_x_z_2 - attitude_11 * force_by_gyro_bias_z_y_2
    )
    resolved_by_gyro_bias_z_x = (
        attitude_21 * force_by_gyro_bias_y_x_2 - attitude_22 * force_by_gyro_bias_x_z_2
    )
    resolved_by_gyro_bias_z_z = (
        attitude_20 * force_by_gyro_bias_x_z_2 - attitude_21 * force_by_gyro_bias_z_y_2
    )
    del corrected_z, corrected_x, corrected_y, force_by_gyro_bias_y_x_2, force_by_gyro_bias_z_y_2
    del force_by_gyro_bias_x_z_2
    resolved_by_accelerometer_bias_z_y = (
        attitude_22 * force_by_accelerometer_bias_z_y_2 - attitude_21
        - attitude_20 * force_by_accelerometer_bias_y_x_2
    )
    resolved_by_accelerometer_bias_x_z = (
        attitude_00 * force_by_accelerometer_bias_x_z_2 - attitude_02
        - attitude_01 * force_by_accelerometer_bias_z_y_2
    )
    resolved_by_accelerometer_bias_y_x = (
        attitude_11 * force_by_accelerometer_bias_y_x_2 - attitude_10
        - attitude_12 * force_by_accelerometer_bias_x_z_2
    )
    resolved_by_accelerometer_bias_x_x = (
        attitude_01 * force_by_accelerometer_bias_y_x_2 - attitude_00
        - attitude_02 * force_by_accelerometer_bias_x_z_2
    )
    resolved_by_accelerometer_bias_x_y = (
        attitude_02 * force_by_accelerometer_bias_z_y_2 - attitude_01
        - attitude_00 * force_by_accelerometer_bias_y_x_2
    )
    resolved_by_accelerometer_bias_y_y = (
        attitude_12 * force_by_accelerometer_bias_z_y_2 - attitude_11
        - attitude_10 * force_by_accelerometer_bias_y_x_2
    )
    resolved_by_accelerometer_bias_y_z = (
        attitude_10 * force_by_accelerometer_bias_x_z_2 - attitude_12
        - attitude_11 * force_by_accelerometer_bias_z_y_2
    )
    del attitude_00, attitude_01, attitude_02, attitude_10, attitude_11, attitude_12
    resolved_by_accelerometer_bias_z_x = (
        attitude_21 * force_by_accelerometer_bias_y_x_2 - attitude_20
        - attitude_22 * force_by_accelerometer_bias_x_z_2
    )
    resolved_by_accelerometer_bias_z_z = (
        attitude_20 * force_by_accelerometer_bias_x_z_2 - attitude_22
        - attitude_21 * force_by_accelerometer_bias_z_y_2
    )
    del force_by_accelerometer_bias_y_x_2, attitude_20, attitude_21, attitude_22
    del force_by_accelerometer_bias_z_y_2, force_by_accelerometer_bias_x_z_2
    return (
        (resolved_x, resolved_y, resolved_z),
        (
            resolved_by_attitude_x_x, resolved_by_attitude_x_y, resolved_by_attitude_x_z,
            resolved_by_accelerometer_bias_x_x, resolved_by_accelerometer_bias_x_y,
            resolved_by_accelerometer_bias_x_z, resolved_by_gyro_bias_x_x,
            resolved_by_gyro_bias_x_y, resolved_by_gyro_bias_x_z, resolved_by_attitude_y_x,
            resolved_by_attitude_y_y, resolved_by_attitude_y_z, resolved_by_accelerometer_bias_y_x,
            resolved_by_accelerometer_bias_y_y, resolved_by_accelerometer_bias_y_z,
            resolved_by_gyro_bias_y_x, resolved_by_gyro_bias_y_y, resolved_by_gyro_bias_y_z,
            resolved_by_attitude_z_x, resolved_by_attitude_z_y, resolved_by_attitude_z_z,
            resolved_by_accelerometer_bias_z_x, resolved_by_accelerometer_bias_z_y,
            resolved_by_accelerometer_bias_z_z, resolved_by_gyro_bias_z_x,
            resolved_by_gyro_bias_z_y, resolved_by_gyro_bias_z_z,
        ),
    )


imu = _calls.publish(_arrays.ArrayFunction(_interface.IMU, _imu_kernel), __name__)
