"""What the header says about the rounding of an output."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from decimal import ROUND_CEILING, Context, Decimal

from symnav import ir

_OVER = "over the declared ranges"


def rounding_text(output: ir.Output, unit_roundoff: float, *, differenced: bool = False) -> str:
    """One sentence without its full stop; empty where no bounds were asked for.

    Args:
        output: with the rounding of its entries.
        unit_roundoff: of the type.
        differenced: True for rows less the row of a reference item.
    """
    if not output.rounding:
        return ""
    entries = output.rounding
    if differenced:
        entries = tuple(_differenced(entry, unit_roundoff) for entry in entries)
    parts = [
        part
        for unit, name, some in _sections(output, entries)
        if (part := _part(unit, name, some, whole=len(some) == len(entries)))
    ]
    if not parts:
        return "free of rounding errors"
    where = "in any element " if output.name.startswith("jacobian") else ""
    return f"rounding error at most {', '.join(parts)} {where}{_OVER}"


def upwards(value: float, digits: int = 2) -> str:
    """A bound in a few digits, never smaller than it is."""
    if math.isinf(value):
        return "(no bound)"
    rounded = Context(prec=digits, rounding=ROUND_CEILING).create_decimal(Decimal(value))
    return f"{float(rounded):.{digits}g}"


def unit_of(output: ir.Output, entry: ir.Entry) -> str:
    """Unit of an entry of a value; empty for a Jacobian, whose entries have all sorts."""
    if output.unit or output.name.startswith("jacobian"):
        return output.unit
    section = _section(output, entry)
    return section.unit if section else ""


def _differenced(one: ir.Rounding, unit_roundoff: float) -> ir.Rounding:
    """The difference of two rows: the errors of both and one rounding."""
    rounding = unit_roundoff * 2.0 * one.largest
    total = [(2.0 * error + rounding) * (1.0 + 1e-12) for error in (one.bound, one.smooth)]
    return ir.Rounding(total[0], total[1], 2.0 * one.largest)


def _sections(
    output: ir.Output, entries: Sequence[ir.Rounding]
) -> Iterator[tuple[str, str, list[ir.Rounding]]]:
    """Unit, name and entries of every part of an output that has a unit of its own."""
    if output.unit or output.name.startswith("jacobian") or len(output.rows) < 2:
        yield output.unit, "", list(entries)
        return
    for row in output.rows:
        found = [
            rounding
            for entry, rounding in zip(output.entries, entries, strict=True)
            if _section(output, entry) is row
        ]
        yield row.unit, row.name, found


def _section(output: ir.Output, entry: ir.Entry) -> ir.Section | None:
    place = entry.index[0] if entry.index else 0
    base = place.base if isinstance(place, ir.Offset) else place
    return next((row for row in output.rows if row.start <= base < row.start + row.size), None)


def _part(unit: str, name: str, entries: Sequence[ir.Rounding], *, whole: bool) -> str:
    bound = max((entry.bound for entry in entries), default=0.0)
    smooth = max((entry.smooth for entry in entries), default=0.0)
    if bound == 0.0:
        return ""
    text = _quantity(smooth, unit)
    if upwards(bound) != upwards(smooth):
        text += f" ({_quantity(bound, unit)} where rounding decides a comparison)"
    return text if whole or not name else f"{text} in {name}"


def _quantity(value: float, unit: str) -> str:
    return upwards(value) if unit in ("", "1") else f"{upwards(value)} {unit}"
