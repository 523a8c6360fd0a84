"""Structured Jacobians against plain SymPy differentiation of the flattened equation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest
import sympy as sp
from mpmath import mpf

from symnav.blocks import Block, HeadingBlock, RotationBlock, VectorBlock
from symnav.derive import Derivation, needed
from symnav.elimination import jacobian, operations
from symnav.graph import ONE, ZERO, Definition, Graph, identity
from tests.core.judging import assert_close, draw
from tests.core.specs import Case, calibrated_gps, derived, gps, inertial, ranges, rotation

#: d(w, x, y, z) by the three elements of a right error, times two: q (0, d).
RIGHT = ((1, -1), (2, -1), (3, -1)), ((0, 1), (3, -1), (2, 1)), ((3, 1), (0, 1), (1, -1)), (
    (2, -1), (1, 1), (0, 1),
)  # fmt: skip


def flattened(derivation: Derivation) -> list[sp.Expr]:
    """The value over argument symbols alone."""
    values = list(derivation.equation.outputs["value"])
    for definition in reversed(derivation.equation.definitions):
        values = [v.xreplace({definition.symbol: definition.expression}) for v in values]
    return values


def tangent(block: Block, x: Sequence[sp.Symbol]) -> sp.Matrix:
    """Change of the stored elements by the error, at its zero."""
    if isinstance(block, RotationBlock):
        rows = [[sign * x[k] / 2 for k, sign in row] for row in RIGHT]
        if block.error == "storage":
            return sp.eye(4)
        assert (block.error, block.storage) == ("right", "wxyz")
        return sp.Matrix(rows)
    assert isinstance(block, (VectorBlock, HeadingBlock))
    return sp.eye(block.storage_size)


def plain_jacobian(case: Case, derivation: Derivation) -> list[sp.Expr]:
    """Row-major derivative by the error of the state, with SymPy's chain rule and nothing else."""
    layout = case.spec().layout
    by_place = {
        (o.argument, o.index): s for s, o in derivation.origins.items() if o.argument == "x"
    }
    values = sp.Matrix(flattened(derivation))
    columns = []
    for place in layout.places.values():
        x = [by_place.get(("x", k), sp.Dummy()) for k in range(layout.size)[place.storage]]
        columns.append(values.jacobian(x) * tangent(place.block, x))
    return list(sp.Matrix.hstack(*columns))


def raw_gps() -> Case:
    """The columns of a quaternion's elements."""
    case = gps()
    return Case(
        case.model, [case.blocks[0], rotation("q", error="storage")], case.inputs, case.bindings,
        case.frames,
    )  # fmt: skip


CASES = {
    "gps": gps(),
    "raw gps": raw_gps(),
    "calibrated gps": calibrated_gps(),
    "range": ranges(),
    "range with earth rotation": ranges("first_order"),
    "specific force": inertial(1),
    "two samples": inertial(2, "polynomial", epoch="end"),
}


@pytest.mark.parametrize("name", list(CASES))
def test_against_plain_differentiation(name: str) -> None:
    """Same numbers by a way that knows no graph."""
    case = CASES[name]
    derivation = derived(case.spec())
    point = draw(case.spec(), 2)
    numbers = {s: point[o.argument][o.index] for s, o in derivation.origins.items()}
    symbols = list(numbers)
    plain = sp.lambdify(symbols, plain_jacobian(case, derivation), "mpmath", cse=True)
    expected = [mpf(e) for e in plain(*numbers.values())]
    (output,) = [o for o in derivation.outputs if o.name == "jacobian"]
    known: dict[sp.Symbol, Any] = dict(numbers)
    for d in derivation.definitions:
        known[d.symbol] = _number(d.expression, known)
    actual = [mpf(0)] * len(expected)
    for (row, column), e in output.entries.items():
        actual[row * output.columns + column] = _number(e, known)
    assert_close(actual, expected, name)


def _number(expression: sp.Expr, known: dict[sp.Symbol, Any]) -> Any:
    symbols = sorted(expression.free_symbols, key=str)
    return mpf(sp.lambdify(symbols, expression, "mpmath")(*(known[s] for s in symbols)))


def diamond() -> tuple[Graph, tuple[sp.Symbol, ...], sp.Symbol]:
    """One source, two ways to the value."""
    graph = Graph()
    x, y = graph.argument(["x", "y"])
    graph.attach("a", [x, y], 2, {graph.source("error of a", 2).name: identity(2)})
    (p,) = graph.let("p", [x * y])
    (q,) = graph.let("q", [x + 3 * p])
    (r,) = graph.let("r", [q * q - p])
    return graph, (x, y), r


def test_paths_add_up() -> None:
    """Every way from the source to the value counts once."""
    graph, (x, y), r = diamond()
    (source,) = [name for name in graph.vertices if name.startswith("error")]
    row = jacobian(graph, [r], {source: 2})[source][0]
    definitions = {d.symbol: d.expression for d in graph.definitions}
    for _ in definitions:
        row = tuple(e.xreplace(definitions) for e in row)
    p = x * y
    q = x + 3 * p
    assert sp.expand(row[0] - (2 * q * (1 + 3 * y) - y)) == 0
    assert sp.expand(row[1] - (2 * q * 3 * x - x)) == 0


def test_what_is_not_reached_is_zero() -> None:
    """Also where the value does not move at all."""
    graph, _, r = diamond()
    other = graph.source("error of b", 2).name
    (c,) = graph.argument(["c"])
    assert jacobian(graph, [r], {other: 2})[other] == ((ZERO, ZERO),)
    assert jacobian(graph, [c], {other: 2})[other] == ((ZERO, ZERO),)


def test_terms_are_named_once_up_to_their_sign() -> None:
    """The opposite of a named product is not computed again."""
    graph = Graph()
    x, y = graph.argument(["x", "y"])
    (c,) = graph.argument(["c"])
    graph.attach("a", [x, y], 2, {graph.source("error of a", 2).name: identity(2)})
    (p, q) = graph.let("p", [c * c * x + y, y - c * c * x])
    rows = jacobian(graph, [p, q], {"error of a": 2})["error of a"]
    assert rows[0][0] == -rows[1][0]
    assert (rows[0][1], rows[1][1]) == (ONE, ONE)
    assert len(graph.definitions) == 3


X, Y, Z = sp.symbols("x y z")


@pytest.mark.parametrize(
    ("expression", "count"),
    [
        (X, 0), (-X, 0), (X - Y, 1), (X + Y + 1, 2), (2 * X, 1), (-X * Y, 1), (X * Y * Z, 2),
        (X / Y, 2), (sp.sin(X * Y), 2), (sp.sqrt(X + Y), 2), (X * Y - Z * X, 3),
    ],
)  # fmt: skip
def test_operations(expression: sp.Expr, count: int) -> None:
    """Signs are free, a division is a reciprocal and a product."""
    assert operations(expression) == count


def test_unused_definitions_are_dropped_but_guards_stay() -> None:
    """A check that no output reads is still a check."""
    spec = ranges().spec()
    derivation = derived(spec)
    kept = needed(derivation.definitions, derivation.outputs[:1])
    assert len(kept) < len(derivation.definitions)
    guarded = [d for d in derivation.definitions if d.guard is not None]
    assert guarded and set(guarded) <= set(needed(derivation.definitions, ()))
    assert all(isinstance(d, Definition) for d in kept)
