"""ekf_cal: the layouts of its code and of its documentation, and what its code has wrong."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.models.conftest import Package, specification
from tests.models.formulas import (
    ONE,
    SEEDS,
    Array,
    about_up,
    close,
    generator,
    matrix,
    quaternion,
    right_jacobian,
    skew,
)

Make = Callable[[str], Package]
UP = np.array([0.0, 0.0, 1.0])


def body(model: Package, seed: int, **more: Any) -> tuple[Array, Array, Array]:
    """A state, its position and the matrix of its attitude; every element is drawn."""
    rng = generator(seed)
    attitude, position = quaternion(rng), rng.uniform(-2e3, 2e3, 3)
    filled = {
        name: rng.uniform(-1, 1, 3)
        for name in ("velocity", "acceleration", "angular_rate", "angular_acceleration")
    }
    x = model.state.pack(position=position, attitude=attitude, **filled, **more)
    return x, position, matrix(attitude)


def test_layout_of_the_code(package: Make) -> None:
    """pos3 vel3 acc3 ang3 omega3 alpha3, then the antenna."""
    state = package("ekf_cal_gps").state
    places = {name: getattr(state.error, name) for name in state.names}
    assert places == {
        "position": slice(0, 3),
        "velocity": slice(3, 6),
        "acceleration": slice(6, 9),
        "attitude": slice(9, 12),
        "angular_rate": slice(12, 15),
        "angular_acceleration": slice(15, 18),
        "antenna": slice(18, 21),
    }
    assert (state.size, state.error.size) == (22, 21)


@pytest.mark.parametrize("seed", SEEDS)
def test_observation_matrix(package: Make, seed: int) -> None:
    """H = [I 0 0 -R[arm]x 0 0 R], and the residual of the update."""
    model = package("ekf_cal_gps")
    rng = generator(seed + 50)
    arm, fix = rng.uniform(-5, 5, 3), rng.uniform(-2e3, 2e3, 3)
    x, p, r = body(model, seed, antenna=arm)
    got = model.functions.gps(x, measured=fix)
    close(got.value, p + r @ arm, 2e3)
    close(got.residual, fix - p - r @ arm, 4e3)
    expected = np.zeros((3, 21))
    expected[:, 0:3], expected[:, 9:12], expected[:, 18:21] = ONE, -r @ skew(arm), r
    close(got.jacobian, expected, 8.0)
    np.testing.assert_array_equal(got.jacobian[expected == 0.0], 0.0)


@pytest.mark.parametrize("seed", SEEDS)
def test_known_antenna_has_no_columns(package: Make, seed: int) -> None:
    """Without extrinsic calibration the arm is data."""
    model = package("ekf_cal_gps")
    arm = generator(seed + 50).uniform(-5, 5, 3)
    x, p, r = body(model, seed)
    got = model.functions.gps_known_antenna(x, lever_arm=arm, measured=np.zeros(3))
    close(got.value, p + r @ arm, 2e3)
    expected = np.zeros((3, 21))
    expected[:, 0:3], expected[:, 9:12] = ONE, -r @ skew(arm)
    close(got.jacobian, expected, 8.0)


def test_negated_quaternion_is_the_same_attitude(package: Make) -> None:
    """Q and -Q turn alike."""
    model = package("ekf_cal_gps")
    x, _, _ = body(model, 1, antenna=[1.0, -2.0, 3.0])
    other = x.copy()
    other[model.state.attitude] *= -1
    a, b = (model.functions.gps(y, measured=np.zeros(3)) for y in (x, other))
    np.testing.assert_array_equal(a.value, b.value)
    np.testing.assert_array_equal(a.jacobian, b.jacobian)


def as_upstream() -> str:
    """The specification with the derivative that upstream's code forms."""
    text = specification("ekf_cal_gps")
    changed = text.replace('error = "right"', 'error = "rotation_vector"')
    assert changed != text
    return changed


