"""Hand-written C: what a careful engineer would write for these models and nothing else."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from benchmarks.contestants.contestant import Contestant, natural, symbol_of
from benchmarks.problems import Problem
from symnav.bench.candidate import Candidate, adapter

SOURCES = Path(__file__).parents[1] / "hand"


def contestants(problem: Problem, _folder: Path) -> Iterator[Contestant]:
    """One contestant; satellites in columns, as symnav stores them."""
    body = []
    parts = ", ".join(f"in + {at}" for name, at in problem.offsets.items() if name != "x")
    values = problem.rows
    if problem.items:
        offsets = problem.offsets
        chosen = ", ".join(f"in + {offsets[n]}" for n in ("p", "q", "b", "l", "C", "s"))
        function, call = "hand_ranges", f"hand_ranges(items, {chosen}, out, out + 32);"
        columns = len(problem.nonzeros[0])
        order = tuple(range(values)) + tuple(
            32 + 32 * column + i for i in range(values) for column in range(columns)
        )
        source = "hand_ranges.c"
        size = 32 * (1 + columns)
        body.append(f"static volatile int items = {problem.items};")  # known at run time only
    else:
        function = f"hand_{problem.name}"
        call = f"{function}({parts}, out, out + {values});"
        order, source = natural(problem), f"{function}.c"
        size = len(order)
    symbol = symbol_of(problem, "hand")
    unit = f'#include "{source}"\n\n{adapter(symbol, [*body, call])}'
    candidate = Candidate(
        name="hand", symbol=symbol, source=unit, size=size, include=(SOURCES,), root=function
    )
    text = (SOURCES / source).read_text(encoding="utf-8")
    yield Contestant(
        problem=problem, candidate=candidate, order=order, text=text, functions=(function,)
    )
