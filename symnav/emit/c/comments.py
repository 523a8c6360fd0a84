"""Text inside C comments: wrapped, and unable to end the comment."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from itertools import accumulate, repeat

WIDTH = 100

_GLUE = "\0"  # a space where a line must not break
_OPERATOR = re.compile(r" ([-+*/<?:]|<=|&&|\|\||=) ")


def harmless(text: str) -> str:
    """One line of text that neither opens nor closes a comment nor gives Doxygen a command."""
    flat = " ".join(text.split())
    return flat.replace("*/", "* /").replace("/*", "/ *").replace("\\", "/").replace("@", "(at)")


def aside(text: str) -> str:
    """A comment of one line, or nothing where there is nothing to say."""
    return f"/* {harmless(text)} */" if text.strip() else ""


def paragraph(text: str, *, lead: str = " * ", hang: str = "") -> list[str]:
    """Lines of a block comment.

    Args:
        text: words to wrap.
        lead: what every line starts with.
        hang: what lines after the first are indented by.
    """
    lines = textwrap.wrap(
        harmless(text),
        width=WIDTH - len(lead),
        subsequent_indent=hang,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return [f"{lead}{line}".rstrip() for line in lines]


def tagged(tag: str, text: str) -> list[str]:
    """A Doxygen command and its text, wrapped."""
    first, *rest = paragraph(text, lead=" " * (len(tag) + 4)) or [""]
    return [f" * {tag} {first.strip()}".rstrip(), *(f" *{line[2:]}" for line in rest)]


def code(text: str, depth: int = 1, remark: str = "") -> list[str]:
    """One statement on as many lines as it needs, with a remark after it or above it."""
    indent = "    " * depth
    lines = _broken(text, indent)
    note = aside(remark)
    if not note:
        return lines
    if len(lines) == 1 and len(lines[0]) + 2 + len(note) <= WIDTH:
        return [f"{lines[0]}  {note}"]
    return [*(f"{indent}{line}" for line in block(remark, WIDTH - len(indent))), *lines]


def block(text: str, width: int = WIDTH, mark: str = "/*") -> list[str]:
    """A comment on as many lines as it needs."""
    lead = len(mark) + 1
    lines = textwrap.wrap(harmless(text), width=width - lead - 3)
    lines[0] = f"{mark} {lines[0]}"
    lines[-1] = f"{lines[-1]} */"
    return [lines[0], *(" " * lead + line for line in lines[1:])]


def fitted(text: str) -> str:
    """A rendered file with the statements that long names made too long broken like the others."""
    lines: list[str] = []
    for line in text.splitlines():
        indent = line[: len(line) - len(line.lstrip())]
        breakable = len(line) > WIDTH and not line.lstrip().startswith(("#", "/*", "*"))
        lines += _broken(line.strip(), indent) if breakable else [line]
    return "\n".join(lines) + "\n"


def _broken(text: str, indent: str) -> list[str]:
    """Break a statement at its outermost operators and commas, and inside only where it must."""
    if len(indent) + len(text) <= WIDTH:
        return [indent + text]
    # In front of an operator no line ends.
    glued = _OPERATOR.sub(lambda match: _GLUE + match.group(1) + " ", text)
    depths = _depths(glued)
    lines: list[str] = []
    for depth in range(max(depths) + 1):
        lines = textwrap.wrap(
            _glued(glued, depths, depth),
            width=WIDTH,
            initial_indent=indent,
            subsequent_indent=indent + "    ",
            break_long_words=False,
            break_on_hyphens=False,
        )
        if all(len(line) <= WIDTH for line in lines):
            break
    return [line.replace(_GLUE, " ") for line in lines]


def _glued(text: str, depths: Sequence[int], deepest: int) -> str:
    """The text with the spaces made unbreakable that are nested deeper than a depth."""
    characters = list(text)
    start = text.find(" ")
    while start >= 0:
        if depths[start] > deepest:
            characters[start] = _GLUE
        start = text.find(" ", start + 1)
    return "".join(characters)


_NESTING = {"(": 1, "[": 99, "]": -99, ")": -1}


def _depths(text: str) -> list[int]:
    """How many parentheses are open at every character; an index counts as very deep."""
    return list(accumulate(map(_NESTING.get, text, repeat(0))))
