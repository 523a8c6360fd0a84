"""Evaluation of many epochs with NumPy, a block at a time.

A block is short enough that its intermediate values stay in the cache. Each element of its
arguments is one row, contiguous in memory, with items in front of epochs; see ``_tables.py``. The
non-zeros are put together as rows as well and copied to where they belong at once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import product
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np

from ._calls import Evaluation
from ._kernels import ComplexStep, Kernel, run
from ._masked import Computed, MaskedFunction
from ._places import columns_of
from ._runtime import (
    Array,
    Extent,
    Output,
    Part,
    Slot,
    Status,
    outputs_of,
)
from ._tables import BlockGuards, Elements, Source, Table

#: Most epochs in a block: less, and calls take longer than arithmetic; more, and the intermediate
#: values of a function overflow the cache.
LENGTH = 4096
#: Most numbers in a row of items, of which there are fewer at a time.
ITEMS_LENGTH = 8192
#: Fewest epochs in a block, however many items: what items share has rows of this length.
SHORTEST = 512

_GAP = 3


@dataclass(frozen=True, eq=False)
class Layout:
    """How the rows of an output are put together.

    Attributes:
        output: which one.
        number: its place in what the kernel returns.
        shape: of one item, or of one epoch.
        size: elements of that.
        runs: first and last column (exclusive) of what is copied at once, short gaps included.
        complete: True when one run covers every column.
        movable: True where some places depend on a run-time index.
        arrange: from the rows of the non-zeros, and one of zeros behind them, to one row for every
            column; None where they are in order already.
    """

    output: Output
    number: int
    shape: tuple[int, ...]
    size: int
    runs: tuple[tuple[int, int], ...]
    complete: bool
    movable: bool
    arrange: Callable[[Sequence[Any]], Sequence[Any]] | None


def _layout(output: Output, number: int, part: Part) -> Layout:
    if part is Part.NONZEROS:
        size, columns = len(output.places), list(range(len(output.places)))
        shape: tuple[int, ...] = (size,)
    else:
        size, columns, shape = output.size, sorted(_columns(output)), output.shape
    runs: list[tuple[int, int]] = []
    for column in columns:
        if runs and column - runs[-1][1] < _GAP:
            runs[-1] = (runs[-1][0], column + 1)
        else:
            runs.append((column, column + 1))
    if runs and runs[0][0] < _GAP:
        runs[0] = (0, runs[0][1])
    if runs and size - runs[-1][1] < _GAP:
        runs[-1] = (runs[-1][0], size)
    movable = part is not Part.NONZEROS and any(isinstance(p, Slot) for p in output.places)
    arrange = None if part is Part.NONZEROS or movable else _arrangement(output)
    complete = runs == [(0, size)]
    return Layout(output, number, shape, size, tuple(runs), complete, movable, arrange)


def _arrangement(output: Output) -> Callable[[Sequence[Any]], Sequence[Any]] | None:
    """A function that spreads the rows of non-zeros over all columns, zeros between them."""
    sources = [len(output.places)] * output.size
    for number, place in enumerate(output.places):
        assert not isinstance(place, Slot)
        sources[place] = number
    if sources == list(range(output.size)):
        return None
    return itemgetter(*sources) if output.size > 1 else lambda rows: [rows[sources[0]]]


def _columns(output: Output) -> Iterator[int]:
    """Every column that may hold something else than zero."""
    for place in output.places:
        if isinstance(place, Slot):
            yield from (column for _, column in columns_of(place))
        else:
            yield place


@lru_cache(maxsize=16)
def _constant(value: float, shape: tuple[int, ...], real: Any) -> Array:
    """A row of equal numbers, which nobody writes to."""
    row = np.full(shape, value, dtype=real)
    row.flags.writeable = False
    return row


def _whole(value: Any, shape: tuple[int, ...], real: Any) -> Array:
    """A row of its full length from a number, or from an array that broadcasts to it."""
    if isinstance(value, np.ndarray):
        return np.broadcast_to(value, shape)
    return _constant(value, shape, real)


def _place(layout: Layout, rows: Sequence[Any], elements: Elements) -> Sequence[Any]:
    """One row, or number, for every column of an output where some places depend on an index."""
    placed: list[Any] = [0.0] * layout.size
    for row, place in zip(rows, layout.output.places, strict=True):
        if isinstance(place, Slot):
            index = elements[place.argument]
            index = index if place.element is None else index[place.element]
            for number, column in columns_of(place):
                placed[column] = np.where(index == number, row, placed[column])
        else:
            placed[place] = row
    return placed


def block_length(items: int | None) -> int:
    """How many epochs are evaluated at once."""
    return max(min(LENGTH, ITEMS_LENGTH // max(1, items or 1)), SHORTEST)


class Plan(NamedTuple):
    """What the types and shapes of the arguments decide about a call.

    Attributes:
        function: masks what failed.
        kernel: computes.
        part: what is asked for.
        layouts: one for every output of it.
        reference: the item that is subtracted from the others, if any.
        extent: leading axes and items.
        real: type of the outputs.
        shapes: of every output, whole and with a single leading and a single trailing axis.
        leads: for every argument the leading axes it is broadcast to, if any, and its shape with
            a single one.
        shared: tables of what all epochs share.
        own: tables of what each epoch has.
    """

    function: MaskedFunction
    kernel: Kernel
    part: Part
    layouts: Sequence[Layout]
    reference: int | None
    extent: Extent
    real: Any
    shapes: Sequence[tuple[tuple[int, ...], tuple[int, ...]]]
    leads: Sequence[tuple[tuple[int, ...] | None, tuple[int, ...]]]
    shared: Sequence[Table]
    own: Sequence[Table]

    def run(self, arrays: Sequence[Array], out: list[Array] | None) -> Evaluation:
        """Evaluates block by block."""
        batch, items = self.extent
        count = math.prod(batch)
        outputs: list[Array] = out or [np.empty(whole, dtype=self.real) for whole, _ in self.shapes]
        results = [
            array if array.shape == flat else array.reshape(flat)
            for array, (_, flat) in zip(outputs, self.shapes, strict=True)
        ]
        status: Array = np.zeros(count, dtype=np.uint8)
        item_status: Array = np.zeros((count, items or 0), dtype=np.uint8)
        length = block_length(items)
        with np.errstate(all="ignore"):
            source = Source(self.function.signature, self._flat(arrays), self.real, self.shared)
            if count <= length:
                self._block(source, slice(None), results, status, item_status, out is None)
            else:
                for start in range(0, count, length):
                    own = slice(start, min(start + length, count))
                    found = [result[own] for result in results]
                    self._block(source, own, found, status[own], item_status[own], out is None)
        verdict = Status(int(status[0])) if batch == () else status.reshape(batch)
        own_status = None if items is None else item_status.reshape((*batch, items))
        return Evaluation(outputs, verdict, own_status)

    def _flat(self, arrays: Sequence[Array]) -> dict[str, Array]:
        """Arguments with one leading axis, of length one where all epochs share them."""
        flat = {}
        for name, array, (wide, shape) in zip(
            self.function.signature.names, arrays, self.leads, strict=True
        ):
            if array.shape != shape:
                array = (array if wide is None else np.broadcast_to(array, wide)).reshape(shape)
            flat[name] = array
        return flat

    def _block(
        self,
        source: Source,
        epochs: slice,
        results: Sequence[Array],
        status: Array,
        item_status: Array,
        fresh: bool,
    ) -> None:
        """Fills in the outputs and the status of some epochs."""
        guards = BlockGuards(self.real)
        elements = source.read(self.own, epochs, guards)
        signature = self.function.signature
        space = ComplexStep(np) if self.real.kind == "c" else np
        found = run(signature, self.kernel, space, guards, elements)
        direct = not guards.noted and self.reference is None
        whole = results if direct else self._room(*item_status.shape)
        for layout, target in zip(self.layouts, whole, strict=True):
            self._store(layout, found[layout.number], elements, target)
        if not direct:
            count, items = item_status.shape
            noted = np.broadcast_to(guards.shared, (count,))
            by_item = np.broadcast_to(guards.item, (items, count)).T if signature.mapped else None
            computed = Computed.of(np, list(whole), noted, by_item)
            self._settle(computed, results, status, item_status, fresh)

    def _store(
        self, layout: Layout, values: Sequence[Any], elements: Elements, target: Array
    ) -> None:
        """Puts the non-zeros of some epochs where they belong: (epochs, items if any, elements)."""
        shape = target.shape[-2::-1]
        real = self.real
        if layout.movable:
            values = _place(layout, values, elements)
        rows: Sequence[Array] = [
            row if type(row) is np.ndarray and row.shape == shape else _whole(row, shape, real)
            for row in values
        ]
        if layout.arrange is not None:
            rows = layout.arrange((*rows, _constant(0.0, shape, real)))
        if layout.complete:
            target[...] = np.concatenate(rows).reshape(target.shape[::-1]).T
            return
        target.fill(0.0)
        for start, stop in layout.runs:
            joined = np.concatenate(rows[start:stop])
            target[..., start:stop] = joined.reshape((stop - start, *shape)).T

    def _room(self, count: int, items: int) -> list[Array]:
        mapped = self.function.signature.mapped
        shapes = ((count, *_own(o, items if mapped else None), o.size) for o in self.layouts)
        return [np.empty(shape, dtype=self.real) for shape in shapes]

    def _settle(
        self,
        computed: Computed,
        results: Sequence[Array],
        status: Array,
        item_status: Array,
        fresh: bool,
    ) -> None:
        """Masks what failed and puts the rest where it belongs; untouched or NaN where fresh."""
        extent = Extent(status.shape, None if computed.item is None else item_status.shape[1])
        outputs = [
            array.reshape((*status.shape, *_own(layout, extent.items), *layout.shape))
            for layout, array in zip(self.layouts, computed.outputs, strict=True)
        ]
        computed = computed._replace(outputs=outputs)
        if self.reference is not None:
            computed = self.function.differenced(np, computed, self.reference)
        done = self.function.finish(np, self.part, computed, extent, None, self.reference)
        status[...] = done.status
        if done.item_status is not None:
            item_status[...] = done.item_status
        passed = (status == Status.OK) | (status == Status.PARTIAL) | fresh
        for target, array in zip(results, done.outputs, strict=True):
            where = passed.reshape(passed.shape + (1,) * (target.ndim - 1))
            np.copyto(target, array.reshape(target.shape), where=where)


def _own(layout: Layout, items: int | None) -> tuple[int, ...]:
    """The item axis of an output, where it has one."""
    return (items,) if items is not None and layout.output.item else ()


class Blocks:
    """Plans the evaluation of a function for NumPy's arrays."""

    def __init__(self, function: MaskedFunction, kernel: Kernel) -> None:
        self._function, self._signature, self._kernel = function, function.signature, kernel
        self._layouts = {
            part: [
                _layout(output, number, part)
                for number, output in enumerate(self._signature.outputs)
                if output in outputs_of(self._signature, part)
            ]
            for part in Part
        }
        self._tables: dict[tuple[bool, ...], tuple[list[Table], list[Table]]] = {}

    def plan(
        self, part: Part, arrays: Sequence[Array], extent: Extent, reference: int | None = None
    ) -> Plan:
        """How to evaluate a part, or all outputs as differences to the item ``reference``."""
        batch, items = extent
        count = math.prod(batch)
        real = self._function.type_of(arrays)
        layouts = self._layouts[part]
        left = items if items is None or reference is None else items - 1
        shapes = [
            ((*batch, *_own(o, left), *o.shape), (count, *_own(o, left), o.size)) for o in layouts
        ]
        leads: list[tuple[tuple[int, ...] | None, tuple[int, ...]]] = []
        shared = []
        for argument, array in zip(self._signature.arguments, arrays, strict=True):
            axes = array.ndim - argument.rank
            lead, own = array.shape[:axes], array.shape[axes:]
            together = lead != batch and math.prod(lead) == 1
            wide = None if together or lead == batch else (*batch, *own)
            leads.append((wide, (1 if together else count, *own)))
            shared.append(together)
        key = tuple(shared)
        if key not in self._tables:
            self._tables[key] = self._grouped(key)
        return Plan(
            self._function, self._kernel, part, layouts, reference, extent, real, shapes, leads,
            *self._tables[key],
        )  # fmt: skip

    def _grouped(self, shared: Sequence[bool]) -> tuple[list[Table], list[Table]]:
        """Tables of what all epochs share and of what each has, items and the rest apart."""
        found: tuple[list[Table], list[Table]] = ([], [])
        arguments = self._signature.arguments
        for together, item in product((True, False), (False, True)):
            pairs = zip(arguments, shared, strict=True)
            chosen = [a for a, own in pairs if own == together and a.item == item]
            if chosen:
                found[not together].append(Table(chosen, self._signature.guarded))
        return found
