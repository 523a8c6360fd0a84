"""Specifications built from records, so that tests of the core need no reader of text."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from symnav import ir
from symnav.blocks import (
    Block,
    GeodeticBlock,
    HeadingBlock,
    RotationBlock,
    ScalarBlock,
    VectorBlock,
)
from symnav.derive import Derivation, derive, derive_local, derive_retract
from symnav.equations import library
from symnav.layout import Layout
from symnav.lower import casadi, sympy
from symnav.spec.records import Binding, Entry, Input, Spec, ToConstant, ToInput, ToState

Bindings = Mapping[str, str | tuple[float, ...] | Binding]
ROUTES = {"casadi": casadi.lower, "sympy": sympy.lower}


def vector(
    name: str,
    size: int = 3,
    unit: str = "m",
    frame: str = "",
    bound: float = 1e5,
    positive: bool = False,
    **more: Any,
) -> VectorBlock:
    """A vector, or a scalar where the size is one."""
    kind = ScalarBlock if size == 1 else VectorBlock
    low, high = (0.1 * bound if positive else -bound,) * size, (bound,) * size
    return kind(name, low, high, "", size=size, unit=unit, frame=frame, **more)


def rotation(
    name: str,
    maps: str = "b -> n",
    error: str = "right",
    storage: str = "wxyz",
    normalise: bool = False,
) -> RotationBlock:
    """A rotation."""
    size = 9 if storage == "dcm" else 4
    low, high = (-1.1,) * size, (1.1,) * size
    return RotationBlock(
        name, low, high, "", maps=maps, error=error, storage=storage, normalise=normalise
    )


def heading(name: str, maps: str = "L -> G", axis: str = "z") -> HeadingBlock:
    """A heading."""
    return HeadingBlock(name, (-3.15,), (3.15,), "", maps=maps, axis=axis)


def geodetic(name: str, axes: str = "ned", attitude_frame: str = "fixed") -> GeodeticBlock:
    """A geodetic position in the earth-fixed frame, local-level axes n."""
    low, high = (-1.5, -3.15, -1000.0), (1.5, 3.15, 20000.0)
    return GeodeticBlock(
        name, low, high, "", frame="ecef", error_frame="n", error_axes=axes,
        attitude_frame=attitude_frame,
    )  # fmt: skip


@dataclass(frozen=True)
class Case:
    """One model under one layout, with bindings and options.

    Attributes:
        model: name in the library.
        blocks: the state, in order.
        inputs: run-time arguments: blocks, or whole records.
        bindings: role -> block or input by name, constant, or a binding record.
        frames: frame role -> frame.
        options: those that differ from their defaults.
        entry: further attributes of the entry.
    """

    model: str
    blocks: Sequence[Block]
    inputs: Sequence[Block | Input]
    bindings: Bindings
    frames: Mapping[str, str]
    options: Mapping[str, Any] = field(default_factory=dict)
    entry: Mapping[str, Any] = field(default_factory=dict)

    def spec(self) -> Spec:
        """The specification with this model as its only entry."""
        model = library()[self.model]
        items = {role.name for role in model.roles if role.item}
        inputs = {}
        for given in self.inputs:
            record = given if isinstance(given, Input) else Input(given)
            inputs[record.block.name] = record
        states = {block.name for block in self.blocks}
        bindings = {role: _binding(value, states) for role, value in self.bindings.items()}
        for role, binding in bindings.items():
            if isinstance(binding, ToInput) and role in items:
                inputs[binding.name] = Input(inputs[binding.name].block, item=True)
        options = {option.name: option.default for option in model.options}
        entry = Entry(
            "f", "measurement[0]", model, bindings, {**options, **self.options},
            frames=self.frames, **{"maximum": 32 if model.mapped else None, **self.entry},
        )  # fmt: skip
        return Spec("t", (), Layout(tuple(self.blocks)), inputs, (entry,), ("double",), "")


def _binding(value: str | tuple[float, ...] | Binding, states: set[str]) -> Binding:
    if isinstance(value, str):
        return ToState(value) if value in states else ToInput(value)
    if isinstance(value, tuple):
        return ToConstant(value)
    return value


def layout(*blocks: Block, inputs: Sequence[Block] = ()) -> Spec:
    """A specification without any equation."""
    declared = {block.name: Input(block) for block in inputs}
    return Spec("t", (), Layout(blocks), declared, (), ("double",), "")


def derived(spec: Spec) -> Derivation:
    """The derivation of the only entry."""
    return derive(spec, spec.entries[0], frozenset())


def lowered(spec: Spec, route: str) -> ir.Function:
    """The only entry, lowered by one route."""
    return ROUTES[route](spec, derived(spec))


def layout_functions(spec: Spec, route: str = "sympy") -> tuple[ir.Function, ir.Function]:
    """Retract and local, lowered by one route."""
    lower = ROUTES[route]
    return (
        lower(spec, derive_retract(spec, frozenset())),
        lower(spec, derive_local(spec, frozenset())),
    )


# -- the models that operation budgets and several tests share -------------------------------------


def gps() -> Case:
    """Position of an antenna: attitude and position in the state, the arm an input."""
    return Case(
        "gnss_position",
        [vector("p", frame="n"), rotation("q")],
        [vector("l", frame="b", bound=5.0)],
        {"position": "p", "attitude": "q", "lever_arm": "l"},
        {"body": "b", "nav": "n", "state": "n"},
    )


def calibrated_gps() -> Case:
    """The same with arm, heading and origin in the state."""
    blocks = [
        vector("p", frame="L"),
        rotation("q", maps="b -> L"),
        vector("l", frame="b", bound=5.0),
        vector("pL", frame="G"),
        heading("psi"),
    ]
    return Case(
        "gnss_position",
        blocks,
        [],
        {"position": "p", "attitude": "q", "lever_arm": "l", "origin": "pL", "heading": "psi"},
        {"body": "b", "nav": "L", "state": "L", "observer": "G"},
    )


def ranges(sagnac: str = "none", place: str = "ecef", **entry: Any) -> Case:
    """Pseudoranges to an antenna off the body's origin, one clock."""
    return Case(
        "pseudorange",
        [vector("p", frame=place, bound=7e6), rotation("q"), vector("b", 1)],
        [
            vector("l", frame="b", bound=5.0),
            rotation("C", maps="n -> ecef", storage="dcm"),
            vector("s", frame="ecef", bound=3e7),
        ],
        {
            "position": "p",
            "attitude": "q",
            "lever_arm": "l",
            "clock_bias": "b",
            "nav_to_ecef": "C",
            "satellite_position": "s",
        },
        {"body": "b", "nav": "n", "ecef": "ecef"},
        {"sagnac": sagnac},
        entry,
    )


def inertial(samples: int = 1, sculling: str = "harmonic", **options: Any) -> Case:
    """Specific force from increments, attitude and biases in the state."""
    return Case(
        "specific_force",
        [
            rotation("q"),
            vector("bg", unit="rad/s", frame="b", bound=0.2),
            vector("ba", unit="m/s^2", frame="b", bound=10.0),
        ],
        [
            vector("dth", 3 * samples, "rad", "b", 0.2),
            vector("dv", 3 * samples, "m/s", "b", 50.0),
            vector("dt", 1, "s", bound=0.1, positive=True),
        ],
        {
            "attitude": "q",
            "delta_theta": "dth",
            "delta_velocity": "dv",
            "dt": "dt",
            "accelerometer_bias": "ba",
            "gyro_bias": "bg",
        },
        {"body": "b", "nav": "n"},
        {"samples": samples, "sculling": sculling, **options},
    )
