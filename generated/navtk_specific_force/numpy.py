"""The functions of ``navtk_specific_force`` in pure NumPy: no compiler, no dependency.

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
    attitude_step_x = -(attitude_exp_sinc * d_attitude_x)
    attitude_step_y = -(attitude_exp_sinc * d_attitude_y)
    attitude_step_z = -(attitude_exp_sinc * d_attitude_z)
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
            + attitude_step_y * attitude_z - attitude_step_z * attitude_y,
            attitude_step_w * attitude_y + attitude_step_y * attitude_w
            + attitude_step_z * attitude_x - attitude_step_x * attitude_z,
            attitude_step_w * attitude_z + attitude_step_x * attitude_y
            + attitude_step_z * attitude_w - attitude_step_y * attitude_x,
            accelerometer_bias_x + d_accelerometer_bias_x,
            accelerometer_bias_y + d_accelerometer_bias_y,
            accelerometer_bias_z + d_accelerometer_bias_z,
            d_gyro_bias_x + gyro_bias_x,
            d_gyro_bias_y + gyro_bias_y,
            d_gyro_bias_z + gyro_bias_z,
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
    attitude_log_of_w = (
        attitude_w * y_attitude_w + attitude_x * y_attitude_x + attitude_y * y_attitude_y
        + attitude_z * y_attitude_z
    )
    attitude_log_of_x = (
        attitude_w * y_attitude_x + attitude_y * y_attitude_z - attitude_x * y_attitude_w
        - attitude_z * y_attitude_y
    )
    attitude_log_of_y = (
        attitude_w * y_attitude_y + attitude_z * y_attitude_x - attitude_x * y_attitude_z
        - attitude_y * y_attitude_w
    )
    attitude_log_of_z = (
        attitude_w * y_attitude_z + attitude_x * y_attitude_y - attitude_y * y_attitude_x
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
            -(attitude_log_of_x * attitude_log_signed_scale),
            -(attitude_log_of_y * attitude_log_signed_scale),
            -(attitude_log_of_z * attitude_log_signed_scale),
            y_accelerometer_bias_x - accelerometer_bias_x,
            y_accelerometer_bias_y - accelerometer_bias_y,
            y_accelerometer_bias_z - accelerometer_bias_z,
            y_gyro_bias_x - gyro_bias_x,
            y_gyro_bias_y - gyro_bias_y,
            y_gyro_bias_z - gyro_bias_z,
        ),
    )


local = _calls.publish(_arrays.ArrayFunction(_interface.LOCAL, _local_kernel), __name__)


def _calc_force_kernel(
    xp: Any, guards: _arrays.Guards, dcm: Any, delta_theta: Any, delta_velocity: Any, dt: Any
) -> _arrays.Nonzeros:
    dcm_00 = dcm[0]
    dcm_01 = dcm[1]
    dcm_02 = dcm[2]
    dcm_10 = dcm[3]
    dcm_11 = dcm[4]
    dcm_12 = dcm[5]
    dcm_20 = dcm[6]
    dcm_21 = dcm[7]
    dcm_22 = dcm[8]
    delta_theta_x = delta_theta[0]
    delta_theta_y = delta_theta[1]
    delta_theta_z = delta_theta[2]
    delta_velocity_x = delta_velocity[0]
    delta_velocity_y = delta_velocity[1]
    delta_velocity_z = delta_velocity[2]
    half_theta_x = 0.5 * delta_theta_x
    half_theta_y = 0.5 * delta_theta_y
    half_theta_z = 0.5 * delta_theta_z
    s0 = 1.0 / dt
    s1 = delta_velocity_x + delta_velocity_z * half_theta_y - delta_velocity_y * half_theta_z
    force_x = s0 * s1
    s2 = delta_velocity_y + delta_velocity_x * half_theta_z - delta_velocity_z * half_theta_x
    force_y = s0 * s2
    s3 = delta_velocity_z + delta_velocity_y * half_theta_x - delta_velocity_x * half_theta_y
    force_z = s0 * s3
    corrected_x = force_x
    corrected_y = force_y
    corrected_z = force_z
    resolved_x = corrected_x * dcm_00 + corrected_y * dcm_01 + corrected_z * dcm_02
    resolved_y = corrected_x * dcm_10 + corrected_y * dcm_11 + corrected_z * dcm_12
    resolved_z = corrected_x * dcm_20 + corrected_y * dcm_21 + corrected_z * dcm_22
    del force_x, force_y, force_z, corrected_x, corrected_y, corrected_z
    s4 = 1.0 / (dt * dt)
    force_by_dt_x = -(s1 * s4)
    force_by_dt_y = -(s2 * s4)
    force_by_dt_z = -(s3 * s4)
    s5 = dcm_21 * s0
    s6 = dcm_22 * s0
    s7 = dcm_20 * s0
    value_by_delta_velocity_z_y = s5 + half_theta_x * s6 - half_theta_z * s7
    s10 = dcm_01 * s0
    s8 = dcm_02 * s0
    s9 = dcm_00 * s0
    value_by_delta_velocity_x_z = s8 + half_theta_y * s9 - half_theta_x * s10
    s11 = dcm_10 * s0
    s12 = dcm_11 * s0
    s13 = dcm_12 * s0
    value_by_delta_velocity_y_x = s11 + half_theta_z * s12 - half_theta_y * s13
    value_by_delta_velocity_x_x = s9 + half_theta_z * s10 - half_theta_y * s8
    value_by_delta_velocity_x_y = s10 + half_theta_x * s8 - half_theta_z * s9
    value_by_delta_velocity_y_y = s12 + half_theta_x * s13 - half_theta_z * s11
    value_by_delta_velocity_y_z = s13 + half_theta_y * s11 - half_theta_x * s12
    value_by_delta_velocity_z_x = s7 + half_theta_z * s5 - half_theta_y * s6
    value_by_delta_velocity_z_z = s6 + half_theta_y * s7 - half_theta_x * s5
    del s1, s2, s3, s4, half_theta_z, half_theta_x, half_theta_y
    value_by_dt_x = dcm_00 * force_by_dt_x + dcm_01 * force_by_dt_y + dcm_02 * force_by_dt_z
    value_by_dt_y = dcm_10 * force_by_dt_x + dcm_11 * force_by_dt_y + dcm_12 * force_by_dt_z
    value_by_dt_z = dcm_20 * force_by_dt_x + dcm_21 * force_by_dt_y + dcm_22 * force_by_dt_z
    value_by_half_theta_z_y = delta_velocity_z * s7 - delta_velocity_x * s6
    value_by_half_theta_x_z = dcm_01 * delta_velocity_x * s0 - delta_velocity_y * s9
    value_by_half_theta_y_x = dcm_12 * delta_velocity_y * s0 - delta_velocity_z * s12
    value_by_half_theta_x_x = dcm_02 * delta_velocity_y * s0 - delta_velocity_z * s10
    del force_by_dt_x, force_by_dt_y, force_by_dt_z, s6, s12, s10
    value_by_half_theta_x_y = delta_velocity_z * s9 - delta_velocity_x * s8
    value_by_half_theta_y_y = delta_velocity_z * s11 - delta_velocity_x * s13
    value_by_half_theta_y_z = dcm_11 * delta_velocity_x * s0 - delta_velocity_y * s11
    value_by_half_theta_z_x = dcm_22 * delta_velocity_y * s0 - delta_velocity_z * s5
    value_by_half_theta_z_z = dcm_21 * delta_velocity_x * s0 - delta_velocity_y * s7
    del s8, s9, s13, s11, s5, s0, s7
    return (
        (resolved_x, resolved_y, resolved_z),
        (-resolved_z, resolved_y, resolved_z, -resolved_x, -resolved_y, resolved_x),
        (
            0.5 * value_by_half_theta_x_x,
            0.5 * value_by_half_theta_x_y,
            0.5 * value_by_half_theta_x_z,
            0.5 * value_by_half_theta_y_x,
            0.5 * value_by_half_theta_y_y,
            0.5 * value_by_half_theta_y_z,
            0.5 * value_by_half_theta_z_x,
            0.5 * value_by_half_theta_z_y,
            0.5 * value_by_half_theta_z_z,
        ),
        (
            value_by_delta_velocity_x_x, value_by_delta_velocity_x_y, value_by_delta_velocity_x_z,
            value_by_delta_velocity_y_x, value_by_delta_velocity_y_y, value_by_delta_velocity_y_z,
            value_by_delta_velocity_z_x, value_by_delta_velocity_z_y, value_by_delta_velocity_z_z,
        ),
        (value_by_dt_x, value_by_dt_y, value_by_dt_z),
    )


calc_force = _calls.publish(
    _arrays.ArrayFunction(_interface.CALC_FORCE, _calc_force_kernel), __name__
)


def _force_kernel(
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
    delta_theta_x = delta_theta[0]
    delta_theta_y = delta_theta[1]
    delta_theta_z = delta_theta[2]
    delta_velocity_x = delta_velocity[0]
    delta_velocity_y = delta_velocity[1]
    delta_velocity_z = delta_velocity[2]
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
    gyro_bias_step_x = dt * gyro_bias_x
    gyro_bias_step_y = dt * gyro_bias_y
    gyro_bias_step_z = dt * gyro_bias_z
    a_x = delta_theta_x - gyro_bias_step_x
    a_y = delta_theta_y - gyro_bias_step_y
    a_z = delta_theta_z - gyro_bias_step_z
    accelerometer_bias_step_x = accelerometer_bias_x * dt
    accelerometer_bias_step_y = accelerometer_bias_y * dt
    accelerometer_bias_step_z = accelerometer_bias_z * dt
    v_x = delta_velocity_x - accelerometer_bias_step_x
    v_y = delta_velocity_y - accelerometer_bias_step_y
    v_z = delta_velocity_z - accelerometer_bias_step_z
    del gyro_bias_step_x, gyro_bias_step_y, gyro_bias_step_z, accelerometer_bias_step_x
    del accelerometer_bias_step_y, accelerometer_bias_step_z
    half_theta_x = 0.5 * a_x
    half_theta_y = 0.5 * a_y
    half_theta_z = 0.5 * a_z
    s1 = 1.0 / dt
    s2 = v_x + half_theta_y * v_z - half_theta_z * v_y
    force_x = s1 * s2
    s3 = v_y + half_theta_z * v_x - half_theta_x * v_z
    force_y = s1 * s3
    s4 = v_z + half_theta_x * v_y - half_theta_y * v_x
    force_z = s1 * s4
    corrected_x = force_x
    corrected_y = force_y
    corrected_z = force_z
    del a_x, a_y, a_z, force_x, force_y, force_z
    resolved_x = attitude_00 * corrected_x + attitude_01 * corrected_y + attitude_02 * corrected_z
    resolved_y = attitude_10 * corrected_x + attitude_11 * corrected_y + attitude_12 * corrected_z
    resolved_z = attitude_20 * corrected_x + attitude_21 * corrected_y + attitude_22 * corrected_z
    s5 = 1.0 / (dt * dt)
    force_by_dt_x = -(s2 * s5)
    force_by_dt_y = -(s3 * s5)
    force_by_dt_z = -(s4 * s5)
    del corrected_x, corrected_y, corrected_z, s2, s3, s4, s5
    value_by_dt_x = (
        attitude_00 * force_by_dt_x + attitude_01 * force_by_dt_y + attitude_02 * force_by_dt_z
    )
    value_by_dt_y = (
        attitude_10 * force_by_dt_x + attitude_11 * force_by_dt_y + attitude_12 * force_by_dt_z
    )
    value_by_dt_z = (
        attitude_20 * force_by_dt_x + attitude_21 * force_by_dt_y + attitude_22 * force_by_dt_z
    )
    s6 = attitude_20 * s1
    s7 = attitude_22 * s1
    value_by_half_theta_z_y = s6 * v_z - s7 * v_x
    s8 = attitude_00 * s1
    value_by_half_theta_x_z = attitude_01 * s1 * v_x - s8 * v_y
    s9 = attitude_11 * s1
    value_by_half_theta_y_x = attitude_12 * s1 * v_y - s9 * v_z
    s10 = attitude_01 * s1
    del force_by_dt_x, force_by_dt_y, force_by_dt_z, attitude_20, attitude_00, attitude_01
    value_by_half_theta_x_x = attitude_02 * s1 * v_y - s10 * v_z
    s11 = attitude_02 * s1
    value_by_half_theta_x_y = s8 * v_z - s11 * v_x
    s12 = attitude_10 * s1
    s13 = attitude_12 * s1
    value_by_half_theta_y_y = s12 * v_z - s13 * v_x
    value_by_half_theta_y_z = attitude_11 * s1 * v_x - s12 * v_y
    s14 = attitude_21 * s1
    value_by_half_theta_z_x = attitude_22 * s1 * v_y - s14 * v_z
    del attitude_02, attitude_10, attitude_12, attitude_11, attitude_22, v_z
    value_by_half_theta_z_z = attitude_21 * s1 * v_x - s6 * v_y
    value_by_v_z_y = s14 + half_theta_x * s7 - half_theta_z * s6
    value_by_v_x_z = s11 + half_theta_y * s8 - half_theta_x * s10
    value_by_v_y_x = s12 + half_theta_z * s9 - half_theta_y * s13
    value_by_v_x_x = s8 + half_theta_z * s10 - half_theta_y * s11
    value_by_v_x_y = s10 + half_theta_x * s11 - half_theta_z * s8
    del attitude_21, v_x, v_y, s1, s8, s10, s11
    value_by_v_y_y = s9 + half_theta_x * s13 - half_theta_z * s12
    value_by_v_y_z = s13 + half_theta_y * s12 - half_theta_x * s9
    value_by_v_z_x = s6 + half_theta_z * s14 - half_theta_y * s7
    value_by_v_z_z = s7 + half_theta_y * s6 - half_theta_x * s14
    del s9, s12, s13, half_theta_z, half_theta_x, half_theta_y, s6, s7, s14
    value_by_a_z_y = 0.5 * value_by_half_theta_z_y
    value_by_a_x_z = 0.5 * value_by_half_theta_x_z
    value_by_a_y_x = 0.5 * value_by_half_theta_y_x
    value_by_a_x_x = 0.5 * value_by_half_theta_x_x
    value_by_a_x_y = 0.5 * value_by_half_theta_x_y
    value_by_a_y_y = 0.5 * value_by_half_theta_y_y
    del value_by_half_theta_z_y, value_by_half_theta_x_z, value_by_half_theta_y_x
    del value_by_half_theta_x_x, value_by_half_theta_x_y, value_by_half_theta_y_y
    value_by_a_y_z = 0.5 * value_by_half_theta_y_z
    value_by_a_z_x = 0.5 * value_by_half_theta_z_x
    value_by_a_z_z = 0.5 * value_by_half_theta_z_z
    value_by_accelerometer_bias_z_y = -(dt * value_by_v_z_y)
    value_by_accelerometer_bias_x_z = -(dt * value_by_v_x_z)
    value_by_accelerometer_bias_y_x = -(dt * value_by_v_y_x)
    value_by_accelerometer_bias_x_x = -(dt * value_by_v_x_x)
    value_by_accelerometer_bias_x_y = -(dt * value_by_v_x_y)
    value_by_accelerometer_bias_y_y = -(dt * value_by_v_y_y)
    value_by_accelerometer_bias_y_z = -(dt * value_by_v_y_z)
    value_by_accelerometer_bias_z_x = -(dt * value_by_v_z_x)
    value_by_accelerometer_bias_z_z = -(dt * value_by_v_z_z)
    value_by_dt_x_2 = (
        value_by_dt_x - accelerometer_bias_x * value_by_v_x_x
        - accelerometer_bias_y * value_by_v_x_y - accelerometer_bias_z * value_by_v_x_z
    )
    value_by_dt_y_2 = (
        value_by_dt_y - accelerometer_bias_x * value_by_v_y_x
        - accelerometer_bias_y * value_by_v_y_y - accelerometer_bias_z * value_by_v_y_z
    )
    value_by_dt_z_2 = (
        value_by_dt_z - accelerometer_bias_x * value_by_v_z_x
        - accelerometer_bias_y * value_by_v_z_y - accelerometer_bias_z * value_by_v_z_z
    )
    del value_by_half_theta_y_z, value_by_half_theta_z_x, value_by_half_theta_z_z, value_by_dt_x
    del value_by_dt_y, value_by_dt_z
    value_by_dt_x_3 = (
        value_by_dt_x_2 - gyro_bias_x * value_by_a_x_x - gyro_bias_y * value_by_a_x_y
        - gyro_bias_z * value_by_a_x_z
    )
    value_by_dt_y_3 = (
        value_by_dt_y_2 - gyro_bias_x * value_by_a_y_x - gyro_bias_y * value_by_a_y_y
        - gyro_bias_z * value_by_a_y_z
    )
    value_by_dt_z_3 = (
        value_by_dt_z_2 - gyro_bias_x * value_by_a_z_x - gyro_bias_y * value_by_a_z_y
        - gyro_bias_z * value_by_a_z_z
    )
    value_by_gyro_bias_z_y = -(dt * value_by_a_z_y)
    value_by_gyro_bias_x_z = -(dt * value_by_a_x_z)
    value_by_gyro_bias_y_x = -(dt * value_by_a_y_x)
    value_by_gyro_bias_x_x = -(dt * value_by_a_x_x)
    value_by_gyro_bias_x_y = -(dt * value_by_a_x_y)
    value_by_gyro_bias_y_y = -(dt * value_by_a_y_y)
    value_by_gyro_bias_y_z = -(dt * value_by_a_y_z)
    value_by_gyro_bias_z_x = -(dt * value_by_a_z_x)
    value_by_gyro_bias_z_z = -(dt * value_by_a_z_z)
    return (
        (resolved_x, resolved_y, resolved_z),
        (
            -resolved_z, resolved_y, value_by_accelerometer_bias_x_x,
            value_by_accelerometer_bias_x_y, value_by_accelerometer_bias_x_z,
            value_by_gyro_bias_x_x, value_by_gyro_bias_x_y, value_by_gyro_bias_x_z, resolved_z,
            -resolved_x, value_by_accelerometer_bias_y_x, value_by_accelerometer_bias_y_y,
            value_by_accelerometer_bias_y_z, value_by_gyro_bias_y_x, value_by_gyro_bias_y_y,
            value_by_gyro_bias_y_z, -resolved_y, resolved_x, value_by_accelerometer_bias_z_x,
            value_by_accelerometer_bias_z_y, value_by_accelerometer_bias_z_z,
            value_by_gyro_bias_z_x, value_by_gyro_bias_z_y, value_by_gyro_bias_z_z,
        ),
        (
            value_by_a_x_x, value_by_a_x_y, value_by_a_x_z, value_by_a_y_x, value_by_a_y_y,
            value_by_a_y_z, value_by_a_z_x, value_by_a_z_y, value_by_a_z_z,
        ),
        (
            value_by_v_x_x, value_by_v_x_y, value_by_v_x_z, value_by_v_y_x, value_by_v_y_y,
            value_by_v_y_z, value_by_v_z_x, value_by_v_z_y, value_by_v_z_z,
        ),
        (value_by_dt_x_3, value_by_dt_y_3, value_by_dt_z_3),
    )


force = _calls.publish(_arrays.ArrayFunction(_interface.FORCE, _force_kernel), __name__)
