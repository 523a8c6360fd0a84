"""No model may cost more than it did: operations always, instructions where they can be counted.

``budgets.toml`` holds what was reached. A change that lowers a count lowers the budget with it.
"""

from __future__ import annotations

import shutil
import tomllib
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import pytest

from benchmarks.contestants import symnav_code
from benchmarks.measuring import operations, records
from benchmarks.problems import PROBLEMS, Problem
from symnav.bench.adapters import Entries
from symnav.bench.program import built, run
from symnav.lower.passes.counts import count_operations
from tests.performance.callgrind import compiler, instructions

FILE = Path(__file__).parent / "budgets.toml"
COMPARED = {problem.name: problem for problem in PROBLEMS if problem.name != "filter"}
SLACK = 1.01
MOST_OPERATIONS = {
    "gps": 70, "ekfcal": 101, "pr8": 362, "pr32": 1058, "imu1": 176, "imu4": 301,
}  # fmt: skip
"""What the prototypes needed, straight-line and structured."""


@cache
def entries(name: str, guarded: bool) -> Entries:
    """Generated code of one model."""
    folder = Path(mkdtemp(prefix="symnav-budgets-"))
    return symnav_code.generated(COMPARED[name], folder, guarded=guarded)


def budget(name: str) -> dict[str, float]:
    """What a model may cost."""
    found: dict[str, float] = tomllib.loads(FILE.read_text(encoding="utf-8"))[name]
    return found


@pytest.mark.parametrize("name", COMPARED)
def test_operations(name: str) -> None:
    """Not one more than was reached, and never more than the prototypes."""
    problem = COMPARED[name]
    found = count_operations(entries(name, True).function).total(problem.items or 1)
    assert found <= budget(name)["operations"]
    assert budget(name)["operations"] <= MOST_OPERATIONS[name]


@pytest.mark.skipif(shutil.which("g++") is None, reason="needs g++")
@pytest.mark.parametrize("name", ["gps", "pr8", "imu4"])
def test_executed_operations(name: str, tmp_path: Path) -> None:
    """What benchmarks count while the C runs is what the graph says; guards only add to it."""
    problem = COMPARED[name]
    wanted = ("symnav_nz", "symnav_nz_guarded")
    made = {c.candidate.name: c for c in symnav_code.contestants(problem, tmp_path)}
    program = built([made[name].candidate for name in wanted], "o2", tmp_path)
    run(program, records(problem), 1)
    said = count_operations(entries(name, False).function).total(problem.items or 1)
    assert operations(made["symnav_nz"], tmp_path) == said
    assert (operations(made["symnav_nz_guarded"], tmp_path) or 0) > said


@pytest.mark.skipif(shutil.which("valgrind") is None, reason="needs valgrind")
@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
@pytest.mark.parametrize("guarded", [False, True], ids=["unguarded", "guarded"])
@pytest.mark.parametrize("name", COMPARED)
def test_instructions(name: str, guarded: bool, tmp_path: Path) -> None:
    """One call of the non-zeros form, for the compiler the budgets were made with."""
    held = tomllib.loads(FILE.read_text(encoding="utf-8"))["compiler"]
    if compiler() != held:
        pytest.skip(f"the budgets hold for {held}")
    found = counted(COMPARED[name], guarded, tmp_path)
    assert found <= SLACK * budget(name)["guarded" if guarded else "unguarded"]


def counted(problem: Problem, guarded: bool, folder: Path) -> float:
    """Instructions of one call."""
    candidate = entries(problem.name, guarded).nonzeros("nonzeros")
    return instructions(candidate, records(problem)[0].tolist(), folder)
