"""When a core is ours alone, for what is timed in this process."""

from __future__ import annotations

import argparse
import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from symnav.bench.quiet import Quiet, least_room
from symnav.build.objects import said
from symnav.emit.templates import directory


@dataclass(frozen=True)
class Core:
    """The core this process runs on.

    Attributes:
        quiet: what counts as ours alone, and how long to wait for that.
        room: how much of it is ours now.
    """

    quiet: Quiet
    room: Callable[[], float]


def core(folder: Path, patience: float) -> Core:
    """Look for a third of the patience, on top of it, at what the core does for us at best.

    Args:
        folder: for what is compiled.
        patience: seconds to wait for a core to itself, for what is timed in turn.
    """
    quiet = Quiet(least_room(patience / 3, folder), patience)
    source, library = folder / "room_of.c", folder / "room_of.so"
    source.write_text('#include "room.h"\n\ndouble room_of(void) { return room(); }\n')
    include = f"-I{directory() / 'bench'}"
    shared = ["-O2", "-std=gnu11", "-shared", "-fPIC", include]
    said("gcc", *shared, str(source), "-o", str(library))
    room_of = ctypes.CDLL(str(library)).room_of
    room_of.restype = ctypes.c_double
    return Core(quiet, room_of)


def add_options(parser: argparse.ArgumentParser, repetitions: int, patience: float) -> None:
    """The options of everything that waits for a core, with what they are by default."""
    parser.add_argument("--repetitions", type=_count, default=repetitions, help="rounds")
    parser.add_argument(
        "--patience", type=float, default=patience, help="seconds to wait for a core"
    )


def _count(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError("must be 1 or more")
    return number
