"""Retract and local undo one another; conventions have the derivatives textbooks give."""

from collections.abc import Callable
from random import Random

import pytest
from mpmath import mp, mpf

from .algebra import (
    Matrix,
    Vector,
    add,
    conjugate,
    cross,
    dot,
    exponential,
    images,
    logarithm,
    sandwich,
    scale,
    subtract,
    turn,
)
from .blocks import SIGNS, Setting, local, retract, stored
from .drawing import far, number, numbers, quaternion, vector
from .earth import ecef, to_local
from .gnss_position import value
from .jacobian import Error, jacobian

ROTATIONS = [*SIGNS, "rotation_vector", "storage"]


def flat(rows: Matrix) -> Vector:
    """Join rows."""
    return [entry for row in rows for entry in row]


@pytest.mark.parametrize("angle", ["0", "1e-30", "1e-9", "0.1", "3", "3.14159265358979", "40"])
def test_exponential(angle: str) -> None:
    """The series is the half-angle quaternion."""
    a, axis = mpf(angle), [mpf("0.48"), mpf("-0.6"), mpf("0.64")]
    closed = [mp.cos(a / 2), *scale(mp.sin(a / 2), axis)]
    assert far(exponential(scale(a, axis)), closed) < mpf("1e-49")
    if a < mp.pi:
        assert far(logarithm(exponential(scale(a, axis))), scale(a, axis)) < mpf("1e-48")


@pytest.mark.parametrize("storage", ["wxyz", "xyzw"])
@pytest.mark.parametrize("convention", ROTATIONS)
def test_rotation_round_trip(convention: str, storage: str) -> None:
    """Local gives back the error, for quaternions of either sign."""
    rng = Random(1)
    setting = Setting(storage=storage)
    for _ in range(5):
        start = stored(exponential(numbers(rng, 3, 0.9)), storage)
        d = numbers(rng, 4 if convention == "storage" else 3, 0.9)
        moved = retract("rotation", convention, start, d, setting)
        assert far(local("rotation", convention, start, moved, setting), d) < mpf("1e-47")
        if convention != "storage":
            mirrored = scale(mpf(-1), moved)
            assert far(local("rotation", convention, start, mirrored, setting), d) < mpf("1e-47")


def right_jacobian(t: Vector, v: Vector) -> Vector:
    """Apply the right Jacobian of the exponential, in closed form."""
    a = mp.sqrt(dot(t, t))
    first, second = cross(t, v), cross(t, cross(t, v))
    return add(
        v,
        scale(-(1 - mp.cos(a)) / a**2, first),
        scale((a - mp.sin(a)) / a**3, second),
    )


@pytest.mark.parametrize("inverse", [False, True])
@pytest.mark.parametrize("convention", ROTATIONS[:-1])
def test_master_table(convention: str, inverse: bool) -> None:
    """Derivatives of R a, and of R^T a for a rotation stored the other way round, by convention."""
    rng = Random(2)
    q, a = quaternion(rng), numbers(rng)
    maps = ("n", "b") if inverse else ("b", "n")
    quantities = {
        "position": vector([mpf(0)] * 3, "n"),
        "attitude": {"wxyz": q, "maps": maps},
        "lever_arm": vector(a, "b"),
    }
    matrix = jacobian(value, quantities, {}, [Error("attitude", "rotation", convention)])
    forward = turn(quantities["attitude"], a, "b")
    back = conjugate(q)
    rules: dict[str, Callable[[Vector], Vector]] = {
        "right": lambda d: sandwich(q, cross(d, a)),
        "left": lambda d: cross(d, forward),
        "rotation_vector": lambda d: sandwich(q, cross(right_jacobian(logarithm(q), d), a)),
    }
    inverse_rules: dict[str, Callable[[Vector], Vector]] = {
        "right": lambda d: cross(forward, d),
        "left": lambda d: sandwich(back, cross(a, d)),
        "rotation_vector": lambda d: cross(forward, right_jacobian(logarithm(q), d)),
    }
    rule = (inverse_rules if inverse else rules)[convention.removesuffix("_negative")]
    sign = mpf(SIGNS.get(convention, 1))
    assert far(flat(matrix), flat(images(lambda d: scale(sign, rule(d))))) < mpf("1e-45")


def test_storage_columns_and_the_tangent() -> None:
    """The right error reaches the four components by half the quaternion product: J_3 = J_4 T."""
    rng = Random(3)
    q = quaternion(rng)
    quantities = {
        "position": vector([mpf(0)] * 3, "n"),
        "attitude": {"wxyz": q, "maps": ("b", "n")},
        "lever_arm": vector(numbers(rng), "b"),
    }
    four = jacobian(value, quantities, {}, [Error("attitude", "rotation", "storage")])
    three = jacobian(value, quantities, {}, [Error("attitude", "rotation", "right")])
    w, x, y, z = scale(mpf(1) / 2, q)
    tangent = [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]
    product = [[dot(row, [t[k] for t in tangent]) for k in range(3)] for row in four]
    assert far(flat(product), flat(three)) < mpf("1e-45")


@pytest.mark.parametrize("error_sign", ["true_minus_estimate", "estimate_minus_true"])
def test_heading(error_sign: str) -> None:
    """Headings wrap, and the shorter way between them is taken."""
    setting, sign = Setting(error_sign=error_sign), 1 if error_sign.startswith("true") else -1
    moved = retract("heading", "", [mpf(3)], [sign * mpf("0.5")], setting)
    assert abs(moved[0] - (mpf("3.5") - 2 * mp.pi)) < mpf("1e-48")
    assert abs(local("heading", "", [mpf(3)], moved, setting)[0] - sign * mpf("0.5")) < mpf("1e-48")


@pytest.mark.parametrize("axes", ["ned", "enu"])
def test_geodetic(axes: str) -> None:
    """Small errors are metres along the local axes; longitude wraps; local undoes retract."""
    rng = Random(4)
    start = [number(rng), mp.pi - mpf("1e-9"), number(rng, 1000)]
    small = scale(mpf("1e-15"), numbers(rng))
    moved = subtract(ecef(retract("geodetic", axes, start, small)), ecef(start))
    assert far(to_local(start, moved, axes), small) < mpf("1e-34")
    d = numbers(rng, 3, 500)
    d["ned".index("e") if axes == "ned" else 0] = mpf(300)
    far_away = retract("geodetic", axes, start, d)
    assert far_away[1] < 0
    assert far(local("geodetic", axes, start, far_away), d) < mpf("1e-40")


@pytest.mark.parametrize("error_sign", ["true_minus_estimate", "estimate_minus_true"])
def test_vector_with_its_error_in_another_frame(error_sign: str) -> None:
    """An error in the body moves the position along the body's axes, either way q is stored."""
    rng = Random(5)
    q, p, d = quaternion(rng), numbers(rng), numbers(rng)
    sign = 1 if error_sign.startswith("true") else -1
    for wxyz, maps in ((q, ("b", "n")), (conjugate(q), ("n", "b"))):
        setting = Setting("wxyz", error_sign, {"wxyz": wxyz, "maps": maps}, ("b", "n"))
        moved = retract("vector", "additive", p, d, setting)
        assert far(moved, add(p, scale(mpf(sign), sandwich(q, d)))) < mpf("1e-48")
        assert far(local("vector", "additive", p, moved, setting), d) < mpf("1e-48")
