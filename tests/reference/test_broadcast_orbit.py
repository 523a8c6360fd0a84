"""The broadcast orbit against Newtonian motion and the magnitudes known of GNSS satellites."""

from typing import Any

import pytest
from mpmath import mp, mpf

from .algebra import (
    Vector,
    about,
    add,
    cross,
    derivative,
    dot,
    exact,
    length,
    sandwich,
    scale,
    subtract,
)
from .broadcast_orbit import GRAVITATION, RELATIVITY, eccentric_anomaly, position_at, since, value
from .drawing import far, vector
from .earth import LIGHT_SPEED, ROTATION_RATE

KEPLERIAN = {
    "toe": "302400",
    "toc": "302384",
    "sqrt_a": "5153.65531",
    "eccentricity": "0.00912",
    "mean_anomaly": "-1.2345",
    "inclination": "0.961234",
    "right_ascension": "2.0123",
    "argument_of_perigee": "-0.7654",
    "af0": "-1.5e-4",
    "af1": "2.3e-12",
    "af2": "4e-17",
    "group_delay": "-1.1e-8",
}
PERTURBED = KEPLERIAN | {
    "mean_motion_difference": "4.5e-9",
    "inclination_rate": "-1.9e-10",
    "right_ascension_rate": "-8.1e-9",
    "cuc": "1.7e-6",
    "cus": "8.3e-6",
    "crc": "214.5",
    "crs": "33.1",
    "cic": "-9.3e-8",
    "cis": "1.5e-7",
}


def quantities(elements: dict[str, str], time: mpf) -> dict[str, Any]:
    """Describe an ephemeris and a time."""
    numbers = {name: vector([mpf(text)]) for name, text in elements.items()}
    return {**numbers, "time": vector([time])}


def inertial(elements: dict[str, str], time: mpf, system: str) -> Vector:
    """Turn the position into inertial axes: those of the Earth at the start of the week."""
    q = quantities(elements, time)
    angle = exact(ROTATION_RATE) * (since(time, mpf(elements["toe"])) + mpf(elements["toe"]))
    return sandwich(about("z", angle), position_at(q, {"system": system}, time))


@pytest.mark.parametrize("system", ["gps", "galileo"])
@pytest.mark.parametrize("time", [281000, 302400, 309600, 323000])
def test_kepler_motion_obeys_newton(system: str, time: int) -> None:
    """Without corrections the satellite falls freely: Newton's equation holds at any time."""

    def place(t: Vector) -> Vector:
        return inertial(KEPLERIAN, t[0], system)

    def speed(t: Vector) -> Vector:
        return [row[0] for row in derivative(place, t)]

    r = place([mpf(time)])
    acceleration = [row[0] for row in derivative(speed, [mpf(time)])]
    gravity = scale(-exact(GRAVITATION[system]) / length(r) ** 3, r)
    assert far(acceleration, gravity) < mpf("1e-40")


def test_orbit_elements() -> None:
    """Radius between perigee and apogee, inclination, node and period are those of the elements."""
    axis, e = mpf(KEPLERIAN["sqrt_a"]) ** 2, mpf(KEPLERIAN["eccentricity"])
    mu = exact(GRAVITATION["gps"])
    period = 2 * mp.pi * mp.sqrt(axis**3 / mu)
    assert abs(period - mpf("43078")) < 60
    times = [mpf(290000) + k * period / 60 for k in range(61)]
    track = [inertial(KEPLERIAN, t, "gps") for t in times]
    assert far(track[0], track[-1]) < mpf("1e-40") * axis
    distances = [length(r) for r in track]
    assert axis * (1 - e) <= min(distances) < axis * (1 - e) * mpf("1.0001")
    assert axis * (1 + e) * mpf("0.9999") < max(distances) <= axis * (1 + e)
    normal = cross(track[0], track[10])
    inclination = mp.acos(normal[2] / length(normal))
    assert abs(inclination - mpf(KEPLERIAN["inclination"])) < mpf("1e-45")
    node = mp.atan2(normal[0], -normal[1])
    assert abs(node - mpf(KEPLERIAN["right_ascension"])) < mpf("1e-45")


def test_velocity() -> None:
    """The velocity is the rate of the position, by an independent difference of eighth order."""
    t, h = mpf(309600), mpf("0.5")
    q = quantities(PERTURBED, t)
    outputs = value(q, {})
    track = {k: position_at(q, {}, t + k * h) for k in range(-4, 5)}
    weights = {1: mpf(4) / 5, 2: mpf(-1) / 5, 3: mpf(4) / 105, 4: mpf(-1) / 280}
    steps = [scale(w / h, subtract(track[k], track[-k])) for k, w in weights.items()]
    assert far(outputs["velocity"], add(*steps)) < mpf("1e-25")
    earth = [mpf(0), mpf(0), exact(ROTATION_RATE)]
    speed = length(add(outputs["velocity"], cross(earth, outputs["position"])))
    assert 3800 < speed < 3950


@pytest.mark.parametrize(
    ("rate", "base"),
    [("mean_motion_difference", "mean_anomaly"), ("inclination_rate", "inclination")],
)
def test_rates_move_their_elements(rate: str, base: str) -> None:
    """After a time an element is what it was, plus rate times time."""
    t, size = mpf(309600), mpf("3e-9")
    moved = mpf(KEPLERIAN[base]) + size * (t - mpf(KEPLERIAN["toe"]))
    by_rate = value({**quantities(KEPLERIAN, t), rate: vector([size])}, {})
    by_element = value({**quantities(KEPLERIAN, t), base: vector([moved])}, {})
    assert far(by_rate["position"], by_element["position"]) < mpf("1e-40")


