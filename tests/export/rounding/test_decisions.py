"""Comparisons and floors: series and closed forms, jumps, and what rounding may turn around."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from symnav import ir
from symnav.export.rounding.bounds import bounds, ranges
from symnav.export.rounding.cases import cases
from symnav.export.rounding.evaluation import Evaluator
from symnav.export.rounding.expressions import trace
from symnav.export.rounding.formats import FORMATS
from symnav.export.rounding.structure import Structure
from tests.export.rounding.kernels import (
    DOUBLE,
    FLOAT,
    Op,
    bound,
    box,
    call,
    domain,
    found,
    function,
    load,
    number,
    smooth,
)

X = load(0)


def test_a_jump_is_part_of_the_bound() -> None:
    """The computed sum may be on the other side of the threshold."""
    total = call(Op.ADD, load(0), load(1))
    step = call(Op.SELECT, call(Op.LT, total, 1.0), 0.0, 5.0)
    one = box([0.0, 0.0], [1.0, 1.0], step)
    assert bound(one) == 5.0
    assert smooth(one) == 0.0


def test_an_exact_comparison_never_turns() -> None:
    step = call(Op.SELECT, call(Op.LT, X, 1.0), 0.0, 5.0)
    assert bound(box([0.0], [2.0], step)) == 0.0


def test_a_literal_the_type_does_not_hold_may_turn() -> None:
    """0.1 is another number in float: inputs between the two are decided otherwise."""
    step = call(Op.SELECT, call(Op.LT, X, 0.1), 0.0, 5.0)
    assert bound(box([0.0], [2.0], step), FLOAT) == 5.0
    assert bound(box([0.0], [2.0], step), DOUBLE) == 0.0


def sinc(threshold: float) -> ir.Function:
    """sin(x) / x, by a series near zero."""
    squared = ir.Statement("s", call(Op.MUL, X, X))
    near = call(Op.LT, ir.Ref("s"), threshold)
    root = call(Op.SQRT, call(Op.SELECT, near, 1.0, ir.Ref("s")))
    far = call(Op.DIV, call(Op.SIN, ir.Ref("r")), ir.Ref("r"))
    series = number(-1.0 / 5040.0)
    total: ir.Expression = series
    for factor in (1.0 / 120.0, -1.0 / 6.0, 1.0):
        total = call(Op.ADD, call(Op.MUL, total, ir.Ref("s")), factor)
    steps = (squared, ir.Statement("r", root))
    return box([-3.0], [3.0], call(Op.SELECT, near, total, far), steps=steps)


@pytest.mark.parametrize("threshold", [0.01, 0.1])
def test_series_and_closed_form_meet(threshold: float) -> None:
    one = sinc(threshold)
    assert bound(one) < 20.0 * 2.0**-24
    assert found(one) <= bound(one)


def test_cases_leave_no_input_out() -> None:
    """The pieces a compared range is cut into touch, from one end to the other."""
    one = sinc(0.01)
    graph, kind = trace(one), FORMATS[FLOAT]
    evaluator = Evaluator(graph, Structure(graph, kind), kind, ranges(one, graph, kind))
    found_cases = list(cases(evaluator, graph.cone(graph.results["value"])))
    agreed = [case.ranges for case in found_cases if case.agreed]
    (compared,) = {node for one_case in agreed for node in one_case}
    pieces = sorted((one_case[compared][0] for one_case in agreed), key=lambda piece: piece.lo)
    assert len(pieces) > 4
    assert pieces[0].lo <= 0.0 and pieces[-1].hi >= 9.0
    assert all(left.hi >= right.lo for left, right in pairwise(pieces))
    assert len(found_cases) == len(agreed) + 2


def test_a_series_that_does_not_meet_the_closed_form_shows() -> None:
    """Switched where the series is bad, the difference of the branches is in the bound."""
    assert bound(sinc(4.0)) > 10.0 * bound(sinc(0.1))


def test_a_floor_jumps_by_one() -> None:
    turns = call(Op.FLOOR, call(Op.MUL, X, 0.3))
    one = box([0.0], [10.0], turns)
    assert bound(one) == 1.0 and smooth(one) == 0.0


def test_a_wrapped_angle_jumps_by_a_turn_and_is_otherwise_sharp() -> None:
    inverse = call(Op.MUL, X, 1.0 / (2.0 * math.pi))
    turns = call(Op.FLOOR, call(Op.ADD, 0.5, inverse))
    wrapped = call(Op.SUB, X, call(Op.MUL, 2.0 * math.pi, turns))
    one = box([-10.0], [10.0], wrapped)
    assert bound(one) == pytest.approx(2.0 * math.pi, rel=1e-4)
    assert smooth(one) < 1e-5
    assert bounds(one, FLOAT)["value"][0].largest < math.pi + 1e-4
    assert found(one) <= bound(one)


def test_a_jump_at_a_floor_is_not_lost_behind_it() -> None:
    """What follows a floor that was decided otherwise differs by what the branches differ."""
    turns = call(Op.FLOOR, call(Op.MUL, X, 0.3))
    one = box([0.0], [10.0], call(Op.SIN, call(Op.MUL, 1.5, turns)))
    assert 0.9 < bound(one) <= 2.1
    assert smooth(one) < 1e-6


def test_selectors_take_one_branch_each() -> None:
    """A quotient by what is zero in the other branch is never looked at."""
    which = ir.Load("k", 0)
    code = domain([0.0], [1.0], ir.Kind.INTEGER)
    divisor = call(Op.SELECT, call(Op.EQ, which, 0.0), 2.0, 4.0)
    one = function({"a": domain([0.0], [1.0]), "k": code}, (), [call(Op.DIV, X, divisor)])
    worst = bounds(one, FLOAT)["value"][0]
    assert worst.bound < 2.0**-24 and worst.bound == worst.smooth


def test_and_or_not_are_decided_by_their_parts() -> None:
    low, high = call(Op.LT, X, 1.0), call(Op.LT, X, 2.0)
    between = call(Op.AND, call(Op.NOT, low), high)
    one = box([0.0], [3.0], call(Op.SELECT, between, call(Op.DIV, 1.0, X), 0.0))
    assert bounds(one, FLOAT)["value"][0].largest <= 1.0
    either = call(Op.OR, low, call(Op.NOT, high))
    other = box([0.0], [3.0], call(Op.SELECT, either, 0.0, call(Op.DIV, 1.0, X)))
    assert bounds(other, FLOAT)["value"][0].largest <= 1.0


def test_many_decisions_are_joined() -> None:
    """Beyond a few hundred cases branches are taken together: wider, and still a bound."""
    total: ir.Expression = number(0.0)
    for k in range(8):
        scaled = call(Op.MUL, X, 0.1 + k)
        total = call(Op.ADD, total, call(Op.SELECT, call(Op.LT, scaled, 1.0), scaled, 1.0))
    one = box([-3.0], [3.0], total)
    assert found(one) <= bound(one) < math.inf
