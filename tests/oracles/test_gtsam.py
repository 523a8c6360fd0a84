"""GTSAM: GPS and pseudorange factors, with Jacobians on Pose3's tangent (R Exp(d), p + R d)."""

from typing import Any

import numpy as np
import pytest

from tests.oracles.implementations import Array, Implementation, offering
from tests.oracles.libraries import library
from tests.oracles.samples import (
    SEEDS,
    generator,
    quaternion,
    rotation,
    sphere,
    vector,
    visible_satellite,
)
from tests.reference.blocks import Setting
from tests.reference.jacobian import Error

POSITION, CLOCK, ARM = 0, 1, 2


@pytest.fixture(scope="module")
def gtsam() -> Any:
    """Give the library."""
    return library("gtsam")


def pose_errors(q: dict[str, Any]) -> list[Error]:
    """Describe the tangent of Pose3: R <- R Exp(d), p <- p + R d."""
    body = Setting(rotation=q["attitude"], frames=("b", q["position"]["frame"]))
    return [Error("attitude", "rotation", "right"), Error("position", setting=body)]


def pose(gtsam: Any, q: dict[str, Any]) -> Any:
    """Give the pose of the quantities."""
    return gtsam.Pose3(gtsam.Rot3.Quaternion(*q["attitude"]["wxyz"]), q["position"]["value"])


def linearised(factor: Any, values: Any) -> Array:
    """Give the derivative of a factor's error toward its variables, in the order of their keys."""
    matrix: Array = factor.linearize(values).jacobian()[0]
    return matrix


def armed(seed: int) -> dict[str, Any]:
    """Draw a position, an attitude and a lever arm."""
    rng = generator(seed)
    return {
        "position": vector(rng.uniform(-2e3, 2e3, 3), "n"),
        "attitude": rotation(quaternion(rng), "b", "n"),
        "lever_arm": vector(rng.uniform(-5, 5, 3), "b"),
    }


@offering("gnss_position", "gnss_position.jacobian")
@pytest.mark.parametrize("seed", SEEDS)
def test_gps_factor(gtsam: Any, implementation: Implementation, seed: int) -> None:
    """Without lever arm the position column is the attitude: the error lives in the body."""
    q = armed(seed)
    del q["lever_arm"]
    fix = generator(seed + 100).uniform(-2e3, 2e3, 3)
    factor = gtsam.GPSFactor(POSITION, fix, gtsam.noiseModel.Unit.Create(3))
    values = gtsam.Values()
    values.insert(POSITION, pose(gtsam, q))
    computed = implementation["gnss_position"](q, {})["value"] - fix
    np.testing.assert_allclose(computed, factor.unwhitenedError(values), atol=1e-11)
    matrix = implementation["gnss_position.jacobian"](q, {}, pose_errors(q))
    np.testing.assert_allclose(matrix, linearised(factor, values), atol=1e-14)


@offering("gnss_position", "gnss_position.jacobian")
@pytest.mark.parametrize("seed", SEEDS)
def test_gps_factor_with_arm(gtsam: Any, implementation: Implementation, seed: int) -> None:
    """A factor with a lever arm that is estimated as well."""
    q = armed(seed)
    fix = generator(seed + 100).uniform(-2e3, 2e3, 3)
    noise = gtsam.noiseModel.Unit.Create(3)
    values = gtsam.Values()
    values.insert(POSITION, pose(gtsam, q))
    fixed = gtsam.GPSFactorArm(POSITION, fix, q["lever_arm"]["value"], noise)
    computed = implementation["gnss_position"](q, {})["value"] - fix
    np.testing.assert_allclose(computed, fixed.unwhitenedError(values), atol=1e-11)
    values.insert(ARM, q["lever_arm"]["value"])
    estimated = gtsam.GPSFactorArmCalib(POSITION, ARM, fix, noise)
    errors = [*pose_errors(q), Error("lever_arm")]
    matrix = implementation["gnss_position.jacobian"](q, {}, errors)
    np.testing.assert_allclose(matrix, linearised(estimated, values), atol=2e-14)
    np.testing.assert_allclose(matrix[:, :6], linearised(fixed, values), atol=2e-14)