@pytest.mark.parametrize("seed", SEEDS)
def test_upstream_differentiates_by_another_error(package: Make, seed: int) -> None:
    """Its code has -R[arm]x Jr(theta), though its update is q <- q Exp(d): defect 1.

    Both agree at the identity, where its own test looks, and differ by metres per radian elsewhere.
    """
    right, upstream = package("ekf_cal_gps"), package(as_upstream())
    arm = generator(seed + 50).uniform(-5, 5, 3)
    x, _, r = body(right, seed, antenna=arm)
    theta = Rotation.from_matrix(r).as_rotvec()
    columns = upstream.functions.gps(x, measured=np.zeros(3)).jacobian[:, 9:12]
    close(columns, -r @ skew(arm) @ right_jacobian(theta), 8.0, ulps=200)
    own = right.functions.gps(x, measured=np.zeros(3)).jacobian[:, 9:12]
    assert np.abs(columns - own).max() > 0.3

    still = right.state.pack(antenna=arm)
    a, b = (m.functions.gps(still, measured=np.zeros(3)).jacobian for m in (right, upstream))
    np.testing.assert_array_equal(a, b)


@pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-9, 1e-5, 1e-3])
def test_rotation_vector_near_the_identity(package: Make, angle: float) -> None:
    """Jr has no closed form that survives small angles; the columns do."""
    arm, axis = np.array([1.0, -2.0, 3.0]), np.array([0.36, -0.48, 0.8])
    upstream = package(as_upstream())
    q = np.roll(Rotation.from_rotvec(angle * axis).as_quat(), 1)
    x = upstream.state.pack(attitude=q, antenna=arm)
    columns = upstream.functions.gps(x, measured=np.zeros(3)).jacobian[:, 9:12]
    series = ONE - angle / 2 * skew(axis) + angle**2 / 6 * skew(axis) @ skew(axis)
    close(columns, -matrix(q) @ skew(arm) @ series, 8.0 + angle**3 / 1e-15 * 0.05)


def test_layout_of_the_documentation(package: Make) -> None:
    """x_G = [theta_GL, arm_1, arm_2] after the body."""
    state = package("ekf_cal_online").state
    assert state.error.heading == slice(18, 19)
    assert state.error.antenna_1 == slice(19, 22)
    assert state.error.antenna_2 == slice(22, 25)
    assert (state.size, state.error.size) == (26, 25)


@pytest.mark.parametrize("antenna", [1, 2])
@pytest.mark.parametrize("seed", SEEDS)
def test_online_observation_matrix(package: Make, seed: int, antenna: int) -> None:
    """Every column of z = p_L^G + C(q_L^G)(p_B^L + C(q_B^L) arm), with C(q_L^G) = Rz(-psi)."""
    model = package("ekf_cal_online")
    rng = generator(seed + 50)
    psi, arms = rng.uniform(-3, 3), rng.uniform(-5, 5, (2, 3))
    origin, fix = rng.uniform(-100, 100, (2, 3))
    x, p, r = body(model, seed, heading=psi, antenna_1=arms[0], antenna_2=arms[1])
    function = getattr(model.functions, f"gps_{antenna}")
    got = function(x, origin=origin, measured=fix)
    turn, arm = about_up(-psi), arms[antenna - 1]
    seen = turn @ (p + r @ arm)
    close(got.value, origin + seen, 4e3)
    close(got.residual, fix - origin - seen, 4e3)
    expected = np.zeros((3, 25))
    expected[:, 0:3], expected[:, 9:12] = turn, -turn @ r @ skew(arm)
    expected[:, 18] = -np.cross(UP, seen)
    expected[:, 16 + 3 * antenna : 19 + 3 * antenna] = turn @ r
    close(got.jacobian, expected, 4e3)
    close(got.jacobian[:, 9:12], expected[:, 9:12], 8.0)
    np.testing.assert_array_equal(got.jacobian[expected == 0.0], 0.0)
    np.testing.assert_array_equal(got.jacobian_origin, ONE)


