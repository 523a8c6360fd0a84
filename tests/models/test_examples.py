"""The examples to copy: a rover with two satellite systems, and ranges in single precision."""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from symnav import pipeline
from symnav.spec import loads
from tests.models.conftest import Package
from tests.models.formulas import SEEDS, Array, close, generator, matrix, quaternion, skew

Make = Callable[[str], Package]
C, RATE = 299792458.0, 7.2921151467e-5
PER_AXIS = 3e4
TOLERANCE = 0.010
"""Metres that single precision may lose within 30 km per axis of the reference."""


def test_rover_has_22_states(package: Make) -> None:
    """22 stored, 21 in error, and three measurements."""
    model = package("rover")
    assert (model.state.size, model.state.error.size) == (22, 21)
    assert all(hasattr(model.functions, name) for name in ("gps", "range", "imu"))


@pytest.mark.parametrize("seed", SEEDS)
def test_rover_position(package: Make, seed: int) -> None:
    """The antenna's position with the lever arm estimated."""
    model = package("rover")
    rng = generator(seed)
    p, q, arm = rng.uniform(-9e3, 9e3, 3), quaternion(rng), rng.uniform(-5, 5, 3)
    got = model.functions.gps(model.state.pack(position=p, attitude=q, antenna=arm))
    r, error = matrix(q), model.state.error
    close(got.value, p + r @ arm, 1e4)
    expected = np.zeros((3, 21))
    expected[:, error.position], expected[:, error.antenna] = np.eye(3), r
    expected[:, error.attitude] = -r @ skew(arm)
    close(got.jacobian, expected, 8.0)


def scene(seed: int, count: int) -> tuple[Array, Array]:
    """A point on the Earth and satellites above its horizon."""
    rng = generator(seed)
    up = rng.standard_normal(3)
    up /= np.linalg.norm(up)
    satellites: list[Array] = []
    while len(satellites) < count:
        direction = rng.standard_normal(3)
        direction /= np.linalg.norm(direction)
        if direction @ up > 0.1:
            satellites.append(2.656e7 * direction)
    return 6.37e6 * up, np.array(satellites)


def area_term(satellites: Array, a: Array) -> Array:
    """(w/c)(s_x a_y - s_y a_x)."""
    term: Array = RATE / C * (satellites[:, 0] * a[1] - satellites[:, 1] * a[0])
    return term


@pytest.mark.parametrize("seed", SEEDS)
def test_rover_ranges_of_two_systems(package: Make, seed: int) -> None:
    """Every satellite reads the clock of its own system, and only that one's column is set."""
    model = package("rover")
    rng = generator(seed + 50)
    origin, satellites = scene(seed, 7)
    system = np.array([0, 1, 1, 0, 1, 0, 0], dtype=np.int32)
    p, q, arm = rng.uniform(-9e3, 9e3, 3), quaternion(rng), rng.uniform(-5, 5, 3)
    axes, clocks = quaternion(rng), rng.uniform(-3e5, 3e5, 2)
    clock, wet, ions = (rng.uniform(-1, 1, (3, 7)).T * [1e-4, 10.0, 20.0]).T
    x = model.state.pack(
        position=p, attitude=q, antenna=arm, b_gps=clocks[0], b_galileo=clocks[1], drift=0.3
    )
    got = model.functions.range(
        x, nav_to_ecef=axes, origin=origin, system=system, satellite_position=satellites,
        satellite_clock=clock, troposphere=wet, ionosphere=ions, measured=np.zeros(7),
    )  # fmt: skip
    c, r, error = matrix(axes), matrix(q), model.state.error
    a = origin + c @ (p + r @ arm)
    toward = a - satellites
    distance = np.linalg.norm(toward, axis=1)
    expected = distance + area_term(satellites, a) + clocks[system] - C * clock + wet + ions
    close(got.value, expected, 3e7)
    close(got.residual, -expected, 6e7)
    g = toward / distance[:, None]
    g[:, 0] -= RATE / C * satellites[:, 1]
    g[:, 1] += RATE / C * satellites[:, 0]
    matrix_expected = np.zeros((7, 21))
    matrix_expected[:, error.position] = g @ c
    matrix_expected[:, error.attitude] = -g @ c @ r @ skew(arm)
    matrix_expected[:, error.antenna] = g @ c @ r
    matrix_expected[:, error.b_gps] = (system == 0)[:, None]
    matrix_expected[:, error.b_galileo] = (system == 1)[:, None]
    close(got.jacobian, matrix_expected, 8.0)
    zero = matrix_expected == 0.0
    np.testing.assert_array_equal(got.jacobian[zero], 0.0)


def test_rover_refuses_an_unknown_system(package: Make) -> None:
    """A code that names no system fails its own satellite only."""
    model = package("rover")
    origin, satellites = scene(1, 3)
    zeros = np.zeros(3)
    got = model.functions.range(
        model.state.pack(), nav_to_ecef=[1.0, 0, 0, 0], origin=origin, system=[0, 2, 1],
        satellite_position=satellites, satellite_clock=zeros, troposphere=zeros, ionosphere=zeros,
        measured=zeros,
    )  # fmt: skip
    assert got.status == 7
    assert list(np.asarray(got.item_status) == 0) == [True, False, True]
    assert not got.jacobian[1].any()


