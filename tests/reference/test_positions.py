"""The Earth's geometry and the position models, against closed forms."""

from random import Random

import pytest
from mpmath import mp, mpf

from .algebra import Vector, add, derivative, exact, sandwich, scale, subtract, transpose
from .drawing import far, number, numbers, quaternion, vector
from .earth import (
    FLATTENING,
    SEMI_MAJOR_AXIS,
    eastward_speed,
    ecef,
    northward_speed,
    to_enu,
    to_local,
    wrap,
)
from .gnss_position import value as predicted
from .gnss_position_to_state_frame import value as preprocessed
from .local_from_geodetic import value as localised
from .pseudorange import antenna


def place(rng: Random) -> Vector:
    """Draw latitude, longitude and height."""
    return [number(rng, 1.55), number(rng, 3.1), number(rng, 9000)]


def radii(latitude: mpf) -> tuple[mpf, mpf]:
    """Give the textbook radii of curvature, meridian and prime vertical."""
    f = exact(FLATTENING)
    e2 = f * (2 - f)
    w = mp.sqrt(1 - e2 * mp.sin(latitude) ** 2)
    a = exact(SEMI_MAJOR_AXIS)
    return a * (1 - e2) / w**3, a / w


@pytest.mark.parametrize("seed", range(5))
def test_ellipsoid(seed: int) -> None:
    """Coordinates and radii in their usual form."""
    latitude, longitude, height = llh = place(Random(seed))
    meridian, normal = radii(latitude)
    f = exact(FLATTENING)
    usual = [
        (normal + height) * mp.cos(latitude) * mp.cos(longitude),
        (normal + height) * mp.cos(latitude) * mp.sin(longitude),
        ((1 - f) ** 2 * normal + height) * mp.sin(latitude),
    ]
    assert far(ecef(llh), usual) < mpf("1e-42")
    assert abs(northward_speed(llh) - (meridian + height)) < mpf("1e-42")
    assert abs(eastward_speed(llh) - (normal + height) * mp.cos(latitude)) < mpf("1e-42")


@pytest.mark.parametrize("seed", range(5))
def test_local_axes(seed: int) -> None:
    """East, north and up in their usual form; latitude, longitude and height move along them."""
    rng = Random(seed)
    llh, v = place(rng), numbers(rng)
    (sl, cl), (so, co) = ((mp.sin(angle), mp.cos(angle)) for angle in llh[:2])
    rows = [[-so, co, mpf(0)], [-sl * co, -sl * so, cl], [cl * co, cl * so, sl]]
    assert far(to_enu(llh, v), [mp.fdot(row, v) for row in rows]) < mpf("1e-48")
    moves = transpose(derivative(ecef, llh))
    north, east, up = (to_local(llh, move, "ned") for move in moves)
    assert far(north, [northward_speed(llh), mpf(0), mpf(0)]) < mpf("1e-41")
    assert far(east, [mpf(0), eastward_speed(llh), mpf(0)]) < mpf("1e-41")
    assert far(up, [mpf(0), mpf(0), mpf(-1)]) < mpf("1e-41")


def test_wrap() -> None:
    """The interval is open below and closed above."""
    assert wrap(mpf("0.5")) == mpf("0.5")
    assert wrap(+mp.pi) == +mp.pi
    assert abs(wrap(-mp.pi) - mp.pi) < mpf("1e-48")
    assert abs(wrap(mpf(7)) - (7 - 2 * mp.pi)) < mpf("1e-48")
    assert abs(wrap(mpf(-10)) - (4 * mp.pi - 10)) < mpf("1e-48")


def test_reference_point_is_the_origin() -> None:
    """At the reference the value vanishes and the noise map is the diagonal of the radii."""
    llh = place(Random(3))
    q = {"geodetic": {"llh": llh}, "reference": {"llh": llh}}
    outputs = localised(q, {"axes": "ned"})
    assert far(outputs["value"], [mpf(0)] * 3) < mpf("1e-41")
    zero = mpf(0)
    diagonal = [northward_speed(llh), zero, zero, zero, eastward_speed(llh), zero, zero, zero, -1]
    assert far(outputs["noise_map"], diagonal) < mpf("1e-41")
    variances = [mpf(4), zero, zero, zero, mpf(9), zero, zero, zero, mpf(25)]
    covariance = localised({**q, "covariance": {"value": variances}}, {"axes": "ned"})["covariance"]
    expected = [c * d**2 for c, d in zip(variances, diagonal, strict=True)]
    assert far(covariance, expected) < mpf("1e-33")


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_heading_is_an_active_rotation(axis: str) -> None:
    """A quarter turn about each axis, both ways."""
    k = "xyz".index(axis)
    unit = [mpf(int(i == (k + 1) % 3)) for i in range(3)]
    turned = [mpf(int(i == (k + 2) % 3)) for i in range(3)]
    heading = {"angle": mp.pi / 2, "axis": axis, "maps": ("L", "G")}
    there = predicted({"position": vector(unit, "L"), "heading": heading}, {})["value"]
    back = predicted({"position": vector(unit, "G"), "heading": heading}, {})["value"]
    assert far(there, turned) < mpf("1e-48")
    assert far(back, scale(mpf(-1), turned)) < mpf("1e-48")


