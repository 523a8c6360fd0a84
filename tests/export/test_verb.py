"""The verb: what a user reads and types next, what a program reads, what a watcher sees."""

from __future__ import annotations

import json
import re
import shlex
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner

from symnav import pipeline
from symnav.cli import main
from symnav.emit import manifest
from tests.export.bundles import OUTER, bundle_of, files, run


def export(*words: str) -> str:
    result = CliRunner().invoke(main, ["export", *words])
    assert result.exit_code == 0, result.output
    return result.output


@pytest.mark.skipif(shutil.which("make") is None, reason="needs make")
def test_summary_says_what_was_written_and_what_is_next(tmp_path: Path) -> None:
    folder = tmp_path / "with space"
    first, *rest = export("rover", "--to", str(folder), "--scalar", "float").splitlines()
    assert first == f"{folder}: {len(files(folder))} files written"
    assert rest[:2] == ["  rover_f32 (float): retract, local, gps, imu", "  rover (double): range"]
    command = rest[2].removeprefix("next: ").partition(", then")[0]
    assert "without a warning" in run(shlex.split(command), tmp_path)
    again = export("rover", "--to", str(folder), "--scalar", "float").splitlines()
    assert again[0] == f"{folder}: unchanged"


def test_summary_tells_what_was_removed(tmp_path: Path) -> None:
    folder = tmp_path / "bundle"
    export("reference_relative", "--to", str(folder))
    before = files(folder)
    said = export("reference_relative", "--to", str(folder), "--scalar", "float").splitlines()[0]
    after = files(folder)
    changed = sum(before.get(path) != content for path, content in after.items())
    assert said == f"{folder}: {changed} files written, {len(before.keys() - after.keys())} removed"


def test_records_of_proofs_that_go_are_counted(tmp_path: Path) -> None:
    """What was proven of the files before is not known of others."""
    folder = tmp_path / "bundle"
    export("reference_relative", "--to", str(folder))
    manifest.write_results(folder, {"proof/gcc.json": "{}\n"})
    assert export("reference_relative", "--to", str(folder)).startswith(f"{folder}: unchanged\n")
    before = files(folder)
    said = export("reference_relative", "--to", str(folder), "--scalar", "float").splitlines()[0]
    gone = before.keys() - files(folder).keys()
    assert {"proof/gcc.json", "proof/results.json"} < gone
    assert said.endswith(f"{len(gone)} removed")


def test_a_folder_has_a_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(main, ["export", "rover", "--to", ""])
    assert result.exit_code == 2 and "the name is empty" in result.output
    assert not any(tmp_path.iterdir())


def test_json_says_the_same(tmp_path: Path) -> None:
    found = json.loads(export("rover", "--to", str(tmp_path / "r"), "--json"))
    assert found["bundle"] == str(tmp_path / "r") and found["name"] == "rover"
    functions = ["retract", "local", "gps", "range", "imu"]
    assert found["trees"] == [{"prefix": "rover", "scalar": "double", "functions": functions}]
    assert sorted(found["written"]) == sorted(files(tmp_path / "r"))
    assert not found["unchanged"] and found["next"].startswith("make -C ")


def test_every_part_is_told(tmp_path: Path) -> None:
    told: list[str] = []
    pipeline.export(pipeline.load("reference_relative"), tmp_path, progress=told.append)
    assert told[:2] == ["derive", "lower"] and told[-1] == "write"
    assert {"build files", "documents", "glue", "provenance", "bill of materials"} <= set(told)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
def test_page_of_the_documentation(tmp_path: Path) -> None:
    """Its C compiles against the bundle it speaks of, and every path of its table is there."""
    page = (Path(__file__).parents[2] / "docs/export.md").read_text(encoding="utf-8")
    folder = bundle_of("rover", "float")
    blocks = re.findall(r"^```c\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    for code, spoken_of in zip(blocks, (bundle_of(*OUTER), folder), strict=True):
        (tmp_path / "page.c").write_text(code)
        include = f"-I{spoken_of / 'include'}"
        run(["gcc", "-std=c99", "-Werror", include, "-fsyntax-only", "page.c"], tmp_path)
    cells = re.findall(r"^\| (`.*?) \|", page, re.MULTILINE)
    paths = [path for cell in cells for path in re.findall(r"`([^`]+)`", cell)]
    assert len(paths) > 15
    for path in paths:
        assert list(folder.glob(path.rstrip("/"))), path
