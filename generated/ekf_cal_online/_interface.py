"""What the functions and the state of ``ekf_cal_online`` look like; data only."""

from __future__ import annotations

from typing import Any, NamedTuple

from ._runtime import Argument, Array, Domain, Kind, Output, Signature
from ._state import Block


class RetractResult(NamedTuple):
    """What ``retract`` returns."""

    value: Array
    """Value of the equation; shape (..., 26)."""
    status: Any


class LocalResult(NamedTuple):
    """What ``local`` returns."""

    value: Array
    """Value of the equation; shape (..., 25)."""
    status: Any


class Gps1Result(NamedTuple):
    """What ``gps_1`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    residual: Array
    """Measured less predicted value; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 25)."""
    jacobian_origin: Array
    """Derivative of the value by origin; shape (..., 3, 3)."""
    status: Any


class Gps2Result(NamedTuple):
    """What ``gps_2`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    residual: Array
    """Measured less predicted value; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 25)."""
    jacobian_origin: Array
    """Derivative of the value by origin; shape (..., 3, 3)."""
    status: Any


_STATE = Argument(
    "x",
    26,
    (
        Domain("position", 0, 3, Kind.REAL, (-1e6,) * 3, (1e6,) * 3, "m", "l", ("x", "y", "z")),
        Domain("velocity", 3, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s", "l", ("x", "y", "z")),
        Domain(
            "acceleration", 6, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s^2", "l", ("x", "y", "z")
        ),
        Domain(
            "attitude",
            9,
            4,
            Kind.QUATERNION,
            (-1.00001,) * 4,
            (1.00001,) * 4,
            "1",
            "b -> l",
            ("w", "x", "y", "z"),
            1e-05,
        ),
        Domain(
            "angular_rate", 13, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "rad/s", "l", ("x", "y", "z")
        ),
        Domain(
            "angular_acceleration",
            16,
            3,
            Kind.REAL,
            (-1e9,) * 3,
            (1e9,) * 3,
            "rad/s^2",
            "l",
            ("x", "y", "z"),
        ),
        Domain("heading", 19, 1, Kind.REAL, (-3.1416,), (3.1416,), "rad", "g -> l", ("",)),
        Domain("antenna_1", 20, 3, Kind.REAL, (-5e1,) * 3, (5e1,) * 3, "m", "b", ("x", "y", "z")),
        Domain("antenna_2", 23, 3, Kind.REAL, (-5e1,) * 3, (5e1,) * 3, "m", "b", ("x", "y", "z")),
    ),
)


RETRACT = Signature(
    "retract",
    """State moved by an error.

        value = x (+) d

    Parameters
    ----------
    x : array_like, shape (..., 26)
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
        - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
        - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
        - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
        - [20:23] antenna_1 (m, frame b, range [-50, 50])
        - [23:26] antenna_2 (m, frame b, range [-50, 50])
    d : array_like, shape (..., 25)
        - [0:3] position (m, frame l, range [-1e9, 1e9]): Error of position
        - [3:6] velocity (m/s, frame l, range [-1e9, 1e9]): Error of velocity
        - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9]): Error of acceleration
        - [9:12] attitude (rad, frame b, range [-6, 6]): Error of attitude
        - [12:15] angular_rate (rad/s, frame l, range [-1e9, 1e9]): Error of angular_rate
        - [15:18] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9]): Error of
          angular_acceleration
        - [18] heading (rad, range [-6, 6]): Error of heading
        - [19:22] antenna_1 (m, frame b, range [-1e9, 1e9]): Error of antenna_1
        - [22:25] antenna_2 (m, frame b, range [-1e9, 1e9]): Error of antenna_2
    out : RetractResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    RetractResult
        value : array, shape (..., 26)
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
            25,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "l", ("x", "y", "z")
                ),
                Domain(
                    "velocity",
                    3,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "acceleration",
                    6,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s^2",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "attitude",
                    9,
                    3,
                    Kind.REAL,
                    (-6.0,) * 3,
                    (6.0,) * 3,
                    "rad",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "angular_rate",
                    12,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "angular_acceleration",
                    15,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s^2",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain("heading", 18, 1, Kind.REAL, (-6.0,), (6.0,), "rad", "", ("",)),
                Domain(
                    "antenna_1",
                    19,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna_2",
                    22,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
            ),
        ),
    ),
    (Output("value", (26,), tuple(range(26))),),
    lanes=16,
)


LOCAL = Signature(
    "local",
    """Error between two states.

        value = y (-) x, so that x (+) value = y

    Parameters
    ----------
    x : array_like, shape (..., 26)
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
        - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
        - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
        - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
        - [20:23] antenna_1 (m, frame b, range [-50, 50])
        - [23:26] antenna_2 (m, frame b, range [-50, 50])
    y : array_like, shape (..., 26)
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
        - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
        - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
        - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
        - [20:23] antenna_1 (m, frame b, range [-50, 50])
        - [23:26] antenna_2 (m, frame b, range [-50, 50])
    out : LocalResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    LocalResult
        value : array, shape (..., 25)
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
            26,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e6,) * 3, (1e6,) * 3, "m", "l", ("x", "y", "z")
                ),
                Domain(
                    "velocity",
                    3,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "acceleration",
                    6,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s^2",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "attitude",
                    9,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "b -> l",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
                Domain(
                    "angular_rate",
                    13,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "angular_acceleration",
                    16,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s^2",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain("heading", 19, 1, Kind.REAL, (-3.1416,), (3.1416,), "rad", "g -> l", ("",)),
                Domain(
                    "antenna_1",
                    20,
                    3,
                    Kind.REAL,
                    (-5e1,) * 3,
                    (5e1,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna_2",
                    23,
                    3,
                    Kind.REAL,
                    (-5e1,) * 3,
                    (5e1,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
            ),
        ),
    ),
    (Output("value", (25,), tuple(range(25))),),
    lanes=16,
)


GPS_1 = Signature(
    "gps_1",
    """Position of a GNSS antenna.

        z = origin + C (offset + p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 26)
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, not read)
        - [6:9] acceleration (m/s^2, frame l, not read)
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, not read)
        - [16:19] angular_acceleration (rad/s^2, frame l, not read)
        - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
        - [20:23] antenna_1 (m, frame b, range [-50, 50])
        - [23:26] antenna_2 (m, frame b, not read)
    origin : array_like, shape (..., 3)
        Position of the local frame's origin in the observer's frame (p_L^G); m, frame g, range
        [-1e7, 1e7]; elements x y z.
    measured : array_like, shape (..., 3)
        Measured value; m, frame g, range [-1e9, 1e9]; elements x y z.
    out : Gps1Result, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    Gps1Result
        value : array, shape (..., 3), m, frame g
            Value of the equation.
        residual : array, shape (..., 3), m, frame g
            Measured less predicted value.
        jacobian : array, shape (..., 3, 25)
            Derivative of the value by the error of the state.
            Columns: position[3] velocity[3] acceleration[3] attitude[3] angular_rate[3]
            angular_acceleration[3] heading[1] antenna_1[3] antenna_2[3].
        jacobian_origin : array, shape (..., 3, 3)
            Derivative of the value by origin.
            Columns: origin[3].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``gps_1.value`` (value, residual), ``gps_1.jacobian``
    (jacobian, jacobian_origin), ``gps_1.nonzeros`` (what is not zero by structure),
    ``gps_1.bind`` (a call without arguments over the same arrays), ``gps_1.blocks`` (epochs
    side by side, see ``gps_1.to_lanes``).
    The lever arm points from the body origin to the antenna, resolved in the body frame.
    C and R are used in the direction their declared maps and the frames of the vectors need.
    Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
    """,
    Gps1Result,
    (
        Argument(
            "x",
            26,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e6,) * 3, (1e6,) * 3, "m", "l", ("x", "y", "z")
                ),
                Domain(
                    "velocity",
                    3,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "acceleration",
                    6,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s^2",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "attitude",
                    9,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "b -> l",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
                Domain(
                    "angular_rate",
                    13,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "angular_acceleration",
                    16,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s^2",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain("heading", 19, 1, Kind.REAL, (-3.1416,), (3.1416,), "rad", "g -> l", ("",)),
                Domain(
                    "antenna_1",
                    20,
                    3,
                    Kind.REAL,
                    (-5e1,) * 3,
                    (5e1,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna_2",
                    23,
                    3,
                    Kind.UNREAD,
                    (-5e1,) * 3,
                    (5e1,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "origin",
            3,
            (
                Domain(
                    "origin", 0, 3, Kind.REAL, (-1e7,) * 3, (1e7,) * 3, "m", "g", ("x", "y", "z")
                ),
            ),
        ),
        Argument(
            "measured",
            3,
            (
                Domain(
                    "measured", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "g", ("x", "y", "z")
                ),
            ),
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output("residual", (3,), (0, 1, 2)),
        Output(
            "jacobian",
            (3, 25),
            (
                0, 1, 9, 10, 11, 18, 19, 20, 21, 25, 26, 34, 35, 36, 43, 44, 45, 46, 52, 59, 60, 61,
                69, 70, 71,
            ),
        ),
        Output("jacobian_origin", (3, 3), (0, 4, 8)),
    ),
    lanes=16,
)


GPS_2 = Signature(
    "gps_2",
    """Position of a GNSS antenna.

        z = origin + C (offset + p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 26)
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, not read)
        - [6:9] acceleration (m/s^2, frame l, not read)
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, not read)
        - [16:19] angular_acceleration (rad/s^2, frame l, not read)
        - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
        - [20:23] antenna_1 (m, frame b, not read)
        - [23:26] antenna_2 (m, frame b, range [-50, 50])
    origin : array_like, shape (..., 3)
        Position of the local frame's origin in the observer's frame (p_L^G); m, frame g, range
        [-1e7, 1e7]; elements x y z.
    measured : array_like, shape (..., 3)
        Measured value; m, frame g, range [-1e9, 1e9]; elements x y z.
    out : Gps2Result, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    Gps2Result
        value : array, shape (..., 3), m, frame g
            Value of the equation.
        residual : array, shape (..., 3), m, frame g
            Measured less predicted value.
        jacobian : array, shape (..., 3, 25)
            Derivative of the value by the error of the state.
            Columns: position[3] velocity[3] acceleration[3] attitude[3] angular_rate[3]
            angular_acceleration[3] heading[1] antenna_1[3] antenna_2[3].
        jacobian_origin : array, shape (..., 3, 3)
            Derivative of the value by origin.
            Columns: origin[3].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``gps_2.value`` (value, residual), ``gps_2.jacobian``
    (jacobian, jacobian_origin), ``gps_2.nonzeros`` (what is not zero by structure),
    ``gps_2.bind`` (a call without arguments over the same arrays), ``gps_2.blocks`` (epochs
    side by side, see ``gps_2.to_lanes``).
    The lever arm points from the body origin to the antenna, resolved in the body frame.
    C and R are used in the direction their declared maps and the frames of the vectors need.
    Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
    """,
    Gps2Result,
    (
        Argument(
            "x",
            26,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e6,) * 3, (1e6,) * 3, "m", "l", ("x", "y", "z")
                ),
                Domain(
                    "velocity",
                    3,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "acceleration",
                    6,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s^2",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "attitude",
                    9,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "b -> l",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
                Domain(
                    "angular_rate",
                    13,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain(
                    "angular_acceleration",
                    16,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s^2",
                    "l",
                    ("x", "y", "z"),
                ),
                Domain("heading", 19, 1, Kind.REAL, (-3.1416,), (3.1416,), "rad", "g -> l", ("",)),
                Domain(
                    "antenna_1",
                    20,
                    3,
                    Kind.UNREAD,
                    (-5e1,) * 3,
                    (5e1,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna_2",
                    23,
                    3,
                    Kind.REAL,
                    (-5e1,) * 3,
                    (5e1,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "origin",
            3,
            (
                Domain(
                    "origin", 0, 3, Kind.REAL, (-1e7,) * 3, (1e7,) * 3, "m", "g", ("x", "y", "z")
                ),
            ),
        ),
        Argument(
            "measured",
            3,
            (
                Domain(
                    "measured", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "g", ("x", "y", "z")
                ),
            ),
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output("residual", (3,), (0, 1, 2)),
        Output(
            "jacobian",
            (3, 25),
            (
                0, 1, 9, 10, 11, 18, 22, 23, 24, 25, 26, 34, 35, 36, 43, 47, 48, 49, 52, 59, 60, 61,
                72, 73, 74,
            ),
        ),
        Output("jacobian_origin", (3, 3), (0, 4, 8)),
    ),
    lanes=16,
)


class StateBlocks(NamedTuple):
    """The blocks of the state of ``ekf_cal_online``."""

    position: Array
    velocity: Array
    acceleration: Array
    attitude: Array
    angular_rate: Array
    angular_acceleration: Array
    heading: Array
    antenna_1: Array
    antenna_2: Array


_BLOCKS = (
    Block(
        "position",
        ("x", "y", "z"),
        "m",
        "l",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m",
        "l",
        "additive, true minus estimate",
    ),
    Block(
        "velocity",
        ("x", "y", "z"),
        "m/s",
        "l",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m/s",
        "l",
        "additive, true minus estimate",
    ),
    Block(
        "acceleration",
        ("x", "y", "z"),
        "m/s^2",
        "l",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m/s^2",
        "l",
        "additive, true minus estimate",
    ),
    Block(
        "attitude",
        ("w", "x", "y", "z"),
        "1",
        "b -> l",
        (1.0, 0.0, 0.0, 0.0),
        ("x", "y", "z"),
        "rad",
        "b",
        "R Exp(d)",
    ),
    Block(
        "angular_rate",
        ("x", "y", "z"),
        "rad/s",
        "l",
        (0.0,) * 3,
        ("x", "y", "z"),
        "rad/s",
        "l",
        "additive, true minus estimate",
    ),
    Block(
        "angular_acceleration",
        ("x", "y", "z"),
        "rad/s^2",
        "l",
        (0.0,) * 3,
        ("x", "y", "z"),
        "rad/s^2",
        "l",
        "additive, true minus estimate",
    ),
    Block(
        "heading",
        ("",),
        "rad",
        "g -> l",
        (0.0,),
        ("",),
        "rad",
        "",
        "additive, wrapped to (-pi, pi] up to rounding",
    ),
    Block(
        "antenna_1",
        ("x", "y", "z"),
        "m",
        "b",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m",
        "b",
        "additive, true minus estimate",
    ),
    Block(
        "antenna_2",
        ("x", "y", "z"),
        "m",
        "b",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m",
        "b",
        "additive, true minus estimate",
    ),
)

_DIGEST = "d0198d42929b59855018f9b95c2e79883b56a19f65f728bac4449b8380e94d1a"
