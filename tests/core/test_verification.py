"""Number systems of the witnesses, and the fifty-digit witness itself, against references."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from mpmath import mp, mpf

from symnav.verify.closures import closure
from symnav.verify.comparison import forget_remainders
from symnav.verify.exact import Exact
from symnav.verify.numbers import Graded, Gradients, ManyDigits
from symnav.verify.sampling import draw as draw_samples
from tests.core.judging import Judge, assert_close, draw
from tests.core.specs import (
    Case,
    calibrated_gps,
    derived,
    geodetic,
    gps,
    inertial,
    ranges,
    rotation,
    vector,
)
from tests.core.test_lowering import NODES, POINTS, SYMBOLS
from tests.core.test_pseudorange import GEOMETRY

SMOOTH = [name for name in NODES if name not in ("least", "greatest")]


@pytest.mark.parametrize("name", list(NODES))
def test_many_digits(name: str) -> None:
    """Every kind of node; rationals are exact, floats are the doubles they will be."""
    expression, meaning = NODES[name]
    evaluate = closure(expression, ManyDigits())
    for point in POINTS:
        numbers = [mpf(e) for e in point]
        actual = evaluate(dict(zip(SYMBOLS, numbers, strict=True)))
        assert abs(actual - meaning(*numbers)) < 1e-16


def test_many_digits_are_kept() -> None:
    """A third has as many digits as were asked for."""
    third = closure(sp.Rational(1, 3), ManyDigits())({})
    assert abs(3 * third - 1) < 1e-24
    assert closure(sp.Float(0.1, 17), ManyDigits())({}) == mpf(0.1)


@pytest.mark.parametrize("name", SMOOTH)
def test_gradients(name: str) -> None:
    """Values and slopes of a whole batch, against differences with many digits."""
    expression, meaning = NODES[name]
    table = np.array(POINTS)
    columns = list(zip(SYMBOLS, table.T, np.eye(3), strict=True))
    env = {s: Graded(x, np.tile(e, (3, 1)), np.abs(x)) for s, x, e in columns}
    result = closure(expression, Gradients())(env)
    if not isinstance(result, Graded):
        assert result == pytest.approx(float(meaning(*POINTS[0])), rel=1e-15)
        return
    step = mpf(10) ** -10
    for i, point in enumerate(POINTS[:2]):
        centre = [mpf(e) for e in point]
        assert result.value[i] == pytest.approx(float(meaning(*centre)), rel=1e-14, abs=1e-15)
        for k in range(3):
            ends = []
            for sign in (1, -1):
                moved = list(centre)
                moved[k] += sign * step
                ends.append(meaning(*moved))
            slope = (ends[0] - ends[1]) / (2 * step)
            actual = np.broadcast_to(result.slope, (3, 3))[i, k]
            assert actual == pytest.approx(float(slope), rel=1e-12, abs=1e-12), (point, k)


def test_sizes() -> None:
    """What cancels stays in sight: sums count with what they add up, also inside functions."""
    x, y = (Graded(np.array([v]), np.zeros((1, 0)), np.array([abs(v)])) for v in (3.0, -2.0))
    a, b = SYMBOLS[:2]

    def size(expression: sp.Expr) -> float:
        result = closure(expression, Gradients())({a: x, b: y})
        return float(result.size[0])

    assert size(a + b) == 5.0
    assert size(a * b - 1) == 7.0
    assert size((a + b) * (a - b)) == 25.0
    assert size(sp.sin(a + b)) == pytest.approx(5.0 * np.cos(1.0))
    assert size(1 / (a + b)) == 5.0


def by_inputs() -> Case:
    """Jacobians toward a matrix and a vector that are given, the position in the body's frame."""
    base = ranges("exact", place="n")
    position = vector("p", frame="n", error_frame="b", bound=6e6)
    entry = {"jacobian_inputs": ("C", "l")}
    return replace(base, blocks=[position, *base.blocks[1:]], entry=entry)


def held(attitude_frame: str) -> Case:
    """A lever arm at a geodetic position."""
    return Case(
        "gnss_position",
        [rotation("q", error="left", storage="xyzw"), geodetic("p", "enu", attitude_frame)],
        [vector("l", frame="b", bound=5.0)],
        {"position": "p", "attitude": "q", "lever_arm": "l"},
        {"body": "b", "nav": "n", "state": "ecef"},
    )


CASES = {
    "gps": gps(),
    "calibrated gps": calibrated_gps(),
    "ranges": ranges("rotate_once"),
    "inputs": by_inputs(),
    "fixed axes": held("fixed"),
    "moving axes": held("moving"),
    "specific force": inertial(2, "polynomial", rotation="exact"),
}


@pytest.mark.parametrize("name", list(CASES))
def test_exact_witness(name: str) -> None:
    """Values and differences of the undifferentiated equation are those of the references."""
    case = CASES[name]
    spec = case.spec()
    given = {"s": GEOMETRY["s"]} if case.model == "pseudorange" else {}
    with mp.workdps(50):
        point = draw(spec, 3, **given)
        judge = Judge(spec, point)
        actual = Exact(spec, derived(spec)).outputs(point)
        assert_close(actual["value"], judge.outputs()["value"], "value")
        expected = [e for row in judge.jacobian() for e in row]
        assert_close(actual["jacobian"], expected, "jacobian", "1e-13")
        for name_ in case.entry.get("jacobian_inputs", ()):
            by = [e for row in judge.input_jacobian(name_) for e in row]
            assert_close(actual[f"jacobian_{name_}"], by, name_, "1e-13")


def test_samples_stay_inside() -> None:
    """Every sample lies in the declared domain, quaternions on the sphere, edges included."""
    case = calibrated_gps()
    spec = case.spec()
    state = draw_samples(spec, derived(spec), 200, 1).arguments["x"]
    for place in spec.layout.places.values():
        x = state[:, place.storage]
        if place.block.name == "q":
            assert np.allclose(np.sum(x * x, axis=1), 1.0, atol=1e-14)
            assert (x[:, 0] < 0).any() and (np.abs(x[:, 0]) < 1e-9).any()
            assert (np.abs(x[:, 1:]).max(axis=1) == 0).any()
        else:
            assert (x >= place.block.lower).all() and (x <= place.block.upper).all()
            assert (x == 0).all(axis=1).any()
    again = draw_samples(spec, derived(spec), 200, 1).arguments["x"]
    other = draw_samples(spec, derived(spec), 200, 2).arguments["x"]
    assert (state == again).all() and not (state == other).all()


def test_remainders_of_differences_are_no_error() -> None:
    """What 50-digit differences leave of a zero is no error; a rounding is one."""
    error = np.array([1e-24, 3e-16, -1e-25, 0.0])
    forget_remainders(error, np.array([0.0, 1.0, 0.0, -2.0]))
    assert error.tolist() == [0.0, 3e-16, 0.0, 0.0]
    alone = np.array([1e-24])
    forget_remainders(alone, np.array([0.0]))
    assert alone.tolist() == [1e-24]
