"""Intervals enclose: judged with rational numbers and with many digits."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from symnav.export.rounding import intervals
from symnav.export.rounding.intervals import Empty, Interval, enclose, point

numbers = st.floats(-1e150, 1e150, allow_nan=False, allow_subnormal=True)


@st.composite
def ranges(draw: st.DrawFn, of: st.SearchStrategy[float] = numbers) -> Interval:
    ends = sorted((draw(of), draw(of)))
    return Interval(*ends)


def inside(draw: Callable[[st.SearchStrategy[int]], int], values: Interval) -> Fraction:
    share = Fraction(draw(st.integers(0, 8)), 8)
    return Fraction(values.lo) + share * (Fraction(values.hi) - Fraction(values.lo))


@settings(max_examples=100, deadline=None)
@given(st.data())
def test_arithmetic_encloses_every_exact_result(data: st.DataObject) -> None:
    a, b = data.draw(ranges()), data.draw(ranges())
    x, y = inside(data.draw, a), inside(data.draw, b)
    assert holds(a + b, x + y)
    assert holds(a - b, x - y)
    assert holds(a * b, x * y)
    assert holds(-a, -x)
    assert holds(a.square(), x * x)
    assert holds(intervals.magnitudes(a), abs(x))
    if y:
        assert holds(a / b, x / y)
    assert holds(a.hull(b), x) and holds(a.hull(b), y)
    if abs(x) < 1e30:
        assert holds(Interval(float(x), float(x)).hull(a).power(3), x**3)
        assert holds(a.power(4), x**4)


def holds(values: Interval, exact: Fraction) -> bool:
    above = math.isinf(values.lo) or Fraction(values.lo) <= exact
    return above and (math.isinf(values.hi) or exact <= Fraction(values.hi))


@settings(max_examples=100, deadline=None)
@given(st.floats(0.0, 1e300))
def test_square_roots_enclose(value: float) -> None:
    root = point(value).sqrt()
    assert Fraction(root.lo) ** 2 <= Fraction(value) <= Fraction(root.hi) ** 2


def test_exact_results_stay_sharp() -> None:
    assert point(0.1) + point(0.2) != point(0.1 + 0.2)
    assert point(1.0) + point(2.0) == point(3.0)
    assert point(0.1) * point(2.0) == point(0.2)
    assert point(0.3) / point(4.0) == point(0.075)
    assert point(0.1) * point(3.0) == Interval(
        math.nextafter(0.1 * 3, 0), math.nextafter(0.1 * 3, 1)
    )
    assert point(1.0).sqrt() == point(1.0)
    assert Interval(0.0, 2.0) + point(0.0) == Interval(0.0, 2.0)


def test_overflow_and_infinity() -> None:
    assert (point(1e308) + point(1e308)).hi == math.inf
    assert (point(1e308) + point(1e308)).lo < math.inf
    assert (point(1e200) * point(1e200)).lo == 1.7976931348623157e308
    assert point(0.0) * Interval(-math.inf, math.inf) == point(0.0)
    assert point(1.0) / Interval(-1.0, 1.0) == intervals.EVERYTHING
    assert (point(1.0) / Interval(0.0, 2.0)) == Interval(0.5, math.inf)


@settings(max_examples=100, deadline=None)
@given(st.data())
def test_waves_enclose(data: st.DataObject) -> None:
    values = data.draw(ranges(st.floats(-50.0, 50.0)))
    narrow = Interval(values.lo, min(values.hi, values.lo + data.draw(st.floats(0.0, 8.0))))
    x = inside(data.draw, narrow)
    with mp.workdps(40):
        exact = mp.mpf(x.numerator) / x.denominator
        for function, judge in ((intervals.sine, mp.sin), (intervals.cosine, mp.cos)):
            result = function(narrow)
            assert result.lo <= judge(exact) <= result.hi
            assert result.lo >= -1.0 and result.hi <= 1.0


def test_waves_are_sharp_at_their_extremes() -> None:
    assert intervals.sine(Interval(1.5, 1.6)).hi == 1.0
    assert intervals.sine(Interval(1.5, 1.6)).lo > 0.99
    assert intervals.sine(Interval(1.6, 1.7)).hi < 1.0
    assert intervals.cosine(Interval(3.0, 3.2)) == Interval(-1.0, intervals.cosine(point(3.0)).hi)
    assert intervals.cosine(Interval(-0.1, 0.2)).lo > 0.98
    assert intervals.sine(Interval(-1.6, -1.5)).lo == -1.0


@settings(max_examples=100, deadline=None)
@given(st.data())
def test_angles_enclose(data: st.DataObject) -> None:
    y, x = (data.draw(ranges(st.floats(-10.0, 10.0, allow_subnormal=False))) for _ in range(2))
    b, a = inside(data.draw, y), inside(data.draw, x)
    if a or b:
        with mp.workdps(40):
            exact = mp.atan2(
                mp.mpf(b.numerator) / b.denominator, mp.mpf(a.numerator) / a.denominator
            )
            result = intervals.arctangent(y, x)
            assert result.lo <= exact <= result.hi


def test_an_angle_away_from_the_cut_is_narrow() -> None:
    assert intervals.arctangent(Interval(0.1, 1.0), Interval(-1.0, 1.0)).lo > 0.09
    assert intervals.arctangent(Interval(-0.1, 0.1), Interval(-1.0, -0.5)) == intervals.HALF_TURN


def test_balls_are_enclosed_where_doubles_end() -> None:
    assert enclose(arb("1e400")) == Interval(1.7976931348623157e308, math.inf)
    assert enclose(arb("1e-400")) == Interval(0.0, 5e-324)
    assert enclose(arb(1) / 3).lo < 1 / 3 <= enclose(arb(1) / 3).hi


def test_nothing_in_common() -> None:
    with pytest.raises(Empty):
        Interval(0.0, 1.0).meet(Interval(2.0, 3.0))
    with pytest.raises(Empty):
        Interval(-2.0, -1.0).sqrt()


@settings(max_examples=100, deadline=None)
@given(st.data())
def test_distances_are_not_underestimated(data: st.DataObject) -> None:
    a, b = data.draw(ranges()), data.draw(ranges())
    x, y = inside(data.draw, a), inside(data.draw, b)
    assert abs(x - y) <= Fraction(a.farthest(b)) if math.isfinite(a.farthest(b)) else True


def test_lengths_are_not_underestimated() -> None:
    assert Fraction(intervals.length([0.1, 0.2, 0.3])) ** 2 >= sum(
        Fraction(v) ** 2 for v in (0.1, 0.2, 0.3)
    )
    assert intervals.length([3.0, 4.0]) == pytest.approx(5.0, rel=1e-15)
