"""Arguments of many epochs as rows of elements, and their guards.

Guards compare the smallest and the largest of every row with its range, and so for defects of
norms; only where one is outside are the elements looked at one by one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from enum import IntEnum
from operator import itemgetter, le
from typing import Any

import numpy as np

from ._kernels import Guards
from ._runtime import Argument, Array, Domain, Kind, Signature, Status

#: Elements by argument: a row, or rows and None for what is not read.
Elements = dict[str, Any]

_LARGEST = float(np.finfo(np.float64).max)
_ROUNDING = 1e-14
_GAP = 8
_IDENTITY = np.eye(2)[:, :, None]
_FINE = np.zeros((), dtype=np.uint8)
_NORMED = {Kind.QUATERNION: 1, Kind.MATRIX: 7}


class BlockGuards(Guards):
    """Guards that look closely only at what holds a bad value."""

    def __init__(self, real: Any) -> None:
        self._xp, self.real, self.noted = np, real, False
        self.shared = self.item = _FINE

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
    lowest, highest = np.minimum.reduce(real, axis=None), np.maximum.reduce(real, axis=None)
    return bool(max(lower, -_LARGEST) <= lowest and highest <= min(upper, _LARGEST))


class _Check(IntEnum):
    """What is looked at in the elements of a domain; the order of their rows."""

    RANGE = 0
    NORM = 1
    NOTHING = 2


def _check(argument: Argument, domain: Domain, guarded: bool) -> _Check:
    if not (guarded or argument.integer):
        return _Check.NOTHING
    # No element is larger than the norm, or than the tolerance beyond it.
    longest = 1.0 + domain.tolerance
    bounded = max(domain.lower) <= -longest and longest <= min(domain.upper)
    return _Check.NORM if domain.kind in _NORMED and bounded else _Check.RANGE


class Table:
    """Where the elements of some arguments with the same axes stand, one row for each.

    The defects of norms come first, then rows whose range is looked at, then the others. Elements
    that the function does not read have no row.
    """

    def __init__(self, arguments: Sequence[Argument], guarded: bool) -> None:
        domains = [
            (_check(argument, domain, guarded), argument, domain)
            for argument in arguments
            for domain in argument.domains
            if domain.kind is not Kind.UNREAD
        ]
        self._low: list[float] = []
        self._high: list[float] = []
        self._norms: list[tuple[Kind, slice, slice]] = []
        self._cuts: list[tuple[str, bool, slice]] = []
        self._defects = self._height = sum(_defect_rows(check, d) for check, _, d in domains)
        rows = {argument.name: [-1] * argument.size for argument in arguments}
        for check, argument, domain in sorted(domains, key=itemgetter(0)):
            first, self._height = self._height, self._height + domain.size
            own = slice(domain.start, domain.start + domain.size)
            rows[argument.name][own] = range(first, self._height)
            self._cut(argument, own)
            if check is _Check.RANGE:
                self._low += [max(bound, -_LARGEST) for bound in domain.lower]
                self._high += [min(bound, _LARGEST) for bound in domain.upper]
            if _defect_rows(check, domain):
                self._norm(domain, _defect_rows(check, domain), slice(first, self._height))
        self._picks = [
            (argument.name, _picker(argument, rows[argument.name])) for argument in arguments
        ]

    def _norm(self, domain: Domain, count: int, own: slice) -> None:
        """Notes a norm and the bounds of its defects, in front of those of ranges."""
        at = sum(found.stop - found.start for _, _, found in self._norms)
        self._norms.append((domain.kind, own, slice(at, at + count)))
        # Good norms bound the elements as well. What is close to the tolerance is left to a closer
        # look, which costs nothing but time.
        limit = domain.tolerance / 2.0 - _ROUNDING
        self._low[at:at] = [-limit] * count
        self._high[at:at] = [limit] * count

    def _cut(self, argument: Argument, own: slice) -> None:
        """Notes which elements come next, in as few pieces as there are."""
        if self._cuts:
            name, _, before = self._cuts[-1]
            if name == argument.name and before.stop == own.start:
                own = slice(before.start, own.stop)
                del self._cuts[-1]
        self._cuts.append((argument.name, argument.scalar, own))

    def read(self, arrays: Mapping[str, Array], own: slice, real: Any, elements: Elements) -> bool:
        """Adds the elements of some epochs by argument; True when all of them pass."""
        parts = []
        for name, scalar, cut in self._cuts:
            turned = arrays[name][own].T
            parts.append(turned[None] if scalar else turned[cut])
        rows: list[Any] = [None]
        passed = True
        if parts:
            shape = parts[0].shape[1:]
            length = math.prod(shape)
            # Rows a power of two apart would share a few sets of the cache.
            flat: Array = np.empty((self._height, length + _GAP), dtype=real)[:, :length]
            table = flat.reshape((self._height, *shape))
            np.concatenate(parts, out=table[self._defects :])
            rows = [*table, None]
            passed = not (length and self._low) or self._passes(flat.real)
        for name, pick in self._picks:
            elements[name] = pick(rows)
        return passed

    def _passes(self, rows: Array) -> bool:
        """True when all norms are good and all numbers are inside their ranges."""
        for kind, own, found in self._norms:
            _DEFECTS[kind](rows[own], rows[found])
        checked = rows[: len(self._low)]
        return all(map(le, self._low, np.minimum.reduce(checked, axis=1).tolist())) and all(
            map(le, np.maximum.reduce(checked, axis=1).tolist(), self._high)
        )


def _picker(argument: Argument, places: Sequence[int]) -> Callable[[Sequence[Any]], Any]:
    """A function that takes the elements of an argument from the rows of a table.

    Behind the rows there is None, for what is not read.
    """
    if argument.size > 1 or argument.scalar:
        return itemgetter(*places)
    return lambda rows: [rows[places[0]]]


def _quaternion_defects(rows: Array, out: Array) -> None:
    """The defect of ``norm_defects`` with its sign: the square of the norm less one."""
    np.einsum("kn,kn->n", rows, rows, out=out[0])
    out[0] -= 1.0


def _matrix_defects(rows: Array, out: Array) -> None:
    """The defects of ``norm_defects``, with signs and in as few calls as there are: seven rows."""
    pair = rows.reshape((3, 3, -1))[:, :2]
    products = np.einsum("ijn,ikn->jkn", pair, pair, out=out[:4].reshape((2, 2, -1)))
    products -= _IDENTITY
    # With the rows once more behind them, every third one from any start is a rotated column.
    again = np.concatenate((rows, rows[:5]))
    cross = np.multiply(again[3:10:3], again[7:14:3], out=out[4:])
    cross -= again[6:13:3] * again[4:11:3]
    cross -= rows[2::3]


_DEFECTS = {Kind.QUATERNION: _quaternion_defects, Kind.MATRIX: _matrix_defects}


def _defect_rows(check: _Check, domain: Domain) -> int:
    """How many rows the defects of a domain take."""
    return 0 if check is _Check.NOTHING else _NORMED.get(domain.kind, 0)


class Source:
    """The arguments of one call; those that all epochs share are read once."""

    def __init__(
        self,
        signature: Signature,
        arrays: Mapping[str, Array],
        real: Any,
        shared: Sequence[Table],
    ) -> None:
        self._signature, self._arrays, self._real = signature, arrays, real
        self._elements: Elements = {}
        self._passed = True
        for table in shared:
            self._passed &= table.read(arrays, slice(0, 1), real, self._elements)

    def read(self, own: Sequence[Table], epochs: slice, guards: BlockGuards) -> Elements:
        """The elements of some epochs; the guards look closely where any of them is bad."""
        found, passed = dict(self._elements), self._passed
        for table in own:
            passed &= table.read(self._arrays, epochs, self._real, found)
        if not passed:
            guards.noted = True
            loaded = []
            for argument in self._signature.arguments:
                if self._signature.guarded or argument.integer:
                    array = self._arrays[argument.name]
                    array = np.real(array if len(array) == 1 else array[epochs])
                    array = array.astype(np.float64, copy=False)
                    loaded.append((argument, np.moveaxis(array, 1, 0) if argument.item else array))
            guards.load(loaded)
        return found
