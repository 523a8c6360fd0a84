"""Retract and local: how an error moves a stored value, and what error lies between two.

rotation
    ``right``, ``left``, ``left_negative``, ``right_negative``: the rotation vector of a turn on
    that side of the *stored* rotation, with that sign; ``rotation_vector``: added to the stored
    rotation's own; ``storage``: added to the four components.
heading
    Added and wrapped into (-pi, pi].
geodetic
    Metres along ``ned`` or ``enu`` axes, divided by the radii at the nominal position.
vector, scalar
    Added; with ``rotation`` and ``frames`` resolved in another frame than the block.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpf

from .algebra import (
    Vector,
    add,
    conjugate,
    dot,
    exponential,
    far_end,
    logarithm,
    multiply,
    scale,
    subtract,
    turn,
)
from .earth import eastward_speed, northward_speed, wrap

SIGNS = {"right": 1, "left": 1, "right_negative": -1, "left_negative": -1}
ERROR_SIGNS = {"true_minus_estimate": 1, "estimate_minus_true": -1}


@dataclass(frozen=True)
class Setting:
    """What retract and local need to know of a block beyond its kind and convention.

    Attributes:
        storage: Order of a quaternion's components, ``wxyz`` or ``xyzw``.
        error_sign: ``true_minus_estimate`` (retract adds) or ``estimate_minus_true`` (retract
            subtracts), for the additive kinds: vector, scalar and heading.
        rotation: Rotation item between the frame of a vector and the frame of its error.
        frames: Frame of the vector's error and frame of the vector, where they differ.
    """

    storage: str = "wxyz"
    error_sign: str = "true_minus_estimate"
    rotation: Mapping[str, Any] | None = None
    frames: tuple[str, str] | None = None


def scalar_first(q: Sequence[mpf], storage: str) -> Vector:
    """Bring stored components into the order w, x, y, z."""
    return [q[storage.index(part)] for part in "wxyz"]


def stored(q: Sequence[mpf], storage: str) -> Vector:
    """Bring w, x, y, z into the order of storage."""
    return [q["wxyz".index(part)] for part in storage]


def unit(q: Sequence[mpf]) -> Vector:
    """Give the quaternion of unit length."""
    return scale(1 / mp.sqrt(dot(q, q)), q)


def retract_rotation(convention: str, x: Vector, d: Vector, setting: Setting) -> Vector:
    """Move a rotation."""
    if convention == "storage":
        return add(x, d)
    q = scalar_first(x, setting.storage)
    if convention == "rotation_vector":
        moved = exponential(add(logarithm(q), d))
    else:
        step = exponential(scale(mpf(SIGNS[convention]), d))
        moved = multiply(q, step) if convention.startswith("right") else multiply(step, q)
    return stored(moved, setting.storage)


def local_rotation(convention: str, x: Vector, y: Vector, setting: Setting) -> Vector:
    """Give the error from one rotation to another."""
    if convention == "storage":
        return subtract(y, x)
    p, q = (unit(scalar_first(side, setting.storage)) for side in (x, y))
    if convention == "rotation_vector":
        return subtract(logarithm(q), logarithm(p))
    right = convention.startswith("right")
    between = multiply(conjugate(p), q) if right else multiply(q, conjugate(p))
    return scale(mpf(SIGNS[convention]), logarithm(between))


def retract_heading(convention: str, x: Vector, d: Vector, setting: Setting) -> Vector:
    """Move a heading, whatever convention its block names."""
    return [wrap(x[0] + ERROR_SIGNS[setting.error_sign] * d[0])]


def local_heading(convention: str, x: Vector, y: Vector, setting: Setting) -> Vector:
    """Give the shorter way from one heading to another."""
    return [wrap(ERROR_SIGNS[setting.error_sign] * (y[0] - x[0]))]


def retract_geodetic(convention: str, x: Vector, d: Vector, setting: Setting) -> Vector:
    """Move a geodetic position by metres along local axes."""
    north, east, down = d if convention == "ned" else (d[1], d[0], -d[2])
    return [
        x[0] + north / northward_speed(x),
        wrap(x[1] + east / eastward_speed(x)),
        x[2] - down,
    ]


def local_geodetic(convention: str, x: Vector, y: Vector, setting: Setting) -> Vector:
    """Give the metres, at the radii of ``x``, from one geodetic position to another."""
    north = (y[0] - x[0]) * northward_speed(x)
    east = wrap(y[1] - x[1]) * eastward_speed(x)
    up = y[2] - x[2]
    return [north, east, -up] if convention == "ned" else [east, north, up]


def retract_vector(convention: str, x: Vector, d: Vector, setting: Setting) -> Vector:
    """Move a vector."""
    step = d
    if setting.rotation is not None and setting.frames is not None:
        step = turn(setting.rotation, d, setting.frames[0])
    return add(x, scale(mpf(ERROR_SIGNS[setting.error_sign]), step))


def local_vector(convention: str, x: Vector, y: Vector, setting: Setting) -> Vector:
    """Give the error from one vector to another."""
    step = scale(mpf(ERROR_SIGNS[setting.error_sign]), subtract(y, x))
    if setting.rotation is not None and setting.frames is not None:
        near = setting.frames[1]
        if far_end(setting.rotation, near) != setting.frames[0]:
            raise ValueError(f"the rotation does not join the frames {setting.frames}")
        step = turn(setting.rotation, step, near)
    return step


Rule = Callable[[str, Vector, Vector, Setting], Vector]
RULES: dict[str, tuple[Rule, Rule]] = {
    "rotation": (retract_rotation, local_rotation),
    "heading": (retract_heading, local_heading),
    "geodetic": (retract_geodetic, local_geodetic),
    "vector": (retract_vector, local_vector),
    "scalar": (retract_vector, local_vector),
}


def retract(
    kind: str, convention: str, x: Sequence[mpf], d: Sequence[mpf], setting: Setting | None = None
) -> Vector:
    """Move the stored value ``x`` by the error ``d``."""
    return RULES[kind][0](convention, list(x), list(d), setting or Setting())


def local(
    kind: str, convention: str, x: Sequence[mpf], y: Sequence[mpf], setting: Setting | None = None
) -> Vector:
    """Give the error that moves the stored value ``x`` to ``y``."""
    return RULES[kind][1](convention, list(x), list(y), setting or Setting())
