"""Bundles that several tests look at, written once."""

from __future__ import annotations

import shutil
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

from symnav import pipeline

MODELS = [name for name, _ in pipeline.shipped()]
SCALARS = ("float", "double")


@cache
def _written(model: str, scalar: str) -> Path:
    folder = Path(mkdtemp(prefix="symnav-bundle-"))
    pipeline.export(pipeline.load(model), folder, scalar=scalar)
    return folder


def bundle(model: str, scalar: str, folder: Path) -> Path:
    """A copy of the bundle of a shipped model that a test may change."""
    target = folder / f"{model}_{scalar}"
    shutil.copytree(_written(model, scalar), target)
    return target


def replace_in(path: Path, old: str, new: str) -> None:
    """Change a file; what is changed must be there."""
    text = path.read_text()
    assert old in text, f"{path.name} does not hold {old!r}"
    path.write_text(text.replace(old, new))
