"""Evaluation by the compiled C of this package."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from ._batches import BatchFunction, numbers, spread, voided
from ._calls import Evaluation
from ._extension import UNFIT, Library
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


class CompiledFunction(BatchFunction):
    """A function whose entry points for one epoch and for many are compiled C."""

    def __init__(self, library: Library, signature: Signature) -> None:
        super().__init__(library, signature)
        both = bool(signature.values and signature.jacobians)
        suffixes = {Part.ALL: "", Part.VALUE: "_value", Part.JACOBIAN: "_jacobian"}
        self._entries = {
            part: library.entry(signature.name + (suffix if both else ""))
            for part, suffix in suffixes.items()
        }
        if any(output.places for output in signature.jacobians):
            self._entries[Part.NONZEROS] = library.entry(f"{signature.name}_nz")
        self._keywords = tuple(name for name in signature.names if name != "x")
        if signature.single_difference:
            self._differences = library.entry(f"{signature.name}_sd")
            name = f"{signature.name}.single_difference"
            self._difference_call = library.call(name, signature.result)

    def evaluate(
        self, part: Part, arrays: Sequence[Array], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """One epoch by its own entry point, more by the batch loop."""
        if extent.batch == ():
            return self._once(part, arrays, extent, out)
        return self._many(part, arrays, extent, out)

    def selector(self, part: Part) -> Callable[..., Any]:
        """One epoch of arrays as the C wants them goes straight to it."""
        general, signature = super().selector(part), self.signature
        apart = part is Part.NONZEROS or bool(signature.values and signature.jacobians)
        call = self._library.call(f"{signature.name}.{part.value}" if apart else signature.name)

        def select(state: Sequence[Any], inputs: Mapping[str, Any], out: Any = None) -> Any:
            given = self._in_order(state, inputs)
            found = None if given is None else call(*given, out)
            return general(state, inputs, out) if found is None else found

        return select if outputs_of(signature, part) else general

    def single_difference(
        self, state: Sequence[Any], inputs: Mapping[str, Any], reference: int, out: Any = None
    ) -> Any:
        """One epoch of arrays as the C wants them goes straight to it."""
        given = self._in_order(state, inputs)
        if given:
            found = self._difference_call(given[0], reference, *given[1:], out)
            if found is not None:
                return found
        return super().single_difference(state, inputs, reference, out)

    def _in_order(self, state: Sequence[Any], inputs: Mapping[str, Any]) -> tuple[Any, ...] | None:
        """All arguments in order; nothing where names are missing or unknown."""
        if len(inputs) != len(self._keywords):
            return None
        try:
            return (*state, *map(inputs.__getitem__, self._keywords))
        except KeyError:
            return None

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
        return voided(Evaluation(outputs, status, item_status), out)

    def bound(self, arrays: Sequence[Array], extent: Extent, out: list[Array]) -> Callable[[], Any]:
        """A call that C takes, which looks at the arrays every time, or pointers to them."""
        if self.signature.column_major:
            return super().bound(arrays, extent, out)
        if extent.batch != ():
            return self._bound_batch(arrays, extent, out)
        items = self._item_status(extent)
        memory = (*arrays, *out, *items)
        first, *rest = map(self._pointer, memory)
        run = partial(self._entries[Part.ALL], first, *numbers(extent), *rest)
        name, places = self.signature.name, [_place(one) for one in memory]
        item_status = items[0] if items else None
        done = self.result(Evaluation(out, Status.OK, item_status), arrays)

        def finished(status: int) -> Any:
            if status == Status.OK:
                return done
            return self.result(Evaluation(out, Status(status), item_status), arrays)

        def otherwise(status: int) -> Any:
            if status != UNFIT:
                return finished(status)
            if [_place(one) for one in memory] != places:
                raise ValueError(f"{name}: an array was resized, retyped or locked since bind")
            return finished(run())

        return self._library.bound(name, memory, done, otherwise) or (lambda: finished(run()))

    def _once(
        self,
        part: Part,
        arrays: Sequence[Array],
        extent: Extent,
        out: list[Array] | None,
        reference: int | None = None,
    ) -> Evaluation:
        """Calls an entry point for one epoch."""
        entry, counts, rows = self._entries[part], numbers(extent), extent
        longest = self._longest
        if reference is not None:
            entry, counts = self._differences, (*counts, reference)
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
        status = Status(entry(first, *counts, *rest))
        if out is not None and status in (Status.OK, Status.PARTIAL):
            for target, result in zip(out, results, strict=True):
                if target is not result:
                    np.copyto(target, result)
        # What lies in columns is turned, so that it can be written to again.
        fresh = out or [np.asarray(result, order="C") for result in results]
        return Evaluation(fresh, status, items[0] if items else None)

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

    def _allocate(
        self, outputs: Sequence[Output], extent: Extent, out: list[Array] | None
    ) -> list[Array]:
        return out or [
            np.empty(output_shape(output, Part.ALL, extent), dtype=self.real) for output in outputs
        ]

    def _item_status(self, extent: Extent) -> list[Array]:
        """Room for the status of every item, where the function is mapped."""
        return [] if extent.items is None else [np.zeros(extent.items, dtype=np.uint8)]

    def _spread(self, arrays: Sequence[Array], extent: Extent) -> list[Array]:
        """Arguments with all their leading axes."""
        return [spread(array, rank, extent) for array, rank in self._ranked(arrays)]


def _place(array: Array) -> tuple[Any, ...]:
    """Where an array lies, of what kind it is and whether it is writable; any shape will do."""
    return (*array.__array_interface__["data"], array.nbytes, array.dtype)
