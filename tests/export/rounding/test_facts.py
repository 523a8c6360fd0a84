"""Facts about norms, directions, quaternions and differences: each by brute force."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from symnav import ir
from symnav.export.arithmetic.evaluation import declared
from symnav.export.rounding import polynomials
from symnav.export.rounding.bounds import bounds, ranges
from symnav.export.rounding.expressions import trace
from symnav.export.rounding.formats import FORMATS
from symnav.export.rounding.intervals import Interval
from symnav.export.rounding.structure import Structure, squared_norm
from tests.export.rounding.kernels import (
    DOUBLE,
    FLOAT,
    Op,
    bound,
    box,
    call,
    found,
    function,
    load,
    number,
    quaternion,
    squares,
)

KIND = FORMATS[FLOAT]


def structure(one: ir.Function) -> Structure:
    return Structure(trace(one), KIND)


def test_norms_are_lipschitz() -> None:
    rng = np.random.default_rng(1)
    a = rng.normal(size=(20000, 3)) * 10.0 ** rng.uniform(-3, 3, (20000, 1))
    b = a + rng.normal(size=a.shape) * 10.0 ** rng.uniform(-6, 3, (20000, 1))
    length = np.linalg.norm
    moved = length(a - b, axis=1)
    assert np.all(np.abs(length(a, axis=1) - length(b, axis=1)) <= moved * (1 + 1e-9))
    units = a / length(a, axis=1)[:, None] - b / length(b, axis=1)[:, None]
    allowed = 2.0 * moved / (length(a, axis=1) + length(b, axis=1))
    assert np.all(length(units, axis=1) <= allowed * (1 + 1e-9))


def difference(i: int, j: int) -> ir.Expression:
    return call(Op.SUB, load(i), load(j))


def distance(low: float, high: float) -> tuple[tuple[ir.Step, ...], list[ir.Expression]]:
    """Distance of two points through a guard on its square, and the direction."""
    parts = [difference(k, k + 3) for k in range(3)]
    guard = ir.Check("s", squares(parts), low, high, 1.0, ir.Status.DOMAIN, "squared range")
    root = ir.Statement("r", call(Op.SQRT, ir.Ref("s")))
    inverse = ir.Statement("i", call(Op.DIV, 1.0, ir.Ref("r")))
    directions: list[ir.Expression] = [call(Op.MUL, part, ir.Ref("i")) for part in parts]
    return (guard, root, inverse), [ir.Ref("r"), *directions]


@pytest.mark.parametrize("low", [1e-12, 1.0, 1e12])
def test_distance_and_direction(low: float) -> None:
    """Near each other or not, a distance of points up to 1e8 m errs by a few units of 1e8."""
    steps, results = distance(low, 1e30)
    one = box([-1e8] * 6, [1e8] * 6, *results, steps=steps)
    found_bounds = bounds(one, FLOAT)["value"]
    assert found_bounds[0].bound < 2.0 * np.sqrt(3.0) * 2e8 * 2.0**-24 * 4.0
    assert found_bounds[1].bound <= 2.0 + 1e-6
    if low == 1e12:  # satellites no nearer than 1000 km
        assert found_bounds[1].bound < 4e-5
    assert found_bounds[1].largest <= 1.0 + 1e-6
    assert found(one) <= max(r.bound for r in found_bounds)


def test_a_direction_turns_as_far_as_its_vector_moves() -> None:
    """One element is rounded to eighths by a detour over 2^20: the bound is what really happens."""
    detour = call(Op.SUB, call(Op.ADD, load(1), 2.0**20), 2.0**20)
    guard = ir.Check("s", squares([load(0), detour]), 0.5, 2.0, 1.0, ir.Status.DOMAIN, "")
    steps = (guard, ir.Statement("i", call(Op.DIV, 1.0, call(Op.SQRT, ir.Ref("s")))))
    one = box([1.0, 0.0], [1.001, 0.0625], call(Op.MUL, detour, ir.Ref("i")), steps=steps)
    assert structure(one).directions
    assert 0.06 < found(one) <= bound(one) < 1.2 * found(one)


def test_distance_is_near_what_is_found() -> None:
    steps, results = distance(1e-12, 1e30)
    one = box([-1e8] * 6, [1e8] * 6, results[0], steps=steps)
    assert found(one) <= bound(one) <= 3.0 * found(one)


def test_a_direction_needs_its_own_norm() -> None:
    """An element of another vector over a norm is no direction."""
    steps, _ = distance(1.0, 1e30)
    one = box([-1e8] * 6, [1e8] * 6, call(Op.MUL, load(0), ir.Ref("i")), steps=steps)
    assert not structure(one).directions
    assert bounds(one, FLOAT)["value"][0].largest > 1e7


def test_squares_in_the_range_of_their_sum() -> None:
    """Where a choice says the sum is small, so is what is squared."""
    total = ir.Statement("s", squares([load(0), load(1)]))
    small = call(Op.LT, ir.Ref("s"), 0.01)
    one = box([-6.0] * 2, [6.0] * 2, call(Op.SELECT, small, load(0), 0.0), steps=(total,))
    worst = bounds(one, FLOAT)["value"][0]
    assert worst.largest < 0.1001
    assert worst.smooth == 0.0 and 0.09 < worst.bound < 0.1001


def rotation() -> list[ir.Expression]:
    """A matrix of a quaternion: two elements in two of its polynomial forms."""
    w, x, y, z = (load(k, "q") for k in range(4))
    yy, zz = call(Op.MUL, call(Op.MUL, 2.0, y), y), call(Op.MUL, call(Op.MUL, 2.0, z), z)
    xy, wz = call(Op.MUL, call(Op.MUL, 2.0, x), y), call(Op.MUL, call(Op.MUL, 2.0, w), z)
    return [call(Op.SUB, call(Op.SUB, 1.0, yy), zz), call(Op.SUB, xy, wz)]


def test_elements_of_a_rotation_are_at_most_one() -> None:
    one = function({"q": quaternion(1e-5)}, (), rotation())
    facts = structure(one)
    for node in facts.graph.results["value"]:
        assert -1.0001 < facts.forms[node].lo < -0.9999
        assert 0.9999 < facts.forms[node].hi < 1.0001
    rng = np.random.default_rng(3)
    q = rng.normal(size=(100000, 4))
    q *= np.sqrt(1.0 + 1e-5 * rng.uniform(-1, 1, (100000, 1))) / np.linalg.norm(
        q, axis=1, keepdims=True
    )
    w, x, y, z = q.T
    diagonal, other = 1 - 2 * y * y - 2 * z * z, 2 * x * y - 2 * w * z
    for node, values in zip(facts.graph.results["value"], (diagonal, other), strict=True):
        assert facts.forms[node].lo <= values.min() and values.max() <= facts.forms[node].hi
    assert bound(one) < 8.0 * 2.0**-24
    assert found(one) <= bound(one)


def test_forms_need_the_whole_quaternion() -> None:
    """The element of a quaternion, one of whose other elements is an input, has no such range."""
    mixed = call(Op.SUB, call(Op.MUL, load(0, "q"), load(1, "q")), call(Op.MUL, load(0), load(0)))
    one = box([-5.0], [5.0], mixed)
    one = replace(
        one,
        arguments=(*one.arguments, ir.Argument("q", 4, False, False, (quaternion(),))),
    )
    facts = structure(one)
    assert not facts.forms.keys() & set(facts.graph.results["value"])


def test_the_guarded_norm_holds_what_the_guard_lets_pass() -> None:
    """Quaternions at the tolerance, where the sum rounds in their favour."""
    tolerance = 1e-5
    allowed = squared_norm(tolerance, KIND)
    rng = np.random.default_rng(4)
    q = rng.normal(size=(200000, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    excesses = []
    for share in (-1.04, -1.02, -1.01, -1.0, -0.99, 0.99, 1.0, 1.01, 1.02, 1.04):
        f = (q * np.sqrt(1.0 + share * tolerance)).astype(np.float32)
        w, x, y, z = f.T
        computed = ((w * w + x * x) + y * y + z * z) - np.float32(1.0)
        passed = f[np.abs(computed) <= np.float32(tolerance)].astype(np.float64)
        excesses.append(np.sum(passed**2, axis=1) - 1.0)
    found_excess = np.concatenate(excesses)
    assert allowed.lo - 1.0 <= found_excess.min() and found_excess.max() <= allowed.hi - 1.0
    # The guard lets pass what is beyond the tolerance by a few roundings, either way.
    assert found_excess.min() < -1.002 * tolerance and found_excess.max() > 1.002 * tolerance
    assert allowed.hi < 1.0 + tolerance + 1e-6


def test_eigenvalues_are_bounded_from_above() -> None:
    rng = np.random.default_rng(5)
    for _ in range(200):
        matrix = rng.normal(size=(4, 4))
        matrix = matrix + matrix.T
        exact = [[Fraction(float(v)) for v in row] for row in matrix]
        bounded = polynomials.largest_eigenvalue(exact)
        assert bounded is not None
        vectors = rng.normal(size=(200, 4))
        quotients = np.einsum("ki,ij,kj->k", vectors, matrix, vectors) / np.sum(vectors**2, axis=1)
        assert quotients.max() <= bounded <= np.linalg.eigvalsh(matrix)[-1] + 1e-9


def test_definiteness_is_proven_not_guessed() -> None:
    identity = [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]
    assert polynomials.is_positive_definite(identity)
    singular = [[Fraction(1), Fraction(1)], [Fraction(1), Fraction(1)]]
    assert not polynomials.is_positive_definite(singular)
    indefinite = [[Fraction(1), Fraction(2)], [Fraction(2), Fraction(1)]]
    assert not polynomials.is_positive_definite(indefinite)


def product(i: int, j: int) -> ir.Expression:
    return call(Op.MUL, load(i, "p"), load(j, "q"))


def conjugate_product() -> list[ir.Expression]:
    """conj(p) q, the real part first."""
    add, sub = Op.ADD, Op.SUB
    return [
        call(add, call(add, product(0, 0), product(1, 1)), call(add, product(2, 2), product(3, 3))),
        call(add, call(sub, product(0, 1), product(1, 0)), call(sub, product(3, 2), product(2, 3))),
        call(add, call(sub, product(0, 2), product(2, 0)), call(sub, product(1, 3), product(3, 1))),
        call(add, call(sub, product(0, 3), product(3, 0)), call(sub, product(2, 1), product(1, 2))),
    ]


def test_the_parts_of_a_product_of_quaternions() -> None:
    w, *vector = conjugate_product()
    steps = (ir.Statement("w", w), ir.Statement("s", squares(vector)))
    near = call(Op.LT, ir.Ref("s"), 0.01)
    sign = call(Op.SELECT, call(Op.LT, ir.Ref("w"), 0.0), -1.0, 1.0)
    inverse = call(Op.DIV, 1.0, call(Op.MUL, ir.Ref("w"), sign))
    safe = call(Op.SELECT, near, inverse, 0.0)
    one = function({"p": quaternion(), "q": quaternion()}, steps, [ir.Ref("w"), safe])
    facts = structure(one)
    assert len(facts.complements) == 1
    found_bounds = bounds(one, FLOAT)["value"]
    # Without the fact w might be zero where s is small.
    assert found_bounds[1].largest < 1.01 and found_bounds[1].smooth < 1e-5
    assert found_bounds[0].largest < 1.0001
    rng = np.random.default_rng(6)
    p, q = (v / np.linalg.norm(v, axis=1)[:, None] for v in rng.normal(size=(2, 1000, 4)))
    real = np.sum(p * q, axis=1)
    x = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] + p[:, 3] * q[:, 2] - p[:, 2] * q[:, 3]
    y = p[:, 0] * q[:, 2] - p[:, 2] * q[:, 0] + p[:, 1] * q[:, 3] - p[:, 3] * q[:, 1]
    z = p[:, 0] * q[:, 3] - p[:, 3] * q[:, 0] + p[:, 2] * q[:, 1] - p[:, 1] * q[:, 2]
    np.testing.assert_allclose(real**2 + x**2 + y**2 + z**2, 1.0, rtol=1e-12)


def test_a_wrong_sign_is_no_product() -> None:
    w, x, y, _ = conjugate_product()
    z = call(
        Op.ADD,
        call(Op.ADD, product(0, 3), product(3, 0)),
        call(Op.SUB, product(2, 1), product(1, 2)),
    )
    steps = (ir.Statement("w", w), ir.Statement("s", squares([x, y, z])))
    one = function({"p": quaternion(), "q": quaternion()}, steps, [ir.Ref("w"), ir.Ref("s")])
    assert not structure(one).complements


def test_sine_and_cosine_hang_together() -> None:
    """(c - e)^2 + (1 - e^2) s^2 = (1 - e c)^2 stays away from zero."""
    e, t = load(0), load(1)
    axis = call(Op.SQRT, call(Op.SUB, 1.0, call(Op.MUL, e, e)))
    major = call(Op.SUB, call(Op.COS, t), e)
    minor = call(Op.MUL, axis, call(Op.SIN, t))
    steps = (ir.Statement("a", major), ir.Statement("b", minor))
    result = call(Op.DIV, 1.0, squares([ir.Ref("a"), ir.Ref("b")]))
    one = box([0.0, -50.0], [0.1, 50.0], result, steps=steps)
    assert bounds(one, FLOAT)["value"][0].largest < 1.3
    assert found(one) <= bound(one) < 1e-4


def test_terms_that_cancel() -> None:
    """Exact values of (a + b) - a are those of b; the error is that of a + b."""
    a, b = load(0), load(1)
    one = box([-1e6, -1.0], [1e6, 1.0], call(Op.SUB, call(Op.ADD, a, b), a))
    worst = bounds(one, FLOAT)["value"][0]
    assert worst.largest < 1.2
    assert found(one) <= worst.bound < 0.07


def excess(x: ir.Expression, d: ir.Expression) -> ir.Expression:
    return call(Op.SUB, call(Op.MUL, x, x), call(Op.MUL, call(Op.MUL, 2.0, x), d))


def test_squares_that_are_not_computed_as_such() -> None:
    """x x - 2 x d + d d is (x - d)^2: near the guard's lower end d is not far from x."""
    x, d = load(0), load(1)
    total = call(Op.ADD, ir.Ref("e"), call(Op.MUL, d, d))
    steps = (
        ir.Statement("e", excess(x, d)),
        ir.Check("s", total, 1.0, 1e30, 1.0, ir.Status.DOMAIN, "squared range"),
        ir.Statement("r", call(Op.SQRT, ir.Ref("s"))),
    )
    one = box([-3e4, -1e8], [3e4, 1e8], ir.Ref("r"), steps=steps)
    (fact,) = structure(one).differences
    assert fact.parts[0][2] == -1
    assert found(one, DOUBLE) <= bound(one, DOUBLE)
    # Without the fact: the error of the square where |d| = 1e8, over twice a root of 1.
    assert bound(one, DOUBLE) < 1e-6


