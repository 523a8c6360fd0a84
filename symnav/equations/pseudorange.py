"""Pseudoranges from an antenna to satellites, mapped over the satellites.

rho = r(s, a) + b - c dt_s + T + I with the antenna a = p0 + C (p + R l) in the earth-fixed frame.
Sources: Farrell, tightly coupled GPS-aided INS, in Autonomous Mobile Robots, chapter 3;
IS-GPS-200, 20.3.3.4.3 (earth rotation during the signal's travel).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

from symnav import units
from symnav.equations.bound import Bound, Results, resolve_in
from symnav.equations.model import (
    Model,
    OptionValue,
    Role,
    Scene,
    choice,
    point,
    rotation,
    scalar,
    vector,
)
from symnav.frames import earth
from symnav.graph import Guard
from symnav.quantities import HARMLESS, Quantity, dot, let, norm, rotate, total

ITERATIONS = 3
#: Of a satellite of the navigation systems, in metres.
ORBIT_RADIUS = 2.66e7


def pseudorange(q: Bound) -> Results:
    """Rho = r + b - c dt_s + T + I."""
    antenna = _antenna(q)
    satellite = q.vector("satellite_position")
    geometric = _RANGES[str(q.options["sagnac"])](q, antenna, satellite)
    return Results({"value": total(geometric, *_delays(q))})


def pseudorange_relative(q: Bound) -> Results:
    """Rho - rho0 = (x.x - 2 d.x)/(r + r0) + (w/c)(s_x x_y - s_y x_x) + (b - b0)."""
    x = let("displacement", _antenna(q))
    d = q.vector("satellite_difference")
    r0 = q.vector("reference_range")
    excess = let("excess", dot(x, x) - 2.0 * dot(d, x))
    guard = Guard(1.0, 1e30, HARMLESS, "squared range")
    square = let("range_squared", dot(d, d) + excess, guard)
    distance = let("range", _square_root(square))
    both = let("range_sum", distance + r0, Guard(1.0, 1e30, HARMLESS, "sum of the ranges"))
    inverse = let("inverse_range_sum", _inverse(both))
    delta = let("range_change", excess * inverse)
    if q.options["sagnac"] == "first_order":
        delta = delta + _sagnac_term(q, q.vector("satellite_xy"), x)
    return Results({"value": total(delta, q.optional("clock_bias"))})


def _antenna(q: Bound) -> Quantity:
    """A = p0 + C (p + R l), in the earth-fixed frame; C only where p is not earth-fixed."""
    position = q.vector("position")
    to_ecef = q.rotation("nav_to_ecef")
    arm = q.optional("lever_arm")
    if arm is not None:
        arm = resolve_in(
            position.frame, arm, q.rotation("attitude"), q.level_of("position"), to_ecef
        )
    antenna = total(position, arm)
    if to_ecef is not None and antenna.frame != q.frames["ecef"]:
        antenna = rotate(to_ecef, let("antenna_nav", antenna), "antenna_ecef")
    return let("antenna", total(antenna, q.optional("origin")))


def _frames(
    known: Mapping[str, str], axes: Mapping[str, str], level: str | None
) -> Mapping[str, str]:
    """An earth-fixed position decides the earth-fixed frame, any other the navigation frame."""
    place = known.get("place")
    if place is None:
        return {}
    if level is not None:
        return {"ecef": place, "nav": level}
    return {"ecef": place} if axes.get(place) == "ecef" else {"nav": place}


def _delays(q: Bound) -> list[Quantity | None]:
    """Clocks and atmosphere in metres: b, -c dt_s, T, I."""
    bias, clock = q.optional("clock_bias"), q.optional("satellite_clock")
    speed = q.constant("m/s", earth.SPEED_OF_LIGHT)
    if bias is not None and bias.unit == units.parse("s"):
        bias = speed * bias
    if clock is not None:
        clock = -(speed * clock)
    return [bias, clock, q.optional("troposphere"), q.optional("ionosphere")]


def _plain(q: Bound, antenna: Quantity, satellite: Quantity) -> Quantity:
    return norm("range", antenna - satellite)


def _first_order(q: Bound, antenna: Quantity, satellite: Quantity) -> Quantity:
    return _plain(q, antenna, satellite) + _sagnac_term(q, satellite, antenna)


def _sagnac_term(q: Bound, satellite: Quantity, antenna: Quantity) -> Quantity:
    """(w/c)(s_x a_y - s_y a_x)."""
    rate = let(
        "turned_satellite",
        q.constant("1/m", earth.ROTATION_RATE / earth.SPEED_OF_LIGHT)
        * Quantity(q.graph, satellite.elements[:2], units.parse("m")),
    )
    sx, sy = rate.elements
    ax, ay, _ = antenna.elements
    return Quantity(q.graph, (sx * ay - sy * ax,), units.parse("m"))


def _rotate_once(q: Bound, antenna: Quantity, satellite: Quantity) -> Quantity:
    distance = norm("range_unrotated", antenna - satellite)
    return norm("range", antenna - _turned(q, "turned", satellite, distance))


def _exact(q: Bound, antenna: Quantity, satellite: Quantity) -> Quantity:
    distance = norm("range_0", antenna - satellite)
    for k in range(1, ITERATIONS + 1):
        name = "range" if k == ITERATIONS else f"range_{k}"
        distance = norm(name, antenna - _turned(q, f"turned_{k}", satellite, distance))
    return distance


def _turned(q: Bound, name: str, satellite: Quantity, distance: Quantity) -> Quantity:
    """The satellite in the earth-fixed axes at reception: turned by w r / c about the pole.

    The angle stays below 1e-4 rad (a signal under way for a second), where the polynomials of
    third and fourth degree are exact to double precision.
    """
    turn = q.constant("1/m", earth.ROTATION_RATE / earth.SPEED_OF_LIGHT)
    angle = let(f"{name}_angle", turn * distance)
    half = sp.Rational(1, 2)

    def cosine_less_one(t: sp.Expr) -> sp.Expr:
        return t * t * (t * t / 24 - half)

    def sine(t: sp.Expr) -> sp.Expr:
        return t - t * t * t / 6

    t = angle.elements[0]
    c1 = let(f"{name}_cosine_less_one", Quantity(q.graph, (cosine_less_one(t),), units.ONE))
    s = let(f"{name}_sine", Quantity(q.graph, (sine(t),), units.ONE))
    x, y, z = satellite.elements
    cx, sx = c1.elements[0], s.elements[0]
    elements = (x + (x * cx + y * sx), y + (y * cx - x * sx), z)
    return let(name, Quantity(q.graph, elements, satellite.unit, satellite.frame))


_RANGES = {
    "first_order": _first_order,
    "none": _plain,
    "rotate_once": _rotate_once,
    "exact": _exact,
}


def _square_root(square: Quantity) -> Quantity:
    return Quantity(square.graph, (sp.sqrt(square.elements[0]),), units.parse("m"))


def _inverse(quantity: Quantity) -> Quantity:
    return Quantity(quantity.graph, (1 / quantity.elements[0],), units.ONE / quantity.unit)


_SAGNAC = {
    "none": "No earth rotation: the satellite is given in the axes at reception.",
    "first_order": "Earth rotation by the first-order term (w/c)(s_x a_y - s_y a_x); the satellite "
    "is given in the axes at transmission.",
    "rotate_once": "Earth rotation by turning the satellite once by the unrotated travel time; the "
    "satellite is given in the axes at transmission.",
    "exact": "Earth rotation solved with the travel time in three fixed-point iterations; the "
    "satellite is given in the axes at transmission.",
}


def _conventions(options: Mapping[str, OptionValue]) -> tuple[str, ...]:
    return (
        "h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of "
        "the range by the antenna position.",
        _SAGNAC[str(options["sagnac"])],
        "A positive receiver clock bias and every delay lengthen the pseudorange; a positive "
        "satellite clock shortens it.",
    )


def _geometry(position: str) -> tuple[Role, ...]:
    return (
        point("position", "place", 1e8, position),
        rotation("attitude", "body -> nav", "Attitude of the body.", optional=True),
        vector("lever_arm", "m", "body", 100.0, "Antenna from the body origin, in the body frame.",
               optional=True),
        rotation("nav_to_ecef", "nav -> ecef", "Attitude of the navigation frame in the "
                 "earth-fixed frame.", optional=True),
    )  # fmt: skip


def _in_line(distance: float) -> Callable[[Bound], Quantity]:
    """The item on the line through the antenna and the origin of its axes."""

    def item(q: Bound) -> Quantity:
        antenna = _antenna(q)
        length = norm("distance", antenna).elements[0]
        elements = tuple(distance * element / length for element in antenna.elements)
        return Quantity(q.graph, elements, antenna.unit, antenna.frame)

    return item


def _scenes(role: str) -> tuple[Scene, ...]:
    """Satellites above the antenna and below: there the direction has a single element."""
    return (
        Scene(role, "above the antenna", _in_line(ORBIT_RADIUS)),
        Scene(role, "below the antenna", _in_line(-ORBIT_RADIUS)),
    )


MODELS = (
    Model(
        name="pseudorange",
        section="measurement",
        title="Pseudoranges from the antenna to satellites",
        equation="rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)",
        source="Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3",
        roles=(
            *_geometry("Position of the body origin."),
            vector("origin", "m", "ecef", 1e8, "Origin of the navigation frame, earth-fixed.",
                   optional=True),
            scalar("clock_bias", ("m", "s"), -1e8, 1e8, "Receiver clock bias.", optional=True,
                   per_item_states=True),
            vector("satellite_position", "m", "ecef", 1e8, "Satellite, earth-fixed.", item=True),
            scalar("satellite_clock", "s", -0.1, 0.1, "Satellite clock offset.", optional=True,
                   item=True),
            scalar("troposphere", "m", -100.0, 1000.0, "Tropospheric delay.", optional=True,
                   item=True, per_item_states=True),
            scalar("ionosphere", "m", -1000.0, 1000.0, "Ionospheric delay.", optional=True,
                   item=True, per_item_states=True),
        ),
        options=(choice("sagnac", tuple(_RANGES), "Earth rotation during the travel time."),),
        mapped=True,
        always_double=True,
        function=pseudorange,
        frame_rule=_frames,
        conventions=_conventions,
        scenes=_scenes("satellite_position"),
        relative="pseudorange_relative",
    ),
    Model(
        name="pseudorange_relative",
        section="measurement",
        title="Pseudoranges relative to a reference point, for single precision",
        equation="rho - rho0 = (x.x - 2 d.x)/(r + r0) + (w/c)(s_x x_y - s_y x_x) + (b - b0)",
        source="reference-relative form of Farrell (3.44): r^2 - r0^2 = x.x - 2 d.x",
        roles=(
            *_geometry("Position of the body origin from the reference point p0."),
            scalar("clock_bias", "m", -1e6, 1e6, "Receiver clock bias less that of the reference.",
                   optional=True, per_item_states=True),
            vector("satellite_difference", "m", "ecef", 1e8, "Satellite from p0, d = s - p0.",
                   item=True),
            scalar("reference_range", "m", 1e3, 1e8, "r0 = |d|, formed once in double.", item=True,
                   positive=True),
            vector("satellite_xy", "m", "", 1e8, "x and y of the satellite, earth-fixed.", size=2,
                   optional=True, item=True),
        ),
        options=(choice("sagnac", ("first_order", "none"), "Earth rotation, relative to p0."),),
        mapped=True,
        always_double=False,
        function=pseudorange_relative,
        frame_rule=_frames,
        conventions=lambda _options: (
            "rho0 = r0 + S(s, p0) - c dt_s + T + I + b0 is formed in double by the caller; the "
            "measurement is z - rho0.",
            "The navigation frame's origin is the reference point p0.",
        ),
        check=lambda options, bound: (
            (("satellite_xy", "sagnac = 'first_order' needs satellite_xy bound"),)
            if options["sagnac"] == "first_order" and "satellite_xy" not in bound
            else ()
        ),
        scenes=(
            *_scenes("satellite_difference"),
            Scene(
                "reference_range", "", lambda q: norm("length", q.vector("satellite_difference"))
            ),
        ),
    ),
)  # fmt: skip
