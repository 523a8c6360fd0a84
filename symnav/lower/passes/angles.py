"""Sines and cosines of angles of a few turns become arithmetic of the emitted C.

Which angles those are follows from the declared ranges. Everything else stays a call of the C
library, whose reduction of the argument has no limits.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from symnav import ir
from symnav.lower.passes.ranges import Ranges
from symnav.trigonometry import LIMIT

_OWN: Mapping[ir.Operation, ir.Operation] = {
    ir.Operation.SIN: ir.Operation.OWN_SIN,
    ir.Operation.COS: ir.Operation.OWN_COS,
}


def own_sinusoids(function: ir.Function) -> ir.Function:
    """Mark every sine and cosine whose argument cannot leave ``trigonometry.LIMIT``.

    Without guards the declared ranges are what the caller promises: beyond them the results of a
    marked sine or cosine are finite and wrong, those of infinities and NaN are NaN.
    """
    ranges = Ranges(function)
    shared = tuple(_step(step, ranges) for step in function.shared)
    item = tuple(_step(step, ranges) for step in function.item)
    outputs = tuple(
        replace(
            output,
            entries=tuple(
                replace(entry, value=_marked(entry.value, ranges)) for entry in output.entries
            ),
        )
        for output in function.outputs
    )
    return replace(function, shared=shared, item=item, outputs=outputs)


def _step(step: ir.Step, ranges: Ranges) -> ir.Step:
    marked = replace(step, value=_marked(step.value, ranges))
    ranges.note(marked)
    return marked


def _marked(expression: ir.Expression, ranges: Ranges) -> ir.Expression:
    if not isinstance(expression, ir.Call):
        return expression
    operands = tuple(_marked(operand, ranges) for operand in expression.operands)
    operation = expression.operation
    if operation in _OWN:
        angle = ranges.of(operands[0])
        if angle.is_known and max(-angle.lower, angle.upper) <= LIMIT:
            operation = _OWN[operation]
    return ir.Call(operation, operands)
