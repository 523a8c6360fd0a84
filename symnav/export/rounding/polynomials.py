"""Exact polynomials in the inputs of a function: where two of its values hang together.

An interval forgets that ``w`` in one factor is the ``w`` of another. A polynomial with rational
coefficients does not: terms cancel, squares stay positive, and a quadratic form of a unit
quaternion has the range of its eigenvalues.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from symnav.export.rounding.intervals import ZERO, Interval, above, below, centred, up_sqrt

Monomial = tuple[int, ...]
"""Generators in ascending order, each as often as its power says; a generator is a node."""

Matrix = list[list[Fraction]]


@dataclass(frozen=True, slots=True)
class Polynomial:
    """A sum of monomials with rational coefficients, none of them zero."""

    terms: Mapping[Monomial, Fraction]

    def __add__(self, other: Polynomial) -> Polynomial:
        return gather((*self.terms.items(), *other.terms.items()))

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def __neg__(self) -> Polynomial:
        return Polynomial({monomial: -factor for monomial, factor in self.terms.items()})

    def __mul__(self, other: Polynomial) -> Polynomial:
        return gather(
            (tuple(sorted((*a, *b))), p * q)
            for a, p in self.terms.items()
            for b, q in other.terms.items()
        )

    def __len__(self) -> int:
        return len(self.terms)

    @property
    def degree(self) -> int:
        """The largest number of factors in a term."""
        return max((len(monomial) for monomial in self.terms), default=0)

    @property
    def generators(self) -> set[int]:
        """Everything it is a polynomial in."""
        return {generator for monomial in self.terms for generator in monomial}

    def constant(self) -> Fraction | None:
        """Its value where it depends on nothing."""
        return self.terms.get((), Fraction(0)) if self.degree == 0 else None

    def range(self, value: Callable[[int], Interval]) -> Interval:
        """Enclosure term by term, from enclosures of the generators."""
        result = ZERO
        for monomial, factor in self.terms.items():
            term = fraction_interval(factor)
            for generator in dict.fromkeys(monomial):
                term = term * value(generator).power(monomial.count(generator))
            result = result + term
        return result


def gather(terms: Iterable[tuple[Monomial, Fraction]]) -> Polynomial:
    """Like terms added up."""
    result: dict[Monomial, Fraction] = {}
    for monomial, factor in terms:
        result[monomial] = result.get(monomial, Fraction(0)) + factor
    return Polynomial({monomial: factor for monomial, factor in result.items() if factor})


def number(value: float) -> Polynomial:
    """A constant: the double exactly."""
    return gather([((), Fraction(value))])


def generator(node: int) -> Polynomial:
    """A generator itself."""
    return Polynomial({(node,): Fraction(1)})


def fraction_interval(value: Fraction) -> Interval:
    """The doubles around a rational number."""
    nearest = float(value)
    exact = Fraction(nearest)
    low = nearest if exact <= value else below(nearest)
    high = nearest if exact >= value else above(nearest)
    return Interval(low, high)


def quadratic_range(
    form: Polynomial, elements: Sequence[int], squared_norm: Interval
) -> Interval | None:
    """Range of a constant plus a quadratic form of a vector of known norm; None for others."""
    if not form.generators or not form.generators <= set(elements):
        return None
    if any(len(monomial) not in (0, 2) for monomial in form.terms):
        return None
    matrix: Matrix = [[Fraction(0)] * len(elements) for _ in elements]
    for monomial, factor in form.terms.items():
        if monomial:
            i, j = (elements.index(node) for node in monomial)
            matrix[i][j] += factor / 2
            matrix[j][i] += factor / 2
    top, bottom = largest_eigenvalue(matrix), largest_eigenvalue([[-x for x in r] for r in matrix])
    if top is None or bottom is None:
        return None
    constant = fraction_interval(form.terms.get((), Fraction(0)))
    return constant + Interval(-bottom, top) * squared_norm


def bilinear_range(
    form: Polynomial,
    first: Sequence[int],
    second: Sequence[int],
    norms: Interval,
) -> Interval | None:
    """Range of a bilinear form of two vectors, by its largest singular value; None for others.

    Args:
        form: the polynomial.
        first: elements of one vector.
        second: elements of the other.
        norms: product of the squared norms.
    """
    matrix: Matrix = [[Fraction(0)] * len(second) for _ in first]
    for monomial, factor in form.terms.items():
        if len(monomial) != 2:
            return None
        a, b = monomial if monomial[0] in first else monomial[::-1]
        if a not in first or b not in second:
            return None
        matrix[first.index(a)][second.index(b)] += factor
    rows = range(len(first))
    gram = [
        [sum((x * y for x, y in zip(matrix[i], matrix[j], strict=True)), Fraction(0)) for j in rows]
        for i in rows
    ]
    squared = largest_eigenvalue(gram)
    if squared is None:
        return None
    return centred(up_sqrt((Interval(0.0, max(squared, 0.0)) * norms).hi))


def largest_eigenvalue(matrix: Matrix) -> float | None:
    """Upper bound on the eigenvalues of a symmetric matrix, proven; None where it is not.

    The bound is guessed in floating point and proven in rational numbers: bound * I - matrix is
    positive definite when no pivot of its elimination is negative or zero.
    """
    guess = float(np.linalg.eigvalsh(np.array(matrix, dtype=float))[-1])
    scale = max(abs(float(x)) for row in matrix for x in row)
    bound = guess + 1e-12 * max(scale, abs(guess)) + 1e-300
    shifted = [
        [(Fraction(bound) if i == j else Fraction(0)) - x for j, x in enumerate(row)]
        for i, row in enumerate(matrix)
    ]
    return bound if is_positive_definite(shifted) else None


def is_positive_definite(matrix: Matrix) -> bool:
    """True when every pivot of the elimination is positive."""
    rows = [list(row) for row in matrix]
    for k, row in enumerate(rows):
        if row[k] <= 0:
            return False
        for below_it in rows[k + 1 :]:
            factor = below_it[k] / row[k]
            for column in range(k, len(row)):
                below_it[column] -= factor * row[column]
    return True
