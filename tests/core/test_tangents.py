"""Every tangent rule: conventions, storage, directions, frames and signs of errors."""

from __future__ import annotations

import pytest
from mpmath import mp, mpf

from tests.core.judging import check, product_of
from tests.core.specs import Case, heading, rotation, vector

CONVENTIONS = ["right", "left", "left_negative", "right_negative", "rotation_vector", "storage"]
FRAMES = {"body": "b", "nav": "n", "state": "n"}
BINDINGS = {"position": "p", "attitude": "q", "lever_arm": "l"}


@pytest.mark.parametrize(
    ("error", "maps", "storage", "normalise"),
    product_of(CONVENTIONS, ["b -> n", "n -> b"], ["wxyz", "xyzw"], [False, True]),
)
def test_quaternions(error: str, maps: str, storage: str, normalise: bool) -> None:
    """An estimated attitude and an estimated lever arm, so that both partials of R l are seen."""
    attitude = rotation("q", maps, error, storage, normalise)
    blocks = [vector("l", frame="b", bound=5.0), attitude, vector("p", frame="n")]
    check(Case("gnss_position", blocks, [], BINDINGS, FRAMES))


@pytest.mark.parametrize("maps", ["b -> n", "n -> b"])
@pytest.mark.parametrize("error", CONVENTIONS[:4])
def test_matrices_as_inputs(error: str, maps: str) -> None:
    """A direction cosine matrix has the same errors as the quaternion of the same rotation."""
    check(
        Case(
            "gnss_position",
            [vector("p", frame="n"), vector("l", frame="b", bound=5.0)],
            [rotation("q", maps, error, "dcm")],
            BINDINGS,
            FRAMES,
            entry={"jacobian_inputs": ("q",)},
        )
    )


@pytest.mark.parametrize("error", ["right", "left", "storage"])
def test_a_given_arm(error: str) -> None:
    """Only the attitude moves."""
    blocks = [rotation("q", error=error), vector("p", frame="n")]
    check(Case("gnss_position", blocks, [vector("l", frame="b", bound=5.0)], BINDINGS, FRAMES))


@pytest.mark.parametrize("error", ["right", "left", "rotation_vector"])
@pytest.mark.parametrize("angle", ["0", "1e-9", "0.19", "3.1"])
def test_small_and_large_rotations(angle: str, error: str) -> None:
    """The series of the rotation vector on both sides of its limit, and at the identity."""
    half = mpf(angle) / 2
    q = [mp.cos(half), *(mp.sin(half) * mpf(e) for e in ("0.48", "-0.6", "0.64"))]
    blocks = [rotation("q", error=error), vector("p", frame="n")]
    case = Case("gnss_position", blocks, [vector("l", frame="b", bound=5.0)], BINDINGS, FRAMES)
    check(case, q=q)
    check(case, q=[-e for e in q])


@pytest.mark.parametrize(
    ("sign", "maps", "given"),
    product_of(["true_minus_estimate", "estimate_minus_true"], ["b -> n", "n -> b"], [True, False]),
)
def test_error_of_a_vector_in_another_frame(sign: str, maps: str, given: bool) -> None:
    """Resolved along the body through a state or an input; with either sign."""
    position = vector("p", frame="n", error_frame="b", error_sign=sign)
    arm = vector("l", frame="b", bound=5.0, error_frame="n", error_sign=sign)
    attitude = rotation("q", maps)
    blocks = [position, arm] if given else [position, attitude, arm]
    check(Case("gnss_position", blocks, [attitude] if given else [], BINDINGS, FRAMES))


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_error_resolved_through_a_heading(axis: str) -> None:
    """A heading connects frames as well as an attitude does."""
    blocks = [vector("p", frame="n", error_frame="b"), heading("psi", maps="b -> n", axis=axis)]
    bindings = {"position": "p", "attitude": "psi", "lever_arm": "l"}
    check(Case("gnss_position", blocks, [vector("l", frame="b")], bindings, FRAMES))


def test_error_frame_without_any_use_of_the_rotation() -> None:
    """The rotation is found in the layout even where the equation does not bind it."""
    blocks = [rotation("q", storage="xyzw"), vector("p", frame="n", error_frame="b")]
    check(Case("gnss_position", blocks, [], {"position": "p"}, {"state": "n"}))


@pytest.mark.parametrize("sign", ["true_minus_estimate", "estimate_minus_true"])
def test_sign_of_a_scalar(sign: str) -> None:
    """A clock whose error is estimate minus truth has a column of minus one."""
    case = Case(
        "pseudorange",
        [vector("p", frame="ecef", bound=7e6), vector("b", 1, error_sign=sign)],
        [vector("s", frame="ecef", bound=3e7)],
        {"position": "p", "clock_bias": "b", "satellite_position": "s"},
        {"ecef": "ecef"},
    )
    check(case, absolute="1e-12")


@pytest.mark.parametrize("maps", ["b -> n", "n -> b"])
def test_error_frame_beside_another_rotation_of_the_same_frames(maps: str) -> None:
    """The state's own attitude turns the error, whatever the equation is bound to."""
    blocks = [vector("p", frame="n", error_frame="b"), rotation("q")]
    inputs = [rotation("q2", maps), vector("l", frame="b", bound=5.0)]
    check(Case("gnss_position", blocks, inputs, {**BINDINGS, "attitude": "q2"}, FRAMES))


def test_error_frame_by_an_input_that_nothing_else_reads() -> None:
    blocks = [vector("p", frame="n", error_frame="b")]
    check(Case("gnss_position", blocks, [rotation("q2")], {"position": "p"}, FRAMES))
