"""Candidates compiled into one program, timed in turn, and the size of their code.

Times of one program compare: every candidate is called through a pointer the compiler cannot see
through, over the same records, in bursts that follow each other round and round, so that whatever
else the machine does meets all of them. Times of two programs do not.
"""

from __future__ import annotations

import re
import shutil
import statistics
import subprocess
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from symnav.bench.candidate import Candidate
from symnav.emit.templates import directory
from symnav.errors import BuildError

Array = npt.NDArray[np.float64]

FLAG_SETS: Mapping[str, tuple[str, ...]] = {
    "o2": ("-O2",),
    "v3": ("-O3", "-march=x86-64-v3", "-fno-math-errno", "-fno-trapping-math"),
    "native": ("-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math"),
}
"""The same for every candidate; ``v3`` is what AVX2 machines of the last ten years have."""

COMPILERS = {"c": ("gcc", "-std=gnu99"), "c++": ("g++", "-std=c++17")}


@dataclass(frozen=True)
class Program:
    """Compiled candidates.

    Attributes:
        candidates: in order.
        objects: their object files.
        executable: times them.
    """

    candidates: tuple[Candidate, ...]
    objects: tuple[Path, ...]
    executable: Path


@dataclass(frozen=True)
class Run:
    """What one run of a program gave.

    Attributes:
        ns: median time of one evaluation, by candidate.
        outputs: what every candidate wrote, one row a call.
    """

    ns: Mapping[str, float]
    outputs: Mapping[str, Array]


def built(candidates: Sequence[Candidate], flags: str, folder: Path) -> Program:
    """Compile candidates into one program.

    Args:
        candidates: of one kind of record.
        flags: name of a flag set.
        folder: for sources and objects.

    Raises:
        BuildError: when there is no compiler, or it refuses a candidate.
    """
    folder.mkdir(parents=True, exist_ok=True)
    objects = [_compiled(candidate, FLAG_SETS[flags], folder) for candidate in candidates]
    table = folder / "table.c"
    table.write_text(_table(candidates), encoding="utf-8")
    alone = [_alone(c, item) for c, item in zip(candidates, objects, strict=True)]
    executable = folder / "program"
    harness = str(directory() / "bench" / "harness.c")
    libraries = ["-lm", *(["-lstdc++"] if any(c.language != "c" for c in candidates) else [])]
    files = [harness, str(table), *map(str, alone)]
    _run(["gcc", "-O2", "-std=gnu11", *files, *libraries, "-o", str(executable)])
    return Program(tuple(candidates), tuple(objects), executable)


def run(program: Program, records: Array, repetitions: int) -> Run:
    """Time every candidate of a program over the same records.

    Args:
        program: compiled candidates.
        records: one flat record of inputs a row.
        repetitions: bursts of each candidate; the median is reported.
    """
    folder = program.executable.parent
    given, taken = folder / "inputs.bin", folder / "outputs.bin"
    np.concatenate([np.array(records.shape, float), records.ravel()]).tofile(given)
    printed = _run([str(program.executable), str(repetitions), str(given), str(taken)])
    times: dict[str, list[float]] = defaultdict(list)
    for line in printed.splitlines():
        name, _, nanoseconds = line.partition(" ")
        times[name].append(float(nanoseconds))
    ns = {c.name: round(statistics.median(times[c.name]), 3) for c in program.candidates}
    return Run(ns, _outputs(program, len(records), np.fromfile(taken)))


def code_bytes(candidate: Candidate, item: Path) -> int:
    """Machine code that stays when nothing but the measured function is asked for."""
    kept = _kept(candidate, item)
    sections = re.findall(r"^(\.text\S*)\s+(\d+)", _run(["size", "-A", str(kept)]), re.MULTILINE)
    return sum(int(size) for _, size in sections)


def stack_bytes(candidate: Candidate, item: Path) -> int:
    """Stack of the measured function and of all it calls in its file, by the compiler's account."""
    symbols = _run(["nm", str(_kept(candidate, item))])
    names = {line.split()[-1] for line in symbols.splitlines() if " t " in line.lower()}
    total = 0
    for line in item.with_suffix(".su").read_text(encoding="utf-8").splitlines():
        place, size, _ = line.split("\t")
        function = place.rpartition(":")[2]
        if any(function == name or f"{name}(" in function for name in {*names, candidate.measured}):
            total += int(size)
    return total


def _compiled(candidate: Candidate, flags: Sequence[str], folder: Path) -> Path:
    """The object file of a candidate; every function in a section of its own."""
    source = folder / candidate.file
    source.write_text(candidate.source, encoding="utf-8")
    target = source.with_suffix(".o")
    include = [f"-I{place}" for place in candidate.include]
    command = [*COMPILERS[candidate.language], *flags, "-ffunction-sections", "-fstack-usage"]
    _run([*command, *include, "-c", str(source), "-o", str(target)])
    return target


def _table(candidates: Sequence[Candidate]) -> str:
    """The list of candidates the harness walks through."""
    rows = [f'    {{"{c.name}", {c.symbol}, {c.size}, {c.epochs}}},' for c in candidates]
    return "\n".join(
        [
            "struct candidate { const char *name; void (*call)(const double *, double *);",
            "    long size; int epochs; };",
            *(f"void {c.symbol}(const double *, double *);" for c in candidates),
            f"const int candidate_count = {len(candidates)};",
            "const struct candidate candidates[] = {",
            *rows,
            "};",
            "",
        ]
    )


def _alone(candidate: Candidate, item: Path) -> Path:
    """The object file with nothing to be seen but the adapter: two of one package never clash."""
    target = item.with_suffix(".alone.o")
    _run(["objcopy", f"--keep-global-symbol={candidate.symbol}", str(item), str(target)])
    return target


def _kept(candidate: Candidate, item: Path) -> Path:
    kept, root = item.with_suffix(".kept.o"), candidate.measured
    _run(["ld", "-r", "--gc-sections", "-u", root, "-e", root, str(item), "-o", str(kept)])
    return kept


def _outputs(program: Program, records: int, written: Array) -> dict[str, Array]:
    found, at = {}, 0
    for candidate in program.candidates:
        calls = records // candidate.epochs
        found[candidate.name] = written[at : at + calls * candidate.size].reshape(calls, -1)
        at += calls * candidate.size
    return found


def _run(command: Sequence[str]) -> str:
    """Standard output of a command that must succeed."""
    if "/" not in command[0] and shutil.which(command[0]) is None:
        raise BuildError(f"{command[0]} is needed to measure and is not installed")
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise BuildError(f"{' '.join(command[:2])} ...: {done.stderr.strip()[:2000]}")
    return done.stdout
