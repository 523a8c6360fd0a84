"""Runs generated models on a minute of recorded GPS observations.

Input: the generated models.
Output: errors against the surveyed position, with all corrections and with one left out each.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib.resources import as_file, files
from typing import Final, TypeAlias

import numpy as np

from symnav.demo.models import GeneratedModels
from symnav.demo.positioning import Corrections, Fix, solve
from symnav.demo.results import (
    DemoResult,
    EpochResult,
    UnsolvedEpoch,
    VariantResult,
    judge,
    summarise,
)
from symnav.demo.rinex import (
    Epoch,
    NavigationFile,
    ObservationFile,
    read_navigation,
    read_observations,
)
from symnav.demo.satellites import observe

OBSERVATIONS: Final = "SEPT078M1.21O"
NAVIGATION: Final = "SEPT078M.21P"
REFERENCE: Final = (-3962108.673, 3381309.574, 3668678.638)
"""ECEF position of the antenna in metres, as given with the data (cssrlib, test_rtk.py)."""
DATA: Final = "Septentrio receiver, Japan, 2021-03-19 12:00 GPS time, 1 Hz, GPS C/A on L1"

Progress: TypeAlias = Callable[[str, int, int], None]
"""Called after each epoch with the variant's label, the epochs done and their number."""


@dataclass(frozen=True, slots=True)
class _Variant:
    """A way to solve the epochs: what is left out, if anything."""

    name: str
    label: str
    corrections: Corrections
    sagnac: bool = True
    group_delay: bool = True
    required: bool = False


def run(models: GeneratedModels, progress: Progress | None = None) -> DemoResult:
    """Solves every epoch of the recorded data with all corrections and without each of them.

    Args:
        models: the generated functions.
        progress: told about each epoch.
    """
    observations, navigation = load_data()
    full, *ablations = (
        _solve_all(variant, observations, navigation, models, progress)
        for variant in _variants(Corrections(ionosphere=navigation.klobuchar))
    )
    return DemoResult(DATA, REFERENCE, full, tuple(ablations))


def load_data() -> tuple[ObservationFile, NavigationFile]:
    """Reads the observation and navigation files that come with symnav."""
    folder = files("symnav.demo") / "data"
    with as_file(folder / OBSERVATIONS) as path:
        observations = read_observations(path)
    with as_file(folder / NAVIGATION) as path:
        navigation = read_navigation(path)
    return observations, navigation


def _variants(full: Corrections) -> tuple[_Variant, ...]:
    without_clock = replace(full, satellite_clock=False)
    without_troposphere = replace(full, troposphere=None)
    without_ionosphere = replace(full, ionosphere=None)
    return (
        _Variant("full", "with all corrections", full),
        _Variant("without_sagnac", "without Sagnac", full, sagnac=False, required=True),
        _Variant("without_group_delay", "without TGD", full, group_delay=False, required=True),
        _Variant("without_clock", "without satellite clock", without_clock, required=True),
        _Variant("without_troposphere", "without troposphere", without_troposphere),
        _Variant("without_ionosphere", "without ionosphere", without_ionosphere),
    )


def _solve_all(
    variant: _Variant,
    observations: ObservationFile,
    navigation: NavigationFile,
    models: GeneratedModels,
    progress: Progress | None,
) -> VariantResult:
    solved: list[EpochResult] = []
    unsolved: list[UnsolvedEpoch] = []
    for done, epoch in enumerate(observations.epochs, start=1):
        outcome = _solve_epoch(variant, epoch, navigation, models)
        if isinstance(outcome, EpochResult):
            solved.append(outcome)
        else:
            unsolved.append(outcome)
        if progress is not None:
            progress(variant.label, done, len(observations.epochs))
    return VariantResult(
        name=variant.name,
        label=variant.label,
        required=variant.required,
        solved=tuple(solved),
        unsolved=tuple(unsolved),
        accuracy=summarise(solved),
    )


def _solve_epoch(
    variant: _Variant, epoch: Epoch, navigation: NavigationFile, models: GeneratedModels
) -> EpochResult | UnsolvedEpoch:
    observed = observe(epoch, navigation.ephemerides, models.broadcast_orbit, variant.group_delay)
    model = models.pseudorange if variant.sagnac else models.pseudorange_without_sagnac
    outcome = solve(observed, epoch.time_of_week, model, variant.corrections)
    if isinstance(outcome, Fix):
        return judge(epoch.time_of_week, outcome, np.array(REFERENCE))
    return UnsolvedEpoch(epoch.time_of_week, outcome.reason)
