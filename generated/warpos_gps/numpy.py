"""The functions of ``warpos_gps`` in pure NumPy: no compiler, no dependency.

Leading axes broadcast. Arrays of another library that follows the array API standard (JAX among
them, also under ``jax.jit``) stay in that library; complex arguments carry derivatives.
Names that are not read any more are deleted, so that arrays find room in the cache.
"""

from __future__ import annotations

from typing import Any

from . import _arrays, _calls, _interface


def _retract_kernel(xp: Any, guards: _arrays.Guards, x: Any, d: Any) -> _arrays.Nonzeros:
    leading_0 = x[0]
    leading_1 = x[1]
    leading_2 = x[2]
    leading_3 = x[3]
    position_x = x[4]
    position_y = x[5]
    position_z = x[6]
    trailing_0 = x[7]
    trailing_1 = x[8]
    trailing_2 = x[9]
    trailing_3 = x[10]
    trailing_4 = x[11]
    trailing_5 = x[12]
    trailing_6 = x[13]
    trailing_7 = x[14]
    d_leading_0 = d[0]
    d_leading_1 = d[1]
    d_leading_2 = d[2]
    d_leading_3 = d[3]
    d_position_x = d[4]
    d_position_y = d[5]
    d_position_z = d[6]
    d_trailing_0 = d[7]
    d_trailing_1 = d[8]
    d_trailing_2 = d[9]
    d_trailing_3 = d[10]
    d_trailing_4 = d[11]
    d_trailing_5 = d[12]
    d_trailing_6 = d[13]
    d_trailing_7 = d[14]
    return (
        (
            d_leading_0 + leading_0,
            d_leading_1 + leading_1,
            d_leading_2 + leading_2,
            d_leading_3 + leading_3,
            d_position_x + position_x,
            d_position_y + position_y,
            d_position_z + position_z,
            d_trailing_0 + trailing_0,
            d_trailing_1 + trailing_1,
            d_trailing_2 + trailing_2,
            d_trailing_3 + trailing_3,
            d_trailing_4 + trailing_4,
            d_trailing_5 + trailing_5,
            d_trailing_6 + trailing_6,
            d_trailing_7 + trailing_7,
        ),
    )


retract = _calls.publish(_arrays.ArrayFunction(_interface.RETRACT, _retract_kernel), __name__)


def _local_kernel(xp: Any, guards: _arrays.Guards, x: Any, y: Any) -> _arrays.Nonzeros:
    leading_0 = x[0]
    leading_1 = x[1]
    leading_2 = x[2]
    leading_3 = x[3]
    position_x = x[4]
    position_y = x[5]
    position_z = x[6]
    trailing_0 = x[7]
    trailing_1 = x[8]
    trailing_2 = x[9]
    trailing_3 = x[10]
    trailing_4 = x[11]
    trailing_5 = x[12]
    trailing_6 = x[13]
    trailing_7 = x[14]
    y_leading_0 = y[0]
    y_leading_1 = y[1]
    y_leading_2 = y[2]
    y_leading_3 = y[3]
    y_position_x = y[4]
    y_position_y = y[5]
    y_position_z = y[6]
    y_trailing_0 = y[7]
    y_trailing_1 = y[8]
    y_trailing_2 = y[9]
    y_trailing_3 = y[10]
    y_trailing_4 = y[11]
    y_trailing_5 = y[12]
    y_trailing_6 = y[13]
    y_trailing_7 = y[14]
    return (
        (
            y_leading_0 - leading_0,
            y_leading_1 - leading_1,
            y_leading_2 - leading_2,
            y_leading_3 - leading_3,
            y_position_x - position_x,
            y_position_y - position_y,
            y_position_z - position_z,
            y_trailing_0 - trailing_0,
            y_trailing_1 - trailing_1,
            y_trailing_2 - trailing_2,
            y_trailing_3 - trailing_3,
            y_trailing_4 - trailing_4,
            y_trailing_5 - trailing_5,
            y_trailing_6 - trailing_6,
            y_trailing_7 - trailing_7,
        ),
    )


local = _calls.publish(_arrays.ArrayFunction(_interface.LOCAL, _local_kernel), __name__)


def _measurement_kernel(xp: Any, guards: _arrays.Guards, x: Any) -> _arrays.Nonzeros:
    position_x = x[4]
    position_y = x[5]
    position_z = x[6]
    return ((position_x, position_y, position_z), (1.0, 1.0, 1.0))


measurement = _calls.publish(
    _arrays.ArrayFunction(_interface.MEASUREMENT, _measurement_kernel), __name__
)


