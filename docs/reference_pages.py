"""Writes the reference pages from what they document, so that they cannot disagree with it.

Before Sphinx looks for pages, ``_generated/`` receives the keys of a specification (from the
published JSON Schema), the model library (from its declarations), the command line (from its
help texts) and the table of rounding bounds (computed).
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import click
import rounding_table
from sphinx.application import Sphinx

from symnav.cli import main
from symnav.equations import library
from symnav.equations.model import Model, Option, Role
from symnav.spec.schema import json_schema

HERE = Path(__file__).parent
FOLDER = HERE / "_generated"

TABLES = {
    "FrameTable": "[[frame]]",
    "VectorTable": '[[state]] of kind = "vector"',
    "ScalarTable": '[[state]] of kind = "scalar"',
    "RotationTable": '[[state]] of kind = "rotation"',
    "HeadingTable": '[[state]] of kind = "heading"',
    "GeodeticTable": '[[state]] of kind = "geodetic"',
    "InputTable": "[[input]]",
    "EntryTable": "[[measurement]] and [[correction]]",
}

Schema = Mapping[str, Any]


def setup(app: Sphinx) -> dict[str, bool]:
    """Registers the writer."""
    app.connect("builder-inited", lambda _app: write_pages())
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def write_pages() -> None:
    """Writes every page whose text has changed."""
    pages: dict[str, Callable[[], Iterable[str]]] = {
        "specification.md": lambda: specification(json_schema()),
        "library.md": lambda: model_library(library()),
        "command_line.md": command_line,
        "rounding_table.md": lambda: table(rounding_table.HEADINGS, rounding_table.rows()),
    }
    FOLDER.mkdir(exist_ok=True)
    for name, page in pages.items():
        text = "\n".join(page()) + "\n"
        file = FOLDER / name
        if not file.is_file() or file.read_text(encoding="utf-8") != text:
            file.write_text(text, encoding="utf-8")


def table(headings: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """A Markdown table."""
    yield "| " + " | ".join(headings) + " |"
    yield "|" + "---|" * len(headings)
    for row in rows:
        yield "| " + " | ".join(cell.replace("|", r"\|").replace("\n", " ") for cell in row) + " |"
    yield ""


def code(value: object) -> str:
    """Inline code, empty when there is nothing to show."""
    return f"`{value}`" if str(value) else ""


def specification(schema: Schema) -> Iterator[str]:
    """The keys of a specification, table by table."""
    yield from ("# Keys of a specification", "")
    yield "The same as a JSON Schema for editors: `docs/spec.schema.json`. Bindings and options of"
    yield "a measurement or correction are the quantities and options of its model, see"
    yield "[the model library](library.md)."
    yield from ("", "## Top level", "", *keys(schema))
    for name, heading in TABLES.items():
        definition = schema["$defs"][name]
        yield from (f"## `{heading}`", "", definition.get("description", ""), "")
        yield from keys(definition)


def keys(schema: Schema) -> Iterator[str]:
    """The table of one object's keys."""
    required = schema.get("required", ())
    rows = [
        (code(key), kind(entry), default(entry, key in required), entry.get("description", ""))
        for key, entry in schema["properties"].items()
        if not holds_tables(entry)
    ]
    yield from table(("key", "value", "default", "meaning"), rows)


def holds_tables(entry: Schema) -> bool:
    """Whether a key stands for tables, which have sections of their own."""
    return not {"$ref", "oneOf"}.isdisjoint(entry.get("items", ()))


def default(entry: Schema, required: bool) -> str:
    """The default in words."""
    if required:
        return "required"
    value = entry.get("default")
    return "" if value in (None, "", [], {}) else code(json.dumps(value))


def kind(entry: Schema) -> str:
    """What may stand as a value, in words."""
    if "enum" in entry:
        return ", ".join(code(json.dumps(value)) for value in entry["enum"])
    if "const" in entry:
        return code(json.dumps(entry["const"]))
    if "anyOf" in entry:
        return unique(kind(choice) for choice in entry["anyOf"] if choice.get("type") != "null")
    if entry.get("type") == "array":
        return f"list of {kind(entry['items'])}" if "items" in entry else "list"
    if entry.get("type") == "object":
        return "table"
    found = entry.get("type", "any")
    return found if isinstance(found, str) else " or ".join(found)


def unique(words: Iterable[str]) -> str:
    """Alternatives without repetition."""
    return " or ".join(dict.fromkeys(words))


def model_library(models: Mapping[str, Model]) -> Iterator[str]:
    """Every model with its quantities and options."""
    yield from ("# The model library", "")
    yield "Each quantity of a model binds to a state block, an input, a constant or, where it is"
    yield "optional, `none`. Frames are roles here: binding gives them the names of your frames."
    yield ""
    for model in models.values():
        yield from (f"## {model.name}", "", f"{model.title}.", "", "```text", model.equation, "```")
        items = " It is evaluated per item." if model.mapped else ""
        precision = " It is always in double precision." if model.always_double else ""
        yield from ("", f"A {model.section}.{items}{precision} Source: {model.source}.", "")
        yield from table(
            ("quantity", "kind", "unit", "frame", "meaning"), map(role_row, model.roles)
        )
        if model.options:
            yield from table(("option", "choices", "meaning"), map(option_row, model.options))


def role_row(role: Role) -> tuple[str, ...]:
    """One quantity of a model."""
    size = "" if role.size == 1 else f" [{role.size}]"
    per_item = ", per item" if role.item else ""
    optional = ", optional" if role.optional else ""
    return (
        code(role.name),
        f"{role.kind}{size}{per_item}{optional}",
        " or ".join(code(unit) for unit in role.units),
        code(role.frame),
        role.description,
    )


def option_row(option: Option) -> tuple[str, ...]:
    """One choice of a model; the default is named first."""
    rest = [choice for choice in option.choices if choice != option.default]
    return code(option.name), ", ".join(map(code, (option.default, *rest))), option.description


def command_line() -> Iterator[str]:
    """The help of every verb."""
    yield from ("# The command line", "", *help_of("symnav", main))
    for name, command in sorted(main.commands.items()):
        yield from (f"## {name}", "", *help_of(f"symnav {name}", command))


def help_of(path: str, command: click.Command) -> Iterator[str]:
    """A command's help as the terminal shows it."""
    context = click.Context(command, info_name=path, max_content_width=88, terminal_width=88)
    yield from ("```text", command.get_help(context), "```", "")
