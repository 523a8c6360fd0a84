"""The recorded files are the ones the licence notice speaks of."""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest


@pytest.mark.parametrize("name", ["SEPT078M1.21O", "SEPT078M.21P"])
def test_files_are_unchanged(data_folder: Path, name: str) -> None:
    """Their digests stand in the notice."""
    notice = (data_folder / "LICENSE-cssrlib").read_text(encoding="utf-8")
    digest = hashlib.sha256((data_folder / name).read_bytes()).hexdigest()
    assert f"{digest}  {name}" in notice
    assert "MIT License" in notice
    assert "Copyright (c) 2021 Rui Hirokawa" in notice
