"""Evaluation of one epoch with Python's own numbers, which are quicker than arrays of length one.

Nothing is decided here: whatever is not an ordinary argument, fails a guard or has no real result
is left to the arrays, which know what to say about it.
"""

from __future__ import annotations

import cmath
import math
import operator
from collections.abc import Callable, Mapping, Sequence
from operator import itemgetter, le
from struct import Struct, pack_into
from typing import Any

import numpy as np

from ._explain import norm_defects
from ._kernels import Kernel
from ._runtime import Argument, Array, Kind, Output, Signature, Slot, Status

#: More items than this are quicker as arrays.
MOST_ITEMS = 64

_LARGEST = float(np.finfo(np.float64).max)
_WIDE_GAP = 64


class Unfit(ValueError):
    """What makes the arrays take over."""


class Numbers:
    """The functions of the array API that kernels call, for Python's numbers."""

    sqrt = staticmethod(math.sqrt)
    sin = staticmethod(math.sin)
    cos = staticmethod(math.cos)
    tan = staticmethod(math.tan)
    asin = staticmethod(math.asin)
    acos = staticmethod(math.acos)
    atan = staticmethod(math.atan)
    atan2 = staticmethod(math.atan2)
    exp = staticmethod(math.exp)
    log = staticmethod(math.log)
    abs = staticmethod(abs)
    less = staticmethod(operator.lt)
    less_equal = staticmethod(operator.le)
    equal = staticmethod(operator.eq)
    not_equal = staticmethod(operator.ne)
    logical_not = staticmethod(operator.not_)

    @staticmethod
    def floor(value: float) -> float:
        """As a float."""
        return float(math.floor(value))

    @staticmethod
    def logical_and(left: bool, right: bool) -> bool:
        """Both."""
        return left and right

    @staticmethod
    def logical_or(left: bool, right: bool) -> bool:
        """Either."""
        return left or right

    @staticmethod
    def where(condition: bool, chosen: Any, otherwise: Any) -> Any:
        """One of two numbers, both of which are known."""
        return chosen if condition else otherwise

    @staticmethod
    def minimum(left: float, right: float) -> float:
        """The smaller; NaN where one is."""
        return left if left <= right or left != left else right

    @staticmethod
    def maximum(left: float, right: float) -> float:
        """The larger; NaN where one is."""
        return left if left >= right or left != left else right


class _Guards:
    """Guards that hand over at the first failure."""

    @staticmethod
    def constant(value: float) -> float:
        """A number."""
        return value

    @staticmethod
    def check(value: float, lower: float, upper: float, substitute: float, status: Status) -> float:
        """The value, inside its range."""
        if lower <= value <= upper and -_LARGEST <= value <= _LARGEST:
            return value
        raise Unfit

    check_item = check

    @staticmethod
    def pick(elements: Sequence[float], base: int, index: int, first: int, last: int) -> float:
        """Element ``base + index``."""
        if not first <= index <= last:
            raise Unfit
        return elements[base + index]


class _Reader:
    """Turns one argument into numbers and guards them."""

    def __init__(self, argument: Argument, guarded: bool) -> None:
        self._argument = argument
        self._shape = () if argument.scalar else (argument.size,)
        checked = [
            domain
            for domain in argument.domains
            if (guarded or argument.integer) and domain.kind is not Kind.UNREAD
        ]
        self._ranges = [
            (domain.start + k, max(lower, -_LARGEST), min(upper, _LARGEST))
            for domain in checked
            for k, (lower, upper) in enumerate(zip(domain.lower, domain.upper, strict=True))
        ]
        self._norms = [
            (domain.kind, slice(domain.start, domain.start + domain.size), domain.tolerance)
            for domain in checked
            if domain.kind in (Kind.QUATERNION, Kind.MATRIX)
        ]
        places, lows, highs = zip(*self._ranges, strict=True) if self._ranges else ((), (), ())
        self._low, self._high = lows, highs
        whole = places == tuple(range(argument.size))
        self._chosen = None if whole or not places else _picker(places)
        self._kinds = "iu" if argument.integer else "d"

    def shared(self, value: Any) -> Any:
        """The elements of an argument that all items share, or its one element."""
        if self._argument.scalar:
            return self._single(value)
        if type(value) is not np.ndarray or value.shape != self._shape or not self._fits(value):
            raise Unfit
        numbers = value.tolist()
        if self._ranges:
            checked = numbers if self._chosen is None else self._chosen(numbers)
            if not (all(map(le, self._low, checked)) and all(map(le, checked, self._high))):
                raise Unfit
        for kind, place, tolerance in self._norms:
            if not max(norm_defects(kind, numbers[place])) <= tolerance:
                raise Unfit
        return numbers

    def items(self, value: Any) -> tuple[int, Any]:
        """How many items there are, and the rows of their elements."""
        if type(value) is not np.ndarray or value.shape[1:] != self._shape or not self._fits(value):
            raise Unfit
        count = len(value)
        if self._norms or not 0 < count <= MOST_ITEMS or value.ndim == 0:
            raise Unfit
        columns = value.T.tolist()
        if self._argument.scalar:
            columns = [columns]
        for place, low, high in self._ranges:
            own = columns[place]
            if not (low <= min(own) and max(own) <= high and not cmath.isnan(sum(own))):
                raise Unfit
        return count, columns[0] if self._argument.scalar else zip(*columns, strict=True)

    def _single(self, value: Any) -> Any:
        if type(value) is np.ndarray and value.ndim == 0 and self._fits(value):
            value = value.item()
        elif isinstance(value, (float, int)) and not (
            self._argument.integer and isinstance(value, float)
        ):
            value = value if self._argument.integer else float(value)
        else:
            raise Unfit
        for _, low, high in self._ranges:
            if not low <= value <= high:
                raise Unfit
        return value

    def _fits(self, value: Array) -> bool:
        return value.dtype.char == "d" or (self._argument.integer and value.dtype.kind in "iu")


