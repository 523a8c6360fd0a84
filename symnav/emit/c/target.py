"""What the scalar type and the package name decide about the text of the C."""

from __future__ import annotations

from dataclasses import dataclass

from symnav import ir
from symnav.emit.c import literals


@dataclass(frozen=True, slots=True)
class Target:
    """One C tree: a prefix for every name and a floating-point type.

    Attributes:
        prefix: leads every function, type and file name.
        scalar: the floating-point type.
    """

    prefix: str
    scalar: ir.Scalar

    @property
    def macro(self) -> str:
        """Leads every macro and enumerator."""
        return self.prefix.upper()

    @property
    def real(self) -> str:
        """Name of the floating-point type."""
        return f"{self.prefix}_real_t"

    @property
    def status(self) -> str:
        """Name of the status type."""
        return f"{self.prefix}_status_t"

    @property
    def unit_roundoff(self) -> float:
        """Largest relative error of a rounding."""
        return 2.0**-24 if self.scalar is ir.Scalar.FLOAT else 2.0**-53

    def literal(self, value: float) -> str:
        """A number in this type."""
        return literals.literal(value, self.scalar)

    def declared(self, lower: float, upper: float) -> tuple[str, str]:
        """The range of an input in this type: the numbers nearest to its ends."""
        return literals.declared(lower, upper, self.scalar)

    def bounds(self, lower: float, upper: float) -> tuple[str, str]:
        """The range of a guard in this type, rounded inwards."""
        return literals.bounds(lower, upper, self.scalar)

    def function(self, name: str) -> str:
        """A function of ``math.h`` for this type."""
        return name if self.scalar is ir.Scalar.DOUBLE else f"{name}f"

    def flag(self, status: ir.Status) -> str:
        """A status as kernels hand it on."""
        return f"(flag_t){self.code(status)}"

    def code(self, status: ir.Status) -> str:
        """The enumerator of a status."""
        return f"{self.macro}_{status.name}"


def target_of(module: ir.Module) -> Target:
    """The tree a module is emitted to; trees of two scalar types have names of their own."""
    return Target(module.name, module.scalar)
