"""Position fix of an antenna on a body.

z = origin + C (offset + position + R lever_arm): R takes the lever arm into the frame of the
position, C (from the observer's attitude or a heading) takes the sum into the receiver's frame. A
geodetic position is an Earth-fixed one; ``nav_to_ecef`` then is the attitude of the local-level
frame that the body's attitude leads to. Sources: the WarpTwin GPS measurement and the ekf_cal GPS
update with on-line heading.
"""

from .algebra import Options, Outputs, Quantities, Vector, add, far_end, turn
from .earth import ecef, with_local_level


def lever_in(q: Quantities, target: str | None, form: str) -> tuple[Vector, str | None]:
    """Give the lever arm resolved outside the body, and the frame it then is resolved in.

    Args:
        q: The quantities; ``lever_arm`` must be bound, ``attitude`` may be.
        target: The frame wanted, where it is known.
        form: How a quaternion acts.
    """
    arm = q["lever_arm"]
    source = arm.get("frame")
    if "attitude" not in q:
        if None not in (source, target) and source != target:
            raise ValueError(f"no attitude takes the lever arm from {source!r} to {target!r}")
        return list(arm["value"]), target or source
    attitude = q["attitude"]
    if source is None and target in attitude["maps"]:
        source = far_end(attitude, target)
    reached = far_end(attitude, source)
    turned = turn(attitude, arm["value"], source, form)
    if target not in (None, reached) and "nav_to_ecef" in q:
        return turn(q["nav_to_ecef"], turned, reached, form), far_end(q["nav_to_ecef"], reached)
    return turned, reached


def value(q: Quantities, options: Options) -> Outputs:
    """Give the fix that an ideal receiver would report."""
    q = with_local_level(q)
    form = options.get("quaternion", "homogeneous")
    frame = q["position"].get("frame")
    geodetic = "llh" in q["position"]
    total = ecef(q["position"]["llh"]) if geodetic else list(q["position"]["value"])
    if "offset" in q:
        total = add(total, q["offset"]["value"])
    if "lever_arm" in q:
        arm, reached = lever_in(q, frame, form)
        if frame is not None and reached != frame:
            raise ValueError(f"the lever arm arrives in {reached!r}, the position is in {frame!r}")
        frame = reached
        total = add(total, arm)
    observers = [name for name in ("observer_attitude", "heading") if name in q]
    if len(observers) > 1:
        raise ValueError("an observer's attitude and a heading cannot both turn the fix")
    for name in observers:
        total = turn(q[name], total, frame, form)
    if "origin" in q:
        total = add(total, q["origin"]["value"])
    return {"value": total}