@pytest.mark.parametrize("seed", SEEDS)
def test_rover_increments(package: Make, seed: int) -> None:
    """Two sub-samples: half the total rotation, and 2/3 (a1 x v2 + v1 x a2)."""
    model = package("rover")
    rng = generator(seed)
    q, angles, velocities = quaternion(rng), rng.uniform(-0.1, 0.1, (2, 3)), rng.uniform(-2, 2, 6)
    b_a, b_g, dt = rng.uniform(-0.5, 0.5, 3), rng.uniform(-0.05, 0.05, 3), 0.02
    x = model.state.pack(attitude=q, accelerometer_bias=b_a, gyro_bias=b_g)
    got = model.functions.imu(x, delta_theta=angles.ravel(), delta_velocity=velocities, dt=dt).value
    a1, a2 = angles - b_g * dt / 2
    v1, v2 = velocities.reshape(2, 3) - b_a * dt / 2
    sculling = 2 / 3 * (np.cross(a1, v2) + np.cross(v1, a2))
    f = matrix(q) @ (v1 + v2 + np.cross(a1 + a2, v1 + v2) / 2 + sculling) / dt
    close(got, f, float(np.abs(f).max()))


def arguments(seed: int, count: int) -> tuple[Array, Array, dict[str, Array], Array]:
    """Displacement, clock and arguments of relative ranges, and the ranges less the reference's.

    The last is worked out in many digits from positions that are exact in single precision.
    """
    mp: Any = pytest.importorskip("mpmath").mp
    rng = generator(seed)
    reference, satellites = scene(seed, count)
    single = np.float32
    difference = (satellites - reference).astype(single).astype(float)
    satellites = reference + difference
    place = rng.uniform(-PER_AXIS, PER_AXIS, 3).astype(single).astype(float)
    clock = np.array(rng.uniform(-1e4, 1e4), dtype=single).astype(float)
    truth = []
    with mp.workdps(40):
        for s in satellites:
            ends = [
                [mp.mpf(float(v)) for v in reference],
                [
                    mp.mpf(float(v)) + mp.mpf(float(d))
                    for v, d in zip(reference, place, strict=True)
                ],
            ]
            r0, r1 = (
                mp.sqrt(sum((mp.mpf(float(v)) - e) ** 2 for v, e in zip(s, end, strict=True)))
                + mp.mpf(RATE) / C * (float(s[0]) * end[1] - float(s[1]) * end[0])
                for end in ends
            )
            truth.append(float(r1 - r0 + mp.mpf(float(clock))))
    given = {
        "satellite_difference": difference,
        "reference_range": np.linalg.norm(difference, axis=1),
        "satellite_xy": satellites[:, :2],
    }
    return place, clock, given, np.array(truth)


@pytest.mark.parametrize("seed", range(40))
def test_relative_ranges_in_single_precision(
    generated: Callable[[str | Path], ModuleType], seed: int
) -> None:
    """Within 30 km per axis float32 keeps centimetres; float64 keeps them all."""
    module: Any = generated("reference_relative")
    place, clock, given, truth = arguments(seed, 12)
    x = module.State.pack(position=place, clock_bias=clock)
    measured = np.zeros(12)
    for backend, dtype, tolerance in (
        ("native_f32", np.float32, TOLERANCE),
        ("native", np.float64, 1e-7),
        ("numpy", np.float64, 1e-7),
    ):
        functions = importlib.import_module(f"{module.__name__}.{backend}")
        got = functions.range(
            x.astype(dtype), measured=measured.astype(dtype),
            **{name: value.astype(dtype) for name, value in given.items()},
        )  # fmt: skip
        assert got.value.dtype == dtype
        np.testing.assert_allclose(got.value, truth, rtol=0, atol=tolerance, err_msg=backend)


def test_relative_ranges_take_their_arguments_in_the_order_of_the_model() -> None:
    """Declaring inputs, for their ranges, must not move the parameters of the C."""
    spec = pipeline.load("reference_relative")
    text = (pipeline._models() / "reference_relative.toml").read_text(encoding="utf-8")
    undeclared = loads(re.sub(r"\[\[input\]\]\n(\w.*\n)+\n", "", text))
    assert list(spec.inputs) == list(undeclared.inputs)
    (declared,) = pipeline.derive(spec).entries
    assert declared.arguments == pipeline.derive(undeclared).entries[0].arguments


def test_plain_ranges_would_lose_metres() -> None:
    """Why the example exists: coordinates alone cost decimetres in single precision."""
    place, _, given, _ = arguments(3, 12)
    far = given["satellite_difference"].astype(np.float32) - place.astype(np.float32)
    plain = np.linalg.norm(far, axis=1) - given["reference_range"].astype(np.float32)
    exact = np.linalg.norm(given["satellite_difference"] - place, axis=1) - given["reference_range"]
    assert np.abs(plain - exact).max() > 10 * TOLERANCE
