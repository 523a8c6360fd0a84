"""What may go on with a number that failed its check, and what must be given another."""

from __future__ import annotations

from dataclasses import replace

import pytest

from symnav import ir
from symnav.emit import c
from symnav.emit.c.discarding import selected
from tests.emit_c import modules
from tests.emit_c.building import (
    Expression,
    Op,
    X,
    add,
    argument,
    call,
    domain,
    function,
    output,
    x,
)

POWER = ir.Load("power", 0)
NOISE = argument(domain("power", 0, "w", 9.0), item=True)


def mapped(value: Expression, *steps: ir.Step) -> ir.Function:
    """One row an item."""
    found = output("value", (1,), [((0,), value)], item=True)
    return function("f", [X, NOISE], item=steps, outputs=(found,), maximum=4)


def guard(value: Expression) -> ir.Check:
    return ir.Check("level", value, 1e-3, 1e3, 1.0, ir.Status.DOMAIN, "level")


@pytest.mark.parametrize("operation", [Op.SQRT, Op.LOG, Op.ASIN, Op.SIN, Op.ATAN2])
def test_roots_and_library_functions_read_selected_numbers(operation: ir.Operation) -> None:
    count = 2 if operation is Op.ATAN2 else 1
    assert POWER in selected(mapped(call(operation, *[POWER] * count)))
    assert POWER in selected(mapped(call(operation, *[add(POWER, 1.0)] * count)))
    of_state = call(operation, *[x(0)] * count)
    assert not selected(mapped(add(of_state, POWER)))
    guarded = call(operation, *[ir.Ref("level")] * count)
    assert not selected(mapped(guarded, guard(POWER)))


def test_so_do_divisors_and_not_what_is_divided() -> None:
    assert POWER in selected(mapped(call(Op.DIV, 1.0, POWER)))
    assert not selected(mapped(call(Op.DIV, POWER, x(0))))
    root = ir.Statement("root", call(Op.SQRT, ir.Ref("level")))
    assert not selected(mapped(call(Op.DIV, 1.0, ir.Ref("root")), guard(POWER), root))
    again = ir.Statement("more", add(ir.Ref("root"), POWER))
    assert POWER in selected(mapped(call(Op.DIV, 1.0, ir.Ref("more")), guard(POWER), root, again))


def test_without_items_every_input_can_fail() -> None:
    value = output("value", (1,), [((0,), call(Op.DIV, 1.0, x(0)))])
    assert selected(function("f", [X], outputs=(value,))) == {x(0)}
    value = output("value", (1,), [((0,), call(Op.OWN_SIN, x(0)))])
    assert not selected(function("f", [X], outputs=(value,)))


def test_a_guard_that_is_left_out_selects_nothing() -> None:
    guarded = mapped(call(Op.SQRT, ir.Ref("level")), guard(POWER))
    assert selected(replace(guarded, guards=ir.Guards.ASSUME)) == {POWER}


def test_of_an_argument_only_the_elements_that_are_read_there() -> None:
    pair = argument(domain("power", 0, "wv", 9.0), item=True)
    spare = ir.Load("power", 1)
    entries = {
        POWER: add(call(Op.DIV, 1.0, POWER), spare),
        spare: add(call(Op.DIV, POWER, spare), POWER),
    }
    for needed, entry in entries.items():
        assert selected(replace(mapped(entry), arguments=(X, pair))) == {needed}


def test_a_slot_may_choose_any_element() -> None:
    pair = argument(domain("power", 0, "wv", 9.0), item=True)
    chosen = ir.Load("power", ir.Offset(0, ir.Load("slot", 0)))
    of_both = replace(mapped(call(Op.DIV, 1.0, chosen)), arguments=(X, pair))
    assert selected(of_both) == {POWER, ir.Load("power", 1)}


def test_loaders_say_which() -> None:
    def text(of: ir.Function) -> str:
        files = c.emit(modules.module(of))
        return next(content for path, content in files.items() if path.endswith("f_kernel.h"))

    assert "read_centred(power[0]" in text(mapped(add(POWER, x(0))))
    assert "take_centred(power[0]" in text(mapped(call(Op.DIV, 1.0, POWER)))
