"""Evaluation of many epochs with NumPy, a block at a time.

A block is short enough that its intermediate values stay in the cache. Its arguments are copied so
that each element is one row, contiguous in memory, with items in front of epochs. Guards compare
the smallest and the largest of every row; only a block where one of them is out of range is looked
at in detail. The non-zeros are put together as rows as well and copied to where they belong.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from operator import le
from typing import Any

import numpy as np

from ._calls import Evaluation
from ._explain import norm_defects
from ._kernels import ComplexStep, Guards, Kernel, run
from ._masked import Computed, MaskedFunction
from ._places import columns_of
from ._runtime import (
    Argument,
    Array,
    Extent,
    Kind,
    Output,
    Part,
    Signature,
    Slot,
    Status,
    output_shape,
    outputs_of,
)

#: Numbers in a row: less, and calls take longer than arithmetic; more, and the cache overflows.
LENGTH = 4096

_LARGEST = float(np.finfo(np.float64).max)
_ROUNDING = 1e-14
_GAP = 3


class BlockGuards(Guards):
    """Guards that look closely only at what holds a bad value."""

    def __init__(self, real: Any) -> None:
        super().__init__(np, real)
        self.noted = False

    def check(
        self, value: Array, lower: float, upper: float, substitute: float, status: Status
    ) -> Array:
        """See :class:`Guards`."""
        if _within(value, lower, upper):
            return value
        self.noted = True
        return super().check(value, lower, upper, substitute, status)

    def check_item(
        self, value: Array, lower: float, upper: float, substitute: float, status: Status
    ) -> Array:
        """See :class:`Guards`."""
        if _within(value, lower, upper):
            return value
        self.noted = True
        return super().check_item(value, lower, upper, substitute, status)


def _within(value: Array, lower: float, upper: float) -> bool:
    """True when every number is finite and inside; NaN is not."""
    real = np.real(value)
    if not real.size:
        return True
    return bool(max(lower, -_LARGEST) <= real.min() and real.max() <= min(upper, _LARGEST))


class Table:
    """Arguments that share their axes, as rows of elements."""

    def __init__(self, signature: Signature, given: Sequence[tuple[Argument, Array]]) -> None:
        self._given = given
        self._guarded = [a for a, _ in given if signature.guarded or a.integer]
        self._rows: list[tuple[Argument, list[int | None]]] = []
        self._low: list[float] = []
        self._high: list[float] = []
        self._norms: list[tuple[Kind, slice, float]] = []
        for argument, _ in given:
            self._plan(argument, argument in self._guarded)

    def _plan(self, argument: Argument, guarded: bool) -> None:
        """Finds the rows of the elements that are read, and their bounds."""
        rows: list[int | None] = [None] * argument.size
        for domain in argument.domains:
            if domain.kind is Kind.UNREAD:
                continue
            first = len(self._low)
            rows[domain.start : domain.start + domain.size] = range(first, first + domain.size)
            low = domain.lower if guarded else (-math.inf,) * domain.size
            high = domain.upper if guarded else (math.inf,) * domain.size
            largest = _LARGEST if guarded else math.inf
            self._low += [max(bound, -largest) for bound in low]
            self._high += [min(bound, largest) for bound in high]
            if guarded and domain.kind in (Kind.QUATERNION, Kind.MATRIX):
                self._norms.append((domain.kind, slice(first, len(self._low)), domain.tolerance))
        self._rows.append((argument, rows))

    def read(self, epochs: slice, real: Any) -> tuple[dict[str, Any], bool]:
        """The elements of some epochs by argument, and whether all of them pass."""
        parts = [
            turned for argument, array in self._given for turned in _read(argument, array[epochs])
        ]
        if not parts:
            return {a.name: [None] * a.size for a, _ in self._given}, True
        shape = (len(self._low), *parts[0].shape[1:])
        table = np.concatenate(parts, out=np.empty(shape, dtype=real))
        rows = list(table)
        elements = {
            argument.name: rows[places[0] or 0]
            if argument.scalar
            else [None if place is None else rows[place] for place in places]
            for argument, places in self._rows
        }
        return elements, not table.size or self._passes(np.real(table), rows)

    def _passes(self, table: Array, rows: Sequence[Array]) -> bool:
        flat = table.reshape(len(table), -1)
        lowest, highest = flat.min(axis=1).tolist(), flat.max(axis=1).tolist()
        if not (all(map(le, self._low, lowest)) and all(map(le, highest, self._high))):
            return False
        return all(_normal(kind, flat[own], tolerance) for kind, own, tolerance in self._norms)

    def inspect(self, epochs: slice, guards: Guards) -> None:
        """Looks at every element of some epochs."""
        for argument, array in self._given:
            if argument in self._guarded:
                own = np.real(array[epochs]).astype(np.float64, copy=False)
                guards.load(argument, np.moveaxis(own, 1, 0) if argument.item else own)


def _read(argument: Argument, array: Array) -> Iterator[Array]:
    """The elements that are read as rows, in pieces."""
    if argument.scalar:
        yield array.T[None]
        return
    start, stop = 0, 0
    for domain in (d for d in argument.domains if d.kind is not Kind.UNREAD):
        if domain.start != stop and stop > start:
            yield array.T[start:stop]
        start = start if domain.start == stop and stop > start else domain.start
        stop = domain.start + domain.size
    if stop > start:
        yield array.T[start:stop]


def _normal(kind: Kind, rows: Array, tolerance: float) -> bool:
    """True when all norms are good, the last few roundings left to a closer look."""
    limit = tolerance - _ROUNDING
    if kind is Kind.QUATERNION:
        norm = np.einsum("ij,ij->j", rows, rows)
        return bool(1.0 - limit <= norm.min() and norm.max() <= 1.0 + limit)
    return all(bool(defect.max() <= limit) for defect in norm_defects(kind, list(rows)))


@dataclass(frozen=True, eq=False)
class Layout:
    """How the rows of an output are put together.

    Attributes:
        output: which one.
        number: its place in what the kernel returns.
        size: elements of one item.
        runs: first and last column (exclusive) of what is copied at once, short gaps included.
        complete: True when the runs cover every column.
    """

    output: Output
    number: int
    size: int
    runs: tuple[tuple[int, int], ...]
    complete: bool


def _layout(output: Output, number: int, part: Part) -> Layout:
    if part is Part.NONZEROS:
        size, columns = len(output.places), list(range(len(output.places)))
    else:
        size, columns = output.size, sorted(_columns(output))
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
    return Layout(output, number, size, tuple(runs), runs == [(0, size)])


def _columns(output: Output) -> Iterator[int]:
    """Every column that may hold something else than zero."""
    for place in output.places:
        if isinstance(place, Slot):
            yield from (column for _, column in columns_of(place))
        else:
            yield place


class Rows:
    """Rows of numbers on their way to an output; constant ones are made once."""

    def __init__(self, shape: tuple[int, ...], real: Any) -> None:
        self._shape, self._real = shape, real
        self._constants: dict[float, Array] = {}

    def whole(self, value: Any) -> Array:
        """A row of its full length."""
        if isinstance(value, np.ndarray):
            if value.shape == self._shape:
                return value
            row = np.empty(self._shape, dtype=self._real)
            row[...] = value
            return row
        found = self._constants.get(value)
        if found is None:
            found = self._constants[value] = np.full(self._shape, value, dtype=self._real)
        return found

    def store(self, layout: Layout, rows: Sequence[Any], target: Array) -> None:
        """Writes the rows of some epochs, (epochs, items if any, elements)."""
        if not layout.complete:
            target.fill(0.0)
        for start, stop in layout.runs:
            parts = [self.whole(row) for row in rows[start:stop]]
            if len(parts) == 1:
                target[..., start] = parts[0].T
                continue
            lead, *rest = self._shape
            joined = np.concatenate(parts)
            target[..., start:stop] = joined.reshape(stop - start, lead, *rest).T


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

    def evaluate(
        self,
        part: Part,
        arrays: Sequence[Array],
        extent: Extent,
        out: list[Array] | None,
        reference: int | None = None,
    ) -> Evaluation:
        """Outputs of a part, or all of them as differences to the item ``reference``."""
        count, items, layouts = math.prod(extent.batch), extent.items, self._layouts[part]
        floats = [array.dtype for array in arrays if array.dtype.kind in "fc"]
        real = np.result_type(*floats) if floats else self._function.real
        left = items if items is None or reference is None else items - 1
        outputs = out or [
            np.empty(output_shape(layout.output, part, Extent(extent.batch, left)), dtype=real)
            for layout in layouts
        ]
        status: Array = np.zeros(count, dtype=np.uint8)
        item_status: Array = np.zeros((count, items or 0), dtype=np.uint8)
        block = Block(self._function, self._kernel, part, layouts, reference, out is None, real)
        results = [
            array.reshape((count, *_own(layout, left), layout.size))
            for layout, array in zip(layouts, outputs, strict=True)
        ]
        length = max(LENGTH // max(1, items or 1), 1)
        with np.errstate(all="ignore"):
            sources = list(self._sources(arrays, extent, count))
            for start in range(0, count, length):
                own = slice(start, min(start + length, count))
                found = [result[own] for result in results]
                block.evaluate(sources, own, found, status[own], item_status[own])
        verdict = Status(int(status[0])) if extent.batch == () else status.reshape(extent.batch)
        if items is None:
            return Evaluation(outputs, verdict, None)
        return Evaluation(outputs, verdict, item_status.reshape((*extent.batch, items)))

    def _sources(
        self, arrays: Sequence[Array], extent: Extent, count: int
    ) -> Iterator[tuple[Table, bool]]:
        """The arguments, those with equal axes together, and whether all epochs share them."""
        groups: dict[tuple[bool, bool], list[tuple[Argument, Array]]] = {}
        for argument, array in zip(self._signature.arguments, arrays, strict=True):
            lead = array.shape[: array.ndim - argument.rank]
            own = array.shape[array.ndim - argument.rank :]
            shared = math.prod(lead) == 1 and count != 1
            if not shared and lead != extent.batch:
                array = np.broadcast_to(array, (*extent.batch, *own))
            flat = array.reshape((1 if shared else count, *own))
            groups.setdefault((shared, argument.item), []).append((argument, flat))
        for (shared, _), given in groups.items():
            yield Table(self._signature, given), shared


def _own(layout: Layout, items: int | None) -> tuple[int, ...]:
    """The item axis of an output, where it has one."""
    return (items,) if items is not None and layout.output.item else ()


@dataclass(frozen=True)
class Block:
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
        sources: Sequence[tuple[Table, bool]],
        epochs: slice,
        results: Sequence[Array],
        status: Array,
        item_status: Array,
    ) -> None:
        """Fills in the outputs and the status of some epochs."""
        guards, elements = BlockGuards(self.real), {}
        for table, shared in sources:
            own = slice(0, 1) if shared else epochs
            read, passed = table.read(own, self.real)
            elements.update(read)
            if not passed:
                table.inspect(own, guards)
                guards.noted = True
        signature = self.function.signature
        space = ComplexStep(np) if self.real.kind == "c" else np
        found = run(signature, self.kernel, space, guards, elements)
        count, items = item_status.shape
        rows = [self._rows(layout, found[layout.number], elements) for layout in self.layouts]
        together = Rows((count,), self.real)
        each = Rows((items, count), self.real) if signature.mapped else together
        direct = not guards.noted and self.reference is None
        whole = results if direct else self._room(count, items)
        for layout, own_rows, target in zip(self.layouts, rows, whole, strict=True):
            (each if layout.output.item else together).store(layout, own_rows, target)
        if not direct:
            noted = np.broadcast_to(guards.shared, (count,))
            by_item = np.broadcast_to(guards.item, (items, count)).T if signature.mapped else None
            self._settle(Computed(whole, noted, by_item), results, status, item_status)

    def _rows(
        self, layout: Layout, values: Sequence[Any], elements: dict[str, Any]
    ) -> Sequence[Any]:
        """One row, or number, for every element of an output."""
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
        shapes = (output_shape(layout.output, self.part, extent) for layout in self.layouts)
        outputs = [a.reshape(shape) for a, shape in zip(computed.outputs, shapes, strict=True)]
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
