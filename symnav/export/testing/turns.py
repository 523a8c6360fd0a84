"""Quaternions and matrices at the edge of being rotations, for the guards that judge them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.export.arithmetic.evaluation import constant, declared, is_rotation, is_unit, kind_of

Array = NDArray[Any]


@dataclass(frozen=True)
class Turn:
    """Elements of one domain and what its guard says about them.

    Attributes:
        elements: all of the domain.
        accepted: whether the guard lets them pass.
    """

    elements: tuple[float, ...]
    accepted: bool


def turns(domain: ir.Domain, scalar: ir.Scalar) -> list[Turn]:
    """Elements that are no rotation, each in another way, and neighbours across the tolerance.

    Args:
        domain: a quaternion or a matrix.
        scalar: the type whose rounding decides.
    """
    candidates = (
        _quaternions(domain, scalar)
        if domain.kind is ir.Kind.QUATERNION
        else _matrices(domain, scalar)
    )
    kind = kind_of(scalar)
    found = []
    for elements in candidates:
        typed = tuple(float(kind.type(e)) for e in elements)
        if _within(domain, scalar, typed):
            found.append(Turn(typed, _accepted(domain, scalar, typed)))
    return list(dict.fromkeys(found))


def _within(domain: ir.Domain, scalar: ir.Scalar, elements: tuple[float, ...]) -> bool:
    """Another guard would judge what is outside the declared range."""
    pairs = zip(domain.lower, domain.upper, strict=True)
    ends = [declared(low, high, scalar) for low, high in pairs]
    return all(
        float(low) <= e <= float(high) for e, (low, high) in zip(elements, ends, strict=True)
    )


def _accepted(domain: ir.Domain, scalar: ir.Scalar, elements: tuple[float, ...]) -> bool:
    kind = kind_of(scalar)
    columns = [np.array([e], dtype=kind) for e in elements]
    tolerance = np.array(constant(domain.tolerance, scalar), dtype=kind)
    judge = is_unit if domain.kind is ir.Kind.QUATERNION else is_rotation
    return bool(judge(columns, tolerance)[0])


def _quaternions(domain: ir.Domain, scalar: ir.Scalar) -> Iterator[tuple[float, ...]]:
    def quaternion(c: float) -> tuple[float, ...]:
        return (c, -c, c, c)

    yield (0.0,) * 4
    yield quaternion(0.25)
    yield quaternion(0.75)
    for part in (1.0 + domain.tolerance, 1.0 - domain.tolerance):
        if part > 0.0:
            yield from _neighbours(domain, scalar, quaternion, float(np.sqrt(part / 4.0)))


def _matrices(domain: ir.Domain, scalar: ir.Scalar) -> Iterator[tuple[float, ...]]:
    def stretched(c: float) -> tuple[float, ...]:
        return (c, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)

    yield stretched(0.5)  # first column
    yield (1.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0)  # second column
    yield (1.0, 0.6, 0.0, 0.0, 0.8, 0.0, 0.0, 0.0, 1.0)  # columns that are not orthogonal
    yield (1.0, 0.0, 0.5, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)  # third column, element by element
    yield (1.0, 0.0, 0.0, 0.0, 1.0, 0.5, 0.0, 0.0, 1.0)
    yield (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0)  # a reflection
    yield (0.0,) * 9
    for part in (1.0 + domain.tolerance, 1.0 - domain.tolerance):
        if part > 0.0:
            yield from _neighbours(domain, scalar, stretched, float(np.sqrt(part)))


def _neighbours(
    domain: ir.Domain,
    scalar: ir.Scalar,
    shape: Callable[[float], tuple[float, ...]],
    start: float,
) -> Iterator[tuple[float, ...]]:
    """Two neighbouring numbers of the type on either side of the tolerance."""
    kind = kind_of(scalar)
    number = kind.type(start)
    for _ in range(64):
        for other in (np.nextafter(number, kind.type(2.0)), np.nextafter(number, kind.type(0.0))):
            pair = (shape(float(number)), shape(float(other)))
            if _accepted(domain, scalar, pair[0]) is not _accepted(domain, scalar, pair[1]):
                yield from pair
                return
        outside = not _accepted(domain, scalar, shape(float(number)))
        inward = kind.type(0.0) if start > shape_unit(shape) else kind.type(2.0)
        outward = kind.type(2.0) - inward
        number = np.nextafter(number, inward if outside else outward)


def shape_unit(shape: Callable[[float], tuple[float, ...]]) -> float:
    """The number at which a shape is a rotation."""
    return 0.5 if len(shape(0.0)) == 4 else 1.0
