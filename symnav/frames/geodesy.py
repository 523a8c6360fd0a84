"""WGS-84 geodesy: geodetic to earth-fixed coordinates, radii of curvature, local-level axes.

Angles in radians, lengths in metres. Source: IERS Conventions and NIMA TR8350.2; the radii are
those of Groves, Principles of GNSS, Inertial and Multisensor Integrated Navigation Systems, 2.4.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from symnav.frames import earth
from symnav.graph import ONE, ZERO, Graph, Matrix, Row

NAMES = tuple(f"{i}{j}" for i in range(3) for j in range(3))


@dataclass(frozen=True)
class GeodeticTerms:
    """Named terms every geodetic formula shares.

    Attributes:
        sine_latitude: of the geodetic latitude.
        cosine_latitude: likewise.
        sine_longitude: of the longitude.
        cosine_longitude: likewise.
        normal_radius: N + h, from the earth's axis along the normal, plus height.
        meridian_radius: M + h, of the meridian ellipse, plus height.
        ecef: earth-centred earth-fixed position.
    """

    sine_latitude: sp.Expr
    cosine_latitude: sp.Expr
    sine_longitude: sp.Expr
    cosine_longitude: sp.Expr
    normal_radius: sp.Expr
    meridian_radius: sp.Expr
    ecef: Row


def geodetic_terms(graph: Graph, name: str, llh: Row, *, frozen: bool = False) -> GeodeticTerms:
    """Name the terms of the geodetic position ``llh`` = latitude, longitude, height."""
    lat, lon, height = llh
    a = sp.Float(earth.SEMI_MAJOR_AXIS, 17)
    e2 = sp.Float(earth.ECCENTRICITY_SQUARED, 17)
    one_less_e2 = sp.Float(1.0 - earth.ECCENTRICITY_SQUARED, 17)

    def define(label: str, expression: sp.Expr) -> sp.Symbol:
        return graph.define(f"{name}_{label}", [expression], frozen=frozen)[0]

    sin_lat, cos_lat = define("sin_lat", sp.sin(lat)), define("cos_lat", sp.cos(lat))
    sin_lon, cos_lon = define("sin_lon", sp.sin(lon)), define("cos_lon", sp.cos(lon))
    w2 = define("w_squared", 1 - e2 * sin_lat * sin_lat)
    w = define("w", sp.sqrt(w2))
    normal = define("normal", a / w)
    normal_height = define("normal_radius", normal + height)
    meridian_height = define("meridian_radius", normal * one_less_e2 / w2 + height)
    across = define("axis_distance", normal_height * cos_lat)
    ecef = graph.define(
        f"{name}_ecef",
        [across * cos_lon, across * sin_lon, (normal * one_less_e2 + height) * sin_lat],
        frozen=frozen,
    )
    return GeodeticTerms(sin_lat, cos_lat, sin_lon, cos_lon, normal_height, meridian_height, ecef)


def level_to_ecef(
    graph: Graph, name: str, terms: GeodeticTerms, axes: str, *, frozen: bool = False
) -> Row:
    """Nine entries of the matrix from local-level axes (``ned`` or ``enu``) to earth-fixed."""
    sl, cl = terms.sine_latitude, terms.cosine_latitude
    so, co = terms.sine_longitude, terms.cosine_longitude
    north, east, up = (-sl * co, -sl * so, cl), (-so, co, ZERO), (cl * co, cl * so, sl)
    columns = (north, east, tuple(-u for u in up)) if axes == "ned" else (east, north, up)
    entries = [columns[j][i] for i in range(3) for j in range(3)]
    return graph.define(name, entries, suffixes=NAMES, frozen=frozen)


def angles_per_metre(terms: GeodeticTerms, axes: str) -> Matrix:
    """d(latitude, longitude, height) per metre of local-level error: rows times (n, e, d)."""
    per_north = ONE / terms.meridian_radius
    per_east = ONE / (terms.normal_radius * terms.cosine_latitude)
    if axes == "ned":
        return ((per_north, ZERO, ZERO), (ZERO, per_east, ZERO), (ZERO, ZERO, -ONE))
    return ((ZERO, per_north, ZERO), (per_east, ZERO, ZERO), (ZERO, ZERO, ONE))


def metres_per_angle(terms: GeodeticTerms, axes: str) -> Matrix:
    """Metres of local-level axes per change of (latitude, longitude, height)."""
    north = terms.meridian_radius
    east = terms.normal_radius * terms.cosine_latitude
    if axes == "ned":
        return ((north, ZERO, ZERO), (ZERO, east, ZERO), (ZERO, ZERO, -ONE))
    return ((ZERO, east, ZERO), (north, ZERO, ZERO), (ZERO, ZERO, ONE))


def transport_rotation(terms: GeodeticTerms, axes: str) -> Matrix:
    """Rotation vector, in local-level axes, of those axes per metre of position error.

    Moving east by dE turns the north-east-down axes by dE/(N+h) about north and by
    -dE tan(L)/(N+h) about down; moving north by dN turns them by -dN/(M+h) about east.
    """
    per_north = ONE / terms.meridian_radius
    per_east = ONE / terms.normal_radius
    tangent = terms.sine_latitude / (terms.normal_radius * terms.cosine_latitude)
    if axes == "ned":
        return ((ZERO, per_east, ZERO), (-per_north, ZERO, ZERO), (ZERO, -tangent, ZERO))
    return ((ZERO, -per_north, ZERO), (per_east, ZERO, ZERO), (tangent, ZERO, ZERO))
