"""Memory that is asked for before it is needed, where many epochs are read and written by row.

Rows that lie beyond the first-level cache take about as long to come as what is computed from
them; asked for ahead, they come meanwhile. They are asked for one by one, between the rows that are
moved: many at once wait for each other, and a batch becomes slower. Integers, of which there are
few, are left to the processor.
"""

from __future__ import annotations

from collections.abc import Iterable

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.items import scaled
from symnav.emit.c.pieces import call

FETCH_AHEAD = "fetch_ahead"
"""The helper."""

Rows = tuple[str, str, str]
"""Name of an array, how many numbers of it are wanted, and where they begin."""


def argument_rows(arguments: Iterable[ir.Argument], epoch: str) -> list[Rows]:
    """What is read of one epoch: its own numbers, which may be fewer than its step.

    Where all epochs share an argument, it is asked for again, which costs next to nothing.
    """
    return [
        (a.name, scaled(a.size, "n") if a.item else str(a.size), f"{epoch} * {a.name}_step")
        for a in arguments
        if not a.integer
    ]


def fetches(rows: Iterable[Rows], depth: int) -> list[str]:
    """Statements that ask for rows."""
    return [
        line
        for name, count, place in rows
        for line in comments.code(f"{call(FETCH_AHEAD, [count, f'&{name}[{place}]'])};", depth)
    ]
