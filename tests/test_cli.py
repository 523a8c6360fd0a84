"""The command line: verbs, exit codes, JSON, and what it costs to ask for help."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import click
import pytest
from click.testing import CliRunner, Result

from symnav import pipeline
from symnav.cli import main
from symnav.errors import BuildError, InputError, Problem, SpecError

VERBS = (
    "new", "generate", "build", "verify", "bench", "export", "check", "list", "doctor", "demo",
)  # fmt: skip
HEAVY = ("sympy", "casadi", "pydantic", "rich", "numpy", "jinja2", "cffi")


def run(*words: str) -> Result:
    """Runs one command line in this process."""
    return CliRunner().invoke(main, list(words))


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty working directory."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("verb", VERBS)
def test_help_has_json_and_a_sentence(verb: str) -> None:
    """Every verb explains itself and offers --json."""
    result = run(verb, "--help")
    assert result.exit_code == 0
    assert "--json" in result.output
    assert main.commands[verb].help


@pytest.mark.parametrize("verb", [verb for verb in VERBS if verb not in {"list", "doctor"}])
def test_help_has_examples(verb: str) -> None:
    """Verbs with arguments show how they are typed, and the examples parse."""
    epilog = main.commands[verb].epilog or ""
    lines = [line.strip() for line in epilog.splitlines() if line.strip().startswith("symnav ")]
    assert lines
    for line in lines:
        words = line.split("   ")[0].split()
        assert words[1] == verb
        command = main.commands[verb]
        existing = {"--reference": str(Path(__file__).parent)}
        words = [
            existing.get(before, word) for before, word in zip(["", *words], words, strict=False)
        ]
        command.make_context(verb, words[2:], parent=click.Context(main))


def test_verbs_are_complete() -> None:
    """The group holds these verbs and no others."""
    assert sorted(main.commands) == sorted(VERBS)


def test_help_imports_nothing_heavy() -> None:
    """Asking for help imports click and the standard library; so it answers at once."""
    done = subprocess.run(
        [sys.executable, "-X", "importtime", "-m", "symnav", "--help"],
        capture_output=True,
        text=True,
        check=True,
    )
    imported = {line.rpartition("|")[2].strip() for line in done.stderr.splitlines()}
    assert "click" in imported
    assert {name.partition(".")[0] for name in imported} & set(HEAVY) == set()


def test_help_is_quick(record_property: Callable[[str, float], None]) -> None:
    """Against an empty interpreter, because the machine may be busy: SymPy alone would be 25."""

    def seconds(*words: str) -> float:
        times = []
        for _ in range(5):
            start = time.perf_counter()
            subprocess.run([sys.executable, *words], stdout=subprocess.DEVNULL, check=True)
            times.append(time.perf_counter() - start)
        return min(times)

    empty, helped = seconds("-c", "pass"), seconds("-m", "symnav", "--help")
    record_property("help_seconds", helped)
    assert helped < 15.0 * empty


def test_unknown_verb_is_the_users_input() -> None:
    """A misspelt verb ends in 2."""
    assert run("generat").exit_code == 2


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_names_the_file(folder: Path) -> None:
    """The system knows no name where it notices; nothing half written is left."""
    full = folder / "bundle" / ".Makefile.partial"
    full.parent.mkdir()
    full.symlink_to("/dev/full")
    words = ("export", "reference_relative", "--to", "bundle", "--force")
    result = run(*words)
    assert result.exit_code == 1
    assert result.stderr == "symnav: bundle/Makefile: No space left on device\n"
    assert not full.is_symlink() and not (folder / "bundle" / "Makefile").exists()
    assert run(*words).exit_code == 0


def test_plain_output_where_nobody_watches() -> None:
    """No colours, no cursor movements."""
    result = run("doctor")
    assert "\x1b" not in result.output
    assert result.stderr == ""


class TestErrors:
    """Errors of the pipeline become one message on standard error and an exit code."""

    @pytest.fixture
    def failing(self, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[Exception], None]]:
        """Makes loading a specification raise."""
        from symnav import pipeline

        def arm(error: Exception) -> None:
            def load(_spec: str | Path) -> None:
                raise error

            monkeypatch.setattr(pipeline, "load", load)

        yield arm

    @pytest.mark.parametrize(
        ("error", "code"),
        [
            (InputError("no such block"), 2),
            (SpecError([Problem("state[0]", "no size"), Problem("state[1]", "no unit")]), 2),
            (BuildError("the compiler refused"), 1),
            (PermissionError(13, "Permission denied", "rover.toml"), 1),
        ],
    )
    def test_message_and_code(
        self, failing: Callable[[Exception], None], error: Exception, code: int
    ) -> None:
        """Plain message, no traceback, the code of the exception."""
        failing(error)
        result = run("generate", "rover.toml")
        assert result.exit_code == code
        assert result.stdout == ""
        assert result.stderr.startswith("symnav: ")
        assert "Traceback" not in result.stderr
        for problem in getattr(error, "problems", ()):
            assert str(problem) in result.stderr

    def test_json_tells_the_problems(self, failing: Callable[[Exception], None]) -> None:
        """With --json a script reads where each mistake stands."""
        failing(SpecError([Problem("state[0].size", "must be positive")], "rover.toml"))
        result = run("verify", "rover.toml", "--json")
        assert result.exit_code == 2
        told = json.loads(result.stdout)
        assert told["exit_code"] == 2
        assert told["error"]["kind"] == "SpecError"
        assert told["error"]["problems"] == [
            {"path": "state[0].size", "message": "must be positive"}
        ]

    def test_a_fault_of_symnav_is_not_hidden(self, failing: Callable[[Exception], None]) -> None:
        """What nobody raised on purpose keeps its traceback."""
        failing(ZeroDivisionError())
        assert isinstance(run("generate", "rover.toml").exception, ZeroDivisionError)


def test_missing_specification(folder: Path) -> None:
    """A name that is neither a file nor a model: exit code 2, nothing written."""
    result = run("generate", "rver.toml")
    assert result.exit_code == 2
    assert "rver" in result.stderr
    assert list(folder.iterdir()) == []


def test_a_folder_does_not_hide_the_model_of_its_name(folder: Path) -> None:
    """What was written for a model before often stands in a folder of that name."""
    (folder / "rover").mkdir()
    assert pipeline.load("rover").name == "rover"
    for name in ("./rover", "other", str(folder)):
        (folder / "other").mkdir(exist_ok=True)
        with pytest.raises(InputError, match="neither a file nor a shipped model"):
            pipeline.load(name)
    (folder / "gps").write_text("nonsense")
    with pytest.raises(InputError, match="gps: "):
        pipeline.load("gps")


def test_mistakes_leave_nothing_behind(folder: Path) -> None:
    """A specification with mistakes is not generated, in part or whole."""
    (folder / "rover.toml").write_text(
        'name = "rover"\n[[state]]\nname = "position"\nkind = "vectr"\n'
    )
    result = run("generate", "rover.toml", "--out", "out")
    assert result.exit_code == 2
    assert "state[0]" in result.stderr
    assert [path.name for path in folder.iterdir()] == ["rover.toml"]


def test_new_writes_a_specification_that_loads(folder: Path) -> None:
    """The starter is valid, and is not written over."""

    result = run("new", "rover")
    assert result.exit_code == 0, result.stderr
    spec = pipeline.load(folder / "rover.toml")
    assert spec.name == "rover"
    assert [entry.name for entry in spec.entries] == ["gps", "imu"]
    before = (folder / "rover.toml").read_bytes()
    again = run("new", "rover")
    assert again.exit_code == 2
    assert "exists already" in again.stderr
    assert (folder / "rover.toml").read_bytes() == before


@pytest.mark.parametrize("name", ["2rover", "while", "ro-ver", "sin"])
def test_new_refuses_names_that_cannot_be_symbols(folder: Path, name: str) -> None:
    """A package name is a prefix of C symbols."""
    result = run("new", name)
    assert result.exit_code == 2
    assert name in result.stderr
    assert list(folder.iterdir()) == []


def test_list(folder: Path) -> None:
    """Shipped specifications with their titles; each is a SPEC of its own."""

    shown = run("list")
    assert shown.exit_code == 0
    listed = json.loads(run("list", "--json").stdout)["models"]
    assert {"name", "title"} == set(listed[0])
    names = [model["name"] for model in listed]
    assert "single_point" in names
    for model in listed:
        assert model["name"] in shown.stdout
        assert pipeline.load(model["name"]).name == model["name"]


def test_doctor() -> None:
    """Versions, compiler and folders."""
    facts = json.loads(run("doctor", "--json").stdout)
    assert {"symnav", "python", "numpy", "casadi", "compiler", "templates", "cache"} <= set(facts)
    assert (Path(facts["templates"]) / "starter.toml.j2").is_file()


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


@dataclass(frozen=True)
class Small:
    """A generated package of one function."""

    folder: Path
    first: dict[str, Any]

    @property
    def package(self) -> Path:
        """Its folder."""
        return self.folder / "out" / "small"


@pytest.fixture
def small(folder: Path) -> Small:
    """Generates the smallest useful specification."""
    (folder / "small.toml").write_text(SMALL)
    result = run("generate", "small.toml", "--out", "out", "--json")
    assert result.exit_code == 0, result.stderr
    return Small(folder, json.loads(result.stdout))


def test_generate_says_what_it_wrote(small: Small) -> None:
    """The second run changes nothing and says so."""
    assert Path(small.first["package"]) == Path("out/small")
    assert not small.first["unchanged"]
    assert all((small.package / name).is_file() for name in small.first["written"])
    again = json.loads(run("generate", "small.toml", "--out", "out", "--json").stdout)
    assert again["unchanged"]


def test_check_fresh_stale_hand_edited(small: Small) -> None:
    """0, 4 and 5, in text and in JSON."""
    assert run("check", "out/small").exit_code == 0
    assert "fresh" in run("check", "out/small", "small.toml").stdout
    (small.folder / "small.toml").write_text(SMALL.replace("2.0 *", "3.0 *"))
    stale = run("check", "out/small", "small.toml", "--json")
    assert (stale.exit_code, json.loads(stale.stdout)["state"]) == (4, "stale")
    header = small.package / "c" / "include" / "small" / "small.h"
    header.write_text(header.read_text() + "\n")
    edited = run("check", "out/small")
    assert edited.exit_code == 5
    assert "small.h" in edited.stdout


def test_check_needs_a_package(folder: Path) -> None:
    """A folder without a manifest is the user's input."""
    (folder / "empty").mkdir()
    assert run("check", "empty").exit_code == 2
    assert run("check", "nowhere").exit_code == 2
    assert run("build", "empty").exit_code == 2


