"""What the functions and the state of ``warpos_gps`` look like; data only."""

from __future__ import annotations

from typing import Any, NamedTuple

from ._runtime import Argument, Array, Domain, Kind, Output, Signature
from ._state import Block


class RetractResult(NamedTuple):
    """What ``retract`` returns."""

    value: Array
    """Value of the equation; shape (..., 15)."""
    status: Any


class LocalResult(NamedTuple):
    """What ``local`` returns."""

    value: Array
    """Value of the equation; shape (..., 15)."""
    status: Any


class MeasurementResult(NamedTuple):
    """What ``measurement`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 15)."""
    status: Any


class MeasurementByColumnResult(NamedTuple):
    """What ``measurement_by_column`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 15)."""
    status: Any


class ObservedResult(NamedTuple):
    """What ``observed`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 15)."""
    status: Any


class ObservedByColumnResult(NamedTuple):
    """What ``observed_by_column`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., 3, 15)."""
    status: Any


class ToStateFrameResult(NamedTuple):
    """What ``to_state_frame`` returns."""

    value: Array
    """Value of the equation; shape (..., 3)."""
    value_covariance: Array
    """Covariance of the value, row-major; shape (..., 9)."""
    status: Any


_STATE = Argument(
    "x",
    15,
    (
        Domain("leading", 0, 4, Kind.REAL, (-1e9,) * 4, (1e9,) * 4, "1", "", ("0", "1", "2", "3")),
        Domain("position", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "f", ("x", "y", "z")),
        Domain(
            "trailing",
            7,
            8,
            Kind.REAL,
            (-1e9,) * 8,
            (1e9,) * 8,
            "1",
            "",
            ("0", "1", "2", "3", "4", "5", "6", "7"),
        ),
    ),
)


RETRACT = Signature(
    "retract",
    """State moved by an error.

        value = x (+) d

    Parameters
    ----------
    x : array_like, shape (..., 15)
        - [0:4] leading (range [-1e9, 1e9])
        - [4:7] position (m, frame f, range [-1e9, 1e9])
        - [7:15] trailing (range [-1e9, 1e9])
    d : array_like, shape (..., 15)
        - [0:4] leading (range [-1e9, 1e9]): Error of leading
        - [4:7] position (m, frame f, range [-1e9, 1e9]): Error of position
        - [7:15] trailing (range [-1e9, 1e9]): Error of trailing
    out : RetractResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    RetractResult
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
    Other forms, with the same arguments: ``retract.value`` (value), ``retract.bind`` (a call
    without arguments over the same arrays), ``retract.blocks`` (epochs side by side, see
    ``retract.to_lanes``).
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
                    "leading",
                    0,
                    4,
                    Kind.REAL,
                    (-1e9,) * 4,
                    (1e9,) * 4,
                    "1",
                    "",
                    ("0", "1", "2", "3"),
                ),
                Domain(
                    "position", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "f", ("x", "y", "z")
                ),
                Domain(
                    "trailing",
                    7,
                    8,
                    Kind.REAL,
                    (-1e9,) * 8,
                    (1e9,) * 8,
                    "1",
                    "",
                    ("0", "1", "2", "3", "4", "5", "6", "7"),
                ),
            ),
        ),
    ),
    (Output("value", (15,), tuple(range(15))),),
    lanes=32,
)


LOCAL = Signature(
    "local",
    """Error between two states.

        value = y (-) x, so that x (+) value = y

    Parameters
    ----------
    x : array_like, shape (..., 15)
        - [0:4] leading (range [-1e9, 1e9])
        - [4:7] position (m, frame f, range [-1e9, 1e9])
        - [7:15] trailing (range [-1e9, 1e9])
    y : array_like, shape (..., 15)
        - [0:4] leading (range [-1e9, 1e9])
        - [4:7] position (m, frame f, range [-1e9, 1e9])
        - [7:15] trailing (range [-1e9, 1e9])
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
            15,
            (
                Domain(
                    "leading",
                    0,
                    4,
                    Kind.REAL,
                    (-1e9,) * 4,
                    (1e9,) * 4,
                    "1",
                    "",
                    ("0", "1", "2", "3"),
                ),
                Domain(
                    "position", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "f", ("x", "y", "z")
                ),
                Domain(
                    "trailing",
                    7,
                    8,
                    Kind.REAL,
                    (-1e9,) * 8,
                    (1e9,) * 8,
                    "1",
                    "",
                    ("0", "1", "2", "3", "4", "5", "6", "7"),
                ),
            ),
        ),
    ),
    (Output("value", (15,), tuple(range(15))),),
    lanes=32,
)