def test_a_guard_without_the_cross_terms_is_no_distance() -> None:
    x, d = load(0), load(1)
    total = call(
        Op.ADD,
        call(Op.SUB, call(Op.MUL, x, x), call(Op.MUL, 3.0, call(Op.MUL, x, d))),
        call(Op.MUL, d, d),
    )
    guard = ir.Check("s", total, 1.0, 1e30, 1.0, ir.Status.DOMAIN, "")
    assert not structure(box([-1.0] * 2, [1.0] * 2, ir.Ref("s"), steps=(guard,))).differences


def test_polynomials_are_exact() -> None:
    x, y = polynomials.generator(0), polynomials.generator(1)
    square = (x + y) * (x - y)
    assert square.terms == {(0, 0): 1, (1, 1): -1}
    assert (x - x).constant() == 0
    tenth = polynomials.number(0.1)
    assert tenth.constant() == Fraction(0.1) != Fraction(1, 10)
    values = {0: Interval(-1.0, 2.0), 1: Interval(3.0, 4.0)}
    found_range = square.range(values.__getitem__)
    assert found_range.lo == -16.0 and -5.0 <= found_range.hi < -4.999999


def test_slots_reach_every_element_they_may_choose() -> None:
    slot = load(0, "k")
    chosen = ir.Load("a", ir.Offset(1, slot))
    one = box([-1.0, -2.0, -3.0, -9.0], [1.0, 5.0, 3.0, 9.0], chosen)
    whole = ir.Domain("k", 0, 1, ir.Kind.INTEGER, (0.0,), (1.0,), 0.0, "1", "", ("",), "")
    one = replace(one, arguments=(*one.arguments, ir.Argument("k", 1, False, True, (whole,))))
    graph = trace(one)
    assert ranges(one, graph, KIND)[chosen] == Interval(-3.0, 5.0)


@pytest.mark.parametrize("scalar", list(ir.Scalar))
def test_inputs_are_what_the_c_admits(scalar: ir.Scalar) -> None:
    """A declared end and the number of the type nearest to it, on whichever side that is."""
    ends = ((-0.1, 0.05), (1e-60, 0.3), (-1e300, 1e300))
    one = box([low for low, _ in ends], [high for _, high in ends], *(load(k) for k in range(3)))
    inputs = ranges(one, trace(one), FORMATS[scalar])
    for k, (low, high) in enumerate(ends):
        held = inputs[load(k)]
        admitted = [float(end) for end in declared(low, high, scalar)]
        assert held.lo <= admitted[0] and admitted[1] <= held.hi
        assert k == 2 or (held.lo <= low and high <= held.hi)
    assert inputs[load(1)].lo > 0.0


def test_numbers_are_told_apart_by_sign_of_zero() -> None:
    one = box([0.0], [1.0], number(0.0), number(-0.0))
    assert len(set(trace(one).results["value"])) == 2
