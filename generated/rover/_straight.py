"""Straight ways: many epochs of arrays that compiled C looks at and takes as they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from ._extension import UNFIT, Library
from ._runtime import Array, Output, Part, Signature, Status

_BYTE = np.dtype(np.uint8)
_Axes = tuple[tuple[int, ...], bool, tuple[int, ...]]


class Straight:
    """The straight way of one function for all its outputs, or for values and non-zeros."""

    def __init__(self, library: Library, signature: Signature, part: Part) -> None:
        arguments, nonzeros = signature.arguments, part is Part.NONZEROS
        self._library, self._real = library, library.real
        self._entry = library.straight(signature.name + ("_batch_nz" if nonzeros else "_batch"))
        self._names = tuple(name for name in signature.names if name != "x")
        self._count = len(arguments)
        self._rank = arguments[0].rank + 1
        self._most = signature.maximum or 0
        self._counter = next(((k, -a.rank) for k, a in enumerate(arguments) if a.item), None)
        stored = [o for o in signature.outputs if o.places or not (nonzeros and o.jacobian)]
        self._axes = [_axes(output, part, signature.mapped) for output in stored]
        self._wanted = [output.jacobian or not nonzeros for output in stored]
        wanted = sum(self._wanted)
        self._fields = wanted, wanted if nonzeros else wanted + 1 + signature.mapped

    def evaluate(
        self, state: Sequence[Any], inputs: Mapping[str, Any], out: Any
    ) -> tuple[Sequence[Array], tuple[Array, ...]] | None:
        """Outputs and statuses of all epochs; nothing where the general way must be taken."""
        try:
            given = (*state, *map(inputs.__getitem__, self._names))
            if len(given) != self._count or len(inputs) != len(self._names):
                return None
            first = given[0]
            if first.ndim != self._rank:
                return None
            epochs, items = len(first), self._items(given)
            made = self._stored(epochs, items, out)
        except (AttributeError, LookupError, TypeError, ValueError):
            return None
        status = np.empty(epochs, _BYTE)
        statuses = (status,) if items is None else (status, np.zeros((epochs, items), _BYTE))
        memory = (np.ndarray, *given, *made, *statuses)
        if self._library.threads == 1:
            done = self._entry(id(memory), 0, epochs)
        else:
            done = self._shared(memory, epochs)
        if done == UNFIT:
            return None
        if done and out is None:
            void(made, status)
        return made, statuses

    def given(self, out: Any) -> Sequence[Array]:
        """The arrays given as ``out``, in order.

        Raises:
            LookupError, TypeError, ValueError: for what has to be looked at more closely.
        """
        return outputs(out, *self._fields)

    def _shared(self, memory: tuple[Any, ...], epochs: int) -> int:
        """The same by several threads; what one of them cannot read, none can."""
        shares = self._library.shares(epochs)
        done = self._library.run([partial(self._share, memory, *share) for share in shares])
        return UNFIT if UNFIT in done else max(done)

    def _share(self, memory: tuple[Any, ...], first: int, count: int) -> int:
        """One thread's epochs; its own hold on the memory outlasts a caller that is interrupted."""
        return self._entry(id(memory), first, count)

    def _items(self, given: Sequence[Array]) -> int | None:
        """The number of items, where there are any.

        Raises:
            ValueError: when there are more than the declared maximum.
        """
        if self._counter is None:
            return None
        place, axis = self._counter
        items: int = given[place].shape[axis]
        if items > self._most:
            raise ValueError("items")
        return items

    def _stored(self, epochs: int, items: int | None, out: Any) -> Sequence[Array]:
        """What the C stores to: given arrays, and new ones for the rest."""
        if out is None:
            return [self._new(axes, epochs, items) for axes in self._axes]
        given = self.given(out)
        if len(given) == len(self._axes) and items is None:
            return given
        rest = iter(given)
        pairs = zip(self._axes, self._wanted, strict=True)
        return [
            _as_stored(next(rest), axes) if wanted else self._new(axes, epochs, items)
            for axes, wanted in pairs
        ]

    def _new(self, axes: _Axes, epochs: int, items: int | None) -> Array:
        front, item, back = axes
        own = (*front, items, *back) if item else front
        return np.empty((epochs, *own), self._real)


def _as_stored(array: Array, axes: _Axes) -> Array:
    """An array as it is stored: the items of non-zeros are in front of them for a caller."""
    front, item, _ = axes
    return np.swapaxes(array, -1, -2) if item and front else array


def _axes(output: Output, part: Part, mapped: bool) -> _Axes:
    """Axes of one epoch in front of that of items, whether there is one, and those behind it."""
    nonzeros = part is Part.NONZEROS and output.jacobian
    own = (len(output.places),) if nonzeros else output.shape
    item = mapped and output.item
    return (own, item, ()) if nonzeros or not item else ((), item, own)


def outputs(out: Any, count: int, fields: int) -> Sequence[Array]:
    """The arrays given as ``out`` by their order: one, several, or a result that is used again.

    Raises:
        LookupError, TypeError, ValueError: for anything else; the general way says why.
    """
    if type(out) is np.ndarray:
        out = (out,)
    if len(out) not in (count, fields):
        raise ValueError("out")
    found: Sequence[Array] = out[:count]
    return found


def void(arrays: Sequence[Array], status: Array) -> None:
    """NaN in every epoch that failed."""
    failed = (status != Status.OK) & (status != Status.PARTIAL)
    if failed.any():
        for array in arrays:
            array[failed] = np.nan
