"""The weights of the sculling rules: published values and the properties that define them."""

from fractions import Fraction
from itertools import pairwise

import pytest
from mpmath import mp, mpf

from .algebra import exact
from .sculling import harmonic_coefficients, harmonic_weights, polynomial_weights

HARMONIC = {
    2: ["2/3"],
    3: ["9/20", "27/20"],
    4: ["54/105", "92/105", "214/105"],
    5: ["250/504", "525/504", "650/504", "1375/504"],
}
POLYNOMIAL = {
    2: {(1, 2): "2/3"},
    3: {(1, 2): "57/80", (2, 3): "57/80", (1, 3): "33/80"},
    4: {
        (1, 2): "736/945",
        (3, 4): "736/945",
        (1, 3): "334/945",
        (2, 4): "334/945",
        (1, 4): "526/945",
        (2, 3): "218/315",
    },
    5: {
        (1, 2): "123425/145152",
        (4, 5): "123425/145152",
        (1, 3): "3875/16128",
        (3, 5): "3875/16128",
        (1, 4): "30025/48384",
        (2, 5): "30025/48384",
        (1, 5): "66625/145152",
        (2, 3): "275/384",
        (3, 4): "275/384",
        (2, 4): "6925/18144",
    },
}


@pytest.mark.parametrize("n", HARMONIC)
def test_classical_table(n: int) -> None:
    """The derived harmonic coefficients are the classical ones."""
    assert harmonic_coefficients(n) == [Fraction(c) for c in HARMONIC[n]]


@pytest.mark.parametrize("n", POLYNOMIAL)
def test_polynomial_table(n: int) -> None:
    """The weights of two to five increments."""
    weights = polynomial_weights(n)
    for i in range(n):
        for j in range(i + 1, n):
            assert weights[i][j] == Fraction(POLYNOMIAL[n][i + 1, j + 1])


def test_previous_increment() -> None:
    """One increment and the one before it."""
    assert polynomial_weights(1, memory=1) == [[0, Fraction(1, 12)], [Fraction(-1, 12), 0]]


@pytest.mark.parametrize("n", range(1, 8))
@pytest.mark.parametrize("memory", [0, 1])
def test_antisymmetric(n: int, memory: int) -> None:
    """Exchanging angles and velocities reverses the sign."""
    weights = polynomial_weights(n, memory)
    assert all(weights[i][j] == -weights[j][i] for i in range(n) for j in range(n))


@pytest.mark.parametrize("n", range(1, 8))
def test_time_reversal(n: int) -> None:
    """Read backwards, the interval has the opposite sculling."""
    weights = polynomial_weights(n)
    assert all(weights[i][j] == weights[n - 1 - j][n - 1 - i] for i in range(n) for j in range(n))


@pytest.mark.parametrize("n", range(2, 7))
@pytest.mark.parametrize(("p", "q"), [(0, 1), (1, 0), (1, 2), (3, 1), (4, 3), (2, 5)])
def test_exact_for_powers(n: int, p: int, q: int) -> None:
    """Rates t^p and t^q below the degree of the fit are integrated exactly, the others are not."""
    increments = [
        [Fraction((i + 1) ** (k + 1) - i ** (k + 1), k + 1) for i in range(n)] for k in (p, q)
    ]
    weights = polynomial_weights(n)
    total = sum(
        weights[i][j] * increments[0][i] * increments[1][j] for i in range(n) for j in range(n)
    )
    integral = Fraction(n ** (p + q + 2), 2 * (p + q + 2)) * (
        Fraction(1, p + 1) - Fraction(1, q + 1)
    )
    assert (total == integral) == (max(p, q) < n)


@pytest.mark.parametrize("n", range(2, 7))
def test_harmonic_order(n: int) -> None:
    """In steady coning the error falls with the (2n+1)st power of the phase per increment."""

    def error(phase: mpf) -> mpf:
        ends = [(mp.sin(k * phase), -mp.cos(k * phase)) for k in range(n + 1)]
        steps = [(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(ends)]
        weights = harmonic_weights(n)
        total = mp.fsum(
            exact(weights[i][j]) * (steps[i][0] * steps[j][1] - steps[i][1] * steps[j][0])
            for i in range(n)
            for j in range(i + 1, n)
        )
        return total - (n * phase - mp.sin(n * phase)) / 2

    with mp.workdps(120):
        small, smaller = error(mpf("1e-4")), error(mpf("1e-4") / 2)
    assert abs(mp.log(abs(small / smaller), 2) - (2 * n + 1)) < mpf("1e-4")
