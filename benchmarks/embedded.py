"""Compares generated C in single precision with its rivals on an emulated Cortex-M4F.

usage: python benchmarks/embedded.py [--cpu cortex-m4|cortex-m7] [--only MODEL,...] [--json FILE]

Every contestant becomes a program of its own, which counts its instructions and is weighed.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from pathlib import Path
from shutil import copy

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.contestants import casadi_code, hand_code, single, symnav_code
from benchmarks.contestants.contestant import Contestant
from benchmarks.measuring import expected, records
from benchmarks.problems import PROBLEMS, Problem
from symnav.build.objects import said, stack_bytes
from symnav.emit.templates import directory
from symnav.export.building.targets import FOLDER, TICK
from symnav.export.runners.emulation import ARM, TARGETS, Target

HERE = Path(__file__).parent
SUPPORT = directory() / "export" / FOLDER
MODELS = tuple(problem.name for problem in PROBLEMS if problem.name != "filter")
Floats = NDArray[np.float32]
Truth = tuple[list[float], list[float]]
RECORDS = 8
TOLERANCE = 2e-6
"""Of the largest result; single precision has 6e-8."""


@dataclass(frozen=True)
class Figures:
    """What was found of one contestant.

    Attributes:
        instructions: of one call, of what it calls as well.
        code: bytes of its code and constants.
        flash: bytes it adds to a program, with what it pulls from libraries.
        stack: bytes of stack, libraries left out.
        undefined: what it needs from libraries.
    """

    instructions: float
    code: int
    flash: int
    stack: int
    undefined: tuple[str, ...]


def main() -> None:
    """Measures, prints a table and, when asked for, writes the figures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cpu", choices=tuple(TARGETS), default="cortex-m4")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures here")
    parser.add_argument("--only", default="", help="models, separated by commas")
    options = parser.parse_args()
    chosen = options.only.split(",") if options.only else MODELS
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        for problem in PROBLEMS:
            if problem.name in chosen:
                place = Path(folder) / problem.name
                results[problem.name] = measure(problem, TARGETS[options.cpu], place)
                print_table(problem.name, results[problem.name])
    if options.json:
        figures = {
            model: {name: asdict(one) for name, one in found.items()}
            for model, found in results.items()
        }
        options.json.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")


def measure(problem: Problem, target: Target, folder: Path) -> dict[str, Figures]:
    """Figures of every contestant of a problem.

    Raises:
        SystemExit: when a contestant computes something else.
        BuildError: when a tool is missing or something does not compile.
    """
    given = records(problem)[:RECORDS].astype(np.float32)
    workshop = Workshop(target, folder / "programs")
    truths = [expected(problem, record.tolist()) for record in given]
    taking_part = list(contestants(problem, folder))
    _, empty = workshop.made(problem, _idle(taking_part[0]), given)
    found = {}
    for contestant in taking_part:
        item, program = workshop.made(problem, contestant, given)
        printed = target.emulated(program).splitlines()
        compare(contestant, truths, printed)
        ticks, calls = (int(printed[-1].split()[k]) for k in (1, 3))
        kept = ARM.kept(item, contestant.candidate.measured)
        found[contestant.name] = Figures(
            instructions=round(TICK * ticks / calls, 1),
            code=ARM.section_bytes(kept, "text|rodata"),
            flash=_loaded(program) - _loaded(empty),
            stack=stack_bytes(item.with_suffix(".su"), ARM.functions(kept)),
            undefined=ARM.needed(kept),
        )
    return found


def contestants(problem: Problem, folder: Path) -> Iterator[Contestant]:
    """Who takes part: symnav, CasADi as it comes and mended, C written by hand."""
    yield from symnav_code.in_single(problem, folder)
    yield from casadi_code.in_single(problem)
    yield from map(single.mended, hand_code.contestants(problem, folder))


