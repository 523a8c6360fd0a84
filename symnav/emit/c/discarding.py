"""Which numbers that failed their check a function may go on with, to discard what comes of them.

Items, and epochs side by side, are evaluated before their flags are looked at: to select a harmless
number in the place of every one outside its range makes the arithmetic wait for the check. Sums and
products need no such help. A square root, a divisor or the argument of a library function does,
unless a guard of the function itself stands in front of it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from symnav import ir
from symnav.emit.c.expressions import LIBRARY_CALLS
from symnav.lower.passes.walk import nodes

_SENSITIVE = LIBRARY_CALLS | {ir.Operation.SQRT}


def selected(function: ir.Function) -> frozenset[ir.Load]:
    """Elements whose place a harmless number has to take when they fail their check.

    Something that needs a number inside its domain reads them, with no guard between. Elements that
    can fail are those of items where there are items, else all of them.
    """
    fails = {a.name: a for a in function.arguments if a.item or function.maximum is None}
    reach: dict[str, frozenset[ir.Load]] = {}

    def read_by(expressions: Iterable[ir.Expression]) -> frozenset[ir.Load]:
        found: set[ir.Load] = set()
        for node in (node for expression in expressions for node in nodes(expression)):
            if isinstance(node, ir.Ref):
                found |= reach.get(node.name, frozenset())
            elif isinstance(node, ir.Load) and node.argument in fails:
                found.update(_chosen_from(node, fails[node.argument]))
        return frozenset(found)

    needed: set[ir.Load] = set()
    for step in (*function.shared, *function.item):
        needed |= read_by(_sensitive(step.value))
        guarded = isinstance(step, ir.Check) and function.checks_domain
        if not guarded:
            reach[step.target] = read_by([step.value])
    for output in function.outputs:
        for entry in output.entries:
            needed |= read_by(_sensitive(entry.value))
    return frozenset(needed)


def _chosen_from(load: ir.Load, argument: ir.Argument) -> Iterator[ir.Load]:
    """The element, or every one that a run-time slot may choose."""
    if isinstance(load.index, ir.Offset):
        yield from (ir.Load(argument.name, index) for index in range(argument.size))
    else:
        yield load


def _sensitive(expression: ir.Expression) -> Iterator[ir.Expression]:
    """Operands that have to be inside a domain."""
    for node in nodes(expression):
        if isinstance(node, ir.Call):
            if node.operation in _SENSITIVE:
                yield from node.operands
            elif node.operation is ir.Operation.DIV:
                yield node.operands[1]
