"""The layout: ordered state blocks, their places in storage and error vectors, and the digest."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cached_property

from symnav.blocks import Block


@dataclass(frozen=True)
class Place:
    """Where a block stands.

    Attributes:
        block: the block.
        start: first element in the storage vector.
        error_start: first element in the error vector.
    """

    block: Block
    start: int
    error_start: int

    @property
    def storage(self) -> slice:
        """Elements in the storage vector."""
        return slice(self.start, self.start + self.block.storage_size)

    @property
    def error(self) -> slice:
        """Elements in the error vector."""
        return slice(self.error_start, self.error_start + self.block.error_size)


@dataclass(frozen=True)
class Layout:
    """Blocks in the order of memory."""

    blocks: tuple[Block, ...]

    @cached_property
    def places(self) -> Mapping[str, Place]:
        """Places by block name, in order."""
        places, start, error_start = {}, 0, 0
        for block in self.blocks:
            places[block.name] = Place(block, start, error_start)
            start += block.storage_size
            error_start += block.error_size
        return places

    @property
    def size(self) -> int:
        """Length of the storage vector."""
        return sum(block.storage_size for block in self.blocks)

    @property
    def error_size(self) -> int:
        """Length of the error vector."""
        return sum(block.error_size for block in self.blocks)

    @cached_property
    def digest(self) -> str:
        """SHA-256 over everything that decides what an element of either vector means."""
        text = "\n".join(_describe(block) for block in self.blocks)
        return hashlib.sha256(text.encode()).hexdigest()


def _describe(block: Block) -> str:
    parts = [f"{item.name}={getattr(block, item.name)!r}" for item in fields(block)]
    return f"{block.kind}({', '.join(part for part in parts if not part.startswith('desc'))})"
