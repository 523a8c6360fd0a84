"""Jacobians of the references, by differences through the retract of what carries an error."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from mpmath import mpf

from .algebra import Matrix, Options, Outputs, Quantities, Vector, derivative
from .blocks import Setting, retract

Model = Callable[[Quantities, Options], Outputs]
STORED = {"rotation": "wxyz", "heading": "angle", "geodetic": "llh"}


@dataclass(frozen=True)
class Error:
    """One quantity with an error: a block of columns.

    Attributes:
        quantity: Name of the quantity.
        kind: Kind of state block (see :mod:`tests.reference.blocks`).
        convention: Convention of the error, where the kind has several.
        setting: What else the retract needs.
    """

    quantity: str
    kind: str = "vector"
    convention: str = "additive"
    setting: Setting = field(default_factory=Setting)

    def size(self, q: Quantities) -> int:
        """Give the number of columns."""
        if self.kind == "heading":
            return 1
        if self.kind == "rotation":
            return 4 if self.convention == "storage" else 3
        return 3 if self.kind == "geodetic" else len(q[self.quantity]["value"])

    def move(self, item: Mapping[str, Any], d: Sequence[mpf]) -> dict[str, Any]:
        """Give the quantity moved by an error."""
        key = STORED.get(self.kind, "value")
        held = [item[key]] if self.kind == "heading" else item[key]
        moved = retract(self.kind, self.convention, held, d, self.setting)
        return {**item, key: moved[0] if self.kind == "heading" else moved}


def jacobian(
    model: Model, q: Quantities, options: Options, errors: Sequence[Error], output: str = "value"
) -> Matrix:
    """Differentiate one output (the rows) toward the errors, in the order given."""
    sizes = [error.size(q) for error in errors]

    def moved(d: Vector) -> Vector:
        replaced, start = dict(q), 0
        for error, size in zip(errors, sizes, strict=True):
            part = d[start : start + size]
            replaced[error.quantity] = error.move(replaced[error.quantity], part)
            start += size
        return model(replaced, options)[output]

    return derivative(moved, [mpf(0)] * sum(sizes))
