"""Everything README.md shows is run: the specification, the commands, the Python and the C."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from symnav.cli import main

README = Path(__file__).parents[1] / "README.md"
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
UNRENDERED = re.compile(r"\{%|%\}|\{\{-?\s*[A-Za-z_]")


@dataclass(frozen=True)
class Example:
    """A folder in which the README's specification has been generated and built."""

    folder: Path
    output: str


def blocks(language: str) -> list[str]:
    """The fenced blocks of a language."""
    text = README.read_text(encoding="utf-8")
    return [body for found, body in FENCE.findall(text) if found == language]


def commands() -> list[str]:
    """The lines a reader would type."""
    lines = (line for block in blocks("console") for line in block.splitlines())
    return [line.removeprefix("$ ") for line in lines if line.startswith("$ ")]


@pytest.fixture(scope="module")
def example(tmp_path_factory: pytest.TempPathFactory) -> Example:
    """Types the README's commands that start with ``symnav``."""
    folder = tmp_path_factory.mktemp("readme")
    (specification,) = blocks("toml")
    (folder / "rover.toml").write_text(specification, encoding="utf-8")
    output = ""
    for command in commands():
        if not command.startswith("symnav "):
            continue
        words = [sys.executable, "-m", *command.split()]
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
        assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
        output += done.stdout
    return Example(folder, output)


def test_first_two_commands() -> None:
    """The demonstration, then the tests; each one line that sets up its own environment."""
    demonstration, tests = commands()[:2]
    for command in (demonstration, tests):
        assert command.startswith("python3 -m venv .venv && .venv/bin/pip install -q ")
    assert demonstration.endswith(".venv/bin/symnav demo")
    assert " -m pytest " in tests


def test_commands_work(example: Example) -> None:
    """Generate, build and verify end well and leave the package where the README says."""
    assert (example.folder / "generated" / "rover" / "__init__.py").is_file()
    assert "generated/rover" in example.output


def test_python_runs(example: Example) -> None:
    """The Python of the README runs on the generated package."""
    (code,) = blocks("python")
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=example.folder,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("[10.1 20.  -5.3]")


@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
def test_c_compiles(example: Example) -> None:
    """The C of the README compiles against the generated header without a warning."""
    (code,) = blocks("c")
    (example.folder / "predict.c").write_text(code, encoding="utf-8")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-Wno-missing-prototypes"]
    done = subprocess.run(
        ["gcc", *flags, "-I", "generated/rover/c/include", "-c", "predict.c", "-o", "predict.o"],
        cwd=example.folder,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_no_template_is_left_over(example: Example) -> None:
    """Generated files hold no marker of the template language."""
    package = example.folder / "generated" / "rover"
    texts = [p for p in package.rglob("*") if p.suffix in {".py", ".pyi", ".c", ".h", ".json"}]
    assert texts
    for path in texts:
        if path.name.startswith("_build"):
            continue
        assert UNRENDERED.search(path.read_text(encoding="utf-8")) is None, path


def test_verbs_are_those_of_the_command_line() -> None:
    """The table names every verb, and none that does not exist."""
    rows = re.findall(r"^\| `symnav (\w+)", README.read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(rows) == sorted(main.commands)
