"""A specification as TOML: what was declared, in one order and one spelling.

Reading the text gives the same specification, so that whatever was made from it can be made again.
Comments and formatting of the file that was read are not kept.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any

_SECTIONS = ("frame", "state", "input", "measurement", "correction")
_FIRST = ("name", "description", "kind", "model", "equation", "let")
_BARE = re.compile(r"[A-Za-z0-9_-]+")


def as_toml(table: Mapping[str, Any]) -> str:
    """A table of a specification as TOML.

    Args:
        table: as TOML or the builder gives it.

    Returns:
        The text; empty where an equation is a Python function, which TOML has no words for.
    """
    rows = [row for section in _SECTIONS for row in table.get(section, ())]
    if any(callable(row.get("equation")) for row in rows):
        return ""
    head = {key: value for key, value in table.items() if key not in _SECTIONS}
    blocks = ["\n".join(_lines(head))]
    for section in _SECTIONS:
        for row in table.get(section, ()):
            blocks.append("\n".join([f"[[{section}]]", *_lines(row)]))
    return "\n\n".join(block for block in blocks if block) + "\n"


def _lines(row: Mapping[str, Any]) -> Iterator[str]:
    """Key and value of a table, what it is in front of how it is."""
    given = {key: value for key, value in row.items() if value is not None}
    first = [key for key in _FIRST if key in given]
    for key in (*first, *sorted(given.keys() - set(first))):
        yield f"{_key(key)} = {_value(given[key])}"


def _key(key: str) -> str:
    return key if _BARE.fullmatch(key) else _string(key)


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, int):
        return str(int(value))
    if isinstance(value, float):
        return repr(float(value))
    if isinstance(value, Mapping):
        # The order of lets and of satellite systems has a meaning: it stays.
        inside = ", ".join(f"{_key(key)} = {_value(each)}" for key, each in value.items())
        return f"{{ {inside} }}"
    return f"[{', '.join(_value(each) for each in value)}]"


def _string(text: str) -> str:
    """A basic string: JSON's, whose escapes TOML shares, with the one more that TOML wants."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
