"""Rotations between frames: vectors resolved in another frame, and the error that comes with it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp

from symnav.errors import EquationError
from symnav.graph import ONE, ZERO, Graph, Matrix, Row, identity, product, rows_of, transpose
from symnav.quantities.quantity import Quantity, accumulate, inner_product, named, through


@dataclass(frozen=True)
class Rotation:
    """A rotation matrix from one frame to another, and the tangent it moves in.

    Attributes:
        graph: where its entries are named.
        name: of the block, input or map it comes from.
        source: frame of the vectors it takes.
        target: frame of the vectors it gives.
        matrix: nine entries, row-major, v_target = matrix v_source.
        tangent: the vertex of its error, or None when it is fixed.
        side: how the error enters: ``right`` R Exp(d), ``left`` Exp(d) R, ``axis`` a rotation
            about ``axis`` by a scalar, ``raw`` additive on the elements listed in ``gradient``.
        axis: index of the rotation axis for ``axis``.
        gradient: d(matrix entry)/d(raw element), nine rows, for ``raw``.
    """

    graph: Graph
    name: str
    source: str
    target: str
    matrix: Row
    tangent: str | None = None
    side: str = "right"
    axis: int = 2
    gradient: Matrix = ()

    def other(self, frame: str) -> str:
        """The frame at the other end.

        Raises:
            EquationError: when the rotation does not touch ``frame``.
        """
        if frame not in (self.source, self.target):
            raise EquationError(
                f"{self.name!r} maps {self.source} -> {self.target}; it cannot rotate a vector in "
                f"frame {frame!r}"
            )
        return self.target if frame == self.source else self.source


def rotate(rotation: Rotation, vector: Quantity, name: str | None = None) -> Quantity:
    """Resolve a vector in the other frame of a rotation; the vector's frame picks the direction.

    The derivative goes through a virtual body vertex, so that products of rotations may be
    multiplied from either end: with R Exp(d), d(R a) = R (da - [a]x d).

    Raises:
        EquationError: when the vector is not resolved in either frame of the rotation.
    """
    if vector.size != 3 or vector.frame is None:
        raise EquationError(f"rotate: {rotation.name!r} needs a 3-vector, got {vector.describe()}")
    target = rotation.other(vector.frame)
    forward = vector.frame == rotation.source
    matrix = rows_of(rotation.matrix, 3)
    if not forward:
        matrix = transpose(matrix)
    graph = vector.graph
    label = name or f"{rotation.name}_rotated"
    operand = named(vector, f"{label}_operand").elements
    out = graph.define(label, [inner_product(row, operand) for row in matrix])
    _rotation_vertex(graph, label, rotation, matrix, operand, out, forward)
    return Quantity(graph, out, vector.unit, target)


def follows(inner: Rotation, outer: Rotation) -> bool:
    """True when ``compose`` serves: the outer one is fixed, the error stands on the operand's side.

    One product of matrices then replaces a product for every vector, derivatives included.
    """
    ends = (outer.source, outer.target)
    return (
        outer.tangent is None
        and inner.tangent is not None
        and inner.side == "right"
        and (inner.target in ends)
    )


def compose(outer: Rotation, inner: Rotation) -> Rotation:
    """The rotation that takes vectors through ``inner``, then through ``outer``: C R Exp(d)."""
    graph = inner.graph
    left = rows_of(outer.matrix, 3)
    if inner.target != outer.source:
        left = transpose(left)
    matrix = [e for row in product(left, rows_of(inner.matrix, 3)) for e in row]
    name = f"{outer.name}_{inner.name}"
    suffixes = [f"{i}{j}" for i in range(3) for j in range(3)]
    entries = graph.define(name, matrix, suffixes=suffixes)
    return replace(inner, name=name, target=outer.other(inner.target), matrix=entries, gradient=())


def _rotation_vertex(
    graph: Graph,
    label: str,
    rotation: Rotation,
    matrix: Matrix,
    a: Row,
    out: Row,
    forward: bool,
) -> None:
    """Vertices of out = M a, where M is R (``forward``) or its transpose."""
    moving_operand = graph.moves(*a)
    if not moving_operand and rotation.tangent is None:
        return
    sign = ONE if forward else -ONE
    if rotation.tangent is None:
        graph.vertex(label, out, through(graph, a, matrix))
    elif rotation.side == "axis":
        partials = through(graph, a, matrix) if moving_operand else {}
        column = tuple((e,) for e in _axis_cross(rotation.axis, out, sign))
        graph.vertex(label, out, accumulate(partials, rotation.tangent, column))
    elif rotation.side == "raw":
        partials = through(graph, a, matrix) if moving_operand else {}
        raw = _raw_partials(graph, label, rotation, a, forward)
        graph.vertex(label, out, accumulate(partials, rotation.tangent, raw))
    elif (rotation.side == "right") == forward:
        # The error acts on the operand's side: out = M Exp(+-d) a.
        partials = through(graph, a, identity(3)) if moving_operand else {}
        partials = accumulate(partials, rotation.tangent, skew(a, -sign))
        inner = graph.vertex(f"{label}_inner", (), partials, size=3)
        graph.vertex(label, out, {inner.name: matrix})
    else:
        # The error acts on the result's side: out = Exp(+-d) M a.
        partials = through(graph, a, matrix) if moving_operand else {}
        graph.vertex(label, out, accumulate(partials, rotation.tangent, skew(out, -sign)))


def _raw_partials(graph: Graph, label: str, rotation: Rotation, a: Row, forward: bool) -> Matrix:
    """d(M a)/d(raw element) from the gradient of the matrix entries."""
    count = len(rotation.gradient[0])
    flat = []
    for i in range(3):
        for k in range(count):
            entries = [rotation.gradient[3 * i + j if forward else 3 * j + i][k] for j in range(3)]
            flat.append(inner_product(entries, a))
    return rows_of(graph.define(f"{label}_by_{rotation.name}", flat), count)


def skew(a: Row, scale: sp.Expr = ONE) -> Matrix:
    """The matrix [a]x with [a]x b = a x b, times ``scale`` (plus or minus one)."""
    x, y, z = (scale * e for e in a)
    return ((ZERO, -z, y), (z, ZERO, -x), (-y, x, ZERO))


def _axis_cross(axis: int, v: Row, sign: sp.Expr) -> Row:
    """Sign * e_axis x v."""
    result = [ZERO, ZERO, ZERO]
    i, j = (axis + 1) % 3, (axis + 2) % 3
    result[i], result[j] = -sign * v[j], sign * v[i]
    return tuple(result)
