"""Single precision on a Cortex-M4F: instructions and flash beside CasADi's and hand-written C."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from benchmarks import embedded
from benchmarks.contestants import casadi_code, hand_code
from benchmarks.contestants.single import mended, mended_text
from benchmarks.embedded import MODELS, Figures
from benchmarks.measuring import expected, records
from benchmarks.page import RESULTS
from benchmarks.problems import PROBLEMS
from symnav.export.runners.emulation import TARGETS, missing

SLACK = 1.01
MENDED = ("casadi_mended", "casadi_sym_mended")
AS_IT_COMES = ("casadi", "casadi_sym")
OF_DOUBLES = {"ekfcal", "pr8", "pr32"}
"""Models with sines or square roots, which CasADi's floats compute as doubles."""


def committed(cpu: str) -> dict[str, dict[str, Figures]]:
    """The figures the documentation shows."""
    read = json.loads((RESULTS / f"{cpu}.json").read_text(encoding="utf-8"))
    return {
        model: {name: Figures(**one) for name, one in found.items()}
        for model, found in read.items()
    }


def judge(model: str, found: dict[str, Figures]) -> None:
    """What the kernels may cost beside others."""
    own = found["symnav_nz"]
    assert not any(name.startswith("__aeabi_") for name in own.undefined)
    assert own.instructions <= 1.05 * found["hand"].instructions
    for rival in MENDED:
        assert own.instructions <= 0.95 * found[rival].instructions, rival
    # Flash, with what is linked: a sine of the library is code as well.
    for rival in (*MENDED, *AS_IT_COMES):
        assert own.flash <= 0.65 * found[rival].flash, rival
    if model in OF_DOUBLES:
        for rival in AS_IT_COMES:
            assert own.instructions <= 0.12 * found[rival].instructions, rival
    if model == "pr32":
        assert own.code <= 2500


@pytest.mark.parametrize("cpu", TARGETS)
@pytest.mark.parametrize("model", MODELS)
def test_what_the_documentation_shows(model: str, cpu: str) -> None:
    judge(model, committed(cpu)[model])


@pytest.mark.slow
@pytest.mark.skipif(bool(missing()), reason=f"needs {', '.join(missing())}")
@pytest.mark.parametrize("model", MODELS)
def test_what_is_measured(model: str, tmp_path: Path) -> None:
    """As good as what was shown, and every contestant right."""
    (problem,) = (p for p in PROBLEMS if p.name == model)
    found = embedded.measure(problem, TARGETS["cortex-m4"], tmp_path)
    judge(model, found)
    shown = committed("cortex-m4")[model]
    assert found.keys() == shown.keys()
    for name in ("symnav_nz", "symnav_dense", "symnav_nz_guarded", "symnav_dense_guarded"):
        assert found[name].instructions <= SLACK * shown[name].instructions, name
        assert found[name].code <= SLACK * shown[name].code, name


def test_mending() -> None:
    """Type, literals and calls; integers, names and whole words stay."""
    given = "double a1 = 2.*sqrt(.5) - 1e-3 + x[10] + sq(1) / my_sin(12.25e+1) + v1.x;"
    expected = "float a1 = 2.F*sqrtf(.5F) - 1e-3F + x[10] + sq(1) / my_sin(12.25e+1F) + v1.x;"
    assert mended_text(given) == expected


def test_mended_rivals_have_no_double_left() -> None:
    problem = PROBLEMS[1]
    (hand,) = map(mended, hand_code.contestants(problem, Path()))
    names = {c.name: c.candidate.source for c in casadi_code.in_single(problem)}
    assert "sinf(" in hand.candidate.source and "double" not in hand.candidate.source
    assert "HAND_ROTATION" in hand.candidate.source
    assert "sin(" in names["casadi"] and "sinf(" not in names["casadi"]
    assert "sinf(" in names["casadi_mended"] and " sin(" not in names["casadi_mended"]
    assert "double" not in names["casadi"] + names["casadi_mended"]


def test_wrong_results_are_refused() -> None:
    problem = PROBLEMS[0]
    given = records(problem)[:1].astype(np.float32)
    (contestant,) = hand_code.contestants(problem, Path())
    truth, scale = expected(problem, given[0].tolist())
    words = np.array(truth, np.float32).view(np.uint32)
    embedded.compare(contestant, [(truth, scale)], [" ".join(["out", *(f"{w:x}" for w in words)])])
    words[4] ^= 64
    wrong = " ".join(["out", *(f"{w:x}" for w in words)])
    with pytest.raises(SystemExit, match="gps hand: differs by"):
        embedded.compare(contestant, [(truth, scale)], [wrong])
    with pytest.raises(ValueError):
        embedded.compare(contestant, [(truth, scale)], [])
