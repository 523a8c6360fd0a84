"""Samples inside the declared ranges: random states, and every edge alone and among others.

Half of the samples asked for are random in everything, the other half mix edges of several
quantities with random values. On top comes one sample for every edge of every quantity the
function reads, in which all the rest is random: those are what the fifty-digit comparisons look at
first, because nothing else can hide there what goes wrong.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav.binding import STATE
from symnav.blocks import Block
from symnav.derive import Derivation
from symnav.spec.records import Spec
from symnav.verify.edges import Array, Edge, Rng, edges, error_edges, random_error, random_value
from symnav.verify.scenes import BoundScene, scenes

Indices = NDArray[np.intp]
RANDOM, MIXED = "", "several edges"
#: Comparisons with fifty digits beyond one for every edge.
JUDGED_BEYOND_EDGES = 8


@dataclass(frozen=True)
class Samples:
    """A batch of arguments.

    Attributes:
        arguments: (S, size), or (S, n, size) for item arguments.
        items: n, or None when the function is not mapped.
        labels: of each row of ``flat``: ``RANDOM``, ``MIXED``, or the edge it is there to show.
        integers: arguments that are system codes or slots.
    """

    arguments: Mapping[str, Array]
    items: int | None
    labels: tuple[str, ...]
    integers: frozenset[str] = frozenset()

    def typed(self) -> dict[str, NDArray[Any]]:
        """Arguments as the generated functions want them: selectors and slots as integers."""
        return {
            name: a.astype(np.int32) if name in self.integers else a
            for name, a in self.arguments.items()
        }

    @property
    def count(self) -> int:
        """Number of samples."""
        return len(next(iter(self.arguments.values())))

    def flat(self) -> dict[str, Array]:
        """One row per sample and item: (S * n, size)."""
        if self.items is None:
            return dict(self.arguments)
        n = self.items
        return {
            name: a.reshape(-1, a.shape[-1]) if a.ndim == 3 else np.repeat(a, n, axis=0)
            for name, a in self.arguments.items()
        }

    def judged(self, good: Indices) -> Indices:
        """The rows to compare with fifty digits, among those inside the domain.

        Every edge there is once, then as many random and mixed ones as are to be had up to
        ``JUDGED_BEYOND_EDGES``.

        Args:
            good: rows of ``flat``, ascending.
        """
        chosen: dict[str, list[int]] = {}
        for row in good:
            chosen.setdefault(self.labels[row], []).append(int(row))
        rows = [of[0] for label, of in chosen.items() if label not in (RANDOM, MIXED)]
        mixed = _spread(chosen.get(MIXED, []), JUDGED_BEYOND_EDGES // 2)
        rows += mixed + _spread(chosen.get(RANDOM, []), JUDGED_BEYOND_EDGES - len(mixed))
        return np.array(sorted(rows), dtype=np.intp)


def _spread(rows: list[int], count: int) -> list[int]:
    """At most so many of the rows, from all over."""
    return rows[:: max(1, len(rows) // count)][:count]


@dataclass(frozen=True)
class _Part:
    """One block of one argument.

    Attributes:
        argument: name of the argument.
        place: its elements there.
        block: what they are.
        item: True when every item has its own.
        read: True when the function looks at it.
        moves: elements of the state that it is the error of; None where it is a value.
    """

    argument: str
    place: slice
    block: Block
    item: bool = False
    read: bool = True
    moves: slice | None = None

    @cached_property
    def edges(self) -> tuple[Edge, ...]:
        """Its edges."""
        return edges(self.block) if self.moves is None else error_edges(self.block)

    def random(self, rng: Rng, at: Array) -> Array:
        """Any other value."""
        if self.moves is None:
            return random_value(self.block, rng)
        return random_error(self.block, rng, at)


@dataclass(frozen=True)
class _Alone:
    """A sample in which one part is at one of its edges."""

    part: _Part
    edge: Edge

    @property
    def item(self) -> bool:
        """True when only the first item shows it."""
        return self.part.item

    @property
    def label(self) -> str:
        """What it shows, for people."""
        return f"{self.part.block.name}: {self.edge.name}"


@dataclass(frozen=True)
class _Staged:
    """A sample in which the first item is in a scene of the model."""

    scene: BoundScene
    item: bool

    @property
    def label(self) -> str:
        """What it shows, for people."""
        return f"{self.scene.argument}: {self.scene.name}"


def draw(spec: Spec, derivation: Derivation, count: int, seed: int, items: int = 3) -> Samples:
    """Draw samples for a derivation's arguments.

    The same seed gives the same samples.

    Args:
        spec: for layout and inputs.
        derivation: the function.
        count: random and mixed samples; those of single edges come on top.
        seed: of the random numbers.
        items: of a mapped function, in each sample.
    """
    rng = np.random.default_rng([seed, *map(ord, derivation.name)])
    if derivation.entry is not None and derivation.entry.maximum is not None:
        items = min(items, derivation.entry.maximum)
    parts = list(_parts(spec, derivation))
    staged = scenes(spec, derivation.entry)
    plan = _plan(parts, [s for s in staged if s.name], count, spec)
    arguments = _empty(parts, len(plan), items)
    for k, kind in enumerate(plan):
        for part in parts:
            at = arguments[STATE][k, part.moves] if part.moves is not None else np.empty(0)
            for i in range(items if part.item else 1):
                row = arguments[part.argument][(k, i) if part.item else k]
                row[part.place] = _value(part, kind, i, rng, at)
    integers = {name for name in arguments if name in spec.inputs and spec.inputs[name].integer}
    arguments |= {name: np.round(arguments[name]) for name in integers}
    _stage(staged, plan, arguments, rng)
    mapped = items if derivation.mapped else None
    ordered = {name: arguments[name] for name in derivation.arguments}
    return Samples(ordered, mapped, _labels(plan, mapped), frozenset(integers))


_Kind = str | _Alone | _Staged


def _parts(spec: Spec, derivation: Derivation) -> Iterator[_Part]:
    """Blocks of every argument, the state before the errors that move it."""
    read = {(origin.argument, origin.index) for origin in derivation.origins.values()}
    own = (STATE,) if derivation.entry is not None else (STATE, "d", "y")
    for name in derivation.arguments:
        if name not in own:
            declared = spec.inputs[name]
            whole = slice(0, declared.block.storage_size)
            yield _Part(name, whole, declared.block, item=declared.item)
            continue
        for place in spec.layout.places.values():
            if name == "d":
                yield _Part(name, place.error, place.block, moves=place.storage)
                continue
            elements = range(place.storage.start, place.storage.stop)
            used = any((name, i) in read for i in elements)
            yield _Part(name, place.storage, place.block, read=used)


def _plan(parts: list[_Part], named: list[BoundScene], count: int, spec: Spec) -> list[_Kind]:
    """What each sample is there for."""
    alone = [_Alone(part, edge) for part in parts if part.read for edge in part.edges]
    shown = [_Staged(scene, spec.inputs[scene.argument].item) for scene in named]
    return [*((RANDOM, MIXED)[k % 2] for k in range(count)), *alone, *shown]


def _empty(parts: list[_Part], samples: int, items: int) -> dict[str, Array]:
    sizes: dict[str, tuple[int, ...]] = {}
    for part in parts:
        shape = (samples, items) if part.item else (samples,)
        sizes[part.argument] = (*shape, part.place.stop)
    return {name: np.zeros(shape) for name, shape in sizes.items()}


def _value(part: _Part, kind: _Kind, item: int, rng: Rng, at: Array) -> Array:
    """Elements of one part: its own edge, any edge, or random ones."""
    if isinstance(kind, _Alone):
        if kind.part is part and item == 0:
            return kind.edge.value(rng, at)
    elif kind == MIXED and rng.random() < 0.75:
        choices = part.edges
        return choices[int(rng.integers(len(choices)))].value(rng, at)
    return part.random(rng, at)


def _labels(plan: list[_Kind], items: int | None) -> tuple[str, ...]:
    """One per row; an edge of an item is that of the first item only."""
    found: list[str] = []
    for kind in plan:
        for i in range(items or 1):
            if isinstance(kind, str):
                found.append(kind)
            else:
                found.append(kind.label if i == 0 or not kind.item else RANDOM)
    return tuple(found)


def _stage(
    staged: list[BoundScene], plan: list[_Kind], arguments: dict[str, Array], rng: Rng
) -> None:
    """Scenes where the plan wants them, now and then among other edges; relations everywhere."""
    named = [scene for scene in staged if scene.name]
    for k, kind in enumerate(plan):
        if isinstance(kind, _Staged):
            _play(kind.scene, arguments, k, 0)
        elif kind == MIXED and named and rng.random() < 0.25:
            _play(named[int(rng.integers(len(named)))], arguments, k, 0)
        for scene in staged:
            if not scene.name:
                for i in range(_items(arguments, scene)):
                    _play(scene, arguments, k, i)


def _items(arguments: Mapping[str, Array], scene: BoundScene) -> int:
    target = arguments[scene.argument]
    return target.shape[1] if target.ndim == 3 else 1


def _play(scene: BoundScene, arguments: Mapping[str, Array], sample: int, item: int) -> None:
    """Elements of the scene's input in one sample and item, from the other arguments there."""
    rows = {name: a[sample, item] if a.ndim == 3 else a[sample] for name, a in arguments.items()}
    values = scene.values(rows)
    if values is not None:
        rows[scene.argument][:] = values
