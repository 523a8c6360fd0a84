"""The functions of ``farrell_tightly_coupled`` in pure NumPy: no compiler, no dependency.

Leading axes broadcast. Arrays of another library that follows the array API standard (JAX among
them, also under ``jax.jit``) stay in that library; complex arguments carry derivatives.
Names that are not read any more are deleted, so that arrays find room in the cache.
"""

from __future__ import annotations

from typing import Any

from . import _arrays, _calls, _interface, _runtime


def _retract_kernel(xp: Any, guards: _arrays.Guards, x: Any, d: Any) -> _arrays.Nonzeros:
    dp_x = x[0]
    dp_y = x[1]
    dp_z = x[2]
    b_u = x[3]
    dv_x = x[4]
    dv_y = x[5]
    dv_z = x[6]
    b_u_dot = x[7]
    drho_w = x[8]
    drho_x = x[9]
    drho_y = x[10]
    drho_z = x[11]
    x_a_x = x[12]
    x_a_y = x[13]
    x_a_z = x[14]
    x_g_x = x[15]
    x_g_y = x[16]
    x_g_z = x[17]
    d_dp_x = d[0]
    d_dp_y = d[1]
    d_dp_z = d[2]
    d_b_u = d[3]
    d_dv_x = d[4]
    d_dv_y = d[5]
    d_dv_z = d[6]
    d_b_u_dot = d[7]
    d_drho_x = d[8]
    d_drho_y = d[9]
    d_drho_z = d[10]
    d_x_a_x = d[11]
    d_x_a_y = d[12]
    d_x_a_z = d[13]
    d_x_g_x = d[14]
    d_x_g_y = d[15]
    d_x_g_z = d[16]
    drho_exp_angle_squared = d_drho_x * d_drho_x + d_drho_y * d_drho_y + d_drho_z * d_drho_z
    s0 = xp.less(drho_exp_angle_squared, 0.01)
    drho_exp_safe_squared = xp.where(s0, guards.constant(1.0), drho_exp_angle_squared)
    drho_exp_angle = xp.sqrt(drho_exp_safe_squared)
    drho_exp_near_cosine = (
        1.0 + drho_exp_angle_squared * (drho_exp_angle_squared * (0.0026041666666666665
        + drho_exp_angle_squared * (9.68812003968254e-8 * drho_exp_angle_squared
        - 2.170138888888889e-5)) - 0.125)
    )
    drho_exp_near_sinc = (
        0.5 + drho_exp_angle_squared * (drho_exp_angle_squared * (2.6041666666666666e-4
        + drho_exp_angle_squared * (5.382288910934745e-9 * drho_exp_angle_squared
        - 1.5500992063492063e-6)) - 0.020833333333333332)
    )
    drho_exp_half = 0.5 * drho_exp_angle
    drho_exp_far_cosine = xp.cos(drho_exp_half)
    drho_exp_far_sinc = xp.sin(drho_exp_half) / drho_exp_angle
    drho_exp_cosine = xp.where(s0, drho_exp_near_cosine, drho_exp_far_cosine)
    del drho_exp_safe_squared, drho_exp_angle_squared, drho_exp_angle, drho_exp_half
    del drho_exp_near_cosine, drho_exp_far_cosine
    drho_exp_sinc = xp.where(s0, drho_exp_near_sinc, drho_exp_far_sinc)
    drho_step_w = drho_exp_cosine
    drho_step_x = d_drho_x * drho_exp_sinc
    drho_step_y = d_drho_y * drho_exp_sinc
    drho_step_z = d_drho_z * drho_exp_sinc
    return (
        (
            d_dp_x + dp_x,
            d_dp_y + dp_y,
            d_dp_z + dp_z,
            b_u + d_b_u,
            d_dv_x + dv_x,
            d_dv_y + dv_y,
            d_dv_z + dv_z,
            b_u_dot + d_b_u_dot,
            drho_step_w * drho_w - drho_step_x * drho_x - drho_step_y * drho_y
            - drho_step_z * drho_z,
            drho_step_w * drho_x + drho_step_x * drho_w + drho_step_y * drho_z
            - drho_step_z * drho_y,
            drho_step_w * drho_y + drho_step_y * drho_w + drho_step_z * drho_x
            - drho_step_x * drho_z,
            drho_step_w * drho_z + drho_step_x * drho_y + drho_step_z * drho_w
            - drho_step_y * drho_x,
            d_x_a_x + x_a_x,
            d_x_a_y + x_a_y,
            d_x_a_z + x_a_z,
            d_x_g_x + x_g_x,
            d_x_g_y + x_g_y,
            d_x_g_z + x_g_z,
        ),
    )


