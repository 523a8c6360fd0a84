"""The table of rounding bounds of the shipped models, computed when the pages are built."""

from __future__ import annotations

from collections.abc import Iterator

from symnav import ir, pipeline
from symnav.emit.c.rounding import upwards
from symnav.export.rounding import bounds
from symnav.export.rounding.search import search

BUDGET = 8192
SEED = 1
HEADINGS = ("function", "output", "unit", "double", "float", "found in float", "float over found")


def rows() -> Iterator[list[str]]:
    """One row per output of every measurement and correction of the shipped models."""
    for model, _ in pipeline.shipped():
        spec = pipeline.load(model)
        wide = {entry.name for entry in spec.entries if entry.model.always_double}
        for function in pipeline.c_route(spec, pipeline.derive(spec)):
            if function.role in (ir.Role.MEASUREMENT, ir.Role.CORRECTION):
                yield from of_function(model, function, single=function.name not in wide)


def of_function(model: str, function: ir.Function, *, single: bool) -> Iterator[list[str]]:
    """Bounds, and in single precision the worst error a search finds."""
    scalars = (ir.Scalar.DOUBLE, ir.Scalar.FLOAT) if single else (ir.Scalar.DOUBLE,)
    found = {scalar: bounds(function, scalar) for scalar in scalars}
    for output in function.outputs:
        limits = {s: max((r.smooth for r in b[output.name]), default=0.0) for s, b in found.items()}
        searched = ratio = "-"
        if single and limits[ir.Scalar.FLOAT] > 0.0:
            worst = search(function, ir.Scalar.FLOAT, output.name, budget=BUDGET, seed=SEED).error
            searched = f"{worst:.2g}"
            ratio = f"{limits[ir.Scalar.FLOAT] / worst:.2g}" if worst else "-"
        yield [
            f"`{model}.{function.name}`",
            f"`{output.name}`",
            output.unit or "-",
            upwards(limits[ir.Scalar.DOUBLE]),
            upwards(limits[ir.Scalar.FLOAT]) if single else "always double",
            searched,
            ratio,
        ]
