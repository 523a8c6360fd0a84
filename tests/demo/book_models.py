"""Broadcast orbit and pseudorange written from the interface document, one satellite at a time.

Nothing here comes from symnav: scalar arithmetic after IS-GPS-200 (20.3.3.3.3.1, table 20-IV) and
the geometric range with the first-order Sagnac term, with its gradient by hand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LIGHT = 299792458.0
EARTH_RATE = 7.2921151467e-5
GM_GPS = 3.986005e14
GM_GALILEO = 3.986004418e14
HALF_WEEK = 302400.0


@dataclass(frozen=True)
class OrbitState:
    """Satellite states at transmission."""

    position: Array
    velocity: Array
    clock: Array


@dataclass(frozen=True)
class Range:
    """Predicted ranges and their gradient."""

    value: Array
    jacobian: Array


def wrapped(seconds: float) -> float:
    """Brings a difference of seconds of week into half a week on either side."""
    return (seconds + HALF_WEEK) % (2 * HALF_WEEK) - HALF_WEEK


def eccentric_anomaly(mean: float, e: float) -> float:
    """Kepler's equation by bisection, which cannot fail: the root lies within e of the mean."""
    low, high = mean - e, mean + e
    for _ in range(80):
        middle = 0.5 * (low + high)
        if middle - e * math.sin(middle) < mean:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def ecef_position(m: dict[str, float], t: float, gm: float) -> tuple[list[float], float]:
    """Table 20-IV: ECEF position and the eccentric anomaly at GPS second of week t."""
    a = m["sqrt_a"] ** 2
    tk = wrapped(t - m["toe"])
    mean = m["mean_anomaly"] + (math.sqrt(gm / a**3) + m["mean_motion_difference"]) * tk
    e = m["eccentricity"]
    anomaly = eccentric_anomaly(mean, e)
    true = 2.0 * math.atan(math.sqrt((1 + e) / (1 - e)) * math.tan(anomaly / 2))
    phi = true + m["argument_of_perigee"]
    s2, c2 = math.sin(2 * phi), math.cos(2 * phi)
    u = phi + m["cus"] * s2 + m["cuc"] * c2
    r = a * (1 - e * math.cos(anomaly)) + m["crs"] * s2 + m["crc"] * c2
    i = m["inclination"] + m["cis"] * s2 + m["cic"] * c2 + m["inclination_rate"] * tk
    node = (
        m["right_ascension"] + (m["right_ascension_rate"] - EARTH_RATE) * tk - EARTH_RATE * m["toe"]
    )
    x, y = r * math.cos(u), r * math.sin(u)
    position = [
        x * math.cos(node) - y * math.cos(i) * math.sin(node),
        x * math.sin(node) + y * math.cos(i) * math.cos(node),
        y * math.sin(i),
    ]
    return position, anomaly


@dataclass(frozen=True)
class BookOrbit:
    """The broadcast orbit of one satellite system."""

    gm: float = GM_GPS

    def __call__(self, *, time: Array, **message: Array) -> OrbitState:
        """Evaluates satellites one after the other; velocities by differences over a second."""
        positions, velocities, clocks = [], [], []
        for k, t in enumerate(time):
            m = {name: float(values[k]) for name, values in message.items()}
            position, anomaly = ecef_position(m, float(t), self.gm)
            ahead, _ = ecef_position(m, float(t) + 0.5, self.gm)
            behind, _ = ecef_position(m, float(t) - 0.5, self.gm)
            dt = wrapped(float(t) - m["toc"])
            relativity = (
                -2.0
                * math.sqrt(self.gm)
                / LIGHT**2
                * m["eccentricity"]
                * m["sqrt_a"]
                * math.sin(anomaly)
            )
            positions.append(position)
            velocities.append([f - b for f, b in zip(ahead, behind, strict=True)])
            clocks.append(
                m["af0"] + m["af1"] * dt + m["af2"] * dt**2 + relativity - m["group_delay"]
            )
        return OrbitState(np.array(positions), np.array(velocities), np.array(clocks))


@dataclass(frozen=True)
class BookRange:
    """The pseudorange equation with or without the Sagnac term."""

    sagnac: bool = True

    def __call__(
        self,
        x: Array,
        /,
        *,
        satellite_position: Array,
        satellite_clock: Array,
        troposphere: Array,
        ionosphere: Array,
    ) -> Range:
        """Evaluates satellites one after the other."""
        w = EARTH_RATE / LIGHT if self.sagnac else 0.0
        values, rows = [], []
        for k, (sx, sy, sz) in enumerate(satellite_position):
            dx, dy, dz = sx - x[0], sy - x[1], sz - x[2]
            r = math.sqrt(dx * dx + dy * dy + dz * dz)
            delays = -LIGHT * satellite_clock[k] + troposphere[k] + ionosphere[k]
            values.append(r + w * (sx * x[1] - sy * x[0]) + x[3] + delays)
            rows.append([-dx / r - w * sy, -dy / r + w * sx, -dz / r, 1.0])
        return Range(np.array(values), np.array(rows))
