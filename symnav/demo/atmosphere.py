"""Signal delays in the troposphere and in the ionosphere, as plain NumPy functions."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from symnav.demo.constants import SPEED_OF_LIGHT
from symnav.demo.geodesy import Geodetic
from symnav.demo.models import Array
from symnav.demo.rinex import KlobucharCoefficients

_LOWEST, _HIGHEST = -500.0, 11_000.0
"""Heights in metres between which the standard atmosphere has its constant lapse rate."""
_RELATIVE_HUMIDITY = 0.5
_SECONDS_PER_DAY = 86_400.0


class Troposphere(Protocol):
    """A tropospheric delay in metres for elevations in radians, shape (n,)."""

    def __call__(self, place: Geodetic, elevation: Array, /) -> Array:
        """Evaluates the delay of each satellite."""


def standard_atmosphere(height: float) -> tuple[float, float, float]:
    """Returns pressure in hPa, temperature in K and water vapour pressure in hPa.

    Pressure and temperature follow the International Standard Atmosphere (ICAO Doc 7488) below
    11 km; heights outside -500 m to 11 km are taken at the nearer end. The vapour pressure
    follows from 50 % relative humidity by the Magnus formula (Murray 1967, Journal of Applied
    Meteorology 6).
    """
    height = min(max(height, _LOWEST), _HIGHEST)
    pressure = 1013.25 * (1.0 - 2.25577e-5 * height) ** 5.25588
    celsius = 15.0 - 6.5e-3 * height
    saturation = 6.1078 * math.exp(17.2694 * celsius / (celsius + 237.29))
    return pressure, celsius + 273.15, _RELATIVE_HUMIDITY * saturation


def saastamoinen(place: Geodetic, elevation: Array, /) -> Array:
    """Tropospheric delay: Saastamoinen's zenith delay, mapped after Black and Eisner.

    The hydrostatic and wet zenith delays are those of Saastamoinen (1972, The Use of Artificial
    Satellites for Geodesy, Geophysical Monograph 15) with the constants of Davis et al. (1985,
    Radio Science 20), in the standard atmosphere. The mapping 1.001 / sqrt(0.002001 + sin^2 el)
    of Black and Eisner (1984, Journal of Geophysical Research 89) is the one of RTCA DO-229,
    A.4.2.4, for elevations above 5 degrees.
    """
    pressure, temperature, vapour = standard_atmosphere(place.height)
    height = min(max(place.height, _LOWEST), _HIGHEST)
    gravity = 1.0 - 0.00266 * math.cos(2.0 * place.latitude) - 0.28e-6 * height
    hydrostatic = 0.0022768 * pressure / gravity
    wet = 0.0022768 * (1255.0 / temperature + 0.05) * vapour
    mapped: Array = 1.001 * (hydrostatic + wet) / np.sqrt(0.002001 + np.sin(elevation) ** 2)
    return mapped


def klobuchar(
    coefficients: KlobucharCoefficients,
    place: Geodetic,
    azimuth: Array,
    elevation: Array,
    time_of_week: float,
) -> Array:
    """Ionospheric delay on L1 in metres by the GPS single-frequency model.

    IS-GPS-200, 20.3.3.5.2.5 and figure 20-4; its angles are in semicircles.

    Args:
        coefficients: the eight broadcast coefficients.
        place: the receiver.
        azimuth: azimuths in radians, shape (n,).
        elevation: elevations in radians, shape (n,).
        time_of_week: GPS second of week.
    """
    semicircles = elevation / math.pi
    angle = 0.0137 / (semicircles + 0.11) - 0.022
    latitude = place.latitude / math.pi + angle * np.cos(azimuth)
    latitude = np.clip(latitude, -0.416, 0.416)
    longitude = place.longitude / math.pi + angle * np.sin(azimuth) / np.cos(latitude * math.pi)
    geomagnetic = latitude + 0.064 * np.cos((longitude - 1.617) * math.pi)
    local_time = np.mod(4.32e4 * longitude + time_of_week, _SECONDS_PER_DAY)

    amplitude = np.maximum(np.polynomial.polynomial.polyval(geomagnetic, coefficients.alpha), 0.0)
    period = np.maximum(np.polynomial.polynomial.polyval(geomagnetic, coefficients.beta), 72_000.0)
    phase = 2.0 * math.pi * (local_time - 50_400.0) / period
    cosine = 1.0 - phase**2 / 2.0 + phase**4 / 24.0
    vertical = 5e-9 + np.where(np.abs(phase) < 1.57, amplitude * cosine, 0.0)
    obliquity = 1.0 + 16.0 * (0.53 - semicircles) ** 3
    delay: Array = SPEED_OF_LIGHT * obliquity * vertical
    return delay
