"""What a floating-point type does to the exact result of an operation.

The model: rounding to nearest, gradual underflow, so that

    |fl(v) - v| <= half the spacing of the numbers of the type around v

which is at most u |v| where v is not tiny, and half the smallest number of the type where it is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from symnav import ir, single
from symnav.export.rounding.intervals import (
    EVERYTHING,
    INFINITY,
    Interval,
    up_product,
)


@dataclass(frozen=True, slots=True)
class Format:
    """A binary floating-point type.

    Attributes:
        bits: of the significand, the hidden one included.
        largest: finite number.
        tiny: upper bound on half the spacing of its subnormal numbers.
        ulps: bound on the error of a library function, in units of the last place of its result.
    """

    bits: int
    largest: float
    tiny: float
    ulps: float = 1.0

    @property
    def smallest(self) -> float:
        """Every number of at least this magnitude has all its bits."""
        return math.ldexp(self.tiny, self.bits)

    def rounding(self, magnitude: float) -> float:
        """Most that rounding moves a number up to this magnitude."""
        if magnitude == 0.0:
            return 0.0
        if not magnitude <= self.largest:
            return INFINITY
        exponent = math.frexp(magnitude)[1] - 1
        return max(math.ldexp(1.0, exponent - self.bits), self.tiny)

    def library(self, magnitude: float) -> float:
        """Most that a library function errs where its value is up to this magnitude."""
        return up_product(2.0 * self.ulps, self.rounding(magnitude))

    def rounded(self, values: Interval) -> Interval:
        """Everything that exact results become when they are rounded: rounding is monotone."""
        if values.magnitude > self.largest:
            return EVERYTHING
        return Interval(-self._up(-values.lo), self._up(values.hi))

    def literal(self, value: float) -> float:
        """The number of the type that a literal is read as."""
        return value if self.bits == 53 else single.nearest(value)

    def _up(self, value: float) -> float:
        """A number of the type that is not below ``value``, the least one but for one step."""
        if self.bits == 53:
            return value
        return single.not_below(value)


FORMATS = {
    ir.Scalar.FLOAT: Format(24, single.LARGEST, 2.0**-150),
    ir.Scalar.DOUBLE: Format(53, 1.7976931348623157e308, 2.0**-1074),
}
