"""Samples inside the declared ranges: random ones, edges and singular neighbourhoods.

Every block kind knows its own edges: identity, yaw only, half turns and negated quaternions for a
rotation, zero and the ends of the range for a vector, the wrap for an angle, the poles for a
geodetic point. Satellites are also placed exactly above and below the antenna.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav.binding import STATE
from symnav.blocks import Block, GeodeticBlock, HeadingBlock, RotationBlock
from symnav.derive import Derivation
from symnav.spec.records import Spec, ToInput, ToState

Array = NDArray[np.float64]
Rng = np.random.Generator

#: How many of the samples are edges rather than random: every second one.
EDGE_EVERY = 2


@dataclass(frozen=True)
class Samples:
    """A batch of arguments.

    Attributes:
        arguments: (S, size), or (S, n, size) for item arguments.
        items: n, or None when the function is not mapped.
        integers: arguments that are system codes or slots.
    """

    arguments: Mapping[str, Array]
    items: int | None
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


def draw(spec: Spec, derivation: Derivation, count: int, seed: int, items: int = 3) -> Samples:
    """Draw ``count`` samples for a derivation's arguments.

    The same seed gives the same samples.
    """
    rng = np.random.default_rng([seed, *map(ord, derivation.name)])
    mapped = derivation.mapped
    if derivation.entry is not None and derivation.entry.maximum is not None:
        items = min(items, derivation.entry.maximum)
    arguments: dict[str, Array] = {}
    for name in derivation.arguments:
        if name == STATE or (derivation.entry is None and name == "y"):
            blocks = [place.block for place in spec.layout.places.values()]
            arguments[name] = np.stack([_state(blocks, rng, k) for k in range(count)])
        elif derivation.entry is None and name == "d":
            arguments[name] = np.stack([_error(spec, rng, k) for k in range(count)])
        elif spec.inputs[name].item:
            block = spec.inputs[name].block
            rows = [[_one(block, rng, k + i) for i in range(items)] for k in range(count)]
            arguments[name] = np.array(rows)
        else:
            block = spec.inputs[name].block
            arguments[name] = np.stack([_one(block, rng, k) for k in range(count)])
    _make_physical(spec, derivation, arguments)
    integers = {name for name in arguments if name in spec.inputs and spec.inputs[name].integer}
    arguments |= {name: np.round(arguments[name]) for name in integers}
    return Samples(arguments, items if mapped else None, frozenset(integers))


def _state(blocks: Sequence[Block], rng: Rng, k: int) -> Array:
    return np.concatenate([_one(block, rng, k) for block in blocks])


def _one(block: Block, rng: Rng, k: int) -> Array:
    """Elements of one block: random, or now and then one of its edges."""
    if k % EDGE_EVERY == 0 or rng.random() < 0.25:
        return random_value(block, rng)
    choices = edges(block)
    return choices[int(rng.integers(len(choices)))](rng)


def random_value(block: Block, rng: Rng) -> Array:
    """A random value inside the domain: uniform, or small by a random power of ten."""
    if isinstance(block, RotationBlock):
        return _stored(block, _unit(rng.normal(size=4)))
    lower, upper = _bounds(block)
    value = rng.uniform(lower, upper)
    if rng.random() < 0.3:
        value = np.clip(value * 10.0 ** rng.uniform(-9.0, 0.0, value.size), lower, upper)
    return value


def edges(block: Block) -> list[Callable[[Rng], Array]]:
    """Generators of the block's edge values."""
    if isinstance(block, RotationBlock):
        # An additive rotation vector has no neighbourhood at a half turn.
        turns = [q for q in _ROTATIONS if q is not _half_turn or block.error != "rotation_vector"]
        return [lambda rng, q=q: _stored(block, q(rng)) for q in turns]  # type: ignore[misc]
    lower, upper = _bounds(block)
    middle = np.clip(np.zeros_like(lower), lower, upper)
    values = [middle, lower, upper, np.clip(middle + 1e-12, lower, upper)]
    if isinstance(block, HeadingBlock):
        values += [np.clip(v, lower, upper) for v in (np.array([np.pi]), np.array([-np.pi / 2]))]
    if isinstance(block, GeodeticBlock):
        pole = np.array([upper[0], 0.3, middle[2]])
        values += [pole, np.array([lower[0], -2.0, middle[2]])]
        values += [np.array([0.7, np.pi - 1e-9, middle[2]])]
    return [lambda rng, v=v: v.copy() for v in values]  # type: ignore[misc]


