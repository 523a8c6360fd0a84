"""Quantities: expressions that carry a unit and a frame, and the operations equations use.

Every operation checks that units add up and frames chain, so that a mistake in an equation (the
library's or a user's own) is reported where it is made. Vectors are column matrices stored as
tuples of SymPy expressions over the symbols of a ``Graph``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import sympy as sp

from symnav import units
from symnav.errors import EquationError
from symnav.graph import (
    ZERO,
    Graph,
    Guard,
    Matrix,
    Row,
    identity,
)
from symnav.units import Unit

#: The smallest squared length a direction may have: 1 micrometre, for ranges in metres.
SMALLEST_SQUARE = 1e-12
LARGEST_SQUARE = 1e30
HARMLESS = 4.0
"""What is read in the place of a length or a square that fails its guard. Not one: compilers follow
one through root and reciprocal, and select every result instead of one argument."""


@dataclass(frozen=True)
class Quantity:
    """A scalar or vector expression with its unit and the frame it is resolved in.

    Attributes:
        graph: where it is named.
        elements: one expression per component.
        unit: SI unit of every component.
        frame: name of the frame, or None for scalars and stacks without a frame.
    """

    graph: Graph
    elements: Row
    unit: Unit
    frame: str | None = None

    @property
    def size(self) -> int:
        """Number of components."""
        return len(self.elements)

    def __add__(self, other: Quantity) -> Quantity:
        self._require_same(other, "added to")
        return self._with(a + b for a, b in zip(self.elements, other.elements, strict=True))

    def __sub__(self, other: Quantity) -> Quantity:
        self._require_same(other, "reduced by")
        return self._with(a - b for a, b in zip(self.elements, other.elements, strict=True))

    def __neg__(self) -> Quantity:
        return self._with(-a for a in self.elements)

    def __mul__(self, other: Quantity | float | sp.Expr) -> Quantity:
        if not isinstance(other, Quantity):
            factor = number(other) if isinstance(other, (int, float)) else other
            return self._with(factor * a for a in self.elements)
        if self.size > 1 and other.size > 1:
            raise EquationError(
                f"{self.describe()} cannot be multiplied by {other.describe()}; "
                "use dot(a, b), cross(a, b) or rotate(attitude, a)"
            )
        scalar, vector = (self, other) if self.size == 1 else (other, self)
        factor = named(scalar).elements[0] if vector.size > 1 else scalar.elements[0]
        return Quantity(
            self.graph,
            tuple(factor * a for a in vector.elements),
            self.unit * other.unit,
            vector.frame,
        )

    __rmul__ = __mul__

    def __getitem__(self, index: int) -> Quantity:
        if not 0 <= index < self.size:
            raise EquationError(f"element {index} of {self.describe()} does not exist")
        return Quantity(self.graph, (self.elements[index],), self.unit)

    def describe(self) -> str:
        """Size, unit and frame in words, for messages."""
        shape = "a scalar" if self.size == 1 else f"a {self.size}-vector"
        frame = f" in frame {self.frame!r}" if self.frame else ""
        return f"{shape} in {self.unit}{frame}"

    def _with(self, elements: Iterable[sp.Expr]) -> Quantity:
        return replace(self, elements=tuple(elements))

    def _require_same(self, other: Quantity, verb: str) -> None:
        if not isinstance(other, Quantity):
            raise EquationError(f"{self.describe()} cannot be {verb} a plain number")
        if self.size != other.size or self.unit != other.unit or self.frame != other.frame:
            raise EquationError(f"{self.describe()} cannot be {verb} {other.describe()}")


def number(value: float) -> sp.Expr:
    """A literal: integers and short binary fractions exactly, others as floats."""
    exact = Fraction(value)
    if exact.denominator <= 64 and abs(exact.numerator) < 1_000_000:
        return sp.Rational(exact.numerator, exact.denominator)
    return sp.Float(value, 17)


def constant(
    graph: Graph, values: Sequence[float], unit: Unit, frame: str | None = None
) -> Quantity:
    """A quantity folded into the code."""
    return Quantity(graph, tuple(number(v) for v in values), unit, frame)


def let(name: str, quantity: Quantity, guard: Guard | None = None) -> Quantity:
    """Name a quantity: it becomes a vertex, keeps its factoring and shows in the C."""
    return replace(quantity, elements=quantity.graph.let(name, quantity.elements, guard=guard))


def total(*terms: Quantity | None) -> Quantity:
    """Sum of the terms that are bound."""
    bound = [term for term in terms if term is not None]
    result = bound[0]
    for term in bound[1:]:
        result = result + term
    return result


def cross(a: Quantity, b: Quantity) -> Quantity:
    """Vector product a x b."""
    _require_vectors("cross", a, b)
    (ax, ay, az), (bx, by, bz) = a.elements, b.elements
    elements = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    return Quantity(a.graph, elements, a.unit * b.unit, a.frame)


def dot(a: Quantity, b: Quantity) -> Quantity:
    """Scalar product a . b."""
    if a.size != b.size or a.frame != b.frame:
        raise EquationError(f"dot: {a.describe()} and {b.describe()} do not fit")
    pairs = zip(a.elements, b.elements, strict=True)
    return Quantity(a.graph, (sp.Add(*(x * y for x, y in pairs)),), a.unit * b.unit)


def norm(name: str, vector: Quantity) -> Quantity:
    """Length of a vector, named; its derivative is the unit vector, shared by every use.

    A length below a micrometre is a domain error: its direction is not defined.
    """
    graph = vector.graph
    v = named(vector, f"{name}_vector").elements
    guard = Guard(SMALLEST_SQUARE, LARGEST_SQUARE, HARMLESS, f"squared {name}")
    (square,) = graph.define(f"{name}_squared", [sp.Add(*(e * e for e in v))], guard=guard)
    (length,) = graph.define(name, [sp.sqrt(square)])
    if graph.moves(*v):
        direction = graph.define(f"{name}_direction", [e / length for e in v])
        partials = through(graph, v, (direction,))
        graph.vertex(name, (length,), partials)
    return Quantity(graph, (length,), vector.unit)


def series(name: str, argument: Quantity, coefficients: Sequence[Fraction]) -> Quantity:
    """A polynomial in a scalar by Horner's rule, with its derivative by the same rule."""
    graph = argument.graph
    t = named(argument, f"{name}_argument").elements[0]
    (value,) = graph.define(name, [horner(coefficients, t)])
    if graph.moves(t):
        slope = [k * c for k, c in enumerate(coefficients)][1:]
        (derivative,) = graph.define(f"{name}_slope", [horner(slope, t)])
        graph.vertex(name, (value,), through(graph, (t,), ((derivative,),)))
    return Quantity(graph, (value,), units.ONE)


