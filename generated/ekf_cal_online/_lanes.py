"""Blocks of epochs side by side: the arrangement in which compiled code runs many epochs at once.

Element k of lane l of block b stands at ``[b, k, l]``; epoch e is lane ``e % lanes`` of block
``e // lanes``. Arrays that are kept like this need no rearrangement, which from rows takes longer
than the arithmetic of a small function.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._runtime import (
    Array,
    Extent,
    Output,
    Part,
    Signature,
    Status,
    as_numbers,
    collect,
    forbid_overlap,
)

if TYPE_CHECKING:
    from ._calls import Function


class Blocks(NamedTuple):
    """What a call for blocks returns.

    Attributes:
        outputs: by name: values, and the structural non-zeros of Jacobians, shape
            (blocks, elements, lanes); NaN where an epoch failed, unless the arrays were given.
        status: of every epoch, in the order of the epochs.
    """

    outputs: Mapping[str, Array]
    status: Array


def to_lanes(rows: Any, lanes: int) -> Array:
    """Rows of epochs, shape (epochs, elements) or (epochs,), as blocks.

    Lanes behind the last epoch repeat it.
    """
    array = np.asarray(rows)
    if array.ndim not in (1, 2):
        raise ValueError(f"to_lanes: expected (epochs, elements) or (epochs,); got {array.shape}")
    array = array.reshape(len(array), -1 if array.size else int(np.prod(array.shape[1:])))
    blocks = -(-len(array) // lanes)
    spare = blocks * lanes - len(array)
    if spare:
        array = np.concatenate([array, np.repeat(array[-1:], spare, axis=0)])
    blocked = array.reshape(blocks, lanes, array.shape[1]).transpose(0, 2, 1)
    return np.array(blocked, order="C")


def from_lanes(blocked: Any, epochs: int | None = None) -> Array:
    """Blocks of shape (blocks, elements, lanes) as new rows, shape (epochs, elements).

    Args:
        blocked: the blocks.
        epochs: how many there are, where the last block is not full.
    """
    array = np.asarray(blocked)
    if array.ndim != 3:
        raise ValueError(f"from_lanes: expected (blocks, elements, lanes); got {array.shape}")
    blocks, elements, lanes = array.shape
    rows = np.array(array.transpose(0, 2, 1), order="C").reshape(blocks * lanes, elements)
    return rows[: _count(epochs, blocks * lanes)]


def to_lanes_of(lanes: int) -> Callable[[Any], Array]:
    """The arrangement of one function."""

    def own(rows: Any) -> Array:
        """Rows of epochs, shape (epochs, elements) or (epochs,), as blocks."""
        return to_lanes(rows, lanes)

    return own


def _count(epochs: int | None, most: int) -> int:
    count = most if epochs is None else operator.index(epochs)
    if not 0 <= count <= most:
        raise ValueError(f"epochs = {count}, but the blocks hold {most}")
    return count


def forms(function: Function) -> dict[str, Callable[..., Any]]:
    """The calls for blocks of a function that is not mapped."""

    def blocks(*state: Any, epochs: int | None = None, out: Any = None, **inputs: Any) -> Any:
        """Values and non-zeros of epochs in blocks of ``lanes``; see ``to_lanes``."""
        call = _Call(function, state, inputs, epochs, out)
        function.evaluate_blocks(call.arrays, call.epochs, call.outputs, call.status)
        return call.result(void=out is None)

    def bind_blocks(*state: Any, epochs: int | None = None, out: Any = None, **inputs: Any) -> Any:
        """A function without arguments over these very blocks; what fails keeps what was there."""
        call = _Call(function, state, inputs, epochs, out, lasting=True)
        if out is None:
            call.void()
        run = function.bound_blocks(call.arrays, call.epochs, call.outputs, call.status)
        return call.bound(run)

    return {"blocks": blocks, "bind_blocks": bind_blocks}


class _Call:
    """The checked arguments of one call for blocks."""

    def __init__(
        self,
        function: Function,
        state: Sequence[Any],
        inputs: Mapping[str, Any],
        epochs: int | None,
        out: Any,
        *,
        lasting: bool = False,
    ) -> None:
        signature, real = function.signature, function.real
        values = collect(signature, state, inputs)
        pairs = zip(signature.arguments, values, strict=True)
        self.arrays = [
            np.ascontiguousarray(as_numbers(argument, value, real, False))
            for argument, value in pairs
        ]
        for name, value, array in zip(signature.names, values, self.arrays, strict=True):
            if lasting and array is not value:
                raise TypeError(f"bind_blocks: {name} must be a contiguous array of {array.dtype}")
        blocks = self._measured(signature)
        self.epochs = _count(epochs, blocks * signature.lanes)
        self.outputs = _targets(signature, blocks, out, real)
        forbid_overlap(signature, self.arrays, list(self.outputs.values()))
        self.status: Array = np.zeros(self.epochs, dtype=np.uint8)

    def result(self, *, void: bool) -> Blocks:
        """The outputs, NaN where nothing was written to new arrays."""
        if void:
            for array in self.outputs.values():
                lanes = array.shape[2]
                failed = np.ones(array.shape[0] * lanes, dtype=bool)
                failed[: self.epochs] = self.status != Status.OK
                if failed.any():
                    array.transpose(0, 2, 1)[failed.reshape(-1, lanes)] = np.nan
        return Blocks(self.outputs, self.status)

    def void(self) -> None:
        """NaN everywhere, for what nothing is written to."""
        for array in self.outputs.values():
            array.fill(np.nan)

    def bound(self, run: Callable[[], Any]) -> Callable[[], Blocks]:
        """The call over and over."""
        done = Blocks(self.outputs, self.status)

        def call() -> Blocks:
            run()
            return done

        return call

    def _measured(self, signature: Signature) -> int:
        """The number of blocks, the same in every argument."""
        blocks: int | None = None
        for argument, array in zip(signature.arguments, self.arrays, strict=True):
            own = (argument.size, signature.lanes)
            if (
                array.ndim != 3
                or array.shape[1:] != own
                or array.shape[0] != (array.shape[0] if blocks is None else blocks)
            ):
                number = "blocks" if blocks is None else blocks
                raise ValueError(
                    f"{argument.name}: expected ({number}, {own[0]}, {own[1]}); got {array.shape}"
                )
            blocks = array.shape[0]
        return blocks or 0


def _targets(signature: Signature, blocks: int, out: Any, real: np.dtype[Any]) -> dict[str, Array]:
    """Arrays for every output, new or given."""
    shapes = {
        output.name: (blocks, elements(output), signature.lanes) for output in signature.outputs
    }
    if out is None:
        return {name: np.empty(shape, dtype=real) for name, shape in shapes.items()}
    given = out.outputs if isinstance(out, Blocks) else out
    if not isinstance(given, Mapping) or set(given) != set(shapes):
        raise TypeError(f"out: expected a dict of arrays for {', '.join(shapes)}")
    for name, shape in shapes.items():
        array = given[name]
        fits = isinstance(array, np.ndarray) and array.shape == shape and array.dtype == real
        if not (fits and array.flags.carray):
            raise ValueError(f"out: {name} must be a contiguous {real} array of shape {shape}")
    return {name: given[name] for name in shapes}


def elements(output: Output) -> int:
    """Elements of an output that one epoch has in a block."""
    return len(output.places) if output.jacobian else output.size


def evaluate_rows(
    function: Function,
    arrays: Sequence[Array],
    epochs: int,
    outputs: Mapping[str, Array],
    status: Array,
) -> None:
    """Blocks by way of rows, for back ends without code for blocks."""
    rows = [
        from_lanes(array, epochs)[:, 0] if argument.scalar else from_lanes(array, epochs)
        for argument, array in zip(function.signature.arguments, arrays, strict=True)
    ]
    extent = Extent((epochs,), None)
    for part in (Part.VALUE, Part.NONZEROS):
        done = function.evaluate(part, rows, extent, None)
        status[...] = done.status
        jacobian = part is Part.NONZEROS
        wanted = [o for o in function.signature.outputs if o.jacobian is jacobian]
        for output, array in zip(wanted, done.outputs, strict=True):
            lanes = outputs[output.name].shape[2]
            for epoch in np.flatnonzero(status == Status.OK):
                place = (epoch // lanes, slice(None), epoch % lanes)
                outputs[output.name][place] = array[epoch].reshape(-1)
