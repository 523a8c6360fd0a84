"""What the graph of a function says about ranges and errors, beyond single operations.

Facts, each of them recognised from the graph and none of them told by whoever built it:

- A quadratic or bilinear form of guarded quaternions ranges as far as its eigenvalues say.
- The square root of a sum of squares is a norm: |norm(a) - norm(b)| <= norm(a - b).
- An element over the norm it is part of is at most 1 and moves by at most
  2 norm(a - b) / (norm(a) + norm(b)).
- Of two quaternions' product the four elements have squares that add up to the product of the
  squared norms, so that one of them is known from the others.
- Where terms of a polynomial cancel, its range is that of what is left.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import combinations

from symnav import ir
from symnav.export.rounding import polynomials
from symnav.export.rounding.expressions import Graph, Node, Operation
from symnav.export.rounding.formats import Format
from symnav.export.rounding.intervals import ONE, Interval, down_sum, total
from symnav.export.rounding.polynomials import Polynomial

#: The cosine of the same angle, by sine.
_COSINES = {Operation.SIN: Operation.COS, Operation.OWN_SIN: Operation.OWN_COS}
_Cosines = dict[tuple[object, tuple[int, ...]], int]
"""Where the cosine is that a sine and its operands go with."""

_MOST_TERMS = 24
_MOST_PRODUCTS = 200
_MOST_FACTORS = 6


@dataclass(frozen=True, slots=True)
class Squares:
    """A sum of squares.

    Attributes:
        leaves: what is squared.
        roundings: most roundings a square goes through on its way into the sum, its own included.
        chosen: where a choice keeps the sum away from zero, the condition and what it must be for
            the sum to be what was chosen.
    """

    leaves: tuple[int, ...]
    roundings: int
    chosen: tuple[int, bool] | None = None


@dataclass(frozen=True, slots=True)
class Direction:
    """An element of a vector over the vector's norm.

    Attributes:
        norm: the square root.
        roundings: after the square root.
    """

    norm: int
    roundings: int


@dataclass(frozen=True, slots=True)
class Complement:
    """Two nodes with ``squares + other^2 = total`` in exact arithmetic."""

    squares: int
    other: int
    total: Interval


@dataclass(frozen=True, slots=True)
class Difference:
    """A node that is, when multiplied out, a sum of squares of differences and of other squares.

    Attributes:
        squares: the node, a guarded one.
        parts: pairs of generators and a sign: the square of ``first + sign * second``.
    """

    squares: int
    parts: tuple[tuple[int, int, int], ...]


@dataclass(frozen=True, slots=True)
class Quaternion:
    """Elements of a guarded quaternion that are read, and the range of their squared norm."""

    elements: tuple[int, ...]
    squared_norm: Interval


@dataclass
class Structure:
    """The facts about one function in one type.

    Attributes:
        forms: ranges of nodes that hold for every input.
        polynomials: exact value of every node, in generators.
        cancels: nodes whose polynomial is shorter than their expression.
        squares: nodes that are sums of squares.
        norms: square roots of them: the sum, by the root.
        directions: elements over norms.
        complements: nodes known from each other.
        differences: sums of squares that are not computed as such.
        radii: for every arc tangent of two arguments, the exact square of their length.
    """

    graph: Graph
    kind: Format
    forms: dict[int, Interval] = field(default_factory=dict)
    polynomials: list[Polynomial] = field(default_factory=list)
    cancels: set[int] = field(default_factory=set)
    squares: dict[int, Squares] = field(default_factory=dict)
    norms: dict[int, int] = field(default_factory=dict)
    directions: dict[int, Direction] = field(default_factory=dict)
    complements: list[Complement] = field(default_factory=list)
    differences: list[Difference] = field(default_factory=list)
    radii: dict[int, Polynomial] = field(default_factory=dict)
    _relations: dict[int, Polynomial] = field(default_factory=dict)
    _inverses: dict[int, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        cosines: _Cosines = {
            (operation, n.operands): n.index
            for n in self.graph.nodes
            for operation, partner in _COSINES.items()
            if n.does(partner)
        }
        for node in self.graph.nodes:
            self._relate(node, cosines)
            self.polynomials.append(self._polynomial(node))
            self._find_squares(node)
            self._find_norms(node)
            self._find_differences(node)
            if node.does(Operation.ATAN2):
                self.radii[node.index] = self._radius(node)
        quaternions = quaternions_of(self.graph, self.kind)
        for node in self.graph.nodes:
            self._find_forms(node, quaternions)
        self.complements.extend(self._find_complements(quaternions))

    def _relate(self, node: Node, cosines: _Cosines) -> None:
        """What the square of a generator is worth."""
        if node.does(Operation.SQRT):
            self._relations[node.index] = self.polynomials[node.operands[0]]
            return
        cosine_at = cosines.get((node.content, node.operands))
        if cosine_at is not None:
            cosine = polynomials.generator(cosine_at)
            self._relations[node.index] = polynomials.number(1.0) - cosine * cosine

    def _polynomial(self, node: Node) -> Polynomial:
        if isinstance(node.content, ir.Check):
            return self._taken_over(node)
        if node.number is not None:
            return polynomials.number(node.number)
        exact = self._combined(node)
        small = exact is not None and len(exact) <= _MOST_TERMS and exact.degree <= _MOST_FACTORS
        return exact if exact is not None and small else polynomials.generator(node.index)

    def _taken_over(self, node: Node) -> Polynomial:
        """A guarded value is the value: what follows matters only where the guard passed."""
        (guarded,) = node.operands
        if guarded in self.cancels:
            self.cancels.add(node.index)
        return self.polynomials[guarded]

    def _combined(self, node: Node) -> Polynomial | None:
        operands = [self.polynomials[operand] for operand in node.operands]
        if node.does(Operation.NEG):
            return -operands[0]
        if node.does(Operation.ADD):
            return self._noted(node, operands[0] + operands[1], len(operands[0]) + len(operands[1]))
        if node.does(Operation.SUB):
            return self._noted(node, operands[0] - operands[1], len(operands[0]) + len(operands[1]))
        if node.does(Operation.MUL) and len(operands[0]) * len(operands[1]) <= _MOST_PRODUCTS:
            product = self._reduced(operands[0] * operands[1])
            return self._noted(node, product, len(operands[0]) * len(operands[1]))
        return None

    def _noted(self, node: Node, exact: Polynomial, expected: int) -> Polynomial:
        """Remember that terms went away, here or in what this is made from."""
        if len(exact) < expected or self.cancels.intersection(node.operands):
            self.cancels.add(node.index)
        return exact

    def _reduced(self, exact: Polynomial) -> Polynomial:
        """Squares of generators replaced by what they are worth."""
        for monomial, factor in exact.terms.items():
            for generator in dict.fromkeys(monomial):
                if generator in self._relations and monomial.count(generator) >= 2:
                    rest = list(monomial)
                    rest.remove(generator)
                    rest.remove(generator)
                    term = Polynomial({monomial: factor})
                    worth = Polynomial({tuple(rest): factor}) * self._relations[generator]
                    if len(worth) > _MOST_TERMS:
                        return exact
                    return self._reduced(exact - term + worth)
        return exact

    def _find_squares(self, node: Node) -> None:
        found = [self.squares.get(operand) for operand in node.operands]
        if node.does(Operation.MUL) and node.operands[0] == node.operands[1]:
            self.squares[node.index] = Squares((node.operands[0],), 1)
        elif node.does(Operation.ADD) and found[0] and found[1]:
            roundings = 1 + max(found[0].roundings, found[1].roundings)
            self.squares[node.index] = Squares((*found[0].leaves, *found[1].leaves), roundings)
        elif isinstance(node.content, ir.Check) and found[0]:
            self.squares[node.index] = found[0]
        elif node.does(Operation.SELECT) and (found[1] is None) != (found[2] is None):
            inner = found[1] or found[2]
            if inner is not None and inner.chosen is None:
                self.squares[node.index] = replace(
                    inner, chosen=(node.operands[0], found[1] is not None)
                )

    def _find_differences(self, node: Node) -> None:
        """Guarded polynomials like ``g g - 2 g h + h h``."""
        if not isinstance(node.content, ir.Check) or node.index in self.squares:
            return
        left = dict(self.polynomials[node.index].terms)
        parts = []
        for monomial, factor in self.polynomials[node.index].terms.items():
            if len(monomial) == 2 and monomial[0] != monomial[1] and abs(factor) == 2:
                first, second = monomial
                if left.get((first, first)) == left.get((second, second)) == 1:
                    for used in (monomial, (first, first), (second, second)):
                        del left[used]
                    parts.append((first, second, 1 if factor > 0 else -1))
        squares = all(m[:1] * 2 == m and factor > 0 for m, factor in left.items())
        if parts and squares:
            self.differences.append(Difference(node.index, tuple(parts)))

    def _radius(self, node: Node) -> Polynomial:
        y, x = (self.polynomials[operand] for operand in node.operands)
        small = len(x) * len(x) + len(y) * len(y) <= _MOST_PRODUCTS
        return self._reduced(y * y + x * x) if small else Polynomial({})

    def _find_norms(self, node: Node) -> None:
        if node.does(Operation.SQRT) and node.operands[0] in self.squares:
            self.norms[node.index] = node.operands[0]
        elif node.does(Operation.DIV):
            above, below = node.operands
            if below in self.norms and self.graph.nodes[above].number == 1.0:
                self._inverses[node.index] = below
            elif below in self.norms and self._is_part(above, below):
                self.directions[node.index] = Direction(below, 1)
        elif node.does(Operation.MUL):
            for part, inverse in (node.operands, node.operands[::-1]):
                norm = self._inverses.get(inverse)
                if norm is not None and self._is_part(part, norm):
                    self.directions[node.index] = Direction(norm, 2)

    def _is_part(self, part: int, norm: int) -> bool:
        """True for an element of the vector, or its negative."""
        node = self.graph.nodes[part]
        leaves = self.squares[self.norms[norm]].leaves
        return part in leaves or (node.does(Operation.NEG) and node.operands[0] in leaves)

    def _find_forms(self, node: Node, quaternions: list[Quaternion]) -> None:
        exact = self.polynomials[node.index]
        if exact.degree != 2:
            return
        for one in quaternions:
            found = polynomials.quadratic_range(exact, one.elements, one.squared_norm)
            if found is not None:
                self.forms[node.index] = found
        for one, other in combinations(quaternions, 2):
            norms = one.squared_norm * other.squared_norm
            found = polynomials.bilinear_range(exact, one.elements, other.elements, norms)
            if found is not None:
                self.forms[node.index] = found

    def _find_complements(self, quaternions: list[Quaternion]) -> Iterator[Complement]:
        for one, other in combinations(quaternions, 2):
            whole = _squared_length(one) * _squared_length(other)
            pair = {*one.elements, *other.elements}
            products = [
                n.index
                for n in self.graph.nodes
                if len(e := self.polynomials[n.index]) == 4
                and e.degree == 2
                and e.generators <= pair
            ]
            for index, squares in self.squares.items():
                if len(squares.leaves) == 3 and set(squares.leaves) <= set(products):
                    rest = whole
                    for leaf in squares.leaves:
                        rest = rest - self.polynomials[leaf] * self.polynomials[leaf]
                    for node in products:
                        if rest.terms == (self.polynomials[node] * self.polynomials[node]).terms:
                            yield Complement(index, node, one.squared_norm * other.squared_norm)


def _squared_length(quaternion: Quaternion) -> Polynomial:
    elements = [polynomials.generator(element) for element in quaternion.elements]
    return sum((element * element for element in elements), Polynomial({}))


def quaternions_of(graph: Graph, kind: Format) -> list[Quaternion]:
    """The guarded quaternions of a function."""
    places = {n.content: n.index for n in graph.nodes if isinstance(n.content, ir.Load)}
    found: list[Quaternion] = []
    for argument in graph.function.arguments:
        for domain in argument.domains:
            if domain.kind is ir.Kind.QUATERNION:
                loads = [ir.Load(argument.name, domain.start + k) for k in range(domain.size)]
                elements = tuple(places[load] for load in loads if load in places)
                squared = squared_norm(domain.tolerance, kind)
                if len(elements) < domain.size:
                    squared = Interval(0.0, squared.hi)
                found.append(Quaternion(elements, squared))
    return [quaternion for quaternion in found if quaternion.elements]


def squared_norm(tolerance: float, kind: Format) -> Interval:
    """Squared norm of a quaternion whose guard passed.

    The guard computes the sum of the squares less one in the type: five roundings of numbers not
    above 1 + tolerance, and one of the tolerance itself.
    """
    unit = kind.rounding(1.0)
    slack = total((tolerance, 2.0 * unit * tolerance, 8.0 * unit * (1.0 + tolerance)))
    return Interval(down_sum(1.0, -slack), (ONE + Interval(0.0, slack)).hi)