def horner(coefficients: Sequence[Fraction], t: sp.Expr) -> sp.Expr:
    """c0 + t (c1 + t (c2 + ...)) without expanding."""
    result: sp.Expr = ZERO
    for coefficient in reversed(coefficients):
        value = sp.Rational(coefficient.numerator, coefficient.denominator)
        result = value + t * result
    return result


def elementwise(
    name: str, function: Callable[[sp.Expr], sp.Expr], argument: Quantity, unit: Unit
) -> Quantity:
    """A function of a scalar (sine, cosine ...), named; SymPy differentiates it."""
    if argument.size != 1:
        raise EquationError(f"{name} needs a scalar, got {argument.describe()}")
    element = named(argument, f"{name}_argument").elements[0]
    elements = argument.graph.let(name, [function(element)])
    return Quantity(argument.graph, elements, unit)


def over(numerator: Quantity, scalar: Quantity) -> Quantity:
    """Numerator / scalar, for a scalar whose declared range excludes zero (checked at binding).

    The quotient keeps the divisor in sight, so that derivatives can cancel it.
    """
    if scalar.size != 1:
        raise EquationError(f"{numerator.describe()} cannot be divided by {scalar.describe()}")
    divisor = named(scalar, "divisor").elements[0]
    elements = tuple(element / divisor for element in numerator.elements)
    return replace(numerator, elements=elements, unit=numerator.unit / scalar.unit)


