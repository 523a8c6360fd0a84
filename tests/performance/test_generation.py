"""What generation costs grows no faster than the state, and not at all with the satellites.

Calls are counted, not seconds: of Python and of C, from the specification to the files.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

from benchmarks.problems import PROBLEMS
from symnav import pipeline

STATE = """
name = "wide"

[[frame]]
name = "n"
axes = "ned"

[[frame]]
name = "b"
axes = "free"

[[state]]
name = "position"
kind = "vector"
size = 3
unit = "m"
frame = "n"
range = [-1e5, 1e5]

[[state]]
name = "attitude"
kind = "rotation"
maps = "b -> n"

[[measurement]]
name = "gps"
model = "gnss_position"
position = "position"
attitude = "attitude"
lever_arm = "input"
"""
BIAS = """
[[state]]
name = "bias_{number}"
kind = "vector"
size = 3
unit = "m"
frame = "n"
range = [-10.0, 10.0]
"""


def calls(run: Callable[[], Any]) -> int:
    """How many functions are called."""
    count = 0

    def counting(_frame: FrameType, event: str, _argument: Any) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(counting)
    try:
        run()
    finally:
        sys.setprofile(before)
    return count


def generating(text: str, folder: Path) -> int:
    """Calls from a specification to its package."""
    folder.mkdir()
    file = folder / "wide.toml"
    file.write_text(text, encoding="utf-8")
    return calls(lambda: pipeline.generate(pipeline.load(file), folder))


def test_grows_with_the_blocks(tmp_path: Path) -> None:
    """Twice the blocks added cost twice as much, and little more."""
    sizes = (8, 32, 96, 224)
    texts = {n: STATE + "".join(BIAS.format(number=k) for k in range(n)) for n in sizes}
    # The first fills what is kept of expressions and templates.
    _, few, more, most = (generating(texts[n], tmp_path / str(n)) for n in sizes)
    assert more > few
    assert most - more < 1.15 * 2 * (more - few)


def test_does_not_grow_with_the_satellites(tmp_path: Path) -> None:
    """The most there may be is a number in the text."""
    (text,) = (p.spec.read_text(encoding="utf-8") for p in PROBLEMS if p.name == "pr8")
    declared = "maximum = 32"
    assert declared in text
    counts = [
        generating(text.replace(declared, f"maximum = {most}"), tmp_path / f"{number}")
        for number, most in enumerate((8, 8, 64))
    ]
    assert counts[2] < 1.01 * counts[1]
