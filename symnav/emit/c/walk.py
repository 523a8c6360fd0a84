"""What the steps and entries of a function refer to."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from symnav import ir

Holder = ir.Step | ir.Entry


def loads_of(holders: Iterable[Holder]) -> set[ir.Load]:
    """Elements of arguments that are read."""
    return {node for node in _nodes(holders) if isinstance(node, ir.Load)}


def references_of(holders: Iterable[Holder]) -> set[str]:
    """Names of earlier steps that are read."""
    return {node.name for node in _nodes(holders) if isinstance(node, ir.Ref)}


def operations_of(holders: Iterable[Holder]) -> set[ir.Operation]:
    """Operations that occur."""
    return {node.operation for node in _nodes(holders) if isinstance(node, ir.Call)}


def _nodes(holders: Iterable[Holder]) -> Iterator[ir.Expression]:
    pending: list[ir.Expression] = [holder.value for holder in holders]
    while pending:
        node = pending.pop()
        yield node
        if isinstance(node, ir.Call):
            pending.extend(node.operands)
        elif isinstance(node, ir.Load) and isinstance(node.index, ir.Offset):
            pending.append(node.index.slot)
