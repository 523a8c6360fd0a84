"""Fifth stage: measurements and corrections, checked against everything they are bound to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from symnav import naming, units
from symnav.blocks import Block, VectorBlock
from symnav.equations.bound import Results
from symnav.equations.model import Model, OptionValue, Role
from symnav.errors import EquationError
from symnav.spec.bindings import ROTATIONS, Bound, misfit
from symnav.spec.declarations import Frames
from symnav.spec.inputs import FrameMap, Wanted, complete_input
from symnav.spec.problems import Problems, suggestion
from symnav.spec.reading import Row
from symnav.spec.records import (
    Binding,
    BySlot,
    BySystem,
    Entry,
    Input,
    ToInput,
    ToState,
)
from symnav.spec.schema import EntryTable
from symnav.spec.trial import Scope, evaluate

#: Most items in one call where the specification does not say.
DEFAULT_MAXIMUM = 32
MEASURED = "measured"


@dataclass(frozen=True)
class Draft:
    """One entry, bound and resolved, before its last checks.

    Attributes:
        row: its table and where it stands.
        model: its model.
        bindings: by role.
        options: every option.
        frames: frame role -> frame.
        scalars: scalar types.
        outcome: results of a user equation; the library's are evaluated when needed.
        canonical: lines that stand for a user equation in the canonical text.
        sound: False when mistakes were found already.
    """

    row: Row
    model: Model
    bindings: Mapping[str, Binding]
    options: Mapping[str, OptionValue]
    frames: Mapping[str, str]
    scalars: tuple[str, ...]
    outcome: Results | None = None
    canonical: tuple[str, ...] = ()
    sound: bool = True

    @property
    def table(self) -> EntryTable:
        """What was declared."""
        table = self.row.table
        assert isinstance(table, EntryTable)
        return table

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of the inputs it reads, selectors and slots included."""
        names: list[str] = []
        for binding in self.bindings.values():
            if isinstance(binding, ToInput):
                names.append(binding.name)
            elif isinstance(binding, BySlot):
                names.append(binding.slot)
            elif isinstance(binding, BySystem):
                names += [c.name for _, c in binding.choices if isinstance(c, ToInput)]
                names.append(binding.selector)
        return tuple(dict.fromkeys(names))


def library_draft(bound: Bound, row: Row, frames: FrameMap, scalars: tuple[str, ...]) -> Draft:
    """An entry that uses a model of the library; its description becomes the title."""
    model = bound.model
    if row.table.description:
        model = replace(model, title=row.table.description)
    return Draft(row, model, bound.bindings, bound.options, frames, scalars, sound=bound.sound)


def check(draft: Draft, scope: Scope, problems: Problems) -> None:
    """Everything that can be said of one entry once all blocks are known."""
    path, model, table = draft.row.path, draft.model, draft.table
    for name, binding in draft.bindings.items():
        role = model.role(name)
        for block, item in _blocks(binding, scope):
            _check_fit(draft, role, block, item, problems)
        if isinstance(binding, BySlot):
            _check_slots(draft, name, binding, scope, problems)
        if isinstance(binding, BySystem):
            _check_units(draft, name, binding, scope, problems)
    if draft.sound:
        for key, message in model.check(draft.options, frozenset(draft.bindings)):
            problems.add(f"{path}.{key}", message)
    _check_jacobians(draft, scope, problems)
    if not model.mapped:
        for key, used in (
            ("maximum", table.maximum is not None),
            ("items", "items" in table.model_fields_set),
            ("difference", table.difference is not None),
        ):
            if used:
                what = f"{model.name} has no items" if table.model else "no input is per item"
                problems.add(f"{path}.{key}", f"goes with functions over items; {what}")
    elif table.difference is not None and "reference" in draft.inputs:
        problems.add(f"{path}.difference", "the input 'reference' would be named twice; rename it")
    if model.always_double and "float" in draft.scalars:
        own = "scalars" if table.scalars is not None else "scalar"
        problems.add(
            f"{path}.{own}",
            f"{model.name} needs double precision; write scalar = 'double' in this table",
        )
    for name in draft.inputs:
        other = naming.step_clash(name, ("x", *draft.inputs))
        if other is not None:
            problems.add(path, f"input {name!r} would be the batch step of {other!r}; rename it")


def _blocks(binding: Binding, scope: Scope) -> list[tuple[Block, bool | None]]:
    """Blocks a binding leads to; with the per-item flag of inputs."""
    if isinstance(binding, ToState):
        return [(scope.states[binding.block], None)]
    if isinstance(binding, ToInput):
        given = scope.inputs.get(binding.name)
        return [] if given is None or given.integer else [(given.block, given.item)]
    if isinstance(binding, BySystem):
        return [pair for _, choice in binding.choices for pair in _blocks(choice, scope)]
    return []


def _check_fit(
    draft: Draft, role: Role, block: Block, item: bool | None, problems: Problems
) -> None:
    path, name = f"{draft.row.path}.{role.name}", draft.model.name
    if not draft.table.model:
        return
    reason = misfit(role, block, draft.options)
    if reason is not None:
        problems.add(path, reason)
        return
    framed = role.frame and role.kind not in ROTATIONS and isinstance(block, VectorBlock)
    if framed and isinstance(block, VectorBlock) and not block.frame:
        frame = draft.frames[role.frame]
        problems.add(
            path, f"{block.name!r} has no frame; {name} needs one, such as frame = {frame!r}"
        )
    if item and not draft.model.mapped:
        problems.add(path, f"input {block.name!r} is per item; {name} has no items")
    zero = any(lo <= 0.0 <= hi for lo, hi in zip(block.lower, block.upper, strict=True))
    if role.positive and zero:
        problems.add(
            path,
            f"the range of {block.name!r} includes zero, by which {name} divides; declare a range "
            "without it",
        )


