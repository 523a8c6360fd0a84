"""Passes: what they change, and that they change no result."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from symnav import ir
from symnav.lower.passes.counts import count_operations
from symnav.lower.passes.inline import inline
from symnav.lower.passes.ranges import drop_idle_checks
from symnav.lower.passes.reciprocals import share_reciprocals
from symnav.lower.passes.walk import nodes, references
from tests.emit_c import building, modules
from tests.emit_c.building import Op, add, call, mul, sub
from tests.emit_c.interpreter import evaluate
from tests.emit_c.samples import draw

FUNCTIONS = {function.name: function for function in modules.all_functions()}
Pass = Callable[[ir.Function], ir.Function]
PASSES: dict[str, Pass] = {
    "inline": inline,
    "reciprocals": share_reciprocals,
    "idle checks": drop_idle_checks,
    "both": lambda function: inline(share_reciprocals(function)),
}


def statement(name: str, value: ir.Expression, comment: str = "") -> ir.Statement:
    """A statement."""
    return ir.Statement(name, value, comment)


def a(index: int) -> ir.Load:
    """An element of the only input."""
    return ir.Load("a", index)


def small(
    *shared: ir.Step, value: ir.Expression, item: tuple[ir.Step, ...] = (), **more: object
) -> ir.Function:
    """A function of ``a``, of ``b`` per item where it has items, with one value."""
    arguments = [building.argument(building.domain("a", 0, "xyz", 5.0))]
    if item:
        arguments.append(building.argument(building.domain("b", 0, "xyz", 5.0), item=True))
    outputs = (building.output("value", (), [((), value)], item=bool(item)),)
    base = building.function(
        "f", arguments, shared=shared, item=item, outputs=outputs, maximum=4 if item else None
    )
    return replace(base, **more)  # type: ignore[arg-type]


def divisions(function: ir.Function) -> tuple[int, int]:
    """Divisions of the shared and of the item part."""
    counts = count_operations(function)
    return counts.shared[Op.DIV], counts.item[Op.DIV]


def assigned_once_before_use(function: ir.Function) -> None:
    """Every step reads only what stands in front of it."""
    known: set[str] = set()
    for step in (*function.shared, *function.item):
        assert set(references(step.value)) <= known, step
        assert step.target not in known
        known.add(step.target)
    for output in function.outputs:
        for entry in output.entries:
            assert set(references(entry.value)) <= known


@pytest.mark.parametrize("transform", PASSES.values(), ids=PASSES.keys())
@pytest.mark.parametrize("name", FUNCTIONS)
def test_results_are_the_same(name: str, transform: Pass) -> None:
    """In 50 digits, for every kind of function."""
    function = FUNCTIONS[name]
    changed = transform(function)
    assigned_once_before_use(changed)
    for seed in range(3):
        inputs = draw(function, seed, 3)
        expected, found = evaluate(function, inputs, 3), evaluate(changed, inputs, 3)
        assert found.status is expected.status
        assert found.item_status == expected.item_status
        for key, array in expected.outputs.items():
            assert_allclose(found.outputs[key], array, rtol=1e-15)


class TestReciprocals:
    """Sharing divisions."""

    def test_a_divisor_used_twice(self) -> None:
        """One division, right behind what it divides by."""
        function = small(
            statement("d", add(a(0), 1.0)),
            statement("p", call(Op.DIV, a(1), "d")),
            value=add("p", call(Op.DIV, a(2), "d")),
        )
        changed = share_reciprocals(function)
        assert [step.target for step in changed.shared] == ["d", "inverse_d", "p"]
        assert divisions(changed) == (1, 0)
        assert changed.shared[2].value == mul(a(1), "inverse_d")

    def test_a_divisor_used_once(self) -> None:
        """Nothing is gained, so nothing changes."""
        function = small(statement("d", add(a(0), 1.0)), value=call(Op.DIV, a(1), "d"))
        assert share_reciprocals(function) is function

    def test_numbers_are_left_to_the_compiler(self) -> None:
        """It knows which of them are exact."""
        function = small(
            value=add(call(Op.DIV, a(0), ir.Number(3.0)), call(Op.DIV, a(1), ir.Number(3.0)))
        )
        assert share_reciprocals(function) is function

    def test_an_existing_reciprocal_is_the_one(self) -> None:
        """``1 / d`` becomes a name, not a product with one."""
        function = small(
            statement("d", add(a(0), 1.0)),
            statement("p", call(Op.DIV, 1.0, "d")),
            value=mul("p", call(Op.DIV, a(2), "d")),
        )
        assert share_reciprocals(function).shared[2].value == ir.Ref("inverse_d")

    def test_divisors_are_compared_as_expressions(self) -> None:
        """The same load or sum is the same divisor; a divisor may hold a quotient itself."""
        inner = add(call(Op.DIV, 2.0, a(0)), 1.0)
        function = small(
            value=add(call(Op.DIV, a(1), inner), call(Op.DIV, a(2), inner), call(Op.DIV, 3.0, a(0)))
        )
        changed = share_reciprocals(function)
        assigned_once_before_use(changed)
        assert divisions(function) == (5, 0)
        assert divisions(changed) == (2, 0)

    def test_a_shared_divisor_in_the_item_part(self) -> None:
        """One division a call instead of one an item."""
        function = small(
            statement("d", add(a(0), 1.0)),
            item=(statement("p", call(Op.DIV, ir.Load("b", 0), "d")),),
            value=ir.Ref("p"),
        )
        assert divisions(function) == (0, 1)
        changed = share_reciprocals(function)
        assert divisions(changed) == (1, 0)
        assert [step.target for step in changed.shared] == ["d", "inverse_d"]

    def test_a_divisor_of_the_item_stays_there(self) -> None:
        """Read by load, by name, or chosen by the slot of an item."""
        slot = ir.Load("a", ir.Offset(0, ir.Load("b", 0)))
        for divisor in (ir.Load("b", 1), ir.Ref("d"), slot):
            function = small(
                item=(
                    statement("d", add(ir.Load("b", 2), 1.0)),
                    statement("p", call(Op.DIV, a(0), divisor)),
                ),
                value=add("p", call(Op.DIV, a(1), divisor)),
            )
            changed = share_reciprocals(function)
            assert divisions(changed) == (0, 1)
            assert not changed.shared

    def test_names_say_what_is_divided_by(self) -> None:
        """An input has a name as well; the only element of one needs no number."""
        scale = building.argument(building.domain("dt", 0, ["value"], 1.0))
        dt = ir.Load("dt", 0)
        terms = [call(Op.DIV, a(k), divisor) for k in (1, 2) for divisor in (a(0), dt)]
        function = small(value=add(*terms))
        function = replace(function, arguments=(*function.arguments, scale))
        changed = share_reciprocals(function)
        assert [step.target for step in changed.shared] == ["inverse_a_0", "inverse_dt"]

    def test_names_are_free(self) -> None:
        """A step may already have the name."""
        function = small(
            statement("d", add(a(0), 1.0)),
            statement("inverse_d", add(a(1), 1.0)),
            value=add(call(Op.DIV, a(1), "d"), call(Op.DIV, "inverse_d", "d")),
        )
        changed = share_reciprocals(function)
        assert [step.target for step in changed.shared] == ["d", "inverse_d_2", "inverse_d"]


class TestInline:
    """Folding temporaries."""

    def test_single_use_is_folded(self) -> None:
        """One line instead of three, with the same operations."""
        function = small(
            statement("t1", mul(a(0), a(1))),
            statement("t2", mul(a(1), a(2))),
            statement("t3", sub("t1", "t2")),
            value=ir.Ref("t3"),
        )
        changed = inline(function)
        assert changed.shared == ()
        assert changed.outputs[0].entries[0].value == sub(mul(a(0), a(1)), mul(a(1), a(2)))
        assert count_operations(changed) == count_operations(function)

    @pytest.mark.parametrize(
        ("step", "reason"),
        [
            (statement("t1", mul(a(0), a(1)), "momentum"), "it has a comment"),
            (statement("momentum", mul(a(0), a(1))), "it has a name"),
        ],
    )
    def test_what_says_something_keeps_its_line(self, step: ir.Statement, reason: str) -> None:
        """A named value is worth a line."""
        function = small(step, value=add(step.target, 1.0))
        assert inline(function).shared == (step,), reason

    def test_what_is_a_result_is_written_where_the_result_is(self) -> None:
        """Its place says what it is, however long it is and whatever it is called."""
        step = statement("momentum", add(*(a(k % 3) for k in range(20))))
        function = small(step, value=ir.Ref("momentum"))
        changed = inline(function, longest=8)
        assert changed.shared == ()
        assert changed.outputs[0].entries[0].value == step.value

    def test_a_result_with_a_comment_or_another_reader_keeps_its_line(self) -> None:
        """The comment would be lost, the arithmetic done twice."""
        told = statement("momentum", mul(a(0), a(1)), "of the rotor")
        assert inline(small(told, value=ir.Ref("momentum"))).shared == (told,)
        again = (statement("momentum", mul(a(0), a(1))), statement("half", mul("momentum", 0.5)))
        base = small(*again, value=ir.Ref("momentum"))
        second = building.output("second", (), [((), add("half", a(2)))])
        function = replace(base, outputs=(*base.outputs, second))
        assert inline(function).shared == again

    def test_what_is_read_twice_keeps_its_line(self) -> None:
        """Folding it would compute it twice."""
        function = small(statement("t1", mul(a(0), a(1))), value=mul("t1", "t1"))
        assert inline(function) == function

    def test_no_folding_across_a_check(self) -> None:
        """What is computed before a check stays before it; its own operand may be folded."""
        check = ir.Check("c", ir.Ref("t2"), 0.0, 1.0, 0.0, ir.Status.DOMAIN, "")
        function = small(
            statement("t1", mul(a(0), a(1))),
            statement("t2", mul(a(1), a(2))),
            check,
            value=add("t1", "c"),
        )
        changed = inline(function)
        assert [step.target for step in changed.shared] == ["t1", "c"]
        assert changed.shared[1].value == mul(a(1), a(2))

    def test_length_is_limited(self) -> None:
        """Too long for a line: the temporary is stored just before its reader."""
        long = add(*(a(k % 3) for k in range(6)))
        function = small(statement("t1", long), statement("t2", long), value=mul("t1", "t2"))
        changed = inline(function, longest=8)
        assert [step.target for step in changed.shared] == ["t2"]
        for step in changed.shared:
            assert sum(not isinstance(node, ir.Call) for node in nodes(step.value)) <= 8
        assert inline(function, longest=12).shared == ()

    def test_shared_values_are_not_folded_into_items(self) -> None:
        """They would be evaluated for every item."""
        function = small(
            statement("t1", mul(a(0), a(1))),
            item=(statement("u1", mul("t1", ir.Load("b", 0))),),
            value=add("u1", 1.0),
        )
        changed = inline(function)
        assert changed.shared == function.shared
        assert changed.item == ()


def test_counts() -> None:
    """By kind and by part, entries of outputs included."""
    counts = count_operations(FUNCTIONS["range"])
    assert counts.item[Op.SQRT] == 1 and counts.shared[Op.SQRT] == 0
    assert counts.item[Op.DIV] == 1
    assert counts.shared[Op.MUL] == 27 + 9  # of the rotation, of the lever arm
    assert counts.total(3) == counts.total(0) + 3 * sum(counts.item.values())
    single = count_operations(FUNCTIONS["gps"])
    assert not single.item
    assert single.shared[Op.DIV] == 3
    assert np.isclose(single.total(), single.total(20))
