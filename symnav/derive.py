"""Derivation: bound equations to values and Jacobians, by eliminating vertices.

Input: a ``Spec``. Output: one ``Derivation`` per entry, and one each for retract and local: named
definitions in dependency order, and outputs whose elements are expressions over them.
Values and Jacobians come from one graph; the Jacobians from eliminating its vertices.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from symnav.binding import Arguments, BoundEntry, Origin, Source, bind
from symnav.elimination import jacobian, operations
from symnav.equations.bound import Results
from symnav.errors import EquationError
from symnav.graph import ZERO, Definition, Graph, Matrix, product, transpose
from symnav.quantities import Quantity
from symnav.spec.records import Entry, Spec, ToInput

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
class Equation:
    """The equation before any differentiation, for witnesses that differentiate it their own way.

    Attributes:
        definitions: in dependency order.
        outputs: elements by output name, the one with Jacobians first.
        rates: output name -> (output that is differentiated, source it is differentiated by).
        covariances: output name -> (source, nine elements of the input covariance).
        sources: every error whose derivative is wanted.
        raw: inputs whose stored elements are perturbed directly.
    """

    definitions: tuple[Definition, ...]
    outputs: Mapping[str, tuple[sp.Expr, ...]]
    rates: Mapping[str, tuple[str, Source]]
    covariances: Mapping[str, tuple[Source, tuple[sp.Expr, ...]]]
    sources: tuple[Source, ...]
    raw: frozenset[str]


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
        equation: the equation before differentiation.
        item_symbols: argument symbols that differ from item to item.
    """

    name: str
    entry: Entry | None
    definitions: tuple[Definition, ...]
    outputs: tuple[DerivedOutput, ...]
    origins: Mapping[sp.Symbol, Origin]
    arguments: tuple[str, ...]
    mapped: bool
    equation: Equation
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
    equation = _equation(graph, bound, results, values)
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
    """X moved by d, every block by its own rule."""
    return _layout_function(spec, "retract", "d", reserved)


def derive_local(spec: Spec, reserved: frozenset[str]) -> Derivation:
    """The error that leads from x to y."""
    return _layout_function(spec, "local", "y", reserved)


def _layout_function(spec: Spec, name: str, second: str, reserved: frozenset[str]) -> Derivation:
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
    equation = Equation(definitions, {"value": tuple(values)}, {}, {}, (), frozenset())
    return Derivation(
        name, None, definitions, (output,), arguments.origins, ("x", second, *inputs), False,
        equation, frozenset(),
    )  # fmt: skip


def _equation(
    graph: Graph, bound: BoundEntry, results: Results, values: Mapping[str, Quantity]
) -> Equation:
    entry = bound.entry
    kinds = {role.name: role.kind for role in entry.model.roles}
    return Equation(
        tuple(graph.definitions),
        {name: quantity.elements for name, quantity in values.items()},
        {name: (rate.output, _source_of(bound, rate.by)) for name, rate in results.rates.items()},
        {
            name: (_source_of(bound, mapped.by), mapped.covariance.elements)
            for name, mapped in results.covariances.items()
        },
        tuple(bound.arguments.sources.values()),
        frozenset(
            binding.name
            for name, binding in entry.bindings.items()
            if isinstance(binding, ToInput) and kinds.get(name) == "geodetic"
        ),
    )


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
    primary = _jacobian(graph, values[first], *sources.values())
    entry = bound.entry
    layout = bound.arguments.spec.layout
    if any(source.state for source in sources.values()):
        state = [source for source in sources.values() if source.state]
        outputs.append(
            _jacobian_output("jacobian", values[first].size, layout.error_size, state, primary, "")
        )
    for source in sources.values():
        if not source.state and source.name in entry.jacobian_inputs:
            name = f"jacobian_{source.name}"
            outputs.append(
                _jacobian_output(
                    name, values[first].size, source.size, [source], primary, source.name
                )
            )
    for name, rate in results.rates.items():
        by = _source_of(bound, rate.by)
        columns = _jacobian(graph, values[rate.output], by)[by.vertex]
        per = bound.bound.vector(rate.by).unit
        value = values[rate.output]
        quantity = Quantity(graph, tuple(row[0] for row in columns), value.unit / per, value.frame)
        outputs.append(_value_output(name, quantity))
    for name, mapped in results.covariances.items():
        by = _source_of(bound, mapped.by)
        j = _jacobian(graph, values[first], by)[by.vertex]
        outputs += _sandwich(graph, name, j, mapped.covariance, values[first])
    return tuple(outputs)


def _jacobian(graph: Graph, value: Quantity, *sources: Source) -> dict[str, Matrix]:
    return jacobian(graph, value.elements, {source.vertex: source.size for source in sources})


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
    """The state, shared inputs, item inputs; inputs in the order of the specification.

    Those it declares come first; those it only binds follow as the models name them.
    """
    used = bound.arguments.inputs
    if bound.arguments.uses_state:
        yield "x"
    ordered = [name for name in spec.inputs if name in used]
    yield from (name for name in ordered if not used[name].item)
    yield from (name for name in ordered if used[name].item)


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
