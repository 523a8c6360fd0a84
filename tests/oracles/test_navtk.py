"""NavToolkit: specific-force correction, tilt, quaternion derivative and geodesy."""

from typing import Any

import numpy as np
import pytest

from tests.oracles.implementations import Implementation, offering
from tests.oracles.libraries import library
from tests.oracles.samples import SEEDS, generator, geodetic, quaternion, rotation, vector
from tests.reference.jacobian import Error

CALC_FORCE = {"rotation": "half", "sculling": "none", "epoch": "start"}


@pytest.fixture(scope="module")
def navtk() -> Any:
    """Give the library."""
    return library("navtk")


def interval(seed: int) -> dict[str, Any]:
    """Draw one interval of an inertial measurement unit on a lively platform."""
    rng = generator(seed)
    return {
        "attitude": rotation(quaternion(rng), "b", "n"),
        "delta_theta": vector(rng.uniform(-0.2, 0.2, 3), "b"),
        "delta_velocity": vector(rng.uniform(-2, 2, 3), "b"),
        "dt": vector(rng.uniform(0.002, 0.05)),
    }


@offering("specific_force")
@pytest.mark.parametrize("seed", SEEDS)
def test_calc_force_ned(navtk: Any, implementation: Implementation, seed: int) -> None:
    """The rotation-corrected force, with the attitude at the start of the interval."""
    q = interval(seed)
    dcm = navtk.navutils.quat_to_dcm(q["attitude"]["wxyz"])
    theirs = navtk.inertial.calc_force_ned(
        dcm, q["dt"]["value"][0], q["delta_theta"]["value"], q["delta_velocity"]["value"]
    )
    computed = implementation["specific_force"](q, CALC_FORCE)["value"]
    np.testing.assert_allclose(computed, theirs, rtol=0, atol=2e-15 * np.abs(theirs).max())
    as_matrix = q | {"attitude": {"matrix": dcm.ravel(), "maps": ("b", "n")}}
    computed = implementation["specific_force"](as_matrix, CALC_FORCE)["value"]
    np.testing.assert_allclose(computed, theirs, rtol=0, atol=2e-15 * np.abs(theirs).max())


@offering("specific_force.jacobian")
@pytest.mark.parametrize("seed", SEEDS)
def test_calc_force_ned_jacobian(navtk: Any, implementation: Implementation, seed: int) -> None:
    """Differences of the library's function, tilted by its own rule, match the derivatives."""
    q = interval(seed)
    dcm = navtk.navutils.quat_to_dcm(q["attitude"]["wxyz"])

    def force(tilt: Any, dth: Any, dv: Any, dt: Any) -> Any:
        turned = navtk.navutils.rot_vec_to_dcm(-tilt) @ dcm
        return navtk.inertial.calc_force_ned(turned, float(dt[0]), dth, dv)

    point = [np.zeros(3), *(q[k]["value"] for k in ("delta_theta", "delta_velocity", "dt"))]
    columns = []
    for place, centre in enumerate(point):
        step = 1e-4 if place < 3 else 1e-3 * centre[0]
        for unit in np.eye(len(centre)) * step:
            ends = [
                force(*(part + k * unit if i == place else part for i, part in enumerate(point)))
                for k in (-2, -1, 1, 2)
            ]
            columns.append((ends[0] - 8 * ends[1] + 8 * ends[2] - ends[3]) / (12 * step))
    errors = [
        Error("attitude", "rotation", "left_negative"),
        *(Error(k) for k in ("delta_theta", "delta_velocity", "dt")),
    ]
    matrix = implementation["specific_force.jacobian"](q, CALC_FORCE, errors)
    scale = np.abs(matrix).max(axis=0)
    np.testing.assert_allclose(matrix / scale, np.array(columns).T / scale, atol=1e-9)


@offering("retract")
@pytest.mark.parametrize("seed", SEEDS)
def test_tilt_is_left_negative(navtk: Any, implementation: Implementation, seed: int) -> None:
    """The Pinson tilt turns the navigation frame, the attitude the other way, from the left."""
    rng = generator(seed)
    q, tilt = quaternion(rng), rng.uniform(-1e-3, 1e-3, 3)
    dcm = navtk.navutils.quat_to_dcm(q)
    moved = implementation["retract"]("rotation", "left_negative", q, tilt)
    turned = navtk.navutils.quat_to_dcm(moved)
    np.testing.assert_allclose(turned, navtk.navutils.rot_vec_to_dcm(-tilt) @ dcm, atol=1e-15)
    np.testing.assert_allclose(turned, navtk.navutils.correct_dcm_with_tilt(dcm, tilt), atol=1e-9)


@offering("gnss_position.jacobian")
@pytest.mark.parametrize("seed", SEEDS)
def test_storage_columns(navtk: Any, implementation: Implementation, seed: int) -> None:
    """Toward the stored components the homogeneous form is differentiated, not normalised."""
    rng = generator(seed)
    q = {
        "position": vector(rng.uniform(-1e3, 1e3, 3), "n"),
        "attitude": rotation(quaternion(rng), "b", "n"),
        "lever_arm": vector(rng.uniform(-5, 5, 3), "b"),
    }
    matrix = implementation["gnss_position.jacobian"](
        q, {}, [Error("attitude", "rotation", "storage")]
    )
    theirs = navtk.navutils.d_platform_to_sensor_pos_wrt_q(
        q["attitude"]["wxyz"], q["lever_arm"]["value"]
    )
    np.testing.assert_allclose(matrix, theirs, atol=2e-14)


@offering("ecef", "local_from_geodetic")
@pytest.mark.parametrize("seed", SEEDS)
def test_geodesy(navtk: Any, implementation: Implementation, seed: int) -> None:
    """Earth-fixed and local-level coordinates, and the derivative of the former.

    The squared eccentricity of the library is that of the standard rounded to twelve digits: 4e-8 m
    on the ground.
    """
    rng = generator(seed)
    reference = geodetic(rng)
    fix = reference + rng.uniform(-1, 1, 3) * np.array([1e-3, 1e-3, 500.0])
    utils = navtk.navutils
    np.testing.assert_allclose(
        implementation["ecef"](fix), utils.llh_to_ecef(fix), rtol=0, atol=5e-8
    )
    q = {"geodetic": {"llh": fix}, "reference": {"llh": reference}}
    outputs = implementation["local_from_geodetic"](q, {"axes": "ned"})
    theirs = utils.ecef_to_local_level(utils.llh_to_ecef(reference), utils.llh_to_ecef(fix))
    np.testing.assert_allclose(outputs["value"], theirs, rtol=0, atol=2e-8)
    derivative = utils.llh_to_cen(reference).T @ utils.d_llh_to_ecef_wrt_llh(fix)
    np.testing.assert_allclose(
        outputs["noise_map"].reshape(3, 3), derivative, rtol=1e-13, atol=1e-8
    )


@offering("retract")
@pytest.mark.parametrize("seed", SEEDS)
def test_geodetic_retract(navtk: Any, implementation: Implementation, seed: int) -> None:
    """The metres of a geodetic error are divided by the radii at the nominal position."""
    rng = generator(seed)
    start, d = geodetic(rng), rng.uniform(-100, 100, 3)
    moved = implementation["retract"]("geodetic", "ned", start, d)
    utils = navtk.navutils
    north = utils.north_to_delta_lat(d[0], start[0], start[2])
    east = utils.east_to_delta_lon(d[1], start[0], start[2])
    expected = start + np.array([north, east, -d[2]])
    np.testing.assert_allclose(moved, expected, rtol=4e-16, atol=1e-15)
