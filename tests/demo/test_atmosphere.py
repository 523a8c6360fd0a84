"""Tropospheric and ionospheric delays against values and formulas of their sources."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from symnav.demo.atmosphere import klobuchar, saastamoinen, standard_atmosphere
from symnav.demo.geodesy import Geodetic
from symnav.demo.rinex import KlobucharCoefficients

LIGHT = 299792458.0
COEFFICIENTS = KlobucharCoefficients(
    (1.118e-8, 7.451e-9, -5.960e-8, -5.960e-8), (90110.0, 0.0, -196600.0, -65540.0)
)
PLACES = st.builds(
    Geodetic, st.floats(-1.5, 1.5), st.floats(-math.pi, math.pi), st.floats(-400.0, 9000.0)
)
ELEVATIONS = st.floats(math.radians(5.0), math.pi / 2)


@pytest.mark.parametrize(
    ("height", "pressure", "temperature"),
    [(0.0, 1013.25, 288.15), (1000.0, 898.75, 281.65), (5000.0, 540.20, 255.65)],
)
def test_standard_atmosphere(height: float, pressure: float, temperature: float) -> None:
    """The tabulated values of the International Standard Atmosphere."""
    p, t, _ = standard_atmosphere(height)
    assert p == pytest.approx(pressure, rel=2e-4)
    assert t == pytest.approx(temperature, abs=1e-6)


def test_vapour_pressure() -> None:
    """Water saturates at 17.04 hPa at 15 degrees Celsius; the model holds half of it."""
    assert standard_atmosphere(0.0)[2] == pytest.approx(17.04 / 2, rel=1e-3)


def test_zenith_delay_at_sea_level() -> None:
    """2.307 m hydrostatic at 45 degrees, and 0.0022768 (1255/T + 0.05) e of water vapour."""
    zenith = saastamoinen(Geodetic(math.pi / 4, 0.0, 0.0), np.array([math.pi / 2]))[0]
    wet = 0.0022768 * (1255.0 / 288.15 + 0.05) * 17.04 / 2
    assert zenith == pytest.approx(0.0022768 * 1013.25 + wet, abs=1e-4)


@given(place=PLACES, elevation=ELEVATIONS)
def test_troposphere_near_cosecant(place: Geodetic, elevation: float) -> None:
    """Between the zenith delay and the flat-Earth cosecant of it, and always positive."""
    zenith, slant = saastamoinen(place, np.array([math.pi / 2, elevation]))
    assert 0.0 < zenith * (1.0 - 1e-6) <= slant <= 1.001 * zenith / math.sin(elevation)


@given(place=PLACES, height=st.floats(-1e7, 1e9))
def test_troposphere_is_finite_at_any_height(place: Geodetic, height: float) -> None:
    """A search far from the ground meets the atmosphere's nearest layer, not a complex power."""
    delay = saastamoinen(place._replace(height=height), np.array([0.5]))
    assert np.isfinite(delay).all()
    assert (delay > 0.0).all()


def book_klobuchar(place: Geodetic, azimuth: float, elevation: float, time: float) -> float:
    """IS-GPS-200 figure 20-4 with scalars, branch by branch."""
    e = elevation / math.pi
    psi = 0.0137 / (e + 0.11) - 0.022
    phi = place.latitude / math.pi + psi * math.cos(azimuth)
    if phi > 0.416:
        phi = 0.416
    elif phi < -0.416:
        phi = -0.416
    lam = place.longitude / math.pi + psi * math.sin(azimuth) / math.cos(phi * math.pi)
    phi_m = phi + 0.064 * math.cos((lam - 1.617) * math.pi)
    t = 4.32e4 * lam + time
    while t >= 86400.0:
        t -= 86400.0
    while t < 0.0:
        t += 86400.0
    per = sum(b * phi_m**n for n, b in enumerate(COEFFICIENTS.beta))
    per = 72000.0 if per < 72000.0 else per
    amp = sum(a * phi_m**n for n, a in enumerate(COEFFICIENTS.alpha))
    amp = 0.0 if amp < 0.0 else amp
    x = 2.0 * math.pi * (t - 50400.0) / per
    f = 1.0 + 16.0 * (0.53 - e) ** 3
    if abs(x) < 1.57:
        return LIGHT * f * (5e-9 + amp * (1.0 - x**2 / 2.0 + x**4 / 24.0))
    return LIGHT * f * 5e-9


@given(
    place=PLACES,
    azimuth=st.floats(-math.pi, math.pi),
    elevation=ELEVATIONS,
    time=st.floats(0.0, 604799.0),
)
def test_klobuchar_follows_the_document(
    place: Geodetic, azimuth: float, elevation: float, time: float
) -> None:
    """The vectorised function against the figure."""
    expected = book_klobuchar(place, azimuth, elevation, time)
    delay = klobuchar(COEFFICIENTS, place, np.array([azimuth]), np.array([elevation]), time)
    assert delay[0] == pytest.approx(expected, rel=1e-9)


def test_klobuchar_by_night_and_by_day() -> None:
    """Five nanoseconds at the zenith by night; most at two in the afternoon, local time."""
    equator = Geodetic(0.0, 0.0, 0.0)
    zenith, north = np.array([math.pi / 2]), np.array([0.0])
    hours = np.arange(24)
    day = [klobuchar(COEFFICIENTS, equator, north, zenith, 3600.0 * h)[0] for h in hours]
    assert min(day) == pytest.approx(LIGHT * 5e-9, rel=1e-3)
    assert int(np.argmax(day)) == 14
