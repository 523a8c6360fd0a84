"""What the functions and the state of ``rover`` look like; data only."""

from __future__ import annotations

from typing import Any, NamedTuple

from ._runtime import Argument, Array, Condition, Domain, Kind, Output, Signature, Status
from ._state import Block


class RetractResult(NamedTuple):
    """What ``retract`` returns."""

    value: Array
    """Value of the equation; shape (..., 22)."""
    status: Any


class LocalResult(NamedTuple):
    """What ``local`` returns."""

    value: Array
    """Value of the equation; shape (..., 21)."""
    status: Any


class GpsResult(NamedTuple):
    """What ``gps`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 21)."""
    status: Any


class RangeResult(NamedTuple):
    """What ``range`` returns."""

    value: Array
    """Value of the equation; shape (..., n)."""
    residual: Array
    """Measured less predicted value; shape (..., n)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., n, 21)."""
    status: Any
    item_status: Array


class ImuResult(NamedTuple):
    """What ``imu`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 21)."""
    status: Any


_STATE = Argument(
    "x",
    22,
    (
        Domain("position", 0, 3, Kind.REAL, (-1e5,) * 3, (1e5,) * 3, "m", "n", ("x", "y", "z")),
        Domain("velocity", 3, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s", "n", ("x", "y", "z")),
        Domain(
            "attitude",
            6,
            4,
            Kind.QUATERNION,
            (-1.00001,) * 4,
            (1.00001,) * 4,
            "1",
            "b -> n",
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
            "b",
            ("x", "y", "z"),
        ),
        Domain(
            "gyro_bias", 13, 3, Kind.REAL, (-0.1,) * 3, (0.1,) * 3, "rad/s", "b", ("x", "y", "z")
        ),
        Domain("antenna", 16, 3, Kind.REAL, (-1e1,) * 3, (1e1,) * 3, "m", "b", ("x", "y", "z")),
        Domain("b_gps", 19, 1, Kind.REAL, (-1e6,), (1e6,), "m", "", ("",)),
        Domain("b_galileo", 20, 1, Kind.REAL, (-1e6,), (1e6,), "m", "", ("",)),
        Domain("drift", 21, 1, Kind.REAL, (-1e9,), (1e9,), "m/s", "", ("",)),
    ),
)


RETRACT = Signature(
    "retract",
    """State moved by an error.

        value = x (+) d

    Parameters
    ----------
    x : array_like, shape (..., 22)
        - [0:3] position (m, frame n, range [-100000, 100000])
        - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
        - [6:10] attitude (map b -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame b, range [-1, 1])
        - [13:16] gyro_bias (rad/s, frame b, range [-0.1, 0.1])
        - [16:19] antenna (m, frame b, range [-10, 10])
        - [19] b_gps (m, range [-1e6, 1e6])
        - [20] b_galileo (m, range [-1e6, 1e6])
        - [21] drift (m/s, range [-1e9, 1e9])
    d : array_like, shape (..., 21)
        - [0:3] position (m, frame n, range [-1e9, 1e9]): Error of position
        - [3:6] velocity (m/s, frame n, range [-1e9, 1e9]): Error of velocity
        - [6:9] attitude (rad, frame b, range [-6, 6]): Error of attitude
        - [9:12] accelerometer_bias (m/s^2, frame b, range [-1e9, 1e9]): Error of
          accelerometer_bias
        - [12:15] gyro_bias (rad/s, frame b, range [-1e9, 1e9]): Error of gyro_bias
        - [15:18] antenna (m, frame b, range [-1e9, 1e9]): Error of antenna
        - [18] b_gps (m, range [-1e9, 1e9]): Error of b_gps
        - [19] b_galileo (m, range [-1e9, 1e9]): Error of b_galileo
        - [20] drift (m/s, range [-1e9, 1e9]): Error of drift
    out : RetractResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    RetractResult
        value : array, shape (..., 22)
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
            21,
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
                    "b",
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
                    "b",
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
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna", 15, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "b", ("x", "y", "z")
                ),
                Domain("b_gps", 18, 1, Kind.REAL, (-1e9,), (1e9,), "m", "", ("",)),
                Domain("b_galileo", 19, 1, Kind.REAL, (-1e9,), (1e9,), "m", "", ("",)),
                Domain("drift", 20, 1, Kind.REAL, (-1e9,), (1e9,), "m/s", "", ("",)),
            ),
        ),
    ),
    (Output("value", (22,), tuple(range(22))),),
    lanes=16,
)


LOCAL = Signature(
    "local",
    """Error between two states.

        value = y (-) x, so that x (+) value = y

    Parameters
    ----------
    x : array_like, shape (..., 22)
        - [0:3] position (m, frame n, range [-100000, 100000])
        - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
        - [6:10] attitude (map b -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame b, range [-1, 1])
        - [13:16] gyro_bias (rad/s, frame b, range [-0.1, 0.1])
        - [16:19] antenna (m, frame b, range [-10, 10])
        - [19] b_gps (m, range [-1e6, 1e6])
        - [20] b_galileo (m, range [-1e6, 1e6])
        - [21] drift (m/s, range [-1e9, 1e9])
    y : array_like, shape (..., 22)
        - [0:3] position (m, frame n, range [-100000, 100000])
        - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
        - [6:10] attitude (map b -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame b, range [-1, 1])
        - [13:16] gyro_bias (rad/s, frame b, range [-0.1, 0.1])
        - [16:19] antenna (m, frame b, range [-10, 10])
        - [19] b_gps (m, range [-1e6, 1e6])
        - [20] b_galileo (m, range [-1e6, 1e6])
        - [21] drift (m/s, range [-1e9, 1e9])
    out : LocalResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    LocalResult
        value : array, shape (..., 21)
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
            22,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e5,) * 3, (1e5,) * 3, "m", "n", ("x", "y", "z")
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
                    "b -> n",
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
                    "b",
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
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna", 16, 3, Kind.REAL, (-1e1,) * 3, (1e1,) * 3, "m", "b", ("x", "y", "z")
                ),
                Domain("b_gps", 19, 1, Kind.REAL, (-1e6,), (1e6,), "m", "", ("",)),
                Domain("b_galileo", 20, 1, Kind.REAL, (-1e6,), (1e6,), "m", "", ("",)),
                Domain("drift", 21, 1, Kind.REAL, (-1e9,), (1e9,), "m/s", "", ("",)),
            ),
        ),
    ),
    (Output("value", (21,), tuple(range(21))),),
    lanes=16,
)


