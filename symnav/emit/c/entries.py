"""What an entry point is: a public symbol with its parameters."""

from __future__ import annotations

from dataclasses import dataclass

from symnav import ir
from symnav.emit.c.pieces import Parameter, head
from symnav.emit.c.store import is_jacobian


@dataclass(frozen=True, slots=True)
class EntryPoint:
    """One public symbol.

    Attributes:
        symbol: its name.
        brief: one sentence.
        parameters: in order.
        full: True for the one that carries the whole documentation.
        remark: what else its callers need to know.
        border: True for the one that checks inputs and evaluates nothing.
    """

    symbol: str
    brief: str
    parameters: tuple[Parameter, ...]
    full: bool = False
    remark: str = ""
    border: bool = False

    def prototype(self, status: str) -> tuple[str, ...]:
        """Its head, on as many lines as it needs."""
        return head(status, self.symbol, [parameter.declaration for parameter in self.parameters])

    @property
    def pointers(self) -> str:
        """Condition under which no pointer is null.

        From the last to the first: those that came on the stack are looked at and forgotten while
        the registers of the first are full, which saves moves where registers are few.
        """
        names = [p.name for p in reversed(self.parameters) if p.pointer]
        if len(names) == 1:
            return f"{names[0]} != NULL"
        return " && ".join(f"({name} != NULL)" for name in names)


def variants(function: ir.Function) -> list[tuple[str, str, tuple[ir.Output, ...]]]:
    """Suffix, meaning and outputs of the dense entry points."""
    outputs = function.outputs
    joint = [("", "", outputs)]
    values = tuple(output for output in outputs if not is_jacobian(output))
    jacobians = tuple(output for output in outputs if is_jacobian(output))
    if not values or not jacobians:
        return joint
    return [
        *joint,
        ("_value", "values only", values),
        ("_jacobian", "Jacobians only", jacobians),
    ]


def has_nonzeros(function: ir.Function) -> bool:
    """True when some Jacobian has a structural non-zero."""
    return any(is_jacobian(output) and output.entries for output in function.outputs)
