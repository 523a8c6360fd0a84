"""The stages from a table to a specification; TOML and Python end in the same ``from_table``.

Reading (``reading``) gives typed tables; ``declarations`` frames and blocks; ``bindings`` what
each quantity is bound to; ``inputs`` the frames of every entry and every input in full; ``user``
the user's own equations; ``entries`` the last checks. Every stage records mistakes and goes on, so
that all of them are reported at once.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from symnav import naming
from symnav.equations import library
from symnav.equations.model import Model
from symnav.errors import InputError, Problem, SpecError
from symnav.layout import Layout
from symnav.naming import Use
from symnav.spec import inputs as stage
from symnav.spec.bindings import Bound, Known, bind
from symnav.spec.canonical import canonical_text
from symnav.spec.declarations import (
    Names,
    check_error_frames,
    declared_frames,
    state_blocks,
)
from symnav.spec.entries import (
    Draft,
    check,
    entry,
    library_draft,
    measured_input,
    ordered_scalars,
    residual_name,
    try_out,
)
from symnav.spec.problems import Problems, choices, suggestion
from symnav.spec.reading import Row, Tables, read
from symnav.spec.records import Entry, Input, Spec
from symnav.spec.schema import EntryTable
from symnav.spec.trial import Scope
from symnav.spec.user import make
from symnav.spec.writing import as_toml


def load(path: Path) -> Spec:
    """Read a specification from a TOML file.

    Raises:
        InputError: when the file cannot be read.
        SpecError: when it has mistakes; all of them are listed.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise InputError(f"{path} cannot be read: {reason}; give the path of a TOML file") from None
    except UnicodeDecodeError as error:
        raise SpecError([Problem("", f"not UTF-8 text: {error.reason}")], str(path)) from None
    return loads(text, str(path))


def loads(text: str, source: str = "specification") -> Spec:
    """Read a specification from TOML text.

    Raises:
        SpecError: when it has mistakes; all of them are listed.
    """
    try:
        table = tomllib.loads(text.removeprefix("\ufeff"))  # some editors lead with a mark
    except tomllib.TOMLDecodeError as error:
        raise SpecError([Problem("", f"not TOML: {error}")], source) from None
    except RecursionError:
        raise SpecError([Problem("", "not TOML: nested too deeply")], source) from None
    return from_table(table, source)


def from_table(
    table: Mapping[str, Any],
    source: str = "specification",
    models: Mapping[str, Model] | None = None,
) -> Spec:
    """Validate a table, whatever it was read from.

    Args:
        table: as TOML gives it; an ``equation`` may also be a Python function.
        source: name of the file, for messages.
        models: model library; that of symnav unless another is given.

    Raises:
        SpecError: when it has mistakes; all of them are listed.
    """
    problems = Problems()
    tables = read(table, problems)
    stages = _Stages(tables, models if models is not None else library(), problems)
    return replace(stages.run(source), toml=as_toml(table))


Found = tuple[str, Row, Bound | None]


