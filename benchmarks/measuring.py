"""Compiles the contestants of a problem into one program, checks their results, and times them."""

from __future__ import annotations

import re
import shutil
import statistics
import subprocess
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import mpmath
import numpy as np
import numpy.typing as npt

from benchmarks.contestants.contestant import Contestant
from benchmarks.problems import Functions, Problem

HERE = Path(__file__).parent
RECORDS = 64
TOLERANCE = 1e-12

FLAG_SETS: Mapping[str, tuple[str, ...]] = {
    "o2": ("-O2",),
    "v3": ("-O3", "-march=x86-64-v3", "-fno-math-errno", "-fno-trapping-math"),
    "native": ("-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math"),
}
"""The same for every contestant."""

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Figures:
    """What was measured of one contestant.

    Attributes:
        ns: median time of one evaluation.
        ops: floating-point operations of one evaluation, as they are executed.
        bytes: machine code, what it calls in its own file included.
        stack: bytes of stack of its deepest chain of calls, by the compiler's account.
    """

    ns: float
    ops: int | None = None
    bytes: int | None = None
    stack: int | None = None


def measure(
    problem: Problem,
    contestants: Sequence[Contestant],
    flags: str,
    folder: Path,
    repetitions: int,
) -> dict[str, Figures]:
    """Build, compare and time the contestants of one problem.

    Raises:
        SystemExit: when a contestant does not compile or computes something else.
    """
    folder.mkdir(parents=True, exist_ok=True)
    objects = [compiled(contestant, FLAG_SETS[flags], folder) for contestant in contestants]
    program = linked(contestants, objects, folder)
    inputs = records(problem)
    given, taken = folder / "inputs.bin", folder / "outputs.bin"
    np.concatenate([np.array(inputs.shape, float), inputs.ravel()]).tofile(given)
    printed = subprocess.run(
        [str(program), str(repetitions), str(given), str(taken)],
        check=True, capture_output=True, text=True,
    ).stdout  # fmt: skip
    compare(problem, contestants, inputs, np.fromfile(taken))
    times: dict[str, list[float]] = defaultdict(list)
    for line in printed.splitlines():
        name, _, nanoseconds = line.partition(" ")
        times[name].append(float(nanoseconds))
    return {
        c.name: Figures(
            round(statistics.median(times[c.name]), 3),
            operations(c, folder),
            code_bytes(c, item),
            stack_bytes(c, item),
        )
        for c, item in zip(contestants, objects, strict=True)
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
    problem: Problem, contestants: Sequence[Contestant], inputs: Array, outputs: Array
) -> None:
    """Every contestant's first results against 50 digits."""
    at = 0
    truths = [expected(problem, inputs[k]) for k in range(4)]
    for contestant in contestants:
        runs = len(inputs) // contestant.epochs
        block = outputs[at : at + runs * contestant.size].reshape(runs, contestant.size)
        at += block.size
        found = block[:, list(contestant.order)].reshape(len(inputs), -1)
        for (truth, scale), row in zip(truths, found, strict=False):
            worst = np.max(np.abs(row - truth) / scale)
            if not worst < TOLERANCE:
                raise SystemExit(f"{contestant.symbol}: differs by {worst:.1e}")


def compiled(contestant: Contestant, flags: Sequence[str], folder: Path) -> Path:
    """The object file of a contestant; every function in a section of its own."""
    source = folder / f"{contestant.symbol}{contestant.suffix}"
    source.write_text(contestant.source, encoding="utf-8")
    target = source.with_suffix(".o")
    compiler = ["gcc", "-std=gnu99"] if contestant.language == "c" else ["g++", "-std=c++17"]
    command = [
        *compiler, *flags, "-ffunction-sections", "-fstack-usage",
        *(f"-I{place}" for place in contestant.include), "-c", str(source), "-o", str(target),
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{contestant.symbol} does not compile:\n{done.stderr[:2000]}")
    return target


def linked(contestants: Sequence[Contestant], objects: Sequence[Path], folder: Path) -> Path:
    """The program that times them."""
    table = folder / "table.c"
    lines = ["struct contestant { const char *name; void (*call)(const double *, double *);"]
    lines += ["    long size; int epochs; };"]
    lines += [f"void {c.symbol}(const double *, double *);" for c in contestants]
    lines += [f"const int contestant_count = {len(contestants)};"]
    lines += ["const struct contestant contestants[] = {"]
    lines += [f'    {{"{c.name}", {c.symbol}, {c.size}, {c.epochs}}},' for c in contestants]
    lines += ["};", ""]
    table.write_text("\n".join(lines), encoding="utf-8")
    program = folder / "program"
    alone = [_alone(c, item) for c, item in zip(contestants, objects, strict=True)]
    command = ["gcc", "-O2", "-std=gnu11", str(HERE / "harness.c"), str(table)]
    command += [*map(str, alone), "-lm", "-lstdc++", "-o", str(program)]
    subprocess.run(command, check=True, capture_output=True, text=True)
    return program


def _alone(contestant: Contestant, item: Path) -> Path:
    """The object file with nothing to be seen but the adapter: two of one package never clash."""
    target = item.with_suffix(".alone.o")
    keep = f"--keep-global-symbol={contestant.symbol}"
    subprocess.run(["objcopy", keep, str(item), str(target)], check=True, capture_output=True)
    return target


def code_bytes(contestant: Contestant, item: Path) -> int:
    """Machine code that stays when only the measured function is kept."""
    root = contestant.root or contestant.symbol
    kept = item.with_suffix(".kept.o")
    subprocess.run(
        ["ld", "-r", "--gc-sections", "-u", root, "-e", root, str(item), "-o", str(kept)],
        check=True, capture_output=True,
    )  # fmt: skip
    printed = subprocess.run(["size", "-A", str(kept)], check=True, capture_output=True, text=True)
    sections = re.findall(r"^(\.text\S*)\s+(\d+)", printed.stdout, flags=re.MULTILINE)
    return sum(int(size) for _, size in sections)


def stack_bytes(contestant: Contestant, item: Path) -> int:
    """Sum over the functions that stay; what is inlined counts where it ended up."""
    root = contestant.root or contestant.symbol
    kept = item.with_suffix(".kept.o")
    symbols = subprocess.run(["nm", str(kept)], check=True, capture_output=True, text=True).stdout
    names = {line.split()[-1] for line in symbols.splitlines() if " t " in line.lower()} | {root}
    total = 0
    for line in item.with_suffix(".su").read_text(encoding="utf-8").splitlines():
        place, size, _ = line.split("\t")
        function = place.rpartition(":")[2]
        if any(function == name or f"{name}(" in function for name in names):
            total += int(size)
    return total


def operations(contestant: Contestant, folder: Path) -> int | None:
    """Floating-point operations of one call, counted by running it with a counting number."""
    if contestant.epochs > 1 or not shutil.which("g++"):
        return None
    source = folder / f"{contestant.symbol}_counted.cpp"
    original = folder / f"{contestant.symbol}{contestant.suffix}"
    source.write_text(
        f'#include "counted.hpp"\n#include "{original.name}"\n\n'
        + _COUNTING.format(symbol=contestant.symbol, size=contestant.size),
        encoding="utf-8",
    )
    program = source.with_suffix("")
    command = [
        "g++", "-std=c++17", "-O0", "-w", "-fpermissive", "-Drestrict=", f"-I{HERE}", f"-I{folder}",
        *(f"-I{place}" for place in contestant.include), str(source), "-o", str(program),
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{contestant.symbol} cannot be counted:\n{done.stderr[:2000]}")
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
