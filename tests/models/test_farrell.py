"""Farrell: rows [h C_n^e, 1, 0 x 13], their differences, and the noise these share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.models.conftest import Package, specification
from tests.models.formulas import SEEDS, Array, close, generator, matrix, quaternion, skew

Make = Callable[[str], Package]
SATELLITES = 6
RADIUS, ORBIT = 6.37e6, 2.656e7
DOMAIN, PARTIAL = 3, 7


def scene(model: Package, seed: int, count: int = SATELLITES) -> tuple[Array, dict[str, Any]]:
    """A state, and the arguments of the pseudoranges of satellites above the horizon."""
    rng = generator(seed)
    up = rng.standard_normal(3)
    up /= np.linalg.norm(up)
    satellites: list[Array] = []
    while len(satellites) < count:
        direction = rng.standard_normal(3)
        direction /= np.linalg.norm(direction)
        if direction @ up > 0.3:
            satellites.append(ORBIT * direction)
    x = model.state.pack(
        dp=rng.uniform(-5e3, 5e3, 3), b_u=rng.uniform(-3e5, 3e5), dv=rng.uniform(-9, 9, 3),
        b_u_dot=rng.uniform(-9, 9), drho=quaternion(rng), x_a=rng.uniform(-1, 1, 3),
        x_g=rng.uniform(-1, 1, 3),
    )  # fmt: skip
    arguments = {
        "c_n_e": matrix(quaternion(rng)).ravel(),
        "origin": RADIUS * up,
        "satellite_position": np.reshape(satellites, (count, 3)),
    }
    return x, arguments


def geometry(model: Package, x: Array, given: dict[str, Any], arm: Array) -> tuple[Array, Array]:
    """Ranges, and the unit vectors h from the satellites to the antenna, as rows."""
    c = given["c_n_e"].reshape(3, 3)
    antenna = given["origin"] + c @ (x[model.state.dp] + matrix(x[model.state.drho]) @ arm)
    toward = antenna - given["satellite_position"]
    ranges = np.linalg.norm(toward, axis=1)
    return ranges, toward / ranges[:, None]


def test_order_of_the_book(package: Make) -> None:
    """Dp 0-2, b_u 3, dv 4-6, b_u_dot 7, drho 8-10, x_a 11-13, x_g 14-16."""
    state = package("farrell_tightly_coupled").state
    assert state.names == ("dp", "b_u", "dv", "b_u_dot", "drho", "x_a", "x_g")
    assert [getattr(state.error, name).start for name in state.names] == [0, 3, 4, 7, 8, 11, 14]
    assert state.error.size == 17


def test_attitude_error_is_of_the_left(package: Make) -> None:
    """C = (I + [rho]x) C_hat to first order."""
    state = package("farrell_tightly_coupled").state
    q, rho = quaternion(generator(4)), np.array([1e-6, -2e-6, 3e-6])
    d = np.zeros(17)
    d[state.error.drho] = rho
    moved = state.retract(state.pack(drho=q), d)[state.drho]
    expected = (np.eye(3) + skew(rho)) @ matrix(q)
    np.testing.assert_allclose(matrix(moved), expected, rtol=0, atol=2e-11)


@pytest.mark.parametrize("seed", SEEDS)
def test_rows_of_the_book(package: Make, seed: int) -> None:
    """Columns 0:3 are h C_n^e, column 3 is one, columns 4:17 are zero, all to the last bit."""
    model = package("farrell_tightly_coupled")
    x, given = scene(model, seed)
    measured = generator(seed + 50).uniform(2e7, 2.6e7, SATELLITES)
    got = model.functions.pseudorange(x, **given, measured=measured)
    ranges, h = geometry(model, x, given, np.zeros(3))
    bias = float(x[model.state.b_u][0])
    close(got.value, ranges + bias, 3e7)
    close(got.residual, measured - ranges - bias, 6e7)
    assert got.jacobian.shape == (SATELLITES, 17)
    close(got.jacobian[:, 0:3], h @ given["c_n_e"].reshape(3, 3))
    np.testing.assert_array_equal(got.jacobian[:, 3], 1.0)
    np.testing.assert_array_equal(got.jacobian[:, 4:17], 0.0)
    assert got.status == 0 and not np.any(got.item_status)


@pytest.mark.parametrize("seed", SEEDS)
def test_lever_arm_brings_the_attitude_in(package: Make, seed: int) -> None:
    """Columns 8:11 are -h C_n^e [C_b^n l]x."""
    model = package("farrell_tightly_coupled")
    x, given = scene(model, seed)
    arm = generator(seed + 50).uniform(-5, 5, 3)
    got = model.functions.pseudorange_lever_arm(x, **given, lever_arm=arm)
    ranges, h = geometry(model, x, given, arm)
    close(got.value, ranges + x[model.state.b_u], 3e7)
    row = h @ given["c_n_e"].reshape(3, 3)
    expected = np.zeros((SATELLITES, 17))
    expected[:, 0:3], expected[:, 3] = row, 1.0
    expected[:, 8:11] = -row @ skew(matrix(x[model.state.drho]) @ arm)
    close(got.jacobian, expected, 8.0)
    np.testing.assert_array_equal(got.jacobian[expected == 0.0], 0.0)


@pytest.mark.parametrize("reference", range(SATELLITES))
def test_single_difference(package: Make, reference: int) -> None:
    """Less the reference, wherever it stands: the clock column vanishes exactly."""
    model = package("farrell_tightly_coupled")
    x, given = scene(model, 2)
    given["measured"] = generator(60).uniform(2e7, 2.6e7, SATELLITES)
    plain = model.functions.pseudorange(x, **given)
    got = model.functions.pseudorange.single_difference(x, **given, reference=reference)
    others = [i for i in range(SATELLITES) if i != reference]
    assert got.jacobian.shape == (SATELLITES - 1, 17)
    for name in ("value", "residual", "jacobian"):
        rows = getattr(plain, name)
        np.testing.assert_array_equal(getattr(got, name), rows[others] - rows[reference])
    np.testing.assert_array_equal(got.jacobian[:, 3:], 0.0)
    assert np.abs(got.jacobian[:, 0:3]).min(axis=1).max() > 0.01

    d = model.functions.pseudorange.difference_matrix(SATELLITES, reference)
    np.testing.assert_array_equal(d.sum(axis=1), 0.0)
    np.testing.assert_array_equal(d @ np.ones(SATELLITES), 0.0)
    np.testing.assert_allclose(d @ plain.value, got.value, rtol=0, atol=2e-8)


@pytest.mark.parametrize("reference", [0, 2, 4])
def test_noise_of_the_differences(package: Make, reference: int) -> None:
    """R = sigma^2 (I + 1 1^T) for equal sigmas, diag + sigma_ref^2 1 1^T in general."""
    function = package("farrell_tightly_coupled").functions.pseudorange
    equal = function.difference_covariance(np.full(5, 3.0), reference)
    np.testing.assert_array_equal(equal, 9.0 * (np.eye(4) + np.ones((4, 4))))
    sigma = np.array([1.0, 2.0, 3.0, 5.0, 7.0])
    others = np.delete(sigma, reference)
    general = function.difference_covariance(sigma, reference)
    np.testing.assert_array_equal(general, np.diag(others**2) + sigma[reference] ** 2)
    d = function.difference_matrix(5, reference)
    np.testing.assert_array_equal(general, d @ np.diag(sigma**2) @ d.T)


def test_one_satellite_differs_from_nobody(package: Make) -> None:
    """The difference of a single satellite is empty, and says so without an error."""
    model = package("farrell_tightly_coupled")
    x, given = scene(model, 1, count=1)
    got = model.functions.pseudorange.single_difference(x, **given, measured=[2e7], reference=0)
    assert got.value.shape == (0,) and got.jacobian.shape == (0, 17)


def test_no_satellite(package: Make) -> None:
    """Nor is an epoch without satellites an error."""
    model = package("farrell_tightly_coupled")
    x, given = scene(model, 1, count=0)
    got = model.functions.pseudorange(x, **given, measured=np.zeros(0))
    assert got.status == 0
    assert got.value.shape == (0,) and got.jacobian.shape == (0, 17)


def test_satellite_at_the_receiver(package: Make) -> None:
    """One satellite without a direction does not cost the epoch."""
    model = package("farrell_tightly_coupled")
    x, given = scene(model, 3)
    x[model.state.dp] = 0.0
    good = model.functions.pseudorange(x, **given, measured=np.zeros(SATELLITES))
    given["satellite_position"][2] = given["origin"]
    got = model.functions.pseudorange(x, **given, measured=np.zeros(SATELLITES))
    assert got.status == PARTIAL
    assert list(got.item_status) == [0, 0, DOMAIN, 0, 0, 0]
    assert got.value[2] == 0.0 and not got.jacobian[2].any()
    others = [0, 1, 3, 4, 5]
    np.testing.assert_array_equal(got.jacobian[others], good.jacobian[others])


def test_clock_in_seconds_has_the_speed_of_light(package: Make) -> None:
    """The same state with its clock in seconds: column 3 is c."""
    text = specification("farrell_tightly_coupled")
    metres = 'name = "b_u"\nkind = "scalar"\nunit = "m"\n'
    assert metres in text
    bounded = 'name = "b_u"\nkind = "scalar"\nunit = "s"\nrange = [-1e-2, 1e-2]\n'
    model = package(text.replace(metres, bounded))
    x, given = scene(model, 1)
    x[model.state.b_u] = 1.5e-4
    got = model.functions.pseudorange(x, **given, measured=np.zeros(SATELLITES))
    ranges, _ = geometry(model, x, given, np.zeros(3))
    close(got.value, ranges + 299792458.0 * 1.5e-4, 3e7)
    np.testing.assert_array_equal(got.jacobian[:, 3], 299792458.0)
