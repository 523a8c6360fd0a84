"""One pass over a graph: the number of every node, under assumptions about some of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from symnav import ir
from symnav.export.rounding import propagation
from symnav.export.rounding.expressions import COMPARISONS, Graph, Node, Operation
from symnav.export.rounding.formats import Format
from symnav.export.rounding.intervals import (
    EVERYTHING,
    INFINITY,
    Interval,
    down_quotient,
    down_sqrt,
    down_sum,
    length,
    total,
    up_product,
    up_quotient,
    up_sum,
)
from symnav.export.rounding.model import Number, Truth
from symnav.export.rounding.polynomials import Polynomial
from symnav.export.rounding.structure import Direction, Structure

Pair = tuple[Interval, Interval]
"""Where a node's exact and its computed value are known to be."""


@dataclass(frozen=True)
class Assumptions:
    """One case.

    Attributes:
        ranges: of nodes.
        truths: of comparisons.
        agreed: True when arithmetic and computation decide every comparison alike.
        floors: nodes whose ranges are decisions.
    """

    ranges: Mapping[int, Pair] = field(default_factory=dict)
    truths: Mapping[int, Truth] = field(default_factory=dict)
    agreed: bool = True
    floors: tuple[int, ...] = ()


@dataclass(frozen=True)
class Pass:
    """The numbers of a pass; conditions stand apart."""

    numbers: Mapping[int, Number]
    truths: Mapping[int, Truth]


