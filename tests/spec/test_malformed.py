"""Every malformed specification gives its mistakes, all of them and nothing else."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from symnav.cli import main
from symnav.errors import InputError, Problem

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


def generate(path: Path, out: Path, *words: str) -> Result:
    """The command line, in this process."""
    return CliRunner().invoke(main, ["generate", str(path), "--out", str(out), *words])


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_mistakes_are_reported_exactly(path: Path, tmp_path: Path) -> None:
    """By the command line: all of them and nothing else, exit code 2, nothing written."""
    out = tmp_path / "out"
    told = generate(path, out, "--json")
    assert told.exit_code == InputError.exit_code == 2
    found = [Problem(**problem) for problem in json.loads(told.stdout)["error"]["problems"]]
    shown = generate(path, out)
    assert shown.exit_code == 2
    assert shown.stdout == ""
    assert shown.stderr.startswith(f"symnav: {path}: {len(found)} problem")
    for problem in found:
        assert str(problem) in shown.stderr
    for expected in expectations(path):
        matching = [p for p in found if p.path == expected.path and expected.message in p.message]
        assert len(matching) == 1, (expected, found)
        found.remove(matching[0])
    assert not found
    assert list(tmp_path.iterdir()) == []


def test_a_package_there_is_left_alone(tmp_path: Path) -> None:
    """A mistake made later does not touch what was generated before."""
    good = tmp_path / "rover.toml"
    good.write_text((FOLDER.parent / "valid" / "rover.toml").read_text(encoding="utf-8"))
    assert generate(good, tmp_path / "out").exit_code == 0
    before = {p: p.read_bytes() for p in (tmp_path / "out").rglob("*") if p.is_file()}
    assert before
    good.write_text(good.read_text() + "\nunheard_of = 1\n")
    assert generate(good, tmp_path / "out").exit_code == 2
    assert {p: p.read_bytes() for p in (tmp_path / "out").rglob("*") if p.is_file()} == before
