"""Fold statements that are read once into the expression that reads them.

Straight-line code with one operation a line is hard to check against an equation. Folding changes
neither the operations nor their grouping, so that results stay the same bits.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from symnav import ir
from symnav.lower.passes.walk import nodes, per_item, references

LONGEST = 8
"""Most numbers and names a folded expression may hold: about what fits one line of C."""

_TEMPORARY = re.compile(r"[a-z]_?\d+")


def inline(function: ir.Function, longest: int = LONGEST) -> ir.Function:
    """Fold temporaries that are read exactly once.

    A temporary is a statement without a comment whose name is a letter and a number: a value with
    a name of its own keeps its line, since the name says what it is. What is read by an output
    alone is written where the output is, which says what it is as well. Nothing is folded across
    a check, nor from the shared part into the item part, where it would be evaluated for every
    item.

    Args:
        function: the function to make readable.
        longest: most numbers and names in one folded expression.
    """
    item_outputs = [output for output in function.outputs if per_item(function, output)]
    other_outputs = [output for output in function.outputs if not per_item(function, output)]
    item_reads = _reads(function.item, item_outputs)
    shared_reads = _reads(function.shared, other_outputs)
    shared = _Folding(shared_reads, set(item_reads), _results(other_outputs), longest)
    item = _Folding(item_reads, set(), _results(item_outputs), longest)
    shared.run(function.shared)
    item.run(function.item)
    outputs = tuple(
        (item if per_item(function, output) else shared).output(output)
        for output in function.outputs
    )
    return replace(function, shared=shared.steps(), item=item.steps(), outputs=outputs)


def _reads(steps: Sequence[ir.Step], outputs: Sequence[ir.Output]) -> Counter[str]:
    """How often a body reads every name."""
    values = [step.value for step in steps]
    values += [entry.value for output in outputs for entry in output.entries]
    return Counter(name for value in values for name in references(value))


def _results(outputs: Sequence[ir.Output]) -> set[str]:
    """Names that are results as they are."""
    values = (entry.value for output in outputs for entry in output.entries)
    return {value.name for value in values if isinstance(value, ir.Ref)}


class _Folding:
    """One body: the steps that keep a line and the temporaries that wait for their reader."""

    def __init__(
        self, reads: Counter[str], kept: set[str], results: set[str], longest: int
    ) -> None:
        self._reads = reads
        self._kept = kept
        self._results = results
        self._longest = longest
        self._steps: list[ir.Step] = []
        self._waiting: dict[str, ir.Expression] = {}
        self._written: dict[str, ir.Expression] = {}

    def run(self, steps: Sequence[ir.Step]) -> None:
        """Fold the steps of a body, in order."""
        for step in steps:
            value = self._folded(step.value)
            if isinstance(step, ir.Check):
                self._settle(tuple(self._waiting))
                self._steps.append(replace(step, value=value))
            elif self._is_result(step):
                self._written[step.target] = value
            elif self._may_fold(step):
                self._waiting[step.target] = value
            else:
                self._steps.append(replace(step, value=value))

    def output(self, output: ir.Output) -> ir.Output:
        """An output with what its entries read folded into them."""
        entries = (replace(entry, value=self._result(entry.value)) for entry in output.entries)
        return replace(output, entries=tuple(entries))

    def steps(self) -> tuple[ir.Step, ...]:
        """The steps that keep a line, once the outputs have been folded."""
        self._settle(tuple(self._waiting))
        return tuple(self._steps)

    def _may_fold(self, step: ir.Statement) -> bool:
        return self._is_read_once(step) and bool(_TEMPORARY.fullmatch(step.target))

    def _is_result(self, step: ir.Statement) -> bool:
        return self._is_read_once(step) and step.target in self._results

    def _is_read_once(self, step: ir.Statement) -> bool:
        once = self._reads[step.target] == 1 and step.target not in self._kept
        return once and not step.comment

    def _result(self, value: ir.Expression) -> ir.Expression:
        if isinstance(value, ir.Ref) and value.name in self._written:
            return self._written.pop(value.name)
        return self._folded(value)

    def _folded(self, value: ir.Expression) -> ir.Expression:
        """The value with its temporaries in place, as many as fit; the others get a line."""
        size = _size(value)
        for name in [name for name in references(value) if name in self._waiting]:
            grown = size + _size(self._waiting[name]) - 1
            if grown > self._longest:
                self._settle((name,))
            else:
                size = grown
                value = _with(value, name, self._waiting.pop(name))
        return value

    def _settle(self, names: Sequence[str]) -> None:
        """Give temporaries a line after all."""
        self._steps += [ir.Statement(name, self._waiting.pop(name)) for name in names]


def _size(value: ir.Expression) -> int:
    return sum(1 for node in nodes(value) if not isinstance(node, ir.Call))


def _with(value: ir.Expression, name: str, folded: ir.Expression) -> ir.Expression:
    """The value with an expression in the place of a name."""
    if isinstance(value, ir.Ref):
        return folded if value.name == name else value
    if isinstance(value, ir.Call):
        operands = tuple(_with(operand, name, folded) for operand in value.operands)
        return ir.Call(value.operation, operands)
    return value
