"""Lines of code a reviewer reads: what is left of functions without blank lines and comments."""

from __future__ import annotations

import re
from collections.abc import Iterable

_COMMENTS = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)


def lines_of_code(text: str, functions: Iterable[str]) -> int:
    """Lines of the definitions of some functions, from their heads to their closing braces.

    Args:
        text: C or C++ source.
        functions: names; one that the text only declares, or does not know, has no lines.
    """
    bare = _COMMENTS.sub("", text)
    definitions = (_definition(bare, name) for name in functions)
    return sum(1 for text in definitions for line in text.splitlines() if line.strip())


def _definition(text: str, name: str) -> str:
    """The text of the first definition of a function, or nothing."""
    for found in re.finditer(rf"\b{re.escape(name)}\s*\(", text):
        after = _closed(text, found.end() - 1, "()")
        if text[after:].lstrip().startswith("{"):
            return text[_start(text, found.start()) : _closed(text, text.index("{", after), "{}")]
    return ""


def _closed(text: str, opening: int, pair: str) -> int:
    """The place behind the bracket that closes the one at ``opening``."""
    depth = 0
    for place in range(opening, len(text)):
        depth += {pair[0]: 1, pair[1]: -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    return len(text)


def _start(text: str, name: int) -> int:
    """Where the head of a function starts: behind what ends before its result type."""
    before = [text.rfind(end, 0, name) + len(end) for end in (";", "}", "\n\n", '"\n', ">\n")]
    return max(0, *before)
