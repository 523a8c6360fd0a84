"""Position of a GNSS antenna, and what a receiver's fix needs before it is compared with it.

``gnss_position`` covers warpos ``GPSMeasurements<N>`` (observer attitude), the GPS update of
ekf_cal (lever arm, heading and antenna calibrated online) and their generalisations.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from symnav import units
from symnav.equations.bound import Bound, Covariance, Results, let, resolve_in
from symnav.equations.model import Model, OptionValue, Role, choice, point, rotation, vector
from symnav.frames import earth
from symnav.quantities import Quantity, elementwise, rotate, total

ARM = vector("lever_arm", "m", "body", 100.0, "Antenna from the body origin, in the body frame.",
             optional=True)  # fmt: skip


def gnss_position(q: Bound) -> Quantity:
    """Z = origin + C (offset + p + R l)."""
    p = q.vector("position")
    arm = q.optional("lever_arm")
    if arm is not None:
        arm = resolve_in(p.frame, arm, q.rotation("attitude"), q.level_of("position"))
    antenna = total(p, arm, q.optional("offset"))
    observer = q.rotation("observer_attitude") or q.rotation("heading")
    if observer is not None:
        antenna = rotate(observer, let("antenna", antenna), "observed")
    return total(antenna, q.optional("origin"))


def gnss_position_to_state_frame(q: Bound) -> Results:
    """pos_B_F__F = R_F_REF pos_GPS_I__REF - pos_F_I__F - R_F_B pos_GPS_B__B, and its covariance."""
    observer = q.rotation("observer_attitude")
    fix = q.vector("receiver_position")
    if observer is not None:
        fix = rotate(observer, fix, "fix")
    origin, arm = q.optional("origin_offset"), q.optional("lever_arm")
    if arm is not None:
        fix = fix - resolve_in(fix.frame, arm, q.rotation("attitude"))
    if origin is not None:
        fix = fix - origin
    covariances = {}
    if q.has("covariance"):
        covariances["value_covariance"] = Covariance("receiver_position", q.vector("covariance"))
    return Results({"value": fix}, covariances=covariances)


def local_from_geodetic(q: Bound) -> Results:
    """Local-level position of a geodetic fix at a reference, by differences that do not cancel.

    With dL = L - L0 and dl = l - l0, every difference is formed from sin(dL/2) and sin(dl/2), so
    that metres between nearby points keep all their digits.
    """
    lat, lon, height = q.geodetic("fix")
    lat0, lon0, height0 = q.geodetic("reference")
    metre = q.constant("m", 1.0)

    def sine(name: str, angle: Quantity) -> Quantity:
        return elementwise(name, sp.sin, angle, units.ONE)

    def cosine(name: str, angle: Quantity) -> Quantity:
        return elementwise(name, sp.cos, angle, units.ONE)

    half_lat = let("half_latitude_change", 0.5 * (lat - lat0))
    half_lon = let("half_longitude_change", 0.5 * (lon - lon0))
    mean = let("mean_latitude", 0.5 * (lat + lat0))
    s_half, s_mean, c_mean = sine("s_half", half_lat), sine("s_mean", mean), cosine("c_mean", mean)
    s0, c0 = sine("sin_reference", lat0), cosine("cos_reference", lat0)
    s, c = sine("sin_latitude", lat), cosine("cos_latitude", lat)
    e2 = earth.ECCENTRICITY_SQUARED
    one = q.constant("1", 1.0)
    w = _root("w", one - let("w_deficit", e2 * (s * s)))
    w0 = _root("w_reference", one - let("w_reference_deficit", e2 * (s0 * s0)))
    normal = let("normal", _over(earth.SEMI_MAJOR_AXIS * metre, w, "inverse_w"))
    # N - N0 = a e2 sin(L + L0) sin(L - L0) / (w w0 (w + w0)), by doubling both half angles.
    c_half = cosine("c_half", half_lat)
    doubled = let("sine_product", (s_mean * c_mean) * (s_half * c_half))
    below = let("w_product", (w * w0) * (w + w0))
    change_normal = let(
        "normal_change",
        _over((4.0 * e2 * earth.SEMI_MAJOR_AXIS) * (doubled * metre), below, "inverse_w_product"),
    )
    climb = let("height_change", height - height0)
    axis_distance = let("axis_distance", (normal + height) * c)
    outward = let(
        "outward", (change_normal + climb) * c0 - 2.0 * ((normal + height) * (s_mean * s_half))
    )
    s_half_lon, c_half_lon = sine("s_half_lon", half_lon), cosine("c_half_lon", half_lon)
    sagitta = let("sagitta", axis_distance * (s_half_lon * s_half_lon))
    inward = let("inward", outward - 2.0 * sagitta)
    polar = let("polar_normal", (1.0 - e2) * normal + height)
    rise = let(
        "rise", 2.0 * (polar * (c_mean * s_half)) + ((1.0 - e2) * change_normal + climb) * s0
    )
    north = let("north", rise * c0 - inward * s0)
    east = let("east", 2.0 * (axis_distance * (s_half_lon * c_half_lon)))
    up = let("up", inward * c0 + rise * s0)
    level = q.frames["level"]
    order = (north, east, -up) if q.options["axes"] == "ned" else (east, north, up)
    elements = tuple(element for part in order for element in part.elements)
    local = Quantity(q.graph, elements, units.parse("m"), level)
    heading = q.rotation("heading")
    if heading is not None:
        local = rotate(heading, let("level_position", local), "local")
    covariances = {}
    if q.has("covariance"):
        covariances["value_covariance"] = Covariance("fix", q.vector("covariance"))
    return Results({"value": local}, covariances=covariances)


def _root(name: str, square: Quantity) -> Quantity:
    return elementwise(name, sp.sqrt, let(f"{name}_squared", square), units.ONE)


def _over(numerator: Quantity, denominator: Quantity, name: str) -> Quantity:
    inverse = elementwise(name, lambda d: 1 / d, denominator, units.ONE)
    return numerator * inverse


def _position_conventions(options: Mapping[str, OptionValue]) -> tuple[str, ...]:
    return (
        "The lever arm points from the body origin to the antenna, resolved in the body frame.",
        "C and R are used in the direction their declared maps and the frames of the vectors need.",
    )


def _position_frames(
    known: Mapping[str, str], axes: Mapping[str, str], level: str | None
) -> Mapping[str, str]:
    """The attitude is that in the state's frame, or in the local level of a geodetic position."""
    if level is not None:
        return {"nav": level}
    return {"nav": known["state"]} if "state" in known else {}


