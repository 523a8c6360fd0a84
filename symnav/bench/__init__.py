"""Measuring the generated C: time, operations, code and stack."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from symnav import pipeline
from symnav.bench.report import Row, compared, measure
from symnav.build import cache_directory
from symnav.spec.records import Spec
from symnav.verify.records import records

__all__ = ["Row", "bench", "compared"]


def bench(
    spec: Spec,
    *,
    flags: str = "v3",
    items: int = 8,
    repetitions: int = 15,
    progress: Callable[[str], None] = lambda _stage: None,
) -> list[Row]:
    """Time the C of a spec, and compare with the last run on this machine.

    Args:
        spec: what to measure.
        flags: name of a flag set of ``symnav.bench.program``.
        items: satellites in each call of a mapped function, where it allows so many.
        repetitions: bursts of every form; the median counts.
        progress: told each stage and each function.

    Raises:
        BuildError: when there is no compiler, or it refuses the code.
        ProofError: when no sample of a function lies inside its domain.
    """
    with tempfile.TemporaryDirectory(prefix="symnav-") as folder:
        package = pipeline.generate(spec, Path(folder), progress).package
        derived = pipeline.derive(spec)
        functions = pipeline.c_route(spec, derived)
        numpy = pipeline.import_package(package).numpy
        rows = measure(
            spec.name, functions, package / "c", records(spec, derived.entries, numpy, items),
            items, flags=flags, folder=Path(folder) / "bench", repetitions=repetitions,
            progress=progress,
        )  # fmt: skip
    return compared(rows, cache_directory() / "bench" / f"{spec.name}.json", flags)
