"""What every kind of state block and input provides.

A block knows how many elements it stores, how many its error has, how an error moves it
(``retract``), which error leads from one value to another (``local``), and how its tangent enters
an equation (``attach``). Retract and attach may read the rest of the nominal state, because an
error can be resolved in a frame that another block defines.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Protocol

from symnav.errors import EquationError
from symnav.frames.geodesy import GeodeticTerms
from symnav.graph import Graph, Row
from symnav.quantities import Quantity, Rotation


@dataclass(frozen=True)
class GeodeticPoint:
    """A geodetic position as equations see it.

    Attributes:
        position: earth-fixed position.
        level: rotation from the local-level axes at the point to earth-fixed axes.
        angles: latitude, longitude and height symbols.
        terms: named sines, cosines and radii.
    """

    position: Quantity
    level: Rotation
    angles: Row
    terms: GeodeticTerms


Value = Quantity | Rotation | GeodeticPoint


class Nominal(Protocol):
    """The nominal values a block may read while it is attached or retracted."""

    def matrix_between(self, source: str, target: str) -> Row:
        """Nine entries of the rotation from one frame to another, from a block or an input.

        Raises:
            EquationError: when no bound rotation connects the two frames.
        """
        ...


@dataclass(frozen=True)
class Block(ABC):
    """One named part of the state vector, or one input.

    Attributes:
        name: identifier.
        lower: least value of each stored element, inclusive.
        upper: greatest value of each stored element, inclusive.
        description: one sentence for documentation, may be empty.
    """

    kind: ClassVar[str]

    name: str
    lower: tuple[float, ...]
    upper: tuple[float, ...]
    description: str

    @property
    @abstractmethod
    def storage_labels(self) -> tuple[str, ...]:
        """A label per stored element."""

    @property
    @abstractmethod
    def error_labels(self) -> tuple[str, ...]:
        """A label per element of the error."""

    @property
    @abstractmethod
    def units(self) -> tuple[str, str]:
        """Unit of the stored elements (that of the first) and of the error."""

    @property
    @abstractmethod
    def frames(self) -> tuple[str, str]:
        """Frame or map of the stored value, and frame of its error; empty where there is none."""

    @property
    @abstractmethod
    def convention(self) -> str:
        """How the error enters, as one word or phrase."""

    @property
    @abstractmethod
    def initial(self) -> tuple[float, ...]:
        """A value inside the domain to start from: zeros, or the identity rotation."""

    @property
    def storage_size(self) -> int:
        """Number of stored elements."""
        return len(self.storage_labels)

    @property
    def error_size(self) -> int:
        """Dimension of the error."""
        return len(self.error_labels)

    @property
    def norm_tolerance(self) -> float:
        """Largest deviation of the squared norm from one; zero where there is no norm."""
        return 0.0

    @abstractmethod
    def attach(self, graph: Graph, x: Row, source: str | None, nominal: Nominal) -> Value:
        """The value as equations see it.

        Args:
            graph: the equation's graph.
            x: symbols of the stored elements.
            source: vertex of the block's error, or None when it is not differentiated.
            nominal: the rest of the state.
        """

    @abstractmethod
    def retract(self, graph: Graph, x: Row, d: Row, nominal: Nominal) -> Row:
        """Stored elements of the value ``x`` moved by the error ``d``."""

    @abstractmethod
    def local(self, graph: Graph, x: Row, y: Row, nominal: Nominal) -> Row:
        """The error that leads from ``x`` to ``y``: retracting ``x`` by it gives ``y``."""


def frame_map(text: str) -> tuple[str, str]:
    """Read ``"b -> n"``.

    Raises:
        EquationError: when the text is not of that form or both ends are the same.
    """
    source, arrow, target = (part.strip() for part in text.partition("->"))
    if not arrow or not source or not target or source == target:
        raise EquationError(f"maps {text!r} is not a frame map; write it like 'b -> n'")
    return source, target
