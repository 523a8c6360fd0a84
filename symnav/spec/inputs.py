"""Fourth stage: frames of every entry, and every input complete.

An input may be declared in full, in part or not at all; what is left out comes from the quantity
it is bound to. Inputs share frames between entries: what one entry fixes, the others read.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from symnav.blocks import Block, GeodeticBlock, ScalarBlock, VectorBlock, frame_map
from symnav.equations.model import Role
from symnav.spec.bindings import ROTATIONS, Bound
from symnav.spec.declarations import Frames, block_of, geodetic_bounds, with_bounds
from symnav.spec.problems import Problems
from symnav.spec.reading import Row, read_table
from symnav.spec.records import BySlot, BySystem, Input, ToConstant, ToInput, ToState
from symnav.spec.resolve import Held, complete, held_by, resolve
from symnav.spec.schema import STATE_TABLES, InputTable

#: Range of a vector or scalar that neither the user nor a model bounds.
DEFAULT_RANGE = (-1e9, 1e9)

FrameMap = dict[str, str]


@dataclass(frozen=True)
class Wanted:
    """One use of an input.

    Attributes:
        path: of the binding.
        model: name of the model.
        role: the quantity it stands for.
        size: number of elements under the entry's options.
        frame: frame, or map ``"b -> n"`` for a rotation, or empty.
        item: True when the model takes one value per item.
        codes: number of codes or slots of an integer input, else 0.
        meaning: of the codes, for documentation.
    """

    path: str
    model: str
    role: Role
    size: int
    frame: str = ""
    item: bool = False
    codes: int = 0
    meaning: str = ""


# -- frames ------------------------------------------------------------------------------------


def resolve_all(
    bounds: Sequence[Bound],
    states: Mapping[str, Block],
    declared: Mapping[str, Row],
    frames: Frames,
) -> list[FrameMap]:
    """The frame of every frame role of every entry."""
    axes = {name: frame.axes for name, frame in frames.declared.items()}
    stated = {name: _declared_frames(name, row.table) for name, row in declared.items()}
    inputs = {name: held for name, held in stated.items() if held is not None}
    maps: list[FrameMap] = []
    for bound in bounds:
        _spread(bounds, states, inputs, axes)
        held = _held(bound, states, inputs)
        resolution = resolve(bound.model, held, axes)
        if bound.sound:
            for role, message in resolution.problems:
                frames.problems.add(f"{bound.path}.{role}", message)
        maps.append(complete(bound.model, held, resolution.frames, axes))
        _learn(bound, maps[-1], inputs)
    return maps


def _spread(
    bounds: Sequence[Bound],
    states: Mapping[str, Block],
    inputs: dict[str, Held],
    axes: Mapping[str, str],
) -> None:
    """Let entries tell each other the frames of the inputs they share."""
    before = -1
    while len(inputs) != before:
        before = len(inputs)
        for bound in bounds:
            resolution = resolve(bound.model, _held(bound, states, inputs), axes)
            if not resolution.problems:
                _learn(bound, resolution.frames, inputs)


def _learn(bound: Bound, frames: Mapping[str, str], inputs: dict[str, Held]) -> None:
    for name, binding in bound.bindings.items():
        if not isinstance(binding, ToInput) or binding.name in inputs:
            continue
        role, label = bound.model.role(name), f"input {binding.name!r}"
        if role.kind in ROTATIONS:
            source, target = frame_map(role.frame)
            if source in frames and target in frames:
                inputs[binding.name] = Held(label, ends=(frames[source], frames[target]))
        elif role.frame in frames:
            inputs[binding.name] = Held(label, frames[role.frame])


def _held(bound: Bound, states: Mapping[str, Block], inputs: Mapping[str, Held]) -> dict[str, Held]:
    held = {}
    for name, binding in bound.bindings.items():
        if isinstance(binding, ToState):
            held[name] = held_by(f"block {binding.block!r}", states[binding.block])
        elif isinstance(binding, ToInput):
            held[name] = inputs.get(binding.name, Held(f"input {binding.name!r}"))
        elif isinstance(binding, ToConstant):
            held[name] = Held("the constant")
    return held


def _declared_frames(name: str, table: InputTable) -> Held | None:
    """What a declared input says of its frames, or None when it leaves them open."""
    label = f"input {name!r}"
    if table.kind == "geodetic" and table.frame and table.error_frame:
        return Held(label, table.frame, level=(table.error_frame, table.frame))
    if table.maps is not None:
        parts = table.maps.partition("->")
        source, target = parts[0].strip(), parts[2].strip()
        return Held(label, ends=(source, target)) if source and target else None
    return Held(label, table.frame) if table.frame else None


# -- what is wanted of each input --------------------------------------------------------------


def wanted_inputs(
    bounds: Sequence[Bound], maps: Sequence[FrameMap], states: Mapping[str, Block]
) -> dict[str, list[Wanted]]:
    """Every use of every input, in the order of the specification."""
    wanted: dict[str, list[Wanted]] = {}
    for bound, frames in zip(bounds, maps, strict=True):
        for role in bound.model.roles:
            binding = bound.bindings.get(role.name)
            use = Wanted(
                f"{bound.path}.{role.name}", bound.model.name, role, role.size_for(bound.options),
                _role_frame(role, frames), role.item,
            )  # fmt: skip
            if isinstance(binding, ToInput):
                wanted.setdefault(binding.name, []).append(use)
            elif isinstance(binding, BySystem):
                names = [system for system, _ in binding.choices]
                meaning = ", ".join(f"{code} {name}" for code, name in enumerate(names))
                code = replace(
                    use, item=True, codes=len(names), meaning=f"Satellite system: {meaning}."
                )
                wanted.setdefault(binding.selector, []).append(code)
                for _, choice in binding.choices:
                    if isinstance(choice, ToInput):
                        wanted.setdefault(choice.name, []).append(replace(use, item=False))
            elif isinstance(binding, BySlot):
                slots = states[binding.block].storage_size
                meaning = "Slot of the item in its state blocks."
                slot = replace(use, item=True, codes=slots, meaning=meaning)
                wanted.setdefault(binding.slot, []).append(slot)
    return wanted


def _meaning(binding: BySystem) -> str:
    codes = ", ".join(f"{code} {system}" for code, (system, _) in enumerate(binding.choices))
    return f"Satellite system: {codes}."


def _role_frame(role: Role, frames: Mapping[str, str]) -> str:
    if role.kind in ROTATIONS:
        source, target = frame_map(role.frame)
        return f"{frames[source]} -> {frames[target]}"
    return frames[role.frame] if role.frame else ""


# -- completion --------------------------------------------------------------------------------


def complete_input(
    name: str, declared: Row | None, wanted: Sequence[Wanted], frames: Frames
) -> Input | None:
    """One input from its declaration and its uses, or None when that cannot be done."""
    if any(use.codes for use in wanted):
        return _integer(name, declared, wanted, frames.problems)
    if wanted and wanted[0].role.kind == "integer":
        return _integer_role(name, declared, wanted[0], frames.problems)
    table = declared.table if declared is not None else None
    first = wanted[0] if wanted else None
    path = declared.path if declared is not None else wanted[0].path
    block = _block(name, table, first, path, frames)
    if block is None:
        return None
    if not block.lower:
        block = with_bounds(block, *_hull(wanted))
    if first is not None and not block.description:
        block = replace(block, description=first.role.description)
    item = table.item if table is not None else None
    if item is None:
        item = first.item if first is not None else False
    return Input(block, item=item)


def _hull(wanted: Sequence[Wanted]) -> tuple[float, float]:
    """The widest default range among the quantities an input or block stands for."""
    roles = [use.role for use in wanted if use.role.lower < use.role.upper]
    if not roles:
        return DEFAULT_RANGE
    return min(role.lower for role in roles), max(role.upper for role in roles)


def _block(
    name: str, table: InputTable | None, use: Wanted | None, path: str, frames: Frames
) -> Block | None:
    given = _given(table)
    kind = given.pop("kind", None) or _kind(given, use)
    raw = use is not None and use.role.kind == "geodetic" and "frame" not in given
    if raw and kind == "geodetic":
        return _raw_geodetic(name, table, path, frames.problems)
    merged = {"name": name, "kind": kind, **_defaults(kind, use), **given}
    if use is not None:
        _expand_parts(merged, use)
    complete_table = read_table(STATE_TABLES[kind], merged, path, frames.problems)
    return None if complete_table is None else block_of(complete_table, path, frames)


def _given(table: InputTable | None) -> dict[str, Any]:
    """Fields that the declaration sets, in the form in which tables are read."""
    if table is None:
        return {}
    fields = table.model_dump(exclude_none=True, exclude={"item", "name"})
    if "range" in fields:
        fields["range"] = [list(pair) for pair in fields["range"]]
    return fields


def _kind(given: Mapping[str, Any], use: Wanted | None) -> str:
    """Kind of an input that does not name it."""
    if "maps" in given or (use is not None and use.role.kind in ROTATIONS):
        return "heading" if "axis" in given else "rotation"
    if use is not None and use.role.kind == "geodetic":
        return "geodetic"
    size = given.get("size", 1) if use is None else given.get("size", use.size)
    return "vector" if size > 1 or "size" in given else "scalar"


def _defaults(kind: str, use: Wanted | None) -> dict[str, Any]:
    """Fields that the quantity it stands for supplies."""
    if use is None:
        return {}
    if kind in ("rotation", "heading"):
        return {"maps": use.frame} if use.role.kind in ROTATIONS else {}
    if kind == "scalar":
        return {"unit": use.role.units[0]}
    if kind == "vector":
        return {"size": use.size, "unit": use.role.units[0], "frame": use.frame}
    return {}


def _expand_parts(fields: dict[str, Any], use: Wanted) -> None:
    """A stack of sub-samples may be declared by the size and the range of one of them."""
    if not isinstance(use.role.size, str) or fields.get("kind") != "vector":
        return
    part = int(use.role.size.partition("*")[0])
    if fields["size"] == part and use.size != part:
        fields["size"] = use.size
        if len(fields.get("range", ())) == part:
            fields["range"] = fields["range"] * (use.size // part)


def _raw_geodetic(
    name: str, table: InputTable | None, path: str, problems: Problems
) -> GeodeticBlock:
    """Latitude, longitude and height that an equation reads as they are."""
    pairs = table.range if table is not None else None
    lower, upper = geodetic_bounds(pairs, f"{path}.range", problems)
    description = table.description if table is not None else ""
    return GeodeticBlock(name, lower, upper, description, "", "")


def _integer(
    name: str, declared: Row | None, wanted: Sequence[Wanted], problems: Problems
) -> Input | None:
    """The code or slot that chooses a state per item."""
    path = declared.path if declared is not None else wanted[0].path
    others = [use for use in wanted if not use.codes]
    if declared is not None or others:
        problems.add(
            f"{path}.name" if declared is not None else others[0].path,
            f"{name!r} is the integer that chooses a state per item ({wanted[0].path}); "
            "choose another name",
        )
        return None
    for use in wanted[1:]:
        if use.meaning != wanted[0].meaning:
            problems.add(
                use.path,
                f"{name!r} means '{use.meaning}' here and '{wanted[0].meaning}' at "
                f"{wanted[0].path}; list the same systems in the same order",
            )
    last = float(min(use.codes for use in wanted) - 1)
    block = ScalarBlock(name, (0.0,), (last,), wanted[0].meaning, 1, "1")
    return Input(block, item=True, integer=True)


def _integer_role(name: str, declared: Row | None, use: Wanted, problems: Problems) -> Input | None:
    if declared is not None:
        problems.add(
            f"{declared.path}.name", f"{name!r} is an integer of {use.model}; leave it out"
        )
        return None
    role = use.role
    block = ScalarBlock(name, (role.lower,), (role.upper,), role.description, 1, "1")
    return Input(block, item=role.item, integer=True)


def with_range(block: Block, wanted: Sequence[Wanted]) -> Block:
    """A state block without a declared range takes that of the quantities it stands for."""
    if block.lower or not isinstance(block, VectorBlock):
        return block
    return with_bounds(block, *_hull(wanted))


def wanted_states(bounds: Sequence[Bound]) -> dict[str, list[Wanted]]:
    """Every quantity that each state block stands for."""
    wanted: dict[str, list[Wanted]] = {}
    for bound in bounds:
        for role in bound.model.roles:
            binding = bound.bindings.get(role.name)
            use = Wanted(f"{bound.path}.{role.name}", bound.model.name, role, 1)
            if isinstance(binding, (ToState, BySlot)):
                wanted.setdefault(binding.block, []).append(use)
            elif isinstance(binding, BySystem):
                for _, choice in binding.choices:
                    if isinstance(choice, ToState):
                        wanted.setdefault(choice.block, []).append(use)
    return wanted
