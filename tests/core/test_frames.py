"""Series, rotations and geodesy against multiple precision and textbook forms."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy as sp
from mpmath import mp, mpf

from symnav.errors import EquationError
from symnav.frames import earth, geodesy, rotations, series
from symnav.graph import Graph, Guard
from symnav.quantities import horner
from tests.core.judging import assert_close
from tests.oracles.libraries import library
from tests.reference import algebra
from tests.reference import earth as reference
from tests.reference.algebra import Vector, cross, images, sandwich
from tests.reference.drawing import numbers, quaternion


class Calculator:
    """A graph over plain arguments, and the numbers of what was defined."""

    def __init__(self, values: Sequence[Any]) -> None:
        self.graph = Graph()
        self.symbols = self.graph.argument([f"a{k}" for k in range(len(values))])
        self._known = dict(zip(self.symbols, values, strict=True))

    def evaluate(self, expressions: Sequence[sp.Expr]) -> Vector:
        """Numbers of expressions over the definitions made so far."""
        for definition in self.graph.definitions:
            if definition.symbol not in self._known:
                self._known[definition.symbol] = self._number(definition.expression)
        return [self._number(e) for e in expressions]

    def _number(self, expression: sp.Expr) -> Any:
        symbols = sorted(expression.free_symbols, key=str)
        return sp.lambdify(symbols, expression, "mpmath")(*(self._known[s] for s in symbols))


CLOSED: dict[Any, Callable[[Any], Any]] = {
    series.one_minus_cosine: lambda a: (1 - mp.cos(a)) / a**2,
    series.angle_minus_sine: lambda a: (a - mp.sin(a)) / a**3,
    series.mid_interval: lambda a: (1 - mp.sin(a / 2) / (a / 2)) / a**2,
    series.half_sinc: lambda a: mp.sin(a / 2) / a,
    series.half_cosine: lambda a: mp.cos(a / 2),
}


@pytest.mark.parametrize("term", list(CLOSED), ids=lambda term: str(term.__name__))
@pytest.mark.parametrize("bound", ["1e-4", "0.1", "0.5", "1", "3.14159"])
def test_series(term: Any, bound: str) -> None:
    """Truncated below a double's rounding at the largest angle, and no sooner than needed."""
    angle = mpf(bound)
    coefficients = series.coefficients(term, float(angle) ** 2)
    for part in (1, mpf("0.7"), mpf("0.01")):
        a = part * angle
        exact = [algebra.exact(c) for c in coefficients]
        value = mp.polyval(exact[::-1], a * a)
        with mp.workdps(60):
            assert abs(value - CLOSED[term](a)) < 2e-17 * abs(exact[0])
    assert len(coefficients) <= 16


def test_arctangent_series() -> None:
    """Up to the limit where the logarithm turns to atan2."""
    bound = float(rotations.SERIES_LIMIT) * 1.05
    u2 = mpf(bound)
    exact = [algebra.exact(c) for c in series.coefficients(series.arctangent, bound)]
    value = mp.polyval(exact[::-1], u2)
    assert abs(value / (mp.atan(mp.sqrt(u2)) / mp.sqrt(u2)) - 1) < 2e-17


def test_series_beyond_pi_are_refused() -> None:
    """There the terms cancel more than the last digits."""
    series.coefficients(series.one_minus_cosine, 3.1415**2)
    with pytest.raises(EquationError, match=r"4 rad .* below pi"):
        series.coefficients(series.one_minus_cosine, 16.0)


def test_horner() -> None:
    """Nested, not expanded."""
    t = sp.Symbol("t")
    nested = horner([Fraction(1), Fraction(2), Fraction(-3)], t)
    assert sp.expand(nested - (1 + 2 * t - 3 * t * t)) == 0


ANGLES = ["0", "1e-200", "1e-9", "0.0999999", "0.1000001", "2", "3.14159265", "6"]


