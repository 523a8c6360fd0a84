"""Continuous integration notices tests that are skipped, and says what for."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType

import pytest

SCRIPT = Path(__file__).parents[1] / ".ci" / "skips.py"
pytestmark = pytest.mark.skipif(not SCRIPT.is_file(), reason="is about the checkout")
RAN, SKIPPED, EXPECTED = "", "<skipped/>", '<skipped type="pytest.xfail"/>'


@pytest.fixture
def skips(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The script that reads the reports."""
    spec = importlib.util.spec_from_file_location("skips", SCRIPT)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, "skips", module)
    spec.loader.exec_module(module)
    return module


def report(path: Path, outcomes: Mapping[tuple[str, str], str]) -> str:
    """A report of tests by class and name."""
    cases = "".join(
        f'<testcase classname="{where}" name="{name}">{outcome}</testcase>'
        for (where, name), outcome in outcomes.items()
    )
    path.write_text(f"<testsuites><testsuite>{cases}</testsuite></testsuites>")
    return str(path)


def test_skipped_tests_are_made_up_for(
    skips: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By test where one is named, by file where the whole of it was left out."""
    first = report(
        tmp_path / "first.xml",
        {
            ("", "tests.oracles.test_gtsam"): SKIPPED,
            ("tests.emit.test_jax.TestJit", "test_a"): SKIPPED,
            ("tests.test_cli", "test_b"): RAN,
            ("tests.test_cli", "test_c"): EXPECTED,
        },
    )
    assert skips.main("files", first) == 0
    assert capsys.readouterr().out.split() == [
        "tests/emit/test_jax.py",
        "tests/oracles/test_gtsam.py",
    ]
    second = {
        ("tests.oracles.test_gtsam", "test_d"): RAN,
        ("tests.emit.test_jax.TestJit", "test_a"): RAN,
    }
    assert skips.main("none", report(tmp_path / "all.xml", second), first) == 0
    for name in second:
        left = {other: RAN for other in second if other != name}
        assert skips.main("none", report(tmp_path / "left.xml", left), first) == 1
        again = {**second, name: SKIPPED}
        assert skips.main("none", report(tmp_path / "again.xml", again), first) == 1


def test_a_tool_that_cannot_be_had_excuses_what_needs_it(
    skips: ModuleType,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What names it in its reason is listed; anything else fails; the summary says why."""
    proof = '<skipped message="frama-c is not installed (apt: frama-c-base)"/>'
    outcomes = {("tests.export.test_eva", "test_a"): proof, ("tests.test_cli", "test_b"): RAN}
    path = report(tmp_path / "slow.xml", outcomes)
    assert skips.main("none", path) == 1
    monkeypatch.setenv("CI_ABSENT", "clang frama-c ")
    assert skips.main("none", path) == 0
    capsys.readouterr()
    assert skips.main("summary", path) == 0
    told = capsys.readouterr().out
    assert "slow: 1 tests ran" in told and "could not be installed: clang, frama-c" in told
    assert "frama-c is not installed" in told and "tests.export.test_eva::test_a" in told
    other = {**outcomes, ("tests.test_cli", "test_c"): '<skipped message="needs clang-19"/>'}
    assert skips.main("none", report(tmp_path / "other.xml", other)) == 1


def test_no_test_at_all(skips: ModuleType, tmp_path: Path) -> None:
    """A run that found nothing is no run."""
    assert skips.main("none", report(tmp_path / "empty.xml", {})) == 1


def test_every_extra_is_installed() -> None:
    """The second run has whatever any test may ask for."""
    text = (SCRIPT.parent / "run").read_text(encoding="utf-8")
    assert 'optional-dependencies"]' in text and 'pip install -q -e ".[$extras]"' in text
    assert text.index('step "every extra"') < text.index("$reports/second.xml")
