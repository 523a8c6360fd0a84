"""Geodetic coordinates and local directions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from symnav.demo.geodesy import Geodetic, azimuth_elevation, enu_from_ecef, geodetic_from_ecef
from symnav.demo.models import Array

A = 6378137.0
E2 = 0.00669437999014


def ecef(place: Geodetic) -> Array:
    """The defining formula, from geodetic to ECEF."""
    n = A / math.sqrt(1.0 - E2 * math.sin(place.latitude) ** 2)
    p = (n + place.height) * math.cos(place.latitude)
    z = (n * (1.0 - E2) + place.height) * math.sin(place.latitude)
    return np.array([p * math.cos(place.longitude), p * math.sin(place.longitude), z])


@given(
    latitude=st.floats(-math.pi / 2, math.pi / 2),
    longitude=st.floats(-3.14, 3.14),
    height=st.floats(-10e3, 30e6),
)
def test_round_trip(latitude: float, longitude: float, height: float) -> None:
    """From the ground to satellites, poles included, to a micrometre."""
    there = ecef(Geodetic(latitude, longitude, height))
    back = geodetic_from_ecef(there)
    assert back.latitude == pytest.approx(latitude, abs=1e-12)
    assert back.height == pytest.approx(height, abs=1e-6)
    assert np.linalg.norm(ecef(back) - there) < 1e-6


@given(latitude=st.floats(-1.5, 1.5), longitude=st.floats(-3.1, 3.1))
def test_local_axes(latitude: float, longitude: float) -> None:
    """East, north and up are the directions in which longitude, latitude and height grow."""
    here = Geodetic(latitude, longitude, 100.0)
    step = 1e-6
    moves = [
        ecef(here._replace(longitude=longitude + step)) - ecef(here),
        ecef(here._replace(latitude=latitude + step)) - ecef(here),
        ecef(here._replace(height=101.0)) - ecef(here),
    ]
    directions = np.array([move / np.linalg.norm(move) for move in moves])
    np.testing.assert_allclose(enu_from_ecef(here), directions, atol=1e-6)


@given(
    latitude=st.floats(-1.5, 1.5),
    longitude=st.floats(-3.1, 3.1),
    azimuth=st.floats(-3.1, 3.1),
    elevation=st.floats(-1.5, 1.5),
)
def test_directions(latitude: float, longitude: float, azimuth: float, elevation: float) -> None:
    """A satellite put at an azimuth and elevation is seen there."""
    receiver = ecef(Geodetic(latitude, longitude, 0.0))
    east, north, up = enu_from_ecef(Geodetic(latitude, longitude, 0.0))
    level = math.sin(azimuth) * east + math.cos(azimuth) * north
    satellite = receiver + 2e7 * (math.cos(elevation) * level + math.sin(elevation) * up)
    seen_azimuth, seen_elevation = azimuth_elevation(receiver, satellite[np.newaxis])
    assert seen_elevation[0] == pytest.approx(elevation, abs=1e-9)
    assert math.remainder(seen_azimuth[0] - azimuth, math.tau) == pytest.approx(0.0, abs=1e-7)
