"""The wheel: installed in an empty environment, it can do everything the checkout can."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Sequence
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]

pytestmark = pytest.mark.slow


def run(words: Sequence[str | Path], folder: Path) -> str:
    """Runs a command outside the checkout and gives its output."""
    outside = {k: v for k, v in os.environ.items() if k not in {"PYTHONPATH", "VIRTUAL_ENV"}}
    done = subprocess.run(
        [str(word) for word in words],
        cwd=folder,
        env=outside,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, f"{words}\n{done.stdout}\n{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def distributions(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The source distribution, and the wheel made from it."""
    folder = tmp_path_factory.mktemp("dist")
    run([sys.executable, "-m", "build", "--outdir", folder, ROOT], folder)
    (wheel,) = folder.glob("*.whl")
    (sdist,) = folder.glob("*.tar.gz")
    return sdist, wheel


@pytest.fixture(scope="module")
def environment(distributions: tuple[Path, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A new environment with the wheel and what it depends on."""
    _, wheel = distributions
    folder = tmp_path_factory.mktemp("environment")
    run([sys.executable, "-m", "venv", folder], folder)
    run([folder / "bin" / "pip", "install", "-q", wheel], folder)
    return folder


def names(folder: Path, root: Path, pattern: str) -> set[str]:
    """Files below a folder, with paths relative to a root."""
    found = (path for path in folder.rglob(pattern) if path.is_file())
    return {path.relative_to(root).as_posix() for path in found if "__pycache__" not in path.parts}


def test_wheel_holds_everything_that_is_read_at_run_time(distributions: tuple[Path, Path]) -> None:
    """Modules, specifications, data, type marker and templates; nothing else at the top."""
    _, wheel = distributions
    inside = set(zipfile.ZipFile(wheel).namelist())
    package = {f"symnav/{name}" for name in names(ROOT / "symnav", ROOT / "symnav", "*")}
    templates = {
        f"symnav/templates/{n}" for n in names(ROOT / "templates", ROOT / "templates", "*")
    }
    assert package | templates <= inside
    assert "symnav/models/single_point.toml" in inside
    assert "symnav/py.typed" in inside
    tops = {name.partition("/")[0] for name in inside}
    assert len(tops) == 2
    assert all(top == "symnav" or top.endswith(".dist-info") for top in tops)


def test_source_distribution_holds_the_tests(distributions: tuple[Path, Path]) -> None:
    """What a packager needs: tests, templates, licence."""
    sdist, _ = distributions
    with tarfile.open(sdist) as archive:
        inside = {name.partition("/")[2] for name in archive.getnames()}
    assert {"tests/test_wheel.py", "templates/starter.toml.j2", "LICENSE", "README.md"} <= inside


def test_installed_command_lists_and_generates(environment: Path, tmp_path: Path) -> None:
    """Away from the checkout: shipped models, templates, compiler, generated package."""
    symnav, python = environment / "bin" / "symnav", environment / "bin" / "python"
    listed = json.loads(run([symnav, "list", "--json"], tmp_path))["models"]
    shipped = {Path(name).stem for name in names(ROOT / "symnav" / "models", ROOT, "*.toml")}
    assert {model["name"] for model in listed} == shipped
    run([symnav, "generate", "single_point", "--out", "out"], tmp_path)
    run([symnav, "build", "out/single_point"], tmp_path)
    told = run(
        [python, "-c", "import out.single_point as m; print(m.BACKEND, m.__file__)"], tmp_path
    )
    backend, _, file = told.strip().partition(" ")
    assert backend == "native"
    assert Path(file).is_relative_to(tmp_path)
    facts = json.loads(run([symnav, "doctor", "--json"], tmp_path))
    assert Path(facts["templates"]).is_relative_to(environment)
