"""Jacobians by eliminating the vertices of a graph.

The chain rule is multiplied out vertex by vertex. Every product that is more than a symbol gets a
name, so that it is computed once. No order of elimination is best for every equation, so a few are
tried and the one with the fewest operations is kept; what depends on an item counts eightfold.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from symnav.graph import ZERO, Definition, Graph, Matrix, element_names, is_multiple, product

#: How much an operation of the item part weighs against one of the shared part.
ITEM_WEIGHT = 8


def jacobian(
    graph: Graph, value: Sequence[sp.Expr], sources: Mapping[str, int]
) -> dict[str, Matrix]:
    """Derivatives of a value by every source, through the cheapest of a few orders.

    Args:
        graph: definitions and vertices; the names the elimination gives are appended.
        value: elements, every one that moves owned by a vertex.
        sources: vertex of each error -> its size.

    Returns:
        vertex of each error -> rows of the derivative.
    """
    edges = _reachable_edges(graph, value)
    inner = [name for name in graph.vertices if name in edges and graph.vertices[name].partials]
    # Forward, backward, and (None) always the vertex that makes the fewest products next.
    orders = (inner, inner[::-1], None)
    best: _Trial | None = None
    for order in orders:
        for names in (False, True):
            limit = None if best is None else best.cost
            trial = _eliminate(graph, edges, order, names_multiples=names, limit=limit)
            if best is None or trial.cost < best.cost:
                best = trial
            if not trial.met_multiple:
                break
    assert best is not None
    graph.adopt(best.definitions)
    return {
        name: best.edges[_TARGET].get(name, tuple((ZERO,) * size for _ in value))
        for name, size in sources.items()
    }


_TARGET = "the value"


def _reachable_edges(graph: Graph, value: Sequence[sp.Expr]) -> dict[str, dict[str, Matrix]]:
    """Partials of every vertex the value depends on, keyed by vertex and parent."""
    edges = {_TARGET: graph.local_partials(value)}
    waiting = list(edges[_TARGET])
    while waiting:
        name = waiting.pop()
        if name not in edges:
            edges[name] = dict(graph.vertices[name].partials)
            waiting += edges[name]
    return edges


@dataclass
class _Trial:
    """One elimination: the edges left, the names given and what they cost.

    ``names_multiples`` gives a number times a symbol a name, so that it is multiplied once; where
    ``met_multiple`` stays false, doing so changes nothing.
    """

    graph: Graph
    edges: dict[str, dict[str, Matrix]]
    names_multiples: bool
    definitions: list[Definition] = field(default_factory=list)
    cost: int = 0
    met_multiple: bool = False
    _known: dict[sp.Expr, sp.Expr] = field(default_factory=dict)
    _items: set[sp.Symbol] = field(default_factory=set)
    _taken: set[str] = field(default_factory=set)

    def atom(self, name: str, expression: sp.Expr) -> sp.Expr:
        """The expression itself when it is as good as a symbol, otherwise its name."""
        if expression.is_Symbol or expression.is_Number:
            return expression
        if _is_atomic(expression):
            multiple = is_multiple(expression)
            self.met_multiple |= multiple
            if not (multiple and self.names_multiples):
                return expression
        if expression in self._known:
            return self._known[expression]
        if -expression in self._known:
            return -self._known[-expression]
        item = self.graph.is_item(expression) or not self._items.isdisjoint(expression.free_symbols)
        symbol = sp.Symbol(self.graph.free_name(name, self._taken))
        self._known[expression] = symbol
        if item:
            self._items.add(symbol)
        self.definitions.append(Definition(symbol, expression, item))
        self.cost += operations(expression) * (ITEM_WEIGHT if item else 1)
        return symbol


def _eliminate(
    graph: Graph,
    edges: Mapping[str, Mapping[str, Matrix]],
    order: Sequence[str] | None,
    *,
    names_multiples: bool,
    limit: int | None,
) -> _Trial:
    """One elimination, given up as soon as it costs as much as ``limit``."""
    trial = _Trial(graph, {name: dict(parents) for name, parents in edges.items()}, names_multiples)
    trial._known.update({d.expression: d.symbol for d in graph.definitions})
    for name, parents in trial.edges.items():
        for parent, matrix in parents.items():
            parents[parent] = _name_entries(trial, name, parent, matrix)
    remaining = list(order) if order is not None else _inner(graph, trial.edges)
    while remaining and (limit is None or trial.cost < limit):
        vertex = remaining.pop(0) if order is not None else _pop_cheapest(trial, remaining)
        _eliminate_vertex(trial, vertex)
    return trial


def _inner(graph: Graph, edges: Mapping[str, Mapping[str, Matrix]]) -> list[str]:
    return [name for name in edges if name != _TARGET and graph.vertices[name].partials]


def _pop_cheapest(trial: _Trial, remaining: list[str]) -> str:
    best = min(remaining, key=lambda name: _growth(trial, name))
    remaining.remove(best)
    return best


def _growth(trial: _Trial, name: str) -> int:
    """Products that eliminating a vertex now would make."""
    inward = sum(_non_trivial(matrix) for matrix in trial.edges[name].values())
    outward = sum(
        _non_trivial(parents[name]) for parents in trial.edges.values() if name in parents
    )
    return inward * outward


def _non_trivial(matrix: Matrix) -> int:
    return sum(1 for row in matrix for e in row if not e.is_number)


def _eliminate_vertex(trial: _Trial, vertex: str) -> None:
    parents = trial.edges.pop(vertex)
    for successor, edges in trial.edges.items():
        if vertex not in edges:
            continue
        outer = edges.pop(vertex)
        for parent, inner in parents.items():
            chained = product(outer, inner)
            if parent in edges:
                chained = tuple(
                    tuple(a + b for a, b in zip(r, s, strict=True))
                    for r, s in zip(edges[parent], chained, strict=True)
                )
            edges[parent] = _name_entries(trial, successor, parent, chained)


def _name_entries(trial: _Trial, child: str, parent: str, matrix: Matrix) -> Matrix:
    stem = f"{_label(child)}_by_{_label(parent)}"
    rows = element_names("", len(matrix)) if len(matrix) > 1 else ("",)
    columns = element_names("", len(matrix[0])) if len(matrix[0]) > 1 else ("",)
    places = [(i, j) for i in range(len(rows)) for j in range(len(columns))]
    if len(rows) == len(columns) == 3:
        places = [*_CYCLIC, *(place for place in places if place not in _CYCLIC)]
    named = {(i, j): trial.atom(f"{stem}{rows[i]}{columns[j]}", matrix[i][j]) for i, j in places}
    return tuple(tuple(named[i, j] for j in range(len(columns))) for i in range(len(rows)))


_CYCLIC = ((2, 1), (0, 2), (1, 0))
"""Where the cross-product matrix [h]x holds +h_x, +h_y and +h_z.

