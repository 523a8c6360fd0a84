"""Constants of the earth and of the GNSS interface specifications, in SI units."""

from __future__ import annotations

from fractions import Fraction
from typing import Final

#: WGS-84 semi-major axis [m].
SEMI_MAJOR_AXIS: Final = 6_378_137.0
#: WGS-84 flattening.
FLATTENING: Final = Fraction(1) / (Fraction(298_257_223_563, 1_000_000_000))
#: First eccentricity squared, f (2 - f).
ECCENTRICITY_SQUARED: Final = float(FLATTENING * (2 - FLATTENING))
#: Earth rotation rate of WGS-84 and IS-GPS-200 [rad/s].
ROTATION_RATE: Final = 7.292_115_146_7e-5
#: Speed of light in vacuum [m/s].
SPEED_OF_LIGHT: Final = 299_792_458.0
#: Gravitational constant times mass of the earth, by satellite system [m^3/s^2].
GRAVITATIONAL_PARAMETER: Final = {"gps": 3.986_005e14, "galileo": 3.986_004_418e14}
#: Relativistic clock constant F = -2 sqrt(GM) / c^2, by satellite system [s/sqrt(m)].
RELATIVISTIC_CLOCK: Final = {"gps": -4.442_807_633e-10, "galileo": -4.442_807_309e-10}
