"""The validated specification: frozen records that the derivation reads."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from symnav.blocks import Block
from symnav.equations.model import Model, OptionValue
from symnav.layout import Layout


@dataclass(frozen=True)
class Frame:
    """A declared frame: its name and axes (``ned``, ``enu``, ``ecef`` or ``free``)."""

    name: str
    axes: str


@dataclass(frozen=True)
class Input:
    """A run-time argument, declared or implied by a model.

    Attributes:
        block: name, kind, size, unit, frame and domain, as for a state block.
        item: True when each item has its own value.
        integer: True for selectors and slots, passed as ``int32_t``.
    """

    block: Block
    item: bool = False
    integer: bool = False


@dataclass(frozen=True)
class ToState:
    """Bound to a state block."""

    block: str


@dataclass(frozen=True)
class ToInput:
    """Bound to a run-time argument of this name (shared by every function that names it)."""

    name: str


@dataclass(frozen=True)
class ToConstant:
    """Folded into the code: elements in the role's unit (a rotation as w, x, y, z)."""

    values: tuple[float, ...]


@dataclass(frozen=True)
class BySystem:
    """One scalar binding per satellite system, chosen per item by an integer input.

    Attributes:
        choices: (system name, binding) in the order of the codes 0, 1, 2 ...
        selector: name of the integer item input.
    """

    choices: tuple[tuple[str, ToState | ToInput], ...]
    selector: str


@dataclass(frozen=True)
class BySlot:
    """One element of a state block per item.

    Attributes:
        block: a vector block with as many elements as there are slots.
        slot: name of the integer item input that gives the element's index.
    """

    block: str
    slot: str


Binding = ToState | ToInput | ToConstant | BySystem | BySlot


@dataclass(frozen=True)
class Entry:
    """One measurement or correction.

    Attributes:
        name: identifier of the generated function.
        path: where it stands in the spec, for messages.
        model: from the library, or made from the user's own equation.
        bindings: by role name; roles bound to none are absent.
        options: every option of the model, defaults filled in.
        frames: frame role of the model -> name of the user's frame.
        jacobian_inputs: inputs with respect to which Jacobians are wanted as well.
        residual: True when the residual z - h is wanted (needs an input ``measured``).
        maximum: most items, for mapped models.
        items: ``skip`` or ``reject``.
        single_difference: True when the differenced form is wanted.
        column_major: True when dense Jacobians are stored by column.
        guards: ``status``, ``outer`` or ``assume``: where checks stand.
        scalars: scalar types it is emitted in, ``double`` first.
    """

    name: str
    path: str
    model: Model
    bindings: Mapping[str, Binding]
    options: Mapping[str, OptionValue]
    frames: Mapping[str, str] = field(default_factory=dict)
    jacobian_inputs: tuple[str, ...] = ()
    residual: bool = False
    maximum: int | None = None
    items: str = "skip"
    single_difference: bool = False
    column_major: bool = False
    guards: str = "status"
    scalars: tuple[str, ...] = ("double",)


@dataclass(frozen=True)
class Spec:
    """A whole specification.

    Attributes:
        name: prefix of every C symbol and name of the package.
        frames: declared frames.
        layout: the state.
        inputs: by name, declared and implied.
        entries: measurements, then corrections, each in the order of the spec.
        scalars: ``double`` and, when asked for, ``float``.
        text: canonical form of what was declared; its digest identifies the spec.
        toml: what was declared, to be read again; empty where an equation is a Python function.
    """

    name: str
    frames: tuple[Frame, ...]
    layout: Layout
    inputs: Mapping[str, Input]
    entries: tuple[Entry, ...]
    scalars: tuple[str, ...]
    text: str
    toml: str = ""


Equation = Callable[[Any], Any]
