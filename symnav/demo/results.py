"""The figures of the demonstration, as frozen records that turn into JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any, Final

import numpy as np

from symnav.demo.geodesy import enu_from_ecef, geodetic_from_ecef
from symnav.demo.models import Array
from symnav.demo.positioning import Fix

LARGEST_MEDIAN_ERROR: Final = 2.5
"""Metres; the median 3-D error the demonstration promises."""
LARGEST_POSTFIT_RMS: Final = 1.5
"""Metres; the root mean square of the residuals it promises."""


@dataclass(frozen=True, slots=True)
class EpochResult:
    """The solution of one epoch against the reference.

    Attributes:
        time_of_week: GPS second of week.
        satellites: the satellites used.
        error_enu: east, north and up error in metres.
        error_3d: length of that error in metres.
        postfit_rms: root mean square of the residuals in metres.
    """

    time_of_week: float
    satellites: tuple[str, ...]
    error_enu: tuple[float, float, float]
    error_3d: float
    postfit_rms: float


@dataclass(frozen=True, slots=True)
class UnsolvedEpoch:
    """An epoch without a solution.

    Attributes:
        time_of_week: GPS second of week.
        reason: why there is none.
    """

    time_of_week: float
    reason: str


@dataclass(frozen=True, slots=True)
class Accuracy:
    """Statistics over the solved epochs.

    Attributes:
        median_error_3d: median 3-D error in metres.
        percentile_95_error_3d: 95th percentile of the 3-D error in metres.
        mean_error_enu: mean east, north and up error in metres.
        postfit_rms: root mean square of all residuals of all epochs in metres.
        fewest_satellites: fewest satellites used.
        median_satellites: median number of satellites used.
        most_satellites: most satellites used.
    """

    median_error_3d: float
    percentile_95_error_3d: float
    mean_error_enu: tuple[float, float, float]
    postfit_rms: float
    fewest_satellites: int
    median_satellites: float
    most_satellites: int


@dataclass(frozen=True, slots=True)
class VariantResult:
    """One way to solve all epochs.

    Attributes:
        name: an identifier, for instance ``"without_sagnac"``.
        label: the same in words.
        required: whether this correction must show its worth for the demonstration to pass.
        solved: the epochs with a solution.
        unsolved: the epochs without.
        accuracy: statistics of the solved epochs, None when there are none.
    """

    name: str
    label: str
    required: bool
    solved: tuple[EpochResult, ...]
    unsolved: tuple[UnsolvedEpoch, ...]
    accuracy: Accuracy | None

    @property
    def epochs(self) -> int:
        """Number of epochs in the file."""
        return len(self.solved) + len(self.unsolved)


@dataclass(frozen=True, slots=True)
class DemoResult:
    """What the demonstration measured.

    Attributes:
        data: what was observed, in words.
        reference_position: the ECEF position errors refer to, in metres.
        full: the solution with all corrections.
        ablations: the same with one correction left out each.
    """

    data: str
    reference_position: tuple[float, float, float]
    full: VariantResult
    ablations: tuple[VariantResult, ...]

    def as_dict(self) -> dict[str, Any]:
        """Returns nested dictionaries, tuples, numbers and strings that ``json`` can write."""
        return asdict(self)

    def shortfalls(self) -> tuple[str, ...]:
        """Returns a sentence for each promise that is not kept; empty when all are."""
        full = self.full.accuracy
        found: list[str] = []
        if self.full.unsolved or full is None:
            found.append(f"{len(self.full.solved)} of {self.full.epochs} epochs are solved")
        if full is None:
            return tuple(found)
        if full.median_error_3d > LARGEST_MEDIAN_ERROR:
            found.append(
                f"the median 3-D error is {full.median_error_3d:.2f} m, "
                f"{LARGEST_MEDIAN_ERROR} m are allowed"
            )
        if full.postfit_rms > LARGEST_POSTFIT_RMS:
            found.append(
                f"the post-fit rms is {full.postfit_rms:.2f} m, {LARGEST_POSTFIT_RMS} m are allowed"
            )
        for variant in self.ablations:
            without = variant.accuracy
            if variant.required and without is not None:
                worse = without.median_error_3d > full.median_error_3d
                found += [] if worse else [f"the solution {variant.label} is not worse"]
        return tuple(found)


def judge(time_of_week: float, fix: Fix, reference: Array) -> EpochResult:
    """Compares a solution with the reference position."""
    error = fix.position - reference
    east, north, up = enu_from_ecef(geodetic_from_ecef(reference)) @ error
    return EpochResult(
        time_of_week=time_of_week,
        satellites=fix.satellites,
        error_enu=(float(east), float(north), float(up)),
        error_3d=float(np.linalg.norm(error)),
        postfit_rms=float(np.sqrt(np.mean(fix.residuals**2))),
    )


def summarise(solved: Sequence[EpochResult]) -> Accuracy | None:
    """Takes statistics over epochs; None when there are none."""
    if not solved:
        return None
    errors = np.array([epoch.error_3d for epoch in solved])
    counts = np.array([len(epoch.satellites) for epoch in solved])
    squares = np.array([epoch.postfit_rms for epoch in solved]) ** 2
    east, north, up = np.mean([epoch.error_enu for epoch in solved], axis=0)
    return Accuracy(
        median_error_3d=float(np.median(errors)),
        percentile_95_error_3d=float(np.percentile(errors, 95.0)),
        mean_error_enu=(float(east), float(north), float(up)),
        # Every residual weighs the same, whatever the number of satellites of its epoch.
        postfit_rms=float(np.sqrt(np.sum(squares * counts) / np.sum(counts))),
        fewest_satellites=int(counts.min()),
        median_satellites=float(np.median(counts)),
        most_satellites=int(counts.max()),
    )
