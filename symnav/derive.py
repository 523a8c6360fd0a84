"""Derivation: bound equations to values and Jacobians, by eliminating vertices.

Input: a ``Spec``. Output: one ``Derivation`` per entry, and one each for retract and local: named
definitions in dependency order, and outputs whose elements are expressions over them.

The chain rule is multiplied out vertex by vertex. Every product that is more than a symbol gets a
name, so that it is computed once. No order of elimination is best for every equation, so a few are
tried and the one with the fewest operations is kept; what depends on an item counts eightfold.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from symnav.binding import Arguments, BoundEntry, Origin, Source, bind
from symnav.equations.bound import Results
from symnav.errors import EquationError
from symnav.graph import ZERO, Definition, Graph, Matrix, element_names, product, transpose
from symnav.quantities import Quantity
from symnav.spec.records import Entry, Spec

#: How much an operation of the item part weighs against one of the shared part.
ITEM_WEIGHT = 8

Element = tuple[int, int]


@dataclass(frozen=True)
class DerivedOutput:
    """One output of a derivation.

    Attributes:
        name: ``value``, ``jacobian``, ``jacobian_<input>``, ``residual``, or the equation's own.
        kind: ``value`` or ``jacobian``.
        rows: number of rows (elements of the value).
        columns: number of columns; 0 for a value.
        entries: (row, column) -> expression for every structural non-zero.
        slots: columns whose place is shifted by a run-time slot: column -> slot symbol.
        by: name of the input a Jacobian is taken by; empty for the state.
        unit: of a value.
        frame: of a value.
    """

    name: str
    kind: str
    rows: int
    columns: int
    entries: Mapping[Element, sp.Expr]
    slots: Mapping[int, sp.Symbol]
    by: str
    unit: str
    frame: str


@dataclass(frozen=True)
class Derivation:
    """An equation with its Jacobians, ready to be lowered.

    Attributes:
        name: of the generated function.
        entry: the spec entry, or None for retract and local.
        definitions: in dependency order, only those an output or a guard needs.
        outputs: the value first.
        origins: where argument symbols are loaded from.
        arguments: run-time arguments in order; ``x`` first where the state is used.
        mapped: True when evaluated per item.
        equation: definitions of the equation alone, before differentiation, for witnesses.
        item_symbols: argument symbols that differ from item to item.
    """

    name: str
    entry: Entry | None
    definitions: tuple[Definition, ...]
    outputs: tuple[DerivedOutput, ...]
    origins: Mapping[sp.Symbol, Origin]
    arguments: tuple[str, ...]
    mapped: bool
    equation: tuple[Definition, ...]
    item_symbols: frozenset[sp.Symbol]

    def operations(self) -> tuple[int, int]:
        """Structural operation count of the shared and of the item part."""
        return _count(self.definitions, item=False), _count(self.definitions, item=True)


def derive(spec: Spec, entry: Entry, reserved: frozenset[str]) -> Derivation:
    """Derive one measurement or correction.

    Raises:
        EquationError: when units or frames of the equation do not fit.
    """
    graph = Graph(reserved=reserved)
    bound = bind(spec, entry, entry.frames, graph)
    results = entry.model.function(bound.bound)
    if isinstance(results, Quantity):
        results = Results({"value": results})
    values = {
        name: _named_value(graph, name, quantity) for name, quantity in results.outputs.items()
    }
    if entry.residual:
        first = next(iter(results.outputs))
        values["residual"] = bound.bound.vector("measured") - values[first]
    equation = tuple(graph.definitions)
    outputs = _outputs(graph, bound, results, values)
    order = [name for name in _argument_order(spec, bound) if name]
    return Derivation(
        entry.name,
        entry,
        needed(graph.definitions, outputs),
        outputs,
        bound.arguments.origins,
        tuple(order),
        entry.model.mapped,
        equation,
        graph.item_arguments(bound.arguments.origins),
    )


def derive_retract(spec: Spec, reserved: frozenset[str]) -> Derivation:
    """x moved by d, every block by its own rule."""
    return _layout_function(spec, "retract", "d", reserved)


def derive_local(spec: Spec, reserved: frozenset[str]) -> Derivation:
    """The error that leads from x to y."""
    return _layout_function(spec, "local", "y", reserved)


def _layout_function(
    spec: Spec, name: str, second: str, reserved: frozenset[str]
) -> Derivation:
    graph = Graph(reserved=reserved)
    arguments = Arguments(spec, graph)
    values: list[sp.Expr] = []
    for place in spec.layout.places.values():
        block = place.block
        x = arguments.symbols_of(block.name)
        retracting = name == "retract"
        labels = block.error_labels if retracting else block.storage_labels
        start = place.error_start if retracting else place.start
        other = graph.argument([f"{second}_{block.name}_{label}" for label in labels])
        arguments.origins.update({s: Origin(second, start + i) for i, s in enumerate(other)})
        method = block.retract if retracting else block.local
        values += method(graph, x, other, arguments)
    entries = {(i, 0): value for i, value in enumerate(values) if value != ZERO}
    output = DerivedOutput("value", "value", len(values), 0, entries, {}, "", "", "")
    inputs = tuple(sorted(arguments.inputs))
    definitions = needed(graph.definitions, (output,))
    return Derivation(
        name, None, definitions, (output,), arguments.origins, ("x", second, *inputs), False,
        definitions, frozenset(),
    )  # fmt: skip


def _named_value(graph: Graph, name: str, quantity: Quantity) -> Quantity:
    """The output with every element that moves owned by a vertex."""
    if all(e.is_Symbol or not graph.moves(e) for e in quantity.elements):
        return quantity
    elements = graph.let(f"{name}_out", quantity.elements)
    return Quantity(graph, elements, quantity.unit, quantity.frame)


def _outputs(
    graph: Graph, bound: BoundEntry, results: Results, values: Mapping[str, Quantity]
) -> tuple[DerivedOutput, ...]:
    """Values, Jacobians by state and inputs, rates and mapped covariances."""
    outputs = [_value_output(name, quantity) for name, quantity in values.items()]
    first = next(iter(results.outputs))
    sources = bound.arguments.sources
    primary = _jacobian(graph, values[first], sources)
    entry = bound.entry
    layout = bound.arguments.spec.layout
    if any(source.state for source in sources.values()):
        state = [source for source in sources.values() if source.state]
        outputs.append(
            _jacobian_output("jacobian", values[first].size, layout.error_size, state, primary, "")
        )
    for source in sources.values():
        if not source.state and source.name in entry.jacobian_inputs:
            outputs.append(
                _jacobian_output(
                    f"jacobian_{source.name}", values[first].size, source.size, [source], primary,
                    source.name,
                )  # fmt: skip
            )
    for name, rate in results.rates.items():
        by = _source_of(bound, rate.by)
        columns = _jacobian(graph, values[rate.output], {by.vertex: by})[by.vertex]
        per = bound.bound.vector(rate.by).unit
        value = values[rate.output]
        quantity = Quantity(graph, tuple(row[0] for row in columns), value.unit / per, value.frame)
        outputs.append(_value_output(name, quantity))
    for name, mapped in results.covariances.items():
        by = _source_of(bound, mapped.by)
        j = _jacobian(graph, values[first], {by.vertex: by})[by.vertex]
        outputs += _sandwich(graph, name, j, mapped.covariance, values[first])
    return tuple(outputs)


def _value_output(name: str, quantity: Quantity) -> DerivedOutput:
    entries = {(i, 0): e for i, e in enumerate(quantity.elements) if e != ZERO}
    return DerivedOutput(
        name, "value", quantity.size, 0, entries, {}, "", str(quantity.unit), quantity.frame or ""
    )


def _jacobian_output(
    name: str,
    rows: int,
    columns: int,
    sources: Sequence[Source],
    jacobian: Mapping[str, Matrix],
    by: str,
) -> DerivedOutput:
    entries: dict[Element, sp.Expr] = {}
    slots: dict[int, sp.Symbol] = {}
    for source in sources:
        block = jacobian[source.vertex]
        for i, row in enumerate(block):
            for j, e in enumerate(row):
                if e != ZERO:
                    entries[i, source.start + j] = e
        if source.slot is not None:
            slots[source.start] = source.slot
    ordered = dict(sorted(entries.items()))
    return DerivedOutput(name, "jacobian", rows, columns, ordered, slots, by, "", "")


def _sandwich(
    graph: Graph, name: str, j: Matrix, covariance: Quantity, value: Quantity
) -> list[DerivedOutput]:
    """The noise map J and J P J^T."""
    size = len(j[0])
    p = tuple(covariance.elements[i * size : (i + 1) * size] for i in range(size))
    half_flat = [e for row in product(j, p) for e in row]
    half = graph.define(f"{name}_half", half_flat)
    rows = tuple(half[i * size : (i + 1) * size] for i in range(len(j)))
    flat = [e for row in product(rows, transpose(j)) for e in row]
    full = graph.define(f"{name}_out", flat)
    unit = str(value.unit * value.unit)
    entries = {(i, 0): e for i, e in enumerate(full) if e != ZERO}
    return [DerivedOutput(name, "value", len(full), 0, entries, {}, "", unit, "")]


def _source_of(bound: BoundEntry, role: str) -> Source:
    binding = bound.entry.bindings[role]
    name = getattr(binding, "name", getattr(binding, "block", ""))
    for source in bound.arguments.sources.values():
        if source.name == name:
            return source
    raise EquationError(f"{role} must be bound to an input: the equation is differentiated by it")


def _argument_order(spec: Spec, bound: BoundEntry) -> Iterable[str]:
    """The state, shared inputs, item inputs; inputs in the order of the model's roles."""
    used = bound.arguments.inputs
    if bound.arguments.uses_state:
        yield "x"
    ordered = [name for name in spec.inputs if name in used]
    yield from (name for name in ordered if not used[name].item)
    yield from (name for name in ordered if used[name].item)