def test_right_ascension_rate_turns_the_plane() -> None:
    """The drift of the node is a rotation about the pole, against that of the Earth."""
    t, rate = mpf(309600), mpf("-8e-9")
    plain = value(quantities(KEPLERIAN, t), {})["position"]
    drifted = value({**quantities(KEPLERIAN, t), "right_ascension_rate": vector([rate])}, {})
    angle = rate * (t - mpf(KEPLERIAN["toe"]))
    assert far(drifted["position"], sandwich(about("z", angle), plain)) < mpf("1e-40")


@pytest.mark.parametrize("family", ["cu", "cr", "ci"])
@pytest.mark.parametrize(("eighths", "cosine", "sine"), [(0, 1, 0), (1, 0, 1), (2, -1, 0)])
def test_harmonic_corrections(family: str, eighths: int, cosine: int, sine: int) -> None:
    """At 0, 45 and 90 degrees from the node the twice-per-orbit terms act in full or not at all."""
    toe, zero = mpf(KEPLERIAN["toe"]), mpf(0)
    latitude = eighths * mp.pi / 4
    size = mpf(100) if family == "cr" else mpf("1e-5")
    circular = quantities(KEPLERIAN, toe) | {
        "eccentricity": vector([zero]),
        "mean_anomaly": vector([latitude + 1]),
        "argument_of_perigee": vector([mpf(-1)]),
    }
    plain = value(circular, {})["position"]
    for letter, factor in (("c", cosine), ("s", sine)):
        moved = value({**circular, family + letter: vector([size])}, {})["position"]
        if family == "cr":
            expected = scale(1 + factor * size / length(plain), plain)
        elif family == "cu":
            along = circular | {"argument_of_perigee": vector([factor * size - 1])}
            expected = value(along, {})["position"]
        else:
            tilted = mpf(KEPLERIAN["inclination"]) + factor * size
            expected = value(circular | {"inclination": vector([tilted])}, {})["position"]
        assert far(moved, expected) < mpf("1e-40")


def test_gravitation_of_the_other_system() -> None:
    """Two hours from the epoch the wrong constant costs metres."""
    q = quantities(KEPLERIAN, mpf(302400 + 7200))
    ours, theirs = (value(q, {"system": system})["position"] for system in ("gps", "galileo"))
    assert 1 < length(subtract(ours, theirs)) < 3


def test_clock() -> None:
    """Relativity is -2 r.v/c^2 of the Keplerian orbit; polynomial and group delay add to it."""
    t = mpf(309600)
    outputs = value(quantities(KEPLERIAN, t), {})
    r = inertial(KEPLERIAN, t, "gps")
    v = [row[0] for row in derivative(lambda s: inertial(KEPLERIAN, s[0], "gps"), [t])]
    elapsed = t - mpf(KEPLERIAN["toc"])
    relativity = -2 * dot(r, v) / exact(LIGHT_SPEED) ** 2
    polynomial = mpf("-1.5e-4") + mpf("2.3e-12") * elapsed + mpf("4e-17") * elapsed**2
    expected = polynomial + relativity + mpf("1.1e-8")
    assert abs(outputs["clock"][0] - expected) < abs(relativity) * mpf("2e-10")
    assert abs(outputs["clock_rate"][0] - mpf("2.3e-12")) < mpf("1e-11")
    later, earlier = (value(quantities(KEPLERIAN, t + k), {})["clock"][0] for k in (1, -1))
    assert abs((later - earlier) / 2 - outputs["clock_rate"][0]) < mpf("1e-19")


@pytest.mark.parametrize("system", ["gps", "galileo"])
def test_relativistic_constant(system: str) -> None:
    """The printed constant is the theoretical one, rounded to its ten digits."""
    theory = -2 * mp.sqrt(exact(GRAVITATION[system])) / exact(LIGHT_SPEED) ** 2
    assert abs(exact(RELATIVITY[system]) - theory) < mpf("5.1e-20")


@pytest.mark.parametrize("toe", ["600", "604200"])
def test_change_of_week(toe: str) -> None:
    """Elapsed time crosses the change of week to the nearer side."""
    elements = KEPLERIAN | {"toe": toe, "toc": toe}
    other = mpf(604000) if toe == "600" else mpf(800)
    continued = other + (-604800 if toe == "600" else 604800)
    wrapped = value(quantities(elements, other), {})
    straight = value(quantities(elements, continued), {})
    assert far(wrapped["position"], straight["position"]) < mpf("1e-40")
    assert far(wrapped["velocity"], straight["velocity"]) < mpf("1e-40")
    assert abs(wrapped["clock"][0] - straight["clock"][0]) < mpf("1e-45")


@pytest.mark.parametrize("eccentricity", ["0", "0.02", "0.7", "0.99"])
@pytest.mark.parametrize("mean", ["-40", "-3.1", "0", "1e-8", "2.2"])
def test_kepler_equation(eccentricity: str, mean: str) -> None:
    """The equation is solved to the working precision."""
    e = mpf(eccentricity)
    anomaly = eccentric_anomaly(mpf(mean), e)
    assert abs(anomaly - e * mp.sin(anomaly) - mpf(mean)) < mpf("1e-47")
