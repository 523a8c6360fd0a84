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
        complete: True when the runs cover every column.
        arrange: from non-zeros to one row, or number, for every column; None where some places
            depend on a run-time index.
    """

    output: Output
    number: int
    shape: tuple[int, ...]
    size: int
    runs: tuple[tuple[int, int], ...]
    complete: bool
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
    arrange = None if part is Part.NONZEROS else _arrangement(output)
    return Layout(output, number, shape, size, tuple(runs), runs == [(0, size)], arrange)


def _arrangement(output: Output) -> Callable[[Sequence[Any]], Sequence[Any]] | None:
    """A function that spreads non-zeros over all columns, zeros between them."""
    fixed = [place for place in output.places if not isinstance(place, Slot)]
    if output.size < 2 or len(fixed) < len(output.places):
        return None
    sources = [len(fixed)] * output.size
    for number, place in enumerate(fixed):
        sources[place] = number
    pick = itemgetter(*sources)
    return lambda values: pick((*values, 0.0))


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
    return (
        np.broadcast_to(value, shape)
        if isinstance(value, np.ndarray)
        else _constant(value, shape, real)
    )


def _store(
    layout: Layout, rows: Sequence[Any], shape: tuple[int, ...], real: Any, target: Array
) -> None:
    """Writes the rows of some epochs, (epochs, items if any, elements)."""
    if not layout.complete:
        target.fill(0.0)
    for start, stop in layout.runs:
        parts = [
            row if type(row) is np.ndarray and row.shape == shape else _whole(row, shape, real)
            for row in rows[start:stop]
        ]
        joined = np.concatenate(parts).reshape((stop - start, *shape))
        target[..., start:stop] = joined.T


class Blocks:
    """Evaluates a function for NumPy's arrays."""

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

    def evaluate(
        self,
        part: Part,
        arrays: Sequence[Array],
        extent: Extent,
        out: list[Array] | None,
        reference: int | None = None,
    ) -> Evaluation:
        """Outputs of a part, or all of them as differences to the item ``reference``."""
        batch, items = extent
        count, layouts = math.prod(batch), self._layouts[part]
        real = self._function.real
        if any(array.dtype.kind == "c" for array in arrays):
            real = np.result_type(real, *(a.dtype for a in arrays if a.dtype.kind == "c"))
        left = items if items is None or reference is None else items - 1
        outputs: list[Array] = out or [
            np.empty((*batch, *_own(layout, left), *layout.shape), dtype=real) for layout in layouts
        ]
        status: Array = np.zeros(count, dtype=np.uint8)
        item_status: Array = np.zeros((count, items or 0), dtype=np.uint8)
        block = Block(self._function, self._kernel, part, layouts, reference, out is None, real)
        results = [
            array.reshape((count, *_own(layout, left), layout.size))
            for layout, array in zip(layouts, outputs, strict=True)
        ]
        length = max(min(LENGTH, ITEMS_LENGTH // max(1, items or 1)), SHORTEST)
        with np.errstate(all="ignore"):
            source = self._source(arrays, extent, count, real)
            for start in range(0, count, length):
                own = slice(start, min(start + length, count))
                found = [result[own] for result in results]
                block.evaluate(source, own, found, status[own], item_status[own])
        verdict = Status(int(status[0])) if batch == () else status.reshape(batch)
        if items is None:
            return Evaluation(outputs, verdict, None)
        return Evaluation(outputs, verdict, item_status.reshape((*batch, items)))

    def _source(self, arrays: Sequence[Array], extent: Extent, count: int, real: Any) -> Source:
        """Arguments with one leading axis, of length one where all epochs share them."""
        flat, shared, batch = {}, [], extent.batch
        for argument, array in zip(self._signature.arguments, arrays, strict=True):
            axes = array.ndim - argument.rank
            lead, own = array.shape[:axes], array.shape[axes:]
            shared.append(lead != batch and math.prod(lead) == 1)
            if not shared[-1] and lead != batch:
                array = np.broadcast_to(array, (*batch, *own))
            flat[argument.name] = array.reshape((1 if shared[-1] else count, *own))
        key = tuple(shared)
        if key not in self._tables:
            self._tables[key] = self._grouped(key)
        return Source(self._signature, flat, real, *self._tables[key])

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


def _own(layout: Layout, items: int | None) -> tuple[int, ...]:
    """The item axis of an output, where it has one."""
    return (items,) if items is not None and layout.output.item else ()


class Block(NamedTuple):
    """The evaluation of some epochs.

    Attributes:
        function: masks what failed.
        kernel: computes.
        part: what was asked for.
        layouts: one for every output of it.
        reference: the item that is subtracted from the others, if any.
        fresh: True where failed epochs become NaN, False where they stay as they are.
        real: type of the outputs.
    """

    function: MaskedFunction
    kernel: Kernel
    part: Part
    layouts: Sequence[Layout]
    reference: int | None
    fresh: bool
    real: Any

    def evaluate(
        self,
        source: Source,
        epochs: slice,
        results: Sequence[Array],
        status: Array,
        item_status: Array,
    ) -> None:
        """Fills in the outputs and the status of some epochs."""
        guards = BlockGuards(self.real)
        elements = source.read(epochs, guards)
        signature = self.function.signature
        space = ComplexStep(np) if self.real.kind == "c" else np
        found = run(signature, self.kernel, space, guards, elements)
        count, items = item_status.shape
        rows = [self._rows(layout, found[layout.number], elements) for layout in self.layouts]
        direct = not guards.noted and self.reference is None
        whole = results if direct else self._room(count, items)
        for layout, own_rows, target in zip(self.layouts, rows, whole, strict=True):
            shape = (items, count) if layout.output.item and signature.mapped else (count,)
            _store(layout, own_rows, shape, self.real, target)
        if not direct:
            noted = np.broadcast_to(guards.shared, (count,))
            by_item = np.broadcast_to(guards.item, (items, count)).T if signature.mapped else None
            self._settle(Computed(list(whole), noted, by_item), results, status, item_status)

    def _rows(self, layout: Layout, values: Sequence[Any], elements: Elements) -> Sequence[Any]:
        """One row, or number, for every column of an output."""
        if layout.arrange is not None:
            return layout.arrange(values)
        if self.part is Part.NONZEROS:
            return values
        rows: list[Any] = [0.0] * layout.size
        for value, place in zip(values, layout.output.places, strict=True):
            if isinstance(place, Slot):
                index = elements[place.argument]
                index = index if place.element is None else index[place.element]
                for number, column in columns_of(place):
                    rows[column] = np.where(index == number, value, rows[column])
            else:
                rows[place] = value
        return rows

    def _room(self, count: int, items: int) -> list[Array]:
        mapped = self.function.signature.mapped
        shapes = ((count, *_own(o, items if mapped else None), o.size) for o in self.layouts)
        return [np.empty(shape, dtype=self.real) for shape in shapes]

    def _settle(
        self, computed: Computed, results: Sequence[Array], status: Array, item_status: Array
    ) -> None:
        """Masks what failed and puts the rest where it belongs."""
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
        passed = (status == Status.OK) | (status == Status.PARTIAL) | self.fresh
        for target, array in zip(results, done.outputs, strict=True):
            where = passed.reshape(passed.shape + (1,) * (target.ndim - 1))
            np.copyto(target, array.reshape(target.shape), where=where)