def test_build_and_verify(small: Small) -> None:
    """The extension is built beside the C; the proof sheet is printed and passes."""
    built = run("build", "out/small", "--json")
    assert built.exit_code == 0, built.stderr
    assert list(small.package.rglob("*.so"))
    sheet = run("verify", "small.toml", "--samples", "5")
    assert sheet.exit_code == 0, sheet.output
    assert "twice" in sheet.stdout
    assert json.loads(run("verify", "small.toml", "--samples", "5", "--json").stdout)


def test_failed_proof_ends_in_three(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What does not hold is printed and counted."""

    sheet = SimpleNamespace(
        passed=False,
        as_dict=lambda: {"passed": False, "worst": float("inf")},
        render=lambda console: console.print("twice: 9 ULP"),
    )
    (folder / "small.toml").write_text(SMALL)
    monkeypatch.setattr(pipeline, "verify", lambda *_args, **_kwargs: sheet)
    shown = run("verify", "small.toml")
    assert (shown.exit_code, shown.stdout) == (3, "twice: 9 ULP\n")
    told = run("verify", "small.toml", "--json")
    assert (told.exit_code, json.loads(told.stdout)["worst"]) == (3, "inf")


def test_demo_says_what_a_specification_lacks(folder: Path) -> None:
    """A specification that cannot position a receiver: what is missing, nothing written."""
    (folder / "small.toml").write_text(SMALL)
    result = run("demo", "small.toml")
    assert result.exit_code == 2
    assert "broadcast_orbit" in result.stderr
    assert "sagnac = 'none'" in result.stderr
    assert [path.name for path in folder.iterdir()] == ["small.toml"]
