"""Random quantities for the tests of the references, with all digits of the working precision."""

from random import Random
from typing import Any

from mpmath import mp, mpf

from .algebra import Vector, dot, scale
from .blocks import unit


def number(rng: Random, size: float = 1.0) -> mpf:
    """Draw a number between plus and minus ``size``."""
    digits = mp.dps
    return mpf(size) * (mpf(rng.randint(-(10**digits), 10**digits)) / mpf(10) ** digits)


def numbers(rng: Random, count: int = 3, size: float = 1.0) -> Vector:
    """Draw a vector."""
    return [number(rng, size) for _ in range(count)]


def quaternion(rng: Random) -> Vector:
    """Draw a unit quaternion."""
    return unit(numbers(rng, 4))


def on_sphere(rng: Random, radius: float) -> Vector:
    """Draw a point on a sphere."""
    return scale(mpf(radius), unit(numbers(rng, 3)))


def visible(rng: Random, point: Vector, radius: float) -> Vector:
    """Draw a point on a larger sphere, above the horizon of a point."""
    while True:
        candidate = on_sphere(rng, radius)
        if dot(candidate, point) > dot(point, point):
            return candidate


def vector(values: Vector, frame: str | None = None) -> dict[str, Any]:
    """Describe a vector quantity."""
    return {"value": values, "frame": frame}


def far(left: Vector, right: Vector) -> mpf:
    """Give the largest difference between elements."""
    return max(abs(a - b) for a, b in zip(left, right, strict=True))
