"""Trial evaluation: an equation over the declared blocks, without errors or Jacobians.

It finds units, sizes and frames that do not fit while the specification can still say where, and
what an equation's result looks like.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import sympy as sp

from symnav import units
from symnav.blocks import Block, RotationBlock, Value, frame_map
from symnav.equations.bound import Bound, Results
from symnav.equations.model import Model, OptionValue, Role
from symnav.errors import EquationError
from symnav.graph import Graph, Row
from symnav.quantities import Quantity, constant, number
from symnav.spec.records import Binding, BySlot, BySystem, Input, ToConstant, ToInput, ToState


class _NoRotations:
    """Nominal state for blocks that are only attached without an error."""

    def matrix_between(self, source: str, target: str) -> Row:
        """Nothing asks for it here."""
        raise EquationError(f"no rotation connects frames {source!r} and {target!r}")


@dataclass(frozen=True)
class Scope:
    """Everything an equation may read, by name.

    Attributes:
        states: state blocks.
        inputs: complete inputs.
    """

    states: Mapping[str, Block]
    inputs: Mapping[str, Input]

    def block(self, name: str) -> Block:
        """The block of a state or input."""
        return self.states[name] if name in self.states else self.inputs[name].block

    def is_item(self, name: str) -> bool:
        """True when each item has its own value."""
        return name not in self.states and self.inputs[name].item

    def names(self) -> tuple[str, ...]:
        """States, then inputs that are not integers."""
        return (*self.states, *(n for n, given in self.inputs.items() if not given.integer))


@dataclass
class Quantities(Mapping[str, Value]):
    """Values of a scope, attached when first read; remembers what was read."""

    scope: Scope
    graph: Graph
    read: dict[str, Value] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Value:
        if name not in self:
            raise KeyError(name)
        if name not in self.read:
            self.read[name] = attach(self.graph, self.scope.block(name), self.scope.is_item(name))
        return self.read[name]

    def __contains__(self, name: object) -> bool:
        return name in self.scope.names()

    def __iter__(self) -> Iterator[str]:
        return iter(self.scope.names())

    def __len__(self) -> int:
        return len(self.scope.names())


def attach(graph: Graph, block: Block, item: bool, *, raw: bool = False) -> Value:
    """The value of a block over fresh symbols."""
    labels = [f"{block.name}_{label}" if label else block.name for label in block.storage_labels]
    symbols = graph.argument(labels, item=item)
    if raw:
        return Quantity(graph, symbols, units.ONE)
    return block.attach(graph, symbols, None, _NoRotations())


def evaluate(
    model: Model,
    bindings: Mapping[str, Binding],
    options: Mapping[str, OptionValue],
    frames: Mapping[str, str],
    scope: Scope,
) -> Results:
    """The results of a model of the library.

    Raises:
        EquationError: when units or frames do not fit.
    """
    graph = Graph()
    values = {
        name: _value(graph, model.role(name), binding, frames, scope)
        for name, binding in bindings.items()
    }
    domains = {name: _domain(binding, scope) for name, binding in bindings.items()}
    found = model.function(Bound(graph, options, values, frames, domains))
    return results(found)


def results(found: object) -> Results:
    """What an equation returned, as results.

    Raises:
        EquationError: when it is neither a quantity nor results.
    """
    if isinstance(found, Results):
        return found
    if isinstance(found, Quantity):
        return Results({"value": found})
    raise EquationError(f"the equation returns {type(found).__name__}; a Quantity is needed")


def _value(
    graph: Graph, role: Role, binding: Binding, frames: Mapping[str, str], scope: Scope
) -> Value:
    if isinstance(binding, ToState):
        return attach(graph, scope.states[binding.block], False)
    if isinstance(binding, ToInput):
        given = scope.inputs[binding.name]
        return attach(graph, given.block, given.item, raw=role.kind == "geodetic")
    if isinstance(binding, BySystem):
        return _value(graph, role, binding.choices[0][1], frames, scope)
    if isinstance(binding, BySlot):
        (symbol,) = graph.argument([f"{binding.block}_of_item"], item=True)
        return Quantity(graph, (symbol,), units.parse(scope.states[binding.block].units[0]))
    return _constant(graph, role, binding, frames)


def _constant(graph: Graph, role: Role, binding: ToConstant, frames: Mapping[str, str]) -> Value:
    if role.kind in ("rotation", "orientation"):
        source, target = frame_map(role.frame)
        maps = f"{frames[source]} -> {frames[target]}"
        block = RotationBlock(role.name, (), (), "", maps)
        elements: tuple[sp.Expr, ...] = tuple(number(v) for v in binding.values)
        return block.attach(graph, elements, None, _NoRotations())
    frame = frames.get(role.frame) if role.frame else None
    return constant(graph, binding.values, units.parse(role.units[0]), frame)


def _domain(binding: Binding, scope: Scope) -> tuple[tuple[float, float], ...]:
    if isinstance(binding, ToConstant):
        return tuple((v, v) for v in binding.values)
    if isinstance(binding, (ToState, BySlot)):
        block = scope.states[binding.block]
    elif isinstance(binding, ToInput):
        block = scope.inputs[binding.name].block
    else:
        return ()
    return tuple(zip(block.lower, block.upper, strict=True))


__all__ = ["Quantities", "Scope", "attach", "evaluate", "results"]