MEASUREMENT = Signature(
    "measurement",
    """Position of a GNSS antenna.

        z = origin + C (offset + p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 15)
        - [0:4] leading (not read)
        - [4:7] position (m, frame f, range [-1e9, 1e9])
        - [7:15] trailing (not read)
    out : MeasurementResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    MeasurementResult
        value : array, shape (..., 3), m, frame f
            Value of the equation.
        jacobian : array, shape (..., 3, 15)
            Derivative of the value by the error of the state.
            Columns: leading[4] position[3] trailing[8].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``measurement.value`` (value),
    ``measurement.jacobian`` (jacobian), ``measurement.nonzeros`` (what is not zero by
    structure), ``measurement.bind`` (a call without arguments over the same arrays),
    ``measurement.blocks`` (epochs side by side, see ``measurement.to_lanes``).
    The lever arm points from the body origin to the antenna, resolved in the body frame.
    C and R are used in the direction their declared maps and the frames of the vectors need.
    Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
    """,
    MeasurementResult,
    (
        Argument(
            "x",
            15,
            (
                Domain(
                    "leading",
                    0,
                    4,
                    Kind.UNREAD,
                    (-1e9,) * 4,
                    (1e9,) * 4,
                    "1",
                    "",
                    ("0", "1", "2", "3"),
                ),
                Domain(
                    "position", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "f", ("x", "y", "z")
                ),
                Domain(
                    "trailing",
                    7,
                    8,
                    Kind.UNREAD,
                    (-1e9,) * 8,
                    (1e9,) * 8,
                    "1",
                    "",
                    ("0", "1", "2", "3", "4", "5", "6", "7"),
                ),
            ),
        ),
    ),
    (Output("value", (3,), (0, 1, 2)), Output("jacobian", (3, 15), (4, 20, 36))),
    lanes=32,
)


MEASUREMENT_BY_COLUMN = Signature(
    "measurement_by_column",
    """Position of a GNSS antenna.

        z = origin + C (offset + p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 15)
        - [0:4] leading (not read)
        - [4:7] position (m, frame f, range [-1e9, 1e9])
        - [7:15] trailing (not read)
    out : MeasurementByColumnResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    MeasurementByColumnResult
        value : array, shape (..., 3), m, frame f
            Value of the equation.
        jacobian : array, shape (..., 3, 15)
            Derivative of the value by the error of the state.
            Columns: leading[4] position[3] trailing[8].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``measurement_by_column.value`` (value),
    ``measurement_by_column.jacobian`` (jacobian), ``measurement_by_column.nonzeros`` (what is
    not zero by structure), ``measurement_by_column.bind`` (a call without arguments over the
    same arrays), ``measurement_by_column.blocks`` (epochs side by side, see
    ``measurement_by_column.to_lanes``).
    The lever arm points from the body origin to the antenna, resolved in the body frame.
    C and R are used in the direction their declared maps and the frames of the vectors need.
    Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
    """,
    MeasurementByColumnResult,
    (
        Argument(
            "x",
            15,
            (
                Domain(
                    "leading",
                    0,
                    4,
                    Kind.UNREAD,
                    (-1e9,) * 4,
                    (1e9,) * 4,
                    "1",
                    "",
                    ("0", "1", "2", "3"),
                ),
                Domain(
                    "position", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "f", ("x", "y", "z")
                ),
                Domain(
                    "trailing",
                    7,
                    8,
                    Kind.UNREAD,
                    (-1e9,) * 8,
                    (1e9,) * 8,
                    "1",
                    "",
                    ("0", "1", "2", "3", "4", "5", "6", "7"),
                ),
            ),
        ),
    ),
    (Output("value", (3,), (0, 1, 2)), Output("jacobian", (3, 15), (4, 20, 36))),
    column_major=True,
    lanes=32,
)


