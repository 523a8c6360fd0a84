"""Runs the comparison: every contestant over the same models, interleaved in one process each.

usage: python benchmarks/run.py [--flags o2|v3|native] [--json FILE] [--only MODEL,...]
                               [--repetitions N] [--patience SECONDS] [--no-python]
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks import python_calls
from benchmarks.contestants import (
    casadi_code,
    floor_code,
    hand_code,
    symforce_code,
    symnav_code,
    sympy_code,
)
from benchmarks.contestants.contestant import Contestant
from benchmarks.measuring import Figures, measure, records
from benchmarks.problems import PROBLEMS, Problem
from benchmarks.quiet import add_options, core
from symnav.bench.program import FLAG_SETS

WRITERS = (symnav_code, casadi_code, symforce_code, sympy_code, hand_code, floor_code)


def main() -> None:
    """Measures, prints a table and, when asked for, writes the figures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--flags", choices=tuple(FLAG_SETS), default="v3")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures here")
    parser.add_argument("--only", default="", help="models, separated by commas")
    add_options(parser, 15, 90.0)
    parser.add_argument("--no-python", action="store_true", help="leave out calls from Python")
    options = parser.parse_args()
    chosen = [p for p in PROBLEMS if not options.only or p.name in options.only.split(",")]
    results: dict[str, dict[str, Figures]] = {}
    with tempfile.TemporaryDirectory() as folder:
        own = core(Path(folder), options.patience)
        for problem in chosen:
            place = Path(folder) / problem.name
            field = list(contestants(problem, place))
            results[problem.name] = measure(
                problem, field, options.flags, place, options.repetitions, own.quiet
            )
            if not options.no_python:
                calls = python_calls.measure(
                    problem,
                    place / "python",
                    records(problem),
                    own,
                    native=options.flags == "native",
                )
                results[problem.name] |= {name: Figures(ns) for name, ns in calls.items()}
            print_table(problem.name, results[problem.name])
    if options.json:
        figures = {
            model: {name: asdict(one) for name, one in found.items()}
            for model, found in results.items()
        }
        options.json.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")


def contestants(problem: Problem, folder: Path) -> Iterator[Contestant]:
    """Everybody who takes part in one model."""
    for writer in WRITERS:
        yield from writer.contestants(problem, folder)


def print_table(model: str, found: Mapping[str, Figures]) -> None:
    """The figures of one model, fastest first."""
    print(f"\n{model}")
    for name, one in sorted(found.items(), key=lambda pair: pair[1].ns):
        cells = [f"{one.ns:11.2f} ns"]
        for number, unit in (
            (one.ops, "ops"),
            (one.bytes, "B"),
            (one.stack, "B stack"),
            (one.lines, "lines"),
        ):
            cells.append("" if number is None else f"{number:7} {unit}")
        print(f"  {name:22} {' '.join(cells)}".rstrip())
    sys.stdout.flush()


if __name__ == "__main__":
    main()
