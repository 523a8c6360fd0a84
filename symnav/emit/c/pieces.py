"""Small records that templates lay out: fields, structures, parameters and routines."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable
from dataclasses import dataclass

from symnav.emit.c import comments


@dataclass(frozen=True, slots=True)
class Field:
    """One member of a structure; ``length`` is empty for a scalar."""

    type: str
    name: str
    length: str = ""
    remark: str = ""

    @property
    def lines(self) -> list[str]:
        """The declaration."""
        size = f"[{self.length.removeprefix('1 * ')}]" if self.length else ""
        return comments.code(f"{self.type} {self.name}{size};", remark=self.remark)


@dataclass(frozen=True, slots=True)
class Struct:
    """A structure type; one without fields is not emitted and nothing refers to it."""

    name: str
    brief: str
    fields: tuple[Field, ...]

    @property
    def comment(self) -> list[str]:
        """What it is for."""
        return comments.block(self.brief, mark="/**")

    def __bool__(self) -> bool:
        return bool(self.fields)


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of an entry point.

    Attributes:
        declaration: as it stands in the prototype.
        name: identifier.
        pointer: True when it must not be null.
        direction: ``in`` or ``out``.
        text: what the documentation says about it.
    """

    declaration: str
    name: str
    pointer: bool
    direction: str
    text: str


@dataclass(frozen=True, slots=True)
class Routine:
    """A function local to a file: what it is for, its head and its body."""

    brief: str
    head: tuple[str, ...]
    body: tuple[str, ...]

    @property
    def comment(self) -> list[str]:
        """What it is for."""
        return comments.block(self.brief)


def head(result: str, name: str, declarations: Iterable[str]) -> tuple[str, ...]:
    """A function head on one line, or one parameter a line."""
    listed = tuple(declarations) or ("void",)
    whole = f"{result} {name}({', '.join(listed)})"
    if len(whole) <= comments.WIDTH:
        return (whole,)
    *front, last = listed
    lines = [line for one in front for line in _indented(f"{one},")]
    return (f"{result} {name}(", *lines, *_indented(f"{last})"))


def _indented(declaration: str) -> list[str]:
    """A parameter on a line of its own, or on two where its size is long."""
    return textwrap.wrap(
        declaration,
        width=comments.WIDTH - 1,  # a prototype ends in a semicolon
        initial_indent="    ",
        subsequent_indent="        ",
        break_long_words=False,
        break_on_hyphens=False,
    )


def call(name: str, arguments: Iterable[str]) -> str:
    """A function call."""
    return f"{name}({', '.join(arguments)})"
