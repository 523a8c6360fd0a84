"""Entry points as drivers call them: arrays with sizes, runs of results, steps.

A driver declares every array as large as the header says, calls the entry point, and looks at
what was written. This module says what that is, from the header alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c.border import SUFFIX as BORDER
from symnav.emit.c.literals import declared
from symnav.export.arithmetic.evaluation import read_domains
from symnav.export.documents.prototypes import Parameter, Prototype, constants, prototypes, value_of
from symnav.export.records import Tree

LANES = 16
"""Epochs side by side, where the C does not say how many."""


@dataclass(frozen=True, slots=True)
class Runs:
    """Where the results of one call stand in an output: rows or columns of items.

    Result ``k`` of item ``i`` is element ``k * pitch + i * stride``; what is not per item counts
    as one item.

    Attributes:
        results: results of an item.
        pitch: from one result to the next.
        stride: from one item to the next.
        items: how many items, in terms of the number ``n`` of the call.
    """

    results: int
    pitch: int
    stride: int
    items: str


@dataclass(frozen=True, slots=True)
class Array:
    """An array of a call.

    Attributes:
        name: identifier.
        type: of its elements.
        written: True for an output.
        size: elements the header declares for one call.
        elements: elements a driver allocates: for many epochs, ``size`` for each.
        runs: where the results of one call stand; None for inputs and for many epochs.
    """

    name: str
    type: str
    written: bool
    size: int
    elements: int
    runs: Runs | None

    @property
    def real(self) -> bool:
        """True for floating-point elements."""
        return self.type.endswith("_real_t")


@dataclass(frozen=True, slots=True)
class Promise:
    """What a caller has seen to before it passes an array.

    Attributes:
        size: elements of one call, of one item where there are items.
        ranges: literals of the lower and upper end, by the number of the element; of an element
            that is not here nothing is promised.
    """

    size: int
    ranges: Mapping[int, tuple[str, str]]


@dataclass(frozen=True, slots=True)
class Entry:
    """An entry point with the arrays a driver gives it.

    Attributes:
        prototype: as the header declares it.
        arrays: its pointers, in order.
        maximum: most items of a call; 0 where it has no items.
        epochs: most epochs a driver gives it; 0 where it takes one.
        lanes: epochs that lie side by side in its arrays; 1 where every epoch has a row.
        statuses: what one epoch can end with: those of the call, or of every epoch.
        promised: by array, what an entry point that does not look at its inputs relies on.
    """

    prototype: Prototype
    arrays: tuple[Array, ...]
    maximum: int
    epochs: int
    lanes: int
    statuses: tuple[str, ...]
    promised: Mapping[str, Promise]

    @property
    def symbol(self) -> str:
        """Its name."""
        return self.prototype.symbol

    @property
    def inputs(self) -> tuple[Array, ...]:
        """What it reads."""
        return tuple(array for array in self.arrays if not array.written)

    @property
    def outputs(self) -> tuple[Array, ...]:
        """What it writes."""
        return tuple(array for array in self.arrays if array.written)

    @property
    def results(self) -> tuple[Array, ...]:
        """The numbers it writes."""
        return tuple(array for array in self.outputs if array.real)

    @property
    def counted(self) -> bool:
        """True when it takes a number of items."""
        return "n" in self.prototype.names

    @property
    def referenced(self) -> bool:
        """True when it takes a reference item."""
        return "reference" in self.prototype.names

    def arguments(self, place: Mapping[bool, str], *, step: bool = True) -> list[str]:
        """Arguments of a call.

        Args:
            place: what stands in front of an array that is read (False) or written (True).
            step: False for the same inputs in every epoch.
        """
        sizes = {f"{array.name}_step": array.size for array in self.arrays}
        return [
            f"{place[parameter.written]}{parameter.name}"
            if parameter.array
            else str(sizes[parameter.name] if step else 0)
            if parameter.name in sizes
            else parameter.name
            for parameter in self.prototype.parameters
        ]


def entries(tree: Tree) -> Iterator[tuple[ir.Function, tuple[Entry, ...]]]:
    """The entry points of every function of a tree."""
    known = constants(tree)
    listed = prototypes(tree)
    symbols = {f"{tree.prefix}_{function.name}": function for function in tree.module.functions}
    for symbol, function in symbols.items():
        family = [p for p in listed if _owner(p.symbol, symbols) == symbol]
        scalar = tree.module.scalar
        yield function, tuple(_entry(p, family, function, known, scalar) for p in family)


def _owner(symbol: str, functions: Mapping[str, ir.Function]) -> str:
    """The function an entry point belongs to: the longest whose name it starts with."""
    return max((f for f in functions if f"{symbol}_".startswith(f"{f}_")), key=len)


def _entry(
    prototype: Prototype,
    family: Sequence[Prototype],
    function: ir.Function,
    known: Mapping[str, int],
    scalar: ir.Scalar,
) -> Entry:
    stem = family[0].symbol.upper()
    many = "epochs" in prototype.names
    maximum = function.maximum or 0
    lanes = known.get(f"{stem}_LANES", LANES)
    epochs = (2 if maximum else 2 * lanes) if many else 0
    # The full entry point comes first: what others call the same may be smaller.
    sizes = {q.name: q.size for p in reversed(family) for q in p.parameters if q.size}
    limit = f"{stem}_MAX_ITEMS"
    arrays = []
    for parameter in prototype.parameters:
        if not parameter.array:
            continue
        text = parameter.size or sizes.get(parameter.name, "1")
        size = value_of(text, known)
        runs = None if many or not parameter.written else _runs(parameter, size, limit, function)
        arrays.append(
            Array(
                parameter.name,
                parameter.type,
                parameter.written,
                size,
                size * max(epochs, 1),
                runs,
            )
        )
    statuses = family[0].statuses if many else prototype.statuses
    border = function.checks_at_border and prototype.symbol == family[0].symbol + BORDER
    promised = {} if function.checks_inputs or border else _promised(arrays, function, scalar)
    beside = lanes if prototype.symbol.endswith("_blocks") else 1
    return Entry(prototype, tuple(arrays), maximum, epochs, beside, statuses, promised)


def _promised(
    arrays: Sequence[Array], function: ir.Function, scalar: ir.Scalar
) -> dict[str, Promise]:
    """The declared ranges of what is read and not looked at."""
    given = [array for array in arrays if not array.written and array.name != "sigma"]
    return {
        array.name: Promise(
            argument.size,
            {
                domain.start + k: declared(domain.lower[k], domain.upper[k], scalar)
                for domain in read_domains(argument)
                for k in range(domain.size)
            },
        )
        for array, argument in zip(given, function.arguments, strict=False)
        if not argument.integer
    }


def _runs(parameter: Parameter, size: int, limit: str, function: ir.Function) -> Runs:
    """Where the results of one call stand in an output."""
    text, maximum = parameter.size, function.maximum or 0
    if limit not in text:
        return Runs(size, 1, 1, "1")
    fewer = text.count(f"({limit} - 1)")
    if text.count(limit) == 2:
        return Runs(1, 1, 1, "(n - 1) * (n - 1)" if fewer == 2 else "(n - 1) * n")
    rows, items = maximum - fewer, "n - 1" if fewer else "n"
    width = size // rows
    by_column = function.column_major and parameter.name.startswith("jacobian")
    if text.endswith(f" * {limit}") or by_column:
        return Runs(width, rows, 1, items)
    return Runs(width, 1, width, items)
