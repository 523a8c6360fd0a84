"""Run the proofs of a bundle and record what they show beside their inputs.

The records are no part of what an export writes: ``proof/results.json`` lists them with their
digests and says which files they are about, so that a record that was changed by hand, or one of
other files, is noticed.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from symnav.emit import manifest
from symnav.export.runners import RUNNERS, Record, Runner, Verdict


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
        record = _run(runner, folder)
        records.append(replace(record, seconds=time.perf_counter() - started))
    text = {
        f"proof/{record.tool}.json": json.dumps(record.as_dict(), indent=2) + "\n"
        for record in records
        if record.verdict is not Verdict.NOT_RUN
    }
    manifest.write_results(folder, text)
    return Proven(tuple(records))


def _run(runner: Runner, folder: Path) -> Record:
    reason = runner.missing()
    if reason:
        return Record(runner.name, "", Verdict.NOT_RUN, reason, "")
    return runner.run(folder.resolve())
