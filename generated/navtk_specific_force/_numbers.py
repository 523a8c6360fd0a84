"""Evaluation of one epoch with Python's own numbers, which are quicker than arrays of length one.

Nothing is decided here: whatever is not an ordinary argument, fails a guard or has no real result
is left to the arrays, which know what to say about it.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping, Sequence
from itertools import chain
from operator import call, itemgetter, le
from struct import Struct, pack_into
from typing import Any, NamedTuple

import numpy as np

from ._explain import norm_defects
from ._kernels import Kernel
from ._runtime import Argument, Array, Kind, Output, Signature, Slot, Status

#: More items than this are quicker as arrays.
MOST_ITEMS = 64

_DOUBLE = np.dtype(np.float64)
_LARGEST = float(np.finfo(np.float64).max)
_WIDE_GAP = 64
_OK = Status.OK


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


class _Limits(NamedTuple):
    """The guards of one argument.

    Attributes:
        places: elements that have a range.
        low: their smallest values.
        high: their largest values.
        norms: runs of elements that have a norm, with its tolerance.
    """

    places: tuple[int, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]
    norms: tuple[tuple[Kind, slice, float], ...]


def _limits(argument: Argument, guarded: bool) -> _Limits:
    places: list[int] = []
    low: list[float] = []
    high: list[float] = []
    norms = []
    for domain in argument.domains:
        if domain.kind is Kind.UNREAD or not (guarded or argument.integer):
            continue
        own = slice(domain.start, domain.start + domain.size)
        places += range(own.start, own.stop)
        low += [max(bound, -_LARGEST) for bound in domain.lower]
        high += [min(bound, _LARGEST) for bound in domain.upper]
        if domain.kind in (Kind.QUATERNION, Kind.MATRIX):
            norms.append((domain.kind, own, domain.tolerance))
    return _Limits(tuple(places), tuple(low), tuple(high), tuple(norms))


def _fits(argument: Argument, value: Array) -> bool:
    return value.dtype.kind in "iu" if argument.integer else value.dtype is _DOUBLE


def _shared_reader(argument: Argument, guarded: bool) -> Callable[[Any], Any]:
    """A function that turns an argument of all items into its numbers and guards them."""
    places, low, high, norms = _limits(argument, guarded)
    shape = (argument.size,)
    chosen = None if places == tuple(range(argument.size)) else _picker(places)
    array, quaternion = np.ndarray, Kind.QUATERNION
    integer = argument.integer

    def read(value: Any) -> Any:
        if type(value) is not array or value.shape != shape:
            raise Unfit
        if (integer or value.dtype is not _DOUBLE) and not _fits(argument, value):
            raise Unfit
        numbers = value.tolist()
        if not low:
            return numbers
        checked = numbers if chosen is None else chosen(numbers)
        if not (all(map(le, low, checked)) and all(map(le, checked, high))):
            raise Unfit
        for kind, own, tolerance in norms:
            if kind is quaternion:
                w, x, y, z = numbers[own]
                defect = abs(w * w + x * x + y * y + z * z - 1.0)
            else:
                defect = max(norm_defects(kind, numbers[own]))
            if not defect <= tolerance:
                raise Unfit
        return numbers

    def read_one(value: Any) -> Any:
        if type(value) is array and value.shape == () and _fits(argument, value):
            value = value.item()
        # A truth value is an int to Python, but no index.
        if not (type(value) is int if integer else isinstance(value, (float, int))):
            raise Unfit
        number = value if integer else float(value)
        if not all(lower <= number <= upper for lower, upper in zip(low, high, strict=True)):
            raise Unfit
        return number

    return read_one if argument.scalar else read


def _items_reader(argument: Argument, guarded: bool) -> Callable[[Any], tuple[int, Any]]:
    """The same for an argument of each item: how many there are, and the rows of their numbers."""
    places, low, high, norms = _limits(argument, guarded)
    limits = list(zip(places, low, high, strict=True))
    rank, own = argument.rank, () if argument.scalar else (argument.size,)
    alike = len(places) == argument.size and len({*zip(low, high, strict=True)}) == 1

    def counted(value: Any) -> int:
        if type(value) is not np.ndarray or value.ndim != rank or value.shape[1:] != own:
            raise Unfit
        count = len(value)
        if norms or not 0 < count <= MOST_ITEMS or not _fits(argument, value):
            raise Unfit
        return count

    def read(value: Any) -> tuple[int, Any]:
        count = counted(value)
        columns = [value.tolist()] if argument.scalar else value.T.tolist()
        for place, lower, upper in limits:
            _require_inside(columns[place], lower, upper)
        return count, columns[0] if argument.scalar else zip(*columns, strict=True)

    def read_alike(value: Any) -> tuple[int, Any]:
        count = counted(value)
        numbers = value.ravel().tolist()
        _require_inside(numbers, low[0], high[0])
        return count, zip(*[iter(numbers)] * argument.size, strict=True)

    return read_alike if alike and not argument.scalar else read


def _require_inside(numbers: Sequence[float], lower: float, upper: float) -> None:
    """Hands over where a number is outside; NaN is neither first nor last, but the sum knows."""
    if not lower <= min(numbers) <= max(numbers) <= upper or math.isnan(sum(numbers)):
        raise Unfit


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
        self._in_order = sources == list(range(len(places)))
        #: From one row of non-zeros to its array.
        self.one = self._scattered_one if self._sparse else self._packer(self._in_order)

    def _packer(self, in_order: bool) -> Callable[[Sequence[float]], Array]:
        shape, empty, dense = self._shape, np.empty, self._dense
        pack = Struct(f"{self._size}d").pack_into

        def one(values: Sequence[float]) -> Array:
            array: Array = empty(shape)
            pack(array, 0, *dense((*values, 0.0)))
            return array

        def one_in_order(values: Sequence[float]) -> Array:
            array: Array = empty(shape)
            pack(array, 0, *values)
            return array

        return one_in_order if in_order else one

    def _scattered_one(self, values: Sequence[float]) -> Array:
        return self._scattered([values]).reshape(self._shape)

    def many(self, rows: Sequence[Sequence[float]]) -> Array:
        """The array of a row of non-zeros for every item."""
        shape = (len(rows), *self._shape)
        if self._sparse:
            return self._scattered(rows).reshape(shape)
        array: Array = np.empty(shape)
        dense = self._dense
        whole = rows if self._in_order else [dense((*row, 0.0)) for row in rows]
        pack_into(f"{array.size}d", array, 0, *chain.from_iterable(whole))
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
        self._names, self._maximum, self._kernel = signature.names, signature.maximum, kernel
        self._shared = [
            (argument.name, _shared_reader(argument, signature.guarded))
            for argument in signature.arguments
            if not argument.item
        ]
        self._own = [
            (argument.name, _items_reader(argument, signature.guarded))
            for argument in signature.arguments
            if argument.item
        ]
        self._writers = [(output.item, _Writer(output)) for output in signature.outputs]
        self._plain = [writer.one for _, writer in self._writers]
        self._movable = any(isinstance(p, Slot) for o in signature.outputs for p in o.places)

    def evaluate(self, state: Sequence[Any], inputs: Mapping[str, Any]) -> list[Any] | None:
        """The fields of the result, or None where the arrays have to look at it."""
        names = self._names
        if self._movable or len(state) + len(inputs) != len(names):
            return None
        if state and names[0] != "x":
            return None
        try:
            given = {names[0]: state[0], **inputs} if state else inputs
            shared = [read(given[name]) for name, read in self._shared]
            if self._own:
                return self._mapped(shared, given)
            found = self._kernel(Numbers, _Guards, *shared)
            return [*map(call, self._plain, found), _OK]
        except (ArithmeticError, KeyError, ValueError):
            return None

    def _mapped(self, shared: Sequence[Any], given: Mapping[str, Any]) -> list[Any]:
        counts, own = zip(*(read(given[name]) for name, read in self._own), strict=True)
        if len(set(counts)) > 1 or counts[0] > (self._maximum or 0):
            raise Unfit
        together, item = self._kernel(Numbers, _Guards, *shared)
        once, each = iter(together), zip(*map(item, *own), strict=True)
        fields = [
            writer.many(next(each)) if mapped else writer.one(next(once))
            for mapped, writer in self._writers
        ]
        return [*fields, _OK, np.zeros(counts[0], dtype=np.uint8)]
