"""Where structural non-zeros stand, also those whose place depends on a run-time index."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ._runtime import Array, Output, Slot


def index_of(slot: Slot, arguments: Mapping[str, Array]) -> Array:
    """The run-time index of a slot."""
    array = arguments[slot.argument]
    return array if slot.element is None else array[..., slot.element]


def columns_of(slot: Slot) -> list[tuple[int, int]]:
    """Every index a slot may have, with the place it leads to."""
    span = range(slot.lower, slot.upper + 1)
    return [(number, slot.base + slot.stride * number) for number in span]


def gather(output: Output, flat: Array, arguments: Mapping[str, Array]) -> Array:
    """The non-zeros of a flattened NumPy output, along its last axis."""
    lead = flat.shape[:-1]
    columns: list[Array] = []
    for place in output.places:
        if isinstance(place, Slot):
            index = np.clip(index_of(place, arguments), place.lower, place.upper)
            where = np.broadcast_to(index * place.stride + place.base, lead)[..., None]
            columns.append(np.take_along_axis(flat, where, axis=-1)[..., 0])
        else:
            columns.append(flat[..., place])
    return np.stack(columns, axis=-1) if columns else np.empty((*lead, 0), dtype=flat.dtype)