GPS = Signature(
    "gps",
    """Position of a GNSS antenna.

        z = origin + C (offset + p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 22)
        - [0:3] position (m, frame n, range [-100000, 100000])
        - [3:6] velocity (m/s, frame n, not read)
        - [6:10] attitude (map b -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame b, not read)
        - [13:16] gyro_bias (rad/s, frame b, not read)
        - [16:19] antenna (m, frame b, range [-10, 10])
        - [19] b_gps (m, not read)
        - [20] b_galileo (m, not read)
        - [21] drift (m/s, not read)
    out : GpsResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    GpsResult
        value : array, shape (..., 3), m, frame n
            Value of the equation.
        jacobian : array, shape (..., 3, 21)
            Derivative of the value by the error of the state.
            Columns: position[3] velocity[3] attitude[3] accelerometer_bias[3] gyro_bias[3]
            antenna[3] b_gps[1] b_galileo[1] drift[1].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``gps.value`` (value), ``gps.jacobian`` (jacobian),
    ``gps.nonzeros`` (what is not zero by structure), ``gps.bind`` (a call without arguments
    over the same arrays), ``gps.blocks`` (epochs side by side, see ``gps.to_lanes``).
    The lever arm points from the body origin to the antenna, resolved in the body frame.
    C and R are used in the direction their declared maps and the frames of the vectors need.
    Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
    """,
    GpsResult,
    (
        Argument(
            "x",
            22,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e5,) * 3, (1e5,) * 3, "m", "n", ("x", "y", "z")
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
                    "b -> n",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
                Domain(
                    "accelerometer_bias",
                    10,
                    3,
                    Kind.UNREAD,
                    (-1.0,) * 3,
                    (1.0,) * 3,
                    "m/s^2",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "gyro_bias",
                    13,
                    3,
                    Kind.UNREAD,
                    (-0.1,) * 3,
                    (0.1,) * 3,
                    "rad/s",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna", 16, 3, Kind.REAL, (-1e1,) * 3, (1e1,) * 3, "m", "b", ("x", "y", "z")
                ),
                Domain("b_gps", 19, 1, Kind.UNREAD, (-1e6,), (1e6,), "m", "", ("",)),
                Domain("b_galileo", 20, 1, Kind.UNREAD, (-1e6,), (1e6,), "m", "", ("",)),
                Domain("drift", 21, 1, Kind.UNREAD, (-1e9,), (1e9,), "m/s", "", ("",)),
            ),
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output(
            "jacobian",
            (3, 21),
            (0, 6, 7, 8, 15, 16, 17, 22, 27, 28, 29, 36, 37, 38, 44, 48, 49, 50, 57, 58, 59),
        ),
    ),
    lanes=32,
)


