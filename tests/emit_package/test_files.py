"""The files of a package as text: clean, narrow, the same every time, and reviewed."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from symnav import ir
from symnav.emit.templates import render
from tests.conftest import Golden
from tests.emit_numpy import modules, packages

ROOT = Path(__file__).parents[2]
MODULE = modules.module()
TEXT = packages.text_of(MODULE, replace(MODULE, name="rover_f32", scalar=ir.Scalar.FLOAT))
STATIC = [
    name
    for name in TEXT
    if name.startswith("_") and name not in ("__init__.py", "__init__.pyi", "_interface.py")
]


def test_tree() -> None:
    """Every back end has its module and its stub."""
    assert {path for path in TEXT if not path.startswith("_")} == {
        "casadi.py", "casadi.pyi", "native.py", "native.pyi", "native_f32.py", "native_f32.pyi",
        "numpy.py", "numpy.pyi", "py.typed", "straight/calls.h", "straight/straight.h",
        "straight/rover_straight.c",
        "straight/rover_straight.h", "straight/rover_f32_straight.c",
        "straight/rover_f32_straight.h",
    }  # fmt: skip
    assert "native_f32.py" not in packages.text_of(MODULE)


@pytest.mark.parametrize("path", TEXT)
def test_lines(path: str) -> None:
    """Narrow lines, no blanks at their ends, one line break at the end, nothing unrendered."""
    text = TEXT[path]
    assert all(len(line) <= 100 and line == line.rstrip() for line in text.splitlines())
    assert text == "" or (text.endswith("\n") and not text.endswith("\n\n"))
    assert not any(mark in text for mark in ("{{", "{%", "%}", "{#"))
    assert "\n\n\n\n" not in text


def test_static_files_are_those_of_the_repository() -> None:
    """What does not depend on the model is copied byte for byte."""
    assert len(STATIC) >= 8
    for name in STATIC:
        original = (ROOT / "templates" / "package" / name).read_text(encoding="utf-8")
        assert TEXT[name] == original == render(f"package/{name}")


def test_lint(tmp_path: Path) -> None:
    """Generated files pass the linter, imports in order and docstrings included."""
    pytest.importorskip("ruff")
    packages.write(TEXT, tmp_path / "rover")
    longest = "a_name_of_all_the_31_characters"
    functions = (replace(modules.gps(), name=longest), replace(modules.ranges(), name="b" * 31))
    long = modules.module(*functions, name=longest)
    packages.write(packages.text_of(long, replace(long, name=f"{longest}_f32")), tmp_path / longest)
    rules = "E,W,F,I,UP,B,C4,RUF"
    command = [sys.executable, "-m", "ruff", "check", "--isolated", "--no-cache"]
    options = ["--select", rules, "--line-length", "100", "--target-version", "py311", "."]
    done = subprocess.run(
        [*command, *options], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout


def test_same_bytes_whatever_the_hash_seed() -> None:
    """Nothing depends on the order of a set."""
    code = (
        "import hashlib\n"
        "from tests.emit_package.test_files import TEXT\n"
        "print(hashlib.sha256(repr(TEXT).encode()).hexdigest())"
    )
    digests = set()
    for seed in ("0", "1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        done = subprocess.run(
            [sys.executable, "-c", code], cwd=ROOT, env=environment, capture_output=True, text=True,
            check=True,
        )  # fmt: skip
        digests.add(done.stdout)
    assert len(digests) == 1


@pytest.mark.parametrize(
    "path",
    [
        "__init__.py",
        "_interface.py",
        "__init__.pyi",
        "numpy.py",
        "native.py",
        "casadi.py",
        "straight/rover_straight.c",
    ],
)
def test_golden(path: str, golden: Golden) -> None:
    """The text of a small package, for review."""
    golden(packages.text_of(modules.module(modules.gps(), modules.ranges()))[path])
