"""The constants the demonstration needs, with the document each one comes from."""

from __future__ import annotations

from typing import Final

SPEED_OF_LIGHT: Final = 299_792_458.0
"""Speed of light in m/s (IS-GPS-200, 20.3.3.3.3.1)."""

SECONDS_PER_WEEK: Final = 604_800.0
"""Length of a GPS week in seconds."""

WGS84_SEMI_MAJOR_AXIS: Final = 6_378_137.0
"""Semi-major axis of the WGS 84 ellipsoid in metres (NGA.STND.0036)."""

WGS84_FLATTENING: Final = 1.0 / 298.257223563
"""Flattening of the WGS 84 ellipsoid (NGA.STND.0036)."""