def _measurement_by_column_kernel(xp: Any, guards: _arrays.Guards, x: Any) -> _arrays.Nonzeros:
    position_x = x[4]
    position_y = x[5]
    position_z = x[6]
    return ((position_x, position_y, position_z), (1.0, 1.0, 1.0))


measurement_by_column = _calls.publish(
    _arrays.ArrayFunction(_interface.MEASUREMENT_BY_COLUMN, _measurement_by_column_kernel), __name__
)


def _observed_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, observer_attitude: Any
) -> _arrays.Nonzeros:
    position_x = x[4]
    position_y = x[5]
    position_z = x[6]
    observer_attitude_w = observer_attitude[0]
    observer_attitude_x = observer_attitude[1]
    observer_attitude_y = observer_attitude[2]
    observer_attitude_z = observer_attitude[3]
    observer_attitude_twice_x = 2.0 * observer_attitude_x
    observer_attitude_twice_y = 2.0 * observer_attitude_y
    observer_attitude_twice_z = 2.0 * observer_attitude_z
    observer_attitude_twice_xx = observer_attitude_twice_x * observer_attitude_x
    observer_attitude_twice_yy = observer_attitude_twice_y * observer_attitude_y
    observer_attitude_twice_zz = observer_attitude_twice_z * observer_attitude_z
    observer_attitude_twice_xy = observer_attitude_twice_y * observer_attitude_x
    observer_attitude_twice_xz = observer_attitude_twice_z * observer_attitude_x
    observer_attitude_twice_yz = observer_attitude_twice_z * observer_attitude_y
    observer_attitude_twice_wx = observer_attitude_twice_x * observer_attitude_w
    observer_attitude_twice_wy = observer_attitude_twice_y * observer_attitude_w
    observer_attitude_twice_wz = observer_attitude_twice_z * observer_attitude_w
    s0 = observer_attitude_twice_zz - 1.0
    observer_attitude_00 = -observer_attitude_twice_yy - s0
    observer_attitude_01 = observer_attitude_twice_xy - observer_attitude_twice_wz
    observer_attitude_02 = observer_attitude_twice_wy + observer_attitude_twice_xz
    observer_attitude_10 = observer_attitude_twice_wz + observer_attitude_twice_xy
    del observer_attitude_twice_x, observer_attitude_twice_y, observer_attitude_twice_z
    del observer_attitude_twice_zz, observer_attitude_twice_xy, observer_attitude_twice_wz
    observer_attitude_11 = -observer_attitude_twice_xx - s0
    observer_attitude_12 = observer_attitude_twice_yz - observer_attitude_twice_wx
    observer_attitude_20 = observer_attitude_twice_xz - observer_attitude_twice_wy
    observer_attitude_21 = observer_attitude_twice_wx + observer_attitude_twice_yz
    observer_attitude_22 = 1.0 - observer_attitude_twice_xx - observer_attitude_twice_yy
    del s0, observer_attitude_twice_xz, observer_attitude_twice_wy, observer_attitude_twice_yz
    del observer_attitude_twice_wx, observer_attitude_twice_xx, observer_attitude_twice_yy
    antenna_x = position_x
    antenna_y = position_y
    antenna_z = position_z
    observed_x = (
        antenna_x * observer_attitude_00 + antenna_y * observer_attitude_10
        + antenna_z * observer_attitude_20
    )
    observed_y = (
        antenna_x * observer_attitude_01 + antenna_y * observer_attitude_11
        + antenna_z * observer_attitude_21
    )
    observed_z = (
        antenna_x * observer_attitude_02 + antenna_y * observer_attitude_12
        + antenna_z * observer_attitude_22
    )
    return (
        (observed_x, observed_y, observed_z),
        (
            observer_attitude_00, observer_attitude_10, observer_attitude_20, observer_attitude_01,
            observer_attitude_11, observer_attitude_21, observer_attitude_02, observer_attitude_12,
            observer_attitude_22,
        ),
    )


observed = _calls.publish(_arrays.ArrayFunction(_interface.OBSERVED, _observed_kernel), __name__)


