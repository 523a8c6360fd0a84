"""Evaluation by C that CasADi wrote, one epoch and one item at a time."""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType
from typing import Any

import numpy as np

from ._calls import Function
from ._masked import Computed, MaskedFunction
from ._places import gather
from ._runtime import Array, Extent, Output, Part, Signature, Status, output_shape, outputs_of


class ForeignFunction(MaskedFunction):
    """A function behind CasADi's calling convention: arrays of pointers, columns first."""

    def __init__(self, extension: ModuleType, package: str, signature: Signature) -> None:
        super().__init__(signature)
        self._ffi: Any = extension.ffi
        name = f"{package}_casadi_{signature.name}"
        self._entry = getattr(extension.lib, name)
        sizes = self._ffi.new("long long int[4]")
        getattr(extension.lib, f"{name}_work")(*(sizes + number for number in range(4)))
        self._sizes = tuple(sizes)

    def prepare(self, values: Sequence[Any]) -> list[Array]:
        """NumPy arrays of real numbers."""
        return Function.prepare(self, values)

    def compute(
        self, xp: ModuleType, part: Part, arrays: Sequence[Array], extent: Extent
    ) -> Computed:
        """Loops over epochs and items; results that are not finite count as failed guards."""
        guards, _ = self.guard(xp, arrays)
        noted = self.computed(xp, [], guards, extent)
        # What all items share needs one evaluation even where there is no item.
        items = (max(1 if extent.items is None else extent.items, 1),)
        dense = [np.zeros((*extent.batch, *items, o.size)) for o in self.signature.outputs]
        found = np.zeros((*extent.batch, *items), dtype=np.uint8)
        for place in np.ndindex(found.shape):
            rows = self._one(self._elements(arrays, place))
            for array, row, output in zip(dense, rows, self.signature.outputs, strict=True):
                array[place] = row.reshape(output.shape, order="F").reshape(-1)
            if self.signature.guarded and not all(np.isfinite(row).all() for row in rows):
                found[place] = Status.DOMAIN
        named = dict(zip(self.signature.names, arrays, strict=True))
        outputs = [
            self._shaped(output, array, part, named, extent)
            for output, array in zip(self.signature.outputs, dense, strict=True)
            if output in outputs_of(self.signature, part)
        ]
        if noted.item is None:
            shared = np.where(noted.shared != 0, noted.shared, found[..., 0])
            return Computed.of(np, outputs, shared, None)
        found = found[..., : extent.items]
        return Computed.of(np, outputs, noted.shared, np.where(noted.item != 0, noted.item, found))

    def _elements(self, arrays: Sequence[Array], place: tuple[int, ...]) -> list[Array]:
        """The arguments of one item of one epoch, as contiguous columns of doubles."""
        *epoch, item = place
        elements = []
        for argument, array in zip(self.signature.arguments, arrays, strict=True):
            lead = array.shape[: array.ndim - argument.rank]
            own = epoch[len(epoch) - len(lead) :]
            index = [0 if length == 1 else at for length, at in zip(lead, own, strict=True)]
            row = array[tuple(index)]
            if argument.item:
                row = row[item] if len(row) else np.zeros(argument.size)
            elements.append(np.array(row, dtype=np.float64, ndmin=1))
        return elements

    def _one(self, elements: Sequence[Array]) -> list[Array]:
        """Calls the C once."""
        rows = [np.zeros(output.size) for output in self.signature.outputs]
        new, view = self._ffi.new, self._ffi.from_buffer
        arguments, results, integers, reals = self._sizes
        given = new("const double *[]", max(arguments, len(elements)))
        given[0 : len(elements)] = [view("double[]", array) for array in elements]
        taken = new("double *[]", max(results, len(rows)))
        taken[0 : len(rows)] = [view("double[]", array) for array in rows]
        self._entry(given, taken, new("long long int[]", integers), new("double[]", reals), 0)
        return rows

    def _shaped(
        self,
        output: Output,
        array: Array,
        part: Part,
        named: dict[str, Array],
        extent: Extent,
    ) -> Array:
        """The rows of all items, or the one row that they share."""
        flat = array[..., : extent.items, :] if output.item else array[..., 0, :]
        if part is Part.NONZEROS:
            return gather(output, flat, named)
        return np.array(flat.reshape(output_shape(output, part, extent)), order="C")