class _Stages:
    """The stages after reading, and what they share."""

    def __init__(self, tables: Tables, models: Mapping[str, Model], problems: Problems) -> None:
        self.tables = tables
        self.models = models
        self.problems = problems
        self.frames = declared_frames(tables, problems)
        self.names = Names(problems)
        self.states = state_blocks(tables, self.frames, self.names)
        self.declared = {
            row.table.name: row
            for row in tables.inputs
            if self.names.give(row.table.name, Use.INPUT, f"{row.path}.name")
        }
        self.turning: frozenset[str] = frozenset()

    def run(self, source: str) -> Spec:
        """All stages in order.

        Raises:
            SpecError: after the last stage that can still find something.
        """
        known = Known(self.states, frozenset(self.declared), self.tables.broken)
        found = self._bind(known)
        scope, drafts = self._complete(found)
        self._check(drafts, scope)
        self._head(drafts)
        self.problems.raise_if_any(source)
        measured = self._measure(drafts, scope)
        self.problems.raise_if_any(source)
        return self._spec(scope, measured, drafts)

    # -- entries ---------------------------------------------------------------------------------

    def _bind(self, known: Known) -> list[Found]:
        """Every entry in order; None for user equations and for entries without a model."""
        functions: dict[str, str] = {}
        found = []
        for section, row in self.tables.entries:
            self._name_function(row, functions)
            model = self._model(section, row)
            bound = None
            if model is not None:
                bound = bind(row.table, row.path, model, known, self.problems)
            found.append((section, row, bound))
        return found

    def _name_function(self, row: Row, functions: dict[str, str]) -> None:
        name, path = row.table.name, f"{row.path}.name"
        reason = naming.fault(name, Use.FUNCTION)
        if reason is not None:
            self.problems.add(path, reason)
        other = naming.clash(name, functions)
        if other is not None:
            case = "" if other == name else " only in case"
            verb = "differs" if case else "is also the name"
            self.problems.add(
                path,
                f"{name!r} {verb}{case} {'from' if case else 'of'} {functions[other]}",
            )
        entry_point = naming.entry_point_clash(name, functions)
        for earlier in functions:
            if naming.entry_point_clash(earlier, [name]) is not None:
                entry_point = earlier
        if entry_point is not None:
            self.problems.add(path, f"{name!r} clashes with an entry point of {entry_point!r}")
        functions.setdefault(name, row.path)

    def _model(self, section: str, row: Row) -> Model | None:
        """The library's model, or None for a user equation or a mistake."""
        table: EntryTable = row.table
        if (table.model is None) == (table.equation is None):
            given = "has both a model and an equation; leave one out"
            missing = "needs either a model or an equation"
            self.problems.add(row.path, missing if table.model is None else given)
            return None
        if table.model is None:
            for key in table.__pydantic_extra__ or {}:
                hint = suggestion(key, type(table).model_fields)
                self.problems.add(
                    f"{row.path}.{key}", f"unknown key; an equation reads states and inputs by "
                    f"their own names{hint}"
                )  # fmt: skip
            return None
        for key in ("let", "unit", "frame"):
            if key in table.model_fields_set:
                self.problems.add(f"{row.path}.{key}", "goes with an equation, not with a model")
        return self._library_model(section, table.model, row)

    def _library_model(self, section: str, name: str, row: Row) -> Model | None:
        model = self.models.get(name)
        fitting = [other.name for other in self.models.values() if other.section == section]
        if model is None:
            hint = suggestion(name, self.models) or f"; choose {choices(fitting)}"
            self.problems.add(f"{row.path}.model", f"{name!r} is not a model of the library{hint}")
        elif model.section != section:
            self.problems.add(f"{row.path}.model", f"{name!r} stands in [[{model.section}]]")
        return model

    def _complete(self, found: list[Found]) -> tuple[Scope, list[Draft]]:
        """Frames, inputs, ranges and user equations; blocks are complete afterwards."""
        bounds = [bound for _, _, bound in found if bound is not None]
        maps = stage.resolve_all(bounds, self.states, self.declared, self.frames)
        inputs = self._inputs(found, stage.wanted_inputs(bounds, maps, self.states))
        uses = stage.wanted_states(bounds)
        states = {
            name: stage.with_range(block, uses.get(name, [])) for name, block in self.states.items()
        }
        paths = {row.table.name: row.path for row in self.tables.states}
        paths |= {name: row.path for name, row in self.declared.items()}
        self.turning = check_error_frames(states, inputs, paths, self.problems)
        scope = Scope(states, inputs)
        by_path = {bound.path: frames for bound, frames in zip(bounds, maps, strict=True)}
        drafts = []
        for section, row, bound in found:
            scalars = self._scalars(row.table, row.path)
            if bound is not None:
                drafts.append(library_draft(bound, row, by_path[row.path], scalars))
            elif row.table.equation is not None and row.table.model is None:
                draft = self._user_draft(section, row, scope, scalars)
                drafts += [draft] if draft is not None else []
        return scope, drafts

    def _inputs(
        self, found: list[Found], wanted: Mapping[str, list[stage.Wanted]]
    ) -> dict[str, Input]:
        """Declared inputs, then implied ones; measured values come when outputs are known."""
        for name, uses in wanted.items():
            if name not in self.declared:
                self.names.give(name, Use.INPUT, uses[0].path)
        measured = {residual_name(row.table) for _, row, _ in found}
        inputs = {}
        for name in dict.fromkeys([*self.declared, *wanted]):
            if name in measured and name not in wanted:
                continue
            row, uses = self.declared.get(name), wanted.get(name, [])
            given = stage.complete_input(name, row, uses, self.frames)
            if given is not None:
                inputs[name] = given
        return inputs

    def _user_draft(
        self, section: str, row: Row, scope: Scope, scalars: tuple[str, ...]
    ) -> Draft | None:
        made = make(row.table, section, row.path, scope, self.frames)
        if made is None:
            return None
        return Draft(
            row, made.model, made.bindings, {}, made.frames, scalars, made.outcome, made.canonical
        )

    # -- checks ----------------------------------------------------------------------------------

    def _check(self, drafts: list[Draft], scope: Scope) -> None:
        for draft in drafts:
            check(draft, scope, self.problems)
        used = self.turning.union(*(draft.inputs for draft in drafts))
        measured = {residual_name(draft.table): draft for draft in drafts}
        for name, draft in measured.items():
            if name in used or name in scope.states:
                self.problems.add(
                    f"{draft.row.path}.residual",
                    f"{name!r} would be the measured value; it has another meaning already",
                )
        complete = len(drafts) == len(self.tables.entries) and all(d.sound for d in drafts)
        roles = [role.name for draft in drafts for role in draft.model.roles]
        for name, row in self.declared.items():
            if complete and name not in used and name not in measured:
                self.problems.add(
                    f"{row.path}.name",
                    f"{name!r} is read by no measurement or correction{_remedy(name, roles)}",
                )

    def _head(self, drafts: list[Draft]) -> None:
        head = self.tables.head
        name = head.get("name")
        reason = naming.fault(name, Use.PACKAGE) if isinstance(name, str) else None
        if reason is not None:
            self.problems.add("name", reason)
        if not (self.tables.states or drafts or self.problems.found):
            self.problems.add("", "nothing to generate: no state, measurement or correction")

    def _scalars(self, table: EntryTable | None, path: str) -> tuple[str, ...]:
        """Scalar types of an entry, or of the whole specification."""
        values = self.tables.head if table is None else table.model_dump(include=_SCALAR_KEYS)
        one, several = values.get("scalar"), values.get("scalars")
        if one is not None and several is not None:
            self.problems.add(f"{path}.scalar".lstrip("."), "write scalar or scalars, not both")
        if one is None and several is None:
            return ordered_scalars(()) if table is None else self._scalars(None, "")
        return ordered_scalars(several or [one])

    # -- the end ---------------------------------------------------------------------------------

    def _measure(self, drafts: list[Draft], scope: Scope) -> dict[str, Input]:
        """Try every equation; give residuals their inputs, which must agree under one name."""
        found: dict[str, Input] = {}
        for draft in drafts:
            outcome = try_out(draft, scope, self.problems)
            name = residual_name(draft.table)
            if name is None or outcome is None:
                continue
            path = f"{draft.row.path}.residual"
            reason = naming.fault(name, Use.INPUT)
            if reason is not None:
                self.problems.add(path, reason)
                continue
            given = measured_input(draft, outcome, self.declared.get(name), self.frames)
            if given is None:
                continue
            given = replace(given, block=replace(given.block, description="Measured value."))
            if found.setdefault(name, given) != given:
                self.problems.add(
                    path,
                    f"{name!r} is another quantity elsewhere; write residual = "
                    f"'measured_{draft.table.name}'",
                )
        return found

    def _spec(self, scope: Scope, measured: dict[str, Input], drafts: list[Draft]) -> Spec:
        entries: list[Entry] = [entry(draft) for draft in drafts]
        every = [*self._scalars(None, ""), *(s for e in entries for s in e.scalars)]
        scalars = ordered_scalars(every)
        inputs = {**scope.inputs, **measured}
        declared = tuple(self.frames.declared.values())
        head = self.tables.head
        text = canonical_text(
            head["name"], head["description"], declared, tuple(scope.states.values()), inputs,
            [(e, draft.canonical) for e, draft in zip(entries, drafts, strict=True)], scalars,
        )  # fmt: skip
        layout = Layout(tuple(scope.states.values()))
        return Spec(head["name"], declared, layout, inputs, tuple(entries), scalars, text)


def _remedy(name: str, roles: list[str]) -> str:
    """What to do about an input that nothing reads."""
    if name in roles:
        return f"; write {name} = {name!r} where it is wanted, or leave it out"
    return suggestion(name, roles) or "; leave it out"


_SCALAR_KEYS = {"scalar", "scalars"}
