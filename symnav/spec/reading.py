"""First stage: the raw table to typed tables, each row on its own so that every mistake shows.

A row that cannot be read is left out, and its name is remembered, so that no later stage complains
about a name that the user did declare.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar, get_args

from symnav.spec.problems import Problems, choices, suggestion
from symnav.spec.schema import (
    SECTIONS,
    STATE_TABLES,
    EntryTable,
    FrameTable,
    InputTable,
    RotationTable,
    ScalarTable,
    SpecTable,
    StateTable,
    Table,
    ValidationError,
)

#: Why a key that exists elsewhere does not belong here.
_MISPLACED: Mapping[tuple[type[Table], str], str] = {
    (RotationTable, "range"): "a rotation has no range: norm_tolerance bounds its elements",
    (RotationTable, "unit"): "a rotation has no unit",
    (RotationTable, "frame"): "a rotation is between two frames; write maps = 'b -> n'",
    (ScalarTable, "frame"): "a scalar has no frame",
    (ScalarTable, "size"): "a scalar has one element; use kind = 'vector' for more",
}

AnyTable = TypeVar("AnyTable", bound=Table)


@dataclass(frozen=True)
class Row:
    """One readable table of a list and where it stands."""

    path: str
    table: Any


@dataclass(frozen=True)
class Tables:
    """What could be read.

    Attributes:
        head: name, description and scalar types.
        frames: declared frames.
        states: state blocks, in order.
        inputs: declared inputs.
        entries: (section, row) of measurements, then corrections.
        broken: names of rows that could not be read.
    """

    head: Mapping[str, Any]
    frames: tuple[Row, ...]
    states: tuple[Row, ...]
    inputs: tuple[Row, ...]
    entries: tuple[tuple[str, Row], ...]
    broken: frozenset[str]


@dataclass
class _Reader:
    problems: Problems
    broken: set[str] = field(default_factory=set)

    def rows(self, raw: Mapping[str, Any], section: str) -> tuple[Row, ...]:
        """The readable rows of one section."""
        listed = raw.get(section, [])
        if isinstance(listed, Mapping):
            self.problems.add(section, f"is a single table; write [[{section}]]")
            listed = [listed]
        if not isinstance(listed, Sequence) or isinstance(listed, str):
            self.problems.add(section, f"is not a list of tables; write [[{section}]]")
            return ()
        rows = []
        for index, item in enumerate(listed):
            path = f"{section}[{index}]"
            table = self._row(item, section, path)
            if table is not None:
                rows.append(Row(path, table))
            elif isinstance(item, Mapping) and isinstance(item.get("name"), str):
                self.broken.add(item["name"])
        return tuple(rows)

    def _row(self, item: object, section: str, path: str) -> Table | None:
        if not isinstance(item, Mapping):
            self.problems.add(path, f"{item!r} is not a table")
            return None
        if section != "state":
            return read_table(SECTIONS[section], item, path, self.problems)
        kind = item.get("kind")
        if kind is None:
            self.problems.add(f"{path}.kind", f"is missing; choose {choices(STATE_TABLES)}")
            return None
        if not isinstance(kind, str) or kind not in STATE_TABLES:
            hint = suggestion(kind, STATE_TABLES) if isinstance(kind, str) else ""
            allowed = choices(STATE_TABLES)
            self.problems.add(f"{path}.kind", f"{kind!r} is not a kind; choose {allowed}{hint}")
            return None
        return read_table(STATE_TABLES[kind], item, path, self.problems)


def read(raw: Mapping[str, Any], problems: Problems) -> Tables:
    """Read every table of a specification."""
    known = tuple(SpecTable.model_fields)
    for key in raw:
        if key not in known:
            hint = suggestion(str(key), known) or f"; known: {', '.join(known)}"
            problems.add(str(key), f"unknown key{hint}")
    sections = ("frame", "state", "input", "measurement", "correction")
    head = {key: value for key, value in raw.items() if key in known and key not in sections}
    table = read_table(SpecTable, head, "", problems)
    reader = _Reader(problems)
    rows = {section: reader.rows(raw, section) for section in sections}
    entries = [(s, row) for s in ("measurement", "correction") for row in rows[s]]
    return Tables(
        table.model_dump() if table is not None else {},
        rows["frame"],
        rows["state"],
        rows["input"],
        tuple(entries),
        frozenset(reader.broken),
    )


def read_table(
    kind: type[AnyTable], raw: Mapping[str, Any], path: str, problems: Problems
) -> AnyTable | None:
    """One table, or None when its problems were recorded."""
    try:
        return kind.model_validate(dict(raw))
    except ValidationError as error:
        for detail in error.errors(include_url=False):
            place = _join(path, detail["loc"])
            problems.add(place, _message(kind, detail))
        return None


def _join(path: str, location: Sequence[int | str]) -> str:
    for step in location:
        path += f"[{step}]" if isinstance(step, int) else f".{step}" if path else step
    return path


def _message(kind: type[Table], detail: Mapping[str, Any]) -> str:
    """One mistake in our words: the value, what is allowed, and a suggestion."""
    key = str(detail["loc"][-1]) if detail["loc"] else ""
    value, fault = detail["input"], detail["type"]
    if fault == "missing":
        return "is missing"
    if fault == "extra_forbidden":
        known = tuple(kind.model_fields)
        reason = _MISPLACED.get((kind, key))
        hint = suggestion(key, known) or f"; known: {', '.join(known)}"
        return f"unknown key; {reason}" if reason else f"unknown key{hint}"
    if fault == "literal_error":
        allowed = _allowed(kind, detail["loc"])
        hint = suggestion(value, allowed) if isinstance(value, str) else ""
        return f"{value!r} is not allowed; choose {choices(allowed)}{hint}"
    if fault == "value_error":
        return str(detail["ctx"]["error"])
    if fault == "greater_than_equal":
        return f"{value!r} is below the least value {detail['ctx']['ge']}"
    if fault == "less_than_equal":
        return f"{value!r} is above the greatest value {detail['ctx']['le']}"
    if fault == "too_short":
        return "is empty"
    wanted = _TYPES.get(fault)
    return f"{value!r} is not {wanted}" if wanted else f"{value!r}: {detail['msg']}"


_TYPES = {
    "string_type": "text",
    "int_type": "a whole number",
    "bool_type": "true or false",
    "list_type": "a list",
    "dict_type": "a table",
}


def _allowed(kind: type[Table], location: Sequence[int | str]) -> tuple[str, ...]:
    """The words a field accepts, found in its annotation."""
    waiting: list[Any] = [kind.model_fields[str(location[0])].annotation]
    words: list[str] = []
    while waiting:
        arguments = get_args(waiting.pop())
        words += [a for a in arguments if isinstance(a, str)]
        waiting += [a for a in arguments if not isinstance(a, str)]
    return tuple(words)


__all__ = [
    "EntryTable",
    "FrameTable",
    "InputTable",
    "Row",
    "StateTable",
    "Tables",
    "read",
    "read_table",
]
