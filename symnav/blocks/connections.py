"""Which rotation turns an error from its own frame into that of its block: one rule for all."""

from __future__ import annotations

from collections.abc import Iterable

from symnav.blocks.base import Block, frame_map
from symnav.blocks.heading import HeadingBlock
from symnav.blocks.rotation import RotationBlock


def connecting(
    states: Iterable[Block], inputs: Iterable[Block], source: str, target: str
) -> tuple[Block, ...]:
    """The rotations between two frames: those of the state, or the inputs where it has none.

    Retract, local and every Jacobian read the same one, whatever an equation is bound to, so a
    specification in which this gives several is refused.

    Args:
        states: blocks of the layout.
        inputs: blocks of the inputs that all items share.
        source: one frame.
        target: the other; the direction does not matter.
    """
    own = _between(states, {source, target})
    return own or _between(inputs, {source, target})


def _between(blocks: Iterable[Block], ends: set[str]) -> tuple[Block, ...]:
    return tuple(
        block
        for block in blocks
        if isinstance(block, (RotationBlock, HeadingBlock)) and set(frame_map(block.maps)) == ends
    )
