"""Python source laid out: data on as few lines as fit, expressions wrapped, comments placed."""

from __future__ import annotations

import json
import math
import re
import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from decimal import Decimal

from symnav.figures import readable

WIDTH = 100
_INDENT = "    "
_GLUE = "\N{NO-BREAK SPACE}"


@dataclass(frozen=True, slots=True)
class Group:
    """Something in brackets: a call or a tuple of parts."""

    head: str
    parts: tuple[Piece, ...]

    def __str__(self) -> str:
        comma = "," if self.head == "(" and len(self.parts) == 1 else ""
        return f"{self.head}{', '.join(map(str, self.parts))}{comma})"


Piece = str | Group


def call(name: str, *parts: Piece) -> Group:
    """A call."""
    return Group(f"{name}(", parts)


def tuple_of(parts: Iterable[Piece]) -> Group:
    """A tuple."""
    return Group("(", tuple(parts))


def strings(values: Iterable[str]) -> Piece:
    """A tuple of strings."""
    return tuple_of([quoted(value) for value in values])


def literal(value: float) -> str:
    """A float, as short as it goes; infinity by its name in ``math``."""
    text = repr(float(value)).replace("inf", "math.inf")
    if not math.isfinite(value):
        return text
    scientific = f"{Decimal(text).normalize():E}".lower().replace("e+", "e")
    return scientific if len(scientific) < len(text) else text


def numbers(values: Sequence[float]) -> Piece:
    """A tuple of floats, equal ones said once."""
    texts = [literal(value) for value in values]
    if len(texts) > 1 and len(set(texts)) == 1:
        return f"({texts[0]},) * {len(texts)}"
    return tuple_of(texts)


def integers(values: Sequence[int]) -> Piece:
    """A tuple of integers, a run said by its ends."""
    if len(values) > 3 and list(values) == list(range(values[0], values[-1] + 1)):
        start = f"{values[0]}, " if values[0] else ""
        return f"tuple(range({start}{values[-1] + 1}))"
    return tuple_of([str(value) for value in values])


def quoted(value: str) -> str:
    """A string literal on one line, in double quotes."""
    return json.dumps(value, ensure_ascii=False)


def docstring(lines: Sequence[str], depth: int = 0) -> list[str]:
    """Lines of a docstring, quotes included; nothing in them ends it early."""
    indent = _INDENT * depth
    safe = [line.replace("\\", "\\\\").replace('"' * 3, "'" * 3) for line in lines]
    first, *rest = safe
    room = " " if first.endswith('"') else ""
    lines = [f'"""{first}', *rest, '"""'] if rest else [f'"""{first}{room}"""']
    return [f"{indent}{line}".rstrip() for line in lines]


def lay_out(piece: Piece, *, before: str = "", after: str = "", depth: int = 0) -> list[str]:
    """Lines of a piece of data between a beginning and an end."""
    indent = _INDENT * depth
    line = f"{indent}{before}{piece}{after}"
    if len(line) <= WIDTH:
        return [line]
    if isinstance(piece, str):
        return wrapped(before + piece, depth, after) if " " in piece else [line]
    texts = [str(part) for part in piece.parts]
    single = f"{indent}{_INDENT}{', '.join(texts)}"
    if len(single) <= WIDTH and len(texts) > 1:
        inner = [single]
    elif len(texts) > 8 and not any(" " in text or '"' in text for text in texts):
        inner = _filled(", ".join(texts) + ",", depth + 1)
    else:
        inner = [text for part in piece.parts for text in lay_out(part, after=",", depth=depth + 1)]
    return [f"{indent}{before}{piece.head}", *inner, f"{indent}){after}"]


def assignment(target: str, expression: str, *, depth: int = 1, remark: str = "") -> list[str]:
    """``target = expression`` on as many lines as it needs, with a remark beside or above it."""
    indent = _INDENT * depth
    note = " ".join(remark.split())
    line = f"{indent}{target} = {expression}"
    if len(line) > WIDTH:
        body = wrapped(expression, depth + 1)
        lines = [f"{indent}{target} = (", *body, f"{indent})"]
    else:
        lines = [line]
        if note and len(line) + len(note) + 4 <= WIDTH:
            return [f"{line}  # {note}"]
    above = textwrap.wrap(note, width=WIDTH - len(indent) - 2) if note else []
    return [*(f"{indent}# {text}" for text in above), *lines]


def deletion(names: Sequence[str], *, depth: int = 1) -> list[str]:
    """``del`` of names, on as many lines as they need."""
    indent = _INDENT * depth
    lines = _filled(", ".join(names), 0, WIDTH - len(indent) - len("del "))
    return [f"{indent}del {line.rstrip(',')}" for line in lines]


def wrapped(expression: str, depth: int, after: str = "") -> list[str]:
    """An expression inside brackets, broken before plus and minus, elsewhere only if it must."""
    room = WIDTH - len(_INDENT) * depth
    sums = _glued(expression + after, "+-")
    for symbol in "*/":
        sums = sums.replace(f" {symbol} ", f"{_GLUE}{symbol}{_GLUE}")
    fits = max(map(len, sums.split(" "))) <= room
    lines = _filled(sums if fits else _glued(expression + after, "+-*/"), depth)
    return [line.replace(_GLUE, " ") for line in lines]


def _glued(expression: str, symbols: str) -> str:
    """An expression whose operators stay with what follows them."""
    for symbol in symbols:
        expression = expression.replace(f" {symbol} ", f" {symbol}{_GLUE}")
    return expression


def _filled(text: str, depth: int, width: int = WIDTH) -> list[str]:
    indent = _INDENT * depth
    return textwrap.wrap(
        text,
        width=width,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )


def shown(value: float) -> str:
    """A bound as documentation shows it."""
    return re.sub(r"e\+?(-?)0*", r"e\1", readable(value))
