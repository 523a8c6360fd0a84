"""Readers for the two RINEX 3.04 files of the demonstration.

They read what single-point positioning needs and refuse what they do not understand: each error
names the file, the line and what was expected there.
"""

from symnav.demo.rinex.navigation import (
    Ephemeris,
    KlobucharCoefficients,
    NavigationFile,
    read_navigation,
)
from symnav.demo.rinex.observations import Epoch, ObservationFile, read_observations

__all__ = [
    "Ephemeris",
    "Epoch",
    "KlobucharCoefficients",
    "NavigationFile",
    "ObservationFile",
    "read_navigation",
    "read_observations",
]
