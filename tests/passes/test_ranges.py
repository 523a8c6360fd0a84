"""Checks that cannot fail go; those that can stay, with everything they say."""

from __future__ import annotations

from dataclasses import replace

import pytest

from symnav import ir, pipeline
from symnav.lower.passes.ranges import drop_idle_checks
from tests.emit_c import modules
from tests.emit_c.building import Op, add, call, mul, sub
from tests.passes.test_passes import a, small, statement

EXPECTED = ir.Status.DOMAIN


def check(target: str, value: ir.Expression, lower: float, upper: float) -> ir.Check:
    """A guard that puts 1 in place of what fails."""
    return ir.Check(target, value, lower, upper, 1.0, EXPECTED, "guarded")


def kept(*steps: ir.Step, value: str) -> list[str]:
    """Targets of the checks that stay."""
    changed = drop_idle_checks(small(*steps, value=ir.Ref(value)))
    assert [step.target for step in changed.shared] == [step.target for step in steps]
    assert all(new.value == old.value for new, old in zip(changed.shared, steps, strict=True))
    return [step.target for step in changed.shared if isinstance(step, ir.Check)]


# The inputs a(0), a(1), a(2) are between -5 and 5.
@pytest.mark.parametrize(
    ("value", "lower", "upper", "stays"),
    [
        (add(a(0), 6.0), 0.5, 100.0, False),
        (add(a(0), 6.0), 1.0, 100.0, True),  # rounding may take it below
        (add(a(0), 6.0), 0.5, 10.9, True),
        (add(a(0), 6.0), 0.5, 11.0, True),  # rounding may take it above
        (sub(a(0), a(1)), -10.1, 10.1, False),
        (sub(a(0), a(1)), -9.9, 10.1, True),
        (mul(a(0), a(0)), -1.0, 25.1, False),  # a square is not negative
        (mul(a(0), a(1)), -1.0, 25.1, True),
        (call(Op.NEG, mul(a(0), a(0))), -25.1, 1.0, False),
        (call(Op.NEG, add(a(0), 6.0)), -10.0, 0.0, True),
        (call(Op.NEG, add(a(0), 6.0)), -11.1, -0.5, False),
        (call(Op.SQRT, add(mul(a(0), a(0)), 1.0)), 0.5, 6.0, False),
        (call(Op.SQRT, a(0)), -1.0, 6.0, True),  # may be no number
        (call(Op.DIV, 1.0, add(a(0), 6.0)), 0.0, 1.1, False),
        (call(Op.DIV, 1.0, a(0)), -1e30, 1e30, True),
        (call(Op.ABS, a(0)), -0.1, 5.1, False),
        (call(Op.COS, a(0)), -1.1, 1.1, False),
        (call(Op.COS, a(0)), -0.9, 1.1, True),
        (call(Op.SIN, a(0)), -0.9, 1.1, True),
        (ir.Number(0.0), 0.0, 1.0, False),  # rounding changes no sign
        (ir.Number(0.0), -1.0, 0.0, False),
        (ir.Number(0.5), 0.5, 1.0, True),  # a rounding below
        (ir.Number(0.5), 0.0, 0.5, True),  # and above
        (ir.Number(3e-44), 2.5e-44, 1.0, True),  # a rounding of subnormal numbers
        (ir.Number(-3e-44), -1.0, -2.5e-44, True),
        (call(Op.OWN_COS, a(0)), -1.1, 1.1, False),
        (call(Op.OWN_COS, a(0)), -0.9, 1.1, True),
        (call(Op.OWN_SIN, a(0)), -0.9, 1.1, True),
        (call(Op.TAN, a(0)), -1e30, 1e30, True),
        (call(Op.MAX, a(0), 2.0), 1.9, 5.1, False),
        (call(Op.MIN, a(0), 2.0), -5.1, 2.1, False),
        (call(Op.SELECT, call(Op.LT, a(0), 0.0), 3.0, a(1)), -5.1, 5.1, False),
        (call(Op.SELECT, call(Op.LT, a(0), 0.0), 7.0, a(1)), -5.1, 5.1, True),
        (mul(add(a(0), 1e30), add(a(0), 1e30)), -1.0, 1e300, True),  # overflows a float
    ],
)
def test_intervals(value: ir.Expression, lower: float, upper: float, stays: bool) -> None:
    assert kept(check("t", value, lower, upper), value="t") == (["t"] if stays else [])


def test_what_passed_a_check_is_inside_it() -> None:
    first = check("s", mul(a(0), a(1)), 1.0, 30.0)
    root = statement("r", call(Op.SQRT, "s"))
    assert kept(first, root, check("t", add("r", 1.0), 1.5, 7.0), value="t") == ["s"]


def test_what_stands_in_for_it_counts() -> None:
    first = replace(check("s", mul(a(0), a(1)), 2.0, 30.0), substitute=-4.0)
    assert kept(first, check("t", add("s", 0.0), 1.0, 31.0), value="t") == ["s", "t"]


def test_functions_without_guards_are_left_alone() -> None:
    function = small(
        check("t", add(a(0), 6.0), 0.5, 100.0), value=ir.Ref("t"), guards=ir.Guards.ASSUME
    )
    assert drop_idle_checks(function) is function


def test_the_sum_of_ranges_needs_no_guard() -> None:
    spec = pipeline.load("reference_relative")
    functions = {f.name: f for f in pipeline.c_route(spec, pipeline.derive(spec))}
    steps = functions["range"].item
    assert "range_sum" in {step.target for step in steps}
    assert {step.target for step in steps if isinstance(step, ir.Check)} == {"range_squared"}


def test_guards_that_can_fail_stay() -> None:
    dropped = set()
    for function in modules.all_functions():
        changed = drop_idle_checks(function)
        before = (*function.shared, *function.item)
        after = (*changed.shared, *changed.item)
        dropped |= {new.target for old, new in zip(before, after, strict=True) if old != new}
    # pair is between -4 and 4: pair - 4.5 is always between -9 and -0.25.
    assert dropped == {"gap"}
