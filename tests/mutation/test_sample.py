"""Thirty mutants, chosen by a seed: tests kill them, or they are reviewed."""

from __future__ import annotations

import os

import pytest

from tests.mutation import table
from tests.mutation.mutants import mutants
from tests.mutation.run import PROJECT, copy_of, evaluate, sample

SEED = int(os.environ.get("SYMNAV_MUTATION_SEED", "1"))
COUNT = 30
JOBS = 2


@pytest.mark.mutation
def test_sample() -> None:
    """The tests that killed them before go first, then the quick ones.

    What needs more tests than those is not looked for here, for that takes many minutes a mutant:
    ``python -m tests.mutation.run --resume`` does, and notes in the table which test it was.
    """
    rows, reviewed = table.read(), table.reviews()
    alive: list[str] = []
    with copy_of(PROJECT) as root:
        chosen = sample(mutants(root), COUNT, SEED)
        chosen = [m for m in chosen if not table.is_reviewed(m, reviewed)]

        def report(row: table.Row) -> None:
            if row.verdict == "survived":
                alive.append(f"{row.id}: {row.change}")

        evaluate(root, chosen, rows, jobs=JOBS, thorough=False, report=report, baseline=False)
    assert alive == [], f"SYMNAV_MUTATION_SEED={SEED} chooses the same mutants again"


def test_table_has_no_open_survivor() -> None:
    """What survived every test has a reason."""
    reviewed = table.reviews()
    rows = table.read()
    alive = {name: row.change for name, row in rows.items() if row.verdict == "survived"}
    assert {n: c for n, c in alive.items() if n not in reviewed or reviewed[n].change != c} == {}


def test_reviews_are_about_survivors() -> None:
    """A reason for what tests kill has had its day."""
    rows = table.read()
    for review in table.reviews().values():
        assert len(review.reason) > 20
        assert review.id not in rows or rows[review.id].verdict == "survived", review.id


def test_table_covers_every_mutant() -> None:
    """New and rewritten sites have been met by the tests.

    ``python -m tests.mutation.run --resume`` evaluates what the table lacks and nothing else.
    """
    rows = table.read()
    changes = {m.id: m.change for m in mutants(PROJECT)}
    lacking = [n for n, change in changes.items() if n not in rows or rows[n].change != change]
    assert lacking == []


def test_every_reviewed_mutant_exists() -> None:
    """Functions that are renamed or rewritten ask for a new look."""
    existing = {m.id: m.change for m in mutants(PROJECT)}
    for review in table.reviews().values():
        assert existing.get(review.id) == review.change, review.id
