"""Random but reproducible states: nothing symmetric, nothing at the identity."""

from typing import Any

import numpy as np

from tests.oracles.implementations import Array

SEEDS = range(8)


def generator(seed: int) -> np.random.Generator:
    """Give the generator of a seed."""
    return np.random.default_rng([20, 24, seed])


def quaternion(rng: np.random.Generator) -> Array:
    """Draw a unit quaternion, scalar first, of either sign."""
    q = rng.standard_normal(4)
    unit: Array = q / np.linalg.norm(q)
    return unit


def geodetic(rng: np.random.Generator) -> Array:
    """Draw latitude, longitude and height, away from the poles."""
    return np.array([rng.uniform(-1.5, 1.5), rng.uniform(-3.1, 3.1), rng.uniform(-400, 12000)])


def sphere(rng: np.random.Generator, radius: float) -> Array:
    """Draw a point on a sphere."""
    direction = rng.standard_normal(3)
    point: Array = radius * direction / np.linalg.norm(direction)
    return point


def visible_satellite(rng: np.random.Generator, point: Array) -> Array:
    """Draw a satellite at GPS height above the horizon of a point."""
    while True:
        satellite = sphere(rng, 26.56e6)
        if satellite @ point > 0.3 * 26.56e6 * np.linalg.norm(point):
            return satellite


def vector(values: Any, frame: str | None = None) -> dict[str, Any]:
    """Describe a vector or scalar quantity."""
    return {"value": np.atleast_1d(np.asarray(values, dtype=float)), "frame": frame}


def rotation(wxyz: Array, source: str, target: str) -> dict[str, Any]:
    """Describe a rotation quantity that takes vectors from ``source`` to ``target``."""
    return {"wxyz": wxyz, "maps": (source, target)}
