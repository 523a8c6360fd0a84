"""pymap3d: geodetic to Earth-fixed, east-north-up and north-east-down."""

from typing import Any

import numpy as np
import pytest

from tests.oracles.implementations import Implementation, offering
from tests.oracles.libraries import library
from tests.oracles.samples import SEEDS, generator, geodetic


@pytest.fixture(scope="module")
def pymap3d() -> Any:
    """Give the library."""
    return library("pymap3d")


@offering("ecef")
@pytest.mark.parametrize("seed", SEEDS)
def test_cartesian(pymap3d: Any, implementation: Implementation, seed: int) -> None:
    """Earth-fixed coordinates."""
    llh = geodetic(generator(seed))
    theirs = np.array(pymap3d.geodetic2ecef(*llh, deg=False))
    np.testing.assert_allclose(implementation["ecef"](llh), theirs, rtol=0, atol=4e-9)


@offering("local_from_geodetic")
@pytest.mark.parametrize("axes", ["enu", "ned"])
@pytest.mark.parametrize("seed", SEEDS)
def test_local_axes(pymap3d: Any, implementation: Implementation, seed: int, axes: str) -> None:
    """Local coordinates, in either set of axes."""
    rng = generator(seed)
    reference = geodetic(rng)
    fix = reference + rng.uniform(-1, 1, 3) * np.array([5e-3, 5e-3, 500.0])
    convert = getattr(pymap3d, f"geodetic2{axes}")
    theirs = np.array(convert(*fix, *reference, deg=False))
    q = {"geodetic": {"llh": fix}, "reference": {"llh": reference}}
    computed = implementation["local_from_geodetic"](q, {"axes": axes})["value"]
    np.testing.assert_allclose(computed, theirs, rtol=0, atol=2e-8)


@offering("local_from_geodetic")
@pytest.mark.parametrize("maps", [("enu", "local"), ("local", "enu")])
@pytest.mark.parametrize("seed", SEEDS)
def test_heading_and_noise(
    pymap3d: Any, implementation: Implementation, seed: int, maps: tuple[str, str]
) -> None:
    """The heading turns value and noise alike, in the direction of its frames."""
    rng = generator(seed)
    reference, psi = geodetic(rng), rng.uniform(-3, 3)
    fix = reference + rng.uniform(-1, 1, 3) * np.array([1e-4, 1e-4, 50.0])
    half = rng.standard_normal((3, 3)) * np.array([[1e-7], [1e-7], [1.0]])
    covariance = half @ half.T
    c, s = np.cos(psi), np.sin(psi)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    turn = turn if maps[0] == "enu" else turn.T

    def position(llh: Any) -> Any:
        return turn @ np.array(pymap3d.geodetic2enu(*llh, *reference, deg=False))

    steps = np.diag([1e-5, 1e-5, 1.0])
    columns = [(position(fix + e) - position(fix - e)) / (2 * e.sum()) for e in steps]
    noise_map = np.array(columns).T
    q = {
        "geodetic": {"llh": fix},
        "reference": {"llh": reference},
        "heading": {"angle": psi, "axis": "z", "maps": maps},
        "covariance": {"value": covariance.ravel()},
    }
    outputs = implementation["local_from_geodetic"](q, {"axes": "enu"})
    np.testing.assert_allclose(outputs["value"], position(fix), rtol=0, atol=2e-8)
    units = np.array([1e-7, 1e-7, 1.0])
    np.testing.assert_allclose(
        outputs["noise_map"].reshape(3, 3) * units, noise_map * units, atol=1e-8
    )
    carried = outputs["noise_map"].reshape(3, 3) @ covariance @ outputs["noise_map"].reshape(3, 3).T
    np.testing.assert_allclose(outputs["covariance"].reshape(3, 3), carried, rtol=1e-13, atol=1e-12)
