"""Binding: the quantities of one spec entry become symbols, vertices and run-time arguments.

Input: a validated ``Spec`` and one of its entries. Output: a ``BoundEntry`` that holds what the
equation reads (``Bound``), where each symbol is loaded from, and the error sources whose
derivatives are wanted.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy as sp

from symnav import units
from symnav.blocks import (
    Block,
    GeodeticBlock,
    HeadingBlock,
    RotationBlock,
    Value,
    connecting,
    frame_map,
)
from symnav.equations.bound import Bound
from symnav.errors import EquationError
from symnav.frames.rotations import homogeneous_entries
from symnav.graph import Graph, Row, identity
from symnav.quantities import Quantity, Rotation, constant, number
from symnav.spec.records import (
    BySlot,
    BySystem,
    Entry,
    Input,
    Spec,
    ToConstant,
    ToInput,
    ToState,
)

STATE = "x"


@dataclass(frozen=True)
class Origin:
    """Where the value of a symbol is loaded from.

    Attributes:
        argument: name of the run-time argument.
        index: element; the first of the block where a slot chooses.
        slot: symbol of the slot, or None.
    """

    argument: str
    index: int
    slot: sp.Symbol | None = None


@dataclass(frozen=True)
class Source:
    """An error whose Jacobian columns are wanted.

    Attributes:
        vertex: in the graph.
        name: of the state block or input.
        state: True for a state block.
        start: first column: in the error vector, or 0 for an input.
        size: number of columns.
        slot: symbol of the run-time slot that is added to ``start``, or None.
    """

    vertex: str
    name: str
    state: bool
    start: int
    size: int
    slot: sp.Symbol | None = None


@dataclass
class Arguments:
    """Symbols of the state and of the inputs, made when first asked for.

    It is also the nominal state that blocks read (``blocks.Nominal``).
    """

    spec: Spec
    graph: Graph
    origins: dict[sp.Symbol, Origin] = field(default_factory=dict)
    sources: dict[str, Source] = field(default_factory=dict)
    inputs: dict[str, Input] = field(default_factory=dict)
    uses_state: bool = False
    _values: dict[str, Value] = field(default_factory=dict)
    _storage: dict[str, Row] = field(default_factory=dict)

    def symbols_of(self, name: str) -> Row:
        """Symbols of the stored elements of a state block; made once."""
        if name not in self._storage:
            place = self.spec.layout.places[name]
            self._storage[name] = self._symbols(place.block, STATE, place.start, item=False)
            self.uses_state = True
        return self._storage[name]

    def state(self, name: str, *, active: bool = True) -> Value:
        """The value of a state block; attached once."""
        key = f"{STATE}.{name}"
        if key not in self._values:
            place = self.spec.layout.places[name]
            symbols = self.symbols_of(name)
            source = None
            if active:
                source = self._source(name, place.block.error_size, True, place.error_start)
            self._values[key] = place.block.attach(self.graph, symbols, source, self)
        return self._values[key]

    def input(self, name: str, *, active: bool = False, raw: bool = False) -> Value:
        """The value of an input; ``raw`` gives stored elements with an additive error."""
        if name not in self._values:
            declared = self.spec.inputs[name]
            self.inputs[name] = declared
            block = declared.block
            symbols = self._symbols(block, name, 0, item=declared.item)
            size = block.storage_size if raw else block.error_size
            source = self._source(name, size, False, 0) if active else None
            if raw:
                if source is not None:
                    self.graph.attach(name, symbols, size, {source: identity(size)})
                self._values[name] = Quantity(self.graph, symbols, units.ONE)
            else:
                self._values[name] = block.attach(self.graph, symbols, source, self)
        return self._values[name]

    def integer(self, name: str) -> sp.Symbol:
        """The symbol of an integer item input: a system code or a slot."""
        value = self.input(name)
        assert isinstance(value, Quantity)
        symbol = value.elements[0]
        assert isinstance(symbol, sp.Symbol)
        return symbol

    def slotted(self, binding: BySlot) -> Quantity:
        """The element of a state block that the item's slot chooses."""
        place = self.spec.layout.places[binding.block]
        slot = self.integer(binding.slot)
        (symbol,) = self.graph.argument([f"{binding.block}_of_item"], item=True)
        self.origins[symbol] = Origin(STATE, place.start, slot)
        self.uses_state = True
        source = self._source(binding.block, 1, True, place.error_start, slot)
        self.graph.attach(f"{binding.block}_element", [symbol], 1, {source: identity(1)})
        return Quantity(self.graph, (symbol,), units.parse(place.block.units[0]))

    def selected(self, name: str, binding: BySystem) -> Quantity:
        """The scalar of the item's satellite system: sum of [system = k] b_k."""
        code = self.integer(binding.selector)
        terms: list[sp.Expr] = []
        found: set[units.Unit] = set()
        for k, (system, choice) in enumerate(binding.choices):
            value = self.state(choice.block) if isinstance(choice, ToState) else (
                self.input(choice.name)
            )  # fmt: skip
            assert isinstance(value, Quantity)
            found.add(value.unit)
            indicator = sp.Piecewise((sp.Integer(1), sp.Eq(code, k)), (sp.Integer(0), True))
            (weight,) = self.graph.define(f"is_{system}", [indicator])
            terms.append(weight * value.elements[0])
        if len(found) != 1:
            listed = " and ".join(sorted(map(str, found)))
            raise EquationError(f"the systems of {name} are in {listed}; one unit is needed")
        return Quantity(self.graph, self.graph.let(name, [sp.Add(*terms)]), found.pop())

    def matrix_between(self, source: str, target: str) -> Row:
        """Nine entries of the rotation from ``source`` to ``target`` (``blocks.Nominal``)."""
        layout, inputs = self.spec.layout, self.spec.inputs
        shared = [given.block for given in inputs.values() if not given.item]
        found = connecting(layout.blocks, shared, source, target)
        if len(found) != 1:
            count = "several rotations connect" if found else "no rotation block or input connects"
            raise EquationError(f"{count} frames {source!r} and {target!r}")
        name = found[0].name
        own = name in layout.places
        rotation = self.state(name, active=False) if own else self.input(name)
        assert isinstance(rotation, Rotation)
        m = rotation.matrix
        if rotation.source == source:
            return m
        return tuple(m[3 * j + i] for i in range(3) for j in range(3))

    def _symbols(self, block: Block, argument: str, start: int, *, item: bool) -> Row:
        names = [f"{block.name}_{label}" if label else block.name for label in block.storage_labels]
        symbols = self.graph.argument(names, item=item)
        self.origins.update({s: Origin(argument, start + i) for i, s in enumerate(symbols)})
        return symbols

    def _source(
        self, name: str, size: int, state: bool, start: int, slot: sp.Symbol | None = None
    ) -> str:
        vertex = self.graph.source(f"error of {name}", size).name
        self.sources[vertex] = Source(vertex, name, state, start, size, slot)
        return vertex


