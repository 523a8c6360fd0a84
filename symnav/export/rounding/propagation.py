"""How errors go through operations: from the operands' numbers to the result's.

For every operation the exact result on the computed operands is enclosed first (``moved`` is how
far it may be from the exact result on the exact operands), then rounded to the type.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import Enum, auto

from flint import arb

from symnav.export.rounding import intervals
from symnav.export.rounding.expressions import Operation
from symnav.export.rounding.formats import Format
from symnav.export.rounding.intervals import (
    EVERYTHING,
    INFINITY,
    PI,
    Interval,
    above,
    down_product,
    down_sum,
    magnitudes,
    point,
    up_product,
    up_quotient,
    up_sqrt,
    up_sum,
)
from symnav.export.rounding.model import Number


def literal(value: float, kind: Format) -> Number:
    """A constant: rounded to the type once."""
    held = kind.literal(value)
    error = up_sum(abs(held - value), 0.0)
    return Number(point(value), point(held), error, error, _relative(error, value))


def element(values: Interval, kind: Format) -> Number:
    """An input: what the caller passes is what is meant."""
    held = values.hull(Interval(kind.literal(values.lo), kind.literal(values.hi)))
    return Number(held, held, 0.0, 0.0, 0.0)


def _relative(error: float, value: float) -> float:
    if value == 0.0:
        return 0.0 if error == 0.0 else INFINITY
    return up_quotient(error, abs(value))


class Finish(Enum):
    """What happens to the exact result of an operation on computed operands."""

    ROUNDED = auto()
    SCALED = auto()
    LIBRARY = auto()
    KEPT = auto()


@dataclass(frozen=True, slots=True)
class Raw:
    """A result before it is rounded.

    Attributes:
        real: the operation on the exact operands.
        exact: the operation on the computed operands, itself without rounding.
        moved: bound on the distance between the two.
        turned: the same but for whole turns, where that is less.
        relative: bound on the distance over the magnitude of the former.
        finish: how the result gets into the type.
    """

    real: Interval
    exact: Interval
    moved: float
    turned: float = INFINITY
    relative: float = INFINITY
    finish: Finish = Finish.ROUNDED


Rule = Callable[[Sequence[Number], Format], Raw]


def apply(
    operation: Operation,
    operands: Sequence[Number],
    kind: Format,
    known: Interval = EVERYTHING,
) -> Number:
    """The result of an operation that is neither a condition nor a choice.

    A bound that is infinite stays infinite, whatever the operation: it may stand for a result that
    is not a number.

    Args:
        operation: what is done.
        operands: to these.
        kind: in this type.
        known: holds every exact result, as is known from elsewhere.

    Raises:
        Empty: when what is known cannot be.
    """
    raw = _RULES[operation](operands, kind)
    if any(operand.error == INFINITY for operand in operands):
        return Number(raw.real.meet(known), EVERYTHING, INFINITY, INFINITY)
    return finished(raw, kind, known)


def finished(raw: Raw, kind: Format, known: Interval = EVERYTHING) -> Number:
    """A result in its type: what is known of the exact one bounds the rounding as well."""
    real, exact = raw.real.meet(known), raw.exact
    if raw.moved < INFINITY:
        exact = exact.meet(real.widened(raw.moved))
    if not exact.magnitude <= kind.largest or raw.moved == INFINITY:
        return Number(real, EVERYTHING, INFINITY, INFINITY)
    rounding = _finishing(raw.finish, exact.magnitude, kind)
    library = raw.finish is Finish.LIBRARY
    computed = exact.widened(rounding) if library else kind.rounded(exact)
    error = up_sum(raw.moved, rounding)
    turned = min(error, up_sum(raw.turned, rounding))
    return Number(real, computed, error, turned, _relatively(raw, real, kind))


def _relatively(raw: Raw, real: Interval, kind: Format) -> float:
    """Relative error of a result that certainly has all its bits."""
    if raw.finish is Finish.KEPT:
        return raw.relative
    least = down_product(real.mignitude, down_sum(1.0, -raw.relative))
    if raw.finish is Finish.LIBRARY or raw.relative >= 0.5 or least < kind.smallest:
        return INFINITY
    if raw.finish is Finish.SCALED:
        return raw.relative
    return both(raw.relative, kind.rounding(1.0))


def both(a: float, b: float) -> float:
    """Two relative errors one after the other: (1 + a) (1 + b) - 1."""
    return up_sum(up_sum(a, b), up_product(a, b))


def _finishing(finish: Finish, magnitude: float, kind: Format) -> float:
    if finish is Finish.ROUNDED:
        return kind.rounding(magnitude)
    if finish is Finish.LIBRARY:
        return kind.library(magnitude)
    return kind.tiny if finish is Finish.SCALED else 0.0


def _add(operands: Sequence[Number], kind: Format) -> Raw:
    a, b = operands
    moved, turned = up_sum(a.error, b.error), up_sum(a.turned, b.turned)
    alike = min(a.real.lo, b.real.lo) >= 0.0 or max(a.real.hi, b.real.hi) <= 0.0
    relative = max(a.relative, b.relative) if alike else INFINITY
    return Raw(a.real + b.real, a.computed + b.computed, moved, turned, relative)


def _sub(operands: Sequence[Number], kind: Format) -> Raw:
    a, b = operands
    return _add((a, _negated(b)), kind)


def _negated(a: Number) -> Number:
    return Number(-a.real, -a.computed, a.error, a.turned, a.relative)


def _mul(operands: Sequence[Number], kind: Format) -> Raw:
    a, b = operands
    if a is b:
        real, exact = a.real.square(), a.computed.square()
    else:
        real, exact = a.real * b.real, a.computed * b.computed
    moved = min(
        up_sum(up_product(a.computed.magnitude, b.error), up_product(b.real.magnitude, a.error)),
        up_sum(up_product(b.computed.magnitude, a.error), up_product(a.real.magnitude, b.error)),
    )
    turned = min(_multiplied(a, b), _multiplied(b, a))
    scaled = _is_power_of_two(a) or _is_power_of_two(b)
    finish = Finish.SCALED if scaled else Finish.ROUNDED
    return Raw(real, exact, moved, turned, both(a.relative, b.relative), finish)


def _multiplied(a: Number, factor: Number) -> float:
    """What is left of whole turns after an integer multiple."""
    exact = factor.real == factor.computed and factor.real.is_point
    if exact and factor.real.lo.is_integer():
        return up_product(factor.real.magnitude, a.turned)
    return INFINITY


def _is_power_of_two(a: Number) -> bool:
    values = a.computed
    return values.is_point and values.lo != 0.0 and abs(math.frexp(values.lo)[0]) == 0.5


def _div(operands: Sequence[Number], kind: Format) -> Raw:
    a, b = operands
    real, exact = a.real / b.real, a.computed / b.computed
    moved = min(
        _quotient_moved(a.error, b.error, real, b.computed),
        _quotient_moved(a.error, b.error, exact, b.real),
    )
    # (1 + a) / (1 - b) - 1 = (a + b) / (1 - b)
    rest = down_sum(1.0, -b.relative)
    relative = up_quotient(up_sum(a.relative, b.relative), rest) if rest > 0.0 else INFINITY
    return Raw(real, exact, moved, relative=relative)


def _quotient_moved(a_error: float, b_error: float, quotient: Interval, divisor: Interval) -> float:
    """|a'/b' - a/b| <= (|a' - a| + |a/b| |b' - b|) / |b'|, and the same with the primes swapped."""
    if divisor.mignitude == 0.0:
        return INFINITY
    shifted = up_sum(a_error, up_product(quotient.magnitude, b_error))
    return up_quotient(shifted, divisor.mignitude)


