"""Evaluation with arrays of any library that follows the array API standard.

Arrays of another library stay there: leading axes pass through, then the item axis where there is
one (arguments shared by all items have length one there). NumPy's are evaluated in blocks, and one
epoch of ordinary numbers as such; see ``_blocks.py`` and ``_numbers.py``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import ModuleType
from typing import Any

import numpy as np

from ._blocks import Blocks, Plan
from ._calls import Evaluation
from ._kernels import ComplexStep, Guards, Kernel, Mapped, Nonzeros, is_complex, run
from ._masked import Computed, MaskedFunction
from ._numbers import Epoch
from ._places import columns_of, index_of
from ._runtime import (
    Array,
    Extent,
    Output,
    Part,
    Signature,
    Slot,
    collect,
    measure,
    output_shape,
    outputs_of,
)

#: Shapes of arguments that are remembered; more, and all are forgotten.
_MOST_PLANS = 32

__all__ = ["ArrayFunction", "Guards", "Mapped", "Nonzeros"]


class Elements(Sequence[Array]):
    """The elements along the last axis of an array, taken when they are asked for."""

    def __init__(self, array: Array) -> None:
        self._array = array

    def __getitem__(self, place: Any) -> Array:
        return self._array[..., place]

    def __len__(self) -> int:
        return int(self._array.shape[-1])


class ArrayFunction(MaskedFunction):
    """A function whose kernel works on numbers and on whole arrays alike."""

    def __init__(self, signature: Signature, kernel: Kernel) -> None:
        super().__init__(signature)
        self._kernel = kernel
        self._epoch = Epoch(signature, kernel)
        self._blocks = Blocks(self, kernel)
        self._plans: dict[tuple[Any, ...], tuple[Plan, Sequence[int]]] = {}

    def call(self, state: Sequence[Any], inputs: Mapping[str, Any], out: Any = None) -> Any:
        """All outputs; one epoch of ordinary numbers, and known shapes, take the short way."""
        if out is not None:
            return super().call(state, inputs, out)
        if not state or getattr(state[0], "ndim", 1) == 1:
            found = self._epoch.evaluate(state, inputs)
            if found is not None:
                return tuple.__new__(self.signature.result, found)
        given = [*state, *inputs.values()]
        for value in given:
            if type(value) is not np.ndarray:
                return super().call(state, inputs)
        key = (*inputs, *[(value.shape, value.dtype) for value in given])
        known = self._plans.get(key)
        if known is None:
            return self._first(key, state, inputs, given)
        plan, order = known
        arrays = [given[place] for place in order]
        return self.result(plan.run(arrays, None), arrays)

    def _first(
        self,
        key: tuple[Any, ...],
        state: Sequence[Any],
        inputs: Mapping[str, Any],
        given: Sequence[Array],
    ) -> Any:
        """The first call for some types and shapes: keeps its plan if it converts nothing."""
        arrays = self.prepare(collect(self.signature, state, inputs))
        plan = self._blocks.plan(Part.ALL, arrays, measure(self.signature, arrays))
        places = {id(array): place for place, array in enumerate(given)}
        if len(places) == len(given) and places.keys() == {id(array) for array in arrays}:
            if len(self._plans) >= _MOST_PLANS:
                self._plans.clear()
            self._plans[key] = plan, [places[id(array)] for array in arrays]
        return self.result(plan.run(arrays, None), arrays)

    def evaluate(
        self, part: Part, arrays: Sequence[Array], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """NumPy's arrays in blocks; another library's in one go."""
        if isinstance(arrays[0], np.ndarray):
            return self._blocks.plan(part, arrays, extent).run(arrays, out)
        return super().evaluate(part, arrays, extent, out)

    def difference(
        self, arrays: Sequence[Array], extent: Extent, reference: int, out: list[Array] | None
    ) -> Evaluation:
        """The same for differences."""
        if isinstance(arrays[0], np.ndarray):
            return self._blocks.plan(Part.ALL, arrays, extent, reference).run(arrays, out)
        return super().difference(arrays, extent, reference, out)

    def compute(
        self, xp: ModuleType, part: Part, arrays: Sequence[Array], extent: Extent
    ) -> Computed:
        """Runs the kernel and assembles its non-zeros."""
        guards, wide = self.guard(xp, arrays)
        named = dict(zip(self.signature.names, wide, strict=True))
        found = self.run(ComplexStep(xp) if is_complex(xp, guards.real) else xp, guards, wide)
        wanted = outputs_of(self.signature, part)
        outputs = []
        for output, values in zip(self.signature.outputs, found, strict=True):
            if output not in wanted:
                continue
            places = range(len(values)) if part is Part.NONZEROS else output.places
            size = len(values) if part is Part.NONZEROS else output.size
            lead = (*extent.batch, *_items(output, extent))
            flat = _stack(xp, values, places, named, (*lead, size), guards.real)
            outputs.append(xp.reshape(flat, output_shape(output, part, extent)))
        return self.computed(xp, outputs, guards, extent)

    def run(self, xp: Any, guards: Any, arrays: Sequence[Array]) -> list[Sequence[Any]]:
        """The non-zeros of every output for arguments that line up."""
        elements = {
            argument.name: array if argument.scalar else Elements(array)
            for argument, array in zip(self.signature.arguments, arrays, strict=True)
        }
        return run(self.signature, self._kernel, xp, guards, elements)


def _items(output: Output, extent: Extent) -> tuple[int, ...]:
    if extent.items is None:
        return ()
    return (extent.items,) if output.item else (1,)


def _stack(
    xp: ModuleType,
    values: Sequence[Any],
    places: Sequence[int | Slot],
    arguments: dict[str, Array],
    shape: tuple[int, ...],
    dtype: Any,
) -> Array:
    """Joins non-zeros and broadcast zeros; writes nowhere, as tracing libraries ask."""
    if not shape[-1]:
        return xp.zeros(shape, dtype=dtype)
    zero = xp.zeros((), dtype=dtype)
    columns = [zero] * shape[-1]
    for value, place in zip(values, places, strict=True):
        if isinstance(place, Slot):
            index = index_of(place, arguments)
            for number, column in columns_of(place):
                columns[column] = xp.where(index == number, value, columns[column])
        else:
            columns[place] = xp.asarray(value, dtype=dtype)
    return xp.stack([xp.broadcast_to(column, shape[:-1]) for column in columns], axis=-1)
