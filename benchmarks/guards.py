"""What guards cost: guarded over unguarded C of every shipped model, timed in turn.

usage: python benchmarks/guards.py [--flags o2|v3|native] [--items N] [--only MODEL,...]
                                   [--repetitions N] [--patience SECONDS]

A function whose bursts never had a core to themselves for so long is marked; its times are not to
be trusted: guards keep arithmetic units busy, and what shares the core does so as well.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.quiet import add_options
from symnav import ir, pipeline
from symnav.bench.adapters import EPOCHS, Entries
from symnav.bench.candidate import Candidate
from symnav.bench.program import FLAG_SETS, Array, built, run
from symnav.bench.quiet import Quiet, least_room
from symnav.spec.records import Spec
from symnav.verify.records import records


@dataclass(frozen=True)
class How:
    """How functions are timed.

    Attributes:
        flags: name of a flag set.
        items: satellites of a mapped function.
        repetitions: rounds.
        quiet: what is waited for.
    """

    flags: str
    items: int
    repetitions: int
    quiet: Quiet


@dataclass(frozen=True)
class Cost:
    """One function.

    Attributes:
        model: the shipped specification.
        function: its name.
        scalars: numbers one call checks.
        bare: nanoseconds without guards.
        guarded: nanoseconds with them.
        alone: True when a core did nothing else meanwhile.
    """

    model: str
    function: str
    scalars: int
    bare: float
    guarded: float
    alone: bool

    @property
    def each(self) -> float:
        """Nanoseconds of one checked number."""
        return (self.guarded - self.bare) / self.scalars


def main() -> None:
    """Measures and prints a table, a line for each function, and the average."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--flags", choices=tuple(FLAG_SETS), default="v3")
    parser.add_argument("--items", type=int, default=8, help="satellites of a mapped function")
    parser.add_argument("--only", default="", help="models, separated by commas")
    add_options(parser, 25, 60.0)
    options = parser.parse_args()
    names = options.only.split(",") if options.only else [name for name, _ in pipeline.shipped()]
    with tempfile.TemporaryDirectory() as folder:
        quiet = Quiet(least_room(options.patience / 3, Path(folder)), options.patience)
    how = How(options.flags, options.items, options.repetitions, quiet)
    costs: list[Cost] = []
    print(f"{'model':24} {'function':28} scalars  bare ns  guarded ns  ns a scalar")
    for cost in (one for name in names for one in measured(name, how)):
        costs.append(cost)
        mark = "" if cost.alone else "  shared"
        print(
            f"{cost.model:24} {cost.function:28} {cost.scalars:7} {cost.bare:8.1f} "
            f"{cost.guarded:11.1f} {cost.each:12.2f}{mark}",
            flush=True,
        )
    print(f"average of {len(costs)}: {average(costs):.2f} ns a scalar")


def average(costs: Sequence[Cost]) -> float:
    """Of all functions, each with the same weight."""
    return float(np.mean([cost.each for cost in costs]))


def measured(name: str, how: How) -> Iterator[Cost]:
    """Every measurement and correction of a shipped model that can be left unguarded."""
    spec = pipeline.load(name)
    bare = replace(spec, entries=tuple(replace(e, guards="assume") for e in spec.entries))
    with tempfile.TemporaryDirectory() as folder:
        with_guards = _functions(spec, Path(folder) / "guarded")
        without = _functions(bare, Path(folder) / "bare")
        numpy = pipeline.import_package(Path(folder) / "guarded" / spec.name).numpy
        given = records(spec, pipeline.derive(spec).entries, numpy, how.items)
        for function, inputs in given.items():
            pair = (without[function], with_guards[function])
            yield _timed(name, pair, inputs, Path(folder), how)


def _functions(spec: Spec, folder: Path) -> dict[str, Entries]:
    """Entry points of the C of a spec, generated in a folder; the number of items is left open."""
    package = pipeline.generate(spec, folder).package
    functions = pipeline.c_route(spec, pipeline.derive(spec))
    return {
        f.name: Entries(spec.name, f, package / "c", label=f"_{folder.name}") for f in functions
    }


def _timed(
    model: str,
    pair: tuple[Entries, Entries],
    inputs: Array,
    folder: Path,
    how: How,
) -> Cost:
    name = pair[0].function.name
    count = min(how.items, pair[0].function.maximum or how.items)
    bare, guarded = (replace(entries, items=count) for entries in pair)
    candidates = [_candidate(bare, "bare"), _candidate(guarded, "guarded")]
    program = built(candidates, how.flags, folder / name)
    taken = run(program, np.resize(inputs, (EPOCHS, bare.record)), how.repetitions, how.quiet)
    scalars = sum(checked(a) * (bare.count if a.item else 1) for a in guarded.function.arguments)
    return Cost(model, name, scalars, taken.ns["bare"], taken.ns["guarded"], taken.alone)


def _candidate(entries: Entries, name: str) -> Candidate:
    """Non-zeros where there is a Jacobian that has some, else the dense form."""
    outputs = entries.function.outputs
    sparse = any(output.name.startswith("jacobian") and output.entries for output in outputs)
    return entries.nonzeros(name) if sparse else entries.dense(name)


def checked(argument: ir.Argument) -> int:
    """Elements of an argument that the guards look at."""
    return sum(domain.size for domain in argument.domains if domain.kind is not ir.Kind.UNREAD)


if __name__ == "__main__":
    main()
