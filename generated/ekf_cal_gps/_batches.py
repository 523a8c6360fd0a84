"""Many epochs in one call of the compiled C: rows, non-zeros and blocks, by one thread or more."""

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
    output_shape,
    outputs_of,
)
from ._straight import Straight, void


class BatchFunction(Function):
    """What a compiled function does with many epochs."""

    def __init__(self, library: Library, signature: Signature) -> None:
        super().__init__(signature)
        self.real = library.real
        self._library = library
        self._pointer = library.pointer
        self._longest = signature.maximum or 0
        self._batch = library.entry(f"{signature.name}_batch")
        sparse = any(output.places for output in signature.jacobians)
        self._batch_nonzeros = library.entry(f"{signature.name}_batch_nz") if sparse else None
        self._rows = Straight(library, signature, Part.ALL)
        whole = sparse and all(output.places for output in signature.jacobians)
        self._sparse_rows = Straight(library, signature, Part.NONZEROS) if whole else None
        if not signature.mapped:
            self._blocks = library.entry(f"{signature.name}_blocks")

    def call(self, state: Sequence[Any], inputs: Mapping[str, Any], out: Any = None) -> Any:
        """All outputs; arrays with one leading axis go straight to the loop over epochs."""
        found = self._rows.evaluate(state, inputs, out)
        if found is None:
            return super().call(state, inputs, out)
        arrays, statuses = found
        return tuple.__new__(self.signature.result, (*arrays, *statuses))

    def select(
        self, part: Part, state: Sequence[Any], inputs: Mapping[str, Any], out: Any = None
    ) -> Any:
        """The same for the non-zeros alone; those of items lie in columns."""
        straight = self._sparse_rows if part is Part.NONZEROS else None
        found = None if straight is None else straight.evaluate(state, inputs, out)
        if straight is None or found is None:
            return super().select(part, state, inputs, out)
        arrays = list(straight.given(out)) if out is not None else self._as_called(found[0])
        return arrays[0] if len(arrays) == 1 else tuple(arrays)

    def _as_called(self, stored: Sequence[Array]) -> list[Array]:
        """The non-zeros among what the C has stored, with the items in front."""
        pairs = zip(stored, self.signature.outputs, strict=True)
        jacobians = [(array, output) for array, output in pairs if output.jacobian]
        if not self.signature.mapped:
            return [array for array, _ in jacobians]
        return [np.swapaxes(a, -1, -2) if o.item else a for a, o in jacobians]

    def _bound_batch(
        self, arrays: Sequence[Array], extent: Extent, out: list[Array]
    ) -> Callable[[], Any]:
        """The same for the batch loop, unless an argument must be spread over some axes first."""
        if not all(lies_ready(array, rank, extent) for array, rank in self._ranked(arrays)):
            return Function.bound(self, arrays, extent, out)
        status, items = self._statuses(extent)
        calls = self._shared(
            self._batch, self._stepped(arrays, extent), extent, [*out, status, *items]
        )
        run = calls[0] if len(calls) == 1 else partial(self._library.run, calls)
        evaluation = Evaluation(out, status, items[0] if items else None)
        done = self.result(evaluation, arrays)

        def call() -> Any:
            run()
            return done

        return call

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
            return self._nonzeros(self._stepped(arrays, extent), extent, out)
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
        read = self._stepped(arrays, extent)
        self._library.run(self._shared(self._batch, read, extent, memory))
        results = [whole[output.name] for output in wanted]
        evaluation = Evaluation(out or results, status, items[0] if items else None)
        return voided(evaluation, out)

    def _nonzeros(
        self, read: Sequence[tuple[Array, int]], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """The same for non-zeros, which lie in columns where there are items."""
        given = dict(zip((o.name for o in self.signature.jacobians), out or (), strict=False))
        memory, results = [], []
        for output in self.signature.outputs:
            shape = output_shape(output, Part.NONZEROS if output.jacobian else Part.ALL, extent)
            columns = output.jacobian and output.item and extent.items is not None
            if columns:
                shape = (*shape[:-2], shape[-1], shape[-2])
            ready = output.name in given and not columns
            array: Array = given[output.name] if ready else np.empty(shape, dtype=self.real)
            if _is_stored(output):
                memory.append(array)
            elif not self._batch_nonzeros:
                whole = output_shape(output, Part.ALL, extent)
                memory.append(np.empty(whole, dtype=self.real))
            if output.jacobian:
                results.append(np.swapaxes(array, -1, -2) if columns else array)
        status, items = self._statuses(extent)
        entry = self._batch_nonzeros or self._batch
        self._library.run(self._shared(entry, read, extent, [*memory, status, *items]))
        passed = (status == Status.OK) | (status == Status.PARTIAL)
        for target, result in zip(out or (), results, strict=False):
            if target is not result:
                where = passed.reshape(passed.shape + (1,) * (result.ndim - passed.ndim))
                np.copyto(target, result, where=where)
        evaluation = Evaluation(out or results, status, items[0] if items else None)
        return voided(evaluation, out)

    def _shared(
        self,
        entry: Callable[..., int],
        read: Sequence[tuple[Array, int]],
        extent: Extent,
        memory: Sequence[Array],
    ) -> list[Callable[[], Any]]:
        """The call of a loop over epochs, or one for each thread; the first keeps memory alive.

        Args:
            entry: the loop.
            read: arguments, with the step of each from epoch to epoch.
            extent: epochs and items.
            memory: outputs and statuses, each with one part per epoch.
        """
        epochs, items = math.prod(extent.batch), numbers(extent)
        inputs = [(self._pointer(array), step) for array, step in read]
        written = [(self._pointer(array), array.size // max(epochs, 1)) for array in memory]
        calls: list[Callable[[], Any]] = []
        passed: list[Any]
        for first, count in self._library.shares(epochs):
            passed = []
            for pointer, step in inputs:
                passed += [pointer + first * step if first else pointer, step]
                passed += items if len(passed) == 2 else ()
            passed += [pointer + first * step if first else pointer for pointer, step in written]
            calls.append(partial(entry, count, *passed))
        return calls

    def _stepped(self, arrays: Sequence[Array], extent: Extent) -> list[tuple[Array, int]]:
        """Arguments with the step of each from epoch to epoch, spread where they have to be."""
        return [_stepped(array, rank, extent) for array, rank in self._ranked(arrays)]

    def _statuses(self, extent: Extent) -> tuple[Array, list[Array]]:
        """Room for the status of every epoch and item."""
        items = [np.zeros((*extent.batch, number), dtype=np.uint8) for number in numbers(extent)]
        return np.empty(extent.batch, dtype=np.uint8), items

    def _ranked(self, arrays: Sequence[Array]) -> list[tuple[Array, int]]:
        ranks = (argument.rank for argument in self.signature.arguments)
        return list(zip(arrays, ranks, strict=True))


def voided(evaluation: Evaluation, out: list[Array] | None) -> Evaluation:
    """NaN in new arrays where an epoch failed; arrays that were given stay as they are."""
    if out is None and evaluation.status.any():
        void(evaluation.outputs, evaluation.status)
    return evaluation


def _is_stored(output: Output) -> bool:
    """True when calls for non-zeros store an output: values, and Jacobians that have some."""
    return not output.jacobian or bool(output.places)


def numbers(extent: Extent) -> tuple[int, ...]:
    """The number of items, where there is one."""
    return () if extent.items is None else (extent.items,)


def spread(array: Array, rank: int, extent: Extent) -> Array:
    own = array.shape[array.ndim - rank :]
    return np.broadcast_to(array, (*extent.batch, *own))


def lies_ready(array: Array, rank: int, extent: Extent) -> bool:
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
    return np.ascontiguousarray(spread(array, rank, extent)), step
