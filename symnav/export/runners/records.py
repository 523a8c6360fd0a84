"""What a proof runner says about a bundle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import Protocol


class Verdict(StrEnum):
    """How a proof ended."""

    PASSED = "passed"
    FAILED = "failed"
    NOT_RUN = "not run"


@dataclass(frozen=True, slots=True)
class Record:
    """The outcome of one runner.

    Attributes:
        tool: name of the runner; its record stands in ``proof/<tool>.json``.
        version: of the tool as it names itself; empty where it did not run.
        verdict: passed, failed or not run.
        shown: one sentence: what was shown, or why it did not run.
        command: how to repeat it, from the folder of the bundle.
        assumptions: what the result rests on.
        findings: what speaks against it, one line each.
        details: numbers by name, for readers and for other tools.
        seconds: how long it took; not recorded, so that equal results have equal bytes.
    """

    tool: str
    version: str
    verdict: Verdict
    shown: str
    command: str
    assumptions: tuple[str, ...] = ()
    findings: tuple[str, ...] = ()
    details: Mapping[str, object] = field(default_factory=dict)
    seconds: float = 0.0

    def as_dict(self) -> dict[str, object]:
        """The record without the time it took."""
        return {
            "tool": self.tool,
            "version": self.version,
            "verdict": self.verdict.value,
            "shown": self.shown,
            "command": self.command,
            "assumptions": list(self.assumptions),
            "findings": list(self.findings),
            "details": dict(self.details),
        }


def broken(tool: str, command: str, message: str) -> Record:
    """The record of a runner that could not finish: nothing is shown, so it failed."""
    lines = tuple(line.rstrip() for line in message.splitlines() if line.strip())
    shown = f"broke off: {lines[0]}" if lines else "broke off"
    return Record(tool, "", Verdict.FAILED, shown, command, findings=lines or (shown,))


class Runner(Protocol):
    """One tool and what it is asked about a bundle."""

    @property
    def name(self) -> str:
        """Short name, and stem of the file of its record."""
        ...

    def missing(self) -> str:
        """Why it cannot run here; empty when it can."""
        ...

    def run(self, folder: Path) -> Record:
        """Run it over the bundle in a folder; writes nothing into that folder."""
        ...
