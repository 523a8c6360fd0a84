"""Numbers as C literals, exact in the type they are written for."""

from __future__ import annotations

import math

from symnav import errors, ir, single

_DOUBLE_MAX = 1.7976931348623157e308


def literal(value: float, scalar: ir.Scalar) -> str:
    """The shortest literal that reads back as the number nearest to ``value``.

    Args:
        value: a finite number.
        scalar: the type of the literal; a float literal carries the suffix ``F``.

    Raises:
        InputError: when the number is not finite or does not fit the type.
    """
    if not math.isfinite(value):
        raise errors.InputError(f"the constant {value} is not finite; C has no literal for it")
    if scalar is ir.Scalar.DOUBLE:
        return _with_point(repr(float(value)))
    nearest = _to_float(value)
    texts = (f"{nearest:.{digits}g}" for digits in range(1, 10))
    shortest = next(text for text in texts if _reads_as(text, nearest))
    return _with_point(_plain(shortest)) + "F"


def declared(lower: float, upper: float, scalar: ir.Scalar) -> tuple[str, str]:
    """Literals of the range of an input: its ends are the numbers nearest to what was declared.

    They are what a caller has who writes the same number in the type, so that the ends themselves
    are inside. An infinite end becomes the largest finite number; an end that is not zero keeps its
    sign, so that a range that leaves zero out never admits it.
    """
    low, high = declared_ends(lower, upper, scalar)
    return literal(low, scalar), literal(high, scalar)


def declared_ends(lower: float, upper: float, scalar: ir.Scalar) -> tuple[float, float]:
    """The numbers that ``declared`` writes."""
    return _nearest(lower, scalar), _nearest(upper, scalar)


def bounds(lower: float, upper: float, scalar: ir.Scalar) -> tuple[str, str]:
    """Literals of a guard's range, rounded inwards where the type cannot hold an end exactly.

    What passes is inside the range that the mathematics needs. An infinite end becomes the largest
    finite number, so that a range never admits infinity. A range too narrow to hold any number of
    the type becomes the one number nearest to it.
    """
    if scalar is ir.Scalar.DOUBLE:
        low, high = max(lower, -_DOUBLE_MAX), min(upper, _DOUBLE_MAX)
    else:
        low, high = single.not_below(lower), single.not_above(upper)
        if low > high:
            low = high = _to_float(0.5 * (lower + upper))
    return literal(low, scalar), literal(high, scalar)


def integer_bounds(lower: float, upper: float) -> tuple[str, str]:
    """Literals of a closed range of ``int32_t``, rounded inwards."""
    low = max(math.ceil(max(lower, -2147483647.0)), -2147483647)
    high = min(math.floor(min(upper, 2147483647.0)), 2147483647)
    return str(low), str(high)


def _nearest(end: float, scalar: ir.Scalar) -> float:
    """The finite number of the type nearest to an end, zero only for zero."""
    if scalar is ir.Scalar.DOUBLE:
        return min(max(end, -_DOUBLE_MAX), _DOUBLE_MAX)
    nearest = single.nearest(min(max(end, -single.LARGEST), single.LARGEST))
    return single.neighbour(0.0, upwards=end > 0.0) if nearest == 0.0 != end else nearest


def _to_float(value: float) -> float:
    try:
        return single.nearest(value)
    except OverflowError:
        raise errors.InputError(
            f"the constant {value!r} does not fit a 32-bit float; generate this function in double"
        ) from None


def _reads_as(text: str, nearest: float) -> bool:
    try:
        return _to_float(float(text)) == nearest
    except errors.InputError:  # rounded up, past the largest float
        return False


def _plain(text: str) -> str:
    """``1e+05`` as ``100000``: powers of ten that read better written out."""
    value = float(text)
    if "e" in text and 1e-4 <= abs(value) < 1e8 and value == int(value):
        return str(int(value))
    return text


def _with_point(text: str) -> str:
    """``1e+22`` as ``1.0e+22`` and ``3`` as ``3.0``: a digit on both sides of a point."""
    mantissa, mark, exponent = text.partition("e")
    if "." not in mantissa:
        mantissa += ".0"
    return mantissa + mark + exponent
