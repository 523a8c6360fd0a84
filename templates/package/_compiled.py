"""Evaluation by the compiled C of this package."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from ._calls import Evaluation, Function
from ._extension import Library
from ._runtime import (
    Array,
    Extent,
    Output,
    Part,
    Signature,
    Status,
    as_numbers,
    output_shape,
    outputs_of,
)


class CompiledFunction(Function):
    """A function whose entry points for one epoch and for many are compiled C."""

    def __init__(self, library: Library, signature: Signature) -> None:
        super().__init__(signature)
        self.real = library.real
        self._pointer = library.pointer
        self._longest = signature.maximum or 0
        both = bool(signature.values and signature.jacobians)
        suffixes = {Part.ALL: "", Part.VALUE: "_value", Part.JACOBIAN: "_jacobian"}
        self._entries = {
            part: library.entry(signature.name + (suffix if both else ""))
            for part, suffix in suffixes.items()
        }
        if any(output.places for output in signature.jacobians):
            self._entries[Part.NONZEROS] = library.entry(f"{signature.name}_nz")
        self._library = library
        self._batch = library.entry(f"{signature.name}_batch")
        if Part.NONZEROS in self._entries:
            self._batch_nonzeros = library.entry(f"{signature.name}_batch_nz")
        if not signature.mapped:
            self._blocks = library.entry(f"{signature.name}_blocks")
        if signature.single_difference:
            self._differences = library.entry(f"{signature.name}_sd")

    def given(self, out: Any, arrays: Sequence[Array], items: int | None = None) -> list[Array]:
        """The arrays given as ``out`` for one epoch, where they can be written as they are.

        Arrays that own their memory cannot overlap; others are looked at.

        Raises:
            ValueError: when they cannot; the general way says why.
        """
        wanted = self.signature.outputs
        listed = [out] if type(out) is np.ndarray else list(out)[: len(wanted)]
        if len(listed) != len(wanted) or type(out) is dict:
            raise ValueError("out")
        for place, (array, output) in enumerate(zip(listed, wanted, strict=True)):
            shape = output.shape if items is None or not output.item else (items, *output.shape)
            flags = array.flags
            fits = type(array) is np.ndarray and array.dtype == self.real and array.shape == shape
            if not fits or not flags.carray:
                raise ValueError("out")
            own = flags.owndata
            for other in (*arrays, *listed[:place]):
                apart = own and other.base is None and other is not array
                if not apart and np.may_share_memory(array, other):
                    raise ValueError("out")
        return listed

    def prepare(self, values: Sequence[Any]) -> list[Array]:
        """Real arrays of the compiled type; complex numbers are refused."""
        pairs = zip(self.signature.arguments, values, strict=True)
        return [as_numbers(argument, value, self.real, False) for argument, value in pairs]

    def evaluate(
        self, part: Part, arrays: Sequence[Array], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """One epoch by its own entry point, more by the batch loop."""
        if extent.batch == ():
            return self._once(part, arrays, extent, out)
        return self._many(part, arrays, extent, out)

    def difference(
        self, arrays: Sequence[Array], extent: Extent, reference: int, out: list[Array] | None
    ) -> Evaluation:
        """Epoch by epoch, since the differenced form has no batch loop."""
        if extent.batch == ():
            return self._once(Part.ALL, arrays, extent, out, reference)
        items = extent.items or 0
        outputs = self._allocate(self.signature.outputs, Extent(extent.batch, items - 1), out)
        status: Array = np.empty(extent.batch, dtype=np.uint8)
        item_status: Array = np.zeros((*extent.batch, items), dtype=np.uint8)
        spread = self._spread(arrays, extent)
        for epoch in np.ndindex(extent.batch):
            own = [array[epoch] for array in spread]
            rows = [array[(*epoch, ...)] for array in outputs]
            done = self._once(Part.ALL, own, Extent((), items), rows, reference)
            status[epoch], item_status[epoch] = done.status, done.item_status
        return self._voided(Evaluation(outputs, status, item_status), out)

    def bound(self, arrays: Sequence[Array], extent: Extent, out: list[Array]) -> Callable[[], Any]:
        """Pointers made once; what is left of a call is the C and a look at its status."""
        if self.signature.column_major:
            return super().bound(arrays, extent, out)
        if extent.batch != ():
            return self._bound_batch(arrays, extent, out)
        items = self._item_status(extent)
        first, *rest = map(self._pointer, [*arrays, *out, *items])
        run = partial(self._entries[Part.ALL], first, *_numbers(extent), *rest)
        item_status = items[0] if items else None
        done = self.result(Evaluation(out, Status.OK, item_status), arrays)

        def call() -> Any:
            status = run()
            if status:
                return self.result(Evaluation(out, Status(status), item_status), arrays)
            return done

        return call

    def _bound_batch(
        self, arrays: Sequence[Array], extent: Extent, out: list[Array]
    ) -> Callable[[], Any]:
        """The same for the batch loop, unless an argument must be spread over some axes first."""
        if not all(_lies_ready(array, rank, extent) for array, rank in self._ranked(arrays)):
            return super().bound(arrays, extent, out)
        status, items = self._statuses(extent)
        calls = self._shared(self._batch, arrays, extent, [*out, status, *items])
        run = calls[0] if len(calls) == 1 else partial(self._library.run, calls)
        evaluation = Evaluation(out, status, items[0] if items else None)
        done = self.result(evaluation, arrays)

        def call() -> Any:
            run()
            return done

        return call

    def _once(
        self,
        part: Part,
        arrays: Sequence[Array],
        extent: Extent,
        out: list[Array] | None,
        reference: int | None = None,
    ) -> Evaluation:
        """Calls an entry point for one epoch."""
        entry, numbers, rows = self._entries[part], _numbers(extent), extent
        longest = self._longest
        if reference is not None:
            entry, numbers = self._differences, (*numbers, reference)
            rows, longest = Extent((), (extent.items or 0) - 1), longest - 1
        wanted = outputs_of(self.signature, part)
        given = dict(zip((output.name for output in wanted), out or (), strict=False))
        buffers, results = [], []
        for output in self.signature.outputs if part is Part.NONZEROS else wanted:
            nonzeros = part is Part.NONZEROS and output.jacobian
            buffer, view = self._memory(output, nonzeros, rows, longest, given.get(output.name))
            buffers += [buffer] if output.places or not nonzeros else []
            results += [view] if output in wanted else []
        items = self._item_status(extent)
        inputs = [np.ascontiguousarray(array) for array in arrays]
        first, *rest = map(self._pointer, [*inputs, *buffers, *items])
        status = Status(entry(first, *numbers, *rest))
        if out is not None and status in (Status.OK, Status.PARTIAL):
            for target, result in zip(out, results, strict=True):
                if target is not result:
                    np.copyto(target, result)
        return Evaluation(out or results, status, items[0] if items else None)

    def _memory(
        self, output: Output, nonzeros: bool, extent: Extent, longest: int, given: Array | None
    ) -> tuple[Array, Array]:
        """What the C writes to, and the same memory with the axes of the result.

        Non-zeros of items lie in columns as long as the most items, and so do rows of items where
        Jacobians are stored by column.
        """
        items = extent.items if output.item else None
        by_column = self.signature.column_major and output.jacobian and not nonzeros
        if nonzeros and items is not None:
            columns = np.zeros((len(output.places), longest), dtype=self.real)
            return columns, columns[:, :items].T
        if by_column:
            height = output.shape[0] if len(output.shape) > 1 else 1
            length = 1 if items is None else longest
            columns = np.zeros((output.shape[-1], length, height), dtype=self.real)
            view = columns.transpose(1, 2, 0)[: 1 if items is None else items]
            # Only axes of length one go, so that this stays a view.
            return columns, view.reshape(output_shape(output, Part.ALL, extent))
        shape = output_shape(output, Part.NONZEROS if nonzeros else Part.ALL, extent)
        array = np.empty(shape, dtype=self.real) if given is None else given
        return array, array

    def evaluate_blocks(
        self,
        arrays: Sequence[Array],
        epochs: int,
        outputs: Mapping[str, Array],
        status: Array,
    ) -> None:
        """Blocks are what the C reads and writes in place."""
        self.bound_blocks(arrays, epochs, outputs, status)()

    def bound_blocks(
        self,
        arrays: Sequence[Array],
        epochs: int,
        outputs: Mapping[str, Array],
        status: Array,
    ) -> Callable[[], Any]:
        """One call for all blocks, or one for each thread, which then has whole blocks."""
        stored = [outputs[output.name] for output in self.signature.outputs if _is_stored(output)]
        lanes, memory = self.signature.lanes, [*arrays, *stored]
        calls = []
        for first, number in self._library.shares(-(-epochs // lanes), lanes):
            start = first * lanes
            count = min(number * lanes, epochs - start)
            places = [self._pointer(array[first : first + number]) for array in memory]
            places.append(self._pointer(status[start : start + count]))
            calls.append(partial(self._blocks, count, *places))
        return calls[0] if len(calls) == 1 else partial(self._library.run, calls)

    def _many(
        self, part: Part, arrays: Sequence[Array], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """Calls the loop over epochs, which stores every output, by row."""
        if part is Part.NONZEROS:
            return self._many_nonzeros(arrays, extent, out)
        wanted = outputs_of(self.signature, part)
        given = dict(zip((output.name for output in wanted), out or (), strict=False))
        whole = {
            output.name: given[output.name]
            if output.name in given
            else np.empty(output_shape(output, Part.ALL, extent), dtype=self.real)
            for output in self.signature.outputs
        }
        status, items = self._statuses(extent)
        memory = [*whole.values(), status, *items]
        self._library.run(self._shared(self._batch, arrays, extent, memory))
        results = [whole[output.name] for output in wanted]
        evaluation = Evaluation(out or results, status, items[0] if items else None)
        return self._voided(evaluation, out)

    def _many_nonzeros(
        self, arrays: Sequence[Array], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """The same for non-zeros, which lie in columns where there are items."""
        given = dict(zip((o.name for o in self.signature.jacobians), out or (), strict=False))
        memory, results = [], []
        for output in self.signature.outputs:
            shape = output_shape(output, Part.NONZEROS if output.jacobian else Part.ALL, extent)
            columns = output.jacobian and output.item and extent.items is not None
            if columns:
                array = np.empty((*shape[:-2], shape[-1], shape[-2]), dtype=self.real)
            else:
                array = given.get(output.name)
                array = np.empty(shape, dtype=self.real) if array is None else array
            memory += [array] if _is_stored(output) else []
            if output.jacobian:
                results.append(np.swapaxes(array, -1, -2) if columns else array)
        status, items = self._statuses(extent)
        if Part.NONZEROS in self._entries:
            calls = self._shared(self._batch_nonzeros, arrays, extent, [*memory, status, *items])
            self._library.run(calls)
        else:
            status = self._many(Part.VALUE, arrays, extent, None).status
        passed = (status == Status.OK) | (status == Status.PARTIAL)
        for target, result in zip(out or (), results, strict=False):
            if target is not result:
                where = passed.reshape(passed.shape + (1,) * (result.ndim - passed.ndim))
                np.copyto(target, result, where=where)
        evaluation = Evaluation(out or results, status, items[0] if items else None)
        return self._voided(evaluation, out)

    def _shared(
        self,
        entry: Callable[..., int],
        arrays: Sequence[Array],
        extent: Extent,
        memory: Sequence[Array],
    ) -> list[Callable[[], Any]]:
        """The call of a loop over epochs, or one for each thread; the first keeps memory alive.

        Args:
            entry: the loop.
            arrays: arguments.
            extent: epochs and items.
            memory: outputs and statuses, each with one part per epoch.
        """
        epochs, numbers = math.prod(extent.batch), _numbers(extent)
        inputs = [_stepped(array, rank, extent) for array, rank in self._ranked(arrays)]
        read = [(self._pointer(array), step) for array, step in inputs]
        written = [(self._pointer(array), array.size // max(epochs, 1)) for array in memory]
        calls: list[Callable[[], Any]] = []
        for first, count in self._library.shares(epochs):
            passed: list[Any] = []
            for pointer, step in read:
                passed += [pointer + first * step if first else pointer, step]
                passed += numbers if len(passed) == 2 else ()
            passed += [pointer + first * step if first else pointer for pointer, step in written]
            calls.append(partial(entry, count, *passed))
        return calls

    def _statuses(self, extent: Extent) -> tuple[Array, list[Array]]:
        """Room for the status of every epoch and item."""
        items = [np.zeros((*extent.batch, number), dtype=np.uint8) for number in _numbers(extent)]
        return np.empty(extent.batch, dtype=np.uint8), items

    def _allocate(
        self, outputs: Sequence[Output], extent: Extent, out: list[Array] | None
    ) -> list[Array]:
        return out or [
            np.empty(output_shape(output, Part.ALL, extent), dtype=self.real) for output in outputs
        ]

    def _voided(self, evaluation: Evaluation, out: list[Array] | None) -> Evaluation:
        """NaN in new arrays where an epoch failed; arrays that were given stay as they are."""
        status = evaluation.status
        if out is not None or not status.any():
            return evaluation
        failed = (status != Status.OK) & (status != Status.PARTIAL)
        if failed.any():
            for array in evaluation.outputs:
                array[failed] = np.nan
        return evaluation

    def _item_status(self, extent: Extent) -> list[Array]:
        """Room for the status of every item, where the function is mapped."""
        return [] if extent.items is None else [np.zeros(extent.items, dtype=np.uint8)]

    def _ranked(self, arrays: Sequence[Array]) -> list[tuple[Array, int]]:
        ranks = (argument.rank for argument in self.signature.arguments)
        return list(zip(arrays, ranks, strict=True))

    def _spread(self, arrays: Sequence[Array], extent: Extent) -> list[Array]:
        """Arguments with all their leading axes."""
        return [_spread(array, rank, extent) for array, rank in self._ranked(arrays)]


def _is_stored(output: Output) -> bool:
    """True when calls for non-zeros store an output: values, and Jacobians that have some."""
    return not output.jacobian or bool(output.places)


def _numbers(extent: Extent) -> tuple[int, ...]:
    """The number of items, where there is one."""
    return () if extent.items is None else (extent.items,)


def _spread(array: Array, rank: int, extent: Extent) -> Array:
    own = array.shape[array.ndim - rank :]
    return np.broadcast_to(array, (*extent.batch, *own))


def _lies_ready(array: Array, rank: int, extent: Extent) -> bool:
    """True when the batch loop can read an argument where it lies."""
    lead = array.shape[: array.ndim - rank]
    return lead == extent.batch or all(length == 1 for length in lead)


def _stepped(array: Array, rank: int, extent: Extent) -> tuple[Array, int]:
    """Memory of an argument and the distance between its epochs, zero when all share one."""
    lead, own = array.shape[: array.ndim - rank], array.shape[array.ndim - rank :]
    step = math.prod(own)
    if lead == extent.batch:
        return np.ascontiguousarray(array), step
    if all(length == 1 for length in lead):
        return np.ascontiguousarray(array), 0
    return np.ascontiguousarray(_spread(array, rank, extent)), step