retract = _calls.publish(_arrays.ArrayFunction(_interface.RETRACT, _retract_kernel), __name__)


def _local_kernel(xp: Any, guards: _arrays.Guards, x: Any, y: Any) -> _arrays.Nonzeros:
    dp_x = x[0]
    dp_y = x[1]
    dp_z = x[2]
    b_u = x[3]
    dv_x = x[4]
    dv_y = x[5]
    dv_z = x[6]
    b_u_dot = x[7]
    drho_w = x[8]
    drho_x = x[9]
    drho_y = x[10]
    drho_z = x[11]
    x_a_x = x[12]
    x_a_y = x[13]
    x_a_z = x[14]
    x_g_x = x[15]
    x_g_y = x[16]
    x_g_z = x[17]
    y_dp_x = y[0]
    y_dp_y = y[1]
    y_dp_z = y[2]
    y_b_u = y[3]
    y_dv_x = y[4]
    y_dv_y = y[5]
    y_dv_z = y[6]
    y_b_u_dot = y[7]
    y_drho_w = y[8]
    y_drho_x = y[9]
    y_drho_y = y[10]
    y_drho_z = y[11]
    y_x_a_x = y[12]
    y_x_a_y = y[13]
    y_x_a_z = y[14]
    y_x_g_x = y[15]
    y_x_g_y = y[16]
    y_x_g_z = y[17]
    drho_log_of_w = drho_w * y_drho_w + drho_x * y_drho_x + drho_y * y_drho_y + drho_z * y_drho_z
    drho_log_of_x = drho_w * y_drho_x + drho_y * y_drho_z - drho_x * y_drho_w - drho_z * y_drho_y
    drho_log_of_y = drho_w * y_drho_y + drho_z * y_drho_x - drho_x * y_drho_z - drho_y * y_drho_w
    drho_log_of_z = drho_w * y_drho_z + drho_x * y_drho_y - drho_y * y_drho_x - drho_z * y_drho_w
    drho_log_sign = xp.where(xp.less(drho_log_of_w, 0.0), guards.constant(-1.0), 1.0)
    drho_log_w = drho_log_of_w * drho_log_sign
    drho_log_sine_squared = (
        drho_log_of_x * drho_log_of_x + drho_log_of_y * drho_log_of_y
        + drho_log_of_z * drho_log_of_z
    )
    s0 = xp.less(drho_log_sine_squared, 0.01)
    drho_log_safe_squared = xp.where(s0, guards.constant(1.0), drho_log_sine_squared)
    drho_log_sine = xp.sqrt(drho_log_safe_squared)
    drho_log_cosine = xp.where(xp.less(0.5, drho_log_w), drho_log_w, 1.0)
    drho_log_tangent_squared = drho_log_sine_squared / (drho_log_cosine * drho_log_cosine)
    drho_log_series = (
        1.0 + drho_log_tangent_squared * (drho_log_tangent_squared * (0.2
        + drho_log_tangent_squared * (drho_log_tangent_squared * (0.1111111111111111
        + drho_log_tangent_squared * (drho_log_tangent_squared * (0.07692307692307693
        + drho_log_tangent_squared * (0.058823529411764705 * drho_log_tangent_squared
        - 0.06666666666666667)) - 0.09090909090909091)) - 0.14285714285714285))
        - 0.3333333333333333)
    )
    drho_log_far = 2.0 * xp.atan2(drho_log_sine, drho_log_w) / drho_log_sine
    del drho_log_of_w, drho_log_safe_squared, drho_log_sine_squared, drho_log_tangent_squared
    del drho_log_w, drho_log_sine
    drho_log_scale = xp.where(s0, 2.0 * drho_log_series / drho_log_cosine, drho_log_far)
    drho_log_signed_scale = drho_log_scale * drho_log_sign
    del s0, drho_log_cosine, drho_log_series, drho_log_far, drho_log_sign, drho_log_scale
    return (
        (
            y_dp_x - dp_x,
            y_dp_y - dp_y,
            y_dp_z - dp_z,
            y_b_u - b_u,
            y_dv_x - dv_x,
            y_dv_y - dv_y,
            y_dv_z - dv_z,
            y_b_u_dot - b_u_dot,
            drho_log_of_x * drho_log_signed_scale,
            drho_log_of_y * drho_log_signed_scale,
            drho_log_of_z * drho_log_signed_scale,
            y_x_a_x - x_a_x,
            y_x_a_y - x_a_y,
            y_x_a_z - x_a_z,
            y_x_g_x - x_g_x,
            y_x_g_y - x_g_y,
            y_x_g_z - x_g_z,
        ),
    )


