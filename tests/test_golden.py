"""The golden fixture itself: it fails when it should, and writes only when asked."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conftest import Golden


def test_accepts_the_same_text(tmp_path: Path) -> None:
    """What was written is accepted again."""
    file = tmp_path / "folder" / "case.txt"
    Golden(file, update=True)("one\ntwo\n")
    Golden(file, update=False)("one\ntwo\n")


def test_missing_file_names_the_option(tmp_path: Path) -> None:
    """A new test says how to make its file, and does not make it."""
    file = tmp_path / "case.txt"
    with pytest.raises(pytest.fail.Exception, match="--update-golden"):
        Golden(file, update=False)("one\n")
    assert not file.exists()


def test_difference_is_shown(tmp_path: Path) -> None:
    """The message holds the lines that differ, and the file stays."""
    file = tmp_path / "case.txt"
    file.write_text("one\ntwo\n")
    with pytest.raises(pytest.fail.Exception, match=r"-two\n\+three"):
        Golden(file, update=False)("one\nthree\n")
    assert file.read_text() == "one\ntwo\n"


@pytest.mark.parametrize("case", ["a b", "c/d"])
def test_file_belongs_to_the_test(golden: Golden, case: str) -> None:
    """Named after test file and test, with every parameter made safe for a file system."""
    assert golden.file.parent.name == "test_golden"
    assert (
        golden.file.name
        == f"test_file_belongs_to_the_test-{case.replace(' ', '-').replace('/', '-')}-.txt"
    )
