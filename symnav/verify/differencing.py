"""Single differences of every back end, against the rows of the same back end.

The rows are proven elsewhere; here it is proven that the differenced form subtracts the row of the
reference, and no other, and hands on the same verdicts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav.derive import Derivation, DerivedOutput
from symnav.verify.comparison import Array, Indices
from symnav.verify.sheet import Finding

BACKENDS = ("native", "numpy")


@dataclass(frozen=True)
class Difference:
    """Rows of one output of one back end less those of a reference, in two ways.

    Attributes:
        output: which one.
        comparison: key of ``LIMITS``.
        error: magnitude of what the two ways differ by.
        scale: of the rows that were subtracted.
        rows: of the samples, one per item, that were compared.
    """

    output: DerivedOutput
    comparison: str
    error: Array
    scale: Array
    rows: Indices


@dataclass(frozen=True)
class Rows:
    """What a back end says of every item, one row per sample and item."""

    outputs: Mapping[str, Array]
    ok: NDArray[np.bool_]


def differenced(
    derivation: Derivation, backend: str, function: Any, arguments: Mapping[str, Any], rows: Rows
) -> Iterator[Difference | Finding]:
    """Compare the differenced form with differences of rows, for the first and the last reference.

    Args:
        derivation: of the function.
        backend: name of the back end.
        function: the generated one.
        arguments: as it wants them, by name; the items are the second axis of some.
        rows: its plain results.
    """
    epochs = len(next(iter(arguments.values())))
    items = len(rows.ok) // epochs
    ok = rows.ok.reshape(epochs, items)
    places = np.arange(len(rows.ok)).reshape(epochs, items)
    for reference in sorted({0, items - 1}):
        result = function.single_difference(**arguments, reference=reference)
        others = np.delete(np.arange(items), reference)
        healthy = ok[:, others] & ok[:, [reference]]
        verdicts = np.asarray(result.item_status)[:, others] == 0
        if (verdicts != healthy)[ok[:, reference]].any():
            message = f"single differences of {backend} judge items by another standard"
            yield Finding(derivation.name, message)
        for output in derivation.outputs:  # the rows of every one are of items
            plain = rows.outputs[output.name].reshape(epochs, items, *_shape(output))
            found = np.asarray(getattr(result, output.name), dtype=np.float64)
            found = found.reshape(epochs, items - 1, *_shape(output))
            ahead, behind = plain[:, others], plain[:, [reference]]
            error = np.abs(found - (ahead - behind))[healthy]
            scale = (np.abs(ahead) + np.abs(behind))[healthy]
            comparison = f"{backend} difference vs rows"
            yield Difference(output, comparison, error, scale, places[:, others][healthy])


def _shape(output: DerivedOutput) -> Sequence[int]:
    return (output.rows, output.columns) if output.kind == "jacobian" else (output.rows,)
