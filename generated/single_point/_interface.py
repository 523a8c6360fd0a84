"""What the functions and the state of ``single_point`` look like; data only."""

from __future__ import annotations

from typing import Any, NamedTuple

from ._runtime import Argument, Array, Condition, Domain, Kind, Output, Signature, Status
from ._state import Block


class RetractResult(NamedTuple):
    """What ``retract`` returns."""

    value: Array
    """Value of the equation; shape (..., 4)."""
    status: Any


class LocalResult(NamedTuple):
    """What ``local`` returns."""

    value: Array
    """Value of the equation; shape (..., 4)."""
    status: Any


class PseudorangeResult(NamedTuple):
    """What ``pseudorange`` returns."""

    value: Array
    """Value of the equation; shape (..., n)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., n, 4)."""
    status: Any
    item_status: Array


class PseudorangeWithoutSagnacResult(NamedTuple):
    """What ``pseudorange_without_sagnac`` returns."""

    value: Array
    """Value of the equation; shape (..., n)."""
    jacobian: Array
    """Derivative of the value by the error of the state; shape (..., n, 4)."""
    status: Any
    item_status: Array


class BroadcastOrbitResult(NamedTuple):
    """What ``broadcast_orbit`` returns."""

    position: Array
    """Position; shape (..., 3)."""
    clock: Array
    """Clock; shape (...)."""
    velocity: Array
    """Velocity; shape (..., 3)."""
    clock_rate: Array
    """Clock rate; shape (...)."""
    status: Any


_STATE = Argument(
    "x",
    4,
    (
        Domain("position", 0, 3, Kind.REAL, (-1e7,) * 3, (1e7,) * 3, "m", "e", ("x", "y", "z")),
        Domain("clock_bias", 3, 1, Kind.REAL, (-1e8,), (1e8,), "m", "", ("",)),
    ),
)


RETRACT = Signature(
    "retract",
    """State moved by an error.

        value = x (+) d

    Parameters
    ----------
    x : array_like, shape (..., 4)
        - [0:3] position (m, frame e, range [-1e7, 1e7])
        - [3] clock_bias (m, range [-1e8, 1e8])
    d : array_like, shape (..., 4)
        - [0:3] position (m, frame e, range [-1e9, 1e9]): Error of position
        - [3] clock_bias (m, range [-1e9, 1e9]): Error of clock_bias
    out : RetractResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    RetractResult
        value : array, shape (..., 4)
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
            4,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e9,) * 3, (1e9,) * 3, "m", "e", ("x", "y", "z")
                ),
                Domain("clock_bias", 3, 1, Kind.REAL, (-1e9,), (1e9,), "m", "", ("",)),
            ),
        ),
    ),
    (Output("value", (4,), tuple(range(4))),),
    lanes=32,
)


LOCAL = Signature(
    "local",
    """Error between two states.

        value = y (-) x, so that x (+) value = y

    Parameters
    ----------
    x : array_like, shape (..., 4)
        - [0:3] position (m, frame e, range [-1e7, 1e7])
        - [3] clock_bias (m, range [-1e8, 1e8])
    y : array_like, shape (..., 4)
        - [0:3] position (m, frame e, range [-1e7, 1e7])
        - [3] clock_bias (m, range [-1e8, 1e8])
    out : LocalResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    LocalResult
        value : array, shape (..., 4)
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
            4,
            (
                Domain(
                    "position", 0, 3, Kind.REAL, (-1e7,) * 3, (1e7,) * 3, "m", "e", ("x", "y", "z")
                ),
                Domain("clock_bias", 3, 1, Kind.REAL, (-1e8,), (1e8,), "m", "", ("",)),
            ),
        ),
    ),
    (Output("value", (4,), tuple(range(4))),),
    lanes=32,
)


