"""The graph: names, vertices, local partials, what moves and what belongs to an item."""

from __future__ import annotations

import pytest
import sympy as sp

from symnav import graph as g
from symnav.graph import ONE, ZERO, Definition, Graph, Guard, is_multiple

X, Y = sp.symbols("x y")


def moving(graph: Graph, name: str, size: int, scale: sp.Expr = ONE) -> tuple[sp.Symbol, ...]:
    """Arguments that an error of the same size moves."""
    symbols = graph.argument([f"{name}{k}" for k in range(size)])
    source = graph.source(f"error of {name}", size)
    graph.attach(name, symbols, size, {source.name: g.identity(size, scale)})
    return symbols


def test_let_differentiates_toward_its_direct_parents() -> None:
    """Nothing is differentiated beyond one vertex; constants have no partial."""
    graph = Graph()
    x, y = moving(graph, "a", 2)
    (c,) = graph.argument(["c"])
    p, q = graph.let("p", [x * y, c * y])
    (r,) = graph.let("r", [p * p + q * x])
    assert graph.vertices["p"].partials == {"a": ((y, x), (ZERO, c))}
    assert graph.vertices["r"].partials == {"p": ((2 * p, x),), "a": ((q, ZERO),)}
    assert graph.owner(r) == "r"
    assert graph.owner(c) is None
    assert [d.symbol for d in graph.definitions] == [p, q, r]


def test_what_does_not_move_is_no_vertex() -> None:
    """A term over constants is only a definition."""
    graph = Graph()
    (c,) = graph.argument(["c"])
    graph.let("t", [c * c])
    assert "t" not in graph.vertices
    assert not graph.moves(c)


def test_a_rule_must_speak_for_what_it_moves() -> None:
    """Symbols that move by a rule may not be used by a let."""
    graph = Graph()
    (x,) = graph.argument(["x"])
    graph.attach("block", [x], 0, {}, identity=False)
    assert graph.moves(x)
    with pytest.raises(AssertionError, match="moves by a rule"):
        graph.let("t", [2 * x])


def test_frozen_definitions_stand_still() -> None:
    """The error of the state does not reach them."""
    graph = Graph()
    (x,) = moving(graph, "a", 1)
    (held,) = graph.define("held", [x * x], frozen=True)
    (free,) = graph.define("free", [x * x])
    assert not graph.moves(held)
    assert graph.moves(free)
    assert [d.frozen for d in graph.definitions] == [True, False]


def test_items_spread() -> None:
    """What reads an item's input, or a vertex that does, belongs to the item."""
    graph = Graph()
    (x,) = moving(graph, "a", 1)
    (s,) = graph.argument(["s"], item=True)
    (d,) = graph.let("d", [x - s])
    (e,) = graph.let("e", [x * x])
    (f,) = graph.let("f", [d + e])
    items = {d.symbol: d.item for d in graph.definitions}
    assert items == {d: True, e: False, f: True}
    assert graph.item_arguments([x, s]) == {s}
    assert graph.is_item(x, d) and not graph.is_item(x, e)
    assert [graph.vertices[n].item for n in ("a", "d", "e", "f")] == [False, True, False, True]


def test_names_are_unique_and_free_of_reserved_words() -> None:
    """A name that is taken gets a number, a reserved one an underscore."""
    graph = Graph(reserved=frozenset({"double"}))
    (x,) = graph.argument(["x"])
    names = [str(graph.define("x", [x])[0]), str(graph.define("x", [x])[0])]
    assert names == ["x_2", "x_3"]
    assert str(graph.define("double", [x])[0]) == "double_"
    taken: set[str] = set()
    assert [graph.free_name(n, taken) for n in ("x", "y", "y", "double")] == [
        "x_4", "y", "y_2", "double__2",
    ]  # fmt: skip
    assert taken == {"x_4", "y", "y_2", "double__2"}
    graph.adopt([Definition(sp.Symbol("y"), x, item=True)])
    assert str(graph.define("y", [x])[0]) == "y_2"
    assert graph.is_item(sp.Symbol("y"))


def test_guards_travel() -> None:
    """The domain of a name stays with its definition."""
    graph = Graph()
    (x,) = graph.argument(["x"])
    guard = Guard(1.0, 2.0, 1.5, "a reason")
    graph.define("t", [x], guard=guard)
    assert graph.definitions[0].guard == guard


def test_element_names() -> None:
    """One element has no suffix, three are x, y, z, any other number counts."""
    assert g.element_names("a", 1) == ("a",)
    assert g.element_names("a", 3) == ("a_x", "a_y", "a_z")
    assert g.element_names("a", 2) == ("a_0", "a_1")
    assert g.element_names("a", 2, ("c", "s")) == ("a_c", "a_s")


def test_matrices() -> None:
    """Rows, transposes and products."""
    a = sp.symbols("a0:6")
    rows = g.rows_of(a, 3)
    assert rows == (a[:3], a[3:])
    assert g.transpose(rows) == ((a[0], a[3]), (a[1], a[4]), (a[2], a[5]))
    x = sp.symbols("x0:3")
    assert g.product(rows, tuple((e,) for e in x)) == (
        (a[0] * x[0] + a[1] * x[1] + a[2] * x[2],),
        (a[3] * x[0] + a[4] * x[1] + a[5] * x[2],),
    )
    assert g.identity(2, -ONE) == ((-ONE, ZERO), (ZERO, -ONE))


def test_multiples() -> None:
    """A sign is no factor worth a name, and a sum is no multiple."""
    assert is_multiple(2 * X) and is_multiple(-X / 3) and is_multiple(sp.Float(0.25) * X)
    assert not any(is_multiple(e) for e in (X, -X, 2 * X * Y, 2 * X + 1, sp.Integer(3)))


@pytest.mark.parametrize(
    "expression",
    [
        3 * X + Y,
        X * Y * (X - Y),
        (X * Y + 1) ** 2,
        (X**2 + Y**2 + 1) ** sp.Rational(-3, 2),
        X**Y,
        sp.sin(X * Y) / X,
        sp.atan2(X, Y) * X**3,
        sp.Piecewise((X * Y, X < 1), (sp.sqrt(X), True)),
        sp.Integer(7),
    ],
    ids=str,
)
def test_derivatives_are_those_of_sympy(expression: sp.Expr) -> None:
    """The very same expression, so that the code does not change with the way it is found."""
    for symbol in (X, Y, sp.Symbol("elsewhere")):
        assert g.derivative(expression, symbol) == sp.diff(expression, symbol)


def test_the_base_of_a_power_stays_whole() -> None:
    """It has a name already; SymPy's ``diff`` multiplies a number into one of the sums."""
    base = X**2 * Y + Y
    by_y = g.derivative(base**2, Y)
    assert base in by_y.args and X**2 + 1 in by_y.args
    assert sp.expand(by_y - sp.diff(base**2, Y)) == 0
