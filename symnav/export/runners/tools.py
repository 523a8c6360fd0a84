"""Finding and calling other programs."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

TIMEOUT = 1800.0
"""Seconds after which a tool is given up."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a program said.

    Attributes:
        code: its exit status; -1 where it was given up.
        output: standard output and standard error, in the order they came.
    """

    code: int
    output: str


def find(*names: str) -> str:
    """Path of the first program of these: beside this Python, then on the search path.

    Empty where there is none.
    """
    beside = Path(sys.executable).parent
    for name in names:
        own = beside / name
        found = str(own) if own.is_file() else shutil.which(name)
        if found:
            return found
    return ""


def call(
    command: Sequence[str],
    folder: Path,
    *,
    timeout: float = TIMEOUT,
    environment: dict[str, str] | None = None,
) -> Outcome:
    """Run a program in a folder, in English."""
    settings = {**os.environ, "LC_ALL": "C", **(environment or {})}
    try:
        done = subprocess.run(
            list(command),
            cwd=folder,
            env=settings,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            timeout=timeout,
            check=False,
        )
    except subprocess.TimeoutExpired as error:
        said = error.stdout if isinstance(error.stdout, str) else ""
        return Outcome(-1, f"{said}\ngiven up after {timeout:.0f} s")
    return Outcome(done.returncode, done.stdout)


def version(command: Sequence[str]) -> str:
    """The first line with a digit of what a program says about itself."""
    output = call(command, Path.cwd(), timeout=60.0).output
    lines = [line.strip() for line in output.splitlines() if re.search(r"\d+\.\d+", line)]
    return lines[0] if lines else ""


def sources(folder: Path) -> list[str]:
    """Translation units of a bundle, relative to it, in order."""
    return sorted(path.relative_to(folder).as_posix() for path in (folder / "src").glob("*.c"))


def in_float(folder: Path, source: str) -> bool:
    """True when a translation unit belongs to a tree of single precision."""
    name = Path(source).stem
    prefixes = [path.name for path in (folder / "include").iterdir() if path.is_dir()]
    owner = max((prefix for prefix in prefixes if f"{name}_".startswith(f"{prefix}_")), key=len)
    text = (folder / "include" / owner / f"{owner}_types.h").read_text(encoding="utf-8")
    return f"typedef float {owner}_real_t;" in text
