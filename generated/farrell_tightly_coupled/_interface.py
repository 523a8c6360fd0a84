"""What the functions and the state of ``farrell_tightly_coupled`` look like; data only."""

from __future__ import annotations

from typing import Any, NamedTuple

from ._runtime import Argument, Array, Condition, Domain, Kind, Output, Signature, Status
from ._state import Block


class RetractResult(NamedTuple):
    """What ``retract`` returns."""

    value: Array
    """Value of the equation; shape (..., 18)."""
    status: Any


class LocalResult(NamedTuple):
    """What ``local`` returns."""

    value: Array
    """Value of the equation; shape (..., 17)."""
    status: Any


class PseudorangeResult(NamedTuple):
    """What ``pseudorange`` returns."""

    value: Array
    """Value of the equation; shape (..., n)."""
    residual: Array
    """Measured less predicted value; shape (..., n)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., n, 17)."""
    status: Any
    item_status: Array


class PseudorangeLeverArmResult(NamedTuple):
    """What ``pseudorange_lever_arm`` returns."""

    value: Array
    """Value of the equation; shape (..., n)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., n, 17)."""
    status: Any
    item_status: Array


_STATE = Argument(
    "x",
    18,
    (
        Domain("dp", 0, 3, Kind.REAL, (-1e6,) * 3, (1e6,) * 3, "m", "n", ("x", "y", "z")),
        Domain("b_u", 3, 1, Kind.REAL, (-1e8,), (1e8,), "m", "", ("",)),
        Domain("dv", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s", "n", ("x", "y", "z")),
        Domain("b_u_dot", 7, 1, Kind.REAL, (-1e9,), (1e9,), "m/s", "", ("",)),
        Domain(
            "drho",
            8,
            4,
            Kind.QUATERNION,
            (-1.00001,) * 4,
            (1.00001,) * 4,
            "1",
            "b -> n",
            ("w", "x", "y", "z"),
            1e-05,
        ),
        Domain("x_a", 12, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s^2", "b", ("x", "y", "z")),
        Domain("x_g", 15, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "rad/s", "b", ("x", "y", "z")),
    ),
)


RETRACT = Signature(
    "retract",
    """State moved by an error.

        value = x (+) d

    Parameters
    ----------
    x : array_like, shape (..., 18)
        - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
          plane
        - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
        - [4:7] dv (m/s, frame n, range [-1e9, 1e9]): Velocity
        - [7] b_u_dot (m/s, range [-1e9, 1e9]): Receiver clock drift
        - [8:12] drho (map b -> n, unit quaternion w x y z): Attitude, whose error the book
          calls rho
        - [12:15] x_a (m/s^2, frame b, range [-1e9, 1e9]): Accelerometer bias
        - [15:18] x_g (rad/s, frame b, range [-1e9, 1e9]): Gyro bias
    d : array_like, shape (..., 17)
        - [0:3] dp (m, frame n, range [-1e9, 1e9]): Error of dp
        - [3] b_u (m, range [-1e9, 1e9]): Error of b_u
        - [4:7] dv (m/s, frame n, range [-1e9, 1e9]): Error of dv
        - [7] b_u_dot (m/s, range [-1e9, 1e9]): Error of b_u_dot
        - [8:11] drho (rad, frame n, range [-6, 6]): Error of drho
        - [11:14] x_a (m/s^2, frame b, range [-1e9, 1e9]): Error of x_a
        - [14:17] x_g (rad/s, frame b, range [-1e9, 1e9]): Error of x_g
    out : RetractResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    RetractResult
        value : array, shape (..., 18)
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
    Products of unit quaternions drift from unit norm by rounding (drho): renormalise after
    every update, for which q *= 1.5 - 0.5 |q|^2 is enough; else calls end in QNORM, in single
    precision after some hundred.
    Source: the error conventions of the blocks.
    """,
    RetractResult,
    (
        _STATE,
        Argument(
            "d",
            17,
            (
                Domain("dp", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "n", ("x", "y", "z")),
                Domain("b_u", 3, 1, Kind.REAL, (-1e9,), (1e9,), "m", "", ("",)),
                Domain("dv", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s", "n", ("x", "y", "z")),
                Domain("b_u_dot", 7, 1, Kind.REAL, (-1e9,), (1e9,), "m/s", "", ("",)),
                Domain(
                    "drho", 8, 3, Kind.REAL, (-6.0,) * 3, (6.0,) * 3, "rad", "n", ("x", "y", "z")
                ),
                Domain(
                    "x_a", 11, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s^2", "b", ("x", "y", "z")
                ),
                Domain(
                    "x_g", 14, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "rad/s", "b", ("x", "y", "z")
                ),
            ),
        ),
    ),
    (Output("value", (18,), tuple(range(18))),),
    lanes=32,
)


LOCAL = Signature(
    "local",
    """Error between two states.

        value = y (-) x, so that x (+) value = y

    Parameters
    ----------
    x : array_like, shape (..., 18)
        - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
          plane
        - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
        - [4:7] dv (m/s, frame n, range [-1e9, 1e9]): Velocity
        - [7] b_u_dot (m/s, range [-1e9, 1e9]): Receiver clock drift
        - [8:12] drho (map b -> n, unit quaternion w x y z): Attitude, whose error the book
          calls rho
        - [12:15] x_a (m/s^2, frame b, range [-1e9, 1e9]): Accelerometer bias
        - [15:18] x_g (rad/s, frame b, range [-1e9, 1e9]): Gyro bias
    y : array_like, shape (..., 18)
        - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
          plane
        - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
        - [4:7] dv (m/s, frame n, range [-1e9, 1e9]): Velocity
        - [7] b_u_dot (m/s, range [-1e9, 1e9]): Receiver clock drift
        - [8:12] drho (map b -> n, unit quaternion w x y z): Attitude, whose error the book
          calls rho
        - [12:15] x_a (m/s^2, frame b, range [-1e9, 1e9]): Accelerometer bias
        - [15:18] x_g (rad/s, frame b, range [-1e9, 1e9]): Gyro bias
    out : LocalResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    LocalResult
        value : array, shape (..., 17)
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
            18,
            (
                Domain("dp", 0, 3, Kind.REAL, (-1e6,) * 3, (1e6,) * 3, "m", "n", ("x", "y", "z")),
                Domain("b_u", 3, 1, Kind.REAL, (-1e8,), (1e8,), "m", "", ("",)),
                Domain("dv", 4, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s", "n", ("x", "y", "z")),
                Domain("b_u_dot", 7, 1, Kind.REAL, (-1e9,), (1e9,), "m/s", "", ("",)),
                Domain(
                    "drho",
                    8,
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
                    "x_a", 12, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m/s^2", "b", ("x", "y", "z")
                ),
                Domain(
                    "x_g", 15, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "rad/s", "b", ("x", "y", "z")
                ),
            ),
        ),
    ),
    (Output("value", (17,), tuple(range(17))),),
    lanes=32,
)


PSEUDORANGE = Signature(
    "pseudorange",
    """Pseudoranges from the antenna to satellites.

        rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 18)
        - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
          plane
        - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
        - [4:7] dv (m/s, frame n, not read): Velocity
        - [7] b_u_dot (m/s, not read): Receiver clock drift
        - [8:12] drho (map b -> n, not read): Attitude, whose error the book calls rho
        - [12:15] x_a (m/s^2, frame b, not read): Accelerometer bias
        - [15:18] x_g (rad/s, frame b, not read): Gyro bias
    c_n_e : array_like, shape (..., 9)
        Attitude of the navigation frame in the earth-fixed frame; map n -> e, rotation matrix,
        row by row.
    origin : array_like, shape (..., 3)
        Origin of the navigation frame, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y
        z.
    satellite_position : array_like, shape (..., n, 3)
        Satellite, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y z.
    measured : array_like, shape (..., n)
        Measured value; m, range [-1e9, 1e9].
    out : PseudorangeResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    PseudorangeResult
        value : array, shape (..., n), m
            Value of the equation.
        residual : array, shape (..., n), m
            Measured less predicted value.
        jacobian : array, shape (..., n, 17)
            Derivative of the value by the error of the state.
            Columns: dp[3] b_u[1] dv[3] b_u_dot[1] drho[3] x_a[3] x_g[3].
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
    Other forms, with the same arguments: ``pseudorange.value`` (value, residual),
    ``pseudorange.jacobian`` (jacobian), ``pseudorange.nonzeros`` (what is not zero by
    structure), ``pseudorange.bind`` (a call without arguments over the same arrays),
    ``pseudorange.single_difference`` (less the item ``reference``).
    At most 32 items.
    h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of
    the range by the antenna position.
    No earth rotation: the satellite is given in the axes at reception.
    A positive receiver clock bias and every delay lengthen the pseudorange; a positive
    satellite clock shortens it.
    Source: Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3.
    """,
    PseudorangeResult,
    (
        Argument(
            "x",
            18,
            (
                Domain("dp", 0, 3, Kind.REAL, (-1e6,) * 3, (1e6,) * 3, "m", "n", ("x", "y", "z")),
                Domain("b_u", 3, 1, Kind.REAL, (-1e8,), (1e8,), "m", "", ("",)),
                Domain(
                    "dv", 4, 3, Kind.UNREAD, (-1e9,) * 3, (1e9,) * 3, "m/s", "n", ("x", "y", "z")
                ),
                Domain("b_u_dot", 7, 1, Kind.UNREAD, (-1e9,), (1e9,), "m/s", "", ("",)),
                Domain(
                    "drho",
                    8,
                    4,
                    Kind.UNREAD,
                    (-1.00001,) * 4,
                    (1.00001,) * 4,
                    "1",
                    "b -> n",
                    ("w", "x", "y", "z"),
                ),
                Domain(
                    "x_a",
                    12,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s^2",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "x_g",
                    15,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s",
                    "b",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "c_n_e",
            9,
            (
                Domain(
                    "c_n_e",
                    0,
                    9,
                    Kind.MATRIX,
                    (-1.00001,) * 9,
                    (1.00001,) * 9,
                    "1",
                    "n -> e",
                    ("00", "01", "02", "10", "11", "12", "20", "21", "22"),
                    1e-05,
                ),
            ),
        ),
        Argument(
            "origin",
            3,
            (
                Domain(
                    "origin", 0, 3, Kind.REAL, (-1e8,) * 3, (1e8,) * 3, "m", "e", ("x", "y", "z")
                ),
            ),
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
                    "e",
                    ("x", "y", "z"),
                ),
            ),
            item=True,
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
        Output("jacobian", (17,), tuple(range(4)), item=True),
    ),
    conditions=(Condition(Status.DOMAIN, 1e-12, 1e30, "squared range"),),
    maximum=32,
    single_difference=True,
)


PSEUDORANGE_LEVER_ARM = Signature(
    "pseudorange_lever_arm",
    """Pseudoranges from the antenna to satellites.

        rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 18)
        - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
          plane
        - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
        - [4:7] dv (m/s, frame n, not read): Velocity
        - [7] b_u_dot (m/s, not read): Receiver clock drift
        - [8:12] drho (map b -> n, unit quaternion w x y z): Attitude, whose error the book
          calls rho
        - [12:15] x_a (m/s^2, frame b, not read): Accelerometer bias
        - [15:18] x_g (rad/s, frame b, not read): Gyro bias
    c_n_e : array_like, shape (..., 9)
        Attitude of the navigation frame in the earth-fixed frame; map n -> e, rotation matrix,
        row by row.
    origin : array_like, shape (..., 3)
        Origin of the navigation frame, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y
        z.
    lever_arm : array_like, shape (..., 3)
        Antenna from the body origin, in the body frame; m, frame b, range [-100, 100]; elements
        x y z.
    satellite_position : array_like, shape (..., n, 3)
        Satellite, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y z.
    out : PseudorangeLeverArmResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    PseudorangeLeverArmResult
        value : array, shape (..., n), m
            Value of the equation.
        jacobian : array, shape (..., n, 17)
            Derivative of the value by the error of the state.
            Columns: dp[3] b_u[1] dv[3] b_u_dot[1] drho[3] x_a[3] x_g[3].
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
    Other forms, with the same arguments: ``pseudorange_lever_arm.value`` (value),
    ``pseudorange_lever_arm.jacobian`` (jacobian), ``pseudorange_lever_arm.nonzeros`` (what is
    not zero by structure), ``pseudorange_lever_arm.bind`` (a call without arguments over the
    same arrays), ``pseudorange_lever_arm.single_difference`` (less the item ``reference``).
    At most 32 items.
    h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of
    the range by the antenna position.
    No earth rotation: the satellite is given in the axes at reception.
    A positive receiver clock bias and every delay lengthen the pseudorange; a positive
    satellite clock shortens it.
    Source: Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3.
    """,
    PseudorangeLeverArmResult,
    (
        Argument(
            "x",
            18,
            (
                Domain("dp", 0, 3, Kind.REAL, (-1e6,) * 3, (1e6,) * 3, "m", "n", ("x", "y", "z")),
                Domain("b_u", 3, 1, Kind.REAL, (-1e8,), (1e8,), "m", "", ("",)),
                Domain(
                    "dv", 4, 3, Kind.UNREAD, (-1e9,) * 3, (1e9,) * 3, "m/s", "n", ("x", "y", "z")
                ),
                Domain("b_u_dot", 7, 1, Kind.UNREAD, (-1e9,), (1e9,), "m/s", "", ("",)),
                Domain(
                    "drho",
                    8,
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
                    "x_a",
                    12,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "m/s^2",
                    "b",
                    ("x", "y", "z"),
                ),
                Domain(
                    "x_g",
                    15,
                    3,
                    Kind.UNREAD,
                    (-1e9,) * 3,
                    (1e9,) * 3,
                    "rad/s",
                    "b",
                    ("x", "y", "z"),
                ),
            ),
        ),
        Argument(
            "c_n_e",
            9,
            (
                Domain(
                    "c_n_e",
                    0,
                    9,
                    Kind.MATRIX,
                    (-1.00001,) * 9,
                    (1.00001,) * 9,
                    "1",
                    "n -> e",
                    ("00", "01", "02", "10", "11", "12", "20", "21", "22"),
                    1e-05,
                ),
            ),
        ),
        Argument(
            "origin",
            3,
            (
                Domain(
                    "origin", 0, 3, Kind.REAL, (-1e8,) * 3, (1e8,) * 3, "m", "e", ("x", "y", "z")
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
                    "e",
                    ("x", "y", "z"),
                ),
            ),
            item=True,
        ),
    ),
    (
        Output("value", (), (0,), item=True),
        Output("jacobian", (17,), (0, 1, 2, 3, 8, 9, 10), item=True),
    ),
    conditions=(Condition(Status.DOMAIN, 1e-12, 1e30, "squared range"),),
    maximum=32,
    single_difference=True,
)


class StateBlocks(NamedTuple):
    """The blocks of the state of ``farrell_tightly_coupled``."""

    dp: Array
    b_u: Array
    dv: Array
    b_u_dot: Array
    drho: Array
    x_a: Array
    x_g: Array


_BLOCKS = (
    Block(
        "dp",
        ("x", "y", "z"),
        "m",
        "n",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m",
        "n",
        "additive, true minus estimate",
    ),
    Block("b_u", ("",), "m", "", (0.0,), ("",), "m", "", "additive, true minus estimate"),
    Block(
        "dv",
        ("x", "y", "z"),
        "m/s",
        "n",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m/s",
        "n",
        "additive, true minus estimate",
    ),
    Block("b_u_dot", ("",), "m/s", "", (0.0,), ("",), "m/s", "", "additive, true minus estimate"),
    Block(
        "drho",
        ("w", "x", "y", "z"),
        "1",
        "b -> n",
        (1.0, 0.0, 0.0, 0.0),
        ("x", "y", "z"),
        "rad",
        "n",
        "Exp(d) R",
    ),
    Block(
        "x_a",
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
        "x_g",
        ("x", "y", "z"),
        "rad/s",
        "b",
        (0.0,) * 3,
        ("x", "y", "z"),
        "rad/s",
        "b",
        "additive, true minus estimate",
    ),
)

_DIGEST = "903245ca33fad419df4082484e2a7dc472e06157f27e73a9a2e4fa113076eb3b"
