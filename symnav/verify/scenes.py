"""What a model declares for its samples, evaluated at the other quantities of a sample.

A scene is written over bound quantities, as the equation is; here it becomes numbers, and they
become the elements of the input its role is bound to.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp
from mpmath import mp

from symnav.binding import Origin, bind
from symnav.equations.model import Scene
from symnav.graph import Graph
from symnav.quantities import Quantity
from symnav.spec.records import Entry, Spec, ToInput
from symnav.verify import closures
from symnav.verify.comparison import Array
from symnav.verify.exact import loaded
from symnav.verify.numbers import ManyDigits

DIGITS = 30


@dataclass(frozen=True)
class BoundScene:
    """A scene of one entry of a specification.

    Attributes:
        argument: input that takes its values.
        name: what they are, for people; empty for a relation that always holds.
        origins: where the symbols are loaded from.
        steps: named terms in dependency order.
        elements: of the input.
    """

    argument: str
    name: str
    origins: Mapping[sp.Symbol, Origin]
    steps: tuple[tuple[sp.Symbol, closures.Closure], ...]
    elements: tuple[closures.Closure, ...]

    def values(self, arguments: Mapping[str, Sequence[float]]) -> Array | None:
        """Elements at the arguments of one sample and item; None where there are none."""
        with mp.workdps(DIGITS):
            numbers = {name: [mp.mpf(float(v)) for v in row] for name, row in arguments.items()}
            env = loaded(self.origins, numbers)
            try:
                for symbol, step in self.steps:
                    env[symbol] = step(env)
                return np.array([float(element(env)) for element in self.elements])
            except (ArithmeticError, TypeError):
                return None


def scenes(spec: Spec, entry: Entry | None) -> list[BoundScene]:
    """The scenes of an entry's model whose roles are bound to inputs."""
    if entry is None:
        return []
    found = [_bound(spec, entry, scene) for scene in entry.model.scenes]
    return [scene for scene in found if scene is not None]


def _bound(spec: Spec, entry: Entry, scene: Scene) -> BoundScene | None:
    binding = entry.bindings.get(scene.role)
    if not isinstance(binding, ToInput):
        return None
    graph = Graph()
    bound = bind(spec, entry, entry.frames, graph)
    quantity: Quantity | None = scene.value(bound.bound)
    if quantity is None:
        return None
    system = ManyDigits()
    return BoundScene(
        binding.name,
        scene.name,
        bound.arguments.origins,
        tuple((d.symbol, closures.closure(d.expression, system)) for d in graph.definitions),
        tuple(closures.closure(element, system) for element in quantity.elements),
    )
