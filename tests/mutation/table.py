"""The table of results and the list of reviewed survivors."""

from __future__ import annotations

import csv
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path

from tests.mutation.mutants import Mutant

HERE = Path(__file__).parent
TABLE = HERE / "table.csv"
REVIEWED = HERE / "survivors.toml"


@dataclass(frozen=True)
class Row:
    """What became of one mutant.

    Attributes:
        id: of the mutant.
        kind: of its site.
        change: before and after.
        digest: of the function when it was evaluated.
        verdict: ``killed`` or ``survived``.
        stage: ``quick`` or ``full``: which tests decided.
        killed_by: the first test that failed, or ``import``, ``timeout``.
    """

    id: str
    kind: str
    change: str
    digest: str
    verdict: str
    stage: str
    killed_by: str


@dataclass(frozen=True)
class Review:
    """A survivor that is none: why no test can tell it from the original."""

    id: str
    change: str
    reason: str


def row(mutant: Mutant, stage: str, killed_by: str | None) -> Row:
    """The row of a result."""
    verdict = "survived" if killed_by is None else "killed"
    return Row(
        mutant.id, mutant.kind, mutant.change, mutant.digest, verdict, stage, killed_by or ""
    )


def read(path: Path = TABLE) -> dict[str, Row]:
    """Rows by mutant; empty where there is no table yet."""
    if not path.is_file():
        return {}
    with path.open(encoding="utf-8", newline="") as file:
        return {entry["id"]: Row(**entry) for entry in csv.DictReader(file)}


def write(rows: Iterable[Row], order: Iterable[Mutant], path: Path = TABLE) -> None:
    """The whole table, in the order of the mutants, replaced at once."""
    by_id = {entry.id: entry for entry in rows}
    partial = path.with_suffix(".partial")
    with partial.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, [f.name for f in fields(Row)], lineterminator="\n")
        writer.writeheader()
        writer.writerows(asdict(by_id[m.id]) for m in order if m.id in by_id)
    partial.replace(path)


def reviews(path: Path = REVIEWED) -> dict[str, Review]:
    """Reviewed survivors by mutant."""
    if not path.is_file():
        return {}
    entries = tomllib.loads(path.read_text(encoding="utf-8")).get("survivor", [])
    return {entry["id"]: Review(**entry) for entry in entries}


def is_fresh(mutant: Mutant, rows: Mapping[str, Row]) -> bool:
    """True when the table's row is about this very change of this very function."""
    entry = rows.get(mutant.id)
    return entry is not None and (entry.digest, entry.change) == (mutant.digest, mutant.change)


def is_settled(mutant: Mutant, rows: Mapping[str, Row], *, thorough: bool) -> bool:
    """True when nothing new can come out: killed, or survived all that would be run."""
    if not is_fresh(mutant, rows):
        return False
    entry = rows[mutant.id]
    return entry.verdict == "killed" or entry.stage == "full" or not thorough


def is_reviewed(mutant: Mutant, reviewed: Mapping[str, Review]) -> bool:
    """True when the survivor has a reason, and the reason is about this change."""
    review = reviewed.get(mutant.id)
    return review is not None and review.change == mutant.change
