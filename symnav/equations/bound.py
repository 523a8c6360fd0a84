"""What an equation sees: its quantities by name, its options, and what it gives back."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from symnav import units
from symnav.blocks import GeodeticPoint, Value
from symnav.equations.model import OptionValue
from symnav.errors import EquationError
from symnav.graph import Graph
from symnav.quantities import Quantity, Rotation, compose, constant, follows, let, rotate


@dataclass(frozen=True)
class Rate:
    """An output that is the derivative of another by a scalar input, such as a velocity.

    Attributes:
        output: name of the output that is differentiated.
        by: role it is differentiated by.
    """

    output: str
    by: str


@dataclass(frozen=True)
class Covariance:
    """An output J P J^T, J being the derivative of ``value`` by a role and P an input covariance.

    Attributes:
        by: role whose covariance is mapped.
        covariance: its covariance, nine elements row-major.
    """

    by: str
    covariance: Quantity


@dataclass(frozen=True)
class Results:
    """What an equation gives back, by output name; the first is the one that has Jacobians."""

    outputs: Mapping[str, Quantity]
    rates: Mapping[str, Rate] = field(default_factory=dict)
    covariances: Mapping[str, Covariance] = field(default_factory=dict)


@dataclass(frozen=True)
class Bound:
    """The bound quantities of one spec entry.

    Attributes:
        graph: where the equation names its terms.
        options: every option of the model.
        values: by role (library) or by block and input name (user equations).
        frames: frame role -> name of the user's frame.
        domains: declared bounds by role, one (lower, upper) pair per element.
    """

    graph: Graph
    options: Mapping[str, OptionValue]
    values: Mapping[str, Value]
    frames: Mapping[str, str]
    domains: Mapping[str, tuple[tuple[float, float], ...]]

    def __getattr__(self, name: str) -> Value:
        if name.startswith("_"):
            raise AttributeError(name)
        if name not in self.values:
            raise EquationError(
                f"{name!r} is not a state block or an input; "
                f"known: {', '.join(sorted(self.values))}"
            )
        return self.values[name]

    def has(self, name: str) -> bool:
        """True when the quantity is bound."""
        return name in self.values

    def vector(self, name: str) -> Quantity:
        """A bound vector or scalar; a geodetic point gives its earth-fixed position."""
        value = self.values[name]
        if isinstance(value, GeodeticPoint):
            return value.position
        if isinstance(value, Rotation):
            raise EquationError(f"{name} is a rotation where a vector is needed")
        return value

    def optional(self, name: str) -> Quantity | None:
        """A vector or scalar, or None when it is bound to none."""
        return self.vector(name) if self.has(name) else None

    def geodetic(self, name: str) -> tuple[Quantity, Quantity, Quantity]:
        """Latitude, longitude and height as scalars."""
        angles = self.vector(name)
        height = Quantity(self.graph, angles.elements[2:], units.parse("m"))
        return angles[0], angles[1], height

    def rotation(self, name: str) -> Rotation | None:
        """A rotation, or None when it is bound to none."""
        value = self.values.get(name)
        if value is None or isinstance(value, Rotation):
            return value
        raise EquationError(f"{name} is not a rotation")

    def level_of(self, name: str) -> Rotation | None:
        """The local-level rotation of a geodetic point, None for a plain vector."""
        value = self.values.get(name)
        return value.level if isinstance(value, GeodeticPoint) else None

    def constant(self, unit: str, *values: float) -> Quantity:
        """Numbers of the equation itself, with their unit."""
        return constant(self.graph, values, units.parse(unit))

    def largest_square(self, name: str, parts: int = 1) -> float:
        """Largest squared length of the sum of ``parts`` consecutive 3-vectors of a role."""
        bounds = [max(abs(lo), abs(hi)) for lo, hi in self.domains[name]]
        return sum(sum(bounds[axis + 3 * k] for k in range(parts)) ** 2 for axis in range(3))


def resolve_in(frame: str | None, vector: Quantity, *chain: Rotation | None) -> Quantity:
    """The vector in ``frame``, taken there through the rotations of the chain that it needs."""
    path: list[Rotation] = []
    reached = vector.frame
    for rotation in chain:
        if reached == frame:
            break
        if rotation is not None and reached in (rotation.source, rotation.target):
            path.append(rotation)
            reached = rotation.other(reached)
    if reached != frame:
        bound = [f"{r.name} ({r.source} -> {r.target})" for r in chain if r is not None]
        raise EquationError(
            f"a vector in frame {reached!r} is needed in frame {frame!r}; the rotations bound "
            f"are {', '.join(bound) or 'none'}"
        )
    for rotation in _composed(vector.frame, path):
        vector = rotate(rotation, vector, f"{rotation.name}_arm")
    return vector


def _composed(frame: str | None, path: Sequence[Rotation]) -> Sequence[Rotation]:
    """The path from a frame with as few rotations as one product of matrices can make it."""
    if not path or path[0].source != frame:
        return path
    first, *rest = path
    while rest and follows(first, rest[0]):
        first = compose(rest.pop(0), first)
    return [first, *rest]


def parts(quantity: Quantity, size: int = 3) -> list[Quantity]:
    """Consecutive sub-vectors of a stacked quantity."""
    return [
        Quantity(quantity.graph, quantity.elements[i : i + size], quantity.unit, quantity.frame)
        for i in range(0, quantity.size, size)
    ]


__all__ = ["Bound", "Covariance", "Rate", "Results", "let", "parts", "resolve_in"]