@pytest.mark.parametrize("angle", ANGLES)
def test_exponential_and_logarithm(angle: str) -> None:
    """Both against the power series of the exponential; a quaternion of either sign."""
    d = [mpf(angle) * mpf(e) for e in ("0.48", "-0.6", "0.64")]
    calculator = Calculator(d)
    q = rotations.exponential(calculator.graph, "e", calculator.symbols)
    expected = algebra.exponential(d)
    assert_close(calculator.evaluate(q), expected, "exponential", "1e-17")
    for sign in (1, -1):
        inverse = Calculator([sign * e for e in expected])
        theta = rotations.logarithm(inverse.graph, "l", inverse.symbols)
        assert_close(inverse.evaluate(theta), algebra.logarithm(expected), "logarithm", "1e-15")


@pytest.mark.parametrize("seed", range(4))
def test_rotations_of_scipy(seed: int) -> None:
    """Matrix, product, exponential and logarithm of another library."""
    scipy = library("scipy.spatial.transform").Rotation
    rng = np.random.default_rng(seed)
    first, second = scipy.random(2, random_state=rng)
    q = [*np.roll(first.as_quat(), 1), *np.roll(second.as_quat(), 1)]
    calculator = Calculator([mpf(e) for e in q])
    a, b = calculator.symbols[:4], calculator.symbols[4:]
    matrix = rotations.unit_quaternion_matrix(calculator.graph, "R", a)
    np.testing.assert_allclose(
        np.array(calculator.evaluate(matrix), float), first.as_matrix().ravel(), atol=1e-15
    )
    both = np.array(calculator.evaluate(rotations.quaternion_product(a, b)), float)
    np.testing.assert_allclose(
        scipy.from_quat(np.roll(both, -1)).as_matrix(), (first * second).as_matrix(), atol=1e-15
    )
    vector = calculator.evaluate(rotations.logarithm(calculator.graph, "l", a))
    np.testing.assert_allclose(np.array(vector, float), first.as_rotvec(), atol=1e-14)


def test_matrices_of_a_quaternion() -> None:
    """The three forms against the sandwich product, of a quaternion off the unit sphere too."""
    q = algebra.scale(mpf("1.3"), quaternion(Random(1)))
    calculator = Calculator(q)
    w2 = sum(e * e for e in q)
    homogeneous = rotations.homogeneous_matrix(calculator.graph, "H", calculator.symbols)
    guard = Guard(1e-6, 1e6, 1.0, "norm")
    normalised, square = rotations.normalised_matrix(
        calculator.graph, "N", calculator.symbols, guard
    )
    unit = rotations.unit_quaternion_matrix(calculator.graph, "U", calculator.symbols)
    for entries, form in ((homogeneous, "homogeneous"), (normalised, "normalised"), (unit, "unit")):
        rows = images(lambda v, form=form: sandwich(q, v, form))  # type: ignore[misc]
        assert_close(calculator.evaluate(entries), [e for row in rows for e in row], form)
    assert_close(calculator.evaluate([square]), [w2], "squared norm")
    conjugate = calculator.evaluate(rotations.conjugate(calculator.symbols))
    assert_close(conjugate, algebra.conjugate(q), "conjugate")


@pytest.mark.parametrize("angle", ["0", "1e-8", "0.3", "3.1"])
def test_right_jacobian(angle: str) -> None:
    """Exp(theta + d) = Exp(theta) Exp(Jr d), by differences of the exponential."""
    theta = [mpf(angle) * mpf(e) for e in ("0.48", "-0.6", "0.64")]
    calculator = Calculator(theta)
    rows = rotations.right_jacobian(calculator.graph, "J", calculator.symbols)
    flat = calculator.evaluate([e for row in rows for e in row])

    def step(d: Vector) -> Vector:
        back = algebra.conjugate(algebra.exponential(theta))
        moved = algebra.exponential(algebra.add(theta, d))
        return algebra.logarithm(algebra.multiply(back, moved))

    expected = algebra.derivative(step, [mpf(0)] * 3)
    assert_close(flat, [e for row in expected for e in row], "Jr", "1e-16")


@pytest.mark.parametrize("angle", ["0", "3.14159", "-3.14159", "3.2", "-3.2", "9.5", "-9.5"])
def test_wrap(angle: str) -> None:
    """Into (-pi, pi], from any number of turns."""
    calculator = Calculator([mpf(angle)])
    (actual,) = calculator.evaluate([rotations.wrap(calculator.symbols[0])])
    assert abs(actual - reference.wrap(mpf(angle))) < 1e-15