class _Writer:
    """Makes the array of one output from its non-zeros."""

    def __init__(self, output: Output) -> None:
        places = [place for place in output.places if not isinstance(place, Slot)]
        self._shape, self._size = output.shape, output.size
        self._sparse = output.size - len(places) > _WIDE_GAP
        self._index = np.array(places, dtype=np.intp)
        sources = [len(places)] * output.size
        for number, place in enumerate(places):
            sources[place] = number
        self._dense = _picker(sources)
        self._pack = Struct(f"{output.size}d").pack_into

    def one(self, values: Sequence[float]) -> Array:
        """The array of one row of non-zeros."""
        if self._sparse:
            return self._scattered([values]).reshape(self._shape)
        array: Array = np.empty(self._shape)
        self._pack(array, 0, *self._dense((*values, 0.0)))
        return array

    def many(self, rows: Sequence[Sequence[float]]) -> Array:
        """The array of a row of non-zeros for every item."""
        shape = (len(rows), *self._shape)
        if self._sparse:
            return self._scattered(rows).reshape(shape)
        array: Array = np.empty(shape)
        dense = self._dense
        numbers = [number for row in rows for number in dense((*row, 0.0))]
        pack_into(f"{len(numbers)}d", array, 0, *numbers)
        return array

    def _scattered(self, rows: Sequence[Sequence[float]]) -> Array:
        array: Array = np.zeros((len(rows), self._size))
        array[:, self._index] = rows
        return array


def _picker(places: Sequence[int]) -> Callable[[Sequence[float]], Sequence[float]]:
    """A function that takes elements of a sequence."""
    if len(places) > 1:
        return itemgetter(*places)
    return lambda values: [values[place] for place in places]


class Epoch:
    """One epoch of a function."""

    def __init__(self, signature: Signature, kernel: Kernel) -> None:
        self._signature, self._kernel = signature, kernel
        self._shared = [
            (argument.name, _Reader(argument, signature.guarded).shared)
            for argument in signature.arguments
            if not argument.item
        ]
        self._own = [
            (argument.name, _Reader(argument, signature.guarded).items)
            for argument in signature.arguments
            if argument.item
        ]
        self._writers = [(output.item, _Writer(output)) for output in signature.outputs]
        self._movable = any(isinstance(p, Slot) for o in signature.outputs for p in o.places)

    def evaluate(self, state: Sequence[Any], inputs: Mapping[str, Any]) -> list[Any] | None:
        """The fields of the result, or None where the arrays have to look at it."""
        names = self._signature.names
        if self._movable or len(state) + len(inputs) != len(names):
            return None
        given = {names[0]: state[0], **inputs} if state else inputs
        try:
            shared = [read(given[name]) for name, read in self._shared]
            if self._own:
                return self._mapped(shared, given)
            found = self._kernel(Numbers, _Guards, *shared)
            fields = [writer.one(v) for (_, writer), v in zip(self._writers, found, strict=True)]
            return [*fields, Status.OK]
        except (ArithmeticError, KeyError, ValueError):
            return None

    def _mapped(self, shared: Sequence[Any], given: Mapping[str, Any]) -> list[Any]:
        counts, own = zip(*(read(given[name]) for name, read in self._own), strict=True)
        if len(set(counts)) > 1 or counts[0] > (self._signature.maximum or 0):
            raise Unfit
        together, item = self._kernel(Numbers, _Guards, *shared)
        once, each = iter(together), zip(*map(item, *own), strict=True)
        fields = [
            writer.many(next(each)) if mapped else writer.one(next(once))
            for mapped, writer in self._writers
        ]
        return [*fields, Status.OK, np.zeros(counts[0], dtype=np.uint8)]
