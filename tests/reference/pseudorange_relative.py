"""Pseudorange relative to that of a reference point p0.

With d = s - p0 and the antenna at p0 + x the model is r - r0 + (w / c)(s_x x_y - s_y x_x) + db.
Here the two distances are simply subtracted, with digits to spare. ``reference_range`` is |d|,
formed by the caller in double precision to save the kernel a square root: the reference forms its
own and only checks that the caller's agrees.
"""

from mpmath import mp, mpf

from .algebra import Options, Outputs, Quantities, add, exact, length, subtract
from .earth import LIGHT_SPEED, ROTATION_RATE
from .pseudorange import lever_on_earth, navigation_frame, receiver_clock, to_earth

AGREEMENT = mpf(2) ** -22
"""Relative agreement asked of ``reference_range``: a rounding to single precision, twice over."""


def value(q: Quantities, options: Options) -> Outputs:
    """Give the pseudorange less that of the reference point, and the residual if measured.

    The place of the body relative to p0 is the quantity ``position``, or ``offset``.
    """
    form = options.get("quaternion", "homogeneous")
    offset = q["position" if "position" in q else "offset"]
    frame = offset.get("frame") or navigation_frame(q)
    x = to_earth(q, offset["value"], frame, form)
    if "lever_arm" in q:
        x = add(x, lever_on_earth(q, frame, form))
    d = q["satellite_difference"]["value"]
    with mp.extradps(20):
        r0 = length(d)
        total = length(subtract(d, x)) - r0
    if "reference_range" in q and abs(q["reference_range"]["value"][0] - r0) > AGREEMENT * r0:
        raise ValueError("reference_range is not the length of satellite_difference")
    if options.get("sagnac", "first_order") == "first_order":
        s_x, s_y = q["satellite_xy"]["value"]
        total += exact(ROTATION_RATE) / exact(LIGHT_SPEED) * (s_x * x[1] - s_y * x[0])
    elif options["sagnac"] != "none":
        raise ValueError(f"unknown Sagnac option {options['sagnac']!r}")
    total += receiver_clock(q, options)
    outputs = {"value": [total]}
    if "measured" in q:
        outputs["residual"] = [q["measured"]["value"][0] - total]
    return outputs