def _one_observer(
    options: Mapping[str, OptionValue], bound: frozenset[str]
) -> tuple[tuple[str, str], ...]:
    if {"observer_attitude", "heading"} <= bound:
        return (("heading", "bind observer_attitude or heading, not both"),)
    return ()


def _local_conventions(options: Mapping[str, OptionValue]) -> tuple[str, ...]:
    return (
        "Latitude and longitude in radians on WGS-84; the Jacobian by the fix, when asked for, is "
        "by latitude, longitude and height: the map of their noise.",
        f"Local-level axes are {options['axes']} at the reference.",
    )


def _mixed(name: str, description: str) -> Role:
    return Role(name, "geodetic", 3, "1", "", False, False, 0.0, 0.0, False, False, description)


COVARIANCE = vector("covariance", "m^2", "", 1e12, "Covariance of the fix, row-major.",
                    size=9, optional=True)  # fmt: skip

MODELS = (
    Model(
        name="gnss_position",
        section="measurement",
        title="Position of a GNSS antenna",
        equation="z = origin + C (offset + p + R l)",
        source="WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering",
        roles=(
            point("position", "state", 1e7, "Position of the body origin."),
            rotation("attitude", "body -> nav", "R, attitude of the body.", optional=True),
            ARM,
            vector("offset", "m", "state", 1e7, "Position of the state frame's origin seen from "
                   "the observer's, in the state frame (pos_F_I__F).", optional=True),
            rotation("observer_attitude", "state -> observer", "C, attitude of the observer's "
                     "frame.", optional=True),
            rotation("heading", "state -> observer", "C, heading of the local frame.",
                     optional=True),
            vector("origin", "m", "observer", 1e7, "Position of the local frame's origin in the "
                   "observer's frame (p_L^G).", optional=True),
        ),
        options=(),
        mapped=False,
        always_double=False,
        function=gnss_position,
        frame_rule=_position_frames,
        conventions=_position_conventions,
        check=_one_observer,
    ),
    Model(
        name="gnss_position_to_state_frame",
        section="measurement",
        title="Receiver position transformed to the state's frame and origin",
        equation="pos_B_F__F = R_F_REF pos_GPS_I__REF - pos_F_I__F - R_F_B pos_GPS_B__B",
        source="WarpTwin GPSMeasurements documentation, note on the measurement",
        roles=(
            vector("receiver_position", "m", "reference", 1e9, "Fix of the receiver in its "
                   "reporting frame (pos_GPS_I__REF)."),
            rotation("observer_attitude", "reference -> state", "Attitude of the state frame with "
                     "respect to the reporting frame (quat_F_REF).", optional=True),
            vector("origin_offset", "m", "state", 1e9, "Origin of the state frame from the "
                   "reporting frame's, in the state frame (pos_F_I__F).", optional=True),
            rotation("attitude", "body -> state", "Attitude of the body (quat_F_B).",
                     optional=True),
            ARM,
            COVARIANCE,
        ),
        options=(),
        mapped=False,
        always_double=False,
        function=gnss_position_to_state_frame,
        differentiated=("receiver_position",),
        conventions=lambda _options: (
            "The covariance leaves out the uncertainty of the attitude that rotates the lever arm; "
            "where the attitude is estimated, prefer gnss_position with a lever arm.",
        ),
    ),
    Model(
        name="local_from_geodetic",
        section="measurement",
        title="Local-level position of a geodetic fix",
        equation="p = C_e^n(reference) (ecef(fix) - ecef(reference))",
        source="Groves 2013, section 2.4; NIMA TR8350.2",
        roles=(
            _mixed("fix", "Latitude, longitude, height of the fix."),
            _mixed("reference", "Latitude, longitude, height of the local origin."),
            rotation("heading", "level -> local", "Heading of the local frame.", optional=True),
            vector("covariance", "1", "", 1e12, "Covariance of latitude, longitude (rad^2), "
                   "height (m^2), row-major.", size=9, optional=True),
        ),
        options=(choice("axes", ("enu", "ned"), "Local-level axes."),),
        mapped=False,
        always_double=True,
        function=local_from_geodetic,
        differentiated=("fix",),
        conventions=_local_conventions,
    ),
)  # fmt: skip
