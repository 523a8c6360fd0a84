"""Single-point positioning: Gauss-Newton on the pseudoranges of one epoch.

Input: pseudoranges with the states of their satellites, the generated pseudorange model.
Output: position and receiver clock, with the residuals that remain.

The search starts at Earth's centre, so nothing is known beforehand. A first solution without
atmosphere places the receiver within some tens of metres, which fixes elevations, weights and
delays; the solution that is reported uses them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from symnav.demo.atmosphere import Troposphere, klobuchar, saastamoinen
from symnav.demo.geodesy import azimuth_elevation, geodetic_from_ecef
from symnav.demo.models import Array, PseudorangeModel
from symnav.demo.rinex import KlobucharCoefficients
from symnav.demo.satellites import Observed

UNKNOWNS: Final = 4
"""Three of position and one receiver clock."""
_LARGEST_ITERATION = 15
_STEP_TOLERANCE = 1e-4
"""Metres; a smaller step ends the iteration."""
_REFINEMENTS = 2
"""Solutions with atmosphere: the second takes elevations and delays from the first."""


@dataclass(frozen=True, slots=True)
class Corrections:
    """Which corrections of the range a solution applies.

    Attributes:
        satellite_clock: whether the satellite clocks are removed.
        troposphere: the tropospheric delay, None to leave it out.
        ionosphere: the coefficients of the ionospheric delay, None to leave it out.
        elevation_mask: satellites below are not used, in radians.
    """

    satellite_clock: bool = True
    troposphere: Troposphere | None = saastamoinen
    ionosphere: KlobucharCoefficients | None = None
    elevation_mask: float = math.radians(10.0)


@dataclass(frozen=True, slots=True)
class Fix:
    """The solution of one epoch.

    Attributes:
        position: ECEF position in metres, shape (3,).
        clock_bias: receiver clock in metres.
        satellites: the satellites used.
        residuals: observed minus predicted pseudoranges in metres, one per satellite.
    """

    position: Array
    clock_bias: float
    satellites: tuple[str, ...]
    residuals: Array


@dataclass(frozen=True, slots=True)
class NoFix:
    """An epoch without a solution.

    Attributes:
        reason: why there is none.
    """

    reason: str


@dataclass(frozen=True, slots=True)
class _Problem:
    """A weighted least-squares problem: the satellites used, their delays and row weights."""

    observed: Observed
    clocks: Array
    troposphere: Array
    ionosphere: Array
    weights: Array


def solve(
    observed: Observed,
    time_of_week: float,
    pseudorange: PseudorangeModel,
    corrections: Corrections,
) -> Fix | NoFix:
    """Solves one epoch.

    Args:
        observed: pseudoranges and satellites.
        time_of_week: GPS second of week, for the ionosphere.
        pseudorange: the generated model over (position, clock bias).
        corrections: what to apply.
    """
    found = gauss_newton(
        _without_atmosphere(observed, corrections), pseudorange, np.zeros(UNKNOWNS)
    )
    for _ in range(_REFINEMENTS):
        if isinstance(found, NoFix):
            break
        start = np.append(found.position, found.clock_bias)
        problem = _with_atmosphere(observed, time_of_week, corrections, found.position)
        found = gauss_newton(problem, pseudorange, start)
    return found


def gauss_newton(problem: _Problem, pseudorange: PseudorangeModel, start: Array) -> Fix | NoFix:
    """Minimises the weighted squared residuals with the generated value and Jacobian."""
    observed, x = problem.observed, start
    count = len(observed.satellites)
    if count < UNKNOWNS:
        return NoFix(f"{count} usable satellites, {UNKNOWNS} are needed")
    for _ in range(_LARGEST_ITERATION):
        prediction = pseudorange(
            x,
            satellite_position=observed.positions,
            satellite_clock=problem.clocks,
            troposphere=problem.troposphere,
            ionosphere=problem.ionosphere,
        )
        residuals = observed.pseudoranges - prediction.value
        rows = problem.weights[:, np.newaxis] * prediction.jacobian
        if not (np.isfinite(residuals).all() and np.isfinite(rows).all()):
            return NoFix("the predicted ranges are not finite")
        step, _, rank, _ = np.linalg.lstsq(rows, problem.weights * residuals, rcond=None)
        if rank < UNKNOWNS:
            return NoFix("the satellites do not determine the position")
        if float(np.linalg.norm(step)) < _STEP_TOLERANCE:
            return Fix(x[:3], float(x[3]), observed.satellites, residuals)
        x = x + step
    return NoFix(f"no convergence in {_LARGEST_ITERATION} iterations")


def _without_atmosphere(observed: Observed, corrections: Corrections) -> _Problem:
    nothing = np.zeros(len(observed.satellites))
    clocks = observed.clocks if corrections.satellite_clock else nothing
    return _Problem(observed, clocks, nothing, nothing, np.ones_like(nothing))


def _with_atmosphere(
    observed: Observed, time_of_week: float, corrections: Corrections, receiver: Array
) -> _Problem:
    """Applies mask, weights and delays for satellites seen from a preliminary position.

    The standard deviation of a pseudorange is taken as proportional to 1 / sin(elevation), the
    usual choice for a range error that grows with the path through the atmosphere.
    """
    place = geodetic_from_ecef(receiver)
    azimuth, elevation = azimuth_elevation(receiver, observed.positions)
    above = elevation >= corrections.elevation_mask
    used, azimuth, elevation = observed.only(above), azimuth[above], elevation[above]
    nothing = np.zeros(len(used.satellites))
    troposphere = ionosphere = nothing
    if corrections.troposphere is not None:
        troposphere = corrections.troposphere(place, elevation)
    if corrections.ionosphere is not None:
        ionosphere = klobuchar(corrections.ionosphere, place, azimuth, elevation, time_of_week)
    clocks = used.clocks if corrections.satellite_clock else nothing
    return _Problem(used, clocks, troposphere, ionosphere, np.sin(elevation))
