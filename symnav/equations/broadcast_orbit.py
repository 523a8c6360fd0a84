"""Satellite position, velocity and clock from a broadcast ephemeris (GPS LNAV and Galileo).

Source: IS-GPS-200, 20.3.3.4.3 (table 20-IV) and 20.3.3.3.3.1; Galileo OS SIS ICD, 5.1.1 and 5.1.4.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

from symnav import units
from symnav.equations.bound import Bound, Rate, Results, let
from symnav.equations.model import Model, OptionValue, Role, choice, scalar
from symnav.frames import earth
from symnav.quantities import Quantity, elementwise

WEEK = 604_800.0
#: Newton steps for Kepler's equation. With e <= 0.1 and the start E = M + e sin M the error is
#: below e^2 at first and then e/2 times its square over (1 - e): under 1e-16 after three.
NEWTON_STEPS = 4


def broadcast_orbit(q: Bound) -> Results:
    """Position in the earth-fixed axes at the time given, its rate, and the satellite clock."""
    system = str(q.options["system"])
    tk = _since(q, "since_toe", "toe")
    a = let("semi_major_axis", q.vector("sqrt_a") * q.vector("sqrt_a"))
    gm = q.constant("m^3/s^2", earth.GRAVITATIONAL_PARAMETER[system])
    mean_motion = let(
        "mean_motion",
        _map("computed_motion", lambda e: sp.sqrt(gm.elements[0] / (e * e * e)), a, "rad/s")
        + q.vector("mean_motion_difference"),
    )
    mean = let("mean_anomaly_now", q.vector("mean_anomaly") + mean_motion * tk)
    e = q.vector("eccentricity")
    anomaly = _kepler(mean, e)
    position = _position(q, tk, a, e, anomaly)
    clock = _clock(q, system, e, anomaly)
    return Results(
        {"position": position, "clock": clock},
        rates={"velocity": Rate("position", "time"), "clock_rate": Rate("clock", "time")},
    )


def _since(q: Bound, name: str, epoch: str) -> Quantity:
    """Time since an epoch of the week, in (-half a week, half a week]."""
    raw = let(f"{name}_raw", q.vector("time") - q.vector(epoch)).elements[0]
    graph = q.graph
    weeks = sp.floor(sp.Rational(1, 2) + raw / sp.Integer(604_800))
    (turns,) = graph.define(f"{name}_weeks", [weeks])
    (wrapped,) = graph.define(name, [raw - sp.Integer(604_800) * turns])
    partials = graph.local_partials([raw])
    if partials:
        graph.vertex(name, (wrapped,), partials)
    return Quantity(graph, (wrapped,), units.parse("s"))


def _kepler(mean: Quantity, eccentricity: Quantity) -> Quantity:
    """E with E - e sin E = M, by Newton's method; its derivatives by the implicit function.

    dE/dM = 1/(1 - e cos E) and dE/de = sin E/(1 - e cos E).
    """
    graph = mean.graph
    m, e = mean.elements[0], eccentricity.elements[0]
    (value,) = graph.define("anomaly_0", [m + e * sp.sin(m)])
    for k in range(1, NEWTON_STEPS + 1):
        step = (value - e * sp.sin(value) - m) / (1 - e * sp.cos(value))
        name = "eccentric_anomaly" if k == NEWTON_STEPS else f"anomaly_{k}"
        (value,) = graph.define(name, [value - step])
    if graph.moves(m, e):
        slope = graph.define(
            "anomaly_slope",
            [1 / (1 - e * sp.cos(value)), sp.sin(value) / (1 - e * sp.cos(value))],
            suffixes=("mean", "eccentricity"),
        )
        partials = {}
        for symbol, derivative in zip((m, e), slope, strict=True):
            for name, rows in graph.local_partials([symbol]).items():
                partials[name] = tuple(tuple(derivative * x for x in row) for row in rows)
        graph.vertex("eccentric_anomaly", (value,), partials)
    return Quantity(graph, (value,), units.ONE)


def _position(q: Bound, tk: Quantity, a: Quantity, e: Quantity, anomaly: Quantity) -> Quantity:
    one = q.constant("1", 1.0)
    cos_e, sin_e = _map("cos_anomaly", sp.cos, anomaly), _map("sin_anomaly", sp.sin, anomaly)
    # The true anomaly leads the eccentric one by twice the angle of (1 - b cos E, b sin E), where
    # b = e/(1 + sqrt(1 - e^2)). The point stays away from the origin whatever E is, which an
    # analysis that knows intervals can see; that of cos E - e and sin E circles around it.
    ratio = _map("lead_ratio", lambda x: x / (1 + sp.sqrt(1 - x * x)), e)
    y, x = let("lead_y", ratio * sin_e), let("lead_x", one - ratio * cos_e)
    lead = Quantity(q.graph, (sp.atan2(y.elements[0], x.elements[0]),), one.unit)
    true = let("true_anomaly", anomaly + 2.0 * let("lead", lead))
    phi = let("latitude_argument", true + q.vector("argument_of_perigee"))
    double = let("doubled_argument", 2.0 * phi)
    c2, s2 = _map("cos_doubled", sp.cos, double), _map("sin_doubled", sp.sin, double)

    def harmonic(name: str) -> Quantity:
        """C_s sin 2 phi + C_c cos 2 phi."""
        return q.vector(f"{name}s") * s2 + q.vector(f"{name}c") * c2

    u = let("corrected_argument", phi + harmonic("cu"))
    r = let("radius", a * (one - e * cos_e) + harmonic("cr"))
    i = let(
        "inclination_now",
        q.vector("inclination") + harmonic("ci") + q.vector("inclination_rate") * tk,
    )
    rate = let(
        "node_rate", q.vector("right_ascension_rate") - q.constant("rad/s", earth.ROTATION_RATE)
    )
    node = let(
        "node",
        q.vector("right_ascension")
        + rate * tk
        - q.constant("rad/s", earth.ROTATION_RATE) * q.vector("toe"),
    )
    xo = let("in_plane_x", r * _map("cos_argument", sp.cos, u))
    yo = let("in_plane_y", r * _map("sin_argument", sp.sin, u))
    ci, si = _map("cos_inclination", sp.cos, i), _map("sin_inclination", sp.sin, i)
    co, so = _map("cos_node", sp.cos, node), _map("sin_node", sp.sin, node)
    yc = let("in_plane_level", yo * ci)
    elements = (xo * co - yc * so, xo * so + yc * co, yo * si)
    stacked = tuple(part.elements[0] for part in elements)
    return let("position", Quantity(q.graph, stacked, units.parse("m"), q.frames.get("ecef")))


def _clock(q: Bound, system: str, e: Quantity, anomaly: Quantity) -> Quantity:
    """af0 + af1 dt + af2 dt^2 + F e sqrt(A) sin E - group delay."""
    dt = _since(q, "since_toc", "toc")
    drift = let("clock_drift", q.vector("af1") + q.vector("af2") * dt)
    factor = Quantity(q.graph, q.constant("1", earth.RELATIVISTIC_CLOCK[system]).elements,
                      units.parse("s") / q.vector("sqrt_a").unit)  # fmt: skip
    eccentric = let("eccentric_root", e * q.vector("sqrt_a"))
    sine = _map("sin_anomaly_clock", sp.sin, anomaly)
    relativity = let("relativity", factor * (eccentric * sine))
    clock = q.vector("af0") + drift * dt + relativity
    delay = q.optional("group_delay")
    return let("clock", clock if delay is None else clock - delay)


def _map(
    name: str, function: Callable[[sp.Expr], sp.Expr], argument: Quantity, unit: str = "1"
) -> Quantity:
    return elementwise(name, function, argument, units.parse(unit))


def _field(name: str, unit: str, lower: float, upper: float, description: str) -> Role:
    return scalar(name, unit, lower, upper, description)


def _small(name: str, unit: str, bound: float, description: str) -> Role:
    return scalar(name, unit, -bound, bound, description)


def _conventions(options: Mapping[str, OptionValue]) -> tuple[str, ...]:
    system = str(options["system"])
    return (
        f"GM = {earth.GRAVITATIONAL_PARAMETER[system]:.9e} m^3/s^2 of {system}; the other system's "
        "value costs metres after two hours.",
        "Earth-fixed axes at the time given, which is the time of transmission for a pseudorange.",
        f"Kepler's equation by {NEWTON_STEPS} Newton steps: error below 1e-16 rad for "
        "eccentricities up to 0.1.",
        "group_delay is TGD or BGD of the signal: the clock is that of the signal.",
    )


MODELS = (
    Model(
        name="broadcast_orbit",
        section="measurement",
        title="Satellite position, velocity and clock from a broadcast ephemeris",
        equation="E - e sin E = M;  r, u, i with harmonic corrections;  R_z(Omega) R_x(i)",
        source="IS-GPS-200, table 20-IV and 20.3.3.3.3.1; Galileo OS SIS ICD 5.1",
        roles=(
            _field(
                "time", "s", -3600.0, WEEK + 3600.0, "Time of week; may pass its ends by an hour."
            ),
            _field("toe", "s", 0.0, WEEK, "Reference time of the ephemeris."),
            _field("toc", "s", 0.0, WEEK, "Reference time of the clock."),
            scalar(
                "sqrt_a",
                "m^1/2",
                4000.0,
                7000.0,
                "Square root of the semi-major axis.",
                positive=True,
            ),
            _field("eccentricity", "1", 0.0, 0.1, "Eccentricity."),
            _small("mean_anomaly", "rad", 3.2, "Mean anomaly at the reference time."),
            _small("mean_motion_difference", "rad/s", 1e-6, "Correction of the mean motion."),
            _small("inclination", "rad", 3.2, "Inclination at the reference time."),
            _small("inclination_rate", "rad/s", 1e-6, "Rate of the inclination."),
            _small("right_ascension", "rad", 3.2, "Longitude of the node at the week's start."),
            _small("right_ascension_rate", "rad/s", 1e-6, "Rate of the right ascension."),
            _small("argument_of_perigee", "rad", 3.2, "Argument of perigee."),
            _small("cuc", "rad", 1e-3, "Cosine correction of the argument of latitude."),
            _small("cus", "rad", 1e-3, "Sine correction of the argument of latitude."),
            _small("crc", "m", 1e4, "Cosine correction of the radius."),
            _small("crs", "m", 1e4, "Sine correction of the radius."),
            _small("cic", "rad", 1e-3, "Cosine correction of the inclination."),
            _small("cis", "rad", 1e-3, "Sine correction of the inclination."),
            _small("af0", "s", 0.1, "Clock offset."),
            _small("af1", "1", 1e-6, "Clock drift."),
            _small("af2", "1/s", 1e-9, "Clock drift rate."),
            scalar("group_delay", "s", -1e-5, 1e-5, "TGD or BGD of the signal.", optional=True),
        ),
        options=(choice("system", ("gps", "galileo"), "Satellite system."),),
        mapped=False,
        always_double=True,
        function=broadcast_orbit,
        differentiated=("time",),
        conventions=_conventions,
    ),
)