PSEUDORANGE = Signature(
    "pseudorange",
    """Pseudoranges from the antenna to satellites.

        rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 4)
        - [0:3] position (m, frame e, range [-1e7, 1e7])
        - [3] clock_bias (m, range [-1e8, 1e8])
    satellite_position : array_like, shape (..., n, 3)
        Satellite, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y z.
    satellite_clock : array_like, shape (..., n)
        Satellite clock offset; s, range [-0.1, 0.1].
    troposphere : array_like, shape (..., n)
        Tropospheric delay; m, range [-100, 1000].
    ionosphere : array_like, shape (..., n)
        Ionospheric delay; m, range [-1000, 1000].
    out : PseudorangeResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    PseudorangeResult
        value : array, shape (..., n), m
            Value of the equation.
        jacobian : array, shape (..., n, 4)
            Derivative of the value by the error of the state.
            Columns: position[3] clock_bias[1].
        status : Status for one epoch, array of them over leading axes
        item_status : array, shape (..., n)
            Status of every item; one that fails refuses its epoch.

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``pseudorange.value`` (value),
    ``pseudorange.jacobian`` (jacobian), ``pseudorange.nonzeros`` (what is not zero by
    structure), ``pseudorange.bind`` (a call without arguments over the same arrays).
    At most 32 items.
    h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of
    the range by the antenna position.
    Earth rotation by the first-order term (w/c)(s_x a_y - s_y a_x); the satellite is given in
    the axes at transmission.
    A positive receiver clock bias and every delay lengthen the pseudorange; a positive
    satellite clock shortens it.
    Source: Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3.
    """,
    PseudorangeResult,
    (
        _STATE,
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
    ),
    (Output("value", (), (0,), item=True), Output("jacobian", (4,), tuple(range(4)), item=True)),
    conditions=(Condition(Status.DOMAIN, 1e-12, 1e30, "squared range"),),
    maximum=32,
    reject=True,
)


PSEUDORANGE_WITHOUT_SAGNAC = Signature(
    "pseudorange_without_sagnac",
    """Pseudoranges from the antenna to satellites.

        rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

    Parameters
    ----------
    x : array_like, shape (..., 4)
        - [0:3] position (m, frame e, range [-1e7, 1e7])
        - [3] clock_bias (m, range [-1e8, 1e8])
    satellite_position : array_like, shape (..., n, 3)
        Satellite, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y z.
    satellite_clock : array_like, shape (..., n)
        Satellite clock offset; s, range [-0.1, 0.1].
    troposphere : array_like, shape (..., n)
        Tropospheric delay; m, range [-100, 1000].
    ionosphere : array_like, shape (..., n)
        Ionospheric delay; m, range [-1000, 1000].
    out : PseudorangeWithoutSagnacResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    PseudorangeWithoutSagnacResult
        value : array, shape (..., n), m
            Value of the equation.
        jacobian : array, shape (..., n, 4)
            Derivative of the value by the error of the state.
            Columns: position[3] clock_bias[1].
        status : Status for one epoch, array of them over leading axes
        item_status : array, shape (..., n)
            Status of every item; one that fails refuses its epoch.

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``pseudorange_without_sagnac.value`` (value),
    ``pseudorange_without_sagnac.jacobian`` (jacobian), ``pseudorange_without_sagnac.nonzeros``
    (what is not zero by structure), ``pseudorange_without_sagnac.bind`` (a call without
    arguments over the same arrays).
    At most 32 items.
    h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of
    the range by the antenna position.
    No earth rotation: the satellite is given in the axes at reception.
    A positive receiver clock bias and every delay lengthen the pseudorange; a positive
    satellite clock shortens it.
    Source: Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3.
    """,
    PseudorangeWithoutSagnacResult,
    (
        _STATE,
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
    ),
    (Output("value", (), (0,), item=True), Output("jacobian", (4,), tuple(range(4)), item=True)),
    conditions=(Condition(Status.DOMAIN, 1e-12, 1e30, "squared range"),),
    maximum=32,
    reject=True,
)


