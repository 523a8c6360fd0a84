"""Tools that say nothing because they are broken: their silence must not count."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from symnav.export.runners import Runner, Verdict, tools
from symnav.export.runners.compilers import ANALYSES, WARNS, Analyser, Warnings
from symnav.export.runners.controls import Control
from symnav.export.runners.linters import CHECKS, TIDIES, ClangTidy, Cppcheck
from tests.export.bundles import copy_of

Fake = Callable[[str], None]
SILENT: tuple[tuple[Runner, str], ...] = (
    (Warnings(), "gcc (GCC) 12.2.0"),
    (Analyser(), "gcc (GCC) 12.2.0"),
    (Cppcheck(), "Cppcheck 2.22.0"),
    (ClangTidy(), "LLVM version 19.1.0"),
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The bundle of a small model."""
    return copy_of("reference_relative", "float", tmp_path)


@pytest.fixture
def fake(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Fake:
    """Puts a script in the place of every tool."""
    path = tmp_path / "fake"

    def write(script: str) -> None:
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)
        monkeypatch.setattr(tools, "find", lambda *names: str(path))

    return write


@pytest.mark.parametrize("runner", [runner for runner, _ in SILENT], ids=lambda r: str(r.name))
@pytest.mark.parametrize("script", ["exit 0", "echo nonsense 1.0", 'echo "$0 $@"'])
def test_an_unknown_program_shows_nothing(
    runner: Runner, script: str, folder: Path, fake: Fake
) -> None:
    fake(script)
    record = runner.run(folder)
    assert record.verdict is Verdict.FAILED
    assert "is not recognised by its version" in record.shown
    assert record.findings and record.command


@pytest.mark.parametrize(("runner", "version"), SILENT, ids=lambda case: getattr(case, "name", ""))
@pytest.mark.parametrize(
    "otherwise", ["exit 0", "echo garbage", 'echo "$@"', "echo broken >&2; exit 1"]
)
def test_a_tool_that_misses_what_was_planted_shows_nothing(
    runner: Runner, version: str, otherwise: str, folder: Path, fake: Fake
) -> None:
    fake(f'[ "$1" = --version ] && {{ echo "{version}"; exit 0; }}\n{otherwise}')
    record = runner.run(folder)
    assert record.verdict is Verdict.FAILED and record.version == version
    assert "does not report a planted defect" in record.shown
    if "broken" in otherwise:
        assert all("exit status 1, it said 'broken'" in text for text in record.findings)


@pytest.mark.parametrize("runner", [Warnings(), Analyser()], ids=lambda r: str(r.name))
def test_a_compiler_that_writes_no_object_has_failed(
    runner: Runner, folder: Path, fake: Fake
) -> None:
    real = shutil.which("gcc")
    if real is None:
        pytest.skip("needs gcc")
    fake(f'case "$*" in *--version*|*control.c*) exec {real} "$@";; esac; exit 0')
    record = runner.run(folder)
    assert record.verdict is Verdict.FAILED
    assert len(record.findings) == len(tools.sources(folder))
    assert all("no object file was written" in text for text in record.findings)


@pytest.mark.parametrize(
    ("control", "version"),
    list(zip((WARNS, ANALYSES, CHECKS, TIDIES), (words for _, words in SILENT), strict=True)),
    ids=lambda case: getattr(case, "tool", ""),
)
def test_words_of_a_defect_elsewhere_do_not_count(
    control: Control, version: str, fake: Fake
) -> None:
    fake("\n".join(f"echo 'control.c:1: {words}'" for words in control.planted))
    assert len(control.doubts(version, [tools.find()])) == len(control.planted) > 0


def test_a_configuration_that_asks_for_nothing_is_noticed(folder: Path) -> None:
    if reason := ClangTidy().missing():
        pytest.skip(reason)
    (folder / ".clang-tidy").write_text("Checks: '-*,bugprone-macro-parentheses'\n")
    record = ClangTidy().run(folder)
    assert record.verdict is Verdict.FAILED and "planted defect" in record.shown
