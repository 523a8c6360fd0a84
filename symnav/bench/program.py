"""Candidates compiled into one program, timed in turn, and the size of their code.

Times of one program compare: every candidate is called through a pointer the compiler cannot see
through, over the same records, in bursts that follow each other round and round, so that whatever
else the machine does meets all of them. Times of two programs do not.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

import numpy as np
import numpy.typing as npt

from symnav.bench.candidate import Candidate
from symnav.bench.quiet import USUAL, Burst, Quiet, Round, medians, quietest
from symnav.build import objects
from symnav.build.objects import Binutils, said
from symnav.emit.templates import directory

Array = npt.NDArray[np.float64]

FLAG_SETS: Mapping[str, tuple[str, ...]] = {
    "o2": ("-O2",),
    "v3": ("-O3", "-march=x86-64-v3", "-fno-math-errno", "-fno-trapping-math"),
    "native": ("-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math"),
}
"""The same for every candidate; ``v3`` is what AVX2 machines of the last ten years have."""

HERE = Binutils()

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
        alone: True when the core did nothing else meanwhile, as far as that can be told.
    """

    ns: Mapping[str, float]
    outputs: Mapping[str, Array]
    alone: bool


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
    said("gcc", "-O2", "-std=gnu11", *files, *libraries, "-o", str(executable))
    return Program(tuple(candidates), tuple(objects), executable)


def run(program: Program, records: Array, repetitions: int, quiet: Quiet = USUAL) -> Run:
    """Time every candidate of a program over the same records.

    Args:
        program: compiled candidates.
        records: one flat record of inputs a row.
        repetitions: rounds, a burst of each candidate in turn; the median is reported.
        quiet: what is waited for, so that all of them have a core to themselves.
    """
    folder = program.executable.parent
    given, taken = folder / "inputs.bin", folder / "outputs.bin"
    np.concatenate([np.array(records.shape, float), records.ravel()]).tofile(given)
    command = (str(program.executable), str(repetitions), str(given), str(taken))

    def timed() -> Iterator[Round]:
        bursts = map(str.split, said(*command).splitlines())
        for _ in range(repetitions):
            turn = islice(bursts, len(program.candidates))
            yield {name: Burst(float(ns), float(room)) for name, ns, room in turn}

    rounds, alone = quietest(timed, repetitions, quiet)
    return Run(medians(rounds), _outputs(program, len(records), np.fromfile(taken)), alone)


def code_bytes(candidate: Candidate, item: Path) -> int:
    """Machine code that stays when nothing but the measured function is asked for."""
    return HERE.section_bytes(HERE.kept(item, candidate.measured), "text")


def stack_bytes(candidate: Candidate, item: Path) -> int:
    """Stack of the measured function and of all it calls in its file, by the compiler's account."""
    functions = HERE.functions(HERE.kept(item, candidate.measured))
    return objects.stack_bytes(item.with_suffix(".su"), functions | {candidate.measured})


def _compiled(candidate: Candidate, flags: Sequence[str], folder: Path) -> Path:
    """The object file of a candidate; every function in a section of its own."""
    source = folder / candidate.file
    source.write_text(candidate.source, encoding="utf-8")
    target = source.with_suffix(".o")
    include = [f"-I{place}" for place in candidate.include]
    command = [*COMPILERS[candidate.language], *flags, *candidate.flags]
    said(
        *command,
        "-ffunction-sections",
        "-fstack-usage",
        *include,
        "-c",
        str(source),
        "-o",
        str(target),
    )
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
    said("objcopy", f"--keep-global-symbol={candidate.symbol}", str(item), str(target))
    return target


def _outputs(program: Program, records: int, written: Array) -> dict[str, Array]:
    found, at = {}, 0
    for candidate in program.candidates:
        calls = records // candidate.epochs
        found[candidate.name] = written[at : at + calls * candidate.size].reshape(calls, -1)
        at += calls * candidate.size
    return found
