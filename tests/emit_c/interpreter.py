"""The intermediate representation evaluated in 50 digits, as its records describe it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import mpmath as mp
import numpy as np
from numpy.typing import NDArray

from symnav import ir

Array = NDArray[np.float64]
Op = ir.Operation

DIGITS = 50

_FUNCTIONS: Mapping[Op, Callable[..., mp.mpf]] = {
    Op.ADD: lambda a, b: a + b,
    Op.SUB: lambda a, b: a - b,
    Op.MUL: lambda a, b: a * b,
    Op.DIV: lambda a, b: a / b,
    Op.NEG: lambda a: -a,
    Op.SQRT: mp.sqrt,
    Op.SIN: mp.sin,
    Op.COS: mp.cos,
    Op.OWN_SIN: mp.sin,
    Op.OWN_COS: mp.cos,
    Op.TAN: mp.tan,
    Op.ASIN: mp.asin,
    Op.ACOS: mp.acos,
    Op.ATAN: mp.atan,
    Op.ATAN2: mp.atan2,
    Op.EXP: mp.exp,
    Op.LOG: mp.log,
    Op.ABS: abs,
    Op.FLOOR: mp.floor,
    Op.MIN: min,
    Op.MAX: max,
    Op.SELECT: lambda condition, a, b: a if condition else b,
    Op.LT: lambda a, b: a < b,
    Op.LE: lambda a, b: a <= b,
    Op.EQ: lambda a, b: a == b,
    Op.NE: lambda a, b: a != b,
    Op.AND: lambda a, b: a and b,
    Op.OR: lambda a, b: a or b,
    Op.NOT: lambda a: not a,
}


@dataclass
class Result:
    """What a call gives: dense outputs per name, with the item axis in front where there is one."""

    status: ir.Status
    outputs: dict[str, Array] = field(default_factory=dict)
    item_status: list[ir.Status] = field(default_factory=list)


class Failure(Exception):
    """A check that failed."""

    def __init__(self, status: ir.Status) -> None:
        super().__init__(status)
        self.status = status


def evaluate(function: ir.Function, inputs: Mapping[str, Array], n: int = 0) -> Result:
    """Evaluate a function for one epoch.

    Args:
        function: what to evaluate.
        inputs: values by argument; of shape (n, size) for an argument per item.
        n: number of items.
    """
    with mp.workdps(DIGITS):
        try:
            _check_inputs(function, inputs, item=False)
            names = _run(function.shared, function, inputs, {})
        except Failure as failure:
            return Result(failure.status)
        if function.maximum is None:
            outputs = {o.name: _dense(o, function, inputs, names) for o in function.outputs}
            return Result(ir.Status.OK, outputs)
        return _evaluate_items(function, inputs, names, n)


def _evaluate_items(
    function: ir.Function, inputs: Mapping[str, Array], names: Mapping[str, mp.mpf], n: int
) -> Result:
    rows: dict[str, list[Array]] = {o.name: [] for o in function.outputs if o.item}
    statuses: list[ir.Status] = []
    per_item = [argument.name for argument in function.arguments if argument.item]
    for item in range(n):
        own = {k: (v[item] if k in per_item else v) for k, v in inputs.items()}
        try:
            _check_inputs(function, own, item=True)
            known = _run(function.item, function, own, names)
            made = {o.name: _dense(o, function, own, known) for o in function.outputs if o.item}
            statuses.append(ir.Status.OK)
        except Failure as failure:
            made = {o.name: np.zeros(o.shape) for o in function.outputs if o.item}
            statuses.append(failure.status)
        for name, row in made.items():
            rows[name].append(row)
    failed = [status for status in statuses if status is not ir.Status.OK]
    if failed and function.items is ir.Items.REJECT:
        return Result(failed[0], {}, statuses)
    outputs = {
        o.name: np.array(rows[o.name]).reshape((n, *o.shape))
        if o.item
        else _dense(o, function, inputs, names)
        for o in function.outputs
    }
    return Result(ir.Status.PARTIAL if failed else ir.Status.OK, outputs, statuses)


def _check_inputs(function: ir.Function, inputs: Mapping[str, Array], *, item: bool) -> None:
    arguments = [argument for argument in function.arguments if argument.item is item]
    for argument in arguments:
        for domain in argument.domains:
            values = inputs[argument.name][domain.start : domain.start + domain.size]
            if not (function.checks_inputs or domain.kind is ir.Kind.INTEGER):
                continue
            for value, lower, upper in zip(values, domain.lower, domain.upper, strict=True):
                if not (np.isfinite(value) and lower <= value <= upper):
                    raise Failure(ir.Status.RANGE)
    for argument in arguments if function.checks_inputs else ():
        for domain in argument.domains:
            values = inputs[argument.name][domain.start : domain.start + domain.size]
            _check_norm(domain, [mp.mpf(float(value)) for value in values])


def _check_norm(domain: ir.Domain, values: Sequence[mp.mpf]) -> None:
    if domain.kind is ir.Kind.QUATERNION:
        excess = [sum(value * value for value in values) - 1]
    elif domain.kind is ir.Kind.MATRIX:
        excess = [
            sum(values[3 * k + i] * values[3 * k + j] for k in range(3)) - (1 if i == j else 0)
            for i in range(3)
            for j in range(3)
        ]
        handed = np.linalg.det(np.reshape(np.array(values, dtype=float), (3, 3)))
        excess.append(float(handed) - 1.0)
    else:
        return
    if any(abs(one) > domain.tolerance for one in excess):
        raise Failure(ir.Status.QNORM)


def _run(
    steps: Sequence[ir.Step],
    function: ir.Function,
    inputs: Mapping[str, Array],
    known: Mapping[str, mp.mpf],
) -> dict[str, mp.mpf]:
    names = dict(known)
    for step in steps:
        value = _value(step.value, inputs, names)
        if (
            isinstance(step, ir.Check)
            and function.checks_domain
            and not (step.lower <= value <= step.upper)
        ):
            raise Failure(step.status)
        names[step.target] = value
    return names


def _value(
    expression: ir.Expression, inputs: Mapping[str, Array], names: Mapping[str, mp.mpf]
) -> mp.mpf:
    match expression:
        case ir.Number(value):
            return mp.mpf(value)
        case ir.Ref(name):
            return names[name]
        case ir.Load(argument, element):
            return mp.mpf(float(inputs[argument][_index(element, inputs)]))
        case ir.Call(operation, operands):
            values = [_value(operand, inputs, names) for operand in operands]
            return _FUNCTIONS[operation](*values)


def _dense(
    output: ir.Output,
    function: ir.Function,
    inputs: Mapping[str, Array],
    names: Mapping[str, mp.mpf],
) -> Array:
    dense = np.zeros(output.shape)
    for entry in output.entries:
        place = tuple(_index(step, inputs) for step in entry.index)
        dense[place] = float(_value(entry.value, inputs, names))
    return dense


def _index(index: int | ir.Offset, inputs: Mapping[str, Array]) -> int:
    if isinstance(index, int):
        return index
    return index.base + int(inputs[index.slot.argument][_index(index.slot.index, inputs)])
