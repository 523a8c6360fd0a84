"""NavToolkit: calc_force_ned and its Jacobians, and the columns of the Pinson states."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.models.conftest import Package, specification
from tests.models.formulas import (
    ONE,
    SEEDS,
    Array,
    close,
    generator,
    matrix,
    quaternion,
    skew,
)

Make = Callable[[str], Package]


def interval(seed: int) -> tuple[Array, Array, Array, float]:
    """Attitude, increments and length of an interval on a lively platform."""
    rng = generator(seed)
    return (
        quaternion(rng),
        rng.uniform(-0.2, 0.2, 3),
        rng.uniform(-2, 2, 3),
        float(rng.uniform(0.002, 0.05)),
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_calc_force(package: Make, seed: int) -> None:
    """F = C (dv + dth x dv / 2) / dt, and its derivative by each of the four arguments."""
    q, dth, dv, dt = interval(seed)
    c = matrix(q)
    got = package("navtk_specific_force").functions.calc_force(
        dcm=c.ravel(), delta_theta=dth, delta_velocity=dv, dt=dt
    )
    f = c @ (dv + np.cross(dth, dv) / 2) / dt
    size = float(np.abs(f).max())
    close(got.value, f, size)
    close(got.jacobian_delta_velocity, c @ (ONE + skew(dth) / 2) / dt, 1 / dt)
    close(got.jacobian_delta_theta, -c @ skew(dv) / (2 * dt), size)
    close(np.ravel(got.jacobian_dt), -f / dt, size / dt)
    close(got.jacobian_dcm, skew(f), size)


@pytest.mark.parametrize("seed", SEEDS)
def test_columns_of_the_pinson_states(package: Make, seed: int) -> None:
    """+[f]x for the tilt, and both biases through the corrected increments."""
    model = package("navtk_specific_force")
    q, dth, dv, dt = interval(seed)
    rng = generator(seed + 50)
    b_a, b_g = rng.uniform(-1, 1, 3), rng.uniform(-0.1, 0.1, 3)
    x = model.state.pack(
        position=rng.uniform(-1e3, 1e3, 3), velocity=rng.uniform(-9, 9, 3), attitude=q,
        accelerometer_bias=b_a, gyro_bias=b_g,
    )  # fmt: skip
    got = model.functions.force(x, delta_theta=dth, delta_velocity=dv, dt=dt)
    c, angle, velocity = matrix(q), dth - b_g * dt, dv - b_a * dt
    f = c @ (velocity + np.cross(angle, velocity) / 2) / dt
    size = float(np.abs(f).max())
    close(got.value, f, size)
    expected = np.zeros((3, 15))
    expected[:, 6:9] = skew(f)
    expected[:, 9:12] = -c @ (ONE + skew(angle) / 2)
    expected[:, 12:15] = c @ skew(velocity) / 2
    close(got.jacobian, expected, size)
    close(got.jacobian[:, 9:], expected[:, 9:], 2.0)
    np.testing.assert_array_equal(got.jacobian[expected == 0.0], 0.0)
    # dt also scales what the biases take away.
    by_dt = -f / dt - c @ (b_a + np.cross(b_g, velocity) / 2 + np.cross(angle, b_a) / 2) / dt
    close(np.ravel(got.jacobian_dt), by_dt, size / dt)


def test_layout_is_pinson_15(package: Make) -> None:
    """dp dv tilt b_a b_g, and a tilt with C_true = Exp(-tilt) C."""
    state = package("navtk_specific_force").state
    assert [getattr(state.error, name).start for name in state.names] == [0, 3, 6, 9, 12]
    assert state.error.size == 15
    q, tilt = quaternion(generator(9)), np.array([0.0, 0.0, 0.3])
    x = state.pack(attitude=q)
    moved = state.retract(x, np.concatenate([np.zeros(6), tilt, np.zeros(6)]))
    c, s = np.cos(0.3), np.sin(0.3)
    expected = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) @ matrix(q)
    close(matrix(moved[state.attitude]), expected)


def test_at_rest(package: Make) -> None:
    """Without rotation the force is C dv / dt, and the derivative by the angle is still there."""
    functions = package("navtk_specific_force").functions
    dv = np.array([0.1, -0.2, 0.3])
    got = functions.calc_force(dcm=ONE.ravel(), delta_theta=np.zeros(3), delta_velocity=dv, dt=0.01)
    close(got.value, dv / 0.01, 30.0)
    close(got.jacobian_delta_theta, -skew(dv) / 0.02, 30.0)


@pytest.mark.parametrize("dt", [0.0, -0.01, np.nan, np.inf])
def test_length_of_the_interval_is_guarded(package: Make, dt: float) -> None:
    """NavToolkit divides by whatever it is given; here the range is declared."""
    model = package("navtk_specific_force")
    with pytest.raises(model.guard_error, match="dt"):
        model.functions.calc_force(
            dcm=ONE.ravel(), delta_theta=np.zeros(3), delta_velocity=np.ones(3), dt=dt
        )


def test_matrix_is_guarded(package: Make) -> None:
    """A matrix that stretches is no attitude."""
    model = package("navtk_specific_force")
    with pytest.raises(model.guard_error, match="dcm"):
        model.functions.calc_force(
            dcm=(0.98 * ONE).ravel(), delta_theta=np.zeros(3), delta_velocity=np.ones(3), dt=0.01
        )


def with_options(**options: str) -> str:
    """The specification with other options of its first correction."""
    text = specification("navtk_specific_force")
    lines = "".join(f'{key} = "{value}"\n' for key, value in options.items())
    marker = 'attitude = "dcm"\nsculling = "none"\n'
    assert marker in text
    return text.replace(marker, 'attitude = "dcm"\n' + lines)


@pytest.mark.parametrize(("epoch", "sign"), [("start", 0.5), ("mid", 0.0), ("end", -0.5)])
def test_epoch_of_the_attitude(package: Make, epoch: str, sign: float) -> None:
    """The sign of the correction follows the end of the interval that C belongs to."""
    q, dth, dv, dt = interval(2)
    functions = package(with_options(sculling="none", epoch=epoch)).functions
    got = functions.calc_force(dcm=matrix(q).ravel(), delta_theta=dth, delta_velocity=dv, dt=dt)
    f = matrix(q) @ (dv + sign * np.cross(dth, dv)) / dt
    close(got.value, f, float(np.abs(f).max()))


@pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.05, 0.3, 0.62])
def test_exact_rotation(package: Make, angle: float) -> None:
    """Savage's closed form, whose coefficients lose their digits near zero; the code keeps them."""
    mp: Any = pytest.importorskip("mpmath").mp
    axis, dv = np.array([0.36, -0.48, 0.8]), np.array([1.0, 2.0, -3.0])
    dth = angle * axis
    functions = package(with_options(sculling="none", rotation="exact")).functions
    got = functions.calc_force(dcm=ONE.ravel(), delta_theta=dth, delta_velocity=dv, dt=0.05)
    with mp.workdps(60):
        t = mp.sqrt(sum(mp.mpf(float(v)) ** 2 for v in dth))
        c2 = (1 - mp.cos(t)) / t**2 if t else mp.mpf(1) / 2
        c3 = (t - mp.sin(t)) / t**3 if t else mp.mpf(1) / 6
        c2, c3 = float(c2), float(c3)
    turned = np.cross(dth, dv)
    f = (dv + c2 * turned + c3 * np.cross(dth, turned)) / 0.05
    close(got.value, f, 60.0)
    np.testing.assert_array_equal(np.isfinite(got.jacobian_delta_theta), True)
