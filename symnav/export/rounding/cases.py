"""The inputs of a function, taken apart where it decides something.

A comparison or a floor splits the inputs into cases: both exact arithmetic and the computation
decide one way, both the other way, or rounding makes the computation decide otherwise. The last
kind needs inputs within rounding of the boundary, which is what keeps the two sides of a switch
from a series to a closed form together. Every case restricts what is compared, so that, for
instance, the closed form is never divided by something near zero.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, product

from symnav.export.rounding.evaluation import Assumptions, Evaluator, Pair, Pass
from symnav.export.rounding.expressions import COMPARISONS, Graph, Node, Operation
from symnav.export.rounding.intervals import (
    EVERYTHING,
    INFINITY,
    Empty,
    Interval,
    centred,
    point,
)
from symnav.export.rounding.model import Number, Truth

_MOST_CASES = 400
_MOST_STEPS = 8
_GROWTH = 1.6
_SHELL = 4.0
_MOST_SHELLS = 40
_PASSES = 3
_LITTLE = 0.01


@dataclass(frozen=True)
class Choice:
    """One way a comparison or a floor may go.

    Attributes:
        ranges: of nodes.
        truths: of comparisons.
        agreed: True when arithmetic and computation go the same way.
        floor: the node it decides when that is a floor.
    """

    ranges: tuple[tuple[int, Pair], ...]
    truths: tuple[tuple[int, Truth], ...]
    agreed: bool
    floor: int | None = None


def cases(evaluator: Evaluator, nodes: Sequence[Node]) -> Iterator[Assumptions]:
    """Every case of a cone of nodes; together they hold every input."""
    first = evaluator.run(nodes, Assumptions())
    decisions = list(_decisions(evaluator, nodes, first, refined=True))
    if math.prod(len(choices) for choices in decisions) > _MOST_CASES:
        decisions = list(_decisions(evaluator, nodes, first, refined=False))
    while math.prod(len(choices) for choices in decisions) > _MOST_CASES:
        # What is not split is joined: both branches at once, which is wider but holds as well.
        decisions.remove(max(decisions, key=len))
    for chosen in product(*decisions):
        try:
            yield _joined(chosen)
        except Empty:
            continue


def _joined(chosen: Iterable[Choice]) -> Assumptions:
    ranges: dict[int, Pair] = {}
    truths: dict[int, Truth] = {}
    floors: list[int] = []
    agreed = True
    for choice in chosen:
        floors += [] if choice.floor is None else [choice.floor]
        for node, (real, computed) in choice.ranges:
            before = ranges.get(node, (EVERYTHING, EVERYTHING))
            ranges[node] = (before[0].meet(real), before[1].meet(computed))
        truths.update(choice.truths)
        agreed = agreed and choice.agreed
    return Assumptions(ranges, truths, agreed, tuple(floors))


def followed(case: Assumptions, *, computed: bool) -> Assumptions:
    """A case with every decision made as the computation makes it, or as exact arithmetic does.

    Where the two differ, the error is at most that of the branch the computation takes plus the
    distance between the two branches' exact values.
    """
    truths = {}
    for node, truth in case.truths.items():
        way = truth.computed if computed else truth.real
        truths[node] = Truth(way, way, True)
    ranges = dict(case.ranges)
    for floor in case.floors:
        step = ranges[floor][1 if computed else 0]
        ranges[floor] = (step, step)
    return Assumptions(ranges, truths, True, case.floors)


def settle(
    evaluator: Evaluator, nodes: Sequence[Node], case: Assumptions, passes: int = _PASSES
) -> Pass:
    """The numbers of a case, with what later nodes say about earlier ones.

    Args:
        evaluator: of the function.
        nodes: a cone.
        case: what is assumed.
        passes: most times to look at all nodes.

    Raises:
        Empty: when the case cannot happen.
    """
    ranges = dict(case.ranges)
    for last in range(passes - 1, -1, -1):
        result = evaluator.run(nodes, replace(case, ranges=dict(ranges)))
        if last == 0:
            break
        news = [*_consequences(evaluator, result), *_of_decided(evaluator, case, result)]
        if all(_holds(result.numbers[node].real, known) for node, known in news):
            break
        for node, known in news:
            before = ranges.get(node, (EVERYTHING, EVERYTHING))
            ranges[node] = (before[0].meet(known), before[1])
    return result


def _holds(values: Interval, known: Interval) -> bool:
    """True where what is known would hardly narrow the values."""
    if values.is_point or values.magnitude == INFINITY:
        return known.lo <= values.lo and values.hi <= known.hi
    margin = _LITTLE * (values.hi - values.lo)
    return known.lo <= values.lo + margin and values.hi - margin <= known.hi


def _of_decided(
    evaluator: Evaluator, case: Assumptions, found: Pass
) -> Iterator[tuple[int, Interval]]:
    """What a compared value, by now known better, says about what it is computed from."""
    for node in case.ranges:
        if node not in case.floors:
            pulled = _pulled(evaluator.graph, node, found.numbers[node].real)
            yield from ((operand, real) for operand, (real, _) in pulled)


def _consequences(evaluator: Evaluator, found: Pass) -> Iterator[tuple[int, Interval]]:
    """What exact values say about exact values they are computed from, and about each other."""
    yield from _of_complements(evaluator, found)
    for index, squares in evaluator.structure.squares.items():
        if index in found.numbers and squares.chosen is None:
            longest = found.numbers[index].real.sqrt().hi
            yield from ((leaf, centred(longest)) for leaf in squares.leaves)
    for fact in evaluator.structure.differences:
        if fact.squares in found.numbers:
            reach = centred(found.numbers[fact.squares].real.sqrt().hi)
            for first, second, sign in fact.parts:
                for one, other in ((first, second), (second, first)):
                    opposite = found.numbers[other].real
                    yield one, reach + (-opposite if sign > 0 else opposite)


def _of_complements(evaluator: Evaluator, found: Pass) -> Iterator[tuple[int, Interval]]:
    """What two nodes whose squares have a known sum say about each other."""
    for fact in evaluator.structure.complements:
        if fact.squares in found.numbers and fact.other in found.numbers:
            squares, other = found.numbers[fact.squares].real, found.numbers[fact.other].real
            yield fact.squares, fact.total - other.square()
            roots = (fact.total - squares).sqrt()
            if other.lo >= 0.0:
                yield fact.other, roots
            elif other.hi <= 0.0:
                yield fact.other, -roots
            else:
                yield fact.other, Interval(-roots.hi, roots.hi)


def _decisions(
    evaluator: Evaluator, nodes: Sequence[Node], first: Pass, *, refined: bool
) -> Iterator[list[Choice]]:
    graph = evaluator.graph
    differences = {fact.squares for fact in evaluator.structure.differences}
    for node in nodes:
        if node.content in (Operation.LT, Operation.LE):
            choices = list(_inequality(graph, node, first.numbers, refined=refined))
        elif node.content in COMPARISONS:
            choices = list(_equality(graph, node, first))
        elif node.does(Operation.FLOOR):
            choices = list(_floor(graph, node, first.numbers))
        elif refined and node.index in differences:
            choices = list(_shells(node, first.numbers))
        else:
            continue
        if len(choices) > 1:
            yield choices


def _shells(node: Node, numbers: Mapping[int, Number]) -> Iterator[Choice]:
    """A guarded squared distance, from near to far: what is near is small as well."""
    for piece in _pieces(EVERYTHING, numbers[node.index].real, _SHELL, _MOST_SHELLS):
        yield Choice(((node.index, (piece, EVERYTHING)),), (), True)


def _inequality(
    graph: Graph, node: Node, numbers: Mapping[int, Number], *, refined: bool
) -> Iterator[Choice]:
    """``value < threshold`` where the threshold is a literal."""
    left, right = node.operands
    if right not in numbers or graph.nodes[right].number is None:
        return
    threshold, value = numbers[right], numbers[left]
    if value.error == INFINITY:
        return
    exact, held = threshold.real.lo, threshold.computed.lo
    free_of_rounding = value.error == 0.0 and threshold.error == 0.0
    for real, computed in product((True, False), repeat=2):
        if real != computed and free_of_rounding:
            continue
        truth = Truth(real, computed, real == computed)
        sides = (_side(exact, real), _side(held, computed))
        pieces = [sides[0]]
        if refined and real == computed:
            pieces = list(_pieces(sides[0], value.real))
        for piece in pieces:
            pair = (piece, sides[1])
            ranges = ((left, pair), *_pulled(graph, left, piece))
            yield Choice(tuple(ranges), ((node.index, truth),), real == computed)


def _side(threshold: float, is_less: bool) -> Interval:
    return Interval(-INFINITY, threshold) if is_less else Interval(threshold, INFINITY)


def _pieces(
    side: Interval, values: Interval, growth: float = _GROWTH, most: int = _MOST_STEPS
) -> Iterator[Interval]:
    """A positive range cut at growing steps, so that quotients by it do not spread."""
    low, high = max(side.lo, values.lo), min(side.hi, values.hi)
    steps = 1
    if 0.0 < low < high < INFINITY:
        steps = max(1, min(most, math.ceil(math.log(high / low) / math.log(growth))))
    ratio = (high / low) ** (1.0 / steps) if steps > 1 else 1.0
    ends = [side.lo, *(low * ratio**k for k in range(1, steps)), side.hi]
    for start, stop in pairwise(ends):
        yield Interval(start, stop)


def _equality(graph: Graph, node: Node, first: Pass) -> Iterator[Choice]:
    """``value == literal`` of an integer input, which rounding does not touch."""
    left, right = node.operands
    value, literal = first.numbers[left], first.numbers[right]
    if value.error or literal.error or not literal.real.is_point:
        return
    wanted = node.does(Operation.EQ)
    number = literal.real.lo
    yield Choice(
        ((left, (literal.real, literal.real)),), ((node.index, Truth(wanted, wanted, True)),), True
    )
    for rest in _without(value.real, number):
        truth = Truth(not wanted, not wanted, True)
        yield Choice(((left, (rest, rest)),), ((node.index, truth),), True)


def _without(values: Interval, number: float) -> Iterator[Interval]:
    """A range without one number: what is left on either side, its end included."""
    if values.lo < number:
        yield Interval(values.lo, number)
    if values.hi > number:
        yield Interval(number, values.hi)


def _floor(graph: Graph, node: Node, numbers: Mapping[int, Number]) -> Iterator[Choice]:
    """A floor: the same integer for both, or neighbours."""
    (operand,) = node.operands
    floors = numbers[node.index]
    steps = floors.real.hull(floors.computed)
    if not steps.hi - steps.lo < _MOST_STEPS or numbers[operand].error >= 1.0:
        return
    integers = [steps.lo + k for k in range(int(steps.hi - steps.lo) + 1)]
    for real, computed in product(integers, repeat=2):
        if abs(real - computed) <= 1.0:
            pair = (Interval(real, real + 1.0), Interval(computed, computed + 1.0))
            ranges = [(operand, pair), (node.index, (point(real), point(computed)))]
            ranges += _pulled(graph, operand, pair[0])
            yield Choice(tuple(ranges), (), real == computed, node.index)


def _pulled(graph: Graph, index: int, real: Interval) -> list[tuple[int, Pair]]:
    """What a range of a node says about what it is computed from, literals aside."""
    node = graph.nodes[index]
    numbers = [graph.nodes[operand].number for operand in node.operands]
    if len(numbers) != 2 or (numbers[0] is None) == (numbers[1] is None):
        return []
    place = 1 if numbers[1] is None else 0
    literal = numbers[1 - place]
    assert literal is not None
    found = _inverted(node, place, point(literal), real)
    if found is None:
        return []
    operand = node.operands[place]
    return [(operand, (found, EVERYTHING)), *_pulled(graph, operand, found)]


def _inverted(node: Node, place: int, literal: Interval, real: Interval) -> Interval | None:
    if node.does(Operation.ADD):
        return real - literal
    if node.does(Operation.SUB):
        return literal - real if place == 1 else real + literal
    if node.does(Operation.MUL) and literal.lo != 0.0:
        return real / literal
    return None