local = _calls.publish(_arrays.ArrayFunction(_interface.LOCAL, _local_kernel), __name__)


def _pseudorange_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, c_n_e: Any, origin: Any
) -> _arrays.Mapped:
    dp_x = x[0]
    dp_y = x[1]
    dp_z = x[2]
    b_u = x[3]
    c_n_e_00 = c_n_e[0]
    c_n_e_01 = c_n_e[1]
    c_n_e_02 = c_n_e[2]
    c_n_e_10 = c_n_e[3]
    c_n_e_11 = c_n_e[4]
    c_n_e_12 = c_n_e[5]
    c_n_e_20 = c_n_e[6]
    c_n_e_21 = c_n_e[7]
    c_n_e_22 = c_n_e[8]
    origin_x = origin[0]
    origin_y = origin[1]
    origin_z = origin[2]
    antenna_nav_x = dp_x
    antenna_nav_y = dp_y
    antenna_nav_z = dp_z
    antenna_ecef_x = antenna_nav_x * c_n_e_00 + antenna_nav_y * c_n_e_01 + antenna_nav_z * c_n_e_02
    antenna_ecef_y = antenna_nav_x * c_n_e_10 + antenna_nav_y * c_n_e_11 + antenna_nav_z * c_n_e_12
    antenna_ecef_z = antenna_nav_x * c_n_e_20 + antenna_nav_y * c_n_e_21 + antenna_nav_z * c_n_e_22
    antenna_x = antenna_ecef_x + origin_x
    antenna_y = antenna_ecef_y + origin_y
    antenna_z = antenna_ecef_z + origin_z
    del antenna_nav_x, antenna_nav_y, antenna_nav_z, antenna_ecef_x, antenna_ecef_y, antenna_ecef_z

    def item(satellite_position: Any, measured: Any) -> _arrays.Nonzeros:
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
        value_out = b_u + range
        del range_squared, range_vector_x, range_vector_y, range_vector_z, s0, range
        range_by_dp_x = (
            c_n_e_00 * range_direction_x + c_n_e_10 * range_direction_y
            + c_n_e_20 * range_direction_z
        )
        range_by_dp_y = (
            c_n_e_01 * range_direction_x + c_n_e_11 * range_direction_y
            + c_n_e_21 * range_direction_z
        )
        range_by_dp_z = (
            c_n_e_02 * range_direction_x + c_n_e_12 * range_direction_y
            + c_n_e_22 * range_direction_z
        )
        return (
            (value_out,),
            (measured - value_out,),
            (range_by_dp_x, range_by_dp_y, range_by_dp_z, 1.0),
        )

    return (), item


pseudorange = _calls.publish(
    _arrays.ArrayFunction(_interface.PSEUDORANGE, _pseudorange_kernel), __name__
)


