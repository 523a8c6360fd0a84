"""Operations of a function, by kind: what one call costs before the compiler has seen it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

from symnav import ir


@dataclass(frozen=True, slots=True)
class Counts:
    """Operations of one function.

    Attributes:
        shared: of the part evaluated once per call.
        item: of the part evaluated once per item; empty where the function is not mapped.
    """

    shared: Counter[ir.Operation]
    item: Counter[ir.Operation]

    def total(self, items: int = 1) -> int:
        """All operations of a call with so many items."""
        return self.shared.total() + items * self.item.total()


def count_operations(function: ir.Function) -> Counts:
    """Count the operations of the bodies and of the output entries.

    Guards are not counted: the comparisons of a ``Check`` are no operations of the equation.
    """
    mapped = function.maximum is not None
    shared: list[ir.Expression] = [step.value for step in function.shared]
    item: list[ir.Expression] = [step.value for step in function.item]
    for output in function.outputs:
        side = item if mapped and output.item else shared
        side.extend(entry.value for entry in output.entries)
    return Counts(_count(shared), _count(item))


def _count(expressions: Iterable[ir.Expression]) -> Counter[ir.Operation]:
    counter: Counter[ir.Operation] = Counter()
    pending = list(expressions)
    while pending:
        node = pending.pop()
        if isinstance(node, ir.Call):
            counter[node.operation] += 1
            pending.extend(node.operands)
    return counter
