"""The worst rounding errors that can be found by looking for them: what bounds are held against.

The lowered function is evaluated twice, in its type and in a wider one, on a population of inputs
that is moved towards larger errors. The search is seeded: the same numbers every time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.export.arithmetic import sinusoids
from symnav.export.arithmetic.walk import evaluate, run
from symnav.export.rounding.sampling import TYPES, moved, samples

Array = NDArray[Any]

WIDER: Mapping[ir.Scalar, Any] = {ir.Scalar.FLOAT: np.float64, ir.Scalar.DOUBLE: np.longdouble}

_KEPT = 64
_CHILDREN = 32


def can_judge(scalar: ir.Scalar) -> bool:
    """True where this machine has a type that is wider by enough bits to judge with."""
    return bool(np.finfo(WIDER[scalar]).nmant >= np.finfo(TYPES[scalar]).nmant + 10)


@dataclass(frozen=True)
class Found:
    """The worst that was found for an output.

    Attributes:
        error: |computed - judge|.
        entry: which of its entries.
        arguments: the inputs, by argument.
        evaluations: how many inputs were looked at.
    """

    error: float
    entry: int
    arguments: Mapping[str, tuple[float, ...]]
    evaluations: int


class Vectors:
    """A ``walk.Arithmetic`` of arrays in one type; remembers where a guard failed.

    Functions of the library are evaluated in a wider type and rounded, so that their errors are
    within half a unit in the last place whatever the machine.
    """

    def __init__(self, kind: Any, wider: Any, count: int) -> None:
        self.kind, self.wider = kind, wider
        self.passed = np.ones(count, dtype=bool)

    def number(self, value: float) -> Array:
        """A literal in the type."""
        return np.asarray(self.kind(value))

    def apply(self, operation: ir.Operation, operands: Sequence[Array]) -> Array:
        """An operation in the type."""
        if operation in _OWN:
            own, judge = _OWN[operation]
            return np.asarray((judge if self.kind is self.wider else own)(*operands))
        if operation in _LIBRARY:
            wide = [operand.astype(self.wider) for operand in operands]
            return np.asarray(_LIBRARY[operation](*wide).astype(self.kind))
        return np.asarray(_ARITHMETIC[operation](*operands))

    def check(self, step: ir.Check, value: Array) -> Array:
        """Select and flag, as the C does."""
        ok = (value >= self.kind(step.lower)) & (value <= self.kind(step.upper))
        self.passed &= ok
        return np.asarray(np.where(ok, value, self.kind(step.substitute)))


_ARITHMETIC: Mapping[ir.Operation, Callable[..., Any]] = {
    ir.Operation.ADD: np.add,
    ir.Operation.SUB: np.subtract,
    ir.Operation.MUL: np.multiply,
    ir.Operation.DIV: np.divide,
    ir.Operation.NEG: np.negative,
    ir.Operation.ABS: np.abs,
    ir.Operation.SQRT: np.sqrt,
    ir.Operation.FLOOR: np.floor,
    ir.Operation.MIN: np.minimum,
    ir.Operation.MAX: np.maximum,
    ir.Operation.SELECT: np.where,
    ir.Operation.LT: np.less,
    ir.Operation.LE: np.less_equal,
    ir.Operation.EQ: np.equal,
    ir.Operation.NE: np.not_equal,
    ir.Operation.AND: np.logical_and,
    ir.Operation.OR: np.logical_or,
    ir.Operation.NOT: np.logical_not,
}

_OWN: Mapping[ir.Operation, tuple[Callable[..., Any], Callable[..., Any]]] = {
    ir.Operation.OWN_SIN: (sinusoids.sine, np.sin),
    ir.Operation.OWN_COS: (sinusoids.cosine, np.cos),
}
"""As the C evaluates them, and what a judge takes for true."""

_LIBRARY: Mapping[ir.Operation, Callable[..., Any]] = {
    ir.Operation.SIN: np.sin,
    ir.Operation.COS: np.cos,
    ir.Operation.TAN: np.tan,
    ir.Operation.ASIN: np.arcsin,
    ir.Operation.ACOS: np.arccos,
    ir.Operation.ATAN: np.arctan,
    ir.Operation.ATAN2: np.arctan2,
    ir.Operation.EXP: np.exp,
    ir.Operation.LOG: np.log,
}


def values(
    function: ir.Function, arguments: Mapping[str, Array], kind: Any, wider: Any
) -> tuple[dict[str, Array], Array]:
    """Every entry of every output, (count, entries) each, and where all guards passed."""
    count = len(next(iter(arguments.values())))
    arithmetic = Vectors(kind, wider, count)

    def load(element: ir.Load) -> Array:
        rows = arguments[element.argument]
        if isinstance(element.index, int):
            return np.asarray(rows[:, element.index].astype(kind))
        slots = element.index.base + load(element.index.slot).astype(int)
        return np.asarray(np.take_along_axis(rows, slots[:, None], axis=1)[:, 0].astype(kind))

    with np.errstate(all="ignore"):
        shared = run(function.shared, load, {}, arithmetic)
        known = run(function.item, load, shared, arithmetic)
        found = {
            output.name: np.stack(
                [
                    np.broadcast_to(evaluate(entry.value, load, known, arithmetic), (count,))
                    for entry in output.entries
                ]
                or [np.zeros(count)],
                axis=1,
            )
            for output in function.outputs
        }
    return found, arithmetic.passed


def errors(
    function: ir.Function, scalar: ir.Scalar, arguments: Mapping[str, Array]
) -> dict[str, Array]:
    """|computed - judge| of every entry; zero where a guard failed in either type."""
    kind, wider = TYPES[scalar], WIDER[scalar]
    computed, passed = values(function, arguments, kind, wider)
    judged, meant = values(function, arguments, wider, wider)
    inside = (passed & meant)[:, None]
    return {
        name: np.where(inside, np.abs(computed[name].astype(wider) - judged[name]), 0.0).astype(
            np.float64
        )
        for name in computed
    }


def search(
    function: ir.Function, scalar: ir.Scalar, output: str, *, budget: int, seed: int
) -> Found:
    """Climb towards the largest error of an output.

    Args:
        function: as it is written in C.
        scalar: type of the C.
        output: name of the output.
        budget: most inputs to look at.
        seed: of the search.
    """
    rng = np.random.default_rng(seed)
    batch = _KEPT * _CHILDREN
    points = samples(function, scalar, batch, rng)
    worst = errors(function, scalar, points)[output].max(axis=1)
    looked_at = batch
    while looked_at + batch <= budget:
        best = np.argsort(-worst, kind="stable")[:_KEPT]
        kept = {name: rows[best] for name, rows in points.items()}
        crowd = {name: np.repeat(rows, _CHILDREN, axis=0) for name, rows in kept.items()}
        tried = moved(function, scalar, crowd, rng)
        points = {name: np.concatenate([kept[name], tried[name]]) for name in kept}
        worst = errors(function, scalar, points)[output].max(axis=1)
        looked_at += batch
    top = int(np.argmax(worst))
    arguments = {name: tuple(float(v) for v in rows[top]) for name, rows in points.items()}
    single = errors(function, scalar, {name: rows[top : top + 1] for name, rows in points.items()})
    return Found(float(worst[top]), int(np.argmax(single[output][0])), arguments, looked_at)
