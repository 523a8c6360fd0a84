"""Constant tables in C: numbers as exact literals, and one table for the same content."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

from symnav import ir

_WIDTH = 96


@dataclass
class Tables:
    """Constant tables of one tree; two of the same content are one."""

    prefix: str
    real: str
    scalar: ir.Scalar
    listed: list[dict[str, Any]] = field(default_factory=list)
    _known: dict[tuple[str, str], str] = field(default_factory=dict)

    def reals(self, wish: str, values: Iterable[Any], remark: str) -> str:
        """Name of a table of reals, as hexadecimal literals."""
        return self._table(wish, self.real, [hexadecimal(v, self.scalar) for v in values], remark)

    def integers(self, wish: str, values: Iterable[int], remark: str) -> str:
        """Name of a table of ``int32_t``."""
        return self._table(wish, "int32_t", [str(int(v)) for v in values], remark)

    def bytes(self, wish: str, values: Iterable[int], remark: str) -> str:
        """Name of a table of ``uint8_t``."""
        return self._table(wish, "uint8_t", [f"{int(v)}U" for v in values], remark)

    def places(self, wish: str, rows: Iterable[Sequence[int]], remark: str) -> str:
        """Name of a table of places."""
        texts = ["{" + ",".join(str(v) for v in row) + "}" for row in rows]
        return self._table(wish, f"{self.prefix}_place_t", texts, remark)

    def _table(self, wish: str, kind: str, texts: Sequence[str], remark: str) -> str:
        if not texts:
            return "NULL"
        content = ", ".join(texts)
        known = self._known.get((kind, content))
        if known is not None:
            return known
        taken = {table["name"] for table in self.listed}
        name, count = f"{self.prefix}_{wish}", 2
        while name in taken:
            name, count = f"{self.prefix}_{wish}_{count}", count + 1
        lines = textwrap.wrap(content, _WIDTH, break_long_words=False, break_on_hyphens=False)
        self.listed.append(
            {"name": name, "kind": kind, "length": len(texts), "lines": lines, "remark": remark}
        )
        self._known[kind, content] = name
        return name


def hexadecimal(value: Any, scalar: ir.Scalar) -> str:
    """A number as a hexadecimal literal of C99, exact and without needless zeros."""
    number = float(value)
    mantissa, _, exponent = number.hex().partition("p")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return f"{mantissa}p{exponent}{'F' if scalar is ir.Scalar.FLOAT else ''}"


def short(value: float) -> float:
    """A bound with a few digits, rounded up."""
    if value == 0.0:
        return 0.0
    mantissa, _, exponent = float(value).hex().partition("p")
    digits = int(mantissa[2:].replace(".", "")[:3].ljust(3, "0"), 16) + 1
    return float(digits) * 2.0 ** (int(exponent) - 8)