def _observed_by_column_kernel(
    xp: Any, guards: _arrays.Guards, x: Any, observer_attitude: Any
) -> _arrays.Nonzeros:
    position_x = x[4]
    position_y = x[5]
    position_z = x[6]
    observer_attitude_w = observer_attitude[0]
    observer_attitude_x = observer_attitude[1]
    observer_attitude_y = observer_attitude[2]
    observer_attitude_z = observer_attitude[3]
    observer_attitude_twice_x = 2.0 * observer_attitude_x
    observer_attitude_twice_y = 2.0 * observer_attitude_y
    observer_attitude_twice_z = 2.0 * observer_attitude_z
    observer_attitude_twice_xx = observer_attitude_twice_x * observer_attitude_x
    observer_attitude_twice_yy = observer_attitude_twice_y * observer_attitude_y
    observer_attitude_twice_zz = observer_attitude_twice_z * observer_attitude_z
    observer_attitude_twice_xy = observer_attitude_twice_y * observer_attitude_x
    observer_attitude_twice_xz = observer_attitude_twice_z * observer_attitude_x
    observer_attitude_twice_yz = observer_attitude_twice_z * observer_attitude_y
    observer_attitude_twice_wx = observer_attitude_twice_x * observer_attitude_w
    observer_attitude_twice_wy = observer_attitude_twice_y * observer_attitude_w
    observer_attitude_twice_wz = observer_attitude_twice_z * observer_attitude_w
    s0 = observer_attitude_twice_zz - 1.0
    observer_attitude_00 = -observer_attitude_twice_yy - s0
    observer_attitude_01 = observer_attitude_twice_xy - observer_attitude_twice_wz
    observer_attitude_02 = observer_attitude_twice_wy + observer_attitude_twice_xz
    observer_attitude_10 = observer_attitude_twice_wz + observer_attitude_twice_xy
    del observer_attitude_twice_x, observer_attitude_twice_y, observer_attitude_twice_z
    del observer_attitude_twice_zz, observer_attitude_twice_xy, observer_attitude_twice_wz
    observer_attitude_11 = -observer_attitude_twice_xx - s0
    observer_attitude_12 = observer_attitude_twice_yz - observer_attitude_twice_wx
    observer_attitude_20 = observer_attitude_twice_xz - observer_attitude_twice_wy
    observer_attitude_21 = observer_attitude_twice_wx + observer_attitude_twice_yz
    observer_attitude_22 = 1.0 - observer_attitude_twice_xx - observer_attitude_twice_yy
    del s0, observer_attitude_twice_xz, observer_attitude_twice_wy, observer_attitude_twice_yz
    del observer_attitude_twice_wx, observer_attitude_twice_xx, observer_attitude_twice_yy
    antenna_x = position_x
    antenna_y = position_y
    antenna_z = position_z
    observed_x = (
        antenna_x * observer_attitude_00 + antenna_y * observer_attitude_10
        + antenna_z * observer_attitude_20
    )
    observed_y = (
        antenna_x * observer_attitude_01 + antenna_y * observer_attitude_11
        + antenna_z * observer_attitude_21
    )
    observed_z = (
        antenna_x * observer_attitude_02 + antenna_y * observer_attitude_12
        + antenna_z * observer_attitude_22
    )
    return (
        (observed_x, observed_y, observed_z),
        (
            observer_attitude_00, observer_attitude_10, observer_attitude_20, observer_attitude_01,
            observer_attitude_11, observer_attitude_21, observer_attitude_02, observer_attitude_12,
            observer_attitude_22,
        ),
    )


observed_by_column = _calls.publish(
    _arrays.ArrayFunction(_interface.OBSERVED_BY_COLUMN, _observed_by_column_kernel), __name__
)


