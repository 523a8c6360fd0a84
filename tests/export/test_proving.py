"""Proofs of a bundle: what is recorded, and what a changed record or file means."""

from __future__ import annotations

import json
import tempfile
from dataclasses import dataclass
from pathlib import Path

import pytest
from click.testing import CliRunner

from symnav import pipeline
from symnav.cli import main
from symnav.emit import manifest
from symnav.errors import BuildError, ProofError
from symnav.export.proofs import proving
from symnav.export.proofs.proving import prove
from symnav.export.runners import Record, Runner, Verdict
from symnav.export.runners.programs import Reach

NAME = "reference_relative"


@dataclass(frozen=True)
class Said:
    """A runner that says what a test wants."""

    name: str
    verdict: Verdict = Verdict.PASSED
    reason: str = ""

    def missing(self) -> str:
        return self.reason

    def run(self, folder: Path) -> Record:
        assert (folder / "manifest.json").is_file()
        found = ("bad",) if self.verdict is Verdict.FAILED else ()
        return Record(self.name, "1.0", self.verdict, "something", "true", findings=found)


@dataclass(frozen=True)
class Breaks:
    """A runner whose tool is broken."""

    name: str
    error: Exception
    at_once: bool = False

    def missing(self) -> str:
        if self.at_once:
            raise self.error
        return ""

    def run(self, folder: Path) -> Record:
        raise self.error


