"""Measures the contestants of a problem: builds them, checks their results, times and counts."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import mpmath
import numpy as np

from benchmarks.contestants.contestant import Contestant
from benchmarks.lines import lines_of_code
from benchmarks.problems import Functions, Problem
from symnav.bench.program import Array, built, code_bytes, run, stack_bytes
from symnav.bench.quiet import Quiet

HERE = Path(__file__).parent
RECORDS = 64
TOLERANCE = 1e-12


@dataclass(frozen=True)
class Figures:
    """What was measured of one contestant.

    Attributes:
        ns: median time of one evaluation.
        ops: floating-point operations of one evaluation, as they are executed.
        bytes: machine code, what it calls in its own file included.
        stack: bytes of stack of its deepest chain of calls, by the compiler's account.
        lines: lines of code of the functions that compute, blank ones and comments left out.
        alone: True when the core did nothing else meanwhile, as far as that can be told.
    """

    ns: float
    ops: int | None = None
    bytes: int | None = None
    stack: int | None = None
    lines: int | None = None
    alone: bool | None = None


def measure(
    problem: Problem,
    contestants: Sequence[Contestant],
    flags: str,
    folder: Path,
    repetitions: int,
    quiet: Quiet,
) -> dict[str, Figures]:
    """Build, compare and time the contestants of one problem.

    Raises:
        SystemExit: when a contestant does not compile or computes something else.
    """
    candidates = [contestant.candidate for contestant in contestants]
    program = built(candidates, flags, folder)
    inputs = records(problem)
    taken = run(program, inputs, repetitions, quiet)
    if not taken.alone:
        print(f"{problem.name}: the core was shared", file=sys.stderr)
    compare(problem, contestants, inputs, taken.outputs)
    return {
        candidate.name: Figures(
            taken.ns[candidate.name],
            operations(contestant, folder),
            code_bytes(candidate, item),
            stack_bytes(candidate, item),
            lines_of_code(contestant.text, contestant.functions) or None,
            taken.alone,
        )
        for contestant, candidate, item in zip(
            contestants, candidates, program.objects, strict=True
        )
    }


def records(problem: Problem, seed: int = 1) -> Array:
    """Random inputs inside the ranges every model declares."""
    rng = np.random.default_rng(seed)
    scales = {
        "p": 1e3, "v": 10.0, "l": 2.0, "pL": 100.0, "psi": 3.0, "b": 1e3, "drift": 10.0,
        "bg": 0.01, "ba": 0.1, "delta_theta": 0.02, "delta_velocity": 0.2, "rest": 1.0,
    }  # fmt: skip
    columns = []
    for name, size in problem.sizes.items():
        if name == "q":
            part = rng.normal(size=(RECORDS, 4))
            part /= np.linalg.norm(part, axis=1, keepdims=True)
        elif name == "C":
            part = np.linalg.qr(rng.normal(size=(RECORDS, 3, 3)))[0].reshape(RECORDS, 9)
        elif name == "s":
            part = rng.normal(size=(RECORDS, size // 3, 3))
            part = (2.6e7 * part / np.linalg.norm(part, axis=2, keepdims=True)).reshape(RECORDS, -1)
        elif name == "dt":
            part = rng.uniform(0.005, 0.02, size=(RECORDS, 1))
        else:
            part = scales[name] * rng.uniform(-1.0, 1.0, size=(RECORDS, size))
        columns.append(part)
    return np.hstack(columns)


def expected(problem: Problem, record: Sequence[float]) -> tuple[list[float], list[float]]:
    """Values and non-zeros with 50 digits, the Jacobian by central differences; and scales."""
    functions = Functions(mpmath.sqrt, mpmath.sin, mpmath.cos)
    with mpmath.workdps(50):
        given = problem.split([mpmath.mpf(float(element)) for element in record])
        value = problem.equation(given, functions)
        step = mpmath.mpf(10) ** -20
        slopes: dict[int, list[mpmath.mpf]] = {}
        for column in sorted({column for _, column in problem.pattern}):
            error = [step if k == column else mpmath.mpf(0) for k in range(problem.columns)]
            back = [-d for d in error]
            ahead = problem.equation(problem.moved(given, error), functions)
            behind = problem.equation(problem.moved(given, back), functions)
            slopes[column] = [(a - b) / (2 * step) for a, b in zip(ahead, behind, strict=True)]
        entries = [slopes[column][row] for row, column in problem.pattern]
        largest = max((abs(entry) for entry in entries), default=mpmath.mpf(1))
        length = max(abs(entry) for entry in value)
        scales = [length] * len(value) + [largest] * len(entries)
        return [float(v) for v in (*value, *entries)], [float(max(s, 1)) for s in scales]


def compare(
    problem: Problem, contestants: Sequence[Contestant], inputs: Array, outputs: Mapping[str, Array]
) -> None:
    """Every contestant's first results against 50 digits."""
    truths = [expected(problem, inputs[k]) for k in range(4)]
    for contestant in contestants:
        if not contestant.order:
            continue
        found = outputs[contestant.name][:, list(contestant.order)].reshape(len(inputs), -1)
        for (truth, scale), row in zip(truths, found, strict=False):
            worst = np.max(np.abs(row - truth) / scale)
            if not worst < TOLERANCE:
                raise SystemExit(f"{problem.name} {contestant.name}: differs by {worst:.1e}")


def operations(contestant: Contestant, folder: Path) -> int | None:
    """Floating-point operations of one call, counted by running it with a counting number."""
    candidate = contestant.candidate
    if candidate.epochs > 1 or not contestant.order or not shutil.which("g++"):
        return None
    source = folder / f"{candidate.symbol}_counted.cpp"
    source.write_text(
        f'#include "counted.hpp"\n#include "{candidate.file}"\n\n'
        + _COUNTING.format(symbol=candidate.symbol, size=candidate.size),
        encoding="utf-8",
    )
    program = source.with_suffix("")
    # ``counted.hpp`` has sine and cosine: the header of a tree that has its own is passed over.
    own = [f"-D{h.stem.upper()}_H" for p in candidate.include for h in p.glob("*_trigonometry.h")]
    command = [
        "g++", "-std=c++17", "-O0", "-w", "-fpermissive", "-Drestrict=", f"-I{HERE}", f"-I{folder}",
        *(f"-I{place}" for place in candidate.include), *own, str(source), "-o", str(program),
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{candidate.symbol} cannot be counted:\n{done.stderr[:2000]}")
    given = folder / "inputs.bin"
    counted = subprocess.run([str(program), str(given)], capture_output=True, text=True, check=True)
    return int(counted.stdout)


_COUNTING = """
#undef double
#include <cstdio>
#include <vector>

int main(int, char **argv)
{{
    std::FILE *file = std::fopen(argv[1], "rb");
    double shape[2];
    if (std::fread(shape, 8, 2, file) != 2) {{ return 3; }}
    std::vector<double> raw(static_cast<std::size_t>(shape[1]));
    if (std::fread(raw.data(), 8, raw.size(), file) != raw.size()) {{ return 3; }}
    std::vector<Counted> in(raw.begin(), raw.end());
    std::vector<Counted> out({size});
    Counted::operations = 0;
    {symbol}(in.data(), out.data());
    std::printf("%ld\\n", Counted::operations);
    return 0;
}}
"""