Named first, the elements of a product with such a matrix are differences of the same form, row
after row: easier to check against the equation, and the compiler can compute several at once.
"""


def _label(vertex: str) -> str:
    if vertex == _TARGET:
        return "value"
    return vertex.removeprefix("error of ").replace(" ", "_")


def _is_atomic(e: sp.Expr) -> bool:
    """A number, a symbol, a number times a symbol, or a symbol over another.

    What is over a symbol stays without a name, so that a later product can cancel the divisor:
    an interval that a bias is multiplied by and a force divided by leaves no trace.
    """
    if e.is_number:
        return True
    factors = [f for f in sp.Mul.make_args(e) if not f.is_number]
    above = sum(1 for f in factors if f.is_Symbol)
    below = sum(1 for f in factors if f.is_Pow and f.exp == -1 and f.base.is_Symbol)
    return above <= 1 and below <= 1 and above + below == len(factors)


def operations(expression: sp.Expr) -> int:
    """Arithmetic operations of an expression as it stands; signs are free inside sums."""
    count = 0
    for node in sp.preorder_traversal(expression):
        if node.is_Add:
            count += len(node.args) - 1
        elif node.is_Mul:
            factors = len(node.args) - (1 if node.args[0] == -1 else 0)
            count += max(factors - 1, 0)
        elif node.is_Pow or node.is_Function:
            count += 1
    return count
