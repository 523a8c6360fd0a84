"""Small-angle coefficients as polynomials in t = |theta|^2.

The closed forms, such as (1 - cos a)/a^2, cancel where navigation works. Their Taylor series in t
converge everywhere; the number of terms follows from the largest angle and the precision.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import factorial, pi

from symnav.errors import EquationError

#: Truncation kept below this fraction of the value: a quarter of a double's unit roundoff.
TRUNCATION = 2.0**-55
#: Beyond this angle the alternating terms cancel more than the last digits; intervals are shorter.
LARGEST_ANGLE = pi

Term = Callable[[int], Fraction]


def one_minus_cosine(k: int) -> Fraction:
    """Term k of (1 - cos a)/a^2."""
    return Fraction((-1) ** k, factorial(2 * k + 2))


def angle_minus_sine(k: int) -> Fraction:
    """Term k of (a - sin a)/a^3."""
    return Fraction((-1) ** k, factorial(2 * k + 3))


def mid_interval(k: int) -> Fraction:
    """Term k of (1 - sinc(a/2))/a^2 with sinc x = sin x / x."""
    return Fraction((-1) ** k, factorial(2 * k + 3) * 4 ** (k + 1))


def half_sinc(k: int) -> Fraction:
    """Term k of sin(a/2)/a."""
    return Fraction((-1) ** k, factorial(2 * k + 1) * 2 ** (2 * k + 1))


def half_cosine(k: int) -> Fraction:
    """Term k of cos(a/2)."""
    return Fraction((-1) ** k, factorial(2 * k) * 4**k)


def arctangent(k: int) -> Fraction:
    """Term k of atan(u)/u in powers of u^2."""
    return Fraction((-1) ** k, 2 * k + 1)


def coefficients(term: Term, bound: float) -> tuple[Fraction, ...]:
    """Enough terms for t up to ``bound`` squared radians that double precision sees no truncation.

    The remainder of an alternating series is below its first omitted term.

    Raises:
        EquationError: when the angle can exceed pi.
    """
    if bound > LARGEST_ANGLE**2 * 1.01:
        raise EquationError(
            f"the declared range allows a rotation of {bound**0.5:.3g} rad in one interval; "
            "declare a range whose norm stays below pi"
        )
    chosen: list[Fraction] = []
    for k in range(60):
        value = term(k)
        if chosen and abs(float(value)) * bound**k < TRUNCATION * abs(float(chosen[0])) / 8:
            return tuple(chosen)
        chosen.append(value)
    raise AssertionError("the series converges within sixty terms for angles below pi")
