"""Geodetic position: latitude, longitude and height stored, error in metres of local-level axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from symnav import units
from symnav.blocks.base import Block, GeodeticPoint, Nominal, Value
from symnav.frames import geodesy, rotations
from symnav.graph import Graph, Matrix, Row, product, rows_of
from symnav.quantities import Quantity, Rotation


@dataclass(frozen=True)
class GeodeticBlock(Block):
    """A point given by geodetic coordinates on WGS-84.

    Attributes:
        frame: earth-fixed frame the point becomes a vector of.
        error_frame: local-level frame of the error.
        error_axes: axes of that frame, ``ned`` or ``enu``.
        attitude_frame: ``fixed`` holds the local-level axes at the nominal position while the
            error moves it; ``moving`` lets them turn.
    """

    kind: ClassVar[str] = "geodetic"

    frame: str
    error_frame: str
    error_axes: str = "ned"
    attitude_frame: str = "fixed"

    @property
    def storage_labels(self) -> tuple[str, ...]:
        return ("latitude", "longitude", "height")

    @property
    def error_labels(self) -> tuple[str, ...]:
        return ("north", "east", "down") if self.error_axes == "ned" else ("east", "north", "up")

    @property
    def units(self) -> tuple[str, str]:
        return "rad", "m"

    @property
    def frames(self) -> tuple[str, str]:
        return self.frame, self.error_frame

    @property
    def convention(self) -> str:
        return f"metres {self.error_axes}, local-level axes {self.attitude_frame}"

    @property
    def initial(self) -> tuple[float, ...]:
        return tuple(min(max(0.0, lo), hi) for lo, hi in zip(self.lower, self.upper, strict=True))

    def attach(self, graph: Graph, x: Row, source: str | None, nominal: Nominal) -> Value:
        if source is not None:
            graph.attach(f"{self.name}_elements", x, 0, {}, identity=False)
        terms = geodesy.geodetic_terms(graph, self.name, x)
        held = terms
        fixed = source is not None and self.attitude_frame == "fixed"
        if fixed:
            held = geodesy.geodetic_terms(graph, f"{self.name}_held", x, frozen=True)
        matrix = geodesy.level_to_ecef(
            graph, f"{self.name}_level", held, self.error_axes, frozen=fixed
        )
        tangent = None
        if source is not None:
            graph.vertex(f"{self.name}_ecef", terms.ecef, {source: rows_of(matrix, 3)})
            if not fixed:
                turn = self._named(
                    graph, "turn", geodesy.transport_rotation(terms, self.error_axes)
                )
                tangent = graph.vertex(f"{self.name}_turn", (), {source: turn}, size=3).name
        position = Quantity(graph, terms.ecef, units.parse("m"), self.frame)
        level = Rotation(
            graph, f"{self.name}_level", self.error_frame, self.frame, matrix, tangent, "right"
        )
        return GeodeticPoint(position, level, x, terms)

    def retract(self, graph: Graph, x: Row, d: Row, nominal: Nominal) -> Row:
        terms = geodesy.geodetic_terms(graph, self.name, x)
        step = product(geodesy.angles_per_metre(terms, self.error_axes), tuple((e,) for e in d))
        lat, lon, height = (a + b for a, (b,) in zip(x, step, strict=True))
        (moved,) = graph.define(f"{self.name}_longitude_moved", [lon])
        return lat, rotations.wrap(moved), height

    def local(self, graph: Graph, x: Row, y: Row, nominal: Nominal) -> Row:
        terms = geodesy.geodetic_terms(graph, self.name, x)
        (turn,) = graph.define(f"{self.name}_longitude_difference", [y[1] - x[1]])
        change = ((y[0] - x[0],), (rotations.wrap(turn),), (y[2] - x[2],))
        metres = product(geodesy.metres_per_angle(terms, self.error_axes), change)
        return tuple(e for (e,) in metres)

    def _named(self, graph: Graph, label: str, matrix: Matrix) -> Matrix:
        flat = [e for row in matrix for e in row]
        return rows_of(graph.define(f"{self.name}_{label}_entry", flat), len(matrix[0]))
