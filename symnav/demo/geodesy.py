"""Geodetic coordinates and local directions on the WGS 84 ellipsoid, in NumPy."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from symnav.demo.constants import WGS84_FLATTENING, WGS84_SEMI_MAJOR_AXIS
from symnav.demo.models import Array

_BOWRING_ITERATIONS = 3


class Geodetic(NamedTuple):
    """Geodetic latitude and longitude in radians, height above the ellipsoid in metres."""

    latitude: float
    longitude: float
    height: float


def geodetic_from_ecef(position: Array) -> Geodetic:
    """Converts an ECEF position; valid anywhere but within some kilometres of Earth's centre.

    Bowring, B. R. (1976), Transformation from spatial to geographical coordinates, Survey Review
    23(181). Repeated on the reduced latitude, it converges to rounding at any satellite height.
    """
    x, y, z = (float(component) for component in position)
    a = WGS84_SEMI_MAJOR_AXIS
    b = a * (1.0 - WGS84_FLATTENING)
    e2 = WGS84_FLATTENING * (2.0 - WGS84_FLATTENING)
    second_e2 = e2 / (1.0 - e2)
    p = math.hypot(x, y)
    reduced = math.atan2(a * z, b * p)
    latitude = reduced
    for _ in range(_BOWRING_ITERATIONS):
        latitude = math.atan2(
            z + second_e2 * b * math.sin(reduced) ** 3, p - e2 * a * math.cos(reduced) ** 3
        )
        reduced = math.atan2(b * math.sin(latitude), a * math.cos(latitude))
    # This form of the height has no division and so holds at the poles as well.
    sine = math.sin(latitude)
    height = p * math.cos(latitude) + z * sine - a * math.sqrt(1.0 - e2 * sine * sine)
    return Geodetic(latitude, math.atan2(y, x), height)


def enu_from_ecef(place: Geodetic) -> Array:
    """Returns the rotation from ECEF to the local east, north, up axes of a place."""
    sin_lat, cos_lat = math.sin(place.latitude), math.cos(place.latitude)
    sin_lon, cos_lon = math.sin(place.longitude), math.cos(place.longitude)
    return np.array(
        [
            [-sin_lon, cos_lon, 0.0],
            [-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat],
            [cos_lat * cos_lon, cos_lat * sin_lon, sin_lat],
        ]
    )


def azimuth_elevation(receiver: Array, satellites: Array) -> tuple[Array, Array]:
    """Returns azimuth (from north over east) and elevation of satellites in radians.

    Args:
        receiver: ECEF position, shape (3,).
        satellites: ECEF positions, shape (n, 3).
    """
    sight = (satellites - receiver) @ enu_from_ecef(geodetic_from_ecef(receiver)).T
    east, north, up = sight.T
    return np.arctan2(east, north), np.arctan2(up, np.hypot(east, north))
