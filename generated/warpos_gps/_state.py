"""The state vector: where each block stands, packing, and the maps to and from its error."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np

from ._runtime import Array


@dataclass(frozen=True)
class Block:
    """One block of the state: its elements in storage, and in the error vector.

    Attributes:
        name: as declared.
        labels: of its elements in storage.
        unit: of its elements in storage.
        frame: they are resolved in, or a map such as ``b -> n``.
        initial: value of elements that are not packed.
        error_labels: of its elements in the error vector.
        error_unit: of those.
        error_frame: of those.
        convention: how the error is defined.
    """

    name: str
    labels: tuple[str, ...]
    unit: str
    frame: str
    initial: tuple[float, ...]
    error_labels: tuple[str, ...]
    error_unit: str
    error_frame: str
    convention: str


class Vector:
    """A vector made of named blocks; each block's name is an attribute that holds its slice."""

    def __init__(
        self,
        names: tuple[str, ...],
        labels: tuple[tuple[str, ...], ...],
        units: tuple[str, ...],
        frames: tuple[str, ...],
    ) -> None:
        self.names = names
        self.units: Mapping[str, str] = MappingProxyType(dict(zip(names, units, strict=True)))
        self.frames: Mapping[str, str] = MappingProxyType(dict(zip(names, frames, strict=True)))
        self.labels = tuple(
            f"{name} {label}" if len(own) > 1 else name
            for name, own in zip(names, labels, strict=True)
            for label in own
        )
        self.size = len(self.labels)
        self.slices: Mapping[str, slice] = MappingProxyType(_slices(names, labels))
        self.__dict__.update(self.slices)
        self._given = names, labels, units, frames

    def __reduce__(self) -> str | tuple[Any, ...]:
        return type(self), self._given


def _slices(names: tuple[str, ...], labels: tuple[tuple[str, ...], ...]) -> dict[str, slice]:
    slices, start = {}, 0
    for name, own in zip(names, labels, strict=True):
        slices[name] = slice(start, start + len(own))
        start += len(own)
    return slices


class StateVector(Vector):
    """The storage vector, with its error vector as the attribute ``error``."""

    def __init__(
        self,
        blocks: tuple[Block, ...],
        digest: str,
        record: type[tuple[Any, ...]],
        retract: Callable[..., Any],
        local: Callable[..., Any],
    ) -> None:
        names = tuple(block.name for block in blocks)
        super().__init__(
            names,
            tuple(block.labels for block in blocks),
            tuple(block.unit for block in blocks),
            tuple(block.frame for block in blocks),
        )
        self.error = Vector(
            names,
            tuple(block.error_labels for block in blocks),
            tuple(block.error_unit for block in blocks),
            tuple(block.error_frame for block in blocks),
        )
        self.error_size = self.error.size
        self.conventions: Mapping[str, str] = MappingProxyType(
            {block.name: block.convention for block in blocks}
        )
        self.digest = digest
        self.initial = np.array([value for block in blocks for value in block.initial])
        self.initial.flags.writeable = False
        self.__module__ = __package__ or ""
        self._record = record
        self._retract = retract
        self._local = local

    def __reduce__(self) -> str:
        return "State"

    def pack(self, **blocks: Any) -> Array:
        """A state vector from its blocks; those not given take their initial value.

        Args:
            **blocks: arrays of shape (..., size of the block); (...) for a block of one element.
        """
        parts = {name: np.asarray(value) for name, value in blocks.items()}
        for name, part in parts.items():
            if name not in self.slices:
                raise TypeError(f"pack: no block {name!r}; the state holds {', '.join(self.names)}")
            if part.dtype.kind not in "biufc":
                raise TypeError(f"pack: {name} must be numbers; got {blocks[name]!r}")
            size = self._length(name)
            if size == 1:
                parts[name] = part[..., None]
            elif part.shape[-1:] != (size,):
                raise ValueError(f"{name}: expected (..., {size}); got {part.shape}")
        lead = np.broadcast_shapes(*(part.shape[:-1] for part in parts.values()))
        kinds = (part.dtype for part in parts.values())
        x = np.empty((*lead, self.size), dtype=np.result_type(np.float64, *kinds))
        x[...] = self.initial
        for name, part in parts.items():
            x[..., self.slices[name]] = part
        return x

    def unpack(self, x: Any) -> Any:
        """The blocks of a state vector by name, as views; a block of one element has no axis."""
        array = x if hasattr(x, "__array_namespace__") else np.asarray(x)
        if tuple(array.shape[-1:]) != (self.size,):
            blocks = " ".join(f"{name}[{self._length(name)}]" for name in self.names)
            raise ValueError(f"x: expected (..., {self.size}) = {blocks}; got {array.shape}")
        parts = [
            array[..., part.start] if self._length(name) == 1 else array[..., part]
            for name, part in self.slices.items()
        ]
        return tuple.__new__(self._record, parts)

    def retract(self, x: Any, d: Any, **inputs: Any) -> Array:
        """The state that lies the error ``d``, shape (..., error_size), away from ``x``.

        The inputs are those that an error in other axes than its block's asks for, if any.
        """
        return self._retract(x, d=d, **inputs)

    def local(self, x: Any, y: Any, **inputs: Any) -> Array:
        """The error, shape (..., error_size), that leads from the state ``x`` to ``y``."""
        return self._local(x, y=y, **inputs)

    def _length(self, name: str) -> int:
        part = self.slices[name]
        return int(part.stop - part.start)
