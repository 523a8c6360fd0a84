"""Numbers as documents and messages show them."""

from __future__ import annotations


def readable(value: float) -> str:
    """A number with as few digits as it takes to read it back as the same."""
    short = f"{value:g}"
    return short if float(short) == value else repr(float(value)).removesuffix(".0")
