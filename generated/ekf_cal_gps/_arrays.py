"""Evaluation with arrays of any library that follows the array API standard.

A kernel is straight-line code over the elements of its arguments. It is called with the library's
namespace, a :class:`Guards` and its arguments; leading axes pass through, then the item axis where
there is one (arguments shared by all items have length one there). It returns the structural
non-zeros of every output.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from ._calls import Evaluation, Function
from ._explain import norm_defects
from ._places import columns_of, index_of
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
    as_numbers,
    output_shape,
    outputs_of,
)

Nonzeros = tuple[tuple[Any, ...], ...]
Kernel = Callable[..., Nonzeros]


class ComplexStep:
    """A namespace that continues real functions to first order in the imaginary part.

    Comparisons look at real parts, so that a step ``1e-100j`` on an argument gives a derivative
    without cancellation.
    """

    def __init__(self, xp: Any) -> None:
        self._xp = xp

    def __getattr__(self, name: str) -> Any:
        return getattr(self._xp, name)

    def real(self, value: Any) -> Any:
        """The real part of an array of any type."""
        dtype = getattr(value, "dtype", None)
        mixed = dtype is not None and _is_complex(self._xp, dtype)
        return self._xp.real(value) if mixed else value

    def less(self, left: Any, right: Any) -> Any:
        """Compares real parts."""
        return self._xp.less(self.real(left), self.real(right))

    def less_equal(self, left: Any, right: Any) -> Any:
        """Compares real parts."""
        return self._xp.less_equal(self.real(left), self.real(right))

    def equal(self, left: Any, right: Any) -> Any:
        """Compares real parts."""
        return self._xp.equal(self.real(left), self.real(right))

    def not_equal(self, left: Any, right: Any) -> Any:
        """Compares real parts."""
        return self._xp.not_equal(self.real(left), self.real(right))

    def minimum(self, left: Any, right: Any) -> Any:
        """The operand whose real part is smaller."""
        return self._xp.where(self.less_equal(left, right), left, right)

    def maximum(self, left: Any, right: Any) -> Any:
        """The operand whose real part is larger."""
        return self._xp.where(self.less_equal(right, left), left, right)

    def abs(self, value: Any) -> Any:
        """The operand with a real part that is not negative; not the modulus."""
        return self._xp.where(self.less(value, 0.0), -value, value)

    def floor(self, value: Any) -> Any:
        """Constant between jumps, so that the imaginary part vanishes."""
        return self._xp.floor(self.real(value))

    def atan2(self, sine: Any, cosine: Any) -> Any:
        """The angle, and its differential in the imaginary part."""
        y, x = self.real(sine), self.real(cosine)
        turn = (x * (sine - y) - y * (cosine - x)) / (x * x + y * y)
        return self._xp.atan2(y, x) + turn


def _is_complex(xp: Any, dtype: Any) -> bool:
    return bool(dtype.kind == "c" if xp is np else xp.isdtype(dtype, "complex floating"))


def _is_float(xp: Any, dtype: Any) -> bool:
    kinds = ("real floating", "complex floating")
    return bool(dtype.kind in "fc" if xp is np else xp.isdtype(dtype, kinds))


class Guards:
    """Remembers which epochs and items fail a guard; the first failure of each counts."""

    def __init__(self, xp: Any, real: Any) -> None:
        self._xp = xp
        self.real = real
        self.shared = self.item = xp.zeros((), dtype=xp.uint8)

    def constant(self, value: float) -> Array:
        """A number as an array, where the standard asks for one."""
        return self._xp.asarray(value, dtype=self.real)

    def check(
        self, value: Array, lower: float, upper: float, substitute: float, status: Status
    ) -> Array:
        """A value of the whole call, or the substitute where it is out of range."""
        passed = self._inside(value, lower, upper)
        self.shared = self._note(self.shared, passed, status)
        return self._xp.where(passed, value, substitute)

    def check_item(
        self, value: Array, lower: float, upper: float, substitute: float, status: Status
    ) -> Array:
        """A value of each item, or the substitute where it is out of range."""
        passed = self._inside(value, lower, upper)
        self.item = self._note(self.item, passed, status)
        return self._xp.where(passed, value, substitute)

    def pick(self, array: Array, base: int, index: Array, first: int, last: int) -> Array:
        """Element ``base + index`` of an array, for an index that depends on the item."""
        chosen = array[..., base + first]
        for number in range(first + 1, last + 1):
            chosen = self._xp.where(index == number, array[..., base + number], chosen)
        return chosen

    def load(self, argument: Argument, array: Array) -> None:
        """Guards the elements of an argument: ranges first, then norms."""
        for passed, status in self._loaded(argument, array):
            if argument.item:
                self.item = self._note(self.item, passed, status)
            else:
                self.shared = self._note(self.shared, passed, status)

    def _loaded(self, argument: Argument, array: Array) -> list[tuple[Array, Status]]:
        xp = self._xp
        lower = [bound for domain in argument.domains for bound in domain.lower]
        upper = [bound for domain in argument.domains for bound in domain.upper]
        if argument.scalar:
            passed = (array >= lower[0]) & (array <= upper[0]) & xp.isfinite(array)
            return [(passed, Status.RANGE)]
        low, high = (xp.asarray(bounds, dtype=array.dtype) for bounds in (lower, upper))
        inside = (array >= low) & (array <= high) & xp.isfinite(array)
        unread = [d.kind is Kind.UNREAD for d in argument.domains for _ in range(d.size)]
        if any(unread):
            inside = inside | xp.asarray(unread)
        passed = xp.all(inside, axis=-1)
        failures = [(passed, Status.RANGE)]
        for domain in argument.domains:
            if domain.kind in (Kind.QUATERNION, Kind.MATRIX):
                elements = [array[..., domain.start + number] for number in range(domain.size)]
                for defect in norm_defects(domain.kind, elements):
                    failures.append((defect <= domain.tolerance, Status.QNORM))
        return failures

    def _inside(self, value: Array, lower: float, upper: float) -> Array:
        xp = self._xp
        above, below = xp.less_equal(lower, value), xp.less_equal(value, upper)
        return above & below & xp.isfinite(value)

    def _note(self, noted: Array, passed: Array, status: Status) -> Array:
        xp = self._xp
        return xp.where(passed | (noted != 0), noted, xp.asarray(int(status), dtype=xp.uint8))


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


class ArrayFunction(Function):
    """A function whose kernel works on whole arrays."""

    def __init__(self, signature: Signature, kernel: Kernel) -> None:
        super().__init__(signature)
        self._kernel = kernel

    def prepare(self, values: Sequence[Any]) -> list[Array]:
        """Keeps arrays of another library (and complex ones); everything else becomes NumPy."""
        xp = _namespace(values)
        pairs = zip(self.signature.arguments, values, strict=True)
        if xp is np:
            return [as_numbers(argument, value, self.real, True) for argument, value in pairs]
        arrays = [xp.asarray(value) for value in values]
        floats = [array.dtype for array in arrays if _is_float(xp, array.dtype)]
        real = xp.result_type(*floats) if floats else xp.asarray(0.0).dtype
        return [
            array if argument.integer or array.dtype in floats else xp.asarray(array, dtype=real)
            for argument, array in zip(self.signature.arguments, arrays, strict=True)
        ]

    def evaluate(
        self, part: Part, arrays: Sequence[Array], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """Computes, then masks what failed."""
        xp = arrays[0].__array_namespace__()
        with np.errstate(all="ignore"):
            computed = self.compute(xp, part, arrays, extent)
        return self._finish(xp, part, computed, extent, out)

    def difference(
        self, arrays: Sequence[Array], extent: Extent, reference: int, out: list[Array] | None
    ) -> Evaluation:
        """Differences of whole arrays."""
        xp = arrays[0].__array_namespace__()
        with np.errstate(all="ignore"):
            computed = self.compute(xp, Part.ALL, arrays, extent)
            outputs = [
                _subtract(xp, output, array, reference) if output.item else array
                for output, array in zip(self.signature.outputs, computed.outputs, strict=True)
            ]
        shared, item = computed.shared, computed.item
        assert item is not None
        shared = xp.where(shared != 0, shared, item[..., reference])
        computed = Computed(outputs, shared, item)
        return self._finish(xp, Part.ALL, computed, extent, out, reference)

    def compute(
        self, xp: ModuleType, part: Part, arrays: Sequence[Array], extent: Extent
    ) -> Computed:
        """Runs the kernel and assembles its non-zeros."""
        guards, wide = self.guard(xp, arrays)
        stepped = _is_complex(xp, guards.real)
        found = self._kernel(ComplexStep(xp) if stepped else xp, guards, *wide)
        named = dict(zip(self.signature.names, wide, strict=True))
        assemble = _fill if xp is np else _stack
        wanted = outputs_of(self.signature, part)
        outputs = []
        for output, values in zip(self.signature.outputs, found, strict=True):
            if output not in wanted:
                continue
            places = range(len(values)) if part is Part.NONZEROS else output.places
            size = len(values) if part is Part.NONZEROS else output.size
            lead = (*extent.batch, *self._items(output, extent))
            flat = assemble(xp, values, places, named, (*lead, size), guards.real)
            outputs.append(xp.reshape(flat, output_shape(output, part, extent)))
        return self.computed(xp, outputs, guards, extent)

    def guard(self, xp: ModuleType, arrays: Sequence[Array]) -> tuple[Guards, list[Array]]:
        """Makes all arguments real, lines shared ones up with items and checks every one."""
        floats = [array.dtype for array in arrays if _is_float(xp, array.dtype)]
        guards = Guards(xp, xp.result_type(*floats) if floats else xp.asarray(0.0).dtype)
        wide = []
        for argument, given in zip(self.signature.arguments, arrays, strict=True):
            array = xp.asarray(given, dtype=guards.real) if argument.integer else given
            if self.signature.mapped and not argument.item:
                array = array[..., None] if argument.scalar else array[..., None, :]
            wide.append(array)
            if self.signature.guarded or argument.integer:
                guards.load(argument, ComplexStep(xp).real(array))
        return guards, wide

    def computed(
        self, xp: ModuleType, outputs: list[Array], guards: Guards, extent: Extent
    ) -> Computed:
        """Spreads what the guards noted over the leading axes and the items."""
        if extent.items is None:
            return Computed(outputs, xp.broadcast_to(guards.shared, extent.batch), None)
        shared = xp.broadcast_to(guards.shared, (*extent.batch, 1))[..., 0]
        item = xp.broadcast_to(guards.item, (*extent.batch, extent.items))
        return Computed(outputs, shared, item)

    def _items(self, output: Output, extent: Extent) -> tuple[int, ...]:
        if extent.items is None:
            return ()
        return (extent.items,) if output.item else (1,)

    def _finish(
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
            item = xp.where(shared[..., None] != 0, xp.zeros_like(item), item)
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


def _namespace(values: Sequence[Any]) -> Any:
    """The library the arguments belong to: the first that is not NumPy."""
    for value in values:
        find = getattr(value, "__array_namespace__", None)
        if find is not None and find() is not np:
            return find()
    return np


def _fill(
    xp: ModuleType,
    values: Sequence[Any],
    places: Sequence[int | Slot],
    arguments: dict[str, Array],
    shape: tuple[int, ...],
    dtype: Any,
) -> Array:
    """Writes non-zeros into zeros; NumPy only, where it saves most of the time."""
    flat = np.zeros(shape, dtype=dtype)
    for value, place in zip(values, places, strict=True):
        if isinstance(place, Slot):
            index = index_of(place, arguments)
            for number, column in columns_of(place):
                flat[..., column] = np.where(index == number, value, flat[..., column])
        else:
            flat[..., place] = value
    return flat


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


def _subtract(xp: ModuleType, output: Output, array: Array, reference: int) -> Array:
    axis = -1 - len(output.shape)
    lead = (slice(None),) * (array.ndim + axis)
    return (
        _without(xp, array, reference, axis) - array[(*lead, slice(reference, reference + 1), ...)]
    )


def _without(xp: ModuleType, array: Array, reference: int, axis: int) -> Array:
    lead = (slice(None),) * (array.ndim + axis)
    before, after = slice(0, reference), slice(reference + 1, None)
    return xp.concat([array[(*lead, before, ...)], array[(*lead, after, ...)]], axis=axis)
