"""Single differences of every back end, against rows of the same back end.

Rows are proven elsewhere. Here it is proven that the differenced form subtracts the row of the
reference, whichever that is, that the verdicts on items and the whole are those of the rows, and
that what fails leaves zeros. It is looked at with the samples as they are, with more items than the
C evaluates side by side, and with items that are no numbers.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.derive import Derivation, DerivedOutput
from symnav.verify.comparison import Array, Indices
from symnav.verify.sheet import DIFFERENCED, Finding

_CROWD = 40  # items, more than two of the blocks that the C evaluates side by side
_EPOCHS = 8

Arguments = Mapping[str, NDArray[Any]]


@dataclass(frozen=True)
class Difference:
    """Rows of one output of one back end less those of a reference, in two ways.

    Attributes:
        output: which one.
        comparison: key of ``LIMITS``.
        error: magnitude of what the two ways differ by.
        scale: of the rows that were subtracted.
        rows: of the samples, one per item; -1 for what is no sample.
    """

    output: DerivedOutput
    comparison: str
    error: Array
    scale: Array
    rows: Indices


@dataclass(frozen=True)
class _Scene:
    """Arguments of several epochs.

    Attributes:
        arguments: by name.
        inside: (epochs, items), what the equation has a value for.
        sampled: True when they are the samples.
    """

    arguments: Arguments
    inside: NDArray[np.bool_]
    sampled: bool


def differenced(
    derivation: Derivation,
    backend: str,
    function: Any,
    arguments: Arguments,
    per_item: Collection[str],
    inside: NDArray[np.bool_],
) -> Iterator[Difference | Finding]:
    """Compare the differenced form with differences of rows.

    Args:
        derivation: of the function.
        backend: name of the back end.
        function: the generated one.
        arguments: as it wants them, by name, with an axis of epochs.
        per_item: names of those with a second axis, of items.
        inside: (epochs, items), where the equation has a value.
    """
    for scene in _scenes(derivation, arguments, per_item, inside):
        plain = function(**scene.arguments)
        items = scene.inside.shape[1]
        for reference in sorted({0, 1, items // 2, items - 1} & set(range(items))):
            found = function.single_difference(**scene.arguments, reference=reference)
            if wrong := _wrong_verdict(plain, found, reference):
                message = f"single differences of {backend} by item {reference} of {items}: {wrong}"
                yield Finding(derivation.name, message)
            yield from _differences(derivation, backend, scene, plain, found, reference)


def _differences(
    derivation: Derivation, backend: str, scene: _Scene, plain: Any, found: Any, reference: int
) -> Iterator[Difference]:
    """Every output: rows where both items are healthy, and zeros where only the reference is."""
    epochs, items = scene.inside.shape
    good = (np.asarray(plain.item_status) == ir.Status.OK) & _whole(plain)[:, None]
    others = np.delete(np.arange(items), reference)
    inside = scene.inside[:, others] & scene.inside[:, [reference]]
    healthy = good[:, others] & good[:, [reference]] & inside
    void = ~good[:, others] & good[:, [reference]]
    places = np.full((epochs, items), -1)
    if scene.sampled:
        places = np.arange(epochs * items).reshape(epochs, items)
    for output in derivation.outputs:
        shape = (output.rows, output.columns) if output.kind == "jacobian" else (output.rows,)
        rows = np.asarray(getattr(plain, output.name)).reshape(epochs, items, *shape)
        got = np.asarray(getattr(found, output.name)).reshape(epochs, items - 1, *shape)
        ahead, behind = rows[:, others], rows[:, [reference]]
        with np.errstate(all="ignore"):
            expected = np.where(_as_wide(void, got), 0.0, ahead - behind)
            error, scale = np.abs(got - expected), np.abs(ahead) + np.abs(behind)
        for chosen, size in ((healthy, scale), (void, np.ones_like(scale))):
            if chosen.any():
                yield Difference(
                    output, DIFFERENCED[backend],
                    error[chosen], size[chosen], places[:, others][chosen],
                )  # fmt: skip


def _wrong_verdict(plain: Any, found: Any, reference: int) -> str:
    """What is wrong with the statuses of differences, given those of rows."""
    whole, item = np.asarray(plain.status), np.asarray(plain.item_status)
    behind = item[:, reference]
    going_on = _whole(plain) & (behind == ir.Status.OK)
    expected = np.where(_whole(plain) & (behind != ir.Status.OK), behind, whole)
    if (np.asarray(found.status) != expected).any():
        k = int(np.flatnonzero(np.asarray(found.status) != expected)[0])
        return f"status {int(np.asarray(found.status)[k])} instead of {int(expected[k])}"
    if (np.asarray(found.item_status) != item)[going_on].any():
        return "statuses of items other than those of their rows"
    return ""


def _whole(result: Any) -> NDArray[np.bool_]:
    """Epochs that were evaluated, be it with items that failed."""
    return np.isin(np.asarray(result.status), (ir.Status.OK, ir.Status.PARTIAL))


def _scenes(
    derivation: Derivation,
    arguments: Arguments,
    per_item: Collection[str],
    inside: NDArray[np.bool_],
) -> Iterator[_Scene]:
    """The samples; many items; and, where the code looks at them, items that are no numbers."""
    yield _Scene(arguments, inside, sampled=True)
    entry = derivation.entry
    if entry is None or entry.guards == "assume":
        return
    epochs, items = inside.shape
    many = min(_CROWD, entry.maximum or items)
    taken = (np.arange(_EPOCHS)[:, None] * items + np.arange(many)) % (epochs * items)
    crowd = {
        name: a.reshape(-1, *a.shape[2:])[taken] if name in per_item else a[taken[:, 0] // items]
        for name, a in arguments.items()
    }
    everywhere = np.ones((_EPOCHS, many), dtype=np.bool_)
    yield _Scene(crowd, everywhere, sampled=False)
    numbers = [name for name in sorted(per_item) if crowd[name].dtype.kind == "f"]
    for name in numbers[:1]:
        spoiled = crowd[name].copy()
        for epoch in range(_EPOCHS):
            spoiled[epoch, [(3 * epoch) % many, (many - epoch) % many]] = np.nan
        yield _Scene({**crowd, name: spoiled}, everywhere, sampled=False)


def _as_wide(chosen: NDArray[np.bool_], rows: Array) -> NDArray[np.bool_]:
    wide: NDArray[np.bool_] = chosen.reshape(*chosen.shape, *[1] * (rows.ndim - 2))
    return wide
