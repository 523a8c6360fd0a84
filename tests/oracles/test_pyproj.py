"""PROJ: geodetic to Earth-fixed and topocentric coordinates."""

from typing import Any

import numpy as np
import pytest

from tests.oracles.implementations import Array, Implementation, offering
from tests.oracles.libraries import library
from tests.oracles.samples import SEEDS, generator, geodetic

CARTESIAN = "+proj=pipeline +step +proj=cart +ellps=WGS84"


@pytest.fixture(scope="module")
def pyproj() -> Any:
    """Give the library."""
    return library("pyproj")


def transformed(pyproj: Any, pipeline: str, llh: Array) -> Array:
    """Run a pipeline on latitude, longitude and height."""
    operation = pyproj.Transformer.from_pipeline(pipeline)
    return np.array(operation.transform(llh[1], llh[0], llh[2], radians=True))


@offering("ecef")
@pytest.mark.parametrize("seed", SEEDS)
def test_cartesian(pyproj: Any, implementation: Implementation, seed: int) -> None:
    """Earth-fixed coordinates, to the rounding of metres in double precision."""
    llh = geodetic(generator(seed))
    theirs = transformed(pyproj, CARTESIAN, llh)
    np.testing.assert_allclose(implementation["ecef"](llh), theirs, rtol=0, atol=4e-9)


@offering("ecef")
@pytest.mark.parametrize("latitude", [-np.pi / 2, 0.0, np.pi / 2])
@pytest.mark.parametrize("longitude", [-np.pi, 0.0, np.pi / 2, np.pi])
def test_cartesian_at_special_points(
    pyproj: Any, implementation: Implementation, latitude: float, longitude: float
) -> None:
    """Poles, equator, meridians."""
    llh = np.array([latitude, longitude, -30.0])
    theirs = transformed(pyproj, CARTESIAN, llh)
    np.testing.assert_allclose(implementation["ecef"](llh), theirs, rtol=0, atol=4e-9)


@offering("local_from_geodetic")
@pytest.mark.parametrize("seed", SEEDS)
def test_topocentric(pyproj: Any, implementation: Implementation, seed: int) -> None:
    """East, north and up at a reference; its degrees are rounded on the way into the library."""
    rng = generator(seed)
    reference = geodetic(rng)
    fix = reference + rng.uniform(-1, 1, 3) * np.array([5e-3, 5e-3, 500.0])
    origin = [float(np.degrees(reference[1])), float(np.degrees(reference[0]))]
    step = f" +step +proj=topocentric +ellps=WGS84 +lon_0={origin[0]!r} +lat_0={origin[1]!r}"
    theirs = transformed(pyproj, f"{CARTESIAN}{step} +h_0={float(reference[2])!r}", fix)
    q = {"geodetic": {"llh": fix}, "reference": {"llh": reference}}
    computed = implementation["local_from_geodetic"](q, {"axes": "enu"})["value"]
    np.testing.assert_allclose(computed, theirs, rtol=0, atol=2e-8)
