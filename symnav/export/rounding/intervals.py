"""Closed intervals of real numbers, rounded outwards.

Sums, products, quotients and square roots are IEEE double operations whose ends are moved outwards
unless the operation is known to have been exact; elementary functions are enclosed with the balls
of Arb (python-flint). An end may be infinite.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from flint import arb

INFINITY = math.inf


class Empty(Exception):
    """An intersection is empty: what was assumed cannot happen."""


@dataclass(frozen=True, slots=True)
class Interval:
    """Every real number from ``lo`` to ``hi``."""

    lo: float
    hi: float

    @property
    def magnitude(self) -> float:
        """The largest absolute value."""
        return max(-self.lo, self.hi)

    @property
    def mignitude(self) -> float:
        """The smallest absolute value."""
        return max(self.lo, -self.hi, 0.0)

    @property
    def is_point(self) -> bool:
        """True for a single number."""
        return self.lo == self.hi

    def __contains__(self, value: float) -> bool:
        return self.lo <= value <= self.hi

    def __neg__(self) -> Interval:
        return Interval(-self.hi, -self.lo)

    def __add__(self, other: Interval) -> Interval:
        return Interval(down_sum(self.lo, other.lo), up_sum(self.hi, other.hi))

    def __sub__(self, other: Interval) -> Interval:
        return Interval(down_sum(self.lo, -other.hi), up_sum(self.hi, -other.lo))

    def __mul__(self, other: Interval) -> Interval:
        pairs = [(a, b) for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        return Interval(
            min(down_product(a, b) for a, b in pairs), max(up_product(a, b) for a, b in pairs)
        )

    def __truediv__(self, other: Interval) -> Interval:
        if other.lo <= 0.0 <= other.hi:
            return self._by_zero(other)
        pairs = [(a, b) for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        return Interval(
            min(down_quotient(a, b) for a, b in pairs), max(up_quotient(a, b) for a, b in pairs)
        )

    def _by_zero(self, other: Interval) -> Interval:
        """A quotient whose divisor may come as near to zero as it likes from one side."""
        if self.lo >= 0.0 and other.lo == 0.0 and other.hi > 0.0:
            return Interval(down_quotient(self.lo, other.hi), INFINITY)
        return EVERYTHING

    def square(self) -> Interval:
        """The squares: never negative."""
        low, high = self.mignitude, self.magnitude
        return Interval(max(down_product(low, low), 0.0), up_product(high, high))

    def power(self, exponent: int) -> Interval:
        """A positive integer power."""
        result = self.square() if exponent >= 2 else self
        for _ in range(exponent - 2):
            result = result * (self if exponent % 2 else magnitudes(self))
        return result

    def sqrt(self) -> Interval:
        """Square roots of what is not negative.

        Raises:
            Empty: when everything is negative.
        """
        if self.hi < 0.0:
            raise Empty
        return Interval(down_sqrt(max(self.lo, 0.0)), up_sqrt(self.hi))

    def floor(self) -> Interval:
        """Largest integers that are not above."""
        low = self.lo if math.isinf(self.lo) else float(math.floor(self.lo))
        high = self.hi if math.isinf(self.hi) else float(math.floor(self.hi))
        return Interval(low, high)

    def meet(self, other: Interval) -> Interval:
        """What both hold.

        Raises:
            Empty: when they have nothing in common.
        """
        low, high = max(self.lo, other.lo), min(self.hi, other.hi)
        if not low <= high:
            raise Empty
        return Interval(low, high)

    def hull(self, other: Interval) -> Interval:
        """The smallest interval that holds both."""
        return Interval(min(self.lo, other.lo), max(self.hi, other.hi))

    def widened(self, margin: float) -> Interval:
        """Everything within ``margin`` of it."""
        return Interval(down_sum(self.lo, -margin), up_sum(self.hi, margin))

    def farthest(self, other: Interval) -> float:
        """Upper bound on the distance of a number of this from a number of the other."""
        return max(up_sum(self.hi, -other.lo), up_sum(other.hi, -self.lo), 0.0)


EVERYTHING = Interval(-INFINITY, INFINITY)
ZERO = Interval(0.0, 0.0)
ONE = Interval(1.0, 1.0)
SIGNED_UNIT = Interval(-1.0, 1.0)


def point(value: float) -> Interval:
    """A single number."""
    return Interval(value, value)


def centred(bound: float) -> Interval:
    """Everything up to a magnitude."""
    return Interval(-bound, bound)


def magnitudes(values: Interval) -> Interval:
    """The absolute values."""
    return Interval(values.mignitude, values.magnitude)


def below(value: float) -> float:
    """The next double towards minus infinity."""
    return math.nextafter(value, -INFINITY)


def above(value: float) -> float:
    """The next double towards infinity."""
    return math.nextafter(value, INFINITY)


def down_sum(a: float, b: float) -> float:
    """Lower bound on a sum, sharp where the sum is exact."""
    total = a + b
    if math.isnan(total):
        return -INFINITY
    if math.isinf(total):
        return total if total < 0.0 or math.isinf(a) or math.isinf(b) else below(total)
    if abs(total) > 1e300:  # what was lost might not be computable
        return below(total)
    return below(total) if _lost(a, b, total) < 0.0 else total


def up_sum(a: float, b: float) -> float:
    """Upper bound on a sum, sharp where the sum is exact."""
    return -down_sum(-a, -b)


def _lost(a: float, b: float, total: float) -> float:
    """What the rounding of a sum of finite doubles left out: exact."""
    virtual = total - a
    return (a - (total - virtual)) + (b - virtual)


def down_product(a: float, b: float) -> float:
    """Lower bound on a product; zero times infinity is zero, as at the end of an interval."""
    if a == 0.0 or b == 0.0:
        return 0.0
    product = a * b
    if math.isinf(a) or math.isinf(b) or _scales(a, b, product):
        return product
    return below(product)


def up_product(a: float, b: float) -> float:
    """Upper bound on a product."""
    return -down_product(-a, b)


def _scales(a: float, b: float, product: float) -> bool:
    """True where one factor is a power of two and nothing over- or underflows."""
    exact = abs(math.frexp(a)[0]) == 0.5 or abs(math.frexp(b)[0]) == 0.5
    return exact and 1e-300 < abs(product) < INFINITY


def down_quotient(a: float, b: float) -> float:
    """Lower bound on a quotient by something that is not zero."""
    if a == 0.0 or math.isinf(b):
        return 0.0 if not math.isinf(a) else -INFINITY
    quotient = a / b
    if math.isinf(a):
        return quotient
    exact = abs(math.frexp(b)[0]) == 0.5 and 1e-300 < abs(quotient) < INFINITY
    return quotient if exact or a == b else below(quotient)


def up_quotient(a: float, b: float) -> float:
    """Upper bound on a quotient by something that is not zero."""
    return -down_quotient(-a, b)


def down_sqrt(value: float) -> float:
    """Lower bound on a square root."""
    return value if value in (0.0, 1.0, INFINITY) else below(math.sqrt(value))


def up_sqrt(value: float) -> float:
    """Upper bound on a square root."""
    return value if value in (0.0, 1.0, INFINITY) else above(math.sqrt(value))


def total(values: Iterable[float]) -> float:
    """Upper bound on a sum."""
    result = 0.0
    for value in values:
        result = up_sum(result, value)
    return result


def length(values: Iterable[float]) -> float:
    """Upper bound on the Euclidean norm."""
    return up_sqrt(total(up_product(value, value) for value in values))


def enclose(ball: arb) -> Interval:
    """The doubles around a ball of Arb."""
    if not ball.is_finite():
        return EVERYTHING
    low, high = ball.lower(), ball.upper()
    least, most = float(low), float(high)
    while arb(least) > low:
        least = below(least)
    while arb(most) < high:
        most = above(most)
    return Interval(least, most)


def increasing(function: Callable[[arb], arb], values: Interval) -> Interval:
    """Values of an increasing function."""
    return Interval(enclose(function(arb(values.lo))).lo, enclose(function(arb(values.hi))).hi)


def sine(values: Interval) -> Interval:
    """Sines."""
    return _wave(values, lambda ball: ball.sin(), -0.5)


def cosine(values: Interval) -> Interval:
    """Cosines."""
    return _wave(values, lambda ball: ball.cos(), 0.0)


def _wave(values: Interval, function: Callable[[arb], arb], crest: float) -> Interval:
    """A wave of period 2 pi that is largest at ``-crest * pi`` and smallest half a turn away."""
    if math.isinf(values.magnitude):
        return SIGNED_UNIT
    ends = [enclose(function(arb(end))) for end in (values.lo, values.hi)]
    result = ends[0].hull(ends[1])
    if _passes(values, crest):
        result = Interval(result.lo, 1.0)
    if _passes(values, crest + 1.0):
        result = Interval(-1.0, result.hi)
    return result.meet(SIGNED_UNIT)


def _passes(values: Interval, half_turns: float) -> bool:
    """False only where no ``(2 k - half_turns) pi`` lies between the ends."""
    turns = [enclose((arb(end) / arb.pi() + half_turns) / 2) for end in (values.lo, values.hi)]
    return math.floor(turns[1].hi) >= math.ceil(turns[0].lo)


def arctangent(y: Interval, x: Interval) -> Interval:
    """Angles of the points of a box, in (-pi, pi]."""
    if x.lo <= 0.0 and y.lo <= 0.0 <= y.hi:
        return HALF_TURN
    corners = [enclose(arb.atan2(arb(b), arb(a))) for a in (x.lo, x.hi) for b in (y.lo, y.hi)]
    return Interval(min(c.lo for c in corners), max(c.hi for c in corners))


PI = enclose(arb.pi())
HALF_TURN = centred(PI.hi)
