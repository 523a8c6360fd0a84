"""``docs/trace.csv``: from every equation to the lines of C that compute its results.

One row for every structural non-zero of every output, every guard, every input element where it is
read and, where that is another statement, every input element where its range is checked, each with
the line where its statement begins. Elements without a row are zero by structure.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator
from dataclasses import astuple, dataclass, fields

from symnav import ir
from symnav.emit import c
from symnav.emit.c.header import Section
from symnav.emit.c.kernel import OUTPUT_POINTER, SHARED_POINTER, Kernel, entry_label
from symnav.export.building.build_files import border_path, kernel_path
from symnav.export.records import Bundle, Tree

PATH = "docs/trace.csv"

_RESULT = re.compile(rf"(?:{OUTPUT_POINTER}|{SHARED_POINTER})->(\w+)\[(\d+)\] = ")
_GUARD = re.compile(r"const bool \w+ = is_within\(")
_CONDITION = re.compile(r"\b(?:is|are_\w+)_(?:centred|within)\(([^()]*)\)")
_JUDGED = re.compile(r"(?:bool )?inside = ")
# Elements of an epoch are a stride apart; where there is one epoch that is one.
_INPUT = re.compile(
    r"(?:outside \|= \w+\(|\w+->[\w\[\]]+ = |const \w+ \w+ = \w+->)"
    r"(\w+)\[(?:(\d+)(?: \* [\w>-]*stride)?|[\w>-]*stride)\][,;]"
)


@dataclass(frozen=True, slots=True)
class Row:
    """One row of the table; the fields are its columns.

    Attributes:
        kind: ``output``, ``guard``, ``input`` or ``range``.
        function: C symbol.
        element: of the dense output or of the argument, counted from 0, per item where mapped.
        meaning: in words.
        equation: in plain text, on one line.
        source: where the equation comes from.
        file: path inside the bundle.
        line: where the statement begins, counted from 1.
        statement: the C.
    """

    kind: str
    function: str
    element: str
    meaning: str
    equation: str
    source: str
    file: str
    line: int
    statement: str


@dataclass(frozen=True, slots=True)
class _Statement:
    """A statement of a kernel and where it begins."""

    line: int
    text: str


def rows(bundle: Bundle) -> list[Row]:
    """The whole table, by tree and function in the order of the headers."""
    return [
        row
        for tree in bundle.trees
        for section in c.sections(tree.module)
        for row in _rows(tree, section)
    ]


def table(bundle: Bundle) -> str:
    """The table as CSV with a head."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(field.name for field in fields(Row))
    writer.writerows(astuple(row) for row in rows(bundle))
    return stream.getvalue()


def _rows(tree: Tree, section: Section) -> Iterator[Row]:
    function = section.kernel.function
    path = kernel_path(tree, function.name)
    statements = list(_statements(tree.files[path]))
    equation = " ; ".join(line.strip() for line in function.equation.splitlines() if line.strip())
    places = (
        *_outputs(function, statements),
        *_guards(function, statements),
        *_inputs(function, statements),
        *_ranges(section.kernel, statements),
    )
    listed = [(path, place) for place in places]
    if function.checks_at_border:
        border = border_path(tree, function.name)
        statements = list(_statements(tree.files[border]))
        places = (*_inputs(function, statements), *_ranges(section.kernel, statements))
        listed += [(border, place) for place in places]
    for file, (kind, element, meaning, statement) in listed:
        yield Row(
            kind, section.kernel.symbol, element, meaning, equation, function.source, file,
            statement.line, statement.text,
        )  # fmt: skip


_Place = tuple[str, str, str, _Statement]


def _outputs(function: ir.Function, statements: list[_Statement]) -> Iterator[_Place]:
    found = {
        (match[1], int(match[2])): statement
        for statement in statements
        if (match := _RESULT.match(statement.text))
    }
    for output in function.outputs:
        for position, entry in enumerate(output.entries):
            index = "".join(f"[{_index(step)}]" for step in entry.index)
            meaning = f"{output.name}: {entry_label(output, entry) or output.description}"
            yield "output", f"{output.name}{index}", meaning, found[output.name, position]


def _index(index: int | ir.Offset) -> str:
    if isinstance(index, ir.Offset):
        return f"{index.base} + {index.slot.argument}"
    return str(index)


def _guards(function: ir.Function, statements: list[_Statement]) -> Iterator[_Place]:
    checks = [s for s in (*function.shared, *function.item) if isinstance(s, ir.Check)]
    found = [statement for statement in statements if _GUARD.match(statement.text)]
    if not function.checks_domain:
        return
    for check, statement in zip(checks, found, strict=True):
        meaning = f"{check.comment or check.target} within {check.lower!r} to {check.upper!r}"
        yield "guard", f"{check.status.name} {check.target}", meaning, statement


def _inputs(function: ir.Function, statements: list[_Statement]) -> Iterator[_Place]:
    known = {argument.name: argument for argument in function.arguments}
    for statement in statements:
        match = _INPUT.match(statement.text)
        if match and match[1] in known:
            argument, position = known[match[1]], int(match[2] or 1)
            element = f"{argument.name}[{position}]"
            yield "input", element, _meaning(argument, position), statement


def _ranges(kernel: Kernel, statements: list[_Statement]) -> Iterator[_Place]:
    """Elements that conditions judge, by their copies or where the caller keeps them."""
    judged = {
        text: element
        for element in kernel.inputs.elements
        for text in (
            kernel.inputs.place(element.load),
            f"{element.argument.name}[{element.index}]",
        )
    }
    for statement in statements:
        if not _JUDGED.match(statement.text):
            continue
        for helper in _CONDITION.finditer(statement.text):
            for text in helper[1].split(", "):
                if text in judged:
                    element = judged[text]
                    name = f"{element.argument.name}[{element.index}]"
                    yield "range", name, _meaning(element.argument, element.index), statement


def _meaning(argument: ir.Argument, position: int) -> str:
    for domain in argument.domains:
        own = position - domain.start
        if 0 <= own < domain.size:
            label = domain.labels[own] if own < len(domain.labels) and domain.size > 1 else ""
            unit = "" if domain.unit == "1" else f" [{domain.unit}]"
            return f"{domain.name} {label}".strip() + unit
    return argument.name


def _statements(text: str) -> Iterator[_Statement]:
    """Statements inside functions, on one line each, without comments."""
    waiting: list[str] = []
    first = 0
    for number, line in enumerate(_without_comments(text).splitlines(), start=1):
        bare = line.strip()
        if not line.startswith(" ") or not bare:
            waiting = []
            continue
        first = first if waiting else number
        waiting.append(bare)
        if bare.endswith((";", "{", "}")):
            yield _Statement(first, " ".join(waiting))
            waiting = []


def _without_comments(text: str) -> str:
    """The text with every comment blank, so that lines keep their numbers."""
    return re.sub(
        r"/\*.*?\*/", lambda match: re.sub(r"[^\n]", " ", match[0]), text, flags=re.DOTALL
    )
