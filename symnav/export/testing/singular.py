"""Inputs at which a guard inside a kernel fails: an antenna at its satellite, a vanishing sum.

Such inputs are rare among samples, so they are searched for: from ordinary samples, every real
input that the guarded value depends on is moved by Newton's method toward the extreme of that
value, which for a squared length is the singular point itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.export.arithmetic import walk
from symnav.export.arithmetic.evaluation import (
    Ieee,
    Outcome,
    Rows,
    bounds,
    evaluate,
    kind_of,
    loader,
    read_domains,
)

Array = NDArray[Any]

#: Ordinary samples a search starts from.
STARTS = 24
STEPS = 30


@dataclass(frozen=True)
class _Variable:
    """A real input that a search may move, and its range."""

    argument: str
    index: int
    lower: float
    upper: float


def failing(
    function: ir.Function, scalar: ir.Scalar, rows: Rows, items: int, outcome: Outcome
) -> list[dict[str, Array]]:
    """Samples in whose first item one guard fails and no other: one for every guard it is found of.

    Args:
        function: as it was emitted.
        scalar: its type.
        rows: of samples, ``items`` rows each.
        items: rows of a sample.
        outcome: of the rows.
    """
    if not function.checks_domain:
        return []
    found = []
    for step in (*function.shared, *function.item):
        if isinstance(step, ir.Check):
            sample = _search(function, scalar, rows, items, outcome, step)
            if sample is not None:
                found.append(sample)
    return found


def _search(
    function: ir.Function,
    scalar: ir.Scalar,
    rows: Rows,
    items: int,
    outcome: Outcome,
    step: ir.Check,
) -> dict[str, Array] | None:
    good = np.flatnonzero(outcome.ok.reshape(-1, items).all(axis=1))[:STARTS]
    starts = {name: array[good * items] for name, array in rows.items()}
    moved = _extreme(function, scalar, starts, step, item=step in function.item)
    for k, sample in enumerate(good):
        block = {
            name: array[sample * items : (sample + 1) * items].copy()
            for name, array in rows.items()
        }
        for argument in function.arguments:
            place = 0 if argument.item else slice(None)
            block[argument.name][place] = moved[argument.name][k]
        if _fails_alone(function, scalar, block, step):
            return block
    return None


def _fails_alone(function: ir.Function, scalar: ir.Scalar, block: Rows, step: ir.Check) -> bool:
    """True when of all guards only this one fails, in the first row and in no other."""
    outcome = evaluate(function, scalar, block)
    status = np.where(outcome.status != 0, outcome.status, outcome.item)
    if status[0] != int(step.status) or (step in function.item and status[1:].any()):
        return False
    for other in (*function.shared, *function.item):
        if isinstance(other, ir.Check):
            raw = _raw(function, scalar, outcome, other)[0]
            low, high = bounds(other.lower, other.upper, scalar)
            if bool(low <= raw <= high) is (other is step):
                return False
    return True


def _raw(function: ir.Function, scalar: ir.Scalar, outcome: Outcome, step: ir.Check) -> Array:
    """A guarded value before its guard."""
    blank = Ieee(scalar, False, np.zeros_like(outcome.status))
    loads = loader(function, outcome.copies, kind_of(scalar))
    value = walk.evaluate(step.value, loads, outcome.values, blank)
    return np.broadcast_to(value, outcome.status.shape)


def _variables(function: ir.Function, *, item: bool) -> list[_Variable]:
    return [
        _Variable(argument.name, domain.start + k, domain.lower[k], domain.upper[k])
        for argument in function.arguments
        if argument.item is item and not argument.integer
        for domain in read_domains(argument)
        if domain.kind is ir.Kind.REAL
        for k in range(domain.size)
    ]


def _extreme(
    function: ir.Function, scalar: ir.Scalar, starts: Rows, step: ir.Check, *, item: bool
) -> dict[str, Array]:
    """The starts moved to where the guarded value is smallest."""
    variables = _variables(function, item=item)
    wide = {
        name: array if array.dtype == np.int32 else array.astype(np.float64)
        for name, array in starts.items()
    }
    for _ in range(STEPS if variables else 0):
        wide = _stepped(function, wide, step, variables)
    kind = kind_of(scalar)
    return {
        name: array if array.dtype == np.int32 else array.astype(kind)
        for name, array in wide.items()
    }


def _stepped(
    function: ir.Function, rows: Rows, step: ir.Check, variables: Sequence[_Variable]
) -> dict[str, Array]:
    """One step of Newton's method with the diagonal of the second derivatives."""
    count = len(next(iter(rows.values())))
    reach = _steps(function, rows, step, variables)
    stacked = {name: np.concatenate([a] * (2 * len(variables) + 1)) for name, a in rows.items()}
    for k, variable in enumerate(variables):
        for sign, block in ((1.0, 2 * k + 1), (-1.0, 2 * k + 2)):
            part = slice(block * count, (block + 1) * count)
            stacked[variable.argument][part, variable.index] += sign * reach[:, k]
    values = _unguarded(function, stacked, step).reshape(-1, count)
    moved = {name: array.copy() for name, array in rows.items()}
    with np.errstate(all="ignore"):
        for k, variable in enumerate(variables):
            ahead, behind = values[2 * k + 1], values[2 * k + 2]
            slope = (ahead - behind) / (2.0 * reach[:, k])
            bend = (ahead - 2.0 * values[0] + behind) / reach[:, k] ** 2
            change = np.where(bend > 0.0, -slope / bend, 0.0)
            column = moved[variable.argument][:, variable.index]
            target = np.where(np.isfinite(change), column + change, column)
            moved[variable.argument][:, variable.index] = np.clip(
                target, variable.lower, variable.upper
            )
    return moved


def _steps(
    function: ir.Function, rows: Rows, step: ir.Check, variables: Sequence[_Variable]
) -> Array:
    """Steps of differences: as long as the way that is left, and never lost in rounding."""
    left = np.sqrt(np.abs(_unguarded(function, rows, step)))
    columns = [np.abs(rows[v.argument][:, v.index]) for v in variables]
    return np.stack([np.maximum(left, 1e-6 * column + 1e-9) for column in columns], axis=1)


def _unguarded(function: ir.Function, rows: Rows, step: ir.Check) -> Array:
    """The guarded value of inputs that may be outside their ranges."""
    count = len(next(iter(rows.values())))
    blank = Ieee(ir.Scalar.DOUBLE, False, np.zeros(count, dtype=np.int64))
    loads = loader(function, rows, kind_of(ir.Scalar.DOUBLE))
    steps = (*function.shared, *function.item)
    values = walk.run(steps[: steps.index(step)], loads, {}, blank)
    return np.broadcast_to(walk.evaluate(step.value, loads, values, blank), (count,))
