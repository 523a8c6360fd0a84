"""A receiver's fix brought to the body's reference point, resolved in the state's frame.

value = R_F<-REF receiver_position - origin_offset - R_F<-B lever_arm, as the documentation of the
WarpTwin measurement asks of its caller; the covariance of the fix turns with it.
"""

from .algebra import (
    Options,
    Outputs,
    Quantities,
    Vector,
    far_end,
    images,
    propagate,
    subtract,
    turn,
)
from .gnss_position import lever_in


def value(q: Quantities, options: Options) -> Outputs:
    """Give the position measured in the state frame and, if one is bound, its covariance."""
    form = options.get("quaternion", "homogeneous")
    fix = q["receiver_position"]
    reference = fix.get("frame")

    def turned(vector: Vector) -> Vector:
        if "observer_attitude" not in q:
            return vector
        return turn(q["observer_attitude"], vector, reference, form)

    state = far_end(q["observer_attitude"], reference) if "observer_attitude" in q else reference
    total = turned(list(fix["value"]))
    if "origin_offset" in q:
        total = subtract(total, q["origin_offset"]["value"])
    if "lever_arm" in q:
        arm, reached = lever_in(q, state, form)
        if state is not None and reached != state:
            raise ValueError(f"the lever arm arrives in {reached!r}, the state is in {state!r}")
        total = subtract(total, arm)
    outputs = {"value": total}
    if "covariance" in q:
        outputs["covariance"] = propagate(images(turned), q["covariance"]["value"])
    return outputs
