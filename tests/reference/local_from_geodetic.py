"""A geodetic fix in local Cartesian axes, with the map its noise goes through.

The fix and the reference point become Earth-fixed points, their difference is resolved at the
reference, and an optional heading turns the local axes further. The noise map is the derivative of
all of that toward latitude, longitude and height, found by differencing at high precision.
"""

from collections.abc import Sequence

from mpmath import mpf

from .algebra import Options, Outputs, Quantities, Vector, derivative, propagate, subtract, turn
from .earth import ecef, to_local


def local_position(llh: Sequence[mpf], q: Quantities, options: Options) -> Vector:
    """Give the local position of a geodetic one.

    A heading's direction follows from its frames: one of them must be the frame of the local axes,
    called as the axes are (``enu`` or ``ned``) or as the option ``axes_frame`` says.
    """
    axes = options.get("axes", "enu")
    reference = q["reference"]["llh"]
    vector = to_local(reference, subtract(ecef(llh), ecef(reference)), axes)
    if "heading" in q:
        vector = turn(q["heading"], vector, options.get("axes_frame", axes))
    return vector


def value(q: Quantities, options: Options) -> Outputs:
    """Give the local position, the noise map and, if one is bound, the covariance.

    The position that was measured is the quantity ``fix``, or ``geodetic``.
    """
    fix = q["fix" if "fix" in q else "geodetic"]["llh"]
    noise_map = derivative(lambda llh: local_position(llh, q, options), fix)
    outputs = {
        "value": local_position(fix, q, options),
        "noise_map": [entry for row in noise_map for entry in row],
    }
    if "covariance" in q:
        outputs["covariance"] = propagate(noise_map, q["covariance"]["value"])
    return outputs
