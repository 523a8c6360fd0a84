"""WGS-84 and the Earth's rotation: constants as published, geometry from the ellipse itself.

The meridian ellipse is walked by the reduced latitude, so neither radius of curvature appears in
the coordinates; the radii come out of the geometry (distance from the axis, speed along the
meridian) when they are needed.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from mpmath import mp, mpf

from .algebra import (
    Quantities,
    Vector,
    about,
    conjugate,
    derivative,
    exact,
    images,
    length,
    multiply,
    sandwich,
    transpose,
)

SEMI_MAJOR_AXIS = Fraction(6378137)
FLATTENING = 1 / Fraction("298.257223563")
ROTATION_RATE = Fraction("7.2921151467e-5")
LIGHT_SPEED = Fraction(299792458)


def ecef(llh: Sequence[mpf]) -> Vector:
    """Give the Cartesian position: a foot point on the ellipse, the height along its normal."""
    latitude, longitude, height = llh
    a = exact(SEMI_MAJOR_AXIS)
    flattening = exact(FLATTENING)
    reduced = mp.atan2((1 - flattening) * mp.sin(latitude), mp.cos(latitude))
    from_axis = a * mp.cos(reduced) + height * mp.cos(latitude)
    from_equator = a * (1 - flattening) * mp.sin(reduced) + height * mp.sin(latitude)
    return sandwich(about("z", longitude), [from_axis, mpf(0), from_equator])


def to_enu(llh: Sequence[mpf], vector: Sequence[mpf]) -> Vector:
    """Resolve an Earth-fixed vector along east, north and up, by two turns of the axes."""
    latitude, longitude = llh[0], llh[1]
    axes = multiply(about("z", longitude + mp.pi / 2), about("x", mp.pi / 2 - latitude))
    return sandwich(conjugate(axes), vector)


def to_local(llh: Sequence[mpf], vector: Sequence[mpf], axes: str) -> Vector:
    """Resolve an Earth-fixed vector along ``enu`` or ``ned`` axes at a geodetic position."""
    east, north, up = to_enu(llh, vector)
    if axes == "enu":
        return [east, north, up]
    if axes == "ned":
        return [north, east, -up]
    raise ValueError(f"axes must be 'enu' or 'ned', not {axes!r}")


def local_level(position: Mapping[str, Any]) -> dict[str, Any]:
    """Give the attitude of the local-level axes at a geodetic position."""
    llh, axes = position["llh"], position["axes"]
    rows = images(lambda vector: to_local(llh, vector, axes))
    matrix = [entry for row in transpose(rows) for entry in row]
    return {"matrix": matrix, "maps": (position["level"], position.get("frame") or "ecef")}


def with_local_level(q: Quantities) -> Quantities:
    """Give the quantities, a geodetic position bringing the attitude of its local-level axes.

    One that is bound already is left as it is.
    """
    if "nav_to_ecef" in q or "axes" not in q.get("position", {}):
        return q
    return {**q, "nav_to_ecef": local_level(q["position"])}


def northward_speed(llh: Sequence[mpf]) -> mpf:
    """Give the metres moved per radian of latitude (M + h), from the speed of the point itself."""
    longitude, height = llh[1], llh[2]
    rows = derivative(lambda moving: ecef([moving[0], longitude, height]), [llh[0]])
    return length([row[0] for row in rows])


def eastward_speed(llh: Sequence[mpf]) -> mpf:
    """Give the metres moved per radian of longitude: (N + h) cos L, the distance from the axis."""
    x, y, _ = ecef(llh)
    return mp.hypot(x, y)


def wrap(angle: mpf) -> mpf:
    """Bring an angle into (-pi, pi]."""
    turns = mp.ceil(angle / (2 * mp.pi) - mpf(1) / 2)
    return angle - 2 * mp.pi * turns
