"""Vectors and scalars: additive errors, resolved in the block's own frame or in another."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from symnav import units
from symnav.blocks.base import Block, Nominal, Value
from symnav.graph import ONE, Graph, Matrix, Row, identity, product, rows_of, transpose
from symnav.quantities import Quantity


@dataclass(frozen=True)
class VectorBlock(Block):
    """Stored elements with an additive error.

    Attributes:
        size: number of elements.
        unit: SI unit.
        frame: frame of a 3-vector, or empty.
        error_frame: frame the error is resolved in; empty for the same frame.
        error_sign: ``true_minus_estimate`` (x + d) or ``estimate_minus_true`` (x - d).
    """

    kind: ClassVar[str] = "vector"

    size: int
    unit: str
    frame: str = ""
    error_frame: str = ""
    error_sign: str = "true_minus_estimate"

    @property
    def storage_labels(self) -> tuple[str, ...]:
        if self.size == 1:
            return ("",)
        return ("x", "y", "z") if self.size == 3 else tuple(str(i) for i in range(self.size))

    @property
    def error_labels(self) -> tuple[str, ...]:
        return self.storage_labels

    @property
    def units(self) -> tuple[str, str]:
        return self.unit, self.unit

    @property
    def frames(self) -> tuple[str, str]:
        return self.frame, self.error_frame or self.frame

    @property
    def convention(self) -> str:
        return f"additive, {self.error_sign.replace('_', ' ')}"

    @property
    def initial(self) -> tuple[float, ...]:
        return tuple(min(max(0.0, lo), hi) for lo, hi in zip(self.lower, self.upper, strict=True))

    @property
    def _sign(self) -> sp.Expr:
        return ONE if self.error_sign == "true_minus_estimate" else -ONE

    def attach(self, graph: Graph, x: Row, source: str | None, nominal: Nominal) -> Value:
        if source is not None:
            graph.attach(self.name, x, self.size, {source: self._directions(nominal)})
        return Quantity(graph, x, units.parse(self.unit), self.frame or None)

    def retract(self, graph: Graph, x: Row, d: Row, nominal: Nominal) -> Row:
        step = product(self._directions(nominal), tuple((e,) for e in d))
        return tuple(a + b for a, (b,) in zip(x, step, strict=True))

    def local(self, graph: Graph, x: Row, y: Row, nominal: Nominal) -> Row:
        difference = tuple((b - a,) for a, b in zip(x, y, strict=True))
        return tuple(e for (e,) in product(transpose(self._directions(nominal)), difference))

    def _directions(self, nominal: Nominal) -> Matrix:
        """Change of the stored elements per unit of error; orthonormal."""
        if not self.error_frame or self.error_frame == self.frame:
            return identity(self.size, self._sign)
        matrix = nominal.matrix_between(self.error_frame, self.frame)
        return rows_of(tuple(self._sign * e for e in matrix), 3)


@dataclass(frozen=True)
class ScalarBlock(VectorBlock):
    """A vector of one element."""

    kind: ClassVar[str] = "scalar"