@dataclass(frozen=True)
class Evaluator:
    """Evaluates a function's graph in one type."""

    graph: Graph
    structure: Structure
    kind: Format
    inputs: Mapping[ir.Load, Interval]

    def run(self, nodes: Iterable[Node], case: Assumptions) -> Pass:
        """Numbers and truths of some nodes, which come with everything they depend on.

        Raises:
            Empty: when the case cannot happen.
        """
        numbers: dict[int, Number] = {}
        truths: dict[int, Truth] = {}
        for node in nodes:
            if isinstance(node.content, Operation) and node.content in ir.CONDITIONS:
                truths[node.index] = self._truth(node, numbers, truths, case)
                continue
            if node.index in case.floors:
                numbers[node.index] = _decided(*case.ranges[node.index]).settled()
                continue
            real, computed = case.ranges.get(node.index, (EVERYTHING, EVERYTHING))
            known = self._known(node.index, numbers).meet(real)
            number = self._number(node, numbers, truths, known).within(known, computed).settled()
            number = self._refined(node, number, numbers, truths)
            numbers[node.index] = number.settled()
        return Pass(numbers, truths)

    def _known(self, index: int, numbers: Mapping[int, Number]) -> Interval:
        """What holds for the exact value of a node, whatever it is computed from."""
        facts = self.structure
        known = facts.forms.get(index, EVERYTHING)
        if index in facts.cancels:
            exact = facts.polynomials[index]
            # A cosine may stand for a sine that is not computed from it.
            if index not in exact.generators and exact.generators <= numbers.keys():
                known = known.meet(exact.range(lambda g: numbers[g].real))
        return known

    def _number(
        self,
        node: Node,
        numbers: Mapping[int, Number],
        truths: Mapping[int, Truth],
        known: Interval,
    ) -> Number:
        content = node.content
        if isinstance(content, ir.Number):
            return propagation.literal(content.value, self.kind)
        if isinstance(content, ir.Load):
            return self._element(content)
        if isinstance(content, ir.Check):
            return self._guarded(content, numbers[node.operands[0]])
        if content is Operation.SELECT:
            condition, *branches = node.operands
            return _chosen(truths[condition], *(numbers[branch] for branch in branches))
        operands = [numbers[operand] for operand in node.operands]
        if content is Operation.ATAN2 and all(o.error < INFINITY for o in operands):
            radius = self._radius(self.structure.radii[node.index], numbers)
            return propagation.angle(operands[0], operands[1], radius, self.kind, known)
        return propagation.apply(content, operands, self.kind, known)

    def _radius(self, squared: Polynomial, numbers: Mapping[int, Number]) -> float:
        """Least exact distance from the origin."""
        if not squared.generators <= numbers.keys():
            return 0.0
        return down_sqrt(squared.range(lambda g: numbers[g].real).mignitude)

    def _element(self, load: ir.Load) -> Number:
        values = self.inputs[load]
        number = propagation.element(values, self.kind)
        if values.magnitude <= 2.0**self.kind.bits:
            return number
        whole = self._is_integer(load)
        error = self.kind.rounding(values.magnitude) if whole else 0.0
        return Number(values, number.computed, error, error)

    def _is_integer(self, load: ir.Load) -> bool:
        arguments = self.graph.function.arguments
        return any(argument.integer for argument in arguments if argument.name == load.argument)

    def _guarded(self, check: ir.Check, value: Number) -> Number:
        """What passed a guard is a number inside its bounds, in the C and in exact arithmetic."""
        bounds = Interval(check.lower, check.upper)
        ends = [
            min(max(end, -self.kind.largest), self.kind.largest) for end in (bounds.lo, bounds.hi)
        ]
        held = bounds.hull(Interval(*(self.kind.literal(end) for end in ends)))
        passed = value.within(bounds, held)
        if value.error == INFINITY:
            distance = passed.real.farthest(passed.computed)
            return Number(passed.real, passed.computed, distance, distance)
        return passed

    def _truth(
        self,
        node: Node,
        numbers: Mapping[int, Number],
        truths: Mapping[int, Truth],
        case: Assumptions,
    ) -> Truth:
        if node.index in case.truths:
            return case.truths[node.index]
        if node.content in COMPARISONS:
            a, b = (numbers[operand] for operand in node.operands)
            exact = a.error == 0.0 and b.error == 0.0
            assert isinstance(node.content, Operation)
            real = _compared(node.content, a.real, b.real)
            computed = _compared(node.content, a.computed, b.computed)
            return Truth(real, computed, exact or (real is not None and real == computed))
        given = [truths[operand] for operand in node.operands]
        if node.does(Operation.NOT):
            return given[0].negated()
        if node.does(Operation.AND):
            return given[0].both(given[1])
        return given[0].negated().both(given[1].negated()).negated()

    def _refined(
        self,
        node: Node,
        number: Number,
        numbers: Mapping[int, Number],
        truths: Mapping[int, Truth],
    ) -> Number:
        """The number with what the structure of the graph says about it."""
        facts, index = self.structure, node.index
        if number.error == INFINITY:
            return number
        if index in facts.norms and self._is_chosen(facts.norms[index], truths):
            return self._as_norm(index, number, numbers)
        if index in facts.directions:
            direction = facts.directions[index]
            if self._is_chosen(facts.norms[direction.norm], truths):
                return self._as_direction(direction, number, numbers)
        return number

    def _is_chosen(self, squares: int, truths: Mapping[int, Truth]) -> bool:
        """True where a sum of squares is one: nothing else was chosen in its place."""
        chosen = self.structure.squares[squares].chosen
        if chosen is None:
            return True
        truth = truths[chosen[0]]
        return truth.real is truth.computed is chosen[1]

    def _as_norm(self, index: int, number: Number, numbers: Mapping[int, Number]) -> Number:
        """A norm moves by no more than the vector does; its own rounding is relative."""
        squared = self.structure.norms[index]
        relative = self._relative(squared, 1, numbers)
        if relative >= 0.5:
            return number
        leaves = self.structure.squares[squared].leaves
        moved = length(numbers[leaf].error for leaf in leaves)
        longest = length(numbers[leaf].computed.magnitude for leaf in leaves)
        # What is computed is a norm times (1 + relative): the norm is not above this.
        seen = up_quotient(number.computed.magnitude, down_sum(1.0, -relative))
        rounding = up_product(relative, min(longest, seen))
        return _no_worse(number, up_sum(moved, rounding))

    def _as_direction(
        self, direction: Direction, number: Number, numbers: Mapping[int, Number]
    ) -> Number:
        """An element of a vector over its norm is at most 1."""
        norm = numbers[direction.norm]
        squared = self.structure.norms[direction.norm]
        relative = self._relative(squared, 1 + direction.roundings, numbers)
        if relative >= 0.5:
            return number
        leaves = self.structure.squares[squared].leaves
        moved = length(numbers[leaf].error for leaf in leaves)
        unit = total((1.0, relative))
        bounded = number.within(Interval(-1.0, 1.0), Interval(-unit, unit))
        # |a'/|a'| - a/|a|| <= 2 |a' - a| / (|a'| + |a|), and |a'| is the computed norm but for its
        # own rounding.
        shorter = down_quotient(norm.computed.mignitude, unit)
        lengths = down_sum(norm.real.mignitude, shorter)
        turned = up_quotient(up_product(2.0, moved), lengths) if lengths > 0.0 else INFINITY
        return _no_worse(bounded, total((min(turned, 2.0), relative, self.kind.tiny)))

    def _relative(self, squared: int, more: int, numbers: Mapping[int, Number]) -> float:
        """Relative error of a root of a sum of squares of computed numbers, and what follows it.

        (1 + u)^k - 1 <= k u / (1 - k u); squares that underflow add half a subnormal spacing each.
        """
        squares = self.structure.squares[squared]
        roundings = squares.roundings + more
        unit = up_product(float(roundings), self.kind.rounding(1.0))
        relative = up_quotient(unit, down_sum(1.0, -unit))
        least = numbers[squared].computed.mignitude
        lost = up_product(float(len(squares.leaves)), self.kind.tiny)
        if least <= 4.0 * lost:
            return INFINITY
        lost = up_quotient(lost, down_sum(least, -lost))
        return total((relative, up_product(lost, up_sum(1.0, relative))))


