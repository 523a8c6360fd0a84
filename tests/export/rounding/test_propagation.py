"""Every operation's rule against brute force: errors of operands and of rounding together.

Exact operands are drawn from an interval, computed operands within their errors of them; the
operation is rounded to float from doubles. What comes out must be within the bound and inside both
enclosures.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from symnav import ir
from symnav.export.rounding import propagation
from symnav.export.rounding.formats import FORMATS
from symnav.export.rounding.intervals import INFINITY, Interval
from symnav.export.rounding.model import Number

Op = ir.Operation
FLOAT = FORMATS[ir.Scalar.FLOAT]

BINARY: dict[Op, Callable[..., float]] = {
    Op.ADD: np.add,
    Op.SUB: np.subtract,
    Op.MUL: np.multiply,
    Op.DIV: np.divide,
    Op.ATAN2: np.arctan2,
    Op.MIN: np.minimum,
    Op.MAX: np.maximum,
}
UNARY: dict[Op, tuple[Callable[..., float], float, float]] = {
    Op.NEG: (np.negative, -100.0, 100.0),
    Op.ABS: (np.abs, -100.0, 100.0),
    Op.SQRT: (np.sqrt, 0.0, 100.0),
    Op.SIN: (np.sin, -20.0, 20.0),
    Op.COS: (np.cos, -20.0, 20.0),
    Op.OWN_SIN: (np.sin, -20.0, 20.0),
    Op.OWN_COS: (np.cos, -20.0, 20.0),
    Op.TAN: (np.tan, -1.2, 1.2),
    Op.ASIN: (np.arcsin, -0.98, 0.98),
    Op.ACOS: (np.arccos, -0.98, 0.98),
    Op.ATAN: (np.arctan, -50.0, 50.0),
    Op.EXP: (np.exp, -20.0, 20.0),
    Op.LOG: (np.log, 0.1, 100.0),
    Op.FLOOR: (np.floor, -100.0, 100.0),
}
# An exact function of the library is off by half a unit: the rule allows one.
JUDGE = 1e-12


def operand(rng: np.random.Generator, low: float, high: float) -> tuple[Number, Number]:
    """A number, and one exact and one computed value of it (as points)."""
    centre, width = rng.uniform(low, high), (high - low) * 10.0 ** rng.uniform(-8.0, 0.0)
    ends = np.array([max(low, centre - width), min(high, centre + width)], dtype=np.float32)
    real = Interval(float(ends[0]), float(ends[1]))
    error = 0.0 if rng.random() < 0.2 else 10.0 ** rng.uniform(-9.0, -1.0) * (high - low) * 0.02
    whole = Number(real, real.widened(error), error, error).settled()
    exact = rng.choice([real.lo, real.hi, rng.uniform(real.lo, real.hi)])
    computed = float(np.float32(exact + error * rng.choice([-0.999, 0.999, rng.uniform(-1, 1)])))
    if abs(computed - exact) > error:
        exact = computed = float(np.float32(exact))
    point = Number(Interval(exact, exact), Interval(computed, computed), error, error)
    return whole, point


def agrees(
    operation: Op, function: Callable[..., float], pairs: list[tuple[Number, Number]]
) -> float:
    """Share of the bound that is used; fails when it is exceeded."""
    result = propagation.apply(operation, [whole for whole, _ in pairs], FLOAT)
    if result.error == INFINITY:
        return 0.0
    exact = float(function(*(point.real.lo for _, point in pairs)))
    shifted = float(function(*(point.computed.lo for _, point in pairs)))
    computed = float(np.float32(shifted))
    slack = JUDGE * max(1.0, abs(exact))
    error = abs(computed - exact)
    assert error <= result.error + slack, (operation, pairs)
    assert result.real.lo - slack <= exact <= result.real.hi + slack, (operation, pairs)
    assert result.computed.lo - slack <= computed <= result.computed.hi + slack, (operation, pairs)
    if result.relative < INFINITY:
        assert error <= result.relative * abs(exact) * (1.0 + 1e-9) + slack, (operation, pairs)
    whole_turns = round((computed - exact) / (2.0 * math.pi)) * 2.0 * math.pi
    assert abs(computed - exact - whole_turns) <= result.turned + slack, (operation, pairs)
    return error / result.error if 0.0 < result.error < INFINITY else 0.0


@pytest.mark.parametrize("operation", BINARY, ids=lambda o: o.value)
def test_rules_of_two_operands(operation: Op) -> None:
    rng = np.random.default_rng(1)
    used = 0.0
    for _ in range(4000):
        scale = 10.0 ** rng.uniform(-3.0, 3.0)
        low = 0.05 * scale if operation is Op.DIV else -scale
        pairs = [operand(rng, -scale, scale), operand(rng, low, scale)]
        used = max(used, agrees(operation, BINARY[operation], pairs))
    assert used > 0.5


@pytest.mark.parametrize("operation", UNARY, ids=lambda o: o.value)
def test_rules_of_one_operand(operation: Op) -> None:
    function, low, high = UNARY[operation]
    rng = np.random.default_rng(2)
    used = 0.0
    for _ in range(4000):
        pair = operand(rng, low, high)
        if pair[1].computed.lo < 0.0 and operation is Op.SQRT:
            continue
        used = max(used, agrees(operation, function, [pair]))
    assert used > 0.4


def test_a_square_is_not_negative_and_twice_as_sensitive() -> None:
    one = Number(Interval(-1.0, 2.0), Interval(-1.1, 2.1), 0.1, 0.1)
    squared = propagation.apply(Op.MUL, [one, one], FLOAT)
    assert squared.real == Interval(0.0, 4.0)
    assert squared.error == pytest.approx(0.1 * (2.0 + 2.1), rel=1e-4)


@pytest.mark.parametrize("operation", [Op.MUL, Op.DIV, Op.SQRT, Op.ADD], ids=lambda o: o.value)
def test_relative_errors_are_handed_on(operation: Op) -> None:
    """Over a range of ten decades, where absolute errors say nothing about small values."""
    rng = np.random.default_rng(3)
    wide, share = Interval(1e-5, 1e5), 1e-4
    number = Number(wide, Interval(0.9998e-5, 1.0002e5), 10.1, 10.1, share)
    count = 1 if operation is Op.SQRT else 2
    result = propagation.apply(operation, [replace(number) for _ in range(count)], FLOAT)
    used = 0.0
    for _ in range(2000):
        exact = 10.0 ** rng.uniform(-5.0, 5.0, count)
        computed = exact * (1.0 + share * rng.choice([-1.0, 1.0], count))
        function = np.sqrt if operation is Op.SQRT else BINARY[operation]
        moved = abs(float(np.float32(function(*computed))) / float(function(*exact)) - 1.0)
        assert moved <= result.relative
        used = max(used, moved / result.relative)
    assert used > 0.95


def test_a_power_of_two_costs_nothing() -> None:
    two = propagation.literal(2.0, FLOAT)
    one = Number(Interval(1.0, 3.0), Interval(1.0, 3.0), 0.0, 0.0)
    assert propagation.apply(Op.MUL, [two, one], FLOAT).error == FLOAT.tiny
    third = propagation.literal(1.0 / 3.0, FLOAT)
    assert third.error == abs(float(np.float32(1.0 / 3.0)) - 1.0 / 3.0)


def test_what_has_no_bound_never_gets_one_back() -> None:
    lost = Number(Interval(0.0, 1.0), Interval(-INFINITY, INFINITY), INFINITY, INFINITY)
    one = Number(Interval(0.0, 0.0), Interval(0.0, 0.0), 0.0, 0.0)
    for operation in (Op.ADD, Op.MUL, Op.DIV, Op.MIN):
        assert propagation.apply(operation, [lost, one], FLOAT).error == INFINITY
    for operation in (Op.SIN, Op.ATAN, Op.SQRT, Op.ABS):
        assert propagation.apply(operation, [lost], FLOAT).error == INFINITY


def test_overflow_has_no_bound() -> None:
    big = Number(Interval(0.0, 1e30), Interval(0.0, 1e30), 0.0, 0.0)
    assert propagation.apply(Op.MUL, [big, big], FLOAT).error == INFINITY
    assert propagation.apply(Op.MUL, [big, big], FORMATS[ir.Scalar.DOUBLE]).error < INFINITY


def test_quotient_by_something_near_zero_has_no_bound() -> None:
    near = Number(Interval(-1.0, 1.0), Interval(-1.0, 1.0), 0.0, 0.0)
    assert propagation.apply(Op.DIV, [near, near], FLOAT).error == INFINITY


def test_an_angle_seen_along_a_tangent() -> None:
    """A point one away from the origin moves by 0.95 and turns by asin(0.95), which is more."""
    reach, turn = math.sqrt(1.0 - 0.95**2), math.asin(0.95)
    y, x = reach * math.sin(turn), reach * math.cos(turn)
    numbers = [
        Number(Interval(exact, exact), Interval(value, value), abs(value - exact), INFINITY)
        for exact, value in ((0.0, y), (1.0, x))
    ]
    seen = propagation.angle(numbers[0], numbers[1], 1.0, FLOAT)
    assert turn <= seen.turned < 1.2 * turn


def test_whole_turns_do_not_matter_to_a_sine() -> None:
    angle = propagation.angle(
        Number(Interval(-1e-3, 1e-3), Interval(-1e-3, 1e-3), 1e-5, 1e-5),
        Number(Interval(-1.0, -0.9), Interval(-1.0, -0.9), 1e-5, 1e-5),
        0.0,
        FLOAT,
    )
    assert angle.error > 6.0 and angle.turned < 1e-4
    two = propagation.literal(2.0, FLOAT)
    doubled = propagation.apply(Op.MUL, [two, angle], FLOAT)
    assert propagation.apply(Op.SIN, [doubled], FLOAT).error < 1e-4
    half = propagation.apply(Op.MUL, [propagation.literal(0.5, FLOAT), angle], FLOAT)
    assert propagation.apply(Op.SIN, [half], FLOAT).error > 1.0
