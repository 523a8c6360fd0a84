"""Formulas of the sources in double precision, and states without any symmetry."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]

SEEDS = range(6)
ZERO = np.zeros((3, 3))
ONE = np.eye(3)


def generator(seed: int) -> np.random.Generator:
    """The generator of a seed."""
    return np.random.default_rng([17, seed])


def quaternion(rng: np.random.Generator) -> Array:
    """A unit quaternion, scalar first, of either sign."""
    q = rng.standard_normal(4)
    unit: Array = q / np.linalg.norm(q)
    return unit


def matrix(wxyz: ArrayLike) -> Array:
    """The matrix of a quaternion."""
    found: Array = Rotation.from_quat(np.roll(np.asarray(wxyz), -1)).as_matrix()
    return found


def about_up(angle: float) -> Array:
    """Rz: turns vectors by an angle about the third axis."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def skew(a: ArrayLike) -> Array:
    """The matrix of a cross product, skew(a) b = a x b."""
    x, y, z = np.asarray(a)
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def right_jacobian(t: ArrayLike) -> Array:
    """Jr with Exp(t + d) = Exp(t) Exp(Jr d) to first order."""
    vector = np.asarray(t)
    a = float(np.linalg.norm(vector))
    k = skew(vector)
    found: Array = ONE - (1 - np.cos(a)) / a**2 * k + (a - np.sin(a)) / a**3 * k @ k
    return found


def close(actual: ArrayLike, expected: ArrayLike, scale: float = 1.0, ulps: float = 16.0) -> None:
    """Equal but for rounding of numbers of the given size."""
    atol = ulps * np.finfo(float).eps * scale
    np.testing.assert_allclose(np.asarray(actual), np.asarray(expected), rtol=0, atol=atol)