def test_constants() -> None:
    """As published."""
    assert reference.SEMI_MAJOR_AXIS == earth.SEMI_MAJOR_AXIS
    assert reference.FLATTENING == earth.FLATTENING
    squared = reference.FLATTENING * (2 - reference.FLATTENING)
    assert float(squared) == earth.ECCENTRICITY_SQUARED
    assert float(reference.ROTATION_RATE) == earth.ROTATION_RATE
    assert float(reference.LIGHT_SPEED) == earth.SPEED_OF_LIGHT


PLACES = [("0.7", "-1.9", "431"), ("-1.5", "3.1", "-80"), ("0", "0", "0"), ("1.2", "0.4", "9000")]


def place(llh: Sequence[str]) -> tuple[Calculator, geodesy.GeodeticTerms, Vector]:
    """The terms of a geodetic position."""
    numbers_ = [mpf(e) for e in llh]
    calculator = Calculator(numbers_)
    terms = geodesy.geodetic_terms(calculator.graph, "p", calculator.symbols)
    return calculator, terms, numbers_


@pytest.mark.parametrize("llh", PLACES)
def test_geodetic_terms(llh: Sequence[str]) -> None:
    """Position and radii, to nanometres and better, by the reduced latitude and by speeds."""
    calculator, terms, x = place(llh)
    assert_close(calculator.evaluate(terms.ecef), reference.ecef(x), "ecef", "2e-9")
    radii = calculator.evaluate(
        [terms.meridian_radius, terms.normal_radius * terms.cosine_latitude]
    )
    expected = [reference.northward_speed(x), reference.eastward_speed(x)]
    assert_close(radii, expected, "radii", "2e-9")


@pytest.mark.parametrize("axes", ["ned", "enu"])
@pytest.mark.parametrize("llh", PLACES)
def test_level_axes(llh: Sequence[str], axes: str) -> None:
    """The matrix of the axes, and metres per angle there and back."""
    calculator, terms, x = place(llh)
    level = geodesy.level_to_ecef(calculator.graph, "C", terms, axes)
    rows = algebra.transpose(images(lambda v: reference.to_local(x, v, axes)))
    assert_close(calculator.evaluate(level), [e for row in rows for e in row], "axes")
    metres = geodesy.metres_per_angle(terms, axes)
    angles = geodesy.angles_per_metre(terms, axes)
    both = sp.Matrix(metres) * sp.Matrix(angles)
    assert_close(
        calculator.evaluate(list(both)),
        [mpf(int(i == j)) for i in range(3) for j in range(3)],
        "inverse",
    )
    moved = algebra.derivative(lambda y: reference.to_local(x, reference.ecef(y), axes), x)
    flat = calculator.evaluate([e for row in metres for e in row])
    assert_close(flat, [e for row in moved for e in row], "metres per angle", "2e-9")


@pytest.mark.parametrize("axes", ["ned", "enu"])
@pytest.mark.parametrize("llh", PLACES)
def test_transport_rotation(llh: Sequence[str], axes: str) -> None:
    """C(moved) = C (I + [w]x): the axes of the moved place, resolved along those of the first."""
    calculator, terms, x = place(llh)
    turn = geodesy.transport_rotation(terms, axes)
    flat = calculator.evaluate([e for row in turn for e in row])
    angles = calculator.evaluate([e for row in geodesy.angles_per_metre(terms, axes) for e in row])
    arm = numbers(Random(3))
    for k in range(3):
        step = [angles[3 * i + k] for i in range(3)]

        def carried(s: Vector, step: Vector = step) -> Vector:
            there = algebra.add(x, algebra.scale(s[0], step))
            rows = algebra.transpose(images(lambda v: reference.to_local(there, v, axes)))
            return reference.to_local(x, algebra.apply(rows, arm), axes)

        slope = [row[0] for row in algebra.derivative(carried, [mpf(0)])]
        omega = [flat[3 * i + k] for i in range(3)]
        assert_close(slope, cross(omega, arm), f"column {k}", "1e-20")