# -- elimination -------------------------------------------------------------------------------


def _jacobian(
    graph: Graph, value: Quantity, sources: Mapping[str, Source]
) -> dict[str, Matrix]:
    """Derivatives of a value by every source, through the cheapest of a few orders."""
    edges = _reachable_edges(graph, value)
    inner = [name for name in graph.vertices if name in edges and graph.vertices[name].partials]
    # Forward, backward, and (None) always the vertex that makes the fewest products next.
    trials = [_eliminate(graph, edges, order) for order in (inner, inner[::-1], None)]
    best = min(trials, key=lambda trial: trial.cost)
    graph.adopt(best.definitions)
    rows = value.size
    return {
        name: best.edges[_TARGET].get(name, tuple((ZERO,) * source.size for _ in range(rows)))
        for name, source in sources.items()
    }


_TARGET = "the value"


def _reachable_edges(graph: Graph, value: Quantity) -> dict[str, dict[str, Matrix]]:
    """Partials of every vertex the value depends on, keyed by vertex and parent."""
    edges = {_TARGET: graph.local_partials(value.elements)}
    waiting = list(edges[_TARGET])
    while waiting:
        name = waiting.pop()
        if name not in edges:
            edges[name] = dict(graph.vertices[name].partials)
            waiting += edges[name]
    return edges


