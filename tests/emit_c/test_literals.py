"""Numbers as C literals: exact, nearest or inwards, and never of the other type."""

from __future__ import annotations

import math
import struct

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from symnav import errors, ir
from symnav.emit.c.literals import bounds, declared, integer_bounds, literal

DOUBLE, FLOAT = ir.Scalar.DOUBLE, ir.Scalar.FLOAT
LARGEST = float(np.finfo(np.float32).max)


@pytest.mark.parametrize(
    ("value", "double", "single"),
    [
        (0.0, "0.0", "0.0F"),
        (-0.0, "-0.0", "-0.0F"),
        (2.0, "2.0", "2.0F"),
        (0.1, "0.1", "0.1F"),
        (1 / 3, "0.3333333333333333", "0.33333334F"),
        (1e22, "1.0e+22", "1.0e+22F"),
        (-1.5e-7, "-1.5e-07", "-1.5e-07F"),
        (6378137.0, "6378137.0", "6378137.0F"),
        (100000.0, "100000.0", "100000.0F"),
        (16777217.0, "16777217.0", "16777216.0F"),
    ],
)
def test_examples(value: float, double: str, single: str) -> None:
    """As a person would write them."""
    assert literal(value, DOUBLE) == double
    assert literal(value, FLOAT) == single


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_double_reads_back(value: float) -> None:
    """The same bits, sign of zero included."""
    text = literal(value, DOUBLE)
    assert struct.pack("<d", float(text)) == struct.pack("<d", value)
    assert "." in text


@given(st.floats(min_value=-LARGEST, max_value=LARGEST))
def test_float_is_nearest(value: float) -> None:
    """The literal reads as the float nearest to the number."""
    text = literal(value, FLOAT)
    assert text.endswith("F") and "." in text
    assert np.float32(text[:-1]).tobytes() == np.float32(value).tobytes()


@given(st.floats(allow_nan=False), st.floats(allow_nan=False), st.sampled_from(ir.Scalar))
def test_bounds_are_inside(one: float, other: float, scalar: ir.Scalar) -> None:
    """A range never grows, is never infinite, and shrinks by no more than one number."""
    lower, upper = min(one, other), max(one, other)
    assume(lower <= LARGEST and upper >= -LARGEST)
    real = np.float64 if scalar is DOUBLE else np.float32
    low, high = (real(text.removesuffix("F")) for text in bounds(lower, upper, scalar))
    assert np.isfinite(low) and np.isfinite(high) and low <= high
    if float(low) != float(high):
        assert lower <= float(low) and float(high) <= upper
        assert lower <= -LARGEST or not float(np.nextafter(low, real(-np.inf))) >= lower
        assert upper >= LARGEST or not float(np.nextafter(high, real(np.inf))) <= upper


@given(st.floats(allow_nan=False), st.floats(allow_nan=False), st.sampled_from(ir.Scalar))
def test_declared_ends_are_nearest(one: float, other: float, scalar: ir.Scalar) -> None:
    """What a caller has who writes an end in the type is inside; zero only where zero was meant."""
    lower, upper = min(one, other), max(one, other)
    real = np.float64 if scalar is DOUBLE else np.float32
    ends = [real(text.removesuffix("F")) for text in declared(lower, upper, scalar)]
    largest = float(np.finfo(real).max)
    for got, end in zip(ends, (lower, upper), strict=True):
        meant = real(min(max(end, -largest), largest))
        if meant == 0.0 != end:
            meant = np.copysign(np.finfo(real).smallest_subnormal, end)
        assert got == meant
        assert np.sign(got) == np.sign(end)


def test_declared_ends_as_users_write_them() -> None:
    """A period of 0.05 s, which rounded inwards would refuse 0.05F; and no end is infinite."""
    assert declared(1e-5, 0.05, FLOAT) == ("1.0e-05F", "0.05F")
    assert declared(-0.1, 0.1, FLOAT) == ("-0.1F", "0.1F")
    assert declared(1e-60, 1.0, FLOAT)[0] == literal(2.0**-149, FLOAT)
    assert declared(-math.inf, math.inf, FLOAT) == bounds(-math.inf, math.inf, FLOAT)


def test_range_between_two_floats() -> None:
    """It holds no float, so the nearest one stands for it."""
    assert bounds(0.1, 0.1, FLOAT) == ("0.1F", "0.1F")
    assert bounds(0.1, 0.1, DOUBLE) == ("0.1", "0.1")


def test_infinite_bounds() -> None:
    """The largest finite number is the end of an open range."""
    assert bounds(-math.inf, math.inf, DOUBLE) == (
        "-1.7976931348623157e+308",
        "1.7976931348623157e+308",
    )
    low, high = bounds(-math.inf, math.inf, FLOAT)
    assert np.float32(high[:-1]) == np.finfo(np.float32).max == -np.float32(low[:-1])


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("scalar", list(ir.Scalar))
def test_no_literal_for_what_is_not_finite(value: float, scalar: ir.Scalar) -> None:
    """It is refused by name."""
    with pytest.raises(errors.InputError, match="not finite"):
        literal(value, scalar)


def test_too_large_for_a_float() -> None:
    """It is refused with the remedy."""
    with pytest.raises(errors.InputError, match=r"1e\+300 does not fit .* in double"):
        literal(1e300, FLOAT)


@pytest.mark.parametrize(
    ("lower", "upper", "expected"),
    [
        (0.0, 3.0, ("0", "3")),
        (-0.5, 2.9, ("0", "2")),
        (-math.inf, math.inf, ("-2147483647", "2147483647")),
    ],
)
def test_integer_bounds(lower: float, upper: float, expected: tuple[str, str]) -> None:
    """Inwards, and inside int32_t."""
    assert integer_bounds(lower, upper) == expected
