"""WarpTwin: the literal reading, the other one, and the generalisation with a lever arm."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tests.models.conftest import Package
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
START = 4


def state(seed: int) -> Array:
    """A state of 15 whose every element is drawn."""
    return generator(seed).uniform(-7e6, 7e6, 15)


def test_ones_in_either_order(package: Make) -> None:
    """The flat Jacobian has ones at i N + 4 + i by row, at 3 (4 + i) + i by column."""
    model = package("warpos_gps")
    assert (model.state.size, model.state.position) == (15, slice(START, START + 3))
    by_row = model.functions.measurement(state(1))
    by_column = model.functions.measurement_by_column(state(1))
    np.testing.assert_array_equal(by_row.value, state(1)[4:7])
    np.testing.assert_array_equal(by_column.value, state(1)[4:7])
    flat = by_row.jacobian.ravel()
    assert set(np.flatnonzero(flat)) == {i * 15 + START + i for i in range(3)}
    transposed = by_column.jacobian.ravel("F")
    assert set(np.flatnonzero(transposed)) == {(START + i) * 3 + i for i in range(3)}
    assert set(flat) == set(transposed) == {0.0, 1.0}


@pytest.mark.parametrize("seed", SEEDS)
def test_prediction_in_the_axes_of_the_receiver(package: Make, seed: int) -> None:
    """z = R(quat_F_REF)^T p, and the block of H is that transpose."""
    model = package("warpos_gps")
    q = quaternion(generator(seed + 50))
    x, back = state(seed), matrix(q).T
    expected = np.zeros((3, 15))
    expected[:, START : START + 3] = back
    for function in (model.functions.observed, model.functions.observed_by_column):
        got = function(x, observer_attitude=q)
        close(got.value, back @ x[4:7], 7e6)
        close(got.jacobian, expected)


@pytest.mark.parametrize("seed", SEEDS)
def test_what_the_note_asks_of_the_caller(package: Make, seed: int) -> None:
    """pos_B_F__F = R_F_REF pos_GPS_I__REF - pos_F_I__F - R_F_B pos_GPS_B__B; the noise turns."""
    rng = generator(seed)
    observer, attitude = quaternion(rng), quaternion(rng)
    fix, offset, arm = rng.uniform(-7e6, 7e6, 3), rng.uniform(-7e6, 7e6, 3), rng.uniform(-5, 5, 3)
    half = rng.standard_normal((3, 3))
    covariance = half @ half.T
    got = package("warpos_gps").functions.to_state_frame(
        receiver_position=fix,
        observer_attitude=observer,
        origin_offset=offset,
        attitude=attitude,
        lever_arm=arm,
        covariance=covariance.ravel(),
    )
    r = matrix(observer)
    close(got.value, r @ fix - offset - matrix(attitude) @ arm, 2e7)
    close(np.reshape(got.value_covariance, (3, 3)), r @ covariance @ r.T, 20.0)


GENERALISED = """\
name = "generalised"
[[frame]]
name = "f"
axes = "free"
[[state]]
name = "leading"
kind = "vector"
size = 2
unit = "1"
[[state]]
name = "attitude"
kind = "rotation"
maps = "b -> f"
storage = "{storage}"
[[state]]
name = "position"
kind = "vector"
size = 3
unit = "m"
frame = "f"
[[measurement]]
name = "gps"
model = "gnss_position"
position = "position"
attitude = "attitude"
lever_arm = "input"
offset = "input"
observer_attitude = "observer"
[[input]]
name = "observer"
maps = "ref -> f"
"""


@pytest.mark.parametrize("storage", ["wxyz", "xyzw"])
@pytest.mark.parametrize("seed", SEEDS)
def test_generalisation_with_attitude(package: Make, seed: int, storage: str) -> None:
    """z = R_F_REF^T (p + pos_F_I__F + R l): the attitude columns that the original leaves out."""
    model = package(GENERALISED.format(storage=storage))
    rng = generator(seed)
    q, observer = quaternion(rng), quaternion(rng)
    p, arm, offset = rng.uniform(-9e3, 9e3, 3), rng.uniform(-5, 5, 3), rng.uniform(-9e3, 9e3, 3)
    stored = q if storage == "wxyz" else np.roll(q, -1)
    x = model.state.pack(attitude=stored, position=p, leading=[3.0, -4.0])
    got = model.functions.gps(x, lever_arm=arm, offset=offset, observer=observer)
    r, back = matrix(q), matrix(observer).T
    close(got.value, back @ (p + offset + r @ arm), 2e4)
    expected = np.zeros((3, 8))
    expected[:, 2:5], expected[:, 5:8] = -back @ r @ skew(arm), back
    close(got.jacobian, expected, 8.0)


SQUARE = """\
name = "square"
[[frame]]
name = "f"
axes = "free"
[[state]]
name = "position"
kind = "vector"
size = 3
unit = "m"
frame = "f"
[[measurement]]
name = "by_row"
model = "gnss_position"
position = "position"
observer_attitude = "observer"
[[measurement]]
name = "by_column"
model = "gnss_position"
position = "position"
observer_attitude = "observer"
order = "column"
[[input]]
name = "observer"
maps = "ref -> f"
"""


def test_order_shows_in_a_square_jacobian(package: Make) -> None:
    """With N = 3 only the memory tells the orders apart; both are the same matrix."""
    model = package(SQUARE)
    q = quaternion(generator(8))
    x = np.array([1.0, 2.0, 3.0])
    by_row, by_column = (
        getattr(model.functions, name)(x, observer=q).jacobian for name in ("by_row", "by_column")
    )
    close(by_row, matrix(q).T)
    np.testing.assert_allclose(by_column, by_row, rtol=0, atol=4e-16)
    if by_column.flags.f_contiguous:  # the native back end hands out what the C wrote
        close(by_column.ravel("K"), matrix(q).ravel())
    close(ONE, by_row @ by_row.T)