def test_unbound_quantities_disappear() -> None:
    """A position alone is the fix; each further term adds to it in its own frame."""
    rng = Random(4)
    p, o, c, arm = (numbers(rng) for _ in range(4))
    q = {"position": vector(p, "n")}
    assert predicted(q, {})["value"] == p
    q["offset"], q["origin"] = vector(o, "n"), vector(c, "n")
    assert far(predicted(q, {})["value"], add(p, o, c)) < mpf("1e-48")
    fixed = predicted({**q, "lever_arm": vector(arm, "n")}, {})["value"]
    assert far(fixed, add(p, o, c, arm)) < mpf("1e-48")
    with pytest.raises(ValueError, match="no attitude"):
        predicted({**q, "lever_arm": vector(arm, "b")}, {})


@pytest.mark.parametrize("form", ["homogeneous", "unit", "normalised"])
def test_quaternion_forms(form: str) -> None:
    """The forms agree on unit quaternions and part off the unit sphere as documented."""
    rng = Random(5)
    attitude, arm = quaternion(rng), numbers(rng)

    def arrived(q: Vector, chosen: str) -> Vector:
        return predicted(
            {
                "position": vector([mpf(0)] * 3, "n"),
                "attitude": {"wxyz": q, "maps": ("b", "n")},
                "lever_arm": vector(arm, "b"),
            },
            {"quaternion": chosen},
        )["value"]

    turned = arrived(attitude, "homogeneous")
    assert far(arrived(attitude, form), turned) < mpf("1e-48")
    longer = arrived(scale(mpf(2), attitude), form)
    expected = {
        "homogeneous": scale(mpf(4), turned),
        "unit": subtract(scale(mpf(4), turned), scale(mpf(3), arm)),
        "normalised": turned,
    }
    assert far(longer, expected[form]) < mpf("1e-47")


def test_preprocessing_inverts_prediction() -> None:
    """A fix predicted for a body, brought to the state frame, is the position of the body."""
    rng = Random(6)
    p, offset, arm = (numbers(rng) for _ in range(3))
    shared = {
        "attitude": {"wxyz": quaternion(rng), "maps": ("n", "b")},
        "observer_attitude": {"wxyz": quaternion(rng), "maps": ("n", "ref")},
        "lever_arm": vector(arm, "b"),
    }
    fix = predicted({"position": vector(p, "n"), "offset": vector(offset, "n"), **shared}, {})
    q = {
        "receiver_position": vector(fix["value"], "ref"),
        "origin_offset": vector(offset, "n"),
        **shared,
    }
    assert far(preprocessed(q, {})["value"], p) < mpf("1e-48")


def test_geodetic_position_with_a_level_attitude() -> None:
    """A lever arm on a geodetic position goes through the local-level frame."""
    rng = Random(7)
    llh, attitude, arm = place(rng), quaternion(rng), numbers(rng)
    zero = mpf(0)
    units = [[mpf(1), zero, zero], [zero, mpf(1), zero], [zero, zero, mpf(1)]]
    to_level = [to_local(llh, unit, "ned") for unit in units]
    q = {
        "position": {"llh": llh, "frame": "ecef"},
        "attitude": {"wxyz": attitude, "maps": ("b", "n")},
        "nav_to_ecef": {"matrix": [x for row in to_level for x in row], "maps": ("n", "ecef")},
        "lever_arm": vector(arm, "b"),
    }
    moved = subtract(predicted(q, {})["value"], ecef(llh))
    assert far(to_local(llh, moved, "ned"), sandwich(attitude, arm)) < mpf("1e-41")
    ranged = antenna({**q, "satellite_position": vector([mpf(2)] * 3, "ecef")}, {})
    assert far(ranged, predicted(q, {})["value"]) < mpf("1e-41")
