"""Mathematical functions rounded correctly: the number of the type nearest to the true value.

What a C library returns for ``sin`` differs from library to library by a unit in the last place.
The golden vectors need one answer that does not depend on the machine that makes them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from symnav import ir

Real = NDArray[Any]
Operation = ir.Operation

#: Digits in binary of a first try; doubled as long as the rounding is in doubt.
BITS = 160

_UNARY: Mapping[Operation, Callable[..., Any]] = {
    Operation.SIN: mp.sin,
    Operation.COS: mp.cos,
    Operation.TAN: mp.tan,
    Operation.ASIN: mp.asin,
    Operation.ACOS: mp.acos,
    Operation.ATAN: mp.atan,
    Operation.EXP: mp.exp,
    Operation.LOG: mp.log,
}
_ODD = frozenset({Operation.SIN, Operation.TAN, Operation.ASIN, Operation.ATAN})

LIBRARY = frozenset((*_UNARY, Operation.ATAN2))
"""Operations whose result depends on the C library."""


def library(operation: Operation, operands: list[Real]) -> Real:
    """One of ``LIBRARY`` on arrays of one type, element by element.

    Args:
        operation: which.
        operands: one array, or two for ``ATAN2`` (y first).
    """
    shape = np.broadcast_shapes(*(operand.shape for operand in operands))
    kind = operands[0].dtype
    flat = [np.broadcast_to(operand, shape).ravel() for operand in operands]
    found = [_one(operation, [float(a[k]) for a in flat], kind) for k in range(flat[0].size)]
    return np.array(found, dtype=kind).reshape(shape)


def nearest(value: Fraction, kind: Any) -> float:
    """The number of a floating-point type nearest to a rational one, ties to even."""
    if value == 0:
        return 0.0
    info = np.finfo(kind)
    digits, lowest = int(info.nmant), int(info.minexp)
    size = abs(value)
    exponent = size.numerator.bit_length() - size.denominator.bit_length()
    if size < Fraction(2) ** exponent:
        exponent -= 1
    unit = Fraction(2) ** (max(exponent, lowest) - digits)
    rounded = round(value / unit) * unit
    return math.copysign(math.inf, value) if abs(rounded) > float(info.max) else float(rounded)


def _one(operation: Operation, operands: list[float], kind: Any) -> float:
    if any(math.isnan(x) for x in operands):
        return math.nan
    if operation is Operation.ATAN2:
        y, x = operands
        return _atan2(y, x, kind)
    (x,) = operands
    special = _special(operation, x)
    if special is not None:
        return special
    return _rounded(_UNARY[operation], operands, kind)


def _special(operation: Operation, x: float) -> float | None:
    """What C says about zeros, infinities and operands outside the domain."""
    if operation in _ODD and x == 0.0:
        return x
    if operation in (Operation.ASIN, Operation.ACOS) and abs(x) > 1.0:
        return math.nan
    if operation is Operation.LOG and x <= 0.0:
        return -math.inf if x == 0.0 else math.nan
    if math.isinf(x) and operation is not Operation.ATAN:
        if operation in (Operation.EXP, Operation.LOG):
            return 0.0 if x < 0.0 else x
        return math.nan
    return None


def _atan2(y: float, x: float, kind: Any) -> float:
    """Finite operands go through the angle itself; a zero y keeps its sign."""
    if y == 0.0 and math.copysign(1.0, x) > 0.0:
        return y
    turned = _rounded(lambda a, b: mp.atan2(a, b), [abs(y), x], kind)
    return math.copysign(turned if y != 0.0 else _rounded(lambda: mp.pi, [], kind), y)


def _rounded(function: Callable[..., Any], operands: list[float], kind: Any) -> float:
    """Both ends of an enclosure must round to the same number."""
    bits = BITS
    while True:
        with mp.workprec(bits):
            value = +function(*(mp.mpf(x) for x in operands))
            exact = _fraction(value)
        reach = abs(exact) / 2 ** (bits - 8)
        low, high = nearest(exact - reach, kind), nearest(exact + reach, kind)
        if low == high or bits > 64 * BITS:
            return nearest(exact, kind)
        bits *= 2


def _fraction(value: Any) -> Fraction:
    """A finite number of many digits as the rational number it is."""
    sign, mantissa, exponent, _ = value._mpf_
    size = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -size if sign else size
