"""Lines of code a reviewer reads: functions laid out by one rule, whoever printed them.

Printers that never wrap have lines of a thousand characters, which no reviewer reads as one. So
all functions are formatted by clang-format in one style before blank lines and comments are left
out and the rest is counted.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path

_COMMENTS = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)

STYLE = (
    "{BasedOnStyle: LLVM, Language: Cpp, ColumnLimit: 100, IndentWidth: 4, "
    "ContinuationIndentWidth: 4, AllowShortFunctionsOnASingleLine: None, "
    "AllowShortBlocksOnASingleLine: Never, AllowShortIfStatementsOnASingleLine: Never, "
    "AllowShortLoopsOnASingleLine: false, BreakBeforeBraces: Linux}"
)
"""Width and indentation of symnav's own C; parameters are packed on as few lines as they fit."""


def lines_of_code(text: str, functions: Iterable[str]) -> int:
    """Lines of the definitions of some functions, from their heads to their closing braces.

    Args:
        text: C or C++ source.
        functions: names; one that the text only declares, or does not know, has no lines.

    Raises:
        SystemExit: when clang-format is not installed.
    """
    bare = _COMMENTS.sub("", text)
    definitions = (_definition(bare, name) for name in functions)
    laid_out = _formatted("\n\n".join(filter(None, definitions)))
    return sum(1 for line in laid_out.splitlines() if line.strip())


def _formatted(text: str) -> str:
    """The text in the common style; lines the author had broken are joined where they fit."""
    joined = re.sub(r"\n\s*\n", "\n", text)
    command = [_clang_format(), f"--style={STYLE}", "--assume-filename=functions.cpp"]
    done = subprocess.run(command, input=joined, capture_output=True, text=True, check=True)
    return done.stdout


@cache
def _clang_format() -> str:
    """The program of the package clang-format beside this Python, or whichever there is."""
    beside = str(Path(sys.executable).parent)
    found = shutil.which("clang-format", path=beside) or shutil.which("clang-format")
    if found is None:
        raise SystemExit("lines of code need clang-format: pip install clang-format")
    return found


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
