"""How errors go through operations: from the operands' numbers to the result's.

For every operation the exact result on the computed operands is enclosed first (``moved`` is how
far it may be from the exact result on the exact operands), then rounded to the type.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

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
    down_sum,
    magnitudes,
    point,
    up_product,
    up_quotient,
    up_sqrt,
    up_sum,
)
from symnav.export.rounding.model import Number

Rule = Callable[[Sequence[Number], Format], Number]


def literal(value: float, kind: Format) -> Number:
    """A constant: rounded to the type once."""
    held = kind.literal(value)
    error = up_sum(abs(held - value), 0.0)
    return Number(point(value), point(held), error, error)


def element(values: Interval, kind: Format) -> Number:
    """An input: what the caller passes is what is meant."""
    held = values.hull(Interval(kind.literal(values.lo), kind.literal(values.hi)))
    return Number(held, held, 0.0, 0.0)


def apply(operation: Operation, operands: Sequence[Number], kind: Format) -> Number:
    """The result of an operation that is neither a condition nor a choice.

    A bound that is infinite stays infinite, whatever the operation: it may stand for a result that
    is not a number.
    """
    result = _RULES[operation](operands, kind)
    if any(operand.error == INFINITY for operand in operands):
        return Number(result.real, EVERYTHING, INFINITY, INFINITY)
    return result


def _rounded(
    real: Interval, exact: Interval, moved: float, kind: Format, turned: float | None = None
) -> Number:
    """A correctly rounded result."""
    return _off_by(real, exact, moved, kind.rounding(exact.magnitude), kind, turned)


def _off_by(
    real: Interval,
    exact: Interval,
    moved: float,
    rounding: float,
    kind: Format,
    turned: float | None = None,
) -> Number:
    if not exact.magnitude <= kind.largest:
        return Number(real, EVERYTHING, INFINITY, INFINITY)
    error = up_sum(moved, rounding)
    shifted = error if turned is None else up_sum(turned, rounding)
    return Number(real, kind.rounded(exact), error, shifted)


def _add(operands: Sequence[Number], kind: Format) -> Number:
    a, b = operands
    real, exact = a.real + b.real, a.computed + b.computed
    return _rounded(real, exact, up_sum(a.error, b.error), kind, up_sum(a.turned, b.turned))


def _sub(operands: Sequence[Number], kind: Format) -> Number:
    a, b = operands
    return _add((a, _negated(b)), kind)


def _negated(a: Number) -> Number:
    return Number(-a.real, -a.computed, a.error, a.turned)


def _mul(operands: Sequence[Number], kind: Format) -> Number:
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
    if _is_power_of_two(a) or _is_power_of_two(b):
        rounding = kind.tiny if exact.magnitude <= kind.largest else INFINITY
        return _off_by(real, exact, moved, rounding, kind, turned)
    return _rounded(real, exact, moved, kind, turned)


def _multiplied(a: Number, factor: Number) -> float:
    """What is left of whole turns after an integer multiple."""
    exact = factor.real == factor.computed and factor.real.is_point
    if exact and factor.real.lo.is_integer():
        return up_product(factor.real.magnitude, a.turned)
    return INFINITY


def _is_power_of_two(a: Number) -> bool:
    values = a.computed
    return values.is_point and values.lo != 0.0 and abs(math.frexp(values.lo)[0]) == 0.5


def _div(operands: Sequence[Number], kind: Format) -> Number:
    a, b = operands
    real, exact = a.real / b.real, a.computed / b.computed
    moved = min(
        _quotient_moved(a.error, b.error, real, b.computed),
        _quotient_moved(a.error, b.error, exact, b.real),
    )
    return _rounded(real, exact, moved, kind)


def _quotient_moved(a_error: float, b_error: float, quotient: Interval, divisor: Interval) -> float:
    """|a'/b' - a/b| <= (|a' - a| + |a/b| |b' - b|) / |b'|, and the same with the primes swapped."""
    if divisor.mignitude == 0.0:
        return INFINITY
    shifted = up_sum(a_error, up_product(quotient.magnitude, b_error))
    return up_quotient(shifted, divisor.mignitude)


def _neg(operands: Sequence[Number], kind: Format) -> Number:
    return _negated(operands[0])


def _abs(operands: Sequence[Number], kind: Format) -> Number:
    (a,) = operands
    return Number(magnitudes(a.real), magnitudes(a.computed), a.error, a.error)


def _sqrt(operands: Sequence[Number], kind: Format) -> Number:
    (a,) = operands
    if a.computed.lo < 0.0:
        # The graph does not rule out a negative number under the root: no bound.
        return Number(a.real.sqrt(), EVERYTHING, INFINITY, INFINITY)
    real, exact = a.real.sqrt(), a.computed.sqrt()
    # |sqrt a' - sqrt a| = |a' - a| / (sqrt a' + sqrt a) <= sqrt |a' - a|
    lowest = down_sum(real.lo, exact.lo)
    moved = up_sqrt(a.error)
    if lowest > 0.0:
        moved = min(moved, up_quotient(a.error, lowest))
    return _rounded(real, exact, moved, kind)


