"""Runners that build the test program and run it: they pass, and say so when it does not."""

from __future__ import annotations

from pathlib import Path

import pytest

from symnav.export.runners import Runner, Verdict
from symnav.export.runners.programs import CortexM, HostTests, Reach
from tests.export.bundles import copy_of, replace_in

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
