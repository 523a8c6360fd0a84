"""What rounding to a type does: brute force over numbers of the type, and its sharpness."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from symnav import ir
from symnav.export.rounding.formats import FORMATS, Format
from symnav.export.rounding.intervals import Interval

FLOAT, DOUBLE = FORMATS[ir.Scalar.FLOAT], FORMATS[ir.Scalar.DOUBLE]


def test_no_rounding_to_float_moves_more() -> None:
    rng = np.random.default_rng(1)
    values = rng.choice([-1.0, 1.0], 200000) * 10.0 ** rng.uniform(-50.0, 38.0, 200000)
    moved = np.abs(values.astype(np.float32).astype(np.float64) - values)
    allowed = np.array([FLOAT.rounding(abs(v)) for v in values])
    assert np.all(moved <= allowed)
    assert np.max(moved / allowed) > 0.99


@pytest.mark.parametrize("exponent", [-140, -126, -3, 0, 30])
def test_half_way_reaches_the_bound(exponent: int) -> None:
    step = max(2.0 ** (exponent - 23), 2.0**-149)
    value = 2.0**exponent + step / 2.0
    moved = abs(float(np.float32(value)) - value)
    assert moved == FLOAT.rounding(value) == step / 2.0


def test_underflow_is_half_a_subnormal() -> None:
    assert float(np.float32(2.0**-150)) == 0.0
    assert FLOAT.rounding(2.0**-150) == 2.0**-150
    product = Fraction(1, 2**1075)  # between zero and the smallest double
    assert Fraction(DOUBLE.rounding(5e-324)) >= product


def test_double_half_way() -> None:
    value = Fraction(1) + Fraction(1, 2**53)
    assert abs(Fraction(float(value)) - value) == Fraction(DOUBLE.rounding(1.0))


def test_beyond_the_largest_there_is_no_bound() -> None:
    assert FLOAT.rounding(3.5e38) == float("inf")
    assert FLOAT.rounded(Interval(0.0, 1e39)).hi == float("inf")


def test_rounded_ranges_hold_rounded_numbers() -> None:
    rng = np.random.default_rng(2)
    for value in rng.choice([-1.0, 1.0], 5000) * 10.0 ** rng.uniform(-46.0, 38.0, 5000):
        held = FLOAT.rounded(Interval(value, value))
        assert held.lo <= float(np.float32(value)) <= held.hi
        assert float(np.float32(held.lo)) == held.lo and float(np.float32(held.hi)) == held.hi
    assert FLOAT.rounded(Interval(-1e-60, 1e-60)) == Interval(-(2.0**-149), 2.0**-149)


@pytest.mark.parametrize("kind", [FLOAT, DOUBLE])
def test_a_library_function_may_miss_by_one_unit(kind: Format) -> None:
    assert kind.library(1.0) == 2.0 ** (1 - kind.bits)
