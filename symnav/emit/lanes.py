"""How many epochs stand side by side in a block."""

from __future__ import annotations

from math import prod

from symnav import ir

_SCRATCH = 16384  # bytes a block of epochs may take on the stack
_LANES = (32, 16)


def lanes_of(function: ir.Function) -> int:
    """Epochs in a block: enough to fill vectors, few enough for the cache and the stack."""
    elements = sum(argument.size for argument in function.arguments)
    elements += sum(block_size(output) for output in function.outputs)
    width = 8 * (elements + 2)
    return next((lanes for lanes in _LANES if lanes * width <= _SCRATCH), 8)


def block_size(output: ir.Output) -> int:
    """Elements of an output that one epoch has in a block: values, or non-zeros of a Jacobian."""
    return len(output.entries) if output.name.startswith("jacobian") else prod(output.shape)
