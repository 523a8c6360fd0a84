"""Small functions written down by hand, for facts that should be looked at alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symnav import ir
from symnav.export.rounding.bounds import bounds
from symnav.export.rounding.formats import Format
from symnav.export.rounding.sampling import samples
from symnav.export.rounding.search import errors

Op = ir.Operation
FLOAT, DOUBLE = ir.Scalar.FLOAT, ir.Scalar.DOUBLE


def call(operation: Op, *operands: ir.Expression | float) -> ir.Call:
    return ir.Call(
        operation, tuple(o if not isinstance(o, (int, float)) else number(o) for o in operands)
    )


def number(value: float) -> ir.Number:
    return ir.Number(float(value))


def load(index: int, argument: str = "a") -> ir.Load:
    return ir.Load(argument, index)


def squares(parts: Sequence[ir.Expression]) -> ir.Expression:
    first, *rest = (call(Op.MUL, part, part) for part in parts)
    total: ir.Expression = first
    for one in rest:
        total = call(Op.ADD, total, one)
    return total


def domain(
    lower: Sequence[float],
    upper: Sequence[float],
    kind: ir.Kind = ir.Kind.REAL,
    tolerance: float = 1e-5,
) -> ir.Domain:
    labels = tuple(str(k) for k in range(len(lower)))
    ends = tuple(map(float, lower)), tuple(map(float, upper))
    return ir.Domain("a", 0, len(lower), kind, *ends, tolerance, "m", "", labels, "")


def quaternion(tolerance: float = 1e-5) -> ir.Domain:
    reach = [1.0 + tolerance] * 4
    return domain([-r for r in reach], reach, ir.Kind.QUATERNION, tolerance)


def function(
    domains: Mapping[str, ir.Domain],
    steps: Sequence[ir.Step],
    results: Sequence[ir.Expression],
) -> ir.Function:
    """A measurement whose value has the results as its elements."""
    arguments = tuple(
        ir.Argument(name, one.size, False, one.kind is ir.Kind.INTEGER, (one,))
        for name, one in domains.items()
    )
    size = len(results)
    entries = tuple(ir.Entry((k,), result) for k, result in enumerate(results))
    rows = (ir.Section("value", 0, size, "m", tuple(str(k) for k in range(size))),)
    output = ir.Output("value", (size,), False, entries, rows, (), "m", "", "")
    return ir.Function(
        *("f", ir.Role.MEASUREMENT, "A function", "", "", (), arguments, tuple(steps), ()),
        *((output,), None, ir.Items.SKIP, ir.Guards.STATUS, False, False),
    )


def box(
    lower: Sequence[float], upper: Sequence[float], *results: ir.Expression, steps: Any = ()
) -> ir.Function:
    """A function of one argument ``a`` in a box."""
    return function({"a": domain(lower, upper)}, steps, results)


def bound(one: ir.Function, scalar: ir.Scalar = FLOAT, kind: Format | None = None) -> float:
    """The worst bound of the value."""
    return max(r.bound for r in bounds(one, scalar, kind)["value"])


def smooth(one: ir.Function, scalar: ir.Scalar = FLOAT) -> float:
    """The worst bound where all decisions agree."""
    return max(r.smooth for r in bounds(one, scalar)["value"])


def found(one: ir.Function, scalar: ir.Scalar = FLOAT, count: int = 20000, seed: int = 1) -> float:
    """The worst error among samples."""
    rng = np.random.default_rng(seed)
    return float(errors(one, scalar, samples(one, scalar, count, rng))["value"].max())