def _neg(operands: Sequence[Number], kind: Format) -> Raw:
    a = _negated(operands[0])
    return Raw(a.real, a.computed, a.error, a.turned, a.relative, Finish.KEPT)


def _abs(operands: Sequence[Number], kind: Format) -> Raw:
    (a,) = operands
    real, computed = magnitudes(a.real), magnitudes(a.computed)
    return Raw(real, computed, a.error, relative=a.relative, finish=Finish.KEPT)


def _sqrt(operands: Sequence[Number], kind: Format) -> Raw:
    (a,) = operands
    if a.computed.lo < 0.0:
        # The graph does not rule out a negative number under the root: no bound.
        return Raw(a.real.sqrt(), EVERYTHING, INFINITY)
    real, exact = a.real.sqrt(), a.computed.sqrt()
    # |sqrt a' - sqrt a| = |a' - a| / (sqrt a' + sqrt a) <= sqrt |a' - a|
    lowest = down_sum(real.lo, exact.lo)
    moved = up_sqrt(a.error)
    if lowest > 0.0:
        moved = min(moved, up_quotient(a.error, lowest))
    # |sqrt(1 + e) - 1| <= r / (2 - r) for |e| <= r < 1
    relative = INFINITY
    if a.relative < 1.0:
        relative = up_quotient(a.relative, down_sum(2.0, -a.relative))
    return Raw(real, exact, moved, relative=relative)


def _wave(function: Callable[[Interval], Interval], slope: Callable[[Interval], Interval]) -> Rule:
    """Sine and cosine: nowhere steeper than 1, and blind to whole turns."""

    def rule(operands: Sequence[Number], kind: Format) -> Raw:
        (a,) = operands
        steepest = slope(a.real.hull(a.computed)).magnitude
        moved = min(up_product(steepest, a.error), a.turned, 2.0)
        return Raw(function(a.real), function(a.computed), moved, finish=Finish.LIBRARY)

    return rule


def _monotone(
    function: Callable[[arb], arb],
    steepness: Callable[[Interval], Interval],
    defined: Interval = EVERYTHING,
) -> Rule:
    """Increasing functions, by the mean value theorem."""

    def rule(operands: Sequence[Number], kind: Format) -> Raw:
        (a,) = operands
        if not (defined.lo <= a.computed.lo and a.computed.hi <= defined.hi):
            return Raw(EVERYTHING, EVERYTHING, INFINITY)
        real = intervals.increasing(function, a.real.meet(defined))
        exact = intervals.increasing(function, a.computed)
        moved = up_product(steepness(a.real.hull(a.computed)).magnitude, a.error)
        return Raw(real, exact, moved, finish=Finish.LIBRARY)

    return rule


