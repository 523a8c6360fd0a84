"""Elements and columns that a run-time slot chooses: how far a slot reaches, and that it fits.

A slot is an integer input with a declared range. The range is checked when the slot is loaded, so
that what it addresses afterwards is inside its array; here the declared range itself is checked.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from symnav import errors, ir
from symnav.emit.c.literals import integer_bounds


@dataclass(frozen=True, slots=True)
class Span:
    """Neighbouring elements of an argument that a slot may choose from; copied as an array."""

    argument: str
    start: int
    stop: int


def reach(function: ir.Function, offset: ir.Offset) -> tuple[int, int]:
    """First and last index an offset can take."""
    slot = offset.slot
    for argument in function.arguments:
        for domain in argument.domains:
            if argument.name == slot.argument and isinstance(slot.index, int):
                place = slot.index - domain.start
                if 0 <= place < domain.size:
                    low, high = integer_bounds(domain.lower[place], domain.upper[place])
                    return offset.base + int(low), offset.base + int(high)
    raise errors.InputError(f"{function.name}: no slot {slot.argument}[{slot.index}]")


def spans_of(function: ir.Function, loads: Iterable[ir.Load]) -> list[Span]:
    """Runs of elements that some load chooses from by a slot; runs that overlap are one.

    Raises:
        InputError: when a slot reaches beyond its argument.
    """
    sizes = {argument.name: argument.size for argument in function.arguments}
    found: list[Span] = []
    for load in loads:
        if isinstance(load.index, ir.Offset):
            first, last = reach(function, load.index)
            if first < 0 or last >= sizes[load.argument]:
                raise _too_far(function, load.index, f"{load.argument}[{sizes[load.argument]}]")
            found.append(Span(load.argument, first, last + 1))
    merged: list[Span] = []
    for span in sorted(found, key=lambda span: (span.argument, span.start, span.stop)):
        last_one = merged[-1] if merged else None
        if last_one and last_one.argument == span.argument and span.start < last_one.stop:
            merged[-1] = Span(span.argument, last_one.start, max(last_one.stop, span.stop))
        else:
            merged.append(span)
    return merged


def refuse_slots_beyond(function: ir.Function) -> None:
    """Refuse a slot whose declared range reaches beyond the output it places a non-zero in."""
    for output in function.outputs:
        for entry in output.entries:
            for step, length in zip(entry.index, output.shape, strict=True):
                if isinstance(step, ir.Offset):
                    first, last = reach(function, step)
                    if first < 0 or last >= length:
                        raise _too_far(function, step, f"{output.name}, {length} elements long")


def _too_far(function: ir.Function, offset: ir.Offset, where: str) -> errors.InputError:
    return errors.InputError(
        f"{function.name}: the declared range of {offset.slot.argument} reaches beyond {where}; "
        "narrow the range"
    )