def test_sign_of_the_heading(package: Make) -> None:
    """Both signs of the heading are told apart: ang_l_to_e turns east to the local frame."""
    model = package("ekf_cal_online")
    for psi in (0.4, -0.4, 2.5, -2.5):
        x = model.state.pack(heading=psi, position=[10.0, 0.0, 0.0])
        z = model.functions.gps_1(x, origin=np.zeros(3), measured=np.zeros(3)).value
        close(z, 10.0 * np.array([np.cos(psi), -np.sin(psi), 0.0]), 10.0)
        back = about_up(psi) @ z
        close(back, [10.0, 0.0, 0.0], 10.0)


def test_other_direction_of_the_heading(package: Make) -> None:
    """The textbook's active rotation is the specification with the frames exchanged."""
    text = specification("ekf_cal_online")
    textbook = package(text.replace('maps = "g -> l"', 'maps = "l -> g"'))
    own = package("ekf_cal_online")
    rng = generator(3)
    x, _, _ = body(own, 3, heading=0.7, antenna_1=rng.uniform(-5, 5, 3))
    mirrored = x.copy()
    mirrored[own.state.heading] *= -1
    arguments = {"origin": rng.uniform(-9, 9, 3), "measured": np.zeros(3)}
    a = own.functions.gps_1(x, **arguments)
    b = textbook.functions.gps_1(mirrored, **arguments)
    close(a.value, b.value, 4e3)
    close(a.jacobian[:, 18], -b.jacobian[:, 18], 4e3)


def radii(latitude: float) -> tuple[float, float]:
    """Meridian and transverse radius of curvature on WGS-84."""
    a, f = 6378137.0, 1 / 298.257223563
    e2 = f * (2 - f)
    w2 = 1 - e2 * np.sin(latitude) ** 2
    return a * (1 - e2) / w2**1.5, a / np.sqrt(w2)


@pytest.mark.parametrize("psi", [0.0, 0.4, -0.4, 2.5])
@pytest.mark.parametrize("latitude", [-1.2, 0.3, 1.5])
def test_fix_enters_with_its_noise_turned(package: Make, latitude: float, psi: float) -> None:
    """At the reference the noise of latitude, longitude, height is scaled, ordered and turned.

    M and N differ by up to 43 km, so that exchanging them would show.
    """
    model = package("ekf_cal_gps")
    reference = np.array([latitude, 2.1, 350.0])
    half = generator(5).standard_normal((3, 3)) * np.array([[1e-7], [1e-7], [1.0]])
    covariance = half @ half.T
    got = model.functions.local_fix(
        fix=reference, reference=reference, heading=psi, covariance=covariance.ravel()
    )
    np.testing.assert_array_equal(got.value, 0.0)
    m, n = radii(latitude)
    east_north_up = np.array(
        [[0, (n + 350.0) * np.cos(latitude), 0], [m + 350.0, 0, 0], [0, 0, 1.0]]
    )
    expected = about_up(psi) @ east_north_up
    close(got.jacobian_fix, expected, 6.4e6)
    carried = expected @ covariance @ expected.T
    np.testing.assert_allclose(np.reshape(got.value_covariance, (3, 3)), carried, atol=1e-14)


@pytest.mark.parametrize("psi", [0.4, -0.4])
def test_fix_is_turned_to_the_local_frame(package: Make, psi: float) -> None:
    """enu_to_local is Rz(+a): what the predicted measurement is compared with."""
    model = package("ekf_cal_gps")
    arguments = {"reference": [0.7, 0.2, 100.0], "covariance": np.zeros(9)}
    fix = [0.7 + 1e-5, 0.2 - 2e-5, 104.0]
    plain = model.functions.local_fix(fix=fix, heading=0.0, **arguments).value
    turned = model.functions.local_fix(fix=fix, heading=psi, **arguments).value
    close(turned, about_up(psi) @ plain, 200.0)
    assert plain[0] < -90 and plain[1] > 60 and 3.9 < plain[2] < 4.0
