"""Pseudorange from one satellite to an antenna on a body.

rho = r + b - c dt_sat + T + I, with the satellite's position Earth-fixed at the time of
transmission. What the Earth's rotation during the travel time does to r is worked out in the axes
of that time: the satellite stands still there and the *antenna* turns with the Earth, so that light
arrives where the antenna then is. The textbook turns the satellite the other way; the distance is
the same.
"""

from collections.abc import Sequence

from mpmath import mp, mpf

from .algebra import (
    Matrix,
    Options,
    Outputs,
    Quantities,
    Vector,
    about,
    add,
    exact,
    far_end,
    length,
    sandwich,
    subtract,
    turn,
)
from .earth import LIGHT_SPEED, ROTATION_RATE, ecef, with_local_level

ITERATIONS = 3


def antenna(q: Quantities, options: Options) -> Vector:
    """Give the Earth-fixed position of the antenna, p0 + C (p + R l).

    Position and lever arm are carried to the Earth separately, so that an attitude toward the
    navigation frame also serves a position that is Earth-fixed already, or geodetic:
    ``nav_to_ecef`` then is the attitude of the local-level frame.
    """
    form = options.get("quaternion", "homogeneous")
    position = q["position"]
    if "llh" in position:
        total, frame = ecef(position["llh"]), "ecef"
    else:
        frame = position.get("frame") or navigation_frame(q)
        total = to_earth(q, position["value"], frame, form)
    if "origin" in q:
        total = add(total, q["origin"]["value"])
    if "lever_arm" in q:
        total = add(total, lever_on_earth(q, frame, form))
    return total


def navigation_frame(q: Quantities) -> str:
    """Name the frame of a position that does not name its own."""
    return far_end(q["nav_to_ecef"], "ecef") if "nav_to_ecef" in q else "ecef"


def to_earth(q: Quantities, vector: Sequence[mpf], frame: str | None, form: str) -> Vector:
    """Resolve a vector along Earth-fixed axes."""
    if frame in ("ecef", None):
        return list(vector)
    return turn(q["nav_to_ecef"], vector, frame, form)


def lever_on_earth(q: Quantities, frame: str | None, form: str) -> Vector:
    """Resolve the lever arm along Earth-fixed axes, through the attitude where one is bound."""
    arm = q["lever_arm"]
    if "attitude" not in q:
        return to_earth(q, arm["value"], arm.get("frame") or frame, form)
    attitude = q["attitude"]
    body = arm.get("frame")
    if body is None and frame in attitude["maps"]:
        body = far_end(attitude, frame)
    reached = far_end(attitude, body)
    return to_earth(q, turn(attitude, arm["value"], body, form), reached, form)


def later_distance(satellite: Sequence[mpf], a: Sequence[mpf], tau: mpf) -> mpf:
    """Give the distance to where the Earth's rotation carries the antenna in the time ``tau``."""
    return length(subtract(satellite, sandwich(about("z", exact(ROTATION_RATE) * tau), a)))


def geometric_range(satellite: Sequence[mpf], a: Sequence[mpf], sagnac: str) -> mpf:
    """Give the distance travelled by the signal.

    Args:
        satellite: Earth-fixed position at transmission.
        a: Earth-fixed position of the antenna at reception.
        sagnac: ``none``; ``first_order``: the area term is added; ``rotate_once``: turned by the
            travel time of the plain distance; ``exact``: three fixed-point steps for the travel
            time, starting from that of the plain distance.
    """
    plain = length(subtract(satellite, a))
    c = exact(LIGHT_SPEED)
    if sagnac == "none":
        return plain
    if sagnac == "first_order":
        return plain + exact(ROTATION_RATE) / c * (satellite[0] * a[1] - satellite[1] * a[0])
    if sagnac not in ("rotate_once", "exact"):
        raise ValueError(f"unknown Sagnac option {sagnac!r}")
    distance = plain
    for _ in range(1 if sagnac == "rotate_once" else ITERATIONS):
        distance = later_distance(satellite, a, distance / c)
    return distance


def converged_range(satellite: Sequence[mpf], a: Sequence[mpf]) -> mpf:
    """Solve for the travel time by bisection, to full precision: the limit of ``exact``."""
    c = exact(LIGHT_SPEED)
    plain = length(subtract(satellite, a))
    early, late = plain / c / 2, 2 * plain / c
    while late - early > late * 4 * mp.eps:
        middle = (early + late) / 2
        if c * middle < later_distance(satellite, a, middle):
            early = middle
        else:
            late = middle
    return c * (early + late) / 2


def receiver_clock(q: Quantities, options: Options) -> mpf:
    """Give the receiver's clock bias in metres.

    The option ``clock_unit``, or else the quantity's own ``unit``, is ``m`` (default) or ``s``.
    """
    if "clock_bias" not in q:
        return mpf(0)
    unit = options.get("clock_unit") or q["clock_bias"].get("unit", "m")
    if unit not in ("m", "s"):
        raise ValueError(f"clock_unit must be 'm' or 's', not {unit!r}")
    bias = q["clock_bias"]["value"][0]
    return exact(LIGHT_SPEED) * bias if unit == "s" else bias


def value(q: Quantities, options: Options) -> Outputs:
    """Give the pseudorange to one satellite and, where a measured one is bound, the residual."""
    q = with_local_level(q)
    satellite = q["satellite_position"]["value"]
    total = geometric_range(satellite, antenna(q, options), options.get("sagnac", "first_order"))
    total += receiver_clock(q, options)
    if "satellite_clock" in q:
        total -= exact(LIGHT_SPEED) * q["satellite_clock"]["value"][0]
    for delay in ("troposphere", "ionosphere"):
        if delay in q:
            total += q[delay]["value"][0]
    outputs = {"value": [total]}
    if "measured" in q:
        outputs["residual"] = [q["measured"]["value"][0] - total]
    return outputs


def difference_matrix(n: int, ref: int) -> Matrix:
    """Give the matrix that subtracts item ``ref`` from the others, in ascending order."""
    others = [i for i in range(n) if i != ref]
    return [[mpf(int(j == i) - int(j == ref)) for j in range(n)] for i in others]


def single_difference_covariance(sigmas: Sequence[mpf], ref: int) -> Matrix:
    """Give the covariance of the differences: two of them share the noise of the reference."""
    others = [i for i in range(len(sigmas)) if i != ref]
    shared = sigmas[ref] ** 2
    return [[shared + (sigmas[i] ** 2 if i == j else 0) for j in others] for i in others]
