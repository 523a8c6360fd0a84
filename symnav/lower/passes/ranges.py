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


def drop_idle_checks(function: ir.Function) -> ir.Function:
    """Turn every check that cannot fail into a plain statement."""
    if not function.guarded:  # nothing holds its inputs inside their ranges either
        return function
    known: dict[str, Interval] = {}
    inputs = {argument.name: _hulls(argument) for argument in function.arguments}
    bodies = []
    for body in (function.shared, function.item):
        steps: list[ir.Step] = []
        for step in body:
            value = _interval(step.value, inputs, known)
            known[step.target] = value
            if isinstance(step, ir.Check):
                if value.is_known and step.lower <= value.lower and value.upper <= step.upper:
                    steps.append(ir.Statement(step.target, step.value, step.comment))
                    continue
                known[step.target] = _checked(step)
            steps.append(step)
        bodies.append(tuple(steps))
    return replace(function, shared=bodies[0], item=bodies[1])


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


def _interval(
    expression: ir.Expression,
    inputs: Mapping[str, tuple[Interval, ...]],
    known: Mapping[str, Interval],
) -> Interval:
    match expression:
        case ir.Number(value):
            return _widened(value, value)
        case ir.Ref(name):
            return known[name]
        case ir.Load(argument, int() as index):
            return inputs[argument][index]
        case ir.Load(argument, _):
            return _hull(*inputs[argument])
        case ir.Call(Operation.SELECT, (_, chosen, otherwise)):
            return _hull(_interval(chosen, inputs, known), _interval(otherwise, inputs, known))
        case ir.Call(Operation.MUL, (a, b)) if a == b:
            square = _applied(Operation.MUL, [_magnitude(_interval(a, inputs, known))] * 2)
            return Interval(max(square.lower, 0.0), square.upper)
        case ir.Call(operation, operands):
            return _applied(operation, [_interval(o, inputs, known) for o in operands])


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
    Operation.MIN: lambda a, b: Interval(min(a.lower, b.lower), min(a.upper, b.upper)),
    Operation.MAX: lambda a, b: Interval(max(a.lower, b.lower), max(a.upper, b.upper)),
}


def _hull(*intervals: Interval) -> Interval:
    return Interval(min(i.lower for i in intervals), max(i.upper for i in intervals))


def _widened(lower: float, upper: float) -> Interval:
    """Room for a rounding at both ends."""
    low = lower - RELATIVE * abs(lower) - ABSOLUTE
    high = upper + RELATIVE * abs(upper) + ABSOLUTE
    if low < -LARGEST or high > LARGEST:
        return ANYTHING
    return Interval(low, high)
