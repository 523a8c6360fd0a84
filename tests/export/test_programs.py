"""Runners that build the test program and run it: they pass, and say so when it does not."""

from __future__ import annotations

from pathlib import Path

import pytest

from symnav.export.runners import Runner, Verdict, coverage
from symnav.export.runners.programs import WAYS, CortexM, HostTests, Reach
from tests.export.bundles import copy_of, replace_in
from tests.export.bundles import run as shell

RUNNERS = [
    pytest.param(HostTests(), id="tests"),
    pytest.param(Reach(), id="mcdc"),
    pytest.param(CortexM("cortex-m4"), id="cortex-m4", marks=pytest.mark.slow),
    pytest.param(CortexM("cortex-m7"), id="cortex-m7", marks=pytest.mark.slow),
]


def run(runner: Runner, folder: Path) -> tuple[Verdict, str]:
    if reason := runner.missing():
        pytest.skip(reason)
    record = runner.run(folder)
    assert record.tool == runner.name
    assert record.version or record.verdict is Verdict.FAILED
    return record.verdict, record.shown + " ".join(record.findings)


@pytest.mark.parametrize("runner", RUNNERS)
def test_passes(runner: Runner, tmp_path: Path) -> None:
    folder = copy_of("reference_relative", "float", tmp_path)
    before = sorted(path.name for path in folder.rglob("*"))
    verdict, said = run(runner, folder)
    assert verdict is Verdict.PASSED, said
    assert sorted(path.name for path in folder.rglob("*")) == before


def test_every_way_is_recorded_with_its_version_and_command(tmp_path: Path) -> None:
    """The command of the record is all of them, and repeats what was run."""
    runner = HostTests()
    if reason := runner.missing():
        pytest.skip(reason)
    folder = copy_of("reference_relative", "float", tmp_path)
    record = runner.run(folder)
    ways = record.details["ways"]
    assert isinstance(ways, list) and len(ways) == sum(not way.missing() for way in WAYS)
    for way, known in zip(ways, (way for way in WAYS if not way.missing()), strict=True):
        assert way["version"] and set(way["version"].split("; ")) <= set(record.version.split("; "))
        assert way["command"] in record.command
        assert any(way["command"].startswith(f"{name} ") for name in known.compilers)
        assert all(word in way["command"] for word in (*known.flags, *known.under))
    said = shell(["sh", "-c", record.command], folder)
    assert said.count(" 0 failures") == len(ways)


def test_the_command_of_the_coverage_gives_its_counts(tmp_path: Path) -> None:
    """By the rule that the record states: in any of the places that include it."""
    runner = Reach()
    if reason := runner.missing():
        pytest.skip(reason)
    folder = copy_of("reference_relative", "float", tmp_path).resolve()
    record = runner.run(folder)
    (rule,) = record.assumptions
    assert "in any of the places that include or inline it" in rule
    shell(["sh", "-c", record.command], folder)
    made = [(folder / f"build/coverage.{kind}").read_text() for kind in ("json", "info")]
    files = coverage._files(made[0], coverage._lines(made[1]), folder)
    total = coverage.Coverage(files, "").total
    kinds = {"lines": total.lines, "branches": total.branches, "conditions": total.conditions}
    assert record.details == {kind: [c.reached, c.total] for kind, c in kinds.items()}


@pytest.mark.parametrize("runner", [p for p in RUNNERS if p.id != "mcdc"])
def test_a_wrong_sign_is_told(runner: Runner, tmp_path: Path) -> None:
    folder = copy_of("reference_relative", "float", tmp_path)
    kernel = folder / "src/reference_relative_f32_retract_kernel.h"
    replace_in(kernel, "in->clock_bias + in->d_clock_bias", "in->clock_bias - in->d_clock_bias")
    verdict, said = run(runner, folder)
    assert verdict is Verdict.FAILED and "fail" in said


def test_lines_that_are_not_reached_are_told(tmp_path: Path) -> None:
    folder = copy_of("reference_relative", "float", tmp_path)
    helper = folder / "src/reference_relative_f32_check.h"
    replace_in(
        helper,
        "#endif /* REFERENCE_RELATIVE_F32_CHECK_H */",
        "static inline int idle(int n)\n{\n    return n;\n}\n\n"
        "#endif /* REFERENCE_RELATIVE_F32_CHECK_H */",
    )
    verdict, said = run(Reach(), folder)
    assert verdict is Verdict.FAILED and "reference_relative_f32_check.h: lines" in said
