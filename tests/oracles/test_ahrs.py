"""AHRS: quaternion action and integration, an independently written Hamilton convention."""

from typing import Any

import numpy as np
import pytest

from tests.oracles.implementations import Implementation, offering
from tests.oracles.libraries import library
from tests.oracles.samples import SEEDS, generator, geodetic, quaternion, rotation, vector


@pytest.fixture(scope="module")
def ahrs() -> Any:
    """Give the library."""
    return library("ahrs")


@offering("gnss_position")
@pytest.mark.parametrize("seed", SEEDS)
def test_rotation_of_a_lever_arm(ahrs: Any, implementation: Implementation, seed: int) -> None:
    """A quaternion takes body vectors to the navigation frame, actively."""
    rng = generator(seed)
    attitude, arm = quaternion(rng), rng.uniform(-5, 5, 3)
    q = {
        "position": vector(np.zeros(3), "n"),
        "attitude": rotation(attitude, "b", "n"),
        "lever_arm": vector(arm, "b"),
    }
    theirs = ahrs.Quaternion(attitude).rotate(arm)
    computed = implementation["gnss_position"](q, {})["value"]
    np.testing.assert_allclose(computed, theirs, rtol=0, atol=4e-15)


@offering("retract")
@pytest.mark.parametrize("seed", SEEDS)
def test_gyro_integration(ahrs: Any, implementation: Implementation, seed: int) -> None:
    """A steady rate moves the attitude by the rate times the interval, from the right."""
    rng = generator(seed)
    attitude, rate, dt = quaternion(rng), rng.uniform(-3, 3, 3), 0.01
    theirs = ahrs.filters.AngularRate(frequency=1 / dt).update(attitude, rate, method="closed")
    computed = implementation["retract"]("rotation", "right", attitude, rate * dt)
    np.testing.assert_allclose(computed, theirs, rtol=0, atol=1e-15)


@offering("ecef")
@pytest.mark.parametrize("seed", SEEDS)
def test_cartesian(ahrs: Any, implementation: Implementation, seed: int) -> None:
    """Earth-fixed coordinates.

    The library's own polar radius ends at the fourth decimal, so it is given one.
    """
    llh = geodetic(generator(seed))
    polar = 6378137.0 * (1 - 1 / 298.257223563)
    theirs = ahrs.common.frames.geodetic2ecef(*np.degrees(llh[:2]), llh[2], b=polar)
    np.testing.assert_allclose(implementation["ecef"](llh), theirs, rtol=0, atol=8e-9)
