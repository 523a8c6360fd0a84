"""Retract of every block kind, written again in mpmath, for differences through the manifold.

It shares no code with the symbolic retract: rotations are moved by quaternion exponentials with
full precision and no series.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from mpmath import mp

from symnav.blocks import Block, GeodeticBlock, HeadingBlock, RotationBlock, VectorBlock

Vector = list[Any]
#: Nine entries, row-major, of the rotation from one frame to another at the nominal state.
MatrixBetween = Callable[[str, str], Vector]

_SEMI_MAJOR = mp.mpf(6378137)


def retract(block: Block, x: Sequence[Any], d: Sequence[Any], matrix: MatrixBetween) -> Vector:
    """Stored elements of ``x`` moved by ``d``."""
    if isinstance(block, RotationBlock):
        return _rotation(block, list(x), list(d))
    if isinstance(block, HeadingBlock):
        return [x[0] + d[0]]
    if isinstance(block, GeodeticBlock):
        return _geodetic(block, x, d)
    assert isinstance(block, VectorBlock)
    step = list(d)
    if block.error_sign == "estimate_minus_true":
        step = [-e for e in step]
    if block.error_frame and block.error_frame != block.frame:
        m = matrix(block.error_frame, block.frame)
        step = [sum(m[3 * i + j] * step[j] for j in range(3)) for i in range(3)]
    return [a + b for a, b in zip(x, step, strict=True)]


def rotation_entries(block: RotationBlock, x: Sequence[Any]) -> Vector:
    """Nine entries of the stored rotation: a matrix as it is, a quaternion by sandwich product."""
    if block.storage == "dcm":
        return list(x)
    q = _wxyz(block, list(x))
    inverse = [q[0], -q[1], -q[2], -q[3]]
    columns = []
    for axis in range(3):
        unit = [mp.mpf(0)] * 4
        unit[axis + 1] = mp.mpf(1)
        columns.append(_product(_product(q, unit), inverse)[1:])
    return [columns[j][i] for i in range(3) for j in range(3)]


def _rotation(block: RotationBlock, x: Vector, d: Vector) -> Vector:
    if block.error == "storage":
        return [a + b for a, b in zip(x, d, strict=True)]
    if block.storage == "dcm":
        return _matrix_rotation(block, x, d)
    q = _wxyz(block, x)
    if block.error == "rotation_vector":
        theta = _logarithm(q)
        return _stored(block, _exponential([a + b for a, b in zip(theta, d, strict=True)]))
    if block.error.endswith("_negative"):
        d = [-e for e in d]
    step = _exponential(d)
    moved = _product(step, q) if block.error.startswith("left") else _product(q, step)
    return _stored(block, moved)


def _matrix_rotation(block: RotationBlock, x: Vector, d: Vector) -> Vector:
    """A stored matrix, moved by the matrix of the step on the side of the convention."""
    if block.error.endswith("_negative"):
        d = [-e for e in d]
    plain = RotationBlock("step", (), (), "", maps=block.maps)
    step = rotation_entries(plain, _exponential(d))
    left, right = (step, x) if block.error.startswith("left") else (x, step)
    return [
        sum(left[3 * i + k] * right[3 * k + j] for k in range(3))
        for i in range(3)
        for j in range(3)
    ]


def _geodetic(block: GeodeticBlock, x: Sequence[Any], d: Sequence[Any]) -> Vector:
    """Radii of curvature in their textbook form: N = a/w, M = a(1 - e^2)/w^3."""
    lat, lon, height = x
    f = 1 / mp.mpf("298.257223563")
    e2 = f * (2 - f)
    w = mp.sqrt(1 - e2 * mp.sin(lat) ** 2)
    meridian = _SEMI_MAJOR * (1 - e2) / w**3
    normal = _SEMI_MAJOR / w
    if block.error_axes == "ned":
        north, east, up = d[0], d[1], -d[2]
    else:
        east, north, up = d
    return [
        lat + north / (meridian + height),
        lon + east / ((normal + height) * mp.cos(lat)),
        height + up,
    ]


def _exponential(d: Sequence[Any]) -> Vector:
    angle = mp.sqrt(sum(e * e for e in d))
    if angle == 0:
        return [mp.mpf(1), mp.mpf(0), mp.mpf(0), mp.mpf(0)]
    scale = mp.sin(angle / 2) / angle
    return [mp.cos(angle / 2), *(scale * e for e in d)]


def _logarithm(q: Vector) -> Vector:
    if q[0] < 0:
        q = [-e for e in q]
    sine = mp.sqrt(q[1] ** 2 + q[2] ** 2 + q[3] ** 2)
    if sine == 0:
        return [mp.mpf(0)] * 3
    scale = 2 * mp.atan2(sine, q[0]) / sine
    return [scale * e for e in q[1:]]


def _product(a: Sequence[Any], b: Sequence[Any]) -> Vector:
    """Hamilton product from i^2 = j^2 = k^2 = ijk = -1: scalar and vector parts."""
    av, bv = a[1:], b[1:]
    dot = sum(x * y for x, y in zip(av, bv, strict=True))
    cross = [
        av[1] * bv[2] - av[2] * bv[1],
        av[2] * bv[0] - av[0] * bv[2],
        av[0] * bv[1] - av[1] * bv[0],
    ]
    return [a[0] * b[0] - dot, *(a[0] * bv[i] + b[0] * av[i] + cross[i] for i in range(3))]


def _wxyz(block: RotationBlock, x: Vector) -> Vector:
    return x if block.storage == "wxyz" else [x[3], x[0], x[1], x[2]]


def _stored(block: RotationBlock, q: Vector) -> Vector:
    return q if block.storage == "wxyz" else [q[1], q[2], q[3], q[0]]
