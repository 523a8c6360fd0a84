"""Inputs inside the declared ranges, drawn in the precision of the C under test."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from tests.emit_c.interpreter import Array

Inputs = dict[str, Array]


def draw(
    function: ir.Function, seed: int, n: int = 0, real: type[np.floating] = np.float64
) -> Inputs:
    """One epoch of inputs."""
    generator = np.random.default_rng([seed, len(function.name)])
    drawn: Inputs = {}
    for argument in function.arguments:
        rows = [
            np.concatenate([_domain(generator, domain) for domain in argument.domains])
            for _ in range(n if argument.item else 1)
        ]
        values = np.array(rows).reshape((-1, argument.size)) if rows else np.zeros((0, 1))
        # Rounded to the type of the C, so that both sides see the same numbers.
        drawn[argument.name] = (values if argument.item else values[0]).astype(real).astype(float)
    return drawn


def changed(
    inputs: Mapping[str, Array], name: str, index: int | tuple[int, int], to: float
) -> Inputs:
    """The same inputs but for one element."""
    copy = {key: value.copy() for key, value in inputs.items()}
    copy[name][index] = to
    return copy


def _domain(generator: np.random.Generator, domain: ir.Domain) -> NDArray[np.float64]:
    if domain.kind is ir.Kind.QUATERNION:
        direction = generator.normal(size=4)
        return np.asarray(direction / np.linalg.norm(direction))
    if domain.kind is ir.Kind.MATRIX:
        return np.asarray(np.linalg.qr(generator.normal(size=(3, 3)))[0].ravel())
    if domain.kind is ir.Kind.INTEGER:
        low, high = int(domain.lower[0]), int(domain.upper[0])
        return generator.integers(low, high + 1, domain.size).astype(float)
    lower, upper = np.array(domain.lower), np.array(domain.upper)
    return np.asarray(lower + (upper - lower) * generator.uniform(0.02, 0.98, domain.size))
