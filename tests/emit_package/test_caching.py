"""Compiled templates: kept between runs, never missed when changed, never in the way."""

from __future__ import annotations

from pathlib import Path

import jinja2
import pytest

from symnav.emit.caching import CompiledTemplates


def rendered(folder: Path) -> str:
    """One template, by an environment of its own as every run has."""
    loader = jinja2.FileSystemLoader(folder)
    environment = jinja2.Environment(loader=loader, bytecode_cache=CompiledTemplates())
    return environment.get_template("page.j2").render(name="rover")


@pytest.fixture
def templates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a template, and a cache of its own beside it."""
    monkeypatch.setenv("SYMNAV_CACHE_DIR", str(tmp_path / "cache"))
    folder = tmp_path / "templates"
    folder.mkdir()
    (folder / "page.j2").write_text("the {{ name }}")
    return folder


def test_compiled_once(templates: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A second run compiles nothing."""
    assert rendered(templates) == "the rover"
    monkeypatch.delattr(jinja2.Environment, "_generate")
    assert rendered(templates) == "the rover"


def test_changes_are_seen(templates: Path) -> None:
    """Whatever the file's time says."""
    rendered(templates)
    (templates / "page.j2").write_text("our {{ name }}")
    assert rendered(templates) == "our rover"


@pytest.mark.parametrize("spoiled", [b"", b"nonsense", b"j2"])
def test_broken_files_are_written_again(templates: Path, spoiled: bytes) -> None:
    """Half a file, or something else."""
    rendered(templates)
    (kept,) = (templates.parent / "cache" / "templates").iterdir()
    whole = kept.read_bytes()
    for content in (spoiled, whole[:-20]):
        kept.write_bytes(content)
        assert rendered(templates) == "the rover"
        assert kept.read_bytes() == whole


def test_no_folder_is_no_reason_to_fail(templates: Path) -> None:
    """A file where the folder should be."""
    (templates.parent / "cache").write_text("in the way")
    assert rendered(templates) == "the rover"
