"""Heading: a rotation about one axis by one angle, SO(2)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from symnav.blocks.base import Block, Nominal, Value, frame_map
from symnav.frames import rotations
from symnav.graph import ONE, ZERO, Graph, Row, identity
from symnav.quantities import Rotation

AXES = ("x", "y", "z")


@dataclass(frozen=True)
class HeadingBlock(Block):
    """An angle psi with v_target = R_axis(psi) v_source, an active rotation about ``axis``.

    Attributes:
        maps: ``"L -> G"``; writing the map the other way round flips the visible sign.
        axis: ``x``, ``y`` or ``z``; both frames share it.
    """

    kind: ClassVar[str] = "heading"

    maps: str
    axis: str = "z"

    @property
    def storage_labels(self) -> tuple[str, ...]:
        return ("",)

    @property
    def error_labels(self) -> tuple[str, ...]:
        return ("",)

    @property
    def units(self) -> tuple[str, str]:
        return "rad", "rad"

    @property
    def frames(self) -> tuple[str, str]:
        return self.maps, ""

    @property
    def convention(self) -> str:
        return "additive, wrapped to (-pi, pi] up to rounding"

    @property
    def initial(self) -> tuple[float, ...]:
        return (0.0,)

    def attach(self, graph: Graph, x: Row, source: str | None, nominal: Nominal) -> Value:
        from_frame, to_frame = frame_map(self.maps)
        tangent = None
        if source is not None:
            graph.attach(f"{self.name}_elements", x, 0, {}, identity=False)
            tangent = graph.vertex(f"{self.name}_tangent", (), {source: identity(1)}, size=1).name
        cosine, sine = graph.define(
            self.name, [sp.cos(x[0]), sp.sin(x[0])], suffixes=("cosine", "sine")
        )
        axis = AXES.index(self.axis)
        matrix = axis_rotation(axis, cosine, sine)
        return Rotation(graph, self.name, from_frame, to_frame, matrix, tangent, "axis", axis=axis)

    def retract(self, graph: Graph, x: Row, d: Row, nominal: Nominal) -> Row:
        (moved,) = graph.define(f"{self.name}_moved", [x[0] + d[0]])
        return (rotations.wrap(moved),)

    def local(self, graph: Graph, x: Row, y: Row, nominal: Nominal) -> Row:
        (difference,) = graph.define(f"{self.name}_difference", [y[0] - x[0]])
        return (rotations.wrap(difference),)


def axis_rotation(axis: int, cosine: sp.Expr, sine: sp.Expr) -> Row:
    """Entries of the active rotation about a coordinate axis."""
    entries = [ZERO] * 9
    i, j = (axis + 1) % 3, (axis + 2) % 3
    entries[4 * axis] = ONE
    entries[4 * i] = entries[4 * j] = cosine
    entries[3 * i + j], entries[3 * j + i] = -sine, sine
    return tuple(entries)
