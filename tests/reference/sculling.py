"""Weights of the sculling (and coning) terms, in exact rational arithmetic.

The term is S = 1/2 int (alpha x f - omega x nu) dt over one interval, alpha = int omega and nu =
int f, and every rule has the form S = sum K_ij a_i x v_j over the increments a_i, v_j with an
antisymmetric K.

*Polynomial* rules put the polynomial of lowest degree through the increments and integrate it.
Written as S = sum_{i<j} W_ij (a_i x v_j + v_i x a_j), the weights for five increments are

    W12 = W45 = 123425/145152    W13 = W35 = 3875/16128    W14 = W25 = 30025/48384
    W15 = 66625/145152           W23 = W34 = 275/384       W24 = 6925/18144

*Harmonic* rules ask instead that the leading terms of the error vanish for sustained coning and
sculling: S = (sum c_k a_k) x v_n + (sum c_k v_k) x a_n.
"""

from fractions import Fraction

Polynomial = list[Fraction]
Weights = list[list[Fraction]]


def product(p: Polynomial, q: Polynomial) -> Polynomial:
    """Multiply two polynomials (coefficients in ascending order)."""
    result = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return result


def slope(p: Polynomial) -> Polynomial:
    """Differentiate a polynomial."""
    return [k * a for k, a in enumerate(p)][1:]


def integral(p: Polynomial, end: int) -> Fraction:
    """Integrate a polynomial from zero to ``end``."""
    return sum((a * Fraction(end) ** (k + 1) / (k + 1) for k, a in enumerate(p)), Fraction(0))


def through(nodes: list[int], values: list[int]) -> Polynomial:
    """Give the polynomial of lowest degree through the points, by Lagrange's formula."""
    result = [Fraction(0)] * len(nodes)
    for node, ordinate in zip(nodes, values, strict=True):
        basis = [Fraction(ordinate)]
        for other in nodes:
            if other != node:
                basis = product(basis, [Fraction(-other, node - other), Fraction(1, node - other)])
        result = [a + b for a, b in zip(result, basis, strict=True)]
    return result


def cumulative(n: int, memory: int) -> list[Polynomial]:
    """Give what each unit increment adds to the integral of the rate, as polynomials in time.

    Increment i is the integral of the rate from i to i + 1; the first ``memory`` ones precede the
    interval, which is [0, n]. All polynomials vanish at zero.
    """
    nodes = list(range(-memory, n + 1))
    return [
        through(nodes, [int(node > i) - int(i < 0) for node in nodes]) for i in range(-memory, n)
    ]


def polynomial_weights(n: int, memory: int = 0) -> Weights:
    """Give K of the polynomial rule: ``n`` increments, ``memory`` earlier ones, oldest first."""
    parts = cumulative(n, memory)
    return [
        [(integral(product(a, slope(b)), n) - integral(product(slope(a), b), n)) / 2 for b in parts]
        for a in parts
    ]


def harmonic_coefficients(n: int) -> list[Fraction]:
    """Give c_1 ... c_(n-1) of the harmonic rule for ``n`` increments.

    In a rotation of the rate's direction at a steady frequency, lambda being the phase passed in
    one increment, the product of increments p apart is proportional to 2 (1 - cos lambda) sin(p
    lambda) and the term wanted to (n lambda - sin(n lambda)) / 2. Equal powers of lambda, third to
    (2n-1)st, give n - 1 linear equations.
    """
    powers = range(3, 2 * n, 2)
    rows = [[Fraction((p + 1) ** k + (p - 1) ** k - 2 * p**k) for p in range(1, n)] for k in powers]
    by_separation = solve(rows, [Fraction(n**k, 2) for k in powers])
    return by_separation[::-1]


def harmonic_weights(n: int) -> Weights:
    """Give K of the harmonic rule for ``n`` increments."""
    weights = [[Fraction(0)] * n for _ in range(n)]
    for k, c in enumerate(harmonic_coefficients(n)):
        weights[k][n - 1] = c
        weights[n - 1][k] = -c
    return weights


def solve(rows: list[list[Fraction]], right: list[Fraction]) -> list[Fraction]:
    """Solve a square linear system exactly, by Gauss-Jordan elimination."""
    table = [[*row, b] for row, b in zip(rows, right, strict=True)]
    for i in range(len(table)):
        pivot = next(k for k in range(i, len(table)) if table[k][i] != 0)
        table[i], table[pivot] = table[pivot], table[i]
        table[i] = [entry / table[i][i] for entry in table[i]]
        for k, row in enumerate(table):
            if k != i:
                table[k] = [a - row[i] * b for a, b in zip(row, table[i], strict=True)]
    return [row[-1] for row in table]
