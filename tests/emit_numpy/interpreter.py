"""A plain interpreter of the intermediate representation: one epoch, one item, Python floats.

It shares nothing with the emitters but the records, and says what every back end must answer.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from symnav import ir

Op = ir.Operation
Elements = Mapping[str, list[float]]

_ARITHMETIC: Mapping[ir.Operation, Callable[..., float | bool]] = {
    Op.ADD: operator.add,
    Op.SUB: operator.sub,
    Op.MUL: operator.mul,
    Op.DIV: operator.truediv,
    Op.NEG: operator.neg,
    Op.SQRT: math.sqrt,
    Op.SIN: math.sin,
    Op.COS: math.cos,
    Op.TAN: math.tan,
    Op.ASIN: math.asin,
    Op.ACOS: math.acos,
    Op.ATAN: math.atan,
    Op.ATAN2: math.atan2,
    Op.EXP: math.exp,
    Op.LOG: math.log,
    Op.ABS: abs,
    Op.FLOOR: math.floor,
    Op.MIN: min,
    Op.MAX: max,
    Op.SELECT: lambda condition, chosen, other: chosen if condition else other,
    Op.LT: operator.lt,
    Op.LE: operator.le,
    Op.EQ: operator.eq,
    Op.NE: operator.ne,
    Op.AND: lambda left, right: left and right,
    Op.OR: lambda left, right: left or right,
    Op.NOT: operator.not_,
}


@dataclass
class Answer:
    """What a call for one epoch gives; rows of items that failed are zero."""

    status: ir.Status
    outputs: dict[str, NDArray[np.float64]]
    item_status: list[ir.Status] = field(default_factory=list)


@dataclass
class _Scope:
    """Values known so far and the first status that was not OK."""

    elements: Elements
    values: dict[str, float]
    status: ir.Status = ir.Status.OK

    def note(self, status: ir.Status) -> None:
        if self.status is ir.Status.OK:
            self.status = status


def evaluate(function: ir.Function, arguments: Mapping[str, object]) -> Answer:
    """Evaluates a function for one epoch.

    Args:
        function: what is called.
        arguments: arrays by name, with an item axis in front where the argument is per item.
    """
    rows = {
        a.name: np.reshape(np.asarray(arguments[a.name], dtype=float), (-1, a.size))
        for a in function.arguments
    }
    shared = {a.name: rows[a.name][0].tolist() for a in function.arguments if not a.item}
    scope = _Scope(shared, {})
    _load(function, scope, [a for a in function.arguments if not a.item])
    _run(function, function.shared, scope)
    if function.maximum is None:
        outputs = {o.name: _dense(o, scope) for o in function.outputs}
        return Answer(scope.status, outputs)
    items = [a for a in function.arguments if a.item]
    count = len(rows[items[0].name])
    scopes = []
    for number in range(count):
        own = _Scope({**shared, **{a.name: rows[a.name][number].tolist() for a in items}}, {})
        own.values.update(scope.values)
        _load(function, own, items)
        _run(function, function.item, own)
        scopes.append(own)
    statuses = [own.status for own in scopes]
    outputs = {
        o.name: np.reshape([_row(o, own) for own in scopes], (count, *o.shape))
        if o.item
        else _dense(o, scope)
        for o in function.outputs
    }
    return Answer(_overall(function, scope.status, statuses), outputs, statuses)


def _overall(function: ir.Function, shared: ir.Status, items: list[ir.Status]) -> ir.Status:
    failed = [status for status in items if status is not ir.Status.OK]
    if shared is not ir.Status.OK or not failed:
        return shared
    return ir.Status.PARTIAL if function.items is ir.Items.SKIP else failed[0]


def _load(function: ir.Function, scope: _Scope, arguments: Sequence[ir.Argument]) -> None:
    """Ranges of all arguments first, then norms; integers are always checked.

    An element out of its range is replaced, so that the arithmetic that follows is defined.
    """
    watched = [a for a in arguments if function.checks_inputs or a.integer]
    for argument in watched:
        for domain in argument.domains:
            for number, (low, high) in enumerate(zip(domain.lower, domain.upper, strict=True)):
                value = scope.elements[argument.name][domain.start + number]
                if not (math.isfinite(value) and low <= value <= high):
                    scope.note(ir.Status.RANGE)
                    scope.elements[argument.name][domain.start + number] = min(max(1, low), high)
    if scope.status is not ir.Status.OK:
        return
    for argument in watched:
        for domain in argument.domains:
            if _skew(domain, _part(scope, argument, domain)) > domain.tolerance:
                scope.note(ir.Status.QNORM)


def _part(scope: _Scope, argument: ir.Argument, domain: ir.Domain) -> Sequence[float]:
    return scope.elements[argument.name][domain.start : domain.start + domain.size]


def _skew(domain: ir.Domain, part: Sequence[float]) -> float:
    if domain.kind is ir.Kind.QUATERNION:
        return abs(sum(value * value for value in part) - 1.0)
    if domain.kind is ir.Kind.MATRIX:
        matrix = np.reshape(part, (3, 3))
        handed = abs(float(np.linalg.det(matrix)) - 1.0)
        return max(float(np.max(np.abs(matrix.T @ matrix - np.eye(3)))), handed)
    return 0.0


def _run(function: ir.Function, steps: Sequence[ir.Step], scope: _Scope) -> None:
    for step in steps:
        value = _value(step.value, scope)
        if isinstance(step, ir.Check) and function.checks_domain:
            passed = math.isfinite(value) and step.lower <= value <= step.upper
            if not passed:
                scope.note(step.status)
                value = step.substitute
        scope.values[step.target] = value


def _value(expression: ir.Expression, scope: _Scope) -> float:
    if isinstance(expression, ir.Number):
        return expression.value
    if isinstance(expression, ir.Ref):
        return scope.values[expression.name]
    if isinstance(expression, ir.Load):
        index = expression.index
        if isinstance(index, ir.Offset):
            return _at(scope.elements[expression.argument], index.base, _value(index.slot, scope))
        return scope.elements[expression.argument][index]
    operands = [_value(operand, scope) for operand in expression.operands]
    return _ARITHMETIC[expression.operation](*operands)


def _at(elements: Sequence[float], base: int, slot: float) -> float:
    """An element; that of a bad index does not matter, since its item failed."""
    index = base + int(slot)
    return elements[index] if 0 <= index < len(elements) else 0.0


def _row(output: ir.Output, scope: _Scope) -> NDArray[np.float64]:
    return _dense(output, scope) if scope.status is ir.Status.OK else np.zeros(output.shape)


def _dense(output: ir.Output, scope: _Scope) -> NDArray[np.float64]:
    dense = np.zeros(output.shape)
    for entry in output.entries:
        index = tuple(
            i.base + int(_value(i.slot, scope)) if isinstance(i, ir.Offset) else i
            for i in entry.index
        )
        dense[index] = _value(entry.value, scope)
    return dense
