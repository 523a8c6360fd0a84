"""Checks that cannot fail are left out: what they guard follows from the declared ranges.

Kernels read copies that are inside their ranges, and a checked value stays inside its bounds.
Intervals of both, widened by more than the roundings of single precision, say what a later value
can be. A check whose bounds hold all of that is dead code, which no test could ever reach.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from itertools import product

from symnav import ir

Operation = ir.Operation

#: More than a rounding of either type, relative and near zero.
RELATIVE, ABSOLUTE = 2.0**-22, 1e-44
#: What is larger may overflow in single precision.
LARGEST = 3e38


@dataclass(frozen=True, slots=True)
class Interval:
    """Numbers from ``lower`` to ``upper``; with an infinite end it may be anything, even NaN."""

    lower: float
    upper: float

    @property
    def is_known(self) -> bool:
        """True when both ends are finite."""
        return math.isfinite(self.lower) and math.isfinite(self.upper)


ANYTHING = Interval(float("-inf"), float("inf"))


class Ranges:
    """What the inputs of a function and the steps so far can be.

    Inputs are taken to be inside their declared ranges, whether that is checked or assumed.
    """

    def __init__(self, function: ir.Function) -> None:
        self._inputs = {argument.name: _hulls(argument) for argument in function.arguments}
        self._known: dict[str, Interval] = {}

    def note(self, step: ir.Step) -> None:
        """Take in a step that later ones read."""
        known = _checked(step) if isinstance(step, ir.Check) else self.of(step.value)
        self._known[step.target] = known

    def of(self, expression: ir.Expression) -> Interval:
        """What an expression over inputs and known steps can be."""
        match expression:
            case ir.Number(value):
                return _widened(value, value)
            case ir.Ref(name):
                return self._known[name]
            case ir.Load(argument, int() as index):
                return self._inputs[argument][index]
            case ir.Load(argument, _):
                return _hull(*self._inputs[argument])
            case ir.Call(Operation.SELECT, (_, chosen, otherwise)):
                return _hull(self.of(chosen), self.of(otherwise))
            case ir.Call(Operation.MUL, (a, b)) if a == b:
                square = _applied(Operation.MUL, [_magnitude(self.of(a))] * 2)
                return Interval(max(square.lower, 0.0), square.upper)
            case ir.Call(operation, operands):
                return _applied(operation, [self.of(operand) for operand in operands])


def drop_idle_checks(function: ir.Function) -> ir.Function:
    """Turn every check that cannot fail into a plain statement."""
    if not function.checks_domain:  # nothing holds its inputs inside their ranges either
        return function
    ranges = Ranges(function)
    shared = tuple(_without_idle_check(step, ranges) for step in function.shared)
    item = tuple(_without_idle_check(step, ranges) for step in function.item)
    return replace(function, shared=shared, item=item)


def _without_idle_check(step: ir.Step, ranges: Ranges) -> ir.Step:
    """The step, or a plain statement of the same value."""
    value = ranges.of(step.value)
    if isinstance(step, ir.Check) and (
        value.is_known and step.lower <= value.lower and value.upper <= step.upper
    ):
        step = ir.Statement(step.target, step.value, step.comment)
    ranges.note(step)
    return step


def _checked(step: ir.Check) -> Interval:
    """A value that passed, or what stands in for it."""
    ends = (step.lower, step.upper, step.substitute)
    return _widened(min(ends), max(ends))


def _hulls(argument: ir.Argument) -> tuple[Interval, ...]:
    """The range of every element."""
    return tuple(
        _widened(lower, upper)
        for domain in argument.domains
        for lower, upper in zip(domain.lower, domain.upper, strict=True)
    )


def _applied(operation: ir.Operation, operands: list[Interval]) -> Interval:
    rule = _RULES.get(operation)
    if rule is None or not all(operand.is_known for operand in operands):
        return ANYTHING
    return rule(*operands)


def _corners(function: Callable[[float, float], float]) -> Callable[[Interval, Interval], Interval]:
    """An operation that is monotonic in each operand."""

    def rule(a: Interval, b: Interval) -> Interval:
        values = [function(x, y) for x, y in product((a.lower, a.upper), (b.lower, b.upper))]
        return _widened(min(values), max(values))

    return rule


def _quotient(a: Interval, b: Interval) -> Interval:
    if b.lower <= 0.0 <= b.upper:
        return ANYTHING
    return _corners(lambda x, y: x / y)(a, b)


def _root(a: Interval) -> Interval:
    return ANYTHING if a.lower < 0.0 else _widened(math.sqrt(a.lower), math.sqrt(a.upper))


def _magnitude(a: Interval) -> Interval:
    largest = max(abs(a.lower), abs(a.upper))
    touches = a.lower <= 0.0 <= a.upper
    return Interval(0.0 if touches else min(abs(a.lower), abs(a.upper)), largest)


_RULES: Mapping[ir.Operation, Callable[..., Interval]] = {
    Operation.ADD: _corners(lambda x, y: x + y),
    Operation.SUB: _corners(lambda x, y: x - y),
    Operation.MUL: _corners(lambda x, y: x * y),
    Operation.DIV: _quotient,
    Operation.NEG: lambda a: Interval(-a.upper, -a.lower),
    Operation.SQRT: _root,
    Operation.ABS: _magnitude,
    Operation.SIN: lambda _: _widened(-1.0, 1.0),
    Operation.COS: lambda _: _widened(-1.0, 1.0),
    Operation.OWN_SIN: lambda _: _widened(-1.0, 1.0),
    Operation.OWN_COS: lambda _: _widened(-1.0, 1.0),
    Operation.MIN: lambda a, b: Interval(min(a.lower, b.lower), min(a.upper, b.upper)),
    Operation.MAX: lambda a, b: Interval(max(a.lower, b.lower), max(a.upper, b.upper)),
}


def _hull(*intervals: Interval) -> Interval:
    return Interval(min(i.lower for i in intervals), max(i.upper for i in intervals))


def _widened(lower: float, upper: float) -> Interval:
    """Room for a rounding at both ends, which changes no sign."""
    low = lower - RELATIVE * abs(lower) - ABSOLUTE
    high = upper + RELATIVE * abs(upper) + ABSOLUTE
    low, high = (0.0 if lower >= 0.0 > low else low), (0.0 if upper <= 0.0 < high else high)
    if low < -LARGEST or high > LARGEST:
        return ANYTHING
    return Interval(low, high)
