"""What the demonstration needs from generated code, as protocols.

The generated functions are passed in, so that this part of symnav imports no generated package and
a test can pass an independent implementation.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]


class SatelliteState(Protocol):
    """Where satellites are at transmission, in the Earth-fixed frame of that instant."""

    @property
    def position(self) -> Array:
        """Positions in metres, shape (n, 3)."""

    @property
    def velocity(self) -> Array:
        """Velocities in m/s, shape (n, 3)."""

    @property
    def clock(self) -> Array:
        """Clock offsets in seconds, relativity included, group delay subtracted, shape (n,)."""


class BroadcastOrbit(Protocol):
    """The broadcast-orbit model: message parameters and transmission time to satellite state."""

    def __call__(
        self,
        *,
        time: Array,
        toe: Array,
        toc: Array,
        sqrt_a: Array,
        eccentricity: Array,
        mean_anomaly: Array,
        mean_motion_difference: Array,
        inclination: Array,
        inclination_rate: Array,
        right_ascension: Array,
        right_ascension_rate: Array,
        argument_of_perigee: Array,
        cuc: Array,
        cus: Array,
        crc: Array,
        crs: Array,
        cic: Array,
        cis: Array,
        af0: Array,
        af1: Array,
        af2: Array,
        group_delay: Array,
    ) -> SatelliteState:
        """Evaluates satellites at once; all arguments have shape (n,), SI units and radians."""


class RangePrediction(Protocol):
    """Predicted pseudoranges and their Jacobian with respect to the state."""

    @property
    def value(self) -> Array:
        """Pseudoranges in metres, shape (n,)."""

    @property
    def jacobian(self) -> Array:
        """Derivatives with respect to position (3) and clock bias (1), shape (n, 4)."""


class PseudorangeModel(Protocol):
    """The pseudorange model over the state (position in ECEF, receiver clock bias in metres)."""

    def __call__(
        self,
        x: Array,
        /,
        *,
        satellite_position: Array,
        satellite_clock: Array,
        troposphere: Array,
        ionosphere: Array,
    ) -> RangePrediction:
        """Evaluates one epoch; the satellite clock is in seconds, the delays are in metres."""


@dataclass(frozen=True, slots=True)
class GeneratedModels:
    """The generated functions the demonstration runs.

    Attributes:
        broadcast_orbit: satellite states with the constants of GPS.
        pseudorange: the range equation with the Sagnac term.
        pseudorange_without_sagnac: the same equation generated with ``sagnac = "none"``.
    """

    broadcast_orbit: BroadcastOrbit
    pseudorange: PseudorangeModel
    pseudorange_without_sagnac: PseudorangeModel