BROADCAST_ORBIT = Signature(
    "broadcast_orbit",
    """Satellite position, velocity and clock from a broadcast ephemeris.

        E - e sin E = M;  r, u, i with harmonic corrections;  R_z(Omega) R_x(i)

    Parameters
    ----------
    time : array_like, shape (...)
        Time of week; may pass its ends by an hour; s, range [-3600, 608400].
    toe : array_like, shape (...)
        Reference time of the ephemeris; s, range [0, 604800].
    toc : array_like, shape (...)
        Reference time of the clock; s, range [0, 604800].
    sqrt_a : array_like, shape (...)
        Square root of the semi-major axis; m^1/2, range [4000, 7000].
    eccentricity : array_like, shape (...)
        Eccentricity; range [0, 0.1].
    mean_anomaly : array_like, shape (...)
        Mean anomaly at the reference time; rad, range [-3.2, 3.2].
    mean_motion_difference : array_like, shape (...)
        Correction of the mean motion; rad/s, range [-1e-6, 1e-6].
    inclination : array_like, shape (...)
        Inclination at the reference time; rad, range [-3.2, 3.2].
    inclination_rate : array_like, shape (...)
        Rate of the inclination; rad/s, range [-1e-6, 1e-6].
    right_ascension : array_like, shape (...)
        Longitude of the node at the week's start; rad, range [-3.2, 3.2].
    right_ascension_rate : array_like, shape (...)
        Rate of the right ascension; rad/s, range [-1e-6, 1e-6].
    argument_of_perigee : array_like, shape (...)
        Argument of perigee; rad, range [-3.2, 3.2].
    cuc : array_like, shape (...)
        Cosine correction of the argument of latitude; rad, range [-0.001, 0.001].
    cus : array_like, shape (...)
        Sine correction of the argument of latitude; rad, range [-0.001, 0.001].
    crc : array_like, shape (...)
        Cosine correction of the radius; m, range [-10000, 10000].
    crs : array_like, shape (...)
        Sine correction of the radius; m, range [-10000, 10000].
    cic : array_like, shape (...)
        Cosine correction of the inclination; rad, range [-0.001, 0.001].
    cis : array_like, shape (...)
        Sine correction of the inclination; rad, range [-0.001, 0.001].
    af0 : array_like, shape (...)
        Clock offset; s, range [-0.1, 0.1].
    af1 : array_like, shape (...)
        Clock drift; range [-1e-6, 1e-6].
    af2 : array_like, shape (...)
        Clock drift rate; 1/s, range [-1e-9, 1e-9].
    group_delay : array_like, shape (...)
        TGD or BGD of the signal; s, range [-1e-5, 1e-5].
    out : BroadcastOrbitResult, tuple or dict of arrays, optional
        Contiguous arrays to write to instead of new ones; what fails stays untouched.

    Returns
    -------
    BroadcastOrbitResult
        position : array, shape (..., 3), m
            Position.
        clock : array, shape (...), s
            Clock.
        velocity : array, shape (..., 3), m/s
            Velocity.
        clock_rate : array, shape (...)
            Clock rate.
        status : Status for one epoch, array of them over leading axes

    Raises
    ------
    GuardError
        When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
        rows of epochs that fail are NaN.

    Notes
    -----
    Other forms, with the same arguments: ``broadcast_orbit.value`` (position, clock, velocity,
    clock_rate), ``broadcast_orbit.bind`` (a call without arguments over the same arrays),
    ``broadcast_orbit.blocks`` (epochs side by side, see ``broadcast_orbit.to_lanes``).
    GM = 3.986005000e+14 m^3/s^2 of gps; the other system's value costs metres after two hours.
    Earth-fixed axes at the time given, which is the time of transmission for a pseudorange.
    Kepler's equation by 4 Newton steps: error below 1e-16 rad for eccentricities up to 0.1.
    group_delay is TGD or BGD of the signal: the clock is that of the signal.
    Source: IS-GPS-200, table 20-IV and 20.3.3.3.3.1; Galileo OS SIS ICD 5.1.
    """,
    BroadcastOrbitResult,
    (
        Argument(
            "time",
            1,
            (Domain("time", 0, 1, Kind.REAL, (-3.6e3,), (6.084e5,), "s", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "toe",
            1,
            (Domain("toe", 0, 1, Kind.REAL, (0.0,), (6.048e5,), "s", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "toc",
            1,
            (Domain("toc", 0, 1, Kind.REAL, (0.0,), (6.048e5,), "s", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "sqrt_a",
            1,
            (Domain("sqrt_a", 0, 1, Kind.REAL, (4e3,), (7e3,), "m^1/2", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "eccentricity",
            1,
            (Domain("eccentricity", 0, 1, Kind.REAL, (0.0,), (0.1,), "1", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "mean_anomaly",
            1,
            (Domain("mean_anomaly", 0, 1, Kind.REAL, (-3.2,), (3.2,), "rad", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "mean_motion_difference",
            1,
            (
                Domain(
                    "mean_motion_difference", 0, 1, Kind.REAL, (-1e-6,), (1e-6,), "rad/s", "", ("",)
                ),
            ),
            scalar=True,
        ),
        Argument(
            "inclination",
            1,
            (Domain("inclination", 0, 1, Kind.REAL, (-3.2,), (3.2,), "rad", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "inclination_rate",
            1,
            (Domain("inclination_rate", 0, 1, Kind.REAL, (-1e-6,), (1e-6,), "rad/s", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "right_ascension",
            1,
            (Domain("right_ascension", 0, 1, Kind.REAL, (-3.2,), (3.2,), "rad", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "right_ascension_rate",
            1,
            (
                Domain(
                    "right_ascension_rate", 0, 1, Kind.REAL, (-1e-6,), (1e-6,), "rad/s", "", ("",)
                ),
            ),
            scalar=True,
        ),
        Argument(
            "argument_of_perigee",
            1,
            (Domain("argument_of_perigee", 0, 1, Kind.REAL, (-3.2,), (3.2,), "rad", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "cuc",
            1,
            (Domain("cuc", 0, 1, Kind.REAL, (-1e-3,), (1e-3,), "rad", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "cus",
            1,
            (Domain("cus", 0, 1, Kind.REAL, (-1e-3,), (1e-3,), "rad", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "crc",
            1,
            (Domain("crc", 0, 1, Kind.REAL, (-1e4,), (1e4,), "m", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "crs",
            1,
            (Domain("crs", 0, 1, Kind.REAL, (-1e4,), (1e4,), "m", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "cic",
            1,
            (Domain("cic", 0, 1, Kind.REAL, (-1e-3,), (1e-3,), "rad", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "cis",
            1,
            (Domain("cis", 0, 1, Kind.REAL, (-1e-3,), (1e-3,), "rad", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "af0",
            1,
            (Domain("af0", 0, 1, Kind.REAL, (-0.1,), (0.1,), "s", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "af1",
            1,
            (Domain("af1", 0, 1, Kind.REAL, (-1e-6,), (1e-6,), "1", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "af2",
            1,
            (Domain("af2", 0, 1, Kind.REAL, (-1e-9,), (1e-9,), "1/s", "", ("",)),),
            scalar=True,
        ),
        Argument(
            "group_delay",
            1,
            (Domain("group_delay", 0, 1, Kind.REAL, (-1e-5,), (1e-5,), "s", "", ("",)),),
            scalar=True,
        ),
    ),
    (
        Output("position", (3,), (0, 1, 2)),
        Output("clock", (), (0,)),
        Output("velocity", (3,), (0, 1, 2)),
        Output("clock_rate", (), (0,)),
    ),
    lanes=32,
)


class StateBlocks(NamedTuple):
    """The blocks of the state of ``single_point``."""

    position: Array
    clock_bias: Array


_BLOCKS = (
    Block(
        "position",
        ("x", "y", "z"),
        "m",
        "e",
        (0.0,) * 3,
        ("x", "y", "z"),
        "m",
        "e",
        "additive, true minus estimate",
    ),
    Block("clock_bias", ("",), "m", "", (0.0,), ("",), "m", "", "additive, true minus estimate"),
)

_DIGEST = "d44814f47cf7697371ec74f3ae77ce39efce44374e859081c56e3bc49bf0e1c9"
