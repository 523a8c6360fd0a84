"""The range models against one another and against light travelling in inertial space."""

from random import Random

import pytest
from mpmath import mpf

from . import pseudorange, pseudorange_relative
from .algebra import Vector, about, add, exact, length, propagate, sandwich, subtract
from .drawing import far, number, numbers, on_sphere, quaternion, vector, visible
from .earth import LIGHT_SPEED, ROTATION_RATE, ecef
from .pseudorange import converged_range, geometric_range

HEIGHTS = {"gps": (26.56e6, "1.1e-4"), "galileo": (29.6e6, "1.4e-4"), "geo": (42.164e6, "2.9e-4")}


def geometry(seed: int, radius: float = 26.56e6) -> tuple[Vector, Vector]:
    """Draw a satellite and an antenna."""
    rng = Random(seed)
    antenna = on_sphere(rng, 6.378e6)
    return visible(rng, antenna, radius), antenna


@pytest.mark.parametrize("system", HEIGHTS)
def test_first_order_is_close_to_exact(system: str) -> None:
    """The neglected terms stay within their bound, and some geometry comes near it."""
    radius, bound = HEIGHTS[system]
    worst = mpf(0)
    for seed in range(40):
        s, a = geometry(seed, radius)
        worst = max(worst, abs(geometric_range(s, a, "first_order") - converged_range(s, a)))
    assert mpf(bound) / 2 < worst < mpf(bound)


@pytest.mark.parametrize("seed", range(10))
def test_iterations_converge(seed: int) -> None:
    """Each step gains five digits or more; three leave far less than a double can show."""
    s, a = geometry(seed)
    truth = converged_range(s, a)
    errors = [abs(geometric_range(s, a, k) - truth) for k in ("none", "rotate_once", "exact")]
    assert errors[0] < 45
    assert errors[1] < errors[0] * mpf("2e-6")
    assert errors[2] < errors[1] * mpf("4e-12")
    assert errors[2] < mpf("1e-15")


@pytest.mark.parametrize("seed", range(5))
def test_satellite_may_be_turned_instead(seed: int) -> None:
    """Turning the satellite back, as textbooks do, meets the same light-time condition."""
    s, a = geometry(seed)
    distance = converged_range(s, a)
    angle = exact(ROTATION_RATE) * distance / exact(LIGHT_SPEED)
    turned = sandwich(about("z", -angle), s)
    assert abs(length(subtract(turned, a)) - distance) < mpf("1e-40")


def test_terms_of_the_pseudorange() -> None:
    """Clocks, delays and residual, in either unit of the receiver's clock."""
    s, a = geometry(1)
    c = exact(LIGHT_SPEED)
    q = {
        "position": vector(a, "ecef"),
        "satellite_position": vector(s, "ecef"),
        "satellite_clock": vector([mpf("3e-5")]),
        "troposphere": vector([mpf("2.5")]),
        "ionosphere": vector([mpf("-4.25")]),
        "clock_bias": vector([mpf(100)]),
        "measured": vector([mpf("2.3e7")]),
    }
    expected = length(subtract(s, a)) + 100 - c * mpf("3e-5") - mpf("1.75")
    outputs = pseudorange.value(q, {"sagnac": "none"})
    assert abs(outputs["value"][0] - expected) < mpf("1e-41")
    assert abs(outputs["residual"][0] - (mpf("2.3e7") - expected)) < mpf("1e-41")
    q["clock_bias"] = vector([100 / c])
    seconds = pseudorange.value(q, {"sagnac": "none", "clock_unit": "s"})["value"][0]
    assert abs(seconds - expected) < mpf("1e-41")
    q["clock_bias"]["unit"] = "s"
    assert pseudorange.value(q, {"sagnac": "none"})["value"][0] == seconds


def test_antenna_in_any_frame() -> None:
    """In the navigation frame or carried to the Earth beforehand, it is one antenna."""
    rng = Random(2)
    s, origin = geometry(2)
    to_earth, attitude = quaternion(rng), quaternion(rng)
    p, arm = numbers(rng, 3, 1000), numbers(rng, 3, 5)
    q = {
        "position": vector(p, "n"),
        "attitude": {"wxyz": attitude, "maps": ("b", "n")},
        "lever_arm": vector(arm, "b"),
        "origin": vector(origin, "ecef"),
        "nav_to_ecef": {"wxyz": to_earth, "maps": ("n", "ecef")},
        "satellite_position": vector(s, "ecef"),
    }
    expected = add(origin, sandwich(to_earth, add(p, sandwich(attitude, arm))))
    assert far(pseudorange.antenna(q, {}), expected) < mpf("1e-41")
    earth_fixed = {**q, "position": vector(sandwich(to_earth, p), "ecef")}
    assert far(pseudorange.antenna(earth_fixed, {}), expected) < mpf("1e-41")
    llh = [number(rng), number(rng), number(rng, 1000)]
    geodetic = {"position": {"llh": llh, "frame": "ecef"}}
    assert far(pseudorange.antenna(geodetic, {}), ecef(llh)) == 0


@pytest.mark.parametrize("seed", range(5))
def test_relative_model(seed: int) -> None:
    """Reference range plus difference is the range, also with a rounded r0."""
    rng = Random(seed)
    s, p0 = geometry(seed)
    attitude = {"wxyz": quaternion(rng), "maps": ("b", "ecef")}
    x, arm = numbers(rng, 3, 3e4), numbers(rng, 3, 5)
    shared = {
        "attitude": attitude,
        "lever_arm": vector(arm, "b"),
        "clock_bias": vector([mpf(7)]),
    }
    d = subtract(s, p0)
    difference = pseudorange_relative.value(
        {
            **shared,
            "offset": vector(x, "ecef"),
            "satellite_difference": vector(d, "ecef"),
            "satellite_xy": vector(s[:2]),
            "reference_range": vector([mpf(float(length(d)))]),
        },
        {},
    )["value"][0]
    body = {"position": vector(add(p0, x), "ecef"), "satellite_position": vector(s, "ecef")}
    full = pseudorange.value({**shared, **body}, {"sagnac": "first_order"})["value"][0]
    at_reference = geometric_range(s, p0, "first_order")
    assert abs(at_reference + difference - full) < mpf("1e-41")


def test_relative_model_wants_its_own_range() -> None:
    """A reference range that does not belong to the satellite is refused."""
    s, p0 = geometry(1)
    q = {
        "offset": vector([mpf(1)] * 3, "ecef"),
        "satellite_difference": vector(subtract(s, p0), "ecef"),
        "satellite_xy": vector(s[:2]),
        "reference_range": vector([length(s)]),
    }
    with pytest.raises(ValueError, match="reference_range"):
        pseudorange_relative.value(q, {})


@pytest.mark.parametrize("n", [1, 2, 3, 6])
def test_single_differences(n: int) -> None:
    """A common clock vanishes and the covariance is the propagated one, for any reference."""
    rng = Random(n)
    for ref in range(n):
        rows = pseudorange.difference_matrix(n, ref)
        assert [sum(row) for row in rows] == [0] * (n - 1)
        assert all(row[ref] == -1 for row in rows)
        assert [row.index(1) for row in rows] == [i for i in range(n) if i != ref]
        sigmas = [1 + abs(number(rng)) for _ in range(n)]
        diagonal = [s**2 if i == j else mpf(0) for i, s in enumerate(sigmas) for j in range(n)]
        covariance = [
            v for row in pseudorange.single_difference_covariance(sigmas, ref) for v in row
        ]
        assert len(covariance) == (n - 1) ** 2
        if n > 1:
            assert far(propagate(rows, diagonal), covariance) < mpf("1e-47")