def _to_state_frame_kernel(
    xp: Any,
    guards: _arrays.Guards,
    observer_attitude: Any,
    receiver_position: Any,
    origin_offset: Any,
    attitude: Any,
    lever_arm: Any,
    covariance: Any,
) -> _arrays.Nonzeros:
    observer_attitude_w = observer_attitude[0]
    observer_attitude_x = observer_attitude[1]
    observer_attitude_y = observer_attitude[2]
    observer_attitude_z = observer_attitude[3]
    receiver_position_x = receiver_position[0]
    receiver_position_y = receiver_position[1]
    receiver_position_z = receiver_position[2]
    origin_offset_x = origin_offset[0]
    origin_offset_y = origin_offset[1]
    origin_offset_z = origin_offset[2]
    attitude_w = attitude[0]
    attitude_x = attitude[1]
    attitude_y = attitude[2]
    attitude_z = attitude[3]
    lever_arm_x = lever_arm[0]
    lever_arm_y = lever_arm[1]
    lever_arm_z = lever_arm[2]
    covariance_0 = covariance[0]
    covariance_1 = covariance[1]
    covariance_2 = covariance[2]
    covariance_3 = covariance[3]
    covariance_4 = covariance[4]
    covariance_5 = covariance[5]
    covariance_6 = covariance[6]
    covariance_7 = covariance[7]
    covariance_8 = covariance[8]
    observer_attitude_twice_x = 2.0 * observer_attitude_x
    observer_attitude_twice_y = 2.0 * observer_attitude_y
    observer_attitude_twice_z = 2.0 * observer_attitude_z
    observer_attitude_twice_xx = observer_attitude_twice_x * observer_attitude_x
    observer_attitude_twice_yy = observer_attitude_twice_y * observer_attitude_y
    observer_attitude_twice_zz = observer_attitude_twice_z * observer_attitude_z
    observer_attitude_twice_xy = observer_attitude_twice_y * observer_attitude_x
    observer_attitude_twice_xz = observer_attitude_twice_z * observer_attitude_x
    observer_attitude_twice_yz = observer_attitude_twice_z * observer_attitude_y
    observer_attitude_twice_wx = observer_attitude_twice_x * observer_attitude_w
    observer_attitude_twice_wy = observer_attitude_twice_y * observer_attitude_w
    observer_attitude_twice_wz = observer_attitude_twice_z * observer_attitude_w
    s0 = observer_attitude_twice_zz - 1.0
    observer_attitude_00 = -observer_attitude_twice_yy - s0
    observer_attitude_01 = observer_attitude_twice_xy - observer_attitude_twice_wz
    observer_attitude_02 = observer_attitude_twice_wy + observer_attitude_twice_xz
    observer_attitude_10 = observer_attitude_twice_wz + observer_attitude_twice_xy
    del observer_attitude_twice_x, observer_attitude_twice_y, observer_attitude_twice_z
    del observer_attitude_twice_zz, observer_attitude_twice_xy, observer_attitude_twice_wz
    observer_attitude_11 = -observer_attitude_twice_xx - s0
    observer_attitude_12 = observer_attitude_twice_yz - observer_attitude_twice_wx
    observer_attitude_20 = observer_attitude_twice_xz - observer_attitude_twice_wy
    observer_attitude_21 = observer_attitude_twice_wx + observer_attitude_twice_yz
    observer_attitude_22 = 1.0 - observer_attitude_twice_xx - observer_attitude_twice_yy
    del s0, observer_attitude_twice_xz, observer_attitude_twice_wy, observer_attitude_twice_yz
    del observer_attitude_twice_wx, observer_attitude_twice_xx, observer_attitude_twice_yy
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
    s1 = attitude_twice_zz - 1.0
    attitude_00 = -attitude_twice_yy - s1
    attitude_01 = attitude_twice_xy - attitude_twice_wz
    attitude_02 = attitude_twice_wy + attitude_twice_xz
    attitude_10 = attitude_twice_wz + attitude_twice_xy
    del attitude_twice_x, attitude_twice_y, attitude_twice_z, attitude_twice_zz, attitude_twice_xy
    del attitude_twice_wz
    attitude_11 = -attitude_twice_xx - s1
    attitude_12 = attitude_twice_yz - attitude_twice_wx
    attitude_20 = attitude_twice_xz - attitude_twice_wy
    attitude_21 = attitude_twice_wx + attitude_twice_yz
    attitude_22 = 1.0 - attitude_twice_xx - attitude_twice_yy
    del s1, attitude_twice_xz, attitude_twice_wy, attitude_twice_yz, attitude_twice_wx
    del attitude_twice_xx, attitude_twice_yy
    fix_x = (
        observer_attitude_00 * receiver_position_x + observer_attitude_01 * receiver_position_y
        + observer_attitude_02 * receiver_position_z
    )
    fix_y = (
        observer_attitude_10 * receiver_position_x + observer_attitude_11 * receiver_position_y
        + observer_attitude_12 * receiver_position_z
    )
    fix_z = (
        observer_attitude_20 * receiver_position_x + observer_attitude_21 * receiver_position_y
        + observer_attitude_22 * receiver_position_z
    )
    attitude_arm_x = (
        attitude_00 * lever_arm_x + attitude_01 * lever_arm_y + attitude_02 * lever_arm_z
    )
    attitude_arm_y = (
        attitude_10 * lever_arm_x + attitude_11 * lever_arm_y + attitude_12 * lever_arm_z
    )
    del attitude_00, attitude_01, attitude_02, attitude_10, attitude_11, attitude_12
    attitude_arm_z = (
        attitude_20 * lever_arm_x + attitude_21 * lever_arm_y + attitude_22 * lever_arm_z
    )
    value_out_x = fix_x - attitude_arm_x - origin_offset_x
    value_out_y = fix_y - attitude_arm_y - origin_offset_y
    del attitude_20, attitude_21, attitude_22, fix_x, attitude_arm_x, fix_y, attitude_arm_y
    value_out_z = fix_z - attitude_arm_z - origin_offset_z
    value_covariance_half_0 = (
        covariance_0 * observer_attitude_00 + covariance_3 * observer_attitude_01
        + covariance_6 * observer_attitude_02
    )
    value_covariance_half_1 = (
        covariance_1 * observer_attitude_00 + covariance_4 * observer_attitude_01
        + covariance_7 * observer_attitude_02
    )
    value_covariance_half_2 = (
        covariance_2 * observer_attitude_00 + covariance_5 * observer_attitude_01
        + covariance_8 * observer_attitude_02
    )
    value_covariance_half_3 = (
        covariance_0 * observer_attitude_10 + covariance_3 * observer_attitude_11
        + covariance_6 * observer_attitude_12
    )
    value_covariance_half_4 = (
        covariance_1 * observer_attitude_10 + covariance_4 * observer_attitude_11
        + covariance_7 * observer_attitude_12
    )
    value_covariance_half_5 = (
        covariance_2 * observer_attitude_10 + covariance_5 * observer_attitude_11
        + covariance_8 * observer_attitude_12
    )
    value_covariance_half_6 = (
        covariance_0 * observer_attitude_20 + covariance_3 * observer_attitude_21
        + covariance_6 * observer_attitude_22
    )
    value_covariance_half_7 = (
        covariance_1 * observer_attitude_20 + covariance_4 * observer_attitude_21
        + covariance_7 * observer_attitude_22
    )
    value_covariance_half_8 = (
        covariance_2 * observer_attitude_20 + covariance_5 * observer_attitude_21
        + covariance_8 * observer_attitude_22
    )
    value_covariance_out_0 = (
        observer_attitude_00 * value_covariance_half_0
        + observer_attitude_01 * value_covariance_half_1
        + observer_attitude_02 * value_covariance_half_2
    )
    value_covariance_out_1 = (
        observer_attitude_10 * value_covariance_half_0
        + observer_attitude_11 * value_covariance_half_1
        + observer_attitude_12 * value_covariance_half_2
    )
    value_covariance_out_2 = (
        observer_attitude_20 * value_covariance_half_0
        + observer_attitude_21 * value_covariance_half_1
        + observer_attitude_22 * value_covariance_half_2
    )
    value_covariance_out_3 = (
        observer_attitude_00 * value_covariance_half_3
        + observer_attitude_01 * value_covariance_half_4
        + observer_attitude_02 * value_covariance_half_5
    )
    value_covariance_out_4 = (
        observer_attitude_10 * value_covariance_half_3
        + observer_attitude_11 * value_covariance_half_4
        + observer_attitude_12 * value_covariance_half_5
    )
    value_covariance_out_5 = (
        observer_attitude_20 * value_covariance_half_3
        + observer_attitude_21 * value_covariance_half_4
        + observer_attitude_22 * value_covariance_half_5
    )
    del fix_z, attitude_arm_z, value_covariance_half_0, value_covariance_half_1
    del value_covariance_half_2, value_covariance_half_3, value_covariance_half_4
    del value_covariance_half_5
    value_covariance_out_6 = (
        observer_attitude_00 * value_covariance_half_6
        + observer_attitude_01 * value_covariance_half_7
        + observer_attitude_02 * value_covariance_half_8
    )
    value_covariance_out_7 = (
        observer_attitude_10 * value_covariance_half_6
        + observer_attitude_11 * value_covariance_half_7
        + observer_attitude_12 * value_covariance_half_8
    )
    del observer_attitude_00, observer_attitude_01, observer_attitude_02, observer_attitude_10
    del observer_attitude_11, observer_attitude_12
    value_covariance_out_8 = (
        observer_attitude_20 * value_covariance_half_6
        + observer_attitude_21 * value_covariance_half_7
        + observer_attitude_22 * value_covariance_half_8
    )
    del observer_attitude_20, observer_attitude_21, observer_attitude_22, value_covariance_half_6
    del value_covariance_half_7, value_covariance_half_8
    return (
        (value_out_x, value_out_y, value_out_z),
        (
            value_covariance_out_0, value_covariance_out_1, value_covariance_out_2,
            value_covariance_out_3, value_covariance_out_4, value_covariance_out_5,
            value_covariance_out_6, value_covariance_out_7, value_covariance_out_8,
        ),
    )


to_state_frame = _calls.publish(
    _arrays.ArrayFunction(_interface.TO_STATE_FRAME, _to_state_frame_kernel), __name__
)
