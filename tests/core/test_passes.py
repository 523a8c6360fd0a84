"""Passes over real functions: what comes out computes what went in, and what the pass promises."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

import pytest

from symnav import ir
from symnav.lower.passes.counts import count_operations
from symnav.lower.passes.inline import inline
from symnav.lower.passes.reciprocals import share_reciprocals
from tests.core.interpreter import DOUBLE, Interpreter
from tests.core.judging import draw
from tests.core.specs import Case, calibrated_gps, gps, inertial, lowered, ranges
from tests.core.test_broadcast_orbit import ELEMENTS, orbit
from tests.core.test_pseudorange import GEOMETRY

CASES: dict[str, Case] = {
    "gps": gps(),
    "calibrated gps": calibrated_gps(),
    "ranges": ranges("exact"),
    "four samples": inertial(4),
    "orbit": orbit("gps"),
}
Outputs = dict[str, dict[tuple[int, ...], float]]


def evaluated(name: str, function: ir.Function) -> Outputs:
    """Outputs in doubles at a point of the case."""
    spec = CASES[name].spec()
    given = {"ranges": GEOMETRY, "orbit": ELEMENTS}.get(name, {})
    point = {a: [float(e) for e in x] for a, x in draw(spec, 1, **given).items()}
    return Interpreter(function, DOUBLE).run(point).outputs


def nodes(expression: ir.Expression) -> Iterator[ir.Expression]:
    """Every node of an expression."""
    yield expression
    if isinstance(expression, ir.Call):
        for operand in expression.operands:
            yield from nodes(operand)


def expressions(function: ir.Function) -> Iterator[ir.Expression]:
    """Every expression of a function."""
    yield from (step.value for step in (*function.shared, *function.item))
    yield from (entry.value for output in function.outputs for entry in output.entries)


def divisors(function: ir.Function) -> Counter[ir.Expression]:
    """What is divided by, and how often."""
    return Counter(
        node.operands[1]
        for expression in expressions(function)
        for node in nodes(expression)
        if isinstance(node, ir.Call) and node.operation is ir.Operation.DIV
    )


@pytest.mark.parametrize("route", ["casadi", "sympy"])
@pytest.mark.parametrize("name", list(CASES))
def test_reciprocals(name: str, route: str) -> None:
    """One division for every divisor; at most a rounding or two away."""
    function = lowered(CASES[name].spec(), route)
    shared = share_reciprocals(function)
    repeated = {d: n for d, n in divisors(shared).items() if n > 1}
    assert not {d for d in repeated if not isinstance(d, ir.Number)}
    before, after = evaluated(name, function), evaluated(name, shared)
    for output, values in before.items():
        size = max(1.0, *(abs(v) for v in values.values()))
        assert all(abs(after[output][k] - v) < 1e-14 * size for k, v in values.items())


@pytest.mark.parametrize("longest", [2, 3, 12])
@pytest.mark.parametrize("name", list(CASES))
def test_inlining(name: str, longest: int) -> None:
    """The same bits, fewer lines; nothing longer than asked for."""
    function = lowered(CASES[name].spec(), "casadi")
    folded = inline(function, longest)
    assert evaluated(name, folded) == evaluated(name, function)
    assert count_operations(folded) == count_operations(function)
    assert len(folded.shared) <= len(function.shared)
    longer = [step for step in (*folded.shared, *folded.item) if operands(step.value) > longest]
    assert all(step in (*function.shared, *function.item) for step in longer)
    if longest == 12:
        assert len(folded.shared) < len(function.shared)


def operands(expression: ir.Expression) -> int:
    """Numbers and names an expression holds."""
    return sum(1 for node in nodes(expression) if not isinstance(node, ir.Call))


def test_lines_are_as_long_as_allowed() -> None:
    """A temporary is folded while the line holds no more operands than asked for."""
    x, y = ir.Load("x", 0), ir.Load("x", 1)
    steps = [ir.Statement("t1", ir.Call(ir.Operation.MUL, (x, y)))]
    for k in range(2, 7):
        previous = ir.Ref(f"t{k - 1}")
        steps.append(ir.Statement(f"t{k}", ir.Call(ir.Operation.ADD, (previous, x))))
    folded = inline(straight_line(*steps), 4)
    assert [(step.target, operands(step.value)) for step in folded.shared] == [("t3", 4)]
    (output,) = folded.outputs
    assert operands(output.entries[0].value) == 4


def test_counts_of_items() -> None:
    """The item part counts once for every item."""
    counts = count_operations(lowered(ranges().spec(), "casadi"))
    assert counts.item.total() > 0
    assert counts.total(5) == counts.shared.total() + 5 * counts.item.total()


def straight_line(*steps: ir.Statement) -> ir.Function:
    """A function of two elements of x with the steps given; the last one is its value."""
    domain = ir.Domain(
        "x", 0, 2, ir.Kind.REAL, (1.0,) * 2, (2.0,) * 2, 0.0, "1", "", ("0", "1"), "."
    )
    entry = ir.Entry((0,), ir.Ref(steps[-1].target))
    section = ir.Section("value", 0, 1, "1", ("",))
    output = ir.Output("value", (1,), False, (entry,), (section,), (), "1", "", ".")
    argument = ir.Argument("x", 2, False, False, (domain,))
    return ir.Function(
        "f", ir.Role.MEASUREMENT, "", "", "", (), (argument,), steps, (), (output,), None,
        ir.Items.SKIP, ir.Guards.STATUS, False, False,
    )  # fmt: skip


def quotients(*targets: str) -> ir.Function:
    """Four quotients by two arguments, under the names given, and a sum."""
    x, y = ir.Load("x", 0), ir.Load("x", 1)
    divide, (a, b, c, d) = ir.Operation.DIV, targets
    return straight_line(
        ir.Statement(a, ir.Call(divide, (x, y))),
        ir.Statement(b, ir.Call(divide, (ir.Ref(a), y))),
        ir.Statement(c, ir.Call(divide, (ir.Ref(a), x))),
        ir.Statement(d, ir.Call(divide, (ir.Ref(c), x))),
        ir.Statement("w", ir.Call(ir.Operation.ADD, (ir.Ref(b), ir.Ref(d)))),
    )


def test_reciprocals_of_arguments_come_first() -> None:
    """Before the first step that reads them, under names that are free."""
    function = quotients("a", "b", "c", "d")
    shared = share_reciprocals(function)
    first, second, *others = [step.target for step in shared.shared]
    assert others == ["a", "b", "c", "d", "w"]
    point = {"x": [1.5, 1.25]}
    before, after = (
        Interpreter(f, DOUBLE).run(point).outputs["value"][(0,)] for f in (function, shared)
    )
    assert abs(before - after) < 1e-15
    crowded = quotients(first, f"{first}_2", second, f"{second}_2")
    renamed = [step.target for step in share_reciprocals(crowded).shared][:2]
    assert sorted(renamed) == sorted([f"{first}_3", f"{second}_3"])
