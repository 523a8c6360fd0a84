"""Inputs inside their declared ranges: anywhere, at the ends, tiny, and on the manifolds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir

Array = NDArray[Any]
Rng = np.random.Generator

TYPES: Mapping[ir.Scalar, Any] = {ir.Scalar.FLOAT: np.float32, ir.Scalar.DOUBLE: np.float64}


def samples(function: ir.Function, scalar: ir.Scalar, count: int, rng: Rng) -> dict[str, Array]:
    """Arguments by name, (count, size) each, every number one of the type and in its range."""
    found: dict[str, Array] = {}
    for argument in function.arguments:
        parts = [_domain(domain, scalar, count, rng) for domain in argument.domains]
        found[argument.name] = np.concatenate(parts, axis=1)
    return found


def moved(
    function: ir.Function, scalar: ir.Scalar, points: Mapping[str, Array], rng: Rng
) -> dict[str, Array]:
    """Every point with some elements a little or entirely elsewhere, still in range."""
    count = len(next(iter(points.values())))
    fresh = samples(function, scalar, count, rng)
    size = sum(argument.size for argument in function.arguments)
    found: dict[str, Array] = {}
    for argument in function.arguments:
        near, far = points[argument.name], fresh[argument.name]
        chance = rng.random(near.shape)
        step = 2.0 ** -rng.uniform(0.0, 26.0, near.shape)
        nudged = near * (1.0 + step * rng.choice([-1.0, 1.0], near.shape))
        values = np.where(chance < 1.0 / size, far, np.where(chance < 4.0 / size, nudged, near))
        parts = [
            _inside(domain, values[:, domain.start : domain.start + domain.size], scalar)
            for domain in argument.domains
        ]
        found[argument.name] = np.concatenate(parts, axis=1)
    return found


def _domain(domain: ir.Domain, scalar: ir.Scalar, count: int, rng: Rng) -> Array:
    shape = (count, domain.size)
    if domain.kind is ir.Kind.QUATERNION:
        return _inside(domain, _quaternions(count, rng), scalar)
    if domain.kind is ir.Kind.MATRIX:
        return _inside(domain, _matrices(_quaternions(count, rng)), scalar)
    low, high = np.array(domain.lower), np.array(domain.upper)
    if domain.kind is ir.Kind.INTEGER:
        return rng.integers(low.astype(int), high.astype(int) + 1, shape).astype(np.float64)
    if domain.kind is ir.Kind.UNREAD:
        return np.zeros(shape)
    low, high = np.maximum(low, -1e300), np.minimum(high, 1e300)
    anywhere = low + (high - low) * rng.random(shape)
    ends = np.where(rng.random(shape) < 0.5, low, high)
    # Within a few thousandths of an end, where magnitudes and so roundings are largest.
    outer = ends * (1.0 - 4e-3 * rng.random(shape))
    small = np.sign(anywhere) * np.abs(ends) * 10.0 ** -rng.uniform(0.0, 12.0, shape)
    # One way for a whole sample more often than one for each element.
    way = np.where(rng.random(shape) < 0.3, rng.random(shape), rng.random((count, 1)))
    values = np.select(
        [way < 0.35, way < 0.5, way < 0.8, way < 0.95], [anywhere, ends, outer, small]
    )
    return _inside(domain, values, scalar)


def _quaternions(count: int, rng: Rng) -> Array:
    """Any attitude, turns about an axis and half turns among them."""
    values = rng.normal(size=(count, 4))
    flat = rng.random((count, 4)) < 0.3 * (rng.random((count, 1)) < 0.4)
    values = np.where(flat, values * 10.0 ** -rng.uniform(1.0, 12.0, (count, 4)), values)
    values[np.all(values == 0.0, axis=1)] = (1.0, 0.0, 0.0, 0.0)
    return values


def _matrices(quaternions: Array) -> Array:
    """Rotations by row."""
    w, x, y, z = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    rows = [
        *(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        *(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        *(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    ]
    return np.stack(rows, axis=1)


def _inside(domain: ir.Domain, values: Array, scalar: ir.Scalar) -> Array:
    """Numbers of the type, in range, of unit norm, orthonormal."""
    if domain.kind is ir.Kind.QUATERNION:
        values = values / np.linalg.norm(values, axis=1, keepdims=True)
    elif domain.kind is ir.Kind.MATRIX:
        left, _, right = np.linalg.svd(values.reshape(-1, 3, 3))
        turn = np.linalg.det(left @ right)
        left[:, :, 2] *= turn[:, None]
        values = (left @ right).reshape(-1, 9)
    elif domain.kind is ir.Kind.INTEGER:
        values = np.rint(values)
    low, high = np.array(domain.lower), np.array(domain.upper)
    kind = TYPES[scalar]
    held = np.clip(values, low, high).astype(kind)
    # Rounding to the type may have left the range: one step back.
    held = np.where(held.astype(np.float64) > high, np.nextafter(held, kind(-np.inf)), held)
    held = np.where(held.astype(np.float64) < low, np.nextafter(held, kind(np.inf)), held)
    return np.asarray(held, dtype=np.float64)
