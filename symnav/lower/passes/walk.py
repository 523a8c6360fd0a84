"""Walking expressions: what the passes share."""

from __future__ import annotations

from collections.abc import Iterator

from symnav import ir


def nodes(expression: ir.Expression) -> Iterator[ir.Expression]:
    """Every node, parents before their operands, operands from the left."""
    pending = [expression]
    while pending:
        node = pending.pop()
        yield node
        if isinstance(node, ir.Call):
            pending.extend(reversed(node.operands))


def expressions(function: ir.Function) -> Iterator[ir.Expression]:
    """Every expression of a function, in its order."""
    for step in (*function.shared, *function.item):
        yield step.value
    for output in function.outputs:
        yield from (entry.value for entry in output.entries)


def references(expression: ir.Expression) -> Iterator[str]:
    """Names of earlier steps, once for every time they are read."""
    return (node.name for node in nodes(expression) if isinstance(node, ir.Ref))


def per_item(function: ir.Function, output: ir.Output) -> bool:
    """True when the entries of an output belong to the item body."""
    return output.item and function.maximum is not None
