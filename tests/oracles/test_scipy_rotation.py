"""SciPy's Rotation: exponential, logarithm, action, in every convention of the error."""

from typing import Any

import numpy as np
import pytest

from tests.oracles.implementations import Array, Implementation, offering
from tests.oracles.libraries import library
from tests.oracles.samples import SEEDS, generator, quaternion, rotation, vector


@pytest.fixture(scope="module")
def rotations() -> Any:
    """Give the class."""
    return library("scipy.spatial.transform").Rotation


def from_wxyz(rotations: Any, q: Array) -> Any:
    """Give SciPy's rotation, which stores the scalar last."""
    return rotations.from_quat(np.roll(q, -1))


def same_rotation(rotations: Any, q: Array, expected: Any, atol: float = 2e-15) -> None:
    """Assert that a quaternion, of either sign, is a given rotation."""
    np.testing.assert_allclose(from_wxyz(rotations, q).as_matrix(), expected.as_matrix(), atol=atol)


@offering("retract")
@pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-9, 1e-5, 1e-3, 0.3, 2.0, 3.141592, np.pi])
def test_exponential(rotations: Any, implementation: Implementation, angle: float) -> None:
    """The exponential over the whole range of angles."""
    direction = np.array([0.36, -0.48, 0.8])
    q = implementation["retract"]("rotation", "right", np.array([1.0, 0, 0, 0]), angle * direction)
    expected = np.roll(rotations.from_rotvec(angle * direction).as_quat(), 1)
    np.testing.assert_allclose(q, expected, rtol=4e-16, atol=2e-16)


@offering("retract", "local")
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(
    "convention", ["right", "left", "right_negative", "left_negative", "rotation_vector"]
)
def test_retract_and_local(
    rotations: Any, implementation: Implementation, seed: int, convention: str
) -> None:
    """Each convention is the composition its name says; local is the logarithm of the quotient."""
    rng = generator(seed)
    d = rng.uniform(-0.5, 0.5, 3)
    start = rotations.from_rotvec(rng.uniform(-1, 1, 3))
    q = np.roll(start.as_quat(), 1) * rng.choice([-1, 1])
    step = rotations.from_rotvec(-d if convention.endswith("negative") else d)
    expected = {
        "right": start * step,
        "left": step * start,
        "rotation_vector": rotations.from_rotvec(start.as_rotvec() + d),
    }[convention.removesuffix("_negative")]
    moved = implementation["retract"]("rotation", convention, q, d)
    same_rotation(rotations, moved, expected)
    back = implementation["local"]("rotation", convention, q, moved)
    np.testing.assert_allclose(back, d, rtol=0, atol=2e-15)


@offering("gnss_position")
@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("stored", [("b", "n"), ("n", "b")])
@pytest.mark.parametrize("maps", [("n", "g"), ("g", "n")])
@pytest.mark.parametrize("observer", ["observer_attitude", "heading"])
def test_position_fix(
    rotations: Any,
    implementation: Implementation,
    seed: int,
    stored: tuple[str, str],
    maps: tuple[str, str],
    observer: str,
) -> None:
    """The frames, not the direction of storage, decide which way attitude and observer turn."""
    rng = generator(seed)
    attitude, psi = quaternion(rng), rng.uniform(-3, 3)
    position, offset, arm, origin = rng.uniform(-50, 50, (4, 3))
    body = from_wxyz(rotations, attitude)
    if observer == "heading":
        outer, item = (
            rotations.from_rotvec([0, psi, 0]),
            {"angle": psi, "axis": "y", "maps": maps},
        )
    else:
        q_outer = quaternion(rng)
        outer, item = from_wxyz(rotations, q_outer), rotation(q_outer, *maps)
    body = body if stored == ("b", "n") else body.inv()
    outer = outer if maps == ("n", "g") else outer.inv()
    q = {
        "position": vector(position, "n"),
        "offset": vector(offset, "n"),
        "attitude": rotation(attitude, *stored),
        "lever_arm": vector(arm, "b"),
        observer: item,
        "origin": vector(origin, "g"),
    }
    computed = implementation["gnss_position"](q, {})["value"]
    expected = origin + outer.apply(offset + position + body.apply(arm))
    np.testing.assert_allclose(computed, expected, rtol=0, atol=2e-13)


@offering("gnss_position_to_state_frame", "gnss_position")
@pytest.mark.parametrize("seed", SEEDS)
def test_fix_in_the_state_frame(rotations: Any, implementation: Implementation, seed: int) -> None:
    """Preprocessing a fix inverts predicting it, and turns the covariance with it."""
    rng = generator(seed)
    attitude, observer = quaternion(rng), quaternion(rng)
    fix, offset, arm = rng.uniform(-50, 50, (3, 3))
    half = rng.standard_normal((3, 3))
    outer = from_wxyz(rotations, observer)
    q = {
        "receiver_position": vector(fix, "ref"),
        "observer_attitude": rotation(observer, "ref", "f"),
        "origin_offset": vector(offset, "f"),
        "attitude": rotation(attitude, "b", "f"),
        "lever_arm": vector(arm, "b"),
        "covariance": vector((half @ half.T).ravel()),
    }
    outputs = implementation["gnss_position_to_state_frame"](q, {})
    expected = outer.apply(fix) - offset - from_wxyz(rotations, attitude).apply(arm)
    np.testing.assert_allclose(outputs["value"], expected, rtol=0, atol=2e-13)
    turned = outer.as_matrix() @ half @ half.T @ outer.as_matrix().T
    np.testing.assert_allclose(outputs["covariance"].reshape(3, 3), turned, atol=1e-13)
    prediction = {
        "position": vector(outputs["value"], "f"),
        "offset": q["origin_offset"],
        **{name: q[name] for name in ("attitude", "lever_arm", "observer_attitude")},
    }
    back = implementation["gnss_position"](prediction, {})["value"]
    np.testing.assert_allclose(back, fix, rtol=0, atol=2e-13)
