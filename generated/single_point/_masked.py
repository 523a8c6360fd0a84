"""Evaluation of whole arrays whose failed epochs and items are masked at the end."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from ._calls import Evaluation, Function
from ._kernels import ComplexStep, Guards, is_float
from ._runtime import (
    Array,
    Extent,
    Output,
    Part,
    Status,
    as_numbers,
    outputs_of,
)


class Computed(NamedTuple):
    """What comes out of the arithmetic, before failures are masked.

    Attributes:
        outputs: whole arrays of the part that was asked for.
        shared: status of the shared part, over the leading axes.
        item: status of every item, or None.
    """

    outputs: list[Array]
    shared: Array
    item: Array | None

    @classmethod
    def of(cls, xp: Any, outputs: list[Array], shared: Array, item: Array | None) -> Computed:
        """From what guards noted; of an epoch whose shared part failed items have no status."""
        if item is not None:
            item = xp.where(shared[..., None] != 0, xp.zeros_like(item), item)
        return cls(outputs, shared, item)


class MaskedFunction(Function):
    """A function of arrays of any library; what failed is found out while it is computed."""

    def prepare(self, values: Sequence[Any]) -> list[Array]:
        """Keeps arrays of another library (and complex ones); everything else becomes NumPy."""
        xp = namespace_of(values)
        pairs = zip(self.signature.arguments, values, strict=True)
        if xp is np:
            return [as_numbers(argument, value, self.real, True) for argument, value in pairs]
        arrays = [xp.asarray(value) for value in values]
        for argument, array in zip(self.signature.arguments, arrays, strict=True):
            if argument.integer and array.size and not xp.isdtype(array.dtype, "integral"):
                raise TypeError(f"{argument.name}: expected integers, got {array.dtype}")
        floats = [array.dtype for array in arrays if is_float(xp, array.dtype)]
        real = xp.result_type(*floats) if floats else xp.asarray(0.0).dtype
        return [
            array if argument.integer or array.dtype in floats else xp.asarray(array, dtype=real)
            for argument, array in zip(self.signature.arguments, arrays, strict=True)
        ]

    def type_of(self, arrays: Sequence[Array]) -> np.dtype[Any]:
        """Complex where an argument is."""
        mixed = [array.dtype for array in arrays if array.dtype.kind == "c"]
        return np.result_type(self.real, *mixed)

    def evaluate(
        self, part: Part, arrays: Sequence[Array], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """Computes, then masks what failed."""
        xp = arrays[0].__array_namespace__()
        with np.errstate(all="ignore"):
            computed = self.compute(xp, part, arrays, extent)
        return self.finish(xp, part, computed, extent, out)

    def difference(
        self, arrays: Sequence[Array], extent: Extent, reference: int, out: list[Array] | None
    ) -> Evaluation:
        """Differences of whole arrays."""
        xp = arrays[0].__array_namespace__()
        with np.errstate(all="ignore"):
            computed = self.compute(xp, Part.ALL, arrays, extent)
            computed = self.differenced(xp, computed, reference)
        return self.finish(xp, Part.ALL, computed, extent, out, reference)

    def differenced(self, xp: ModuleType, computed: Computed, reference: int) -> Computed:
        """All outputs less the reference's; without it an epoch fails."""
        outputs = [
            subtract(xp, output, array, reference) if output.item else array
            for output, array in zip(self.signature.outputs, computed.outputs, strict=True)
        ]
        shared, item = computed.shared, computed.item
        assert item is not None
        if self.signature.reject:
            return Computed(outputs, shared, item)
        # Where the reference fails, nothing is said about the others.
        own = xp.arange(item.shape[-1]) == reference
        lost = (item[..., reference] != 0)[..., None] & ~own
        item = xp.where(lost, xp.zeros_like(item), item)
        return Computed(outputs, xp.where(shared != 0, shared, item[..., reference]), item)

    @abstractmethod
    def compute(
        self, xp: ModuleType, part: Part, arrays: Sequence[Array], extent: Extent
    ) -> Computed:
        """Evaluates a part of the outputs, failures not yet masked."""

    def guard(self, xp: ModuleType, arrays: Sequence[Array]) -> tuple[Guards, list[Array]]:
        """Makes all arguments real, lines shared ones up with items and checks every one."""
        floats = [array.dtype for array in arrays if is_float(xp, array.dtype)]
        guards = Guards(xp, xp.result_type(*floats) if floats else xp.asarray(0.0).dtype)
        wide, loaded = [], []
        for argument, given in zip(self.signature.arguments, arrays, strict=True):
            array = xp.asarray(given, dtype=guards.real) if argument.integer else given
            if self.signature.mapped and not argument.item:
                array = array[..., None] if argument.scalar else array[..., None, :]
            wide.append(array)
            if self.signature.guarded or argument.integer:
                loaded.append((argument, ComplexStep(xp).real(array)))
        guards.load(loaded)
        return guards, wide

    def computed(
        self, xp: ModuleType, outputs: list[Array], guards: Guards, extent: Extent
    ) -> Computed:
        """Spreads what the guards noted over the leading axes and the items."""
        if extent.items is None:
            return Computed.of(xp, outputs, xp.broadcast_to(guards.shared, extent.batch), None)
        shared = xp.broadcast_to(guards.shared, (*extent.batch, 1))[..., 0]
        item = xp.broadcast_to(guards.item, (*extent.batch, extent.items))
        return Computed.of(xp, outputs, shared, item)

    def finish(
        self,
        xp: ModuleType,
        part: Part,
        computed: Computed,
        extent: Extent,
        out: list[Array] | None,
        reference: int | None = None,
    ) -> Evaluation:
        """Decides the status of every epoch; zeroes failed items, voids failed epochs."""
        shared, item = computed.shared, computed.item
        status, bad_items = shared, None
        if item is not None:
            status = xp.where(shared != 0, shared, self._of_items(xp, item))
            bad_items = item != 0
            if reference is not None:
                bad_items = _without(xp, bad_items, reference, -1)
        failed = (status != int(Status.OK)) & (status != int(Status.PARTIAL))
        outputs = []
        for output, array in zip(outputs_of(self.signature, part), computed.outputs, strict=True):
            trailing = array.ndim - len(extent.batch)
            if output.item and bad_items is not None:
                zero = xp.reshape(bad_items, bad_items.shape + (1,) * (trailing - 1))
                array = xp.where(zero, xp.zeros_like(array), array)
            void = xp.reshape(failed, failed.shape + (1,) * trailing)
            outputs.append((array, void))
        if xp is not np:
            masked = [xp.where(void, xp.nan, array) for array, void in outputs]
            return Evaluation(masked, status, item)
        written = _write(outputs, out)
        verdict = Status(int(status)) if extent.batch == () else np.array(status)
        return Evaluation(written, verdict, None if item is None else np.array(item))

    def _of_items(self, xp: ModuleType, item: Array) -> Array:
        """What the items' failures mean for the epoch."""
        partial = xp.asarray(int(Status.PARTIAL), dtype=xp.uint8)
        fine = xp.asarray(int(Status.OK), dtype=xp.uint8)
        if not self.signature.reject:
            return xp.where(xp.any(item != 0, axis=-1), partial, fine)
        status = fine
        for number in range(item.shape[-1]):
            status = xp.where(status != 0, status, item[..., number])
        return status


