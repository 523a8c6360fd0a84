"""How far results may move from one C library to another.

Libraries differ in the last place of a sine. Such a step moves what is computed from it, and every
operation after it may round the other way. Both are followed through the function to first order:
``moves`` of a number is what steps of one unit in the last place, in every result of the library
and in every rounding behind one, can add up to, in units of the type's epsilon. A number that no
library function reaches has none: it must come out bit for bit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.export.arithmetic import walk
from symnav.export.arithmetic.evaluation import Ieee, Outcome, kind_of, loader
from symnav.export.arithmetic.rounded import LIBRARY

Real = NDArray[Any]
Operation = ir.Operation

_ZERO: Real = np.zeros(())

#: Units in the last place that a library function may be off.
UNITS = 2.0


@dataclass(frozen=True)
class Moving:
    """A number of the type and how far it may move, in epsilons."""

    value: Real
    moves: Real


class Following:
    """IEEE 754 arithmetic that follows steps in the last place."""

    def __init__(self, scalar: ir.Scalar, guarded: bool, rows: int) -> None:
        self._plain = Ieee(scalar, guarded, np.zeros(rows, dtype=np.int64))

    def number(self, value: float) -> Moving:
        """A literal stays where it is."""
        return Moving(self._plain.number(value), _ZERO)

    def apply(self, operation: Operation, operands: Sequence[Moving]) -> Moving:
        """The result and how far it moves."""
        values = [operand.value for operand in operands]
        result = self._plain.apply(operation, values)
        with np.errstate(all="ignore"):
            moves = _carried(operation, values, [operand.moves for operand in operands], result)
            if operation in LIBRARY:
                moves = moves + np.abs(result.astype(np.float64))
            elif operation in _ROUNDED:
                moves = np.where(moves > 0.0, moves + np.abs(result.astype(np.float64)), 0.0)
        return Moving(result, np.nan_to_num(moves, nan=0.0, posinf=0.0))

    def check(self, step: ir.Check, value: Moving) -> Moving:
        """A guarded number moves as before."""
        return Moving(self._plain.check(step, value.value), value.moves)


def slack(function: ir.Function, scalar: ir.Scalar, outcome: Outcome) -> dict[str, Real]:
    """Allowed difference of every structural non-zero: (rows, count) by output name.

    Args:
        function: as it was emitted.
        scalar: its type.
        outcome: of the rows.
    """
    count = len(outcome.status)
    plain = loader(function, outcome.copies, kind_of(scalar))
    arithmetic = Following(scalar, function.checks_domain, count)

    def loads(element: ir.Load) -> Moving:
        return Moving(plain(element), _ZERO)

    values = walk.run((*function.shared, *function.item), loads, {}, arithmetic)
    return {
        output.name: _allowed(output, loads, values, arithmetic, count)
        for output in function.outputs
    }


def _allowed(
    output: ir.Output,
    loads: walk.Loads[Moving],
    values: Mapping[str, Moving],
    arithmetic: Following,
    count: int,
) -> Real:
    found = np.zeros((count, len(output.entries)))
    for k, entry in enumerate(output.entries):
        number = walk.evaluate(entry.value, loads, values, arithmetic)
        found[:, k] = UNITS * float(np.finfo(number.value.dtype).eps) * number.moves
    return found


_ROUNDED = frozenset(
    (
        *(Operation.ADD, Operation.SUB, Operation.MUL, Operation.DIV, Operation.SQRT),
        *(Operation.OWN_SIN, Operation.OWN_COS),
    )
)


def _carried(
    operation: Operation, values: Sequence[Real], moves: Sequence[Real], result: Real
) -> Real:
    """What the operands' moves do to the result, to first order."""
    wide = [np.asarray(value, dtype=np.float64) for value in values]
    if operation is Operation.SELECT:
        return np.where(values[0], moves[1], moves[2])
    if operation in (Operation.MIN, Operation.MAX):
        return np.maximum(moves[0], moves[1])
    if operation is Operation.MUL:
        return np.asarray(np.abs(wide[1]) * moves[0] + np.abs(wide[0]) * moves[1])
    if operation is Operation.DIV:
        quotient = np.abs(np.asarray(result, dtype=np.float64))
        return np.asarray((moves[0] + quotient * moves[1]) / np.abs(wide[1]))
    if operation is Operation.ATAN2:
        square = wide[0] ** 2 + wide[1] ** 2
        crossed = np.abs(wide[1]) * moves[0] + np.abs(wide[0]) * moves[1]
        return np.asarray(crossed / square)
    if operation in _SLOPES:
        (x,), r = wide, np.asarray(result, dtype=np.float64)
        return np.where(moves[0] > 0.0, np.abs(_SLOPES[operation](x, r)) * moves[0], 0.0)
    if operation in (Operation.ADD, Operation.SUB, Operation.NEG, Operation.ABS):
        return np.asarray(sum(moves))
    return _ZERO  # comparisons, and whole numbers


_SLOPES = {
    Operation.SQRT: lambda x, r: 0.5 / r,
    Operation.SIN: lambda x, r: np.cos(x),
    Operation.COS: lambda x, r: np.sin(x),
    Operation.OWN_SIN: lambda x, r: np.cos(x),
    Operation.OWN_COS: lambda x, r: np.sin(x),
    Operation.TAN: lambda x, r: 1.0 + r * r,
    Operation.ASIN: lambda x, r: 1.0 / np.sqrt(1.0 - x * x),
    Operation.ACOS: lambda x, r: 1.0 / np.sqrt(1.0 - x * x),
    Operation.ATAN: lambda x, r: 1.0 / (1.0 + x * x),
    Operation.EXP: lambda x, r: r,
    Operation.LOG: lambda x, r: 1.0 / x,
}
