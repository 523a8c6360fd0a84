"""The C of a bundle, compiled and called for many inputs at once."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.export.rounding.sampling import TYPES

Array = NDArray[Any]
FLAGS = ("-std=c99", "-O2", "-ffp-contract=off")
ITEMS = 4
"""Satellites in one call."""


def compile_sources(folder: Path, prefix: str, flags: Sequence[str] = FLAGS) -> ctypes.CDLL:
    """The sources of one tree of a bundle as a library."""
    sources = sorted(path for path in (folder / "src").glob(f"{prefix}_*.c"))
    library = folder / f"lib{prefix}.so"
    command = ["gcc", *flags, "-fPIC", "-shared", f"-I{folder / 'include'}", "-o", str(library)]
    subprocess.run([*command, *map(str, sources), "-lm"], check=True)
    return ctypes.CDLL(str(library))


@dataclass(frozen=True)
class Compiled:
    """One function of a compiled tree."""

    library: ctypes.CDLL
    prefix: str
    function: ir.Function
    scalar: ir.Scalar

    def __call__(self, arguments: Mapping[str, Array]) -> tuple[dict[str, Array], Array]:
        """Every entry of every output, (count, entries) each, and where the status was OK.

        Args:
            arguments: (count, size) each; of a mapped function those of one item each, so that
                neighbours share what is not per item.
        """
        items = ITEMS if self.function.maximum is not None else 1
        count = len(next(iter(arguments.values())))
        epochs = count // items
        kind = TYPES[self.scalar]
        held: list[Array] = []
        parameters: list[Any] = [ctypes.c_int32(epochs)]
        for argument in self.function.arguments:
            rows = arguments[argument.name]
            if not argument.item:
                rows = rows[::items]
            held.append(np.ascontiguousarray(rows, dtype=np.int32 if argument.integer else kind))
            step = argument.size * (items if argument.item else 1)
            parameters += [held[-1].ctypes.data_as(ctypes.c_void_p), ctypes.c_int32(step)]
            if self.function.maximum is not None and len(held) == 1:
                parameters.append(ctypes.c_int32(items))
        outputs = {o.name: self._room(o, epochs, items, kind) for o in self.function.outputs}
        status = np.full(epochs, 255, dtype=np.uint8)
        item_status = np.full((epochs, items), 255, dtype=np.uint8)
        written = [*outputs.values(), status]
        written += [item_status] if self.function.maximum is not None else []
        parameters += [array.ctypes.data_as(ctypes.c_void_p) for array in written]
        getattr(self.library, f"{self.prefix}_{self.function.name}_batch")(*parameters)
        passed = np.isin(status, (ir.Status.OK, ir.Status.PARTIAL))[:, None]
        if self.function.maximum is not None:
            passed = passed & (item_status == ir.Status.OK)
        found = {
            o.name: self._entries(o, outputs[o.name], arguments) for o in self.function.outputs
        }
        return found, passed.reshape(-1)

    def _room(self, output: ir.Output, epochs: int, items: int, kind: Any) -> Array:
        per_item = items if output.item and self.function.maximum is not None else 1
        return np.full((epochs, per_item, prod(output.shape)), np.nan, dtype=kind)

    def _entries(self, output: ir.Output, room: Array, arguments: Mapping[str, Array]) -> Array:
        count = len(next(iter(arguments.values())))
        rows = np.repeat(room, count // (room.shape[0] * room.shape[1]), axis=1)
        rows = rows.reshape(count, -1)
        columns = [self._column(output, entry, rows, arguments) for entry in output.entries]
        return np.stack(columns or [np.zeros(count)], axis=1)

    def _column(
        self, output: ir.Output, entry: ir.Entry, rows: Array, arguments: Mapping[str, Array]
    ) -> Array:
        places = np.zeros(len(rows), dtype=np.intp)
        for axis, index in enumerate(entry.index):
            stride = prod(output.shape[axis + 1 :])
            if isinstance(index, ir.Offset):
                assert isinstance(index.slot.index, int)
                slot = arguments[index.slot.argument][:, index.slot.index].astype(np.intp)
                places += stride * (index.base + slot)
            else:
                places += stride * index
        return np.asarray(rows[np.arange(len(rows)), places])


def shared_by_items(function: ir.Function, arguments: Mapping[str, Array]) -> dict[str, Array]:
    """Samples in which neighbours have the same state and the same of all else that is shared."""
    if function.maximum is None:
        return dict(arguments)
    count = len(next(iter(arguments.values()))) // ITEMS * ITEMS
    return {
        argument.name: arguments[argument.name][:count]
        if argument.item
        else np.repeat(arguments[argument.name][:count:ITEMS], ITEMS, axis=0)
        for argument in function.arguments
    }
