"""What the functions and the state of ``ekf_cal_gps`` look like; data only."""

from __future__ import annotations

from typing import Any, NamedTuple

from ._runtime import Argument, Array, Domain, Kind, Output, Signature
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
    residual: Array
    """Measured less predicted value; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 21)."""
    status: Any


class GpsKnownAntennaResult(NamedTuple):
    """What ``gps_known_antenna`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    residual: Array
    """Measured less predicted value; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 21)."""
    status: Any


class LocalFixResult(NamedTuple):
    """What ``local_fix`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian_fix: Array
    """Derivative of the value by fix; shape (..., 3, 3)."""
    value_covariance: Array
    """Covariance of the value, row-major; shape (..., 9)."""
    status: Any


_STATE = Argument(
    "x",
    22,
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
        Domain("antenna", 19, 3, Kind.REAL, (-5e1,) * 3, (5e1,) * 3, "m", "b", ("x", "y", "z")),
    ),
)


RETRACT = Signature(
    "retract",
    """State moved by an error.

        value = x (+) d

    Parameters
    ----------
    x : array_like, shape (..., 22)
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
        - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
        - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
        - [19:22] antenna (m, frame b, range [-50, 50])
    d : array_like, shape (..., 21)
        - [0:3] position (m, frame l, range [-1e9, 1e9]): Error of position
        - [3:6] velocity (m/s, frame l, range [-1e9, 1e9]): Error of velocity
        - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9]): Error of acceleration
        - [9:12] attitude (rad, frame b, range [-6, 6]): Error of attitude
        - [12:15] angular_rate (rad/s, frame l, range [-1e9, 1e9]): Error of angular_rate
        - [15:18] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9]): Error of
          angular_acceleration
        - [18:21] antenna (m, frame b, range [-1e9, 1e9]): Error of antenna
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
                Domain(
                    "antenna", 18, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "b", ("x", "y", "z")
                ),
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
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
        - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
        - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
        - [19:22] antenna (m, frame b, range [-50, 50])
    y : array_like, shape (..., 22)
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
        - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
        - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
        - [19:22] antenna (m, frame b, range [-50, 50])
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
                Domain(
                    "antenna", 19, 3, Kind.REAL, (-5e1,) * 3, (5e1,) * 3, "m", "b", ("x", "y", "z")
                ),
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
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, not read)
        - [6:9] acceleration (m/s^2, frame l, not read)
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, not read)
        - [16:19] angular_acceleration (rad/s^2, frame l, not read)
        - [19:22] antenna (m, frame b, range [-50, 50])
    measured : array_like, shape (..., 3)
        Measured value; m, frame l, range [-1e9, 1e9]; elements x y z.
    out : GpsResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    GpsResult
        value : array, shape (..., 3), m, frame l
            Value of the equation.
        residual : array, shape (..., 3), m, frame l
            Measured less predicted value.
        jacobian : array, shape (..., 3, 21)
            Derivative of the value by the error of the state.
            Columns: position[3] velocity[3] acceleration[3] attitude[3] angular_rate[3]
            angular_acceleration[3] antenna[3].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``gps.value`` (value, residual), ``gps.jacobian``
    (jacobian), ``gps.nonzeros`` (what is not zero by structure), ``gps.bind`` (a call without
    arguments over the same arrays), ``gps.blocks`` (epochs side by side, see ``gps.to_lanes``).
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
                Domain(
                    "antenna", 19, 3, Kind.REAL, (-5e1,) * 3, (5e1,) * 3, "m", "b", ("x", "y", "z")
                ),
            ),
        ),
        Argument(
            "measured",
            3,
            (
                Domain(
                    "measured", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "l", ("x", "y", "z")
                ),
            ),
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output("residual", (3,), (0, 1, 2)),
        Output(
            "jacobian",
            (3, 21),
            (0, 9, 10, 11, 18, 19, 20, 22, 30, 31, 32, 39, 40, 41, 44, 51, 52, 53, 60, 61, 62),
        ),
    ),
    lanes=32,
)


GPS_KNOWN_ANTENNA = Signature(
    "gps_known_antenna",
    """Position of a GNSS antenna.

        z = origin + C (offset + p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 22)
        - [0:3] position (m, frame l, range [-1e6, 1e6])
        - [3:6] velocity (m/s, frame l, not read)
        - [6:9] acceleration (m/s^2, frame l, not read)
        - [9:13] attitude (map b -> l, unit quaternion w x y z)
        - [13:16] angular_rate (rad/s, frame l, not read)
        - [16:19] angular_acceleration (rad/s^2, frame l, not read)
        - [19:22] antenna (m, frame b, not read)
    lever_arm : array_like, shape (..., 3)
        Antenna from the body origin, in the body frame; m, frame b, range [-100, 100]; elements
        x y z.
    measured : array_like, shape (..., 3)
        Measured value; m, frame l, range [-1e9, 1e9]; elements x y z.
    out : GpsKnownAntennaResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    GpsKnownAntennaResult
        value : array, shape (..., 3), m, frame l
            Value of the equation.
        residual : array, shape (..., 3), m, frame l
            Measured less predicted value.
        jacobian : array, shape (..., 3, 21)
            Derivative of the value by the error of the state.
            Columns: position[3] velocity[3] acceleration[3] attitude[3] angular_rate[3]
            angular_acceleration[3] antenna[3].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``gps_known_antenna.value`` (value, residual),
    ``gps_known_antenna.jacobian`` (jacobian), ``gps_known_antenna.nonzeros`` (what is not zero
    by structure), ``gps_known_antenna.bind`` (a call without arguments over the same arrays),
    ``gps_known_antenna.blocks`` (epochs side by side, see ``gps_known_antenna.to_lanes``).
    The lever arm points from the body origin to the antenna, resolved in the body frame.
    C and R are used in the direction their declared maps and the frames of the vectors need.
    Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
    """,
    GpsKnownAntennaResult,
    (
        Argument(
            "x",
            22,
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
                Domain(
                    "antenna",
                    19,
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
            "lever_arm",
            3,
            (
                Domain(
                    "lever_arm", 0, 3, Kind.REAL, (-1e2,) * 3, (1e2,) * 3, "m", "b", ("x", "y", "z")
                ),
            ),
        ),
        Argument(
            "measured",
            3,
            (
                Domain(
                    "measured", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "l", ("x", "y", "z")
                ),
            ),
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output("residual", (3,), (0, 1, 2)),
        Output("jacobian", (3, 21), (0, 9, 10, 11, 22, 30, 31, 32, 44, 51, 52, 53)),
    ),
    lanes=32,
)


LOCAL_FIX = Signature(
    "local_fix",
    """Local-level position of a geodetic fix.

        p = C_e^n(reference) (ecef(fix) - ecef(reference))

    Parameters
    ----------
    heading : array_like, shape (...)
        Heading of the local frame; rad, map g -> l, range [-3.1416, 3.1416].
    fix : array_like, shape (..., 3)
        Latitude, longitude, height of the fix; rad, range [-1.5690509975429023,
        1.5690509975429023], [-3.1416, 3.1416], [-10000, 1e7]; elements latitude longitude
        height.
    reference : array_like, shape (..., 3)
        Latitude, longitude, height of the local origin; rad, range [-1.5690509975429023,
        1.5690509975429023], [-3.1416, 3.1416], [-10000, 1e7]; elements latitude longitude
        height.
    covariance : array_like, shape (..., 9)
        Covariance of latitude, longitude (rad^2), height (m^2), row-major; range [-1e12, 1e12].
    out : LocalFixResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    LocalFixResult
        value : array, shape (..., 3), m, frame l
            Value of the equation.
        jacobian_fix : array, shape (..., 3, 3)
            Derivative of the value by fix.
            Columns: fix[3].
        value_covariance : array, shape (..., 9), m^2
            Covariance of the value, row-major.
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``local_fix.value`` (value, value_covariance),
    ``local_fix.jacobian`` (jacobian_fix), ``local_fix.nonzeros`` (what is not zero by
    structure), ``local_fix.bind`` (a call without arguments over the same arrays),
    ``local_fix.blocks`` (epochs side by side, see ``local_fix.to_lanes``).
    Latitude and longitude in radians on WGS-84; the Jacobian by the fix, when asked for, is by
    latitude, longitude and height: the map of their noise.
    Local-level axes are enu at the reference.
    Source: Groves 2013, section 2.4; NIMA TR8350.2.
    """,
    LocalFixResult,
    (
        Argument(
            "heading",
            1,
            (Domain("heading", 0, 1, Kind.REAL, (-3.1416,), (3.1416,), "rad", "g -> l", ("",)),),
            scalar=True,
        ),
        Argument(
            "fix",
            3,
            (
                Domain(
                    "fix",
                    0,
                    3,
                    Kind.REAL,
                    (-1.5690509975429023, -3.1416, -1e4),
                    (1.5690509975429023, 3.1416, 1e7),
                    "rad",
                    "",
                    ("latitude", "longitude", "height"),
                ),
            ),
        ),
        Argument(
            "reference",
            3,
            (
                Domain(
                    "reference",
                    0,
                    3,
                    Kind.REAL,
                    (-1.5690509975429023, -3.1416, -1e4),
                    (1.5690509975429023, 3.1416, 1e7),
                    "rad",
                    "",
                    ("latitude", "longitude", "height"),
                ),
            ),
        ),
        Argument(
            "covariance",
            9,
            (
                Domain(
                    "covariance",
                    0,
                    9,
                    Kind.REAL,
                    (-1e12,) * 9,
                    (1e12,) * 9,
                    "1",
                    "",
                    ("0", "1", "2", "3", "4", "5", "6", "7", "8"),
                ),
            ),
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output("jacobian_fix", (3, 3), tuple(range(9))),
        Output("value_covariance", (9,), tuple(range(9))),
    ),
    lanes=32,
)


class StateBlocks(NamedTuple):
    """The blocks of the state of ``ekf_cal_gps``."""

    position: Array
    velocity: Array
    acceleration: Array
    attitude: Array
    angular_rate: Array
    angular_acceleration: Array
    antenna: Array


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
)

_DIGEST = "d35bc63c37004baad9edaf5440932e1eea55317ef5a31ddbb9c170f3ec3b7a49"
