"""Every malformed specification gives its mistakes, all of them and nothing else."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from symnav.errors import Problem, SpecError
from symnav.spec import load

FOLDER = Path(__file__).parents[1] / "data" / "malformed"
FILES = sorted(FOLDER.glob("*.toml"))
_EXPECTATION = re.compile(r"# expect: (?P<message>.*); at:(?P<path>.*)")


def expectations(path: Path) -> list[Problem]:
    """What the first comment lines of a file promise."""
    lines = path.read_text(encoding="utf-8").splitlines()
    matches = [_EXPECTATION.fullmatch(line) for line in lines if line.startswith("# expect:")]
    return [Problem(m["path"].strip(), m["message"]) for m in matches if m is not None]


def test_there_are_at_least_forty() -> None:
    assert len(FILES) >= 40
    assert all(expectations(path) for path in FILES)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_mistakes_are_reported_exactly(path: Path) -> None:
    with pytest.raises(SpecError) as caught:
        load(path)
    found = list(caught.value.problems)
    for expected in expectations(path):
        matching = [p for p in found if p.path == expected.path and expected.message in p.message]
        assert len(matching) == 1, (expected, found)
        found.remove(matching[0])
    assert not found
    assert str(caught.value).startswith(f"{path}: ")
