"""One walk through a lowered function, in whatever arithmetic.

The records of ``symnav.ir`` say what the C computes, operation by operation and in its order. What
a number is, is left to an ``Arithmetic``: IEEE 754 numbers give the bits of the C, enclosures with
error bounds give what rounding can do to them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Protocol, TypeVar

from symnav import ir

T = TypeVar("T")
Loads = Callable[[ir.Load], T]


class Arithmetic(Protocol[T]):
    """Numbers and what can be done with them.

    Comparisons give conditions, which are numbers of the same type in a form the arithmetic knows
    and which only ``SELECT``, ``AND``, ``OR`` and ``NOT`` ever see.
    """

    def number(self, value: float) -> T:
        """A literal as the C writes it in the function's type."""
        ...

    def apply(self, operation: ir.Operation, operands: Sequence[T]) -> T:
        """An operation on operands."""
        ...

    def check(self, step: ir.Check, value: T) -> T:
        """What a guarded temporary is worth; may raise where its guard fails."""
        ...


def run(
    steps: Sequence[ir.Step], loads: Loads[T], known: Mapping[str, T], arithmetic: Arithmetic[T]
) -> dict[str, T]:
    """Values of all targets after the steps, those already known among them."""
    values = dict(known)
    for step in steps:
        value = evaluate(step.value, loads, values, arithmetic)
        values[step.target] = arithmetic.check(step, value) if isinstance(step, ir.Check) else value
    return values


def evaluate(
    expression: ir.Expression, loads: Loads[T], known: Mapping[str, T], arithmetic: Arithmetic[T]
) -> T:
    """Value of an expression."""
    match expression:
        case ir.Number(value):
            return arithmetic.number(value)
        case ir.Ref(name):
            return known[name]
        case ir.Load():
            return loads(expression)
        case ir.Call(operation, operands):
            evaluated = [evaluate(operand, loads, known, arithmetic) for operand in operands]
            return arithmetic.apply(operation, evaluated)
