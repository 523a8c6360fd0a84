"""Which way every selection of a function goes, and samples close to where it turns.

A kernel selects between expressions by comparing: a series near zero, the closed form elsewhere.
Samples must take both ways, and some of them where it matters which way is taken.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise, product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.export.arithmetic import walk
from symnav.export.arithmetic.evaluation import Ieee, Outcome, Rows, evaluate, kind_of, loader
from symnav.lower.passes.walk import expressions, nodes

Indices = NDArray[np.intp]
Codes = NDArray[np.int64]

_SINUSOIDS = (ir.Operation.OWN_SIN, ir.Operation.OWN_COS)

#: Halvings of the way between two samples that decide differently.
HALVINGS = 6
#: Samples on either side that a way is looked for between.
TRIES = 3


def decisions(function: ir.Function, scalar: ir.Scalar, outcome: Outcome) -> list[Codes]:
    """For every selection what each row decided, as bits of its comparisons; -1 where unreached.

    Args:
        function: as it was emitted.
        scalar: its type.
        outcome: of the rows.
    """
    loads = loader(function, outcome.copies, kind_of(scalar))
    blank = Ieee(scalar, function.checks_domain, np.zeros_like(outcome.status))
    found: list[Codes] = []

    def decide(condition: ir.Expression) -> NDArray[np.bool_]:
        value = walk.evaluate(condition, loads, outcome.values, blank)
        return np.broadcast_to(value, outcome.status.shape).astype(np.bool_)

    def visit(expression: ir.Expression, reached: NDArray[np.bool_]) -> None:
        if not isinstance(expression, ir.Call):
            return
        if expression.operation is not ir.Operation.SELECT:
            for operand in expression.operands:
                visit(operand, reached)
            return
        condition, chosen, otherwise = expression.operands
        code = np.zeros(outcome.status.shape, dtype=np.int64)
        for bit, leaf in enumerate(_leaves(condition)):
            code |= decide(leaf).astype(np.int64) << bit
        found.append(np.where(reached, code, -1))
        holds = decide(condition)
        visit(chosen, reached & holds)
        visit(otherwise, reached & ~holds)

    everywhere = np.ones(outcome.status.shape, dtype=np.bool_)
    for expression in expressions(function):
        visit(expression, everywhere)
    return found


def quarters(function: ir.Function, scalar: ir.Scalar, outcome: Outcome) -> list[Codes]:
    """For every sine and cosine of the tree the quarter turn each row reaches, and its side.

    The tree evaluates them by a polynomial of its own for each quarter: 0 to 3 from zero on, 4 to
    7 below it.
    """
    loads = loader(function, outcome.copies, kind_of(scalar))
    blank = Ieee(scalar, function.checks_domain, np.zeros_like(outcome.status))
    angles = {
        node.operands[0]: None
        for expression in expressions(function)
        for node in nodes(expression)
        if isinstance(node, ir.Call) and node.operation in _SINUSOIDS
    }
    found = []
    for angle in angles:
        value = walk.evaluate(angle, loads, outcome.values, blank)
        turns = np.broadcast_to(value, outcome.status.shape).astype(np.float64) / (0.5 * np.pi)
        quarter = np.rint(np.where(np.isfinite(turns), turns, 0.0)).astype(np.int64)
        found.append(quarter % 4 + 4 * (turns < 0.0))
    return found


def decided(taken: Sequence[Codes], sample: int, items: int) -> set[tuple[int, int]]:
    """What the rows of one sample decide: number of the selection and code."""
    rows = range(sample * items, (sample + 1) * items)
    return {(k, int(code[row])) for k, code in enumerate(taken) for row in rows if code[row] >= 0}


def beside_turns(
    function: ir.Function,
    scalar: ir.Scalar,
    rows: Rows,
    items: int,
    good: Indices,
    taken: Sequence[Codes],
) -> list[dict[str, NDArray[Any]]]:
    """Samples on both sides of where selections turn, between samples that decide differently.

    Args:
        function: as it was emitted.
        scalar: its type.
        rows: of samples, ``items`` rows each.
        items: rows of a sample.
        good: samples inside the domain.
        taken: what the rows decide.
    """
    found: list[dict[str, NDArray[Any]]] = []
    seen: set[bytes] = set()
    for k, code in enumerate(taken):
        ways = code.reshape(-1, items)[good]
        if ways.tobytes() in seen:  # another selection by the same condition
            continue
        seen.add(ways.tobytes())
        first = ways[:, 0]
        codes = sorted({int(c) for c in first} - {-1})
        for low_code, high_code in pairwise(codes):
            pairs = product(good[first == low_code][:TRIES], good[first == high_code][:TRIES])
            for low, high in pairs:
                ends = (_sample(rows, int(low), items), _sample(rows, int(high), items))
                halved = _halved(function, scalar, *ends, k)
                if halved:
                    found += halved
                    break
    return found


def _halved(
    function: ir.Function, scalar: ir.Scalar, low: Rows, high: Rows, selection: int
) -> list[dict[str, NDArray[Any]]]:
    """The two ends moved together while they decide differently; none where they do not."""
    start = _way(function, scalar, low, selection)
    if start == _way(function, scalar, _between(function, low, high, 1.0), selection):
        return []
    near, far = 0.0, 1.0
    for _ in range(HALVINGS):
        middle = 0.5 * (near + far)
        if _way(function, scalar, _between(function, low, high, middle), selection) == start:
            near = middle
        else:
            far = middle
    return [_between(function, low, high, part) for part in (near, far)]


def _way(function: ir.Function, scalar: ir.Scalar, sample: Rows, selection: int) -> int:
    outcome = evaluate(function, scalar, sample)
    return int(decisions(function, scalar, outcome)[selection][0])


def _between(function: ir.Function, low: Rows, high: Rows, part: float) -> dict[str, NDArray[Any]]:
    """Reals on the straight line, quaternions on the short way; the rest as at the low end."""
    found = {name: array.copy() for name, array in low.items()}
    for argument in function.arguments:
        for domain in argument.domains:
            place = slice(domain.start, domain.start + domain.size)
            if argument.integer or domain.kind is ir.Kind.MATRIX:
                continue
            a = low[argument.name][:, place].astype(np.float64)
            b = high[argument.name][:, place].astype(np.float64)
            if domain.kind is ir.Kind.QUATERNION:
                b = b * np.where(np.sum(a * b, axis=1, keepdims=True) < 0.0, -1.0, 1.0)
            mixed = (1.0 - part) * a + part * b
            if domain.kind is ir.Kind.QUATERNION:
                mixed = mixed / np.linalg.norm(mixed, axis=1, keepdims=True)
            found[argument.name][:, place] = mixed
    return found


def _sample(rows: Mapping[str, NDArray[Any]], sample: int, items: int) -> Rows:
    return {name: a[sample * items : (sample + 1) * items] for name, a in rows.items()}


def _leaves(condition: ir.Expression) -> Iterator[ir.Expression]:
    joining = (ir.Operation.AND, ir.Operation.OR, ir.Operation.NOT)
    if isinstance(condition, ir.Call) and condition.operation in joining:
        for operand in condition.operands:
            yield from _leaves(operand)
    else:
        yield condition
