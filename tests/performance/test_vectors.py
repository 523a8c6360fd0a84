"""Loops over items and over epochs run in vector registers, those that check included.

A loop the compiler gives up on is no error anywhere, and some times slower: a selection it turns
into a branch, or a load it moves behind one, is enough.
"""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from symnav import pipeline
from symnav.bench.program import FLAG_SETS
from symnav.build.objects import said
from tests.performance.callgrind import compiler

MODELS = [name for name, _ in pipeline.shipped()]
CHECKED_WITH = "gcc 12 x86_64"
LIBRARY = ("atan2", "sin", "cos")
"""Functions of the C library that have no vector form."""


def loops(source: Path) -> dict[int, str]:
    """The lines of loops that are to run side by side, and the functions they are in."""
    found: dict[int, str] = {}
    function = ""
    lines = source.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, start=1):
        opening = re.match(r"(?:\w+ )*(\w+)\($", line)
        function = opening.group(1) if opening else function
        if line.endswith("_IVDEP"):
            found[number + 1] = function
    return found


def vectorised(source: Path, include: Path) -> set[int]:
    """The lines of loops of a file that gcc runs in vector registers of 32 bytes."""
    report = source.with_suffix(".vectors")
    options = [*FLAG_SETS["v3"], f"-fopt-info-vec={report}", f"-I{include}", "-c"]
    said("gcc", "-std=gnu99", *options, str(source), "-o", str(source.with_suffix(".o")))
    pattern = rf"{re.escape(source.name)}:(\d+):\d+: optimized: loop vectorized using 32 byte"
    return {int(number) for number in re.findall(pattern, report.read_text(encoding="utf-8"))}


def calls_library(kernel: Path) -> bool:
    """True when a kernel calls what the C library has in no vector form."""
    text = kernel.read_text(encoding="utf-8")
    return re.search(rf"(?<!\w)(?:{'|'.join(LIBRARY)})\(", text) is not None


@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
@pytest.mark.parametrize("name", MODELS)
def test_loops_are_vectorised(name: str, tmp_path: Path) -> None:
    """All of them, but for those that call the library."""
    if compiler() != CHECKED_WITH:
        pytest.skip(f"which loops a compiler can take differs; this is about {CHECKED_WITH}")
    tree = pipeline.generate(pipeline.load(name), tmp_path).package / "c"
    for source in sorted((tree / "src").glob("*.c")):
        wanted, done = loops(source), vectorised(source, tree / "include")
        kernel = source.with_name(f"{source.stem}_kernel.h")
        lacking = [
            function
            for line, function in wanted.items()
            if not done & {line, line - 1}
            and not (calls_library(kernel) and "evaluate" in function)
        ]
        assert wanted and lacking == [], source.name
