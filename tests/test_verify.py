"""What ``symnav verify`` says and how it ends, on specifications that are easy and on hard ones."""

from __future__ import annotations

import json
import stat
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from symnav.cli import main

SMALL = """
name = "small"
[[state]]
name = "bias"
kind = "scalar"
unit = "m"
range = [-10.0, 10.0]
[[measurement]]
name = "twice"
equation = ["2.0 * bias"]
"""

Verify = Callable[..., Result]


@pytest.fixture
def verify(tmp_path: Path) -> Verify:
    """Verifies the text of a specification by the command line, in this process."""

    def run(text: str, *words: str) -> Result:
        path = tmp_path / "spec.toml"
        path.write_text(text, encoding="utf-8")
        return CliRunner().invoke(main, ["verify", str(path), *words])

    return run


class TestCompiler:
    """Only a compiler that is not there may be passed over."""

    def test_refused_c_is_no_proof(
        self, verify: Verify, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        """NumPy alone would pass; what the compiler says is told."""
        compiler = tmp_path / "refusing"
        compiler.write_text('#!/bin/sh\necho "rows.c:7:1: error: no such thing" >&2\nexit 1\n')
        compiler.chmod(compiler.stat().st_mode | stat.S_IXUSR)
        monkeypatch.setenv("CC", str(compiler))
        shown = verify(SMALL, "--samples", "8")
        assert shown.exit_code == 3, shown.output
        assert "FAIL" in shown.stdout and "rows.c:7:1: error: no such thing" in shown.stdout
        told = verify(SMALL, "--samples", "8", "--json")
        assert told.exit_code == 3
        assert any("no such thing" in text for text in json.loads(told.stdout)["failures"])

    def test_no_compiler_is_a_note(self, verify: Verify, monkeypatch: pytest.MonkeyPatch) -> None:
        """NumPy is proven, and the sheet says what was not."""
        monkeypatch.delenv("CC", raising=False)
        monkeypatch.setenv("PATH", "")
        told = verify(SMALL, "--samples", "8", "--json")
        assert told.exit_code == 0, told.output
        sheet = json.loads(told.stdout)
        assert any("native was not available" in note for note in sheet["notes"])
        assert {row["comparison"].split()[0] for row in sheet["rows"]} == {"numpy"}


def test_the_sheet_says_how_many_states_were_judged(verify: Verify) -> None:
    """By function, in text and in JSON; four edges of one number, and eight others."""
    sheet = json.loads(verify(SMALL, "--samples", "20", "--json").stdout)
    assert sheet["judged"] == {"twice": 12}
    shown = verify(SMALL, "--samples", "20")
    assert "States judged with 50 digits" in shown.stdout and "twice 12" in shown.stdout
    told = " ".join(CliRunner().invoke(main, ["verify", "--help"]).stdout.split())
    assert "With 50 digits, at one state for every edge and at eight others" in told