@offering("pseudorange", "pseudorange.jacobian")
@pytest.mark.parametrize("seed", SEEDS)
def test_pseudorange_factor(gtsam: Any, implementation: Implementation, seed: int) -> None:
    """Clocks in seconds, Sagnac to first order; the rotation counts in the gradient too."""
    rng = generator(seed)
    point = sphere(rng, 6.37e6)
    satellite = visible_satellite(rng, point)
    bias, satellite_clock, measured = rng.uniform(-1e-3, 1e-3), rng.uniform(-1e-4, 1e-4), 2.2e7
    noise = gtsam.noiseModel.Unit.Create(1)
    factor = gtsam.PseudorangeFactor(POSITION, CLOCK, measured, satellite, satellite_clock, noise)
    values = gtsam.Values()
    values.insert(POSITION, point)
    values.insert(CLOCK, bias)
    q = {
        "position": vector(point, "ecef"),
        "clock_bias": vector(bias),
        "satellite_position": vector(satellite, "ecef"),
        "satellite_clock": vector(satellite_clock),
        "measured": vector(measured),
    }
    options = {"sagnac": "first_order", "clock_unit": "s"}
    residual = implementation["pseudorange"](q, options)["residual"]
    np.testing.assert_allclose(-residual, factor.unwhitenedError(values), atol=2e-8)
    errors = [Error("position"), Error("clock_bias", "scalar")]
    matrix = implementation["pseudorange.jacobian"](q, options, errors)
    np.testing.assert_allclose(matrix, linearised(factor, values), rtol=1e-14, atol=1e-14)


@offering("pseudorange", "pseudorange.jacobian")
@pytest.mark.parametrize("seed", SEEDS)
def test_pseudorange_factor_with_arm(gtsam: Any, implementation: Implementation, seed: int) -> None:
    """A body in a local frame: pose, lever arm and the navigation frame's own pose on the Earth."""
    rng = generator(seed)
    origin = sphere(rng, 6.37e6)
    satellite = visible_satellite(rng, origin)
    to_earth, bias, measured = quaternion(rng), rng.uniform(-1e-3, 1e-3), 2.2e7
    q = armed(seed) | {
        "origin": vector(origin, "ecef"),
        "nav_to_ecef": rotation(to_earth, "n", "ecef"),
        "clock_bias": vector(bias),
        "satellite_position": vector(satellite, "ecef"),
        "measured": vector(measured),
    }
    factor = gtsam.PseudorangeFactorArm(
        POSITION,
        CLOCK,
        measured,
        satellite,
        q["lever_arm"]["value"],
        gtsam.Pose3(gtsam.Rot3.Quaternion(*to_earth), origin),
        0.0,
        gtsam.noiseModel.Unit.Create(1),
    )
    values = gtsam.Values()
    values.insert(POSITION, pose(gtsam, q))
    values.insert(CLOCK, bias)
    options = {"sagnac": "first_order", "clock_unit": "s"}
    residual = implementation["pseudorange"](q, options)["residual"]
    np.testing.assert_allclose(-residual, factor.unwhitenedError(values), atol=2e-8)
    errors = [*pose_errors(q), Error("clock_bias", "scalar")]
    matrix = implementation["pseudorange.jacobian"](q, options, errors)
    np.testing.assert_allclose(matrix, linearised(factor, values), rtol=1e-13, atol=2e-14)


@offering("pseudorange")
@pytest.mark.parametrize("seed", SEEDS)
def test_sagnac_term(gtsam: Any, implementation: Implementation, seed: int) -> None:
    """The range exceeds the plain distance by the first-order term alone."""
    rng = generator(seed)
    point = sphere(rng, 6.37e6)
    satellite = visible_satellite(rng, point)
    factor = gtsam.PseudorangeFactor(
        POSITION, CLOCK, 0.0, satellite, 0.0, gtsam.noiseModel.Unit.Create(1)
    )
    values = gtsam.Values()
    values.insert(POSITION, point)
    values.insert(CLOCK, 0.0)
    q = {"position": vector(point, "ecef"), "satellite_position": vector(satellite, "ecef")}
    plain = implementation["pseudorange"](q, {"sagnac": "none"})["value"]
    term = implementation["pseudorange"](q, {"sagnac": "first_order"})["value"] - plain
    np.testing.assert_allclose(factor.unwhitenedError(values) - plain, term, atol=2e-8)
    assert 0.05 < abs(term[0]) < 45


@offering("retract", "local")
@pytest.mark.parametrize("seed", SEEDS)
def test_rotation_retract(gtsam: Any, implementation: Implementation, seed: int) -> None:
    """Rot3's tangent is the right one, and its local coordinates undo its retract."""
    rng = generator(seed)
    p, d = quaternion(rng), rng.uniform(-1, 1, 3)
    start = gtsam.Rot3.Quaternion(*p)
    moved = implementation["retract"]("rotation", "right", p, d)
    np.testing.assert_allclose(
        gtsam.Rot3.Quaternion(*moved).matrix(), start.expmap(d).matrix(), atol=1e-15
    )
    back = implementation["local"]("rotation", "right", p, moved)
    np.testing.assert_allclose(back, start.logmap(start.expmap(d)), atol=1e-14)