def _check_units(
    draft: Draft, name: str, binding: BySystem, scope: Scope, problems: Problems
) -> None:
    """The choices stand in one sum, so they have one unit."""
    found = [
        (f"{system} = {block.name!r} is in {block.units[0]!r}", units.parse(block.units[0]))
        for system, choice in binding.choices
        for block, _ in _blocks(choice, scope)
        if misfit(draft.model.role(name), block, draft.options) is None
    ]
    if len({unit for _, unit in found}) > 1:
        listed = ", ".join(words for words, _ in found)
        problems.add(f"{draft.row.path}.{name}", f"{listed}; give all systems one unit")


def _check_slots(
    draft: Draft, name: str, binding: BySlot, scope: Scope, problems: Problems
) -> None:
    block, path = scope.states[binding.block], f"{draft.row.path}.{name}"
    maximum = draft.table.maximum or DEFAULT_MAXIMUM
    if not isinstance(block, VectorBlock):
        problems.add(f"{path}.block", f"{block.name!r} is not a vector with one element per slot")
        return
    one = replace(block, size=1)
    reason = misfit(draft.model.role(name), one, draft.options)
    if reason is not None:
        problems.add(f"{path}.block", reason)
    if block.size < maximum:
        problems.add(
            f"{path}.block",
            f"{block.name!r} has {block.size} elements for up to {maximum} items; set maximum = "
            f"{block.size} or less, or make the block larger",
        )


def _check_jacobians(draft: Draft, scope: Scope, problems: Problems) -> None:
    direct = [b.name for b in draft.bindings.values() if isinstance(b, ToInput)]
    allowed = [n for n in direct if n not in scope.inputs or not scope.inputs[n].integer]
    for k, name in enumerate(draft.table.jacobians):
        path = f"{draft.row.path}.jacobians[{k}]"
        if name in scope.states:
            problems.add(path, f"{name!r} is a state block: 'jacobian' has its columns already")
        elif name not in allowed and draft.sound:
            known = f"; inputs: {', '.join(allowed)}" if allowed else "; it has no inputs"
            hint = suggestion(name, allowed) or known
            problems.add(path, f"{name!r} is not an input of {draft.table.name!r}{hint}")
        elif name in draft.table.jacobians[:k]:
            problems.add(path, f"{name!r} is listed twice")


def residual_name(table: EntryTable) -> str | None:
    """Name of the input that a residual needs, or None."""
    if isinstance(table.residual, str):
        return table.residual
    return MEASURED if table.residual else None


def try_out(draft: Draft, scope: Scope, problems: Problems) -> Results | None:
    """Evaluate the equation once, so that what it refuses is reported where it stands."""
    outcome = draft.outcome
    if outcome is None:
        try:
            outcome = evaluate(draft.model, draft.bindings, draft.options, draft.frames, scope)
        except EquationError as error:
            problems.add(draft.row.path, str(error))
            return None
    if all(e == 0 for value in outcome.outputs.values() for e in value.elements):
        key = "equation" if draft.table.equation is not None else "model"
        problems.add(f"{draft.row.path}.{key}", "the result is zero, whatever it reads")
    return outcome


def measured_input(
    draft: Draft, outcome: Results, declared: Row | None, frames: Frames
) -> Input | None:
    """The input that the residual of an entry compares its value with."""
    path = f"{draft.row.path}.residual"
    value = next(iter(outcome.outputs.values()))
    name = residual_name(draft.table)
    assert name is not None
    role = Role(
        MEASURED, "scalar" if value.size == 1 else "vector", value.size, str(value.unit),
        value.frame or "", False, draft.model.mapped, 0.0, 0.0, False, False,
        f"Measured value of {draft.table.name}.",
    )  # fmt: skip
    use = Wanted(
        path, draft.model.name, role, value.size, value.frame or "", draft.model.mapped
    )  # fmt: skip
    given = complete_input(name, declared, [use], frames)
    if given is not None:
        block = given.block
        reason = misfit(role, block, {})
        if reason is not None:
            frames.problems.add(path, reason)
        elif isinstance(block, VectorBlock) and block.frame != (value.frame or ""):
            frames.problems.add(
                path, f"{name!r} is in frame {block.frame!r}; {value.describe()} is needed"
            )
        elif given.item != draft.model.mapped:
            frames.problems.add(path, f"{name!r} is per item exactly where {draft.table.name} is")
    return given


def entry(draft: Draft) -> Entry:
    """The record that the derivation reads."""
    table, model = draft.table, draft.model
    name = residual_name(table)
    bindings = dict(draft.bindings)
    if name is not None:
        bindings[MEASURED] = ToInput(name)
    return Entry(
        name=table.name,
        path=draft.row.path,
        model=model,
        bindings=bindings,
        options=draft.options,
        frames=draft.frames,
        jacobian_inputs=tuple(table.jacobians),
        residual=name is not None,
        maximum=(table.maximum or DEFAULT_MAXIMUM) if model.mapped else None,
        items=table.items,
        single_difference=table.difference == "single",
        column_major=table.order == "column",
        guards=table.guards,
        scalars=draft.scalars,
    )


def ordered_scalars(chosen: Sequence[str]) -> tuple[str, ...]:
    """``double`` first, and always there."""
    return ("double", "float") if "float" in chosen else ("double",)


__all__ = ["Draft", "check", "entry", "library_draft", "measured_input", "residual_name", "try_out"]