def _decided(real: Interval, computed: Interval) -> Number:
    """A floor is what the case says it is."""
    error = real.farthest(computed)
    return Number(real, computed, error, error)


def _no_worse(number: Number, error: float) -> Number:
    return replace(number, error=min(number.error, error), turned=min(number.turned, error))


def _compared(operation: Operation, a: Interval, b: Interval) -> bool | None:
    """Whether a comparison holds for all numbers of two intervals, for none, or for some."""
    if operation is Operation.LT:
        return True if a.hi < b.lo else False if a.lo >= b.hi else None
    if operation is Operation.LE:
        return True if a.hi <= b.lo else False if a.lo > b.hi else None
    equal = True if a.is_point and a == b else False if a.hi < b.lo or b.hi < a.lo else None
    if operation is Operation.EQ or equal is None:
        return equal
    return not equal


def _chosen(truth: Truth, chosen: Number, otherwise: Number) -> Number:
    """The branch a condition picks: where it may be decided either way, whichever is worse."""
    real = _picked(truth.real, chosen.real, otherwise.real)
    computed = _picked(truth.computed, chosen.computed, otherwise.computed)
    alike = truth.same or (truth.real is not None and truth.real == truth.computed)
    used = [
        branch
        for branch, value in ((chosen, True), (otherwise, False))
        if truth.real in (None, value) or truth.computed in (None, value)
    ]
    error = max(branch.error for branch in used)
    turned = max(branch.turned for branch in used)
    relative = max(branch.relative for branch in used)
    if not alike and error < INFINITY:
        error = turned = real.farthest(computed)
        relative = INFINITY
    return Number(real, computed, error, turned, relative)


def _picked(truth: bool | None, chosen: Interval, otherwise: Interval) -> Interval:
    if truth is None:
        return chosen.hull(otherwise)
    return chosen if truth else otherwise
