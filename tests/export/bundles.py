"""Bundles as a user gets them: exported once for each model and scalar type."""

from __future__ import annotations

import atexit
import functools
import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

from symnav import pipeline
from symnav.export import Bundle

MODELS = tuple(name for name, _ in pipeline.shipped())
QUICK = (("reference_relative", "double"), ("rover", "float"))
OUTER = ("rover", "double outer")
"""A bundle whose inputs are checked at the caller's border; the other has them in every call."""
SCALARS = ("double", "float")
ALL = tuple((model, scalar) for model in MODELS for scalar in SCALARS)

_FOLDER = Path(tempfile.mkdtemp(prefix="bundles-"))
atexit.register(shutil.rmtree, _FOLDER, ignore_errors=True)


def cases(
    quick: Sequence[tuple[str, str]] = QUICK, slow: Sequence[tuple[str, str]] = ALL
) -> list[object]:
    """Some bundles in every run, others in the slow one."""
    marks = dict.fromkeys(slow, (pytest.mark.slow,)) | dict.fromkeys(quick, ())
    return [
        pytest.param(*case, id="-".join(case).replace(" ", "-"), marks=mark)
        for case, mark in marks.items()
    ]


@functools.cache
def bundle_of(model: str, scalar: str) -> Path:
    """A folder with the bundle of a shipped model; to be read, not written."""
    folder = _FOLDER / f"{model}-{scalar.replace(' ', '-')}"
    kind, _, guards = scalar.partition(" ")
    pipeline.export(pipeline.load(model), folder, scalar=kind, guards=guards or None)
    return folder


@functools.cache
def records_of(model: str, scalar: str) -> Bundle:
    """What the bundle was assembled from."""
    kind, _, guards = scalar.partition(" ")
    return pipeline.bundle(pipeline.load(model), kind, guards=guards or None)


def files(folder: Path) -> dict[str, bytes]:
    """Content by path."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def run(
    words: Sequence[str | Path], folder: Path, environment: Mapping[str, str] | None = None
) -> str:
    """The output of a command that must end well."""
    done = subprocess.run(
        [str(word) for word in words],
        cwd=folder,
        env={**os.environ, **(environment or {})},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, f"{words}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def copy_of(model: str, scalar: str, folder: Path) -> Path:
    """A copy of the bundle of a shipped model that a test may change."""
    target = folder / f"{model}_{scalar.replace(' ', '_')}"
    shutil.copytree(bundle_of(model, scalar), target)
    return target


def replace_in(path: Path, old: str, new: str, count: int = -1) -> None:
    """Change a file; what is changed must be there."""
    text = path.read_text()
    assert old in text, f"{path.name} does not hold {old!r}"
    path.write_text(text.replace(old, new, count))
