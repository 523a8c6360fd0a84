"""Text inside C comments: wrapped, and unable to end the comment."""

from __future__ import annotations

import textwrap

WIDTH = 100


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


def code(text: str, depth: int = 1, remark: str = "") -> list[str]:
    """One statement on as many lines as it needs, with a remark after it or above it."""
    indent = "    " * depth
    lines = textwrap.wrap(
        text,
        width=WIDTH,
        initial_indent=indent,
        subsequent_indent=indent + "    ",
        break_long_words=False,
        break_on_hyphens=False,
    )
    note = aside(remark)
    if not note:
        return lines
    if len(lines) == 1 and len(lines[0]) + 2 + len(note) <= WIDTH:
        return [f"{lines[0]}  {note}"]
    return [indent + note, *lines]
