"""No contestant but a measure: the loads, stores, divisions, roots and sines of a model, no more.

Whatever computes the model on this machine takes at least as long, so the distance to it is what
arithmetic, and a better schedule of it, could still give.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from benchmarks.contestants.contestant import Contestant, symbol_of
from benchmarks.problems import Problem
from symnav.bench.candidate import Candidate, adapter

COLUMNS = 32


def contestants(problem: Problem, _folder: Path) -> Iterator[Contestant]:
    """One for each problem; its results are not compared."""
    function = f"floor_{problem.name}"
    if problem.items:
        body, size = _items(problem), COLUMNS * (1 + len(problem.nonzeros[0]))
    else:
        size = problem.rows + len(problem.pattern)
        body = _straight(problem, size)
    head = f"void {function}(const double in[restrict], double out[restrict])"
    lines = ["#include <math.h>", f"{head};", head, "{", *(f"    {line}" for line in body), "}", ""]
    symbol = symbol_of(problem, "floor")
    source = "\n".join(lines) + adapter(symbol, [f"{function}(in, out);"])
    candidate = Candidate(name="floor", symbol=symbol, source=source, size=size, root=function)
    yield Contestant(problem=problem, candidate=candidate, order=())


def _straight(problem: Problem, size: int) -> list[str]:
    """Every output stored once; the divisor and the angle where there are any."""
    offsets = problem.offsets
    lines = ["double value = in[0];"]
    if "dt" in offsets:
        lines.append(f"value = 1.0 / in[{offsets['dt']}];")
    if "psi" in offsets:
        angle = f"in[{offsets['psi']}]"
        lines += [f"const double s = sin({angle}), c = cos({angle});", "value = s + c;"]
    given = [f"in[{k % problem.record}]" for k in range(size)]
    return [*lines, *(f"out[{k}] = {source} + value;" for k, source in enumerate(given))]


def _items(problem: Problem) -> list[str]:
    """One root, one division and the columns of every satellite."""
    columns = len(problem.nonzeros[0])
    stores = [f"    out[{COLUMNS * (1 + k)} + i] = inverse;" for k in range(columns)]
    return [
        f"const double *restrict s = in + {problem.offsets['s']};",
        "#pragma GCC ivdep",
        f"for (int i = 0; i < {problem.items}; ++i) {{",
        "    const double x = s[3 * i], y = s[3 * i + 1], z = s[3 * i + 2];",
        "    const double range = sqrt(x * x + y * y + z * z);",
        "    const double inverse = 1.0 / range;",
        "",
        "    out[i] = range;",
        *stores,
        "}",
    ]
