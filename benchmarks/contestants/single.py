"""From double to single precision: what a user has to do to C that was written for doubles."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from benchmarks.contestants.contestant import Contestant

_NUMBER = re.compile(r"(?<![\w.])((?:\d+\.\d*|\.\d+)(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+)(?![\w.])")
_CALL = re.compile(r"\b(sqrt|sin|cos|tan|asin|acos|atan|atan2|exp|log|fabs|fmin|fmax)\(")
_INCLUDE = re.compile(r'^#include "([^"]+)"$', re.MULTILINE)


def mended_text(text: str) -> str:
    """C whose type, literals and calls of the mathematics library are those of floats."""
    text = re.sub(r"\bdouble\b", "float", text)
    return _CALL.sub(r"\1f(", _NUMBER.sub(r"\1F", text))


def mended(contestant: Contestant, name: str = "") -> Contestant:
    """The same contestant in single precision, with every file it includes from its folders."""
    candidate = contestant.candidate
    source = mended_text(inlined(candidate.source, candidate.include))
    changed = replace(candidate, source=source, include=(), name=name or candidate.name)
    return replace(contestant, candidate=changed)


def inlined(source: str, folders: Sequence[Path]) -> str:
    """A translation unit with the contents of the files it includes from the folders."""

    def content(found: re.Match[str]) -> str:
        for folder in folders:
            file = folder / found.group(1)
            if file.is_file():
                return inlined(file.read_text(encoding="utf-8"), folders)
        return found.group(0)

    return _INCLUDE.sub(content, source)
