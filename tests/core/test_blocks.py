"""Retract and local of every kind, both routes, against references and against each other."""

from __future__ import annotations

import math
from dataclasses import replace
from random import Random
from typing import Any

import pytest
from mpmath import mp, mpf

from symnav.blocks import (
    KINDS,
    Block,
    GeodeticBlock,
    HeadingBlock,
    RotationBlock,
    VectorBlock,
    frame_map,
)
from symnav.derive import derive_retract
from symnav.errors import EquationError
from symnav.spec.records import Spec
from symnav.verify.retraction import retract as witness
from tests.core.interpreter import DIGITS, DOUBLE, Arithmetic, Interpreter
from tests.core.judging import assert_close, draw, draw_block, rotation_between
from tests.core.specs import ROUTES, geodetic, heading, layout, layout_functions, rotation, vector
from tests.reference import blocks as reference
from tests.reference.algebra import Vector, images, logarithm, sandwich, scale, turn
from tests.reference.blocks import Setting
from tests.reference.drawing import numbers

CONVENTIONS = ["right", "left", "left_negative", "right_negative", "rotation_vector", "storage"]
SIGNS = ["true_minus_estimate", "estimate_minus_true"]


def rotations() -> list[Block]:
    """A rotation of every convention and storage."""
    return [
        rotation(f"q{i}{j}", error=error, storage=storage)
        for i, error in enumerate(CONVENTIONS)
        for j, storage in enumerate(("wxyz", "xyzw"))
    ]


def in_frames(maps: str) -> list[Block]:
    """Vectors whose errors are resolved elsewhere, and what turns them."""
    return [
        *(vector(f"p{k}", frame="n", error_frame="b", error_sign=s) for k, s in enumerate(SIGNS)),
        rotation("q", maps=maps),
        *(vector(f"l{k}", frame="b", error_frame="n", error_sign=s) for k, s in enumerate(SIGNS)),
    ]


LAYOUTS: dict[str, Any] = {
    "rotations": rotations,
    "vectors": lambda: [
        vector("a", 5, error_sign=SIGNS[1]),
        vector("b", 1),
        vector("c", 1, error_sign=SIGNS[1]),
        vector("d", frame="n"),
    ],
    "headings": lambda: [heading(axis, axis=axis) for axis in "xyz"],
    "geodetic": lambda: [geodetic("down"), geodetic("up", "enu")],
    "frames": lambda: in_frames("b -> n"),
    "inverse frames": lambda: in_frames("n -> b"),
}


def expected(spec: Spec, point: Any, name: str, given: Vector) -> Vector:
    """Retract or local of a whole layout by the references."""
    result: Vector = []
    for place in spec.layout.places.values():
        block, x = place.block, point["x"][place.storage]
        other = given[place.error if name == "retract" else place.storage]
        kind, convention, setting = words(spec, point, block)
        result += getattr(reference, name)(kind, convention, x, other, setting)
    return result


def words(spec: Spec, point: Any, block: Block) -> tuple[str, str, Setting]:
    """A block as the references call it."""
    if isinstance(block, RotationBlock):
        return "rotation", block.error, Setting(storage=block.storage)
    if isinstance(block, HeadingBlock):
        return "heading", "", Setting()
    if isinstance(block, GeodeticBlock):
        return "geodetic", block.error_axes, Setting()
    assert isinstance(block, VectorBlock)
    if not block.error_frame:
        return "vector", "", Setting(error_sign=block.error_sign)
    turned = rotation_between(spec, point, block.error_frame, block.frame)
    return "vector", "", Setting("wxyz", block.error_sign, turned, (block.error_frame, block.frame))


def run(function: Any, arithmetic: Arithmetic = DIGITS, **arguments: Vector) -> Vector:
    """A layout function as a plain one."""
    convert = arithmetic.number
    plain = {name: [convert(e) for e in values] for name, values in arguments.items()}
    (output,) = function.outputs
    return Interpreter(function, arithmetic).run(plain).dense("value", *output.shape)


@pytest.mark.parametrize("route", ["casadi", "sympy"])
@pytest.mark.parametrize("name", list(LAYOUTS))
@pytest.mark.parametrize("size", ["0", "1e-8", "0.7"])
def test_against_references(name: str, route: str, size: str) -> None:
    """Moderate, tiny and zero errors; and back."""
    spec = layout(*LAYOUTS[name]())
    retract, local = layout_functions(spec, route)
    point = draw(spec, 3)
    d = scale(mpf(size), numbers(Random(2), spec.layout.error_size))
    moved = run(retract, x=point["x"], d=d)
    assert_close(moved, expected(spec, point, "retract", d), "retract")
    back = run(local, x=point["x"], y=moved)
    assert_close(back, expected(spec, point, "local", moved), "local", "1e-14")
    assert_close(back, d, "round trip", "1e-14")


@pytest.mark.parametrize("name", list(LAYOUTS))
def test_witness(name: str) -> None:
    """The retract that verification differentiates through is the same map."""
    spec = layout(*LAYOUTS[name]())
    point = draw(spec, 4)
    d = numbers(Random(5), spec.layout.error_size, 0.5)
    result: Vector = []
    for place in spec.layout.places.values():
        result += witness(
            place.block,
            point["x"][place.storage],
            d[place.error],
            lambda s, t: matrix(spec, point, s, t),
        )
    assert_close(result, expected(spec, point, "retract", d), "witness", "1e-18")


def matrix(spec: Spec, point: Any, source: str, target: str) -> Vector:
    """Nine entries of the rotation between two frames."""
    item = rotation_between(spec, point, source, target)
    return [e for row in images(lambda v: turn(item, v, source)) for e in row]


