"""Walking and rebuilding expressions: what the passes share."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from symnav import ir

Rule = Callable[[ir.Expression], ir.Expression]


def nodes(expression: ir.Expression) -> Iterator[ir.Expression]:
    """Every node, parents before their operands, operands from the left."""
    pending = [expression]
    while pending:
        node = pending.pop()
        yield node
        if isinstance(node, ir.Call):
            pending.extend(reversed(node.operands))


def rebuild(expression: ir.Expression, rule: Rule) -> ir.Expression:
    """Apply a rule to every node, operands before their parents."""
    if isinstance(expression, ir.Call):
        operands = tuple(rebuild(operand, rule) for operand in expression.operands)
        if any(new is not old for new, old in zip(operands, expression.operands, strict=True)):
            expression = replace(expression, operands=operands)
    return rule(expression)


def rewrite_step(step: ir.Step, rule: Rule) -> ir.Step:
    """A step with a rule applied to its value."""
    return replace(step, value=rebuild(step.value, rule))


def rewrite_output(output: ir.Output, rule: Rule) -> ir.Output:
    """An output with a rule applied to the value of every entry."""
    entries = tuple(
        replace(entry, value=rebuild(entry.value, rule)) for entry in output.entries
    )
    return replace(output, entries=entries)


def references(expression: ir.Expression) -> Iterator[str]:
    """Names of earlier steps, once for every time they are read."""
    return (node.name for node in nodes(expression) if isinstance(node, ir.Ref))


def per_item(function: ir.Function, output: ir.Output) -> bool:
    """True when the entries of an output belong to the item body."""
    return output.item and function.maximum is not None