def compare(contestant: Contestant, truths: Sequence[Truth], printed: Sequence[str]) -> None:
    """Results of every record against 50 digits for the same rounded inputs."""
    results = [line for line in printed if line.startswith("out ")]
    for (truth, scale), line in zip(truths, results, strict=True):
        words = np.array([int(word, 16) for word in line.split()[1:]], np.uint32)
        found = words.view(np.float32)[list(contestant.order)].astype(float)
        worst = np.max(np.abs(found - truth) / scale)
        if not worst < TOLERANCE:
            raise SystemExit(f"{contestant.problem.name} {contestant.name}: differs by {worst:.1e}")


def print_table(model: str, found: Mapping[str, Figures]) -> None:
    """The figures of one model, fewest instructions first."""
    print(f"\n{model}")
    for name, one in sorted(found.items(), key=lambda pair: pair[1].instructions):
        print(
            f"  {name:22} {one.instructions:9.1f} instructions {one.code:6} B code "
            f"{one.flash:6} B flash {one.stack:5} B stack  {' '.join(one.undefined)}".rstrip()
        )
    sys.stdout.flush()


def _idle(contestant: Contestant) -> Contestant:
    """Nothing, in the place of a contestant: what the program weighs without it."""
    symbol = contestant.candidate.symbol
    source = f"void {symbol}(const float *in, float *out)\n{{\n    (void)in;\n    (void)out;\n}}\n"
    candidate = replace(
        contestant.candidate, name=f"{contestant.name}_idle", source=source, include=(), root=symbol
    )
    return replace(contestant, candidate=candidate)


def _caller(problem: Problem, symbol: str, size: int, given: Floats) -> str:
    """The main program around one contestant."""
    rows = ["{" + ", ".join(f"{float(e).hex()}F" for e in row) + "}," for row in given]
    return "\n".join(
        [
            f"#define RECORDS {len(given)}",
            f"#define SIZE {size}",
            f"#define CALL {symbol}",
            f"static const float records[RECORDS][{problem.record}] = {{",
            *rows,
            "};",
            "",
            (HERE / "embedded.c").read_text(encoding="utf-8"),
        ]
    )


def _loaded(program: Path) -> int:
    """Bytes of a program that stand in flash."""
    return ARM.section_bytes(program, "text|rodata|data")


@dataclass(frozen=True)
class Workshop:
    """Makes programs.

    Attributes:
        target: what for.
        folder: for sources and objects.
    """

    target: Target
    folder: Path

    def made(self, problem: Problem, contestant: Contestant, given: Floats) -> tuple[Path, Path]:
        """The object of a contestant and the program that calls it."""
        candidate = contestant.candidate
        place = self.folder / contestant.name
        place.mkdir(parents=True, exist_ok=True)
        source = place / candidate.file
        source.write_text(candidate.source, encoding="utf-8")
        item = self._object(source, *(f"-I{folder}" for folder in candidate.include))
        return item, self._linked(place, _caller(problem, candidate.symbol, candidate.size, given))

    def _object(self, source: Path, *options: str) -> Path:
        item = source.with_suffix(".o")
        said(
            "arm-none-eabi-gcc", "-std=gnu99", *self.target.flags, "-ffunction-sections",
            "-fdata-sections", "-fstack-usage", *options, "-c", str(source), "-o", str(item),
        )  # fmt: skip
        return item

    def _linked(self, place: Path, caller: str) -> Path:
        """A program of all objects in a folder, with the start-up code of a bundle."""
        main = place / "main.c"
        main.write_text(caller, encoding="utf-8")
        self._object(main, "-ffreestanding")
        program = place / "program.elf"
        objects = [*sorted(place.glob("*.o")), *self.support]
        said(
            "arm-none-eabi-gcc", *self.target.flags, "-nostartfiles", "-Wl,--gc-sections",
            "-T", str(SUPPORT / "mps2.ld"), *map(str, objects), "-lm", "-o", str(program),
        )  # fmt: skip
        return program

    @cached_property
    def support(self) -> tuple[Path, ...]:
        """What stands between a reset and the main program."""
        place = self.folder / "support"
        place.mkdir(parents=True)
        copies = [Path(copy(SUPPORT / name, place)) for name in ("startup.c", "semihost.c")]
        return tuple(self._object(one, "-ffreestanding", f"-I{SUPPORT}") for one in copies)


if __name__ == "__main__":
    main()
