"""The intermediate representation, evaluated number by number: what a target must compute.

Written from the documentation of the records; shares nothing with the emitters.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from mpmath import mp

from symnav import ir

Op = ir.Operation
Index = tuple[int, ...]

_ANY: Mapping[ir.Operation, Callable[..., Any]] = {
    Op.ADD: lambda a, b: a + b,
    Op.SUB: lambda a, b: a - b,
    Op.MUL: lambda a, b: a * b,
    Op.DIV: lambda a, b: a / b,
    Op.NEG: lambda a: -a,
    Op.ABS: abs,
    Op.MIN: min,
    Op.MAX: max,
    Op.SELECT: lambda condition, yes, no: yes if condition else no,
    Op.LT: lambda a, b: a < b,
    Op.LE: lambda a, b: a <= b,
    Op.EQ: lambda a, b: a == b,
    Op.NE: lambda a, b: a != b,
    Op.AND: lambda a, b: a and b,
    Op.OR: lambda a, b: a or b,
    Op.NOT: lambda a: not a,
}
_OWN = {Op.OWN_SIN: "sin", Op.OWN_COS: "cos"}
_FUNCTIONS = (
    Op.SQRT, Op.SIN, Op.COS, Op.TAN, Op.ASIN, Op.ACOS, Op.ATAN, Op.ATAN2, Op.EXP, Op.LOG, Op.FLOOR,
)  # fmt: skip


@dataclass(frozen=True)
class Arithmetic:
    """A number system: how a literal becomes a number, and where functions come from."""

    number: Callable[[float], Any]
    functions: Any
    names: Mapping[ir.Operation, str] = field(default_factory=dict)

    def __call__(self, operation: ir.Operation, operands: Sequence[Any]) -> Any:
        """Apply an operation."""
        if operation in _OWN:
            return getattr(self.functions, _OWN[operation])(*operands)
        if operation in _FUNCTIONS:
            name = self.names.get(operation, operation.value)
            return getattr(self.functions, name)(*operands)
        return _ANY[operation](*operands)


DIGITS = Arithmetic(mp.mpf, mp)
DOUBLE = Arithmetic(float, math)
SINGLE = Arithmetic(
    np.float32, np, {Op.ATAN2: "arctan2", Op.ASIN: "arcsin", Op.ACOS: "arccos", Op.ATAN: "arctan"}
)


@dataclass
class Result:
    """Outputs by name and index, and what failed."""

    outputs: dict[str, dict[Index, Any]] = field(default_factory=dict)
    failed: list[ir.Status] = field(default_factory=list)

    def dense(self, name: str, rows: int, columns: int = 0) -> list[Any]:
        """An output row by row; a scalar of an item counts as one row."""
        shape = (rows, columns) if columns else (rows,)
        flat = [mp.mpf(0)] * math.prod(shape)
        for index, value in self.outputs[name].items():
            full = (0,) * (len(shape) - len(index)) + index
            flat[full[0] * columns + full[1] if columns else full[0]] = value
        return flat


class Interpreter:
    """One function in one number system.

    Args:
        function: what to evaluate.
        arithmetic: the number system.
    """

    def __init__(self, function: ir.Function, arithmetic: Arithmetic = DIGITS) -> None:
        self._function = function
        self._arithmetic = arithmetic
        self._arguments: Mapping[str, Sequence[Any]] = {}
        self._values: dict[str, Any] = {}

    def run(self, arguments: Mapping[str, Sequence[Any]]) -> Result:
        """Evaluate at stored elements by argument name, of one item."""
        self._arguments, self._values = arguments, {}
        result = Result()
        for step in (*self._function.shared, *self._function.item):
            value = self._value(step.value)
            if isinstance(step, ir.Check) and not step.lower <= value <= step.upper:
                result.failed.append(step.status)
                value = self._arithmetic.number(step.substitute)
            assert step.target not in self._values, f"{step.target} is assigned twice"
            self._values[step.target] = value
        for output in self._function.outputs:
            result.outputs[output.name] = {
                tuple(self._index(i) for i in entry.index): self._value(entry.value)
                for entry in output.entries
            }
        return result

    def _index(self, index: int | ir.Offset) -> int:
        if isinstance(index, int):
            return index
        return index.base + int(self._value(index.slot))

    def _value(self, expression: ir.Expression) -> Any:
        if isinstance(expression, ir.Number):
            return self._arithmetic.number(expression.value)
        if isinstance(expression, ir.Ref):
            return self._values[expression.name]
        if isinstance(expression, ir.Load):
            return self._arguments[expression.argument][self._index(expression.index)]
        if expression.operation is Op.SELECT:
            condition, yes, no = expression.operands
            return self._value(yes if self._value(condition) else no)
        return self._arithmetic(
            expression.operation, [self._value(operand) for operand in expression.operands]
        )
