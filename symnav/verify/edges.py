"""Values of a block that deserve a look of their own: random ones, and its edges by name.

Every block kind knows its edges: identity, yaw only, half turns and negated quaternions for a
rotation; zero, the ends of the range and the neighbourhood of zero for a vector; the wrap for an
angle; the ends of the meridian and the date line for a geodetic point. Errors have edges as well:
none at all, a tiny one, and almost half a turn.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from symnav.blocks import Block, GeodeticBlock, HeadingBlock, RotationBlock

Array = NDArray[np.float64]
Rng = np.random.Generator


@dataclass(frozen=True)
class Edge:
    """A kind of value.

    Attributes:
        name: in a few words.
        value: makes one; for an error, given the value that it moves.
    """

    name: str
    value: Callable[[Rng, Array], Array]


def random_value(block: Block, rng: Rng) -> Array:
    """A random value inside the domain: uniform, or small by a random power of ten."""
    if isinstance(block, RotationBlock):
        return _stored(block, _unit(rng.normal(size=4)))
    lower, upper = _bounds(block)
    part = rng.random(lower.size)
    # Not lower + part (upper - lower): the width of the widest range is beyond every double.
    value = np.clip(lower * (1.0 - part) + upper * part, lower, upper)
    if rng.random() < 0.3:
        value = np.clip(value * 10.0 ** rng.uniform(-9.0, 0.0, value.size), lower, upper)
    return value


def edges(block: Block) -> tuple[Edge, ...]:
    """The block's edges; where the range lets several coincide, the first of them."""
    if isinstance(block, RotationBlock):
        # An additive rotation vector has no neighbourhood at a half turn.
        turns = [e for e in _ROTATIONS if e is not _HALF_TURN or block.error != "rotation_vector"]
        return tuple(
            Edge(e.name, lambda rng, at, e=e: _stored(block, e.value(rng, at)))  # type: ignore[misc]
            for e in turns
        )
    found: dict[tuple[float, ...], str] = {}
    for name, value in _points(block):
        found.setdefault(tuple(value), name)
    return tuple(
        Edge(name, lambda _rng, _at, v=value: np.array(v))  # type: ignore[misc]
        for value, name in found.items()
    )


def _points(block: Block) -> Iterator[tuple[str, Array]]:
    """Edges that are single points, zero being the value nearest to it."""
    lower, upper = _bounds(block)
    zero = np.clip(np.zeros_like(lower), lower, upper)
    yield "zero", zero
    yield "lower end", lower
    yield "upper end", upper
    yield "almost zero", np.clip(zero + 1e-12, lower, upper)
    if isinstance(block, HeadingBlock):
        yield "half turn", np.clip(np.array([np.pi]), lower, upper)
        yield "quarter turn", np.clip(np.array([-np.pi / 2]), lower, upper)
    if isinstance(block, GeodeticBlock):
        yield "northern end", np.array([upper[0], np.clip(0.3, lower[1], upper[1]), zero[2]])
        yield "southern end", np.array([lower[0], np.clip(-2.0, lower[1], upper[1]), zero[2]])
        yield "date line", np.clip(np.array([0.7, np.pi - 1e-9, zero[2]]), lower, upper)


def random_error(block: Block, rng: Rng, at: Array) -> Array:
    """A moderate error of the value ``at``, seldom beyond the block's range."""
    error = rng.uniform(-1.0, 1.0, block.error_size)
    if isinstance(block, RotationBlock):
        return 0.1 * error if block.error == "storage" else _one_to_one(block, at, error)
    if block.units[1] == "rad":
        return error
    lower, upper = _bounds(block)
    width = 1e4 if isinstance(block, GeodeticBlock) else upper / 2.0 - lower / 2.0
    moderate: Array = error * np.minimum(100.0, 0.02 * width)
    return moderate


def error_edges(block: Block) -> tuple[Edge, ...]:
    """Edges of the block's error."""
    size = block.error_size
    found = [
        Edge("no error", lambda _rng, _at: np.zeros(size)),
        Edge("tiny error", lambda rng, at: 1e-9 * random_error(block, rng, at)),
    ]
    if isinstance(block, RotationBlock) and block.error not in ("storage", "rotation_vector"):
        almost = np.pi - 1e-6
        found.append(
            Edge("error of almost half a turn", lambda rng, _at: almost * _unit(rng.normal(size=3)))
        )
    return tuple(found)


def _one_to_one(block: RotationBlock, at: Array, error: Array) -> Array:
    """The error shortened so that it is also the one that leads back.

    Rotation vectors that are added stay below half a turn together: |Log(R)| + |d| < pi.
    """
    if block.error != "rotation_vector":
        return error
    scalar = at[0] if block.storage == "wxyz" else at[3]
    room = np.pi - 2.0 * np.arccos(min(abs(scalar), 1.0))
    shortened: Array = error * min(1.0, 0.5 * room / np.linalg.norm(error))
    return shortened


def _half_turn(rng: Rng, _at: Array) -> Array:
    row: Array = np.eye(4)[1 + int(rng.integers(3))]
    return row


_HALF_TURN = Edge("half turn", _half_turn)
_ROTATIONS: tuple[Edge, ...] = (
    Edge("identity", lambda _rng, _at: np.array([1.0, 0.0, 0.0, 0.0])),
    Edge("negated identity", lambda _rng, _at: -np.array([1.0, 0.0, 0.0, 0.0])),
    Edge(
        "yaw only",
        lambda rng, _at: _axis_angle(np.array([0.0, 0.0, 1.0]), rng.uniform(-np.pi, np.pi)),
    ),
    _HALF_TURN,
    Edge("negated quaternion", lambda rng, _at: -_positive(_unit(rng.normal(size=4)))),
    Edge("tiny turn", lambda rng, _at: _axis_angle(rng.normal(size=3), 1e-9)),
    Edge("almost half a turn", lambda rng, _at: _axis_angle(rng.normal(size=3), np.pi - 1e-6)),
)


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
    return np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * _unit(axis)])


def _positive(q: Array) -> Array:
    return q if q[0] > 0.0 else -q


def _unit(v: Array) -> Array:
    unit: Array = v / np.linalg.norm(v)
    return unit