def _library(
    real: Interval, exact: Interval, moved: float, kind: Format, reach: Interval
) -> Number:
    """A function of the library: within its bound of the exact value, and inside its reach."""
    rounding = kind.library(exact.magnitude)
    computed = exact.widened(rounding)
    error = up_sum(moved, rounding)
    return Number(real.meet(reach), computed, error, error)


def _wave(function: Callable[[Interval], Interval], slope: Callable[[Interval], Interval]) -> Rule:
    """Sine and cosine: nowhere steeper than 1, and blind to whole turns."""

    def rule(operands: Sequence[Number], kind: Format) -> Number:
        (a,) = operands
        real, exact = function(a.real), function(a.computed)
        steepest = slope(a.real.hull(a.computed)).magnitude
        moved = min(up_product(steepest, a.error), a.turned, 2.0)
        return _library(real, exact, moved, kind, intervals.SIGNED_UNIT)

    return rule


def _monotone(
    function: Callable[[arb], arb],
    steepness: Callable[[Interval], Interval],
    defined: Interval = EVERYTHING,
) -> Rule:
    """Increasing functions, by the mean value theorem."""

    def rule(operands: Sequence[Number], kind: Format) -> Number:
        (a,) = operands
        if not (defined.lo <= a.computed.lo and a.computed.hi <= defined.hi):
            return Number(EVERYTHING, EVERYTHING, INFINITY, INFINITY)
        real = intervals.increasing(function, a.real.meet(defined))
        exact = intervals.increasing(function, a.computed)
        moved = up_product(steepness(a.real.hull(a.computed)).magnitude, a.error)
        return _library(real, exact, moved, kind, EVERYTHING)

    return rule


def _tan(operands: Sequence[Number], kind: Format) -> Number:
    (a,) = operands
    around = a.real.hull(a.computed)
    if intervals.cosine(around).mignitude == 0.0:
        return Number(EVERYTHING, EVERYTHING, INFINITY, INFINITY)
    rule = _monotone(lambda ball: ball.tan(), lambda v: _reciprocal(intervals.cosine(v).square()))
    return rule(operands, kind)


def _reciprocal(values: Interval) -> Interval:
    """Reciprocals."""
    return intervals.ONE / values


def _acos(operands: Sequence[Number], kind: Format) -> Number:
    (a,) = operands
    turned = _RULES[Operation.ASIN]((_negated(a),), kind)
    quarter = Interval(PI.lo / 2.0, PI.hi / 2.0)
    real, exact = turned.real + quarter, turned.computed + quarter
    error = up_sum(turned.error, kind.library(exact.magnitude))
    return Number(real, exact.widened(kind.library(exact.magnitude)), error, error)


def _atan2(operands: Sequence[Number], kind: Format) -> Number:
    y, x = operands
    return angle(y, x, 0.0, kind)


def angle(y: Number, x: Number, radius: float, kind: Format) -> Number:
    """The angle of a point: it moves by at most an arc over the distance from the origin.

    Args:
        y: ordinate.
        x: abscissa.
        radius: least distance of the exact point from the origin, as far as it is known.
        kind: the type.
    """
    real, exact = intervals.arctangent(y.real, x.real), intervals.arctangent(y.computed, x.computed)
    shift = intervals.length((y.error, x.error))
    around_y, around_x = y.real.hull(y.computed), x.real.hull(x.computed)
    nearest = (magnitudes(around_y).square() + magnitudes(around_x).square()).sqrt().lo
    nearest = max(nearest, radius)
    # From a point r away from the origin everything within d of it is seen within asin(d / r),
    # which is at most pi/2 d / r.
    turned = PI.hi
    if shift < nearest:
        turned = up_product(above(PI.hi / 2.0), up_quotient(shift, nearest))
    on_cut = around_x.lo <= 0.0 and around_y.lo <= 0.0 <= around_y.hi
    moved = up_sum(2.0 * PI.hi, 0.0) if on_cut else turned
    moved = min(moved, real.farthest(exact))
    rounding = kind.library(exact.magnitude)
    result = _library(real, exact, moved, kind, EVERYTHING)
    return Number(result.real, result.computed, result.error, up_sum(turned, rounding))


def _floor(operands: Sequence[Number], kind: Format) -> Number:
    (a,) = operands
    real, computed = a.real.floor(), a.computed.floor()
    moved = 0.0 if real == computed and real.is_point else above(a.error + 1.0)
    return Number(real, computed, moved, moved)


def _extreme(pick: Callable[[float, float], float]) -> Rule:
    """The smaller or the larger of two: moves no more than either of them."""

    def rule(operands: Sequence[Number], kind: Format) -> Number:
        a, b = operands
        values = [
            Interval(pick(p.lo, q.lo), pick(p.hi, q.hi))
            for p, q in ((a.real, b.real), (a.computed, b.computed))
        ]
        error = max(a.error, b.error)
        return Number(values[0], values[1], error, error)

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