def _write(outputs: Sequence[tuple[Array, Array]], out: list[Array] | None) -> list[Array]:
    """New arrays with NaN, or the given ones untouched, where an epoch failed."""
    if out is None:
        return [np.where(void, np.nan, array) if void.any() else array for array, void in outputs]
    for target, (array, void) in zip(out, outputs, strict=True):
        np.copyto(target, array, where=~void)
    return out


def namespace_of(values: Sequence[Any]) -> Any:
    """The library the arguments belong to: the first that is not NumPy."""
    for value in values:
        if type(value) is np.ndarray:
            continue
        find = getattr(value, "__array_namespace__", None)
        if find is not None and find() is not np:
            return find()
    return np


def subtract(xp: ModuleType, output: Output, array: Array, reference: int) -> Array:
    axis = -1 - len(output.shape)
    lead = (slice(None),) * (array.ndim + axis)
    return (
        _without(xp, array, reference, axis) - array[(*lead, slice(reference, reference + 1), ...)]
    )


def _without(xp: ModuleType, array: Array, reference: int, axis: int) -> Array:
    lead = (slice(None),) * (array.ndim + axis)
    before, after = slice(0, reference), slice(reference + 1, None)
    return xp.concat([array[(*lead, before, ...)], array[(*lead, after, ...)]], axis=axis)
