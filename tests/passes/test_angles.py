"""Sines and cosines become the C's own where the declared ranges say so, and nowhere else."""

from __future__ import annotations

from dataclasses import replace

import pytest

from symnav import ir
from symnav.lower.passes.angles import own_sinusoids
from symnav.trigonometry import LIMIT
from tests.emit_c.building import Op, add, call, mul, sub
from tests.passes.test_passes import a, small, statement

OWN = {Op.SIN: Op.OWN_SIN, Op.COS: Op.OWN_COS}


# The inputs a(0), a(1), a(2) and those of an item are between -5 and 5.
@pytest.mark.parametrize("wave", OWN)
@pytest.mark.parametrize(
    ("angle", "near"),
    [
        (a(0), True),
        (mul(a(0), LIMIT / 5.1), True),
        (mul(a(0), LIMIT / 4.9), False),
        (mul(a(0), -LIMIT / 4.9), False),
        (call(Op.SQRT, a(0)), False),  # may be no number
        (call(Op.DIV, 1.0, a(0)), False),
        (call(Op.SQRT, mul(a(0), a(0))), True),  # rounding makes no square negative
        (sub(a(0), LIMIT), False),
        (add(a(0), LIMIT), False),
        (ir.Number(LIMIT * 1.001), False),
        (ir.Number(1.0), True),
    ],
)
def test_range_decides(wave: Op, angle: ir.Expression, near: bool) -> None:
    """Statements, what they are nested in, entries, and the items that read a shared angle."""
    expected = OWN[wave] if near else wave
    nested = call(Op.NEG, call(wave, angle))
    function = small(
        statement("angle", angle),
        statement("nested", nested),
        item=(
            statement("own", call(wave, "angle")),
            statement("other", mul("own", ir.Load("b", 0))),
        ),
        value=call(wave, "angle"),
    )
    changed = own_sinusoids(function)
    assert changed.shared[1].value == call(Op.NEG, call(expected, angle))
    assert changed.item[0].value == call(expected, "angle")
    assert changed.outputs[0].entries[0].value == call(expected, "angle")
    same = own_sinusoids(replace(function, guards=ir.Guards.ASSUME))
    assert (same.shared, same.item) == (changed.shared, changed.item)


def test_a_guard_is_as_good_as_a_range() -> None:
    """A checked angle is inside its bounds, whatever it came from."""
    wild = call(Op.DIV, 1.0, a(0))
    check = ir.Check("angle", wild, -LIMIT / 2, LIMIT / 2, 1.0, ir.Status.DOMAIN, "an angle")
    changed = own_sinusoids(small(check, value=call(Op.SIN, "angle")))
    assert changed.outputs[0].entries[0].value == call(Op.OWN_SIN, "angle")
    assert changed.shared == (check,)


def test_nothing_else_changes() -> None:
    """Other functions of an angle stay those of the library."""
    function = small(statement("t", call(Op.TAN, a(0))), value=call(Op.EXP, "t"))
    assert own_sinusoids(function) == function