@pytest.mark.parametrize("angle", ["3.1415926", "3.14159265358", "2", "0.2", "0.19", "1e-200"])
@pytest.mark.parametrize("error", CONVENTIONS[:5])
def test_near_half_turns_and_near_nothing(error: str, angle: str) -> None:
    """In doubles, round trips to rounding: next to pi, around the limit of the series, near 0."""
    spec = layout(rotation("q", error=error))
    retract, local = layout_functions(spec)
    direction = [mpf("0.48"), mpf("-0.6"), mpf("0.64")]
    start = [mpf(1), mpf(0), mpf(0), mpf(0)] if error == "rotation_vector" else draw(spec)["x"]
    d = scale(mpf(angle), direction)
    moved = run(retract, DOUBLE, x=start, d=d)
    for sign in (1.0, -1.0):
        back = run(local, DOUBLE, x=start, y=[sign * e for e in moved])
        assert all(
            math.isclose(a, b, rel_tol=3e-15, abs_tol=2e-15) for a, b in zip(back, d, strict=True)
        )
    if mpf(angle) > 1e-3:
        assert abs(math.hypot(*moved) - 1.0) < 5e-16


@pytest.mark.parametrize("value", ["0.19999", "0.20001", "0", "1", "-1"])
def test_logarithm_is_continuous(value: str) -> None:
    """Both branches of the logarithm, of either sign of the scalar part, at the identity."""
    spec = layout(rotation("q", error="rotation_vector"))
    _, local = layout_functions(spec)
    half = mpf(value) / 2
    end = [mp.cos(half), mp.sin(half), mpf(0), mpf(0)]
    identity = [mpf(1), mpf(0), mpf(0), mpf(0)]
    for q in (end, [-e for e in end]):
        assert_close(run(local, x=identity, y=q), logarithm(q), "logarithm", "1e-16")


@pytest.mark.parametrize("error", CONVENTIONS[:4])
def test_matrices(error: str) -> None:
    """A stored matrix moves as the quaternion of the same rotation does."""
    spec = layout(rotation("m", error=error, storage="dcm"))
    function = ROUTES["sympy"](spec, derive_retract(spec, frozenset()))
    q, d = draw_block(rotation("q"), Random(1), {}), numbers(Random(2), 3, 0.9)
    actual = run(function, x=entries(q), d=d)
    assert_close(actual, entries(reference.retract("rotation", error, q, d)), error)


def entries(q: Vector) -> Vector:
    """Nine entries of the matrix of a quaternion."""
    return [e for row in images(lambda v: sandwich(q, v)) for e in row]


def test_angles_wrap() -> None:
    """Headings and longitudes stay in (-pi, pi], and the shorter way is taken."""
    spec = layout(heading("psi"), geodetic("p"))
    retract, local = layout_functions(spec)
    x = [mpf("3.1"), mpf("0.7"), mpf("3.1415"), mpf(0)]
    d = [mpf("0.2"), mpf(10), mpf(1000), mpf(0)]
    moved = run(retract, x=x, d=d)
    assert moved[0] < -2.9 and moved[2] < -3
    assert_close(run(local, x=x, y=moved), d, "round trip", "1e-8")
    assert_close(moved[:1], [mpf("3.3") - 2 * mp.pi], "heading", "1e-15")


def test_a_body_frame_that_nothing_defines() -> None:
    """An error frame without a rotation is a mistake that names both frames."""
    spec = layout(vector("p", frame="n", error_frame="b"))
    with pytest.raises(EquationError, match="'b' and 'n'"):
        layout_functions(spec)


@pytest.mark.parametrize("block", [b for make in LAYOUTS.values() for b in make()], ids=str)
def test_declarations(block: Block) -> None:
    """Sizes follow labels; the start lies in the domain; conventions and units are named."""
    assert block.storage_size == len(block.lower) == len(block.initial)
    domain = zip(block.lower, block.initial, block.upper, strict=True)
    assert all(low <= value <= high for low, value, high in domain)
    assert KINDS[block.kind] is type(block)
    assert block.convention and all(block.units)
    if isinstance(block, RotationBlock):
        assert sum(block.initial) == 1.0 and block.initial[block.storage.index("w")] == 1.0
        raw = block.error == "storage"
        assert block.error_size == (4 if raw else 3)
        assert block.units[1] == ("1" if raw else "rad")


@pytest.mark.parametrize(
    ("error", "frame"),
    [("right", "b"), ("right_negative", "b"), ("left", "n"), ("left_negative", "n"),
     ("rotation_vector", ""), ("storage", "")],
)  # fmt: skip
def test_frame_of_a_rotation_error(error: str, frame: str) -> None:
    """Right errors are resolved where the rotation comes from, left ones where it goes."""
    assert rotation("q", "b -> n", error).frames == ("b -> n", frame)


@pytest.mark.parametrize("text", ["b", "b -> ", "-> n", "b -> b", ""])
def test_frame_maps(text: str) -> None:
    """A map has two different ends."""
    assert frame_map(" b->n ") == ("b", "n")
    with pytest.raises(EquationError, match="'b -> n'"):
        frame_map(text)


def test_digest_and_places() -> None:
    """What an element means decides the digest; what it is called in prose does not."""
    first = layout(vector("a", 2), rotation("q"), vector("b", 1)).layout
    assert [(p.storage, p.error) for p in first.places.values()] == [
        (slice(0, 2), slice(0, 2)), (slice(2, 6), slice(2, 5)), (slice(6, 7), slice(5, 6)),
    ]  # fmt: skip
    assert (first.size, first.error_size) == (7, 6)
    described = replace(vector("a", 2), description="An a.")
    assert layout(described, rotation("q"), vector("b", 1)).layout.digest == first.digest
    other = layout(vector("a", 2), rotation("q", error="left"), vector("b", 1)).layout
    assert other.digest != first.digest
