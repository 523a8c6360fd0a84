"""From broadcast messages and pseudoranges to satellites at the transmission of their signals.

Input: an epoch of observations, broadcast messages, the generated broadcast-orbit model.
Output: pseudoranges beside positions and clocks of their satellites.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from symnav.demo.constants import SPEED_OF_LIGHT
from symnav.demo.models import Array, BroadcastOrbit, SatelliteState
from symnav.demo.rinex import Ephemeris, Epoch

SIGNAL = "C1C"
"""The C/A pseudorange on L1."""
GPS = "G"
_LONGEST_AGE = 7_200.0
"""A GPS message serves two hours on either side of its reference time."""
_ORBIT_ARGUMENTS = (
    "toe",
    "toc",
    "sqrt_a",
    "eccentricity",
    "mean_anomaly",
    "mean_motion_difference",
    "inclination",
    "inclination_rate",
    "right_ascension",
    "right_ascension_rate",
    "argument_of_perigee",
    "cuc",
    "cus",
    "crc",
    "crs",
    "cic",
    "cis",
    "af0",
    "af1",
    "af2",
    "group_delay",
)


@dataclass(frozen=True, slots=True)
class Observed:
    """What an epoch says about the receiver, one entry per satellite.

    Attributes:
        satellites: their names.
        pseudoranges: in metres, shape (n,).
        positions: ECEF at transmission in metres, shape (n, 3).
        clocks: satellite clock offsets in seconds, shape (n,).
    """

    satellites: tuple[str, ...]
    pseudoranges: Array
    positions: Array
    clocks: Array

    def only(self, keep: NDArray[np.bool_]) -> Observed:
        """Returns the satellites that ``keep``, shape (n,), marks."""
        names = tuple(s for s, kept in zip(self.satellites, keep, strict=True) if kept)
        return Observed(names, self.pseudoranges[keep], self.positions[keep], self.clocks[keep])


def observe(
    epoch: Epoch,
    ephemerides: Sequence[Ephemeris],
    orbit: BroadcastOrbit,
    group_delay: bool = True,
) -> Observed:
    """Collects the GPS satellites of an epoch that have a C/A pseudorange and a usable message.

    Args:
        epoch: the observations.
        ephemerides: all broadcast messages.
        orbit: the generated broadcast-orbit model.
        group_delay: whether TGD enters the satellite clocks.
    """
    messages: list[Ephemeris] = []
    pseudoranges: list[float] = []
    for satellite, values in epoch.observations.items():
        if satellite[0] != GPS or SIGNAL not in values:
            continue
        message = choose_ephemeris(ephemerides, satellite, epoch.week, epoch.time_of_week)
        if message is not None:
            messages.append(message)
            pseudoranges.append(values[SIGNAL])
    names = tuple(message.satellite for message in messages)
    ranges = np.array(pseudoranges, dtype=np.float64)
    if not names:
        return Observed(names, ranges, np.empty((0, 3)), np.empty(0))
    state = satellite_states(orbit, messages, epoch.time_of_week, ranges, group_delay)
    return Observed(names, ranges, state.position, state.clock)


def choose_ephemeris(
    ephemerides: Sequence[Ephemeris], satellite: str, week: int, time_of_week: float
) -> Ephemeris | None:
    """Returns the healthy message whose reference time is nearest, within two hours."""
    candidates = [
        message
        for message in ephemerides
        if message.satellite == satellite
        and message.health == 0
        and abs(message.age(week, time_of_week)) <= _LONGEST_AGE
    ]
    return min(candidates, key=lambda m: abs(m.age(week, time_of_week)), default=None)


def satellite_states(
    orbit: BroadcastOrbit,
    messages: Sequence[Ephemeris],
    reception: float,
    pseudoranges: Array,
    group_delay: bool = True,
) -> SatelliteState:
    """Evaluates satellites at the transmission of their signals.

    The pseudorange is reception time on the receiver's clock minus transmission time on the
    satellite's clock, so transmission in GPS time needs the satellite clock alone, which the
    first evaluation gives; the receiver's clock drops out.

    Args:
        orbit: the generated broadcast-orbit model.
        messages: one message per satellite.
        reception: the receiver's time tag, second of week.
        pseudoranges: in metres, shape (n,).
        group_delay: whether TGD enters the clock.
    """
    arguments = {name: _column(messages, name) for name in _ORBIT_ARGUMENTS}
    if not group_delay:
        arguments["group_delay"] = np.zeros_like(arguments["group_delay"])
    tags = reception - pseudoranges / SPEED_OF_LIGHT
    clock = orbit(time=tags, **arguments).clock
    return orbit(time=tags - clock, **arguments)


def _column(messages: Sequence[Ephemeris], name: str) -> Array:
    return np.array([getattr(message, name) for message in messages], dtype=np.float64)
