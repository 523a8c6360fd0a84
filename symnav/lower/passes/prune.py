"""Keep some outputs of a function and what they need."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from symnav import ir
from symnav.lower.passes.walk import references


def prune(function: ir.Function, outputs: Collection[str]) -> ir.Function:
    """The function without the outputs that are not named and the steps only they need.

    Checks always stay, with what they read: the pruned function fails where the whole one does.

    Args:
        function: the whole function.
        outputs: names to keep.

    Raises:
        KeyError: when there is no output of a name.
    """
    unknown = set(outputs) - {output.name for output in function.outputs}
    if unknown:
        raise KeyError(f"{function.name} has no output {sorted(unknown)[0]!r}")
    kept = tuple(output for output in function.outputs if output.name in outputs)
    wanted = {
        name for output in kept for entry in output.entries for name in references(entry.value)
    }
    item = _needed(function.item, wanted)
    shared = _needed(function.shared, wanted)
    return replace(function, shared=shared, item=item, outputs=kept)


def _needed(steps: Sequence[ir.Step], wanted: set[str]) -> tuple[ir.Step, ...]:
    """Steps that are wanted or are checks; adds what they read to ``wanted``."""
    kept: list[ir.Step] = []
    for step in reversed(steps):
        if step.target in wanted or isinstance(step, ir.Check):
            kept.append(step)
            wanted.update(references(step.value))
    return tuple(reversed(kept))