def _pseudorange_lever_arm_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, c_n_e: Any, origin: Any, lever_arm: Any
) -> _arrays.Mapped:
    dp_x = x[0]
    dp_y = x[1]
    dp_z = x[2]
    b_u = x[3]
    drho_w = x[8]
    drho_x = x[9]
    drho_y = x[10]
    drho_z = x[11]
    c_n_e_00 = c_n_e[0]
    c_n_e_01 = c_n_e[1]
    c_n_e_02 = c_n_e[2]
    c_n_e_10 = c_n_e[3]
    c_n_e_11 = c_n_e[4]
    c_n_e_12 = c_n_e[5]
    c_n_e_20 = c_n_e[6]
    c_n_e_21 = c_n_e[7]
    c_n_e_22 = c_n_e[8]
    origin_x = origin[0]
    origin_y = origin[1]
    origin_z = origin[2]
    lever_arm_x = lever_arm[0]
    lever_arm_y = lever_arm[1]
    lever_arm_z = lever_arm[2]
    drho_twice_x = 2.0 * drho_x
    drho_twice_y = 2.0 * drho_y
    drho_twice_z = 2.0 * drho_z
    drho_twice_xx = drho_twice_x * drho_x
    drho_twice_yy = drho_twice_y * drho_y
    drho_twice_zz = drho_twice_z * drho_z
    drho_twice_xy = drho_twice_y * drho_x
    drho_twice_xz = drho_twice_z * drho_x
    drho_twice_yz = drho_twice_z * drho_y
    drho_twice_wx = drho_twice_x * drho_w
    drho_twice_wy = drho_twice_y * drho_w
    drho_twice_wz = drho_twice_z * drho_w
    s0 = drho_twice_zz - 1.0
    drho_00 = -drho_twice_yy - s0
    drho_01 = drho_twice_xy - drho_twice_wz
    drho_02 = drho_twice_wy + drho_twice_xz
    drho_10 = drho_twice_wz + drho_twice_xy
    del drho_twice_x, drho_twice_y, drho_twice_z, drho_twice_zz, drho_twice_xy, drho_twice_wz
    drho_11 = -drho_twice_xx - s0
    drho_12 = drho_twice_yz - drho_twice_wx
    drho_20 = drho_twice_xz - drho_twice_wy
    drho_21 = drho_twice_wx + drho_twice_yz
    drho_22 = 1.0 - drho_twice_xx - drho_twice_yy
    del s0, drho_twice_xz, drho_twice_wy, drho_twice_yz, drho_twice_wx, drho_twice_xx, drho_twice_yy
    drho_arm_x = drho_00 * lever_arm_x + drho_01 * lever_arm_y + drho_02 * lever_arm_z
    drho_arm_y = drho_10 * lever_arm_x + drho_11 * lever_arm_y + drho_12 * lever_arm_z
    del drho_00, drho_01, drho_02, drho_10, drho_11, drho_12
    drho_arm_z = drho_20 * lever_arm_x + drho_21 * lever_arm_y + drho_22 * lever_arm_z
    antenna_nav_x = dp_x + drho_arm_x
    antenna_nav_y = dp_y + drho_arm_y
    antenna_nav_z = dp_z + drho_arm_z
    antenna_ecef_x = antenna_nav_x * c_n_e_00 + antenna_nav_y * c_n_e_01 + antenna_nav_z * c_n_e_02
    antenna_ecef_y = antenna_nav_x * c_n_e_10 + antenna_nav_y * c_n_e_11 + antenna_nav_z * c_n_e_12
    antenna_ecef_z = antenna_nav_x * c_n_e_20 + antenna_nav_y * c_n_e_21 + antenna_nav_z * c_n_e_22
    del drho_20, drho_21, drho_22, antenna_nav_x, antenna_nav_y, antenna_nav_z
    antenna_x = antenna_ecef_x + origin_x
    antenna_y = antenna_ecef_y + origin_y
    antenna_z = antenna_ecef_z + origin_z

    def item(satellite_position: Any) -> _arrays.Nonzeros:
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
        s1 = 1.0 / range
        range_direction_x = range_vector_x * s1
        range_direction_y = range_vector_y * s1
        range_direction_z = range_vector_z * s1
        value_out = b_u + range
        del range_squared, range_vector_x, range_vector_y, range_vector_z, s1, range
        value_by_antenna_nav_x = (
            c_n_e_00 * range_direction_x + c_n_e_10 * range_direction_y
            + c_n_e_20 * range_direction_z
        )
        value_by_antenna_nav_y = (
            c_n_e_01 * range_direction_x + c_n_e_11 * range_direction_y
            + c_n_e_21 * range_direction_z
        )
        value_by_antenna_nav_z = (
            c_n_e_02 * range_direction_x + c_n_e_12 * range_direction_y
            + c_n_e_22 * range_direction_z
        )
        value_by_drho_tangent_x = (
            drho_arm_y * value_by_antenna_nav_z - drho_arm_z * value_by_antenna_nav_y
        )
        value_by_drho_tangent_y = (
            drho_arm_z * value_by_antenna_nav_x - drho_arm_x * value_by_antenna_nav_z
        )
        value_by_drho_tangent_z = (
            drho_arm_x * value_by_antenna_nav_y - drho_arm_y * value_by_antenna_nav_x
        )
        return (
            (value_out,),
            (
                value_by_antenna_nav_x,
                value_by_antenna_nav_y,
                value_by_antenna_nav_z,
                1.0,
                value_by_drho_tangent_x,
                value_by_drho_tangent_y,
                value_by_drho_tangent_z,
            ),
        )

    return (), item


pseudorange_lever_arm = _calls.publish(
    _arrays.ArrayFunction(_interface.PSEUDORANGE_LEVER_ARM, _pseudorange_lever_arm_kernel), __name__
)
