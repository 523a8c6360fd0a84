"""Planted defects: the silence of a tool counts only when it tells what was planted.

A tool that is broken, or is another program of the same name, finds nothing either. So the same
command is given a few lines of C with known defects first.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from symnav.export.runners import tools
from symnav.export.runners.records import Record, Verdict

NAME = "control.c"
"""The file the defects stand in, in the folder the command is run in."""

SOURCE = """\
int planted(double x);
int planted(double x)
{
    const int *p = 0;
    int unused;
    int n = x;
    float step = 0.5;
    if (n > 3)
        n = n + 1;
    x = n / 2;
    return n + *p + (int)(x * step);
}
"""
"""Nothing is included, so that it depends on no header of the machine."""

_SAID = 300


@dataclass(frozen=True, slots=True)
class Control:
    """What a tool must say before its silence counts.

    Attributes:
        tool: its name, for messages.
        product: pattern of the line in which it says its version.
        planted: the line of every defect it must tell by the words it tells it with.
    """

    tool: str
    product: str
    planted: Mapping[str, str]

    def doubts(self, version: str, command: Sequence[str]) -> tuple[str, ...]:
        """Why silence of the tool would show nothing; nothing when it may be trusted.

        Args:
            version: what the tool says about its version.
            command: what it is asked about the control, as about every source.
        """
        if not re.search(self.product, version):
            said = f"says {version!r}" if version else "says none"
            return (f"{self.tool} is not recognised by its version: it {said}",)
        with tempfile.TemporaryDirectory(prefix="symnav-") as scratch:
            (Path(scratch) / NAME).write_text(SOURCE, encoding="utf-8")
            done = tools.call(command, Path(scratch))
        return tuple(
            f"{self.tool} does not report a planted defect, {words}; {_in_short(done)}"
            for words, line in self.planted.items()
            if not _told(done.output, words, line)
        )

    def distrusted(self, name: str, version: str, command: str, doubts: Sequence[str]) -> Record:
        """The record of a runner whose tool shows nothing by its silence."""
        shown = doubts[0].partition(";")[0]
        return Record(name, version, Verdict.FAILED, shown, command, findings=tuple(doubts))


def _told(output: str, words: str, line: str) -> bool:
    """True when the output tells a defect by its words at its line."""
    number = [text.strip() for text in SOURCE.splitlines()].index(line) + 1
    return re.search(rf"{re.escape(NAME)}:{number}:.*{re.escape(words)}", output) is not None


def _in_short(done: tools.Outcome) -> str:
    said = " ".join(done.output.split())[-_SAID:]
    return f"exit status {done.code}, it said {said!r}" if said else f"exit status {done.code}"