def divide(name: str, numerator: Quantity, denominator: Quantity) -> Quantity:
    """Numerator / denominator for any denominator; one below 1e-15 is a domain error.

    The quotient is formed as n (d / d^2), so that the guard stands on a square and the code has
    neither a branch nor a division by a bad value.
    """
    if denominator.size != 1:
        raise EquationError(f"{numerator.describe()} cannot be divided by {denominator.describe()}")
    graph = numerator.graph
    bottom = named(denominator, f"{name}_divisor").elements[0]
    if bottom.is_number and bottom == 0:
        raise EquationError(f"{numerator.describe()} is divided by zero")
    if bottom.is_number:
        inverse = 1 / bottom
    else:
        guard = Guard(1e-30, LARGEST_SQUARE, HARMLESS, f"squared divisor of {name}")
        (square,) = graph.define(f"{name}_divisor_squared", [bottom * bottom], guard=guard)
        (inverse,) = graph.define(f"{name}_reciprocal", [bottom / square])
        if graph.moves(bottom):
            slope = through(graph, (bottom,), ((-inverse * inverse,),))
            graph.vertex(f"{name}_reciprocal", (inverse,), slope)
    elements = tuple(e * inverse for e in named(numerator, f"{name}_dividend").elements)
    return Quantity(graph, elements, numerator.unit / denominator.unit, numerator.frame)


def square_root(name: str, square: Quantity) -> Quantity:
    """Square root of a scalar, named; an argument below 1e-30 is a domain error."""
    if square.size != 1:
        raise EquationError(f"the square root needs a scalar, got {square.describe()}")
    graph = square.graph
    guard = Guard(1e-30, LARGEST_SQUARE, HARMLESS, f"argument of {name}")
    (argument,) = graph.let(f"{name}_squared", square.elements, guard=guard)
    (root,) = graph.define(name, [sp.sqrt(argument)])
    if graph.moves(argument):
        slope = ((1 / (2 * root),),)
        graph.vertex(name, (root,), through(graph, (argument,), slope))
    return Quantity(graph, (root,), square.unit ** Fraction(1, 2))


def arctangent2(name: str, y: Quantity, x: Quantity) -> Quantity:
    """Angle of the point (x, y), named; both below 1e-15 are a domain error."""
    if y.size != 1 or x.size != 1 or y.unit != x.unit:
        raise EquationError(f"atan2: {y.describe()} and {x.describe()} do not fit")
    graph = y.graph
    point = graph.let(f"{name}_point", (y.elements[0], x.elements[0]), suffixes=("y", "x"))
    guard = Guard(1e-30, LARGEST_SQUARE, HARMLESS, f"squared distance of {name}")
    (square,) = graph.define(f"{name}_squared", [sp.Add(*(e * e for e in point))], guard=guard)
    (angle,) = graph.define(name, [sp.atan2(*point)])
    if graph.moves(*point):
        slope = ((point[1] / square, -point[0] / square),)
        graph.vertex(name, (angle,), through(graph, point, slope))
    return Quantity(graph, (angle,), units.ONE)


def through(graph: Graph, operand: Row, matrix: Matrix) -> dict[str, Matrix]:
    """Partials of matrix . operand toward the vertices that own the operand's elements."""
    inner = graph.local_partials(operand)
    size = len(operand)
    if len(inner) == 1:
        ((name, rows),) = inner.items()
        if rows == identity(size) and graph.vertices[name].size == size:
            return {name: matrix}
    return {
        name: tuple(
            tuple(
                inner_product(row, [rows[j][k] for j in range(size)]) for k in range(len(rows[0]))
            )
            for row in matrix
        )
        for name, rows in inner.items()
    }


def accumulate(partials: dict[str, Matrix], name: str, matrix: Matrix) -> dict[str, Matrix]:
    """Partials with a matrix added toward one vertex."""
    if name not in partials:
        return {**partials, name: matrix}
    summed = tuple(
        tuple(a + b for a, b in zip(left, right, strict=True))
        for left, right in zip(partials[name], matrix, strict=True)
    )
    return {**partials, name: summed}


def named(quantity: Quantity, name: str = "term") -> Quantity:
    """The quantity with atomic elements: named unless it already is."""
    if all(e.is_Symbol or e.is_number for e in quantity.elements):
        return quantity
    return let(name, quantity)


def inner_product(row: Sequence[sp.Expr], column: Sequence[sp.Expr]) -> sp.Expr:
    """Sum of the products of corresponding elements."""
    return sp.Add(*(a * b for a, b in zip(row, column, strict=True)))


def _require_vectors(operation: str, a: Quantity, b: Quantity) -> None:
    if a.size != 3 or b.size != 3 or a.frame != b.frame:
        raise EquationError(f"{operation}: {a.describe()} and {b.describe()} do not fit")