def _half_turn(rng: Rng) -> Array:
    row: Array = np.eye(4)[1 + int(rng.integers(3))]
    return row


_ROTATIONS: tuple[Callable[[Rng], Array], ...] = (
    lambda rng: np.array([1.0, 0.0, 0.0, 0.0]),
    lambda rng: -np.array([1.0, 0.0, 0.0, 0.0]),
    lambda rng: _axis_angle(np.array([0.0, 0.0, 1.0]), rng.uniform(-np.pi, np.pi)),
    _half_turn,
    lambda rng: -_unit(rng.normal(size=4)),
    lambda rng: _axis_angle(rng.normal(size=3), 1e-9),
    lambda rng: _axis_angle(rng.normal(size=3), np.pi - 1e-6),
)


def _error(spec: Spec, rng: Rng, k: int) -> Array:
    """An error vector: moderate, tiny, zero, or with rotations close to a half turn."""
    parts = []
    for place in spec.layout.places.values():
        block, size = place.block, place.block.error_size
        bound = 1.0 if block.units[1] == "rad" else 100.0
        part = rng.uniform(-bound, bound, size) * (1.0, 1e-9, 0.0, 1.0)[k % 4]
        if isinstance(block, RotationBlock) and block.error not in ("storage", "rotation_vector"):
            direction = rng.normal(size=3)
            if k % 4 == 3:
                part = direction / np.linalg.norm(direction) * (np.pi - 1e-6)
        elif isinstance(block, RotationBlock):
            part = part * 0.1
        parts.append(part)
    return np.concatenate(parts)


def _make_physical(spec: Spec, derivation: Derivation, arguments: dict[str, Array]) -> None:
    """Relations between inputs that hold in use, and geometry worth testing."""
    entry = derivation.entry
    if entry is None:
        return
    names = {role: b.name for role, b in entry.bindings.items() if isinstance(b, ToInput)}
    if "reference_range" in names and "satellite_difference" in names:
        d = arguments[names["satellite_difference"]]
        short = np.linalg.norm(d, axis=-1, keepdims=True) < 1e6
        d = np.where(short, d + 2.0e7, d)
        arguments[names["satellite_difference"]] = d
        arguments[names["reference_range"]] = np.linalg.norm(d, axis=-1, keepdims=True)
    position = entry.bindings.get("position")
    if "satellite_position" in names and isinstance(position, ToState):
        place = spec.layout.places[position.block]
        if place.block.storage_size == 3 and not isinstance(place.block, GeodeticBlock):
            _overhead(arguments, names["satellite_position"], place.storage)


def _overhead(arguments: dict[str, Array], satellite: str, place: slice) -> None:
    """Every fourth sample: the first satellite on the line through the receiver."""
    position = arguments[STATE][::4, place]
    length = np.linalg.norm(position, axis=1, keepdims=True)
    up = np.array([0.0, 0.0, 1.0])
    direction = np.where(length > 1.0, position / np.maximum(length, 1.0), up)
    arguments[satellite][::4, 0, :] = 2.66e7 * direction


def _bounds(block: Block) -> tuple[Array, Array]:
    return np.array(block.lower, dtype=np.float64), np.array(block.upper, dtype=np.float64)


def _stored(block: RotationBlock, q: Array) -> Array:
    if block.storage == "wxyz":
        return q
    if block.storage == "xyzw":
        return np.roll(q, -1)
    w, v = q[0], q[1:]
    skew = np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])
    matrix = np.eye(3) + 2.0 * w * skew + 2.0 * skew @ skew
    entries: Array = matrix.ravel()
    return entries


def _axis_angle(axis: Array, angle: float) -> Array:
    direction = axis / np.linalg.norm(axis)
    return np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * direction])


def _unit(q: Array) -> Array:
    unit: Array = q / np.linalg.norm(q)
    return unit