@dataclass
class _Trial:
    """One elimination: the edges left, the names given and what they cost."""

    graph: Graph
    edges: dict[str, dict[str, Matrix]]
    definitions: list[Definition] = field(default_factory=list)
    cost: int = 0
    _known: dict[sp.Expr, sp.Expr] = field(default_factory=dict)
    _items: set[sp.Symbol] = field(default_factory=set)
    _taken: set[str] = field(default_factory=set)

    def atom(self, name: str, expression: sp.Expr) -> sp.Expr:
        """The expression itself when it is as good as a symbol, otherwise its name."""
        if _is_atomic(expression):
            return expression
        if expression in self._known:
            return self._known[expression]
        if -expression in self._known:
            return -self._known[-expression]
        item = self.graph.is_item(expression) or not self._items.isdisjoint(
            expression.free_symbols
        )
        symbol = sp.Symbol(self.graph.free_name(name, self._taken))
        self._known[expression] = symbol
        if item:
            self._items.add(symbol)
        self.definitions.append(Definition(symbol, expression, item))
        self.cost += operations(expression) * (ITEM_WEIGHT if item else 1)
        return symbol


def _eliminate(
    graph: Graph, edges: Mapping[str, Mapping[str, Matrix]], order: Sequence[str] | None
) -> _Trial:
    trial = _Trial(graph, {name: dict(parents) for name, parents in edges.items()})
    trial._known.update({d.expression: d.symbol for d in graph.definitions})
    for name, parents in trial.edges.items():
        for parent, matrix in parents.items():
            parents[parent] = _name_entries(trial, name, parent, matrix)
    remaining = list(order) if order is not None else _inner(graph, trial.edges)
    while remaining:
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
    return tuple(
        tuple(trial.atom(f"{stem}{r}{c}", e) for c, e in zip(columns, row, strict=True))
        for r, row in zip(rows, matrix, strict=True)
    )


def _label(vertex: str) -> str:
    if vertex == _TARGET:
        return "value"
    return vertex.removeprefix("error of ").replace(" ", "_")


def _is_atomic(e: sp.Expr) -> bool:
    """A number, a symbol, or a number times a symbol."""
    if e.is_Symbol or e.is_number:
        return True
    return bool(e.is_Mul and len(e.args) == 2 and e.args[0].is_number and e.args[1].is_Symbol)


# -- counting and pruning ----------------------------------------------------------------------


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


def _count(definitions: Iterable[Definition], *, item: bool) -> int:
    return sum(operations(d.expression) for d in definitions if d.item == item)


def needed(
    definitions: Sequence[Definition], outputs: Sequence[DerivedOutput]
) -> tuple[Definition, ...]:
    """Definitions that an output or a guard depends on, in order."""
    live: set[sp.Basic] = set()
    for output in outputs:
        for e in output.entries.values():
            live |= e.free_symbols
        live |= set(output.slots.values())
    kept = []
    for definition in reversed(definitions):
        if definition.symbol in live or definition.guard is not None:
            kept.append(definition)
            live |= definition.expression.free_symbols
    return tuple(reversed(kept))

