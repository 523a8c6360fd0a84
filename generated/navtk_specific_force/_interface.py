"""What the functions and the state of ``navtk_specific_force`` look like; data only."""

from __future__ import annotations

from typing import Any, NamedTuple

from ._runtime import Argument, Array, Domain, Kind, Output, Signature
from ._state import Block


class RetractResult(NamedTuple):
    """What ``retract`` returns."""

    value: Array
    """Value of the equation; shape (..., 16)."""
    status: Any


class LocalResult(NamedTuple):
    """What ``local`` returns."""

    value: Array
    """Value of the equation; shape (..., 15)."""
    status: Any


class CalcForceResult(NamedTuple):
    """What ``calc_force`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian_dcm: Array
    """Derivative of the value by dcm; shape (..., 3, 3)."""
    jacobian_delta_theta: Array
    """Derivative of the value by delta_theta; shape (..., 3, 3)."""
    jacobian_delta_velocity: Array
    """Derivative of the value by delta_velocity; shape (..., 3, 3)."""
    jacobian_dt: Array
    """Derivative of the value by dt; shape (..., 3, 1)."""
    status: Any


class ForceResult(NamedTuple):
    """What ``force`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 15)."""
    jacobian_delta_theta: Array
    """Derivative of the value by delta_theta; shape (..., 3, 3)."""
    jacobian_delta_velocity: Array
    """Derivative of the value by delta_velocity; shape (..., 3, 3)."""
    jacobian_dt: Array
    """Derivative of the value by dt; shape (..., 3, 1)."""
    status: Any


_STATE = Argument(
    "x",
    16,
    (
        Domain("position", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "n", ("x", "y", "z")),
        Domain("velocity", 3, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s", "n", ("x", "y", "z")),
        Domain(
            "attitude",
            6,
            4,
            Kind.QUATERNION,
            (-1.00001,) * 4,
            (1.00001,) * 4,
            "1",
            "s -> n",
            ("w", "x", "y", "z"),
            1e-05,
        ),
        Domain(
            "accelerometer_bias",
            10,
            3,
            Kind.REAL,
            (-1.0,) * 3,
            (1.0,) * 3,
            "m/s^2",
            "s",
            ("x", "y", "z"),
        ),
        Domain(
            "gyro_bias", 13, 3, Kind.REAL, (-0.1,) * 3, (0.1,) * 3, "rad/s", "s", ("x", "y", "z")
        ),
    ),
)


RETRACT = Signature(
    "retract",
    """State moved by an error.

        value = x (+) d

    Parameters
    ----------
    x : array_like, shape (..., 16)
        - [0:3] position (m, frame n, range [-1e9, 1e9])
        - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
        - [6:10] attitude (map s -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame s, range [-1, 1])
        - [13:16] gyro_bias (rad/s, frame s, range [-0.1, 0.1])
    d : array_like, shape (..., 15)
        - [0:3] position (m, frame n, range [-1e9, 1e9]): Error of position
        - [3:6] velocity (m/s, frame n, range [-1e9, 1e9]): Error of velocity
        - [6:9] attitude (rad, frame n, range [-6, 6]): Error of attitude
        - [9:12] accelerometer_bias (m/s^2, frame s, range [-1e9, 1e9]): Error of
          accelerometer_bias
        - [12:15] gyro_bias (rad/s, frame s, range [-1e9, 1e9]): Error of gyro_bias
    out : RetractResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    RetractResult
        value : array, shape (..., 16)
            Value of the equation.
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``retract.value`` (value), ``retract.bind`` (a call
    without arguments over the same arrays), ``retract.blocks`` (epochs side by side, see
    ``retract.to_lanes``).
    Products of unit quaternions drift from unit norm by rounding (attitude): renormalise after
    every update, for which q *= 1.5 - 0.5 |q|^2 is enough; else calls end in QNORM, in single
    precision after some hundred.
    Source: the error conventions of the blocks.
    """,
    RetractResult,
    (
        _STATE,
        Argument(
            "d",
            15,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "n", ("x", "y", "z")
                ),
                Domain(
                    "velocity",
                    3,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s",
                    "n",
                    ("x", "y", "z"),
                ),
                Domain(
                    "attitude",
                    6,
                    3,
                    Kind.REAL,
                    (-6.0,) * 3,
                    (6.0,) * 3,
                    "rad",
                    "n",
                    ("x", "y", "z"),
                ),
                Domain(
                    "accelerometer_bias",
                    9,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s^2",
                    "s",
                    ("x", "y", "z"),
                ),
                Domain(
                    "gyro_bias",
                    12,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s",
                    "s",
                    ("x", "y", "z"),
                ),
            ),
        ),
    ),
    (Output("value", (16,), tuple(range(16))),),
    lanes=32,
)


LOCAL = Signature(
    "local",
    """Error between two states.

        value = y (-) x, so that x (+) value = y

    Parameters
    ----------
    x : array_like, shape (..., 16)
        - [0:3] position (m, frame n, range [-1e9, 1e9])
        - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
        - [6:10] attitude (map s -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame s, range [-1, 1])
        - [13:16] gyro_bias (rad/s, frame s, range [-0.1, 0.1])
    y : array_like, shape (..., 16)
        - [0:3] position (m, frame n, range [-1e9, 1e9])
        - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
        - [6:10] attitude (map s -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame s, range [-1, 1])
        - [13:16] gyro_bias (rad/s, frame s, range [-0.1, 0.1])
    out : LocalResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    LocalResult
        value : array, shape (..., 15)
            Value of the equation.
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``local.value`` (value), ``local.bind`` (a call
    without arguments over the same arrays), ``local.blocks`` (epochs side by side, see
    ``local.to_lanes``).
    Source: the error conventions of the blocks.
    """,
    LocalResult,
    (
        _STATE,
        Argument(
            "y",
            16,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "n", ("x", "y", "z")
                ),
                Domain(
                    "velocity",
                    3,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s",
                    "n",
                    ("x", "y", "z"),
                ),
                Domain(
                    "attitude",
                    6,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "s -> n",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
                Domain(
                    "accelerometer_bias",
                    10,
                    3,
                    Kind.REAL,
                    (-1.0,) * 3,
                    (1.0,) * 3,
                    "m/s^2",
                    "s",
                    ("x", "y", "z"),
                ),
                Domain(
                    "gyro_bias",
                    13,
                    3,
                    Kind.REAL,
                    (-0.1,) * 3,
                    (0.1,) * 3,
                    "rad/s",
                    "s",
                    ("x", "y", "z"),
                ),
            ),
        ),
    ),
    (Output("value", (15,), tuple(range(15))),),
    lanes=32,
)


CALC_FORCE = Signature(
    "calc_force",
    """Specific force corrected for rotation and sculling.

        f = C (dv + c2 theta x dv + c3 theta x (theta x dv) + S) / dt

    Parameters
    ----------
    dcm : array_like, shape (..., 9)
        C, attitude of the body at the epoch; map s -> n, rotation matrix, row by row.
    delta_theta : array_like, shape (..., 3)
        Angle increments, oldest sub-sample first; rad, frame s, range [-0.5, 0.5]; elements x y
        z.
    delta_velocity : array_like, shape (..., 3)
        Velocity increments, oldest sub-sample first; m/s, frame s, range [-50, 50]; elements x
        y z.
    dt : array_like, shape (...)
        Length of the interval; s, range [1e-5, 0.05].
    out : CalcForceResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    CalcForceResult
        value : array, shape (..., 3), m/s^2, frame n
            Value of the equation.
        jacobian_dcm : array, shape (..., 3, 3)
            Derivative of the value by dcm.
            Columns: dcm[3].
        jacobian_delta_theta : array, shape (..., 3, 3)
            Derivative of the value by delta_theta.
            Columns: delta_theta[3].
        jacobian_delta_velocity : array, shape (..., 3, 3)
            Derivative of the value by delta_velocity.
            Columns: delta_velocity[3].
        jacobian_dt : array, shape (..., 3, 1)
            Derivative of the value by dt.
            Columns: dt[1].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``calc_force.value`` (value), ``calc_force.jacobian``
    (jacobian_dcm, jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt),
    ``calc_force.nonzeros`` (what is not zero by structure), ``calc_force.bind`` (a call without
    arguments over the same arrays), ``calc_force.blocks`` (epochs side by side, see
    ``calc_force.to_lanes``).
    Input: increments, raw, resolved in the body frame.
    The attitude is that at the start of the interval; rotation correction half, sculling none.
    Angles are with respect to inertial space; the rotation of the navigation frame over one
    interval is neglected.
    Output: specific force.
    Source: Savage 1998 part 2; Titterton and Weston 11.4; NavToolkit calc_force_ned.
    """,
    CalcForceResult,
    (
        Argument(
            "dcm",
            9,
            (
                Domain(
                    "dcm",
                    0,
                    9,
                    Kind.MATRIX,
                    (-1.00001,) * 9,
                    (1.00001,) * 9,
                    "1",
                    "s -> n",
                    ("00", "01", "02", "10", "11", "12", "20", "21", "22"),
                    1e-05,
                ),
            ),
        ),
        Argument(
            "delta_theta",
            3,
            (
                Domain(
                    "delta_theta",
                    0,
                    3,
                    Kind.REAL,
                    (-0.5,) * 3,
                    (0.5,) * 3,
                    "rad",
                    "s",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "delta_velocity",
            3,
            (
                Domain(
                    "delta_velocity",
                    0,
                    3,
                    Kind.REAL,
                    (-5e1,) * 3,
                    (5e1,) * 3,
                    "m/s",
                    "s",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "dt", 1, (Domain("dt", 0, 1, Kind.REAL, (1e-5,), (0.05,), "s", "", ("",)),), scalar=True
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output("jacobian_dcm", (3, 3), (1, 2, 3, 5, 6, 7)),
        Output("jacobian_delta_theta", (3, 3), tuple(range(9))),
        Output("jacobian_delta_velocity", (3, 3), tuple(range(9))),
        Output("jacobian_dt", (3, 1), (0, 1, 2)),
    ),
    lanes=32,
)


FORCE = Signature(
    "force",
    """Specific force corrected for rotation and sculling.

        f = C (dv + c2 theta x dv + c3 theta x (theta x dv) + S) / dt

    Parameters
    ----------
    x : array_like, shape (..., 16)
        - [0:3] position (m, frame n, not read)
        - [3:6] velocity (m/s, frame n, not read)
        - [6:10] attitude (map s -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame s, range [-1, 1])
        - [13:16] gyro_bias (rad/s, frame s, range [-0.1, 0.1])
    delta_theta : array_like, shape (..., 3)
        Angle increments, oldest sub-sample first; rad, frame s, range [-0.5, 0.5]; elements x y
        z.
    delta_velocity : array_like, shape (..., 3)
        Velocity increments, oldest sub-sample first; m/s, frame s, range [-50, 50]; elements x
        y z.
    dt : array_like, shape (...)
        Length of the interval; s, range [1e-5, 0.05].
    out : ForceResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    ForceResult
        value : array, shape (..., 3), m/s^2, frame n
            Value of the equation.
        jacobian : array, shape (..., 3, 15)
            Derivative of the value by the error of the state.
            Columns: position[3] velocity[3] attitude[3] accelerometer_bias[3] gyro_bias[3].
        jacobian_delta_theta : array, shape (..., 3, 3)
            Derivative of the value by delta_theta.
            Columns: delta_theta[3].
        jacobian_delta_velocity : array, shape (..., 3, 3)
            Derivative of the value by delta_velocity.
            Columns: delta_velocity[3].
        jacobian_dt : array, shape (..., 3, 1)
            Derivative of the value by dt.
            Columns: dt[1].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``force.value`` (value), ``force.jacobian`` (jacobian,
    jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt), ``force.nonzeros`` (what is not
    zero by structure), ``force.bind`` (a call without arguments over the same arrays),
    ``force.blocks`` (epochs side by side, see ``force.to_lanes``).
    Input: increments, raw, resolved in the body frame.
    The attitude is that at the start of the interval; rotation correction half, sculling none.
    Angles are with respect to inertial space; the rotation of the navigation frame over one
    interval is neglected.
    Output: specific force.
    Source: Savage 1998 part 2; Titterton and Weston 11.4; NavToolkit calc_force_ned.
    """,
    ForceResult,
    (
        Argument(
            "x",
            16,
            (
                Domain(
                    "position",
                    0,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m",
                    "n",
                    ("x", "y", "z"),
                ),
                Domain(
                    "velocity",
                    3,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s",
                    "n",
                    ("x", "y", "z"),
                ),
                Domain(
                    "attitude",
                    6,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "s -> n",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
                Domain(
                    "accelerometer_bias",
                    10,
                    3,
                    Kind.REAL,
                    (-1.0,) * 3,
                    (1.0,) * 3,
                    "m/s^2",
                    "s",
                    ("x", "y", "z"),
                ),
                Domain(
                    "gyro_bias",
                    13,
                    3,
                    Kind.REAL,
                    (-0.1,) * 3,
                    (0.1,) * 3,
                    "rad/s",
                    "s",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "delta_theta",
            3,
            (
                Domain(
                    "delta_theta",
                    0,
                    3,
                    Kind.REAL,
                    (-0.5,) * 3,
                    (0.5,) * 3,
                    "rad",
                    "s",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "delta_velocity",
            3,
            (
                Domain(
                    "delta_velocity",
                    0,
                    3,
                    Kind.REAL,
                    (-5e1,) * 3,
                    (5e1,) * 3,
                    "m/s",
                    "s",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "dt", 1, (Domain("dt", 0, 1, Kind.REAL, (1e-5,), (0.05,), "s", "", ("",)),), scalar=True
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output(
            "jacobian",
            (3, 15),
            (
                7, 8, 9, 10, 11, 12, 13, 14, 21, 23, 24, 25, 26, 27, 28, 29, 36, 37, 39, 40, 41, 42,
                43, 44,
            ),
        ),
        Output("jacobian_delta_theta", (3, 3), tuple(range(9))),
        Output("jacobian_delta_velocity", (3, 3), tuple(range(9))),
        Output("jacobian_dt", (3, 1), (0, 1, 2)),
    ),
    lanes=16,
)


class StateBlocks(NamedTuple):
    """The blocks of the state of ``navtk_specific_force``."""

    position: Array
    velocity: Array
    attitude: Array
    accelerometer_bias: Array
    gyro_bias: Array


_BLOCKS = (
    Block(
        "position",
        ("x", "y", "z"),
        "m",
        "n",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m",
        "n",
        "additive, true minus estimate",
    ),
    Block(
        "velocity",
        ("x", "y", "z"),
        "m/s",
        "n",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m/s",
        "n",
        "additive, true minus estimate",
    ),
    Block(
        "attitude",
        ("w", "x", "y", "z"),
        "1",
        "s -> n",
        (1.0, 0.0, 0.0, 0.0),
        ("x", "y", "z"),
        "rad",
        "n",
        "Exp(-d) R",
    ),
    Block(
        "accelerometer_bias",
        ("x", "y", "z"),
        "m/s^2",
        "s",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m/s^2",
        "s",
        "additive, true minus estimate",
    ),
    Block(
        "gyro_bias",
        ("x", "y", "z"),
        "rad/s",
        "s",
        (0.0,) * 3,
        ("x", "y", "z"),
        "rad/s",
        "s",
        "additive, true minus estimate",
    ),
)

_DIGEST = "820d47b4be86c618316e745919cd0013d620e9534a7cfb2acc56786b1eca9d8b"
