"""Whether a function may go on with numbers that failed their check and discard what comes of it.

Items, and epochs side by side, are evaluated before their flags are looked at: to select a harmless
number in the place of every one outside its range makes the arithmetic wait for the check. Sums and
products need no such help. A square root, a divisor or the argument of a library function does,
unless a guard of the function itself stands in front of it.
"""

from __future__ import annotations

from collections.abc import Iterator

from symnav import ir
from symnav.emit.c.expressions import LIBRARY_CALLS
from symnav.lower.passes.walk import nodes

_SENSITIVE = LIBRARY_CALLS | {ir.Operation.SQRT}


def may_discard(function: ir.Function) -> bool:
    """True when nothing that needs a number inside its domain reads one that failed its check.

    Numbers that can fail are those of items where there are items, else all of them.
    """
    fails = {a.name for a in function.arguments if a.item or function.maximum is None}
    open_: set[str] = set()

    def reads_open(expression: ir.Expression) -> bool:
        return any(
            node.name in open_
            if isinstance(node, ir.Ref)
            else isinstance(node, ir.Load) and node.argument in fails
            for node in nodes(expression)
        )

    for step in (*function.shared, *function.item):
        if any(map(reads_open, _sensitive(step.value))):
            return False
        guarded = isinstance(step, ir.Check) and function.checks_domain
        if not guarded and reads_open(step.value):
            open_.add(step.target)
    results = (entry.value for output in function.outputs for entry in output.entries)
    return not any(reads_open(operand) for value in results for operand in _sensitive(value))


def _sensitive(expression: ir.Expression) -> Iterator[ir.Expression]:
    """Operands that have to be inside a domain."""
    for node in nodes(expression):
        if isinstance(node, ir.Call):
            if node.operation in _SENSITIVE:
                yield from node.operands
            elif node.operation is ir.Operation.DIV:
                yield node.operands[1]