OBSERVED = Signature(
    "observed",
    """Position of a GNSS antenna.

        z = origin + C (offset + p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 15)
        - [0:4] leading (not read)
        - [4:7] position (m, frame f, range [-1e9, 1e9])
        - [7:15] trailing (not read)
    observer_attitude : array_like, shape (..., 4)
        C, attitude of the observer's frame; map ref -> f, unit quaternion w x y z.
    out : ObservedResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    ObservedResult
        value : array, shape (..., 3), m, frame ref
            Value of the equation.
        jacobian : array, shape (..., 3, 15)
            Derivative of the value by the error of the state.
            Columns: leading[4] position[3] trailing[8].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``observed.value`` (value), ``observed.jacobian``
    (jacobian), ``observed.nonzeros`` (what is not zero by structure), ``observed.bind`` (a call
    without arguments over the same arrays), ``observed.blocks`` (epochs side by side, see
    ``observed.to_lanes``).
    The lever arm points from the body origin to the antenna, resolved in the body frame.
    C and R are used in the direction their declared maps and the frames of the vectors need.
    Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
    """,
    ObservedResult,
    (
        Argument(
            "x",
            15,
            (
                Domain(
                    "leading",
                    0,
                    4,
                    Kind.UNREAD,
                    (-1e9,) * 4,
                    (1e9,) * 4,
                    "1",
                    "",
                    ("0", "1", "2", "3"),
                ),
                Domain(
                    "position", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "f", ("x", "y", "z")
                ),
                Domain(
                    "trailing",
                    7,
                    8,
                    Kind.UNREAD,
                    (-1e9,) * 8,
                    (1e9,) * 8,
                    "1",
                    "",
                    ("0", "1", "2", "3", "4", "5", "6", "7"),
                ),
            ),
        ),
        Argument(
            "observer_attitude",
            4,
            (
                Domain(
                    "observer_attitude",
                    0,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "ref -> f",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
            ),
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output("jacobian", (3, 15), (4, 5, 6, 19, 20, 21, 34, 35, 36)),
    ),
    lanes=32,
)


OBSERVED_BY_COLUMN = Signature(
    "observed_by_column",
    """Position of a GNSS antenna.

        z = origin + C (offset + p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 15)
        - [0:4] leading (not read)
        - [4:7] position (m, frame f, range [-1e9, 1e9])
        - [7:15] trailing (not read)
    observer_attitude : array_like, shape (..., 4)
        C, attitude of the observer's frame; map ref -> f, unit quaternion w x y z.
    out : ObservedByColumnResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    ObservedByColumnResult
        value : array, shape (..., 3), m, frame ref
            Value of the equation.
        jacobian : array, shape (..., 3, 15)
            Derivative of the value by the error of the state.
            Columns: leading[4] position[3] trailing[8].
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``observed_by_column.value`` (value),
    ``observed_by_column.jacobian`` (jacobian), ``observed_by_column.nonzeros`` (what is not
    zero by structure), ``observed_by_column.bind`` (a call without arguments over the same
    arrays), ``observed_by_column.blocks`` (epochs side by side, see
    ``observed_by_column.to_lanes``).
    The lever arm points from the body origin to the antenna, resolved in the body frame.
    C and R are used in the direction their declared maps and the frames of the vectors need.
    Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
    """,
    ObservedByColumnResult,
    (
        Argument(
            "x",
            15,
            (
                Domain(
                    "leading",
                    0,
                    4,
                    Kind.UNREAD,
                    (-1e9,) * 4,
                    (1e9,) * 4,
                    "1",
                    "",
                    ("0", "1", "2", "3"),
                ),
                Domain(
                    "position", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "f", ("x", "y", "z")
                ),
                Domain(
                    "trailing",
                    7,
                    8,
                    Kind.UNREAD,
                    (-1e9,) * 8,
                    (1e9,) * 8,
                    "1",
                    "",
                    ("0", "1", "2", "3", "4", "5", "6", "7"),
                ),
            ),
        ),
        Argument(
            "observer_attitude",
            4,
            (
                Domain(
                    "observer_attitude",
                    0,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "ref -> f",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
            ),
        ),
    ),
    (
        Output("value", (3,), (0, 1, 2)),
        Output("jacobian", (3, 15), (4, 5, 6, 19, 20, 21, 34, 35, 36)),
    ),
    column_major=True,
    lanes=32,
)


TO_STATE_FRAME = Signature(
    "to_state_frame",
    """Receiver position transformed to the state's frame and origin.

        pos_B_F__F = R_F_REF pos_GPS_I__REF - pos_F_I__F - R_F_B pos_GPS_B__B

    Parameters
    ----------
    observer_attitude : array_like, shape (..., 4)
        C, attitude of the observer's frame; map ref -> f, unit quaternion w x y z.
    receiver_position : array_like, shape (..., 3)
        Fix of the receiver in its reporting frame (pos_GPS_I__REF); m, frame ref, range [-1e9,
        1e9]; elements x y z.
    origin_offset : array_like, shape (..., 3)
        Origin of the state frame from the reporting frame's, in the state frame (pos_F_I__F);
        m, frame f, range [-1e9, 1e9]; elements x y z.
    attitude : array_like, shape (..., 4)
        Attitude of the body (quat_F_B); map body -> f, unit quaternion w x y z.
    lever_arm : array_like, shape (..., 3)
        Antenna from the body origin, in the body frame; m, frame body, range [-100, 100];
        elements x y z.
    covariance : array_like, shape (..., 9)
        Covariance of the fix, row-major; m^2, range [-1e12, 1e12].
    out : ToStateFrameResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    ToStateFrameResult
        value : array, shape (..., 3), m, frame f
            Value of the equation.
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
    Other forms, with the same arguments: ``to_state_frame.value`` (value, value_covariance),
    ``to_state_frame.bind`` (a call without arguments over the same arrays),
    ``to_state_frame.blocks`` (epochs side by side, see ``to_state_frame.to_lanes``).
    The covariance leaves out the uncertainty of the attitude that rotates the lever arm; where
    the attitude is estimated, prefer gnss_position with a lever arm.
    Source: WarpTwin GPSMeasurements documentation, note on the measurement.
    """,
    ToStateFrameResult,
    (
        Argument(
            "observer_attitude",
            4,
            (
                Domain(
                    "observer_attitude",
                    0,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "ref -> f",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
            ),
        ),
        Argument(
            "receiver_position",
            3,
            (
                Domain(
                    "receiver_position",
                    0,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m",
                    "ref",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "origin_offset",
            3,
            (
                Domain(
                    "origin_offset",
                    0,
                    3,
                    Kind.REAL,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m",
                    "f",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "attitude",
            4,
            (
                Domain(
                    "attitude",
                    0,
                    4,
                    Kind.QUATERNION,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "body -> f",
                    ("w", "x", "y", "z"),
                    1e-05,
                ),
            ),
        ),
        Argument(
            "lever_arm",
            3,
            (
                Domain(
                    "lever_arm",
                    0,
                    3,
                    Kind.REAL,
                    (-1e2,) * 3,
                    (1e2,) * 3,
                    "m",
                    "body",
                    ("x", "y", "z"),
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
                    "m^2",
                    "",
                    ("0", "1", "2", "3", "4", "5", "6", "7", "8"),
                ),
            ),
        ),
    ),
    (Output("value", (3,), (0, 1, 2)), Output("value_covariance", (9,), tuple(range(9)))),
    lanes=32,
)


class StateBlocks(NamedTuple):
    """The blocks of the state of ``warpos_gps``."""

    leading: Array
    position: Array
    trailing: Array


_BLOCKS = (
    Block(
        "leading",
        ("0", "1", "2", "3"),
        "1",
        "",
        (0.0,) * 4,
        ("0", "1", "2", "3"),
        "1",
        "",
        "additive, true minus estimate",
    ),
    Block(
        "position",
        ("x", "y", "z"),
        "m",
        "f",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m",
        "f",
        "additive, true minus estimate",
    ),
    Block(
        "trailing",
        ("0", "1", "2", "3", "4", "5", "6", "7"),
        "1",
        "",
        (0.0,) * 8,
        ("0", "1", "2", "3", "4", "5", "6", "7"),
        "1",
        "",
        "additive, true minus estimate",
    ),
)

_DIGEST = "61ff2c007c6f1f0a3e8c5abd164f9d8f856d4c4d9539fb285d0dea0f3261f5e1"
