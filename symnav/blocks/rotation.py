"""Rotations: stored as a Hamilton quaternion (or, for inputs, as a matrix), error on the manifold.

Error conventions, d being the error and R(q) the stored rotation:
``right`` R Exp(d), ``right_negative`` R Exp(-d), ``left`` Exp(d) R, ``left_negative`` Exp(-d) R,
``rotation_vector`` Exp(Log(R) + d), ``storage`` q + d on the raw elements.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from symnav.blocks.base import Block, Nominal, Value, frame_map
from symnav.frames import rotations
from symnav.graph import ONE, Graph, Guard, Matrix, Row, identity, product, rows_of
from symnav.quantities import HARMLESS, Rotation

CONVENTIONS = ("right", "left", "left_negative", "right_negative", "rotation_vector", "storage")
STORAGES = ("wxyz", "xyzw", "dcm")


@dataclass(frozen=True)
class RotationBlock(Block):
    """A rotation between two frames.

    Attributes:
        maps: ``"b -> n"``: the stored rotation takes vectors from b to n.
        storage: ``wxyz`` or ``xyzw`` (quaternion), or ``dcm`` (9, row-major; inputs only).
        error: one of ``CONVENTIONS``.
        normalise: divide by the norm of the quaternion instead of trusting it.
        tolerance: largest deviation of the squared norm from one.
    """

    kind: ClassVar[str] = "rotation"

    maps: str
    storage: str = "wxyz"
    error: str = "right"
    normalise: bool = False
    tolerance: float = 1e-5

    @property
    def storage_labels(self) -> tuple[str, ...]:
        return rotations.NAMES if self.storage == "dcm" else tuple(self.storage)

    @property
    def error_labels(self) -> tuple[str, ...]:
        return tuple(self.storage) if self.error == "storage" else ("x", "y", "z")

    @property
    def units(self) -> tuple[str, str]:
        return "1", "1" if self.error == "storage" else "rad"

    @property
    def frames(self) -> tuple[str, str]:
        source, target = frame_map(self.maps)
        side = target if self.error.startswith("left") else source
        return self.maps, "" if self.error in ("storage", "rotation_vector") else side

    @property
    def convention(self) -> str:
        return {
            "right": "R Exp(d)",
            "right_negative": "R Exp(-d)",
            "left": "Exp(d) R",
            "left_negative": "Exp(-d) R",
            "rotation_vector": "Exp(Log(R) + d)",
            "storage": "q + d",
        }[self.error]

    @property
    def initial(self) -> tuple[float, ...]:
        ones = {"wxyz": (0,), "xyzw": (3,), "dcm": (0, 4, 8)}[self.storage]
        return tuple(1.0 if i in ones else 0.0 for i in range(self.storage_size))

    @property
    def norm_tolerance(self) -> float:
        return self.tolerance

    def attach(self, graph: Graph, x: Row, source: str | None, nominal: Nominal) -> Value:
        from_frame, to_frame = frame_map(self.maps)
        matrix, gradient = self._matrix(graph, x)
        tangent = None
        if source is not None:
            graph.attach(f"{self.name}_elements", x, 0, {}, identity=False)
            tangent = self._tangent(graph, x, source)
        side = "left" if self.error.startswith("left") else "right"
        if self.error == "storage":
            side = "raw"
        return Rotation(
            graph, self.name, from_frame, to_frame, matrix, tangent, side, gradient=gradient
        )

    def retract(self, graph: Graph, x: Row, d: Row, nominal: Nominal) -> Row:
        if self.error == "storage":
            return tuple(a + b for a, b in zip(x, d, strict=True))
        if self.storage == "dcm":
            return self._retract_matrix(graph, x, d)
        q = self.to_wxyz(x)
        if self.error == "rotation_vector":
            theta = rotations.logarithm(graph, f"{self.name}_log", q)
            moved = graph.define(
                f"{self.name}_vector", [a + b for a, b in zip(theta, d, strict=True)]
            )
            return self._from_wxyz(rotations.exponential(graph, f"{self.name}_exp", moved))
        signed = tuple(self._sign * e for e in d)
        step = graph.define(
            f"{self.name}_step",
            rotations.exponential(graph, f"{self.name}_exp", signed),
            suffixes=tuple("wxyz"),
        )
        left = self.error.startswith("left")
        pair = (step, q) if left else (q, step)
        return self._from_wxyz(rotations.quaternion_product(*pair))

    def local(self, graph: Graph, x: Row, y: Row, nominal: Nominal) -> Row:
        if self.error == "storage":
            return tuple(b - a for a, b in zip(x, y, strict=True))
        before, after = self.to_wxyz(x), self.to_wxyz(y)
        if self.error == "rotation_vector":
            start = rotations.logarithm(graph, f"{self.name}_from", before)
            end = rotations.logarithm(graph, f"{self.name}_to", after)
            return tuple(b - a for a, b in zip(start, end, strict=True))
        inverse = rotations.conjugate(before)
        left = self.error.startswith("left")
        pair = (after, inverse) if left else (inverse, after)
        theta = rotations.logarithm(graph, f"{self.name}_log", rotations.quaternion_product(*pair))
        return tuple(self._sign * e for e in theta)

    def _retract_matrix(self, graph: Graph, x: Row, d: Row) -> Row:
        """A stored matrix times the matrix of the step, on the side of the convention."""
        signed = tuple(self._sign * e for e in d)
        q = graph.define(
            f"{self.name}_step",
            rotations.exponential(graph, f"{self.name}_exp", signed),
            suffixes=tuple("wxyz"),
        )
        step = rows_of(rotations.homogeneous_entries(q), 3)
        before = rows_of(x, 3)
        left = self.error.startswith("left")
        moved = product(step, before) if left else product(before, step)
        return tuple(e for row in moved for e in row)

    def to_wxyz(self, x: Row) -> Row:
        """Stored elements in the order w, x, y, z."""
        return x if self.storage == "wxyz" else (x[3], *x[:3])

    def _from_wxyz(self, q: Row) -> Row:
        return q if self.storage == "wxyz" else (*q[1:], q[0])

    @property
    def _sign(self) -> sp.Expr:
        return -ONE if self.error.endswith("_negative") else ONE

    def _matrix(self, graph: Graph, x: Row) -> tuple[Row, Matrix]:
        """Entries of R and, for raw errors, their gradient in storage order."""
        if self.storage == "dcm":
            return x, ()
        q = self.to_wxyz(x)
        raw = self.error == "storage"
        if self.normalise:
            guard = Guard(1e-6, 1e6, HARMLESS, f"squared norm of {self.name}")
            matrix, square = rotations.normalised_matrix(graph, self.name, q, guard)
            gradient = rotations.normalised_gradient(q, matrix, square) if raw else ()
        elif raw:
            matrix = rotations.homogeneous_matrix(graph, self.name, q)
            gradient = rotations.homogeneous_gradient(q)
        else:
            matrix, gradient = rotations.unit_quaternion_matrix(graph, self.name, q), ()
        return matrix, tuple(self._from_wxyz(row) for row in gradient)

    def _tangent(self, graph: Graph, x: Row, source: str) -> str:
        """Vertex of the error on the side that ``rotate`` expects."""
        partial: Matrix
        if self.error == "storage":
            partial = identity(4)
        elif self.error == "rotation_vector":
            theta = rotations.logarithm(graph, f"{self.name}_log", self.to_wxyz(x))
            named = graph.define(f"{self.name}_vector", theta)
            partial = rotations.right_jacobian(graph, f"{self.name}_jr", named)
        else:
            partial = identity(3, self._sign)
        return graph.vertex(
            f"{self.name}_tangent", (), {source: partial}, size=self.error_size
        ).name
