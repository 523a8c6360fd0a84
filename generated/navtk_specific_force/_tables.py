"""Arguments of many epochs as rows of elements, and their guards.

Guards compare the smallest and the largest of every row with its range; only where one is outside
are the elements looked at one by one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from operator import itemgetter, le
from typing import Any

import numpy as np

from ._explain import norm_defects
from ._kernels import Guards
from ._runtime import Argument, Array, Kind, Signature, Status

#: Elements by argument: a row, or rows and None for what is not read.
Elements = dict[str, Any]

_LARGEST = float(np.finfo(np.float64).max)
_ROUNDING = 1e-14


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
    real = np.asarray(value).real
    if not real.size:
        return True
    return bool(max(lower, -_LARGEST) <= real.min() and real.max() <= min(upper, _LARGEST))


class Table:
    """Where the elements of some arguments with the same axes stand, one row for each.

    Elements that the function does not read have no row.
    """

    def __init__(self, arguments: Sequence[Argument], guarded: bool) -> None:
        self._low: list[float] = []
        self._high: list[float] = []
        self._norms: list[tuple[Kind, slice, float]] = []
        self._picks = [
            (argument.name, self._plan(argument, guarded or argument.integer))
            for argument in arguments
        ]
        self._cuts = [(argument, _cuts(argument)) for argument in arguments]

    def _plan(self, argument: Argument, guarded: bool) -> Callable[[Sequence[Any]], Any]:
        """A function that takes the elements of an argument from the rows; notes their bounds.

        Behind the rows there is None, for what is not read.
        """
        rows = [-1] * argument.size
        for domain in argument.domains:
            if domain.kind is Kind.UNREAD:
                continue
            first = len(self._low)
            rows[domain.start : domain.start + domain.size] = range(first, first + domain.size)
            endless = (math.inf,) * domain.size
            self._low += [max(b, -_LARGEST) for b in domain.lower] if guarded else _negated(endless)
            self._high += [min(b, _LARGEST) for b in domain.upper] if guarded else endless
            if guarded and domain.kind in (Kind.QUATERNION, Kind.MATRIX):
                self._norms.append((domain.kind, slice(first, len(self._low)), domain.tolerance))
        if argument.size > 1 or argument.scalar:
            return itemgetter(*rows)
        return lambda found: [found[rows[0]]]

    def read(self, arrays: Mapping[str, Array], own: slice, real: Any) -> tuple[Elements, bool]:
        """The elements of some epochs by argument, and whether all of them pass."""
        parts = []
        for argument, cuts in self._cuts:
            turned = arrays[argument.name][own].T
            parts += [turned[None]] if argument.scalar else [turned[cut] for cut in cuts]
        if not parts:
            return {argument.name: [None] * argument.size for argument, _ in self._cuts}, True
        table: Array = np.empty((len(self._low), *parts[0].shape[1:]), dtype=real)
        np.concatenate(parts, out=table)
        rows = [*table, None]
        elements = {name: pick(rows) for name, pick in self._picks}
        return elements, not table.size or self._passes(table.real)

    def _passes(self, table: Array) -> bool:
        flat = table.reshape(len(table), -1)
        lowest, highest = np.minimum.reduce(flat, axis=1), np.maximum.reduce(flat, axis=1)
        if not all(map(le, self._low, lowest.tolist())):
            return False
        if not all(map(le, highest.tolist(), self._high)):
            return False
        return all(_normal(kind, flat[own], tolerance) for kind, own, tolerance in self._norms)


def _negated(bounds: Sequence[float]) -> list[float]:
    return [-bound for bound in bounds]


def _cuts(argument: Argument) -> list[slice]:
    """The elements of an argument that are read, in as few pieces as there are."""
    cuts: list[slice] = []
    for domain in argument.domains:
        if domain.kind is Kind.UNREAD:
            continue
        stop = domain.start + domain.size
        if cuts and cuts[-1].stop == domain.start:
            cuts[-1] = slice(cuts[-1].start, stop)
        else:
            cuts.append(slice(domain.start, stop))
    return cuts


def _normal(kind: Kind, rows: Array, tolerance: float) -> bool:
    """True when all norms are good, the last few roundings left to a closer look."""
    limit = tolerance - _ROUNDING
    if kind is Kind.QUATERNION:
        norm = np.einsum("ij,ij->j", rows, rows)
        return bool(1.0 - limit <= norm.min() and norm.max() <= 1.0 + limit)
    return all(bool(defect.max() <= limit) for defect in norm_defects(kind, list(rows)))


class Source:
    """The arguments of one call."""

    def __init__(
        self,
        signature: Signature,
        arrays: Mapping[str, Array],
        real: Any,
        shared: Sequence[Table],
        own: Sequence[Table],
    ) -> None:
        self._signature, self._arrays, self._real, self._own = signature, arrays, real, own
        self._elements: Elements = {}
        self._passed = True
        for table in shared:
            elements, passed = table.read(arrays, slice(0, 1), real)
            self._elements |= elements
            self._passed &= passed

    def read(self, epochs: slice, guards: BlockGuards) -> Elements:
        """The elements of some epochs; the guards look closely where any of them is bad."""
        found, passed = dict(self._elements), self._passed
        for table in self._own:
            elements, fine = table.read(self._arrays, epochs, self._real)
            found |= elements
            passed &= fine
        if not passed:
            guards.noted = True
            for argument in self._signature.arguments:
                if self._signature.guarded or argument.integer:
                    array = self._arrays[argument.name]
                    array = np.real(array if len(array) == 1 else array[epochs])
                    array = array.astype(np.float64, copy=False)
                    guards.load(argument, np.moveaxis(array, 1, 0) if argument.item else array)
        return found
