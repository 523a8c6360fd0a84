"""Rigorous bounds on the rounding error of every output of a lowered function.

For inputs inside their declared ranges that pass the guards in exact arithmetic as well,

    |computed - exact| <= bound

where *computed* is what the C returns in its type and *exact* what the same operations give on the
same inputs without any rounding. Inputs are exact: the number the caller passes is the number that
is meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from symnav import ir
from symnav.errors import InputError
from symnav.export.rounding.cases import cases, followed, settle
from symnav.export.rounding.evaluation import Assumptions, Evaluator
from symnav.export.rounding.expressions import COMPARISONS, Graph, Node, Operation, trace
from symnav.export.rounding.formats import FORMATS, Format
from symnav.export.rounding.intervals import Empty, Interval, up_sum
from symnav.export.rounding.structure import Structure


def bounded(function: ir.Function, scalar: ir.Scalar) -> ir.Function:
    """The function with the rounding of every entry of its outputs filled in.

    Raises:
        InputError: when no input inside the declared ranges passes the guards.
    """
    try:
        found = bounds(function, scalar)
    except Empty:
        raise InputError(f"{function.name}: {_refuses_everything(function)}") from None
    outputs = tuple(replace(o, rounding=found[o.name]) for o in function.outputs)
    return replace(function, outputs=outputs)


def _refuses_everything(function: ir.Function) -> str:
    checks = [step for step in (*function.shared, *function.item) if isinstance(step, ir.Check)]
    limits = dict.fromkeys(f"{c.comment} in [{c.lower:g}, {c.upper:g}]" for c in checks)
    return (
        "nothing inside the declared ranges of its inputs passes its guards "
        f"({', '.join(limits)}); declare wider ranges or change the equation"
    )


def bounds(
    function: ir.Function, scalar: ir.Scalar, kind: Format | None = None
) -> dict[str, tuple[ir.Rounding, ...]]:
    """Bounds for the entries of every output, in their order.

    Args:
        function: as it is written in C.
        scalar: type of the C.
        kind: what the type does to numbers, where it is not the usual.
    """
    kind = kind or FORMATS[scalar]
    graph = trace(function)
    evaluator = Evaluator(graph, Structure(graph, kind), kind, ranges(function, graph, kind))
    by_node: dict[int, ir.Rounding] = {}
    for group in _groups(graph):
        by_node |= _of_group(evaluator, group)
    return {
        name: tuple(by_node[node] for node in results) for name, results in graph.results.items()
    }


def _groups(graph: Graph) -> Iterator[list[int]]:
    """Results that depend on the same decisions, to be looked at together."""
    groups: dict[frozenset[int], list[int]] = {}
    for results in graph.results.values():
        for node in dict.fromkeys(results):
            decided = frozenset(n.index for n in graph.cone([node]) if _decides(n.content))
            group = groups.setdefault(decided, [])
            if node not in group:
                group.append(node)
    yield from groups.values()


def _decides(content: object) -> bool:
    return content is Operation.FLOOR or content in COMPARISONS


def _of_group(evaluator: Evaluator, group: list[int]) -> dict[int, ir.Rounding]:
    nodes = evaluator.graph.cone(group)
    worst = dict.fromkeys(group, ir.Rounding(0.0, 0.0, 0.0))
    for case in cases(evaluator, nodes):
        try:
            found = _of_case(evaluator, nodes, case, group)
        except Empty:
            continue
        worst = {node: _worse(worst[node], found[node]) for node in group}
    return worst


def _worse(a: ir.Rounding, b: ir.Rounding) -> ir.Rounding:
    return ir.Rounding(max(a.bound, b.bound), max(a.smooth, b.smooth), max(a.largest, b.largest))


def _of_case(
    evaluator: Evaluator, nodes: Sequence[Node], case: Assumptions, group: list[int]
) -> dict[int, ir.Rounding]:
    numbers = settle(evaluator, nodes, case).numbers
    direct = {node: numbers[node].error for node in group}
    errors = direct if case.agreed else _decided_otherwise(evaluator, nodes, case, direct)
    return {
        node: ir.Rounding(error, error if case.agreed else 0.0, numbers[node].computed.magnitude)
        for node, error in errors.items()
    }


def _decided_otherwise(
    evaluator: Evaluator, nodes: Sequence[Node], case: Assumptions, direct: dict[int, float]
) -> dict[int, float]:
    """Errors where rounding decides: through both branches at once, or from one to the other."""
    try:
        taken = settle(evaluator, nodes, followed(case, computed=True), 1).numbers
        meant = settle(evaluator, nodes, followed(case, computed=False), 1).numbers
    except Empty:  # one of the branches has no value there
        return direct
    jumps = {node: taken[node].real.farthest(meant[node].real) for node in direct}
    return {
        node: min(error, up_sum(taken[node].error, jumps[node])) for node, error in direct.items()
    }


def ranges(function: ir.Function, graph: Graph, kind: Format) -> dict[ir.Load, Interval]:
    """Range of every element that is read: as it was declared, and as the C admits it."""
    loads = [node.content for node in graph.nodes if isinstance(node.content, ir.Load)]
    return {load: _range(function, load, kind) for load in loads}


def _admitted(lower: float, upper: float, kind: Format) -> Interval:
    """A declared range with the numbers of the type nearest to its ends, which the C compares."""
    lower, upper = (min(max(end, -kind.largest), kind.largest) for end in (lower, upper))
    # What is rounded to zero has its end inside the range instead: literals.declared.
    rounded = [kind.literal(end) or end for end in (lower, upper)]
    return Interval(min(lower, rounded[0]), max(upper, rounded[1]))


def _range(function: ir.Function, load: ir.Load, kind: Format) -> Interval:
    argument = next(a for a in function.arguments if a.name == load.argument)
    ends = [
        _admitted(domain.lower[k], domain.upper[k], kind)
        for domain in argument.domains
        for k in range(domain.size)
    ]
    if isinstance(load.index, int):
        return ends[load.index]
    slots = _range(function, load.index.slot, kind)
    first = load.index.base + int(slots.lo)
    last = load.index.base + int(slots.hi)
    chosen = ends[first]
    for one in ends[first + 1 : last + 1]:
        chosen = chosen.hull(one)
    return chosen