RANGE = Signature(
    "range",
    """Pseudoranges from the antenna to satellites.

        rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 22)
        - [0:3] position (m, frame n, range [-100000, 100000])
        - [3:6] velocity (m/s, frame n, not read)
        - [6:10] attitude (map b -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame b, not read)
        - [13:16] gyro_bias (rad/s, frame b, not read)
        - [16:19] antenna (m, frame b, range [-10, 10])
        - [19] b_gps (m, range [-1e6, 1e6])
        - [20] b_galileo (m, range [-1e6, 1e6])
        - [21] drift (m/s, not read)
    nav_to_ecef : array_like, shape (..., 4)
        Attitude of the navigation frame in the earth-fixed frame; map n -> ecef, unit
        quaternion w x y z.
    origin : array_like, shape (..., 3)
        Origin of the navigation frame, earth-fixed; m, frame ecef, range [-1e8, 1e8]; elements
        x y z.
    system : integers, shape (..., n)
        Satellite system: 0 gps, 1 galileo; range [0, 1].
    satellite_position : array_like, shape (..., n, 3)
        Satellite, earth-fixed; m, frame ecef, range [-1e8, 1e8]; elements x y z.
    satellite_clock : array_like, shape (..., n)
        Satellite clock offset; s, range [-0.1, 0.1].
    troposphere : array_like, shape (..., n)
        Tropospheric delay; m, range [-100, 1000].
    ionosphere : array_like, shape (..., n)
        Ionospheric delay; m, range [-1000, 1000].
    measured : array_like, shape (..., n)
        Measured value; m, range [-1e9, 1e9].
    out : RangeResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    RangeResult
        value : array, shape (..., n), m
            Value of the equation.
        residual : array, shape (..., n), m
            Measured less predicted value.
        jacobian : array, shape (..., n, 21)
            Derivative of the value by the error of the state.
            Columns: position[3] velocity[3] attitude[3] accelerometer_bias[3] gyro_bias[3]
            antenna[3] b_gps[1] b_galileo[1] drift[1].
        status : Status for one epoch, array of them over leading axes
        item_status : array, shape (..., n)
            Status of every item; one that fails has zero rows and makes its epoch PARTIAL.

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``range.value`` (value, residual), ``range.jacobian``
    (jacobian), ``range.nonzeros`` (what is not zero by structure), ``range.bind`` (a call
    without arguments over the same arrays).
    At most 32 items.
    h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of
    the range by the antenna position.
    Earth rotation by the first-order term (w/c)(s_x a_y - s_y a_x); the satellite is given in
    the axes at transmission.
    A positive receiver clock bias and every delay lengthen the pseudorange; a positive
    satellite clock shortens it.
    Source: Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3.
    """,
    RangeResult,
    (
        Argument(
            "x",
            22,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e5,) * 3, (1e5,) * 3, "m", "n", ("x", "y", "z")
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
                    "b -> n",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
                Domain(
                    "accelerometer_bias",
                    10,
                    3,
                    Kind.UNREAD,
                    (-1.0,) * 3,
                    (1.0,) * 3,
                    "m/s^2",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "gyro_bias",
                    13,
                    3,
                    Kind.UNREAD,
                    (-0.1,) * 3,
                    (0.1,) * 3,
                    "rad/s",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna", 16, 3, Kind.REAL, (-1e1,) * 3, (1e1,) * 3, "m", "b", ("x", "y", "z")
                ),
                Domain("b_gps", 19, 1, Kind.REAL, (-1e6,), (1e6,), "m", "", ("",)),
                Domain("b_galileo", 20, 1, Kind.REAL, (-1e6,), (1e6,), "m", "", ("",)),
                Domain("drift", 21, 1, Kind.UNREAD, (-1e9,), (1e9,), "m/s", "", ("",)),
            ),
        ),
        Argument(
            "nav_to_ecef",
            4,
            (
                Domain(
                    "nav_to_ecef",
                    0,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "n -> ecef",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
            ),
        ),
        Argument(
            "origin",
            3,
            (
                Domain(
                    "origin", 0, 3, Kind.REAL, (-1e8,) * 3, (1e8,) * 3, "m", "ecef", ("x", "y", "z")
                ),
            ),
        ),
        Argument(
            "system",
            1,
            (Domain("system", 0, 1, Kind.INTEGER, (0.0,), (1.0,), "1", "", ("",)),),
            item=True,
            integer=True,
            scalar=True,
        ),
        Argument(
            "satellite_position",
            3,
            (
                Domain(
                    "satellite_position",
                    0,
                    3,
                    Kind.REAL,
                    (-1e8,) * 3,
                    (1e8,) * 3,
                    "m",
                    "ecef",
                    ("x", "y", "z"),
                ),
            ),
            item=True,
        ),
        Argument(
            "satellite_clock",
            1,
            (Domain("satellite_clock", 0, 1, Kind.REAL, (-0.1,), (0.1,), "s", "", ("",)),),
            item=True,
            scalar=True,
        ),
        Argument(
            "troposphere",
            1,
            (Domain("troposphere", 0, 1, Kind.REAL, (-1e2,), (1e3,), "m", "", ("",)),),
            item=True,
            scalar=True,
        ),
        Argument(
            "ionosphere",
            1,
            (Domain("ionosphere", 0, 1, Kind.REAL, (-1e3,), (1e3,), "m", "", ("",)),),
            item=True,
            scalar=True,
        ),
        Argument(
            "measured",
            1,
            (Domain("measured", 0, 1, Kind.REAL, (-1e9,), (1e9,), "m", "", ("",)),),
            item=True,
            scalar=True,
        ),
    ),
    (
        Output("value", (), (0,), item=True),
        Output("residual", (), (0,), item=True),
        Output("jacobian", (21,), (0, 1, 2, 6, 7, 8, 15, 16, 17, 18, 19), item=True),
    ),
    conditions=(Condition(Status.DOMAIN, 1e-12, 1e30, "squared range"),),
    maximum=32,
)


