"""Measurements while a core is ours alone.

A virtual processor is often one of two threads of a core. What the other one does takes half of the
core away, for milliseconds or minutes, and more of it from code that keeps arithmetic units busy
than from code that waits for roots and quotients. Rounds with a core to themselves are waited for.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from symnav.build.objects import said
from symnav.emit.templates import directory

HALF = 3.5
"""Additions in a cycle that a core of four adders does, and hardly each of two threads of one."""

STEADY = 0.95
"""Of the room of a core to itself, what a measurement finds at least."""


@dataclass(frozen=True, slots=True)
class Burst:
    """Calls of one candidate, one after another.

    Attributes:
        ns: time of one evaluation.
        room: independent additions in a cycle, before or after, whichever were less.
    """

    ns: float
    room: float


Round = Mapping[str, Burst]
"""A burst of every candidate, one after another: whatever else happens meets all of them."""


@dataclass(frozen=True, slots=True)
class Quiet:
    """What is waited for.

    Attributes:
        least_room: from which on a core counts as ours alone.
        seconds: to wait at most.
    """

    least_room: float = HALF
    seconds: float = 2.0


USUAL = Quiet()
"""For a machine nothing is known about."""


def quietest(
    timed: Callable[[], Iterable[Round]], count: int, quiet: Quiet
) -> tuple[list[Round], bool]:
    """Rounds that had a core to themselves, the last ones; else those that had most of it.

    Args:
        timed: a round or more, each of the same candidates.
        count: rounds, at least one.
        quiet: what is waited for.

    Returns:
        The rounds, and whether all of them had a core to themselves.
    """
    rounds: list[Round] = []
    end = time.monotonic() + quiet.seconds
    while True:
        rounds.extend(timed())
        alone = [one for one in rounds if room_of(one) >= quiet.least_room]
        if len(alone) >= count:
            return alone[-count:], True
        if time.monotonic() > end and len(rounds) >= count:
            return sorted(rounds, key=room_of)[-count:], False


def room_of(one: Round) -> float:
    """The least of a round."""
    return min(burst.room for burst in one.values())


def medians(rounds: Sequence[Round]) -> dict[str, float]:
    """Median time of one evaluation over the rounds, in nanoseconds, by candidate."""
    return {name: round(statistics.median(one[name].ns for one in rounds), 3) for name in rounds[0]}


def least_room(seconds: float, folder: Path) -> float:
    """From which room on a core counts as ours alone, by what is found in some seconds.

    Where nobody left the core to us for so long, the answer is what two threads hardly get each.

    Args:
        seconds: to look for.
        folder: for what is compiled.
    """
    folder.mkdir(parents=True, exist_ok=True)
    executable = folder / "room"
    source = str(directory() / "bench" / "room.c")
    said("gcc", "-O2", "-std=gnu11", source, "-o", str(executable))
    return max(HALF, STEADY * float(said(str(executable), str(seconds))))
