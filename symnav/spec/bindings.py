"""Third stage: what each quantity of a model is bound to, and the options of the model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from symnav import naming, units
from symnav.blocks import (
    Block,
    GeodeticBlock,
    HeadingBlock,
    RotationBlock,
    ScalarBlock,
    VectorBlock,
)
from symnav.equations.model import Model, Option, OptionValue, Role
from symnav.naming import Use
from symnav.spec.problems import Problems, choices, suggestion
from symnav.spec.records import Binding, BySlot, BySystem, ToConstant, ToInput, ToState
from symnav.spec.schema import BindingValue, EntryTable

#: Largest deviation of the squared norm of a constant quaternion from one.
QUATERNION_TOLERANCE = 1e-6

ROTATIONS = ("rotation", "orientation")


@dataclass(frozen=True)
class Known:
    """Names that a binding may mean.

    Attributes:
        states: blocks by name.
        inputs: names of declared inputs.
        broken: names whose declaration could not be read.
    """

    states: Mapping[str, Block]
    inputs: frozenset[str]
    broken: frozenset[str]

    @property
    def names(self) -> tuple[str, ...]:
        """Every name, for suggestions."""
        return (*self.states, *sorted(self.inputs))


@dataclass
class Bound:
    """The bindings of one entry as far as they could be read.

    Attributes:
        path: of the entry.
        model: its model.
        bindings: by role.
        options: every option.
        sound: False when a mistake was found, so that later checks keep quiet.
    """

    path: str
    model: Model
    bindings: dict[str, Binding] = field(default_factory=dict)
    options: dict[str, OptionValue] = field(default_factory=dict)
    sound: bool = True


def bind(table: EntryTable, path: str, model: Model, known: Known, problems: Problems) -> Bound:
    """Bind every role and option of a model of the library."""
    binder = _Binder(path, model, known, problems)
    extra: Mapping[str, BindingValue] = table.__pydantic_extra__ or {}
    binder.check_keys(extra)
    binder.bind_options(extra)
    for role in model.roles:
        binder.bind_role(role, extra.get(role.name))
    binder.imply_inputs(extra)
    return binder.result


@dataclass
class _Binder:
    path: str
    model: Model
    known: Known
    problems: Problems
    result: Bound = field(init=False)

    def __post_init__(self) -> None:
        self.result = Bound(self.path, self.model)

    def check_keys(self, extra: Iterable[str]) -> None:
        """Every key is a role, an option or a field of the table."""
        roles = tuple(role.name for role in self.model.roles)
        options = tuple(option.name for option in self.model.options)
        for key in extra:
            if key not in (*roles, *options):
                near = suggestion(key, (*roles, *options, *EntryTable.model_fields))
                listed = f"; {self.model.name} has the quantities {', '.join(roles)}" + (
                    f" and the options {', '.join(options)}" if options else ""
                )
                self._fault(key, f"unknown key{near or listed}")

    def bind_options(self, extra: Mapping[str, BindingValue]) -> None:
        """Every option: the value given, or the default."""
        for option in self.model.options:
            self.result.options[option.name] = option.default
            if option.name in extra:
                value = extra[option.name]
                if _is_choice(option, value):
                    assert isinstance(value, (str, int, float))
                    self.result.options[option.name] = value
                else:
                    near = suggestion(value, map(str, option.choices)) if isinstance(
                        value, str
                    ) else ""  # fmt: skip
                    self._fault(
                        option.name,
                        f"{value!r} is not allowed; choose {choices(option.choices)}{near}",
                    )

    def bind_role(self, role: Role, value: BindingValue | None) -> None:
        """One role; silence means none for optional roles and an input for the others."""
        if value is None:
            value = self._silent(role)
        if value is None:
            return
        if value == "none":
            if not role.optional:
                self._fault(role.name, f"{self.model.name} cannot do without it")
            return
        binding = self._binding(role, value)
        if binding is not None:
            self.result.bindings[role.name] = binding

    def imply_inputs(self, extra: Iterable[str]) -> None:
        """Optional quantities that the options make necessary become inputs, unless refused."""
        bindings, options = self.result.bindings, self.result.options
        for role in self.model.roles:
            if role.name in extra or role.name in bindings or not self.result.sound:
                continue
            missing = {key for key, _ in self.model.check(options, frozenset(bindings))}
            remedied = {
                key for key, _ in self.model.check(options, frozenset({*bindings, role.name}))
            }
            if role.name in missing - remedied:
                binding = self._named(role, "input", role.name)
                if binding is not None:
                    bindings[role.name] = binding

    def _silent(self, role: Role) -> str | None:
        if role.optional:
            return "none"
        if role.name in self.known.states:
            self._fault(
                role.name,
                f"is not bound, though a state block has this name; write {role.name} = "
                f"{role.name!r} to estimate it, or bind an input declared under another name",
            )
            return None
        return "input"

    def _binding(self, role: Role, value: BindingValue) -> Binding | None:
        if isinstance(value, str):
            return self._named(role, value, role.name)
        if isinstance(value, bool):
            self._fault(role.name, f"{value!r} is not a binding")
            return None
        if isinstance(value, dict):
            return self._table(role, value)
        values = value if isinstance(value, tuple) else (float(value),)
        return self._constant(role, values)

    def _named(self, role: Role, name: str, implied: str) -> ToState | ToInput | None:
        """A state block, a declared input, or the input that the word ``input`` implies."""
        if name == "input":
            if implied in self.known.states:
                self._fault(
                    role.name,
                    f"'input' would be named {implied!r} like a state block; declare [[input]] "
                    "with another name and bind that",
                )
                return None
            return ToInput(implied)
        if name in self.known.states:
            return self._state(role, name)
        if name in self.known.inputs:
            return ToInput(name)
        self.result.sound = False
        if name not in self.known.broken:
            self._fault(role.name, self._unknown(name))
        return None

    def _state(self, role: Role, name: str) -> ToState | None:
        if role.kind in ("integer", "geodetic"):
            self._fault(role.name, f"cannot be a state block; bind {role.name} to an input")
            return None
        return ToState(name)

    def _constant(self, role: Role, values: tuple[float, ...]) -> ToConstant | None:
        size = 4 if role.kind in ROTATIONS else role.size_for(self.result.options)
        if role.kind == "integer" or role.name in self.model.differentiated:
            self._fault(role.name, f"cannot be a constant; bind {role.name} to an input")
            return None
        if len(values) != size:
            wanted = "a quaternion w, x, y, z" if role.kind in ROTATIONS else f"{size} numbers"
            self._fault(role.name, f"{len(values)} numbers given; {wanted} needed")
            return None
        if role.kind in ROTATIONS:
            norm = sum(v * v for v in values)
            if abs(norm - 1.0) > QUATERNION_TOLERANCE:
                self._fault(role.name, f"the quaternion's squared norm is {norm:.9g}, not 1")
        if role.positive and any(v == 0.0 for v in values):
            self._fault(role.name, f"{self.model.name} divides by it; zero is not allowed")
        return ToConstant(values)

    def _table(self, role: Role, table: Mapping[str, str]) -> BySystem | BySlot | None:
        if not role.per_item_states or not self.model.mapped:
            self._fault(role.name, "cannot be chosen per item; bind one state block or input")
            return None
        if "block" in table or "slot" in table:
            return self._slot(role, table)
        options: list[tuple[str, ToState | ToInput]] = []
        for system, name in table.items():
            path = f"{role.name}.{system}"
            reason = naming.fault(system, Use.SYSTEM)
            if reason is not None:
                self._fault(path, reason)
            if naming.clash(system, (s for s, _ in options)) is not None:
                self._fault(path, f"{system!r} differs only in case from another system")
            binding = self._choice(role, path, name, system)
            if binding is not None:
                options.append((system, binding))
        return BySystem(tuple(options), "system")

    def _choice(self, role: Role, path: str, name: str, system: str) -> ToState | ToInput | None:
        if name == "none":
            self._fault(path, "a system cannot be 'none'; bind a state block or an input")
            return None
        if name != "input" and name not in (*self.known.names, *self.known.broken):
            self._fault(path, self._unknown(name))
            return None
        return self._named(role, name, f"{role.name}_{system}")

    def _slot(self, role: Role, table: Mapping[str, str]) -> BySlot | None:
        for key in table:
            if key not in ("block", "slot"):
                self._fault(f"{role.name}.{key}", "unknown key; write { block = ..., slot = ... }")
        block, slot = table.get("block", ""), table.get("slot", "slot")
        if not block:
            self._fault(f"{role.name}.block", "is missing")
            return None
        if block not in self.known.states:
            self.result.sound = False
            if block not in self.known.broken:
                near = suggestion(block, self.known.states)
                self._fault(f"{role.name}.block", f"{block!r} is not a state block{near}")
            return None
        reason = naming.fault(slot, Use.INPUT)
        if reason is not None:
            self._fault(f"{role.name}.slot", reason)
        return BySlot(block, slot)

    def _unknown(self, name: str) -> str:
        names = self.known.names
        known = f"; known: {', '.join(names)}" if names else ""
        hint = suggestion(name, names) or known
        return f"{name!r} is not a state block or a declared input{hint}"

    def _fault(self, key: str, message: str) -> None:
        self.result.sound = False
        self.problems.add(f"{self.path}.{key}", message)


def _is_choice(option: Option, value: object) -> bool:
    """True when the value is one of the choices, of the same type (1 is not True)."""
    return any(value == choice and type(value) is type(choice) for choice in option.choices)


def misfit(role: Role, block: Block, options: Mapping[str, OptionValue]) -> str | None:
    """Why a block cannot stand for a role, or None when it can; frames are checked elsewhere."""
    what = {
        VectorBlock: f"a {block.storage_size}-vector",
        ScalarBlock: "a scalar",
        RotationBlock: "a rotation",
        HeadingBlock: "a heading",
        GeodeticBlock: "a geodetic point",
    }[type(block)]
    size = role.size_for(options)
    if role.kind in ROTATIONS:
        fits, wanted = isinstance(block, (RotationBlock, HeadingBlock)), "a rotation or a heading"
    elif role.kind == "geodetic":
        fits = isinstance(block, GeodeticBlock)
        wanted = "latitude, longitude and height (kind 'geodetic')"
    elif role.kind == "point" and isinstance(block, GeodeticBlock):
        return None
    else:
        fits = isinstance(block, VectorBlock) and block.size == size
        wanted = "a scalar" if size == 1 else f"a {size}-vector"
        wanted += " or a geodetic point" if role.kind == "point" else ""
    if not fits:
        return f"{block.name!r} is {what}; {wanted} is needed"
    return _unit_misfit(role, block) if isinstance(block, VectorBlock) else None


def _unit_misfit(role: Role, block: VectorBlock) -> str | None:

    unit = units.parse(block.unit)
    if any(unit == units.parse(accepted) for accepted in role.units):
        return None
    return f"{block.name!r} is in {block.unit!r}; {choices(role.units)} is needed"
