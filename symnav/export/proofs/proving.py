"""Run the proofs of a bundle and record what they show beside their inputs.

The records are no part of what an export writes: ``proof/results.json`` lists them with their
digests and says which files they are about, so that a record that was changed by hand, or one of
other files, is noticed.
"""

from __future__ import annotations

import json
import re
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from symnav.emit import manifest
from symnav.errors import SymnavError
from symnav.export.runners import RUNNERS, Record, Runner, Verdict
from symnav.export.runners.records import broken


@dataclass(frozen=True, slots=True)
class Proven:
    """What the runners said, in their order."""

    records: tuple[Record, ...]

    @property
    def passed(self) -> bool:
        """True when nothing failed; what did not run does not count."""
        return not any(record.verdict is Verdict.FAILED for record in self.records)

    @property
    def missing(self) -> tuple[Record, ...]:
        """What did not run."""
        return tuple(r for r in self.records if r.verdict is Verdict.NOT_RUN)

    def as_dict(self) -> dict[str, object]:
        """All records, with the time they took."""
        return {
            "passed": self.passed,
            "proofs": [
                {**record.as_dict(), "seconds": round(record.seconds, 1)} for record in self.records
            ],
        }


def prove(
    folder: Path,
    runners: Sequence[Runner] = RUNNERS,
    progress: Callable[[str], None] = lambda _: None,
) -> Proven:
    """Run every runner over a bundle and write its record.

    Args:
        folder: the bundle.
        runners: what is run, in this order.
        progress: told each runner.
    """
    records: list[Record] = []
    for runner in runners:
        progress(f"prove: {runner.name}")
        started = time.perf_counter()
        record = _without_places(_run(runner, folder), folder)
        records.append(replace(record, seconds=time.perf_counter() - started))
    text = {
        f"proof/{record.tool}.json": json.dumps(record.as_dict(), indent=2) + "\n"
        for record in records
        if record.verdict is not Verdict.NOT_RUN
    }
    manifest.write_results(folder, text)
    return Proven(tuple(records))


def _run(runner: Runner, folder: Path) -> Record:
    """What a runner says; one that breaks has shown nothing, which is a failed proof.

    Tools that are broken, or print what nobody understands, end in errors of many kinds.
    """
    try:
        reason = runner.missing()
        if reason:
            return Record(runner.name, "", Verdict.NOT_RUN, reason, "")
        return runner.run(folder.resolve())
    except (SymnavError, OSError) as error:
        said = str(error)
    except Exception as error:
        said = f"{type(error).__name__}: {error}"
    return broken(runner.name, "", said)


def _without_places(record: Record, folder: Path) -> Record:
    """A record without the places of this run, so that equal results have equal bytes."""
    root = str(folder.resolve())
    scratch = re.compile(rf"{re.escape(tempfile.gettempdir())}/symnav-[^/\s'\"]*/?")

    def bare(text: str) -> str:
        return scratch.sub("", text.replace(f"{root}/", "").replace(root, "the bundle"))

    return replace(
        record, shown=bare(record.shown), findings=tuple(bare(text) for text in record.findings)
    )
