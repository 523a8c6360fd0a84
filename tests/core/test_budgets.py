"""How many operations the derivations cost, and that they do not grow with the satellites."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any

import pytest

from symnav import ir
from tests.core.specs import Case, calibrated_gps, derived, gps, inertial, lowered, ranges, vector


def operations(steps: Sequence[ir.Step]) -> int:
    """Operations as they will be executed, after common subexpressions; comparisons are free."""
    return sum(_count(step.value) for step in steps)


def _count(expression: ir.Expression) -> int:
    if not isinstance(expression, ir.Call):
        return 0
    own = int(expression.operation not in ir.CONDITIONS)
    return own + sum(_count(operand) for operand in expression.operands)


@pytest.mark.parametrize(
    ("case", "budget"),
    [
        (gps(), (68, 0)),
        (calibrated_gps(), (99, 0)),
        (inertial(1), (161, 0)),
        (inertial(4), (282, 0)),
        (ranges(), (113, 28)),
    ],
    ids=["gps", "calibrated gps", "one sample", "four samples", "range"],
)
def test_operations(case: Case, budget: tuple[int, int]) -> None:
    """The shared part once, the item part per satellite; value and Jacobian together."""
    function = lowered(case.spec(), "casadi")
    counts = operations(function.shared), operations(function.item)
    assert counts[0] <= budget[0] and counts[1] <= budget[1], counts
    for output in function.outputs:
        assert all(not isinstance(entry.value, ir.Call) for entry in output.entries)


def stripped(function: ir.Function) -> Any:
    """Everything the maximum could change."""
    return function.shared, function.item, [output.entries for output in function.outputs]


@pytest.mark.parametrize("route", ["casadi", "sympy"])
def test_the_maximum_costs_nothing(route: str) -> None:
    """The same steps for 8 satellites as for 64."""
    few, many = ranges("exact", maximum=8).spec(), ranges("exact", maximum=64).spec()
    assert stripped(lowered(few, route)) == stripped(lowered(many, route))
    assert lowered(many, route).maximum == 64


def test_derivation_is_quick() -> None:
    """Far below a second, whatever the maximum."""
    spec = ranges("exact", maximum=1000).spec()
    start = time.perf_counter()
    derived(spec)
    assert time.perf_counter() - start < 5.0


def test_padding_costs_nothing() -> None:
    """Blocks that an equation does not read change only the columns' places."""
    case = gps()
    padded = Case(
        case.model, [vector("padding", 200), *case.blocks], case.inputs, case.bindings, case.frames
    )
    plain, wide = (lowered(c.spec(), "casadi") for c in (case, padded))
    assert len(plain.shared) == len(wide.shared)
    (before,) = [o for o in plain.outputs if o.name == "jacobian"]
    (after,) = [o for o in wide.outputs if o.name == "jacobian"]
    shifted = [(e.index[0], int(str(e.index[1])) + 200) for e in before.entries]
    assert [e.index for e in after.entries] == shifted
