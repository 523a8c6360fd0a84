"""Positioning on simulated observations, where the answer is known exactly."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from symnav.demo.atmosphere import klobuchar, saastamoinen
from symnav.demo.geodesy import Geodetic, azimuth_elevation, enu_from_ecef, geodetic_from_ecef
from symnav.demo.models import Array, GeneratedModels
from symnav.demo.positioning import Corrections, Fix, NoFix, solve
from symnav.demo.rinex import KlobucharCoefficients, NavigationFile, ObservationFile
from symnav.demo.satellites import Observed, choose_ephemeris, observe
from tests.demo.book_models import BookRange
from tests.demo.test_geodesy import ecef

NOON = 475200.0
IONOSPHERE = KlobucharCoefficients(
    (1.118e-8, 7.451e-9, -5.960e-8, -5.960e-8), (90110.0, 0.0, -196600.0, -65540.0)
)
ALL = Corrections(ionosphere=IONOSPHERE)
SKY = [(0.3, 1.2), (1.4, 0.5), (2.4, 0.9), (-2.8, 0.3), (-1.9, 0.7), (-0.8, 0.35), (0.9, 0.25)]
"""Azimuths and elevations in radians; all above the mask."""


def satellites_above(receiver: Array, sky: list[tuple[float, float]]) -> Array:
    """Puts satellites at the given directions, 22,000 km away."""
    east, north, up = enu_from_ecef(geodetic_from_ecef(receiver))
    directions = [
        math.cos(e) * (math.sin(a) * east + math.cos(a) * north) + math.sin(e) * up for a, e in sky
    ]
    return receiver + 2.2e7 * np.array(directions)


def simulate(receiver: Array, clock_bias: float, sky: list[tuple[float, float]]) -> Observed:
    """Pseudoranges without noise, with clocks, Sagnac and atmosphere."""
    positions = satellites_above(receiver, sky)
    clocks = 1e-4 * np.sin(np.arange(len(sky)) + 1.0)
    place = geodetic_from_ecef(receiver)
    azimuth, elevation = azimuth_elevation(receiver, positions)
    prediction = BookRange()(
        np.append(receiver, clock_bias),
        satellite_position=positions,
        satellite_clock=clocks,
        troposphere=saastamoinen(place, elevation),
        ionosphere=klobuchar(IONOSPHERE, place, azimuth, elevation, NOON),
    )
    names = tuple(f"G{number:02d}" for number in range(1, len(sky) + 1))
    return Observed(names, prediction.value, positions, clocks)


@settings(max_examples=50, deadline=None)
@given(
    latitude=st.floats(-1.55, 1.55),
    longitude=st.floats(-math.pi, math.pi),
    height=st.floats(-100.0, 8000.0),
    clock_bias=st.floats(-3e5, 3e5),
)
def test_recovers_any_receiver_from_earths_centre(
    latitude: float, longitude: float, height: float, clock_bias: float
) -> None:
    """Anywhere on Earth, a millisecond of receiver clock included."""
    receiver = ecef(Geodetic(latitude, longitude, height))
    fix = solve(simulate(receiver, clock_bias, SKY), NOON, BookRange(), ALL)
    assert isinstance(fix, Fix)
    assert np.linalg.norm(fix.position - receiver) < 1e-3
    assert fix.clock_bias == pytest.approx(clock_bias, abs=1e-3)
    assert np.abs(fix.residuals).max() < 1e-3


@settings(max_examples=20, deadline=None)
@given(order=st.permutations(range(len(SKY))))
def test_order_of_satellites_is_irrelevant(order: list[int]) -> None:
    """A fix does not depend on the order of the file."""
    receiver = ecef(Geodetic(0.6, 2.4, 70.0))
    observed = simulate(receiver, 100.0, SKY)
    noisy = replace(observed, pseudoranges=observed.pseudoranges + np.cos(3.0 * np.arange(7)))
    shuffled = Observed(
        tuple(noisy.satellites[k] for k in order),
        noisy.pseudoranges[order],
        noisy.positions[order],
        noisy.clocks[order],
    )
    one = solve(noisy, NOON, BookRange(), ALL)
    other = solve(shuffled, NOON, BookRange(), ALL)
    assert isinstance(one, Fix)
    assert isinstance(other, Fix)
    np.testing.assert_allclose(one.position, other.position, atol=1e-4)


def test_mask_leaves_low_satellites_out() -> None:
    """A satellite at five degrees is not used, whatever its range says."""
    receiver = ecef(Geodetic(0.6, 2.4, 70.0))
    observed = simulate(receiver, 0.0, [*SKY, (2.0, math.radians(5.0))])
    observed.pseudoranges[-1] += 30.0
    fix = solve(observed, NOON, BookRange(), ALL)
    assert isinstance(fix, Fix)
    assert fix.satellites == observed.satellites[:-1]
    assert np.linalg.norm(fix.position - receiver) < 1e-3


def test_low_satellites_weigh_less() -> None:
    """The same error moves the position less from a low satellite than without weights."""
    receiver = ecef(Geodetic(0.6, 2.4, 70.0))
    observed = simulate(receiver, 0.0, SKY)
    observed.pseudoranges[-1] += 10.0
    fix = solve(observed, NOON, BookRange(), ALL)
    assert isinstance(fix, Fix)
    state = np.append(receiver, 0.0)
    nothing = np.zeros(len(SKY))
    jacobian = (
        BookRange()(
            state,
            satellite_position=observed.positions,
            satellite_clock=nothing,
            troposphere=nothing,
            ionosphere=nothing,
        )
    ).jacobian
    weights = np.diag([math.sin(elevation) ** 2 for _, elevation in SKY])
    expected = np.linalg.solve(
        jacobian.T @ weights @ jacobian, jacobian.T @ weights @ (10.0 * np.eye(len(SKY))[-1])
    )
    np.testing.assert_allclose(fix.position - receiver, expected[:3], atol=0.01)


def test_three_satellites_are_too_few() -> None:
    """Four unknowns need four satellites, and none at all is no crash."""
    receiver = ecef(Geodetic(0.6, 2.4, 70.0))
    for sky in (SKY[:3], []):
        if sky:
            observed = simulate(receiver, 0.0, sky)
        else:
            observed = Observed((), np.empty(0), np.empty((0, 3)), np.empty(0))
        outcome = solve(observed, NOON, BookRange(), ALL)
        assert isinstance(outcome, NoFix)
        assert f"{len(sky)} usable satellites" in outcome.reason


def test_coincident_satellites_do_not_determine_a_position() -> None:
    """Five times the same satellite is one equation."""
    receiver = ecef(Geodetic(0.6, 2.4, 70.0))
    observed = simulate(receiver, 0.0, [SKY[0]] * 5)
    outcome = solve(replace(observed, clocks=np.zeros(5)), NOON, BookRange(), ALL)
    assert isinstance(outcome, NoFix)


def test_impossible_ranges_are_not_solved() -> None:
    """Not-a-number in a range does not become a position."""
    observed = simulate(ecef(Geodetic(0.6, 2.4, 70.0)), 0.0, SKY)
    observed.pseudoranges[2] = math.nan
    outcome = solve(observed, NOON, BookRange(), ALL)
    assert isinstance(outcome, NoFix)
    assert "finite" in outcome.reason


def test_choice_of_message(navigation: NavigationFile) -> None:
    """The nearest healthy message serves, for two hours and not longer."""
    chosen = choose_ephemeris(navigation.ephemerides, "G03", 2149, NOON)
    assert chosen is not None
    assert chosen.toe == NOON
    later = choose_ephemeris(navigation.ephemerides, "G03", 2149, NOON + 5000.0)
    assert later is not None
    assert later.toe == NOON + 7200.0
    assert choose_ephemeris(navigation.ephemerides, "G03", 2149, NOON - 7201.0) is None
    assert choose_ephemeris(navigation.ephemerides, "G03", 2150, NOON) is None
    assert choose_ephemeris(navigation.ephemerides, "G32", 2149, NOON) is None
    sick = [replace(m, health=1) for m in navigation.ephemerides]
    assert choose_ephemeris(sick, "G03", 2149, NOON) is None


def test_transmission_time(
    observations: ObservationFile, navigation: NavigationFile, book: GeneratedModels
) -> None:
    """Range by the satellite's own clock: reception minus transmission is the pseudorange."""
    epoch = observations.epochs[0]
    observed = observe(epoch, navigation.ephemerides, book.broadcast_orbit)
    assert len(observed.satellites) == 10
    assert all(satellite.startswith("G") for satellite in observed.satellites)
    message = choose_ephemeris(navigation.ephemerides, observed.satellites[0], 2149, NOON)
    assert message is not None
    names = [n for n in type(message).__dataclass_fields__ if n not in NOT_ARGUMENTS]
    arguments = {name: np.array([getattr(message, name)]) for name in names}
    sent = NOON - observed.pseudoranges[0] / 299792458.0 - observed.clocks[0]
    there = book.broadcast_orbit(time=np.array([sent]), **arguments)
    np.testing.assert_allclose(there.position[0], observed.positions[0], atol=1e-4)
    np.testing.assert_allclose(there.clock[0], observed.clocks[0], atol=1e-15)


NOT_ARGUMENTS = {"satellite", "message", "toc_week", "toe_week", "health"}
