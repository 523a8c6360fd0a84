"""How a model of the library declares itself: its quantities, its options and its equation.

A model is one function over bound quantities. The declaration says what each quantity is; the
spec says what each is bound to. Frames in a declaration are roles ("body", "nav"): binding gives
them the names of the user's frames.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

OptionValue = str | int | float | bool


@dataclass(frozen=True)
class Role:
    """A quantity an equation needs or accepts.

    Attributes:
        name: keyword in the spec.
        kind: ``vector``, ``scalar``, ``rotation``, ``orientation`` (rotation or heading),
            ``point`` (earth-fixed vector or geodetic) or ``integer``.
        size: number of elements; a string names the option that scales it (``"3*samples"``).
        unit: SI unit; a tuple lists the units accepted, the first being the default.
        frame: frame role of a vector, or the two roles a rotation connects, ``"body -> nav"``.
        optional: True when the quantity may be ``none`` (the default when the spec is silent).
        item: True when each item has its own value.
        lower: default domain of each element.
        upper: likewise.
        positive: True when the range must exclude zero (the equation divides by it).
        per_item_states: True when it may bind to one element per item or be chosen by system.
        description: one sentence.
    """

    name: str
    kind: str
    size: int | str
    unit: str | tuple[str, ...]
    frame: str
    optional: bool
    item: bool
    lower: float
    upper: float
    positive: bool
    per_item_states: bool
    description: str

    @property
    def units(self) -> tuple[str, ...]:
        """Units accepted, the default first."""
        return (self.unit,) if isinstance(self.unit, str) else self.unit

    def size_for(self, options: Mapping[str, OptionValue]) -> int:
        """Number of elements under the options of one spec entry."""
        if isinstance(self.size, int):
            return self.size
        factor, _, option = self.size.partition("*")
        return int(factor) * int(options[option])


@dataclass(frozen=True)
class Option:
    """A choice of a model.

    Attributes:
        name: keyword in the spec.
        choices: allowed values, the default first; for integers, every allowed integer.
        description: one sentence.
        default: value when the spec is silent.
    """

    name: str
    choices: tuple[OptionValue, ...]
    default: OptionValue
    description: str


@dataclass(frozen=True)
class Scene:
    """Values of one quantity that follow from the others, for the samples of a proof.

    Attributes:
        role: quantity that takes them, where it is bound to an input.
        name: what is worth testing about them, in a few words; empty for a relation that holds in
            every use of the model.
        value: over the bound quantities, like the equation itself; None where it does not apply.
    """

    role: str
    name: str
    value: Callable[[Any], Any]


@dataclass(frozen=True)
class Model:
    """An entry of the model library.

    Attributes:
        name: keyword in the spec.
        section: ``measurement`` or ``correction``: the table of the spec it may stand in.
        title: one line.
        equation: in plain text.
        source: where it comes from.
        roles: its quantities.
        options: its choices.
        mapped: True when it is evaluated per item.
        always_double: True when single precision would be refused.
        function: the equation itself, over ``Bound`` quantities, giving its results.
        conventions: sentences for headers and documentation, from the options chosen.
        check: extra rules; gives problems as (keyword, message) pairs.
        differentiated: roles the equation itself differentiates by (rates, covariance maps).
        frame_rule: completes the frames of roles that no binding decides; see ``no_rule``.
        scenes: what the samples of a proof should hold beyond ranges and edges.
        relative: model of the same relative to a reference point, which rounding moves less.
    """

    name: str
    section: str
    title: str
    equation: str
    source: str
    roles: tuple[Role, ...]
    options: tuple[Option, ...]
    mapped: bool
    always_double: bool
    function: Callable[[Any], Any]
    conventions: Callable[[Mapping[str, OptionValue]], tuple[str, ...]]
    check: Callable[[Mapping[str, OptionValue], frozenset[str]], tuple[tuple[str, str], ...]] = (
        field(default=lambda _options, _bound: ())
    )
    differentiated: tuple[str, ...] = ()
    frame_rule: Callable[[Mapping[str, str], Mapping[str, str], str | None], Mapping[str, str]] = (
        field(default=lambda known, axes, level: no_rule(known, axes, level))
    )
    scenes: tuple[Scene, ...] = ()
    relative: str = ""

    def role(self, name: str) -> Role:
        """The role of that name."""
        return next(role for role in self.roles if role.name == name)


def no_rule(
    known: Mapping[str, str], axes: Mapping[str, str], level: str | None
) -> Mapping[str, str]:
    """The frame rule of most models: nothing to add.

    Args:
        known: frame role -> name, as far as bindings decide it.
        axes: name of each declared frame -> its axes.
        level: local-level frame of a geodetic position, if one is bound.

    Returns:
        frames to add for roles that are not yet known.
    """
    return {}


def vector(
    name: str,
    unit: str | tuple[str, ...],
    frame: str,
    bound: float,
    description: str,
    *,
    size: int | str = 3,
    optional: bool = False,
    item: bool = False,
) -> Role:
    """A vector role with the default domain [-bound, bound]."""
    return Role(
        name, "vector", size, unit, frame, optional, item, -bound, bound, False, False, description
    )


def scalar(
    name: str,
    unit: str | tuple[str, ...],
    lower: float,
    upper: float,
    description: str,
    *,
    optional: bool = False,
    item: bool = False,
    positive: bool = False,
    per_item_states: bool = False,
) -> Role:
    """A scalar role with a default domain."""
    return Role(
        name, "scalar", 1, unit, "", optional, item, lower, upper, positive, per_item_states,
        description,
    )  # fmt: skip


def point(name: str, frame: str, bound: float, description: str) -> Role:
    """A position that may be a vector or a geodetic block."""
    return Role(
        name, "point", 3, "m", frame, False, False, -bound, bound, False, False, description
    )


def rotation(name: str, maps: str, description: str, *, optional: bool = False) -> Role:
    """A rotation role between two frame roles; a heading serves as well."""
    return Role(
        name, "rotation", 4, "1", maps, optional, False, -1.0, 1.0, False, False, description
    )


def choice(name: str, choices: tuple[OptionValue, ...], description: str) -> Option:
    """An option whose default is the first choice."""
    return Option(name, choices, choices[0], description)