@dataclass(frozen=True)
class BoundEntry:
    """What the derivation of one entry starts from."""

    entry: Entry
    bound: Bound
    arguments: Arguments


def bind(spec: Spec, entry: Entry, frames: Mapping[str, str], graph: Graph) -> BoundEntry:
    """Bind every quantity of an entry; rotations first, so that error frames find them.

    Args:
        spec: the whole specification.
        entry: the measurement or correction.
        frames: frame role -> name of the user's frame.
        graph: an empty graph.
    """
    arguments = Arguments(spec, graph)
    wanted = set(entry.jacobian_inputs)
    values: dict[str, Value] = {}
    domains: dict[str, tuple[tuple[float, float], ...]] = {}
    for name in sorted(entry.bindings, key=lambda key: not _is_rotation(spec, entry, key)):
        binding = entry.bindings[name]
        active = name in entry.model.differentiated or (
            isinstance(binding, ToInput) and binding.name in wanted
        )
        values[name] = _value(arguments, entry, name, frames, active)
        domains[name] = _domain(spec, entry, name)
    ordered = {name: values[name] for name in entry.bindings}
    bound = Bound(graph, entry.options, ordered, frames, domains)
    return BoundEntry(entry, bound, arguments)


def _value(
    arguments: Arguments, entry: Entry, name: str, frames: Mapping[str, str], active: bool
) -> Value:
    binding = entry.bindings[name]
    raw = _role_kind(entry, name) == "geodetic"
    if isinstance(binding, ToState):
        return arguments.state(binding.block)
    if isinstance(binding, ToInput):
        return arguments.input(binding.name, active=active, raw=raw)
    if isinstance(binding, BySystem):
        return arguments.selected(name, binding)
    if isinstance(binding, BySlot):
        return arguments.slotted(binding)
    return _constant(arguments.graph, entry, name, binding, frames)


def _constant(
    graph: Graph, entry: Entry, name: str, binding: ToConstant, frames: Mapping[str, str]
) -> Value:
    role = entry.model.role(name)
    if role.kind == "rotation":
        source, target = (frames[end] for end in frame_map(role.frame))
        q = [number(v) for v in binding.values]
        square = sp.Add(*(e * e for e in q))
        matrix = tuple(entry_ / square for entry_ in homogeneous_entries(tuple(q)))
        return Rotation(graph, name, source, target, matrix)
    frame = frames.get(role.frame) if len(binding.values) == 3 and role.frame else None
    return constant(graph, binding.values, units.parse(role.units[0]), frame)


def _domain(spec: Spec, entry: Entry, name: str) -> tuple[tuple[float, float], ...]:
    binding = entry.bindings[name]
    if isinstance(binding, ToConstant):
        return tuple((v, v) for v in binding.values)
    if isinstance(binding, ToState):
        block = spec.layout.places[binding.block].block
    elif isinstance(binding, ToInput):
        block = spec.inputs[binding.name].block
    elif isinstance(binding, BySlot):
        block = spec.layout.places[binding.block].block
    else:
        return ()
    return tuple(zip(block.lower, block.upper, strict=True))


def _role_kind(entry: Entry, name: str) -> str:
    return next((role.kind for role in entry.model.roles if role.name == name), "")


def _is_rotation(spec: Spec, entry: Entry, name: str) -> bool:
    binding = entry.bindings[name]
    if isinstance(binding, ToState):
        return isinstance(
            spec.layout.places[binding.block].block, (RotationBlock, HeadingBlock, GeodeticBlock)
        )
    if isinstance(binding, ToInput):
        return isinstance(spec.inputs[binding.name].block, (RotationBlock, HeadingBlock))
    return _role_kind(entry, name) == "rotation"


__all__ = ["STATE", "Arguments", "BoundEntry", "Origin", "Source", "bind"]