def _tan(operands: Sequence[Number], kind: Format) -> Raw:
    (a,) = operands
    if intervals.cosine(a.real.hull(a.computed)).mignitude == 0.0:
        return Raw(EVERYTHING, EVERYTHING, INFINITY)
    rule = _monotone(lambda ball: ball.tan(), lambda v: _reciprocal(intervals.cosine(v).square()))
    return rule(operands, kind)


def _reciprocal(values: Interval) -> Interval:
    return intervals.ONE / values


def _acos(operands: Sequence[Number], kind: Format) -> Raw:
    """A quarter turn less the arc sine."""
    (a,) = operands
    turned = _RULES[Operation.ASIN]((_negated(a),), kind)
    quarter = Interval(PI.lo / 2.0, PI.hi / 2.0)
    return replace(turned, real=turned.real + quarter, exact=turned.exact + quarter)


def _atan2(operands: Sequence[Number], kind: Format) -> Raw:
    y, x = operands
    return _angle(y, x, 0.0)


def angle(
    y: Number, x: Number, radius: float, kind: Format, known: Interval = EVERYTHING
) -> Number:
    """The angle of a point: it moves by at most an arc over the distance from the origin.

    Args:
        y: ordinate.
        x: abscissa.
        radius: least distance of the exact point from the origin, as far as it is known.
        kind: the type.
        known: holds every exact result.
    """
    return finished(_angle(y, x, radius), kind, known)


def _angle(y: Number, x: Number, radius: float) -> Raw:
    real, exact = intervals.arctangent(y.real, x.real), intervals.arctangent(y.computed, x.computed)
    shift = intervals.length((y.error, x.error))
    around_y, around_x = y.real.hull(y.computed), x.real.hull(x.computed)
    box = (magnitudes(around_y).square() + magnitudes(around_x).square()).sqrt().lo
    nearest = max(box, radius)
    # From a point r away from the origin everything within d of it is seen within asin(d / r),
    # which is at most pi/2 d / r.
    turned = PI.hi
    if shift < nearest:
        turned = min(turned, up_product(above(PI.hi / 2.0), up_quotient(shift, nearest)))
    on_cut = around_x.lo <= 0.0 and around_y.lo <= 0.0 <= around_y.hi
    moved = min(2.0 * PI.hi if on_cut else turned, real.farthest(exact))
    return Raw(real, exact, moved, turned, finish=Finish.LIBRARY)


def _floor(operands: Sequence[Number], kind: Format) -> Raw:
    (a,) = operands
    real, computed = a.real.floor(), a.computed.floor()
    moved = 0.0 if real == computed and real.is_point else above(a.error + 1.0)
    return Raw(real, computed, moved, finish=Finish.KEPT)


def _extreme(pick: Callable[[float, float], float]) -> Rule:
    """The smaller or the larger of two: moves no more than either of them."""

    def rule(operands: Sequence[Number], kind: Format) -> Raw:
        a, b = operands
        real, computed = (
            Interval(pick(p.lo, q.lo), pick(p.hi, q.hi))
            for p, q in ((a.real, b.real), (a.computed, b.computed))
        )
        return Raw(real, computed, max(a.error, b.error), finish=Finish.KEPT)

    return rule


def _exponential(values: Interval) -> Interval:
    return intervals.increasing(lambda ball: ball.exp(), values)


_RULES: dict[Operation, Rule] = {
    Operation.ADD: _add,
    Operation.SUB: _sub,
    Operation.MUL: _mul,
    Operation.DIV: _div,
    Operation.NEG: _neg,
    Operation.ABS: _abs,
    Operation.SQRT: _sqrt,
    Operation.SIN: _wave(intervals.sine, intervals.cosine),
    Operation.COS: _wave(intervals.cosine, intervals.sine),
    Operation.OWN_SIN: _wave(intervals.sine, intervals.cosine),
    Operation.OWN_COS: _wave(intervals.cosine, intervals.sine),
    Operation.TAN: _tan,
    Operation.ASIN: _monotone(
        lambda ball: ball.asin(),
        lambda v: _reciprocal((intervals.ONE - v.square()).meet(Interval(0.0, 1.0)).sqrt()),
        intervals.SIGNED_UNIT,
    ),
    Operation.ACOS: _acos,
    Operation.ATAN: _monotone(
        lambda ball: ball.atan(), lambda v: _reciprocal(intervals.ONE + v.square())
    ),
    Operation.ATAN2: _atan2,
    Operation.EXP: _monotone(lambda ball: ball.exp(), _exponential),
    Operation.LOG: _monotone(lambda ball: ball.log(), _reciprocal, Interval(0.0, INFINITY)),
    Operation.FLOOR: _floor,
    Operation.MIN: _extreme(min),
    Operation.MAX: _extreme(max),
}