IMU = Signature(
    "imu",
    """Specific force corrected for rotation and sculling.

        f = C (dv + c2 theta x dv + c3 theta x (theta x dv) + S) / dt

    Parameters
    ----------
    x : array_like, shape (..., 22)
        - [0:3] position (m, frame n, not read)
        - [3:6] velocity (m/s, frame n, not read)
        - [6:10] attitude (map b -> n, unit quaternion w x y z)
        - [10:13] accelerometer_bias (m/s^2, frame b, range [-1, 1])
        - [13:16] gyro_bias (rad/s, frame b, range [-0.1, 0.1])
        - [16:19] antenna (m, frame b, not read)
        - [19] b_gps (m, not read)
        - [20] b_galileo (m, not read)
        - [21] drift (m/s, not read)
    delta_theta : array_like, shape (..., 6)
        Angle increments, oldest sub-sample first; rad, frame b, range [-0.5, 0.5].
    delta_velocity : array_like, shape (..., 6)
        Velocity increments, oldest sub-sample first; m/s, frame b, range [-50, 50].
    dt : array_like, shape (...)
        Length of the interval; s, range [1e-5, 0.05].
    out : ImuResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    ImuResult
        value : array, shape (..., 3), m/s^2, frame n
            Value of the equation.
        jacobian : array, shape (..., 3, 21)
            Derivative of the value by the error of the state.
            Columns: position[3] velocity[3] attitude[3] accelerometer_bias[3] gyro_bias[3]
            antenna[3] b_gps[1] b_galileo[1] drift[1].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``imu.value`` (value), ``imu.jacobian`` (jacobian),
    ``imu.nonzeros`` (what is not zero by structure), ``imu.bind`` (a call without arguments
    over the same arrays), ``imu.blocks`` (epochs side by side, see ``imu.to_lanes``).
    Input: increments, raw, resolved in the body frame.
    The attitude is that at the start of the interval; rotation correction half, sculling
    polynomial.
    Angles are with respect to inertial space; the rotation of the navigation frame over one
    interval is neglected.
    Output: specific force.
    Source: Savage 1998 part 2; Titterton and Weston 11.4; NavToolkit calc_force_ned.
    """,
    ImuResult,
    (
        Argument(
            "x",
            22,
            (
                Domain(
                    "position",
                    0,
                    3,
                    Kind.UNREAD,
                    (-1e5,) * 3,
                    (1e5,) * 3,
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
                    "b -> n",
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
                    "b",
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
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "antenna",
                    16,
                    3,
                    Kind.UNREAD,
                    (-1e1,) * 3,
                    (1e1,) * 3,
                    "m",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain("b_gps", 19, 1, Kind.UNREAD, (-1e6,), (1e6,), "m", "", ("",)),
                Domain("b_galileo", 20, 1, Kind.UNREAD, (-1e6,), (1e6,), "m", "", ("",)),
                Domain("drift", 21, 1, Kind.UNREAD, (-1e9,), (1e9,), "m/s", "", ("",)),
            ),
        ),
        Argument(
            "delta_theta",
            6,
            (
                Domain(
                    "delta_theta",
                    0,
                    6,
                    Kind.REAL,
                    (-0.5,) * 6,
                    (0.5,) * 6,
                    "rad",
                    "b",
                    ("0", "1", "2", "3", "4", "5"),
                ),
            ),
        ),
        Argument(
            "delta_velocity",
            6,
            (
                Domain(
                    "delta_velocity",
                    0,
                    6,
                    Kind.REAL,
                    (-5e1,) * 6,
                    (5e1,) * 6,
                    "m/s",
                    "b",
                    ("0", "1", "2", "3", "4", "5"),
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
            (3, 21),
            (
                6, 7, 8, 9, 10, 11, 12, 13, 14, 27, 28, 29, 30, 31, 32, 33, 34, 35, 48, 49, 50, 51,
                52, 53, 54, 55, 56,
            ),
        ),
    ),
    lanes=16,
)


class StateBlocks(NamedTuple):
    """The blocks of the state of ``rover``."""

    position: Array
    velocity: Array
    attitude: Array
    accelerometer_bias: Array
    gyro_bias: Array
    antenna: Array
    b_gps: Array
    b_galileo: Array
    drift: Array


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
        "b -> n",
        (1.0, 0.0, 0.0, 0.0),
        ("x", "y", "z"),
        "rad",
        "b",
        "R Exp(d)",
    ),
    Block(
        "accelerometer_bias",
        ("x", "y", "z"),
        "m/s^2",
        "b",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m/s^2",
        "b",
        "additive, true minus estimate",
    ),
    Block(
        "gyro_bias",
        ("x", "y", "z"),
        "rad/s",
        "b",
        (0.0,) * 3,
        ("x", "y", "z"),
        "rad/s",
        "b",
        "additive, true minus estimate",
    ),
    Block(
        "antenna",
        ("x", "y", "z"),
        "m",
        "b",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m",
        "b",
        "additive, true minus estimate",
    ),
    Block("b_gps", ("",), "m", "", (0.0,), ("",), "m", "", "additive, true minus estimate"),
    Block("b_galileo", ("",), "m", "", (0.0,), ("",), "m", "", "additive, true minus estimate"),
    Block("drift", ("",), "m/s", "", (0.0,), ("",), "m/s", "", "additive, true minus estimate"),
)

_DIGEST = "3394c738509a87af0db352f63f4a813139ccb2f97625d2e404618fbe7e5eddcb"