GOOD, BAD = Said("good"), Said("bad", Verdict.FAILED)
ABSENT = Said("absent", reason="nobody installed it")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A bundle."""
    pipeline.export(pipeline.load(NAME), tmp_path)
    return tmp_path


def state(folder: Path) -> str:
    return manifest.check(folder, None).state


def test_records_stand_beside_their_inputs(folder: Path) -> None:
    proven = prove(folder, (GOOD, ABSENT))
    assert proven.passed and [record.tool for record in proven.missing] == ["absent"]
    assert not (folder / "proof/absent.json").exists()
    record = json.loads((folder / "proof/good.json").read_text())
    assert record["verdict"] == "passed" and record["version"] == "1.0"
    assert str(folder) not in (folder / "proof/good.json").read_text()
    assert state(folder) == "fresh"


def test_one_failure_is_enough(folder: Path) -> None:
    assert not prove(folder, (GOOD, BAD)).passed
    assert json.loads((folder / "proof/bad.json").read_text())["findings"] == ["bad"]


@pytest.mark.parametrize("at_once", [False, True])
@pytest.mark.parametrize(
    "error",
    [
        BuildError("clang-19 exits with 1"),
        ProofError("the tests fail"),
        FileNotFoundError(2, "No such file or directory", "clang-19"),
        KeyError("data"),
    ],
    ids=lambda error: type(error).__name__,
)
def test_a_runner_that_breaks_has_failed(folder: Path, error: Exception, at_once: bool) -> None:
    proven = prove(folder, (Breaks("broken", error, at_once), GOOD))
    assert not proven.passed
    assert [record.verdict.value for record in proven.records] == ["failed", "passed"]
    record = json.loads((folder / "proof/broken.json").read_text())
    assert record["verdict"] == "failed" and str(error) in record["findings"][0]
    assert record["shown"].startswith("broke off: ") and state(folder) == "fresh"


def test_a_record_of_what_broke_names_no_place(folder: Path) -> None:
    with tempfile.TemporaryDirectory(prefix="symnav-") as scratch:
        text = f"{scratch}/a.c: refused\n\n{folder.resolve()}/src/b.c: as well"
        prove(folder, (Breaks("broken", BuildError(text)),))
    findings = json.loads((folder / "proof/broken.json").read_text())["findings"]
    assert findings == ["a.c: refused", "src/b.c: as well"]


def test_a_clang_that_fails_is_a_row_and_a_record(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("clang-19", "llvm-profdata-19", "llvm-cov-19"):
        fake = tmp_path / "bin" / name
        fake.parent.mkdir(exist_ok=True)
        fake.write_text("#!/bin/sh\nexit 1\n")
        fake.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}:/bin")
    only_run(monkeypatch, Reach())
    folder = tmp_path / "bundle"
    done = CliRunner().invoke(main, ["export", NAME, "--to", str(folder), "--prove"])
    assert done.exit_code == 3 and "mcdc" in done.output and "failed" in done.output
    text = (folder / "proof/mcdc.json").read_text()
    assert json.loads(text)["verdict"] == "failed" and "clang-19" in text
    assert str(tmp_path) not in text


def only_run(monkeypatch: pytest.MonkeyPatch, runner: Runner) -> None:
    """Make one runner all there are."""
    defaults = prove.__defaults__
    assert defaults is not None
    monkeypatch.setattr(proving.prove, "__defaults__", ((runner,), *defaults[1:]))


def test_same_results_have_same_bytes(folder: Path) -> None:
    prove(folder, (GOOD,))
    before = (folder / "proof/good.json").read_bytes(), (folder / manifest.RESULTS).read_bytes()
    prove(folder, (GOOD,))
    after = (folder / "proof/good.json").read_bytes(), (folder / manifest.RESULTS).read_bytes()
    assert before == after


def test_a_record_changed_by_hand_is_noticed(folder: Path) -> None:
    prove(folder, (BAD,))
    record = folder / "proof/bad.json"
    record.write_text(record.read_text().replace("failed", "passed"))
    assert state(folder) == "hand-edited"
    prove(folder, (BAD,))
    (folder / "proof/made_up.json").write_text("{}")
    assert manifest.check(folder, None).files == ("proof/made_up.json",)


def test_records_of_other_files_are_stale(folder: Path) -> None:
    prove(folder, (GOOD,))
    results = folder / manifest.RESULTS
    proven = json.loads(results.read_text())
    results.write_text(json.dumps({**proven, "proven": "0" * 64}))
    report = manifest.check(folder, None)
    assert report.state == "stale" and "prove again" in report.reasons[0]


def test_records_go_with_what_they_were_of(folder: Path) -> None:
    prove(folder, (GOOD,))
    again = pipeline.export(pipeline.load(NAME), folder)
    assert again.unchanged and (folder / "proof/good.json").is_file()
    other = pipeline.export(pipeline.load(NAME), folder, scalar="float")
    assert not other.unchanged
    assert not (folder / "proof/good.json").exists()
    assert not (folder / manifest.RESULTS).exists()
    assert state(folder) == "fresh"


def test_earlier_records_go(folder: Path) -> None:
    prove(folder, (GOOD, BAD))
    prove(folder, (GOOD,))
    assert not (folder / "proof/bad.json").exists() and state(folder) == "fresh"


def test_a_list_that_cannot_be_read(folder: Path) -> None:
    (folder / manifest.RESULTS).write_text("nonsense")
    done = CliRunner().invoke(main, ["check", str(folder)])
    assert done.exit_code == 2 and "prove the bundle again" in done.output
    prove(folder, (GOOD,))
    assert state(folder) == "fresh"


@pytest.mark.parametrize(("runner", "code"), [(GOOD, 0), (BAD, 3), (ABSENT, 0)])
def test_exit_code(
    runner: Said, code: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    only_run(monkeypatch, runner)
    arguments = ["export", NAME, "--to", str(tmp_path / "bundle"), "--prove"]
    done = CliRunner().invoke(main, arguments)
    assert done.exit_code == code, done.output
    assert runner.name in done.output
    assert ("Did not run: absent: nobody installed it." in done.output) == (runner is ABSENT)
    as_json = CliRunner().invoke(main, [*arguments, "--json"])
    assert as_json.exit_code == code
    said = json.loads(as_json.output)
    assert said["proofs"][0]["tool"] == runner.name and said["passed"] == (code == 0)
    assert "seconds" in said["proofs"][0]
