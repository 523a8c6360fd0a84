"""Retract and local: against fifty digits, and as inverses of each other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from mpmath import mp

from symnav.binding import STATE
from symnav.blocks import HeadingBlock
from symnav.derive import Derivation
from symnav.spec.records import Spec
from symnav.verify.comparison import Array, Worst, differences
from symnav.verify.exact import DIGITS, Exact
from symnav.verify.retraction import retract as exact_retract
from symnav.verify.sampling import draw
from symnav.verify.sheet import Row


def prove_layout(
    spec: Spec,
    layout_functions: Sequence[Derivation],
    backends: Mapping[str, Any],
    samples: int,
    seed: int,
) -> list[Row]:
    """Retract and local against fifty digits, and as inverses of each other."""
    retract, _ = layout_functions
    drawn = draw(spec, retract, samples, seed)
    arguments = dict(drawn.arguments)
    rows: list[Row] = []
    for name, module in backends.items():
        if name in ("casadi", "native_f32"):
            continue
        extra = {key: value for key, value in arguments.items() if key not in (STATE, "d")}
        x = arguments[STATE]
        step = module.retract(x, d=arguments["d"], **extra)
        # A state moved out of its declared range is retracted, but has no local coordinates.
        whole = np.where(np.isnan(step.value), x, step.value)
        back = module.local(x, y=whole, **extra)
        moved = np.asarray(step.status) == 0
        inside = np.flatnonzero(moved & (np.asarray(back.status) == 0))
        chosen = {key: value[inside] for key, value in arguments.items()}
        rows += _inverse_rows(spec, name, chosen, np.asarray(back.value)[inside])
        if name == "native":
            few = drawn.judged(np.flatnonzero(moved))
            chosen = {key: value[few] for key, value in arguments.items()}
            rows += _retract_rows(spec, retract, chosen, np.asarray(step.value)[few])
    return rows


def _inverse_rows(spec: Spec, name: str, arguments: Mapping[str, Array], back: Array) -> list[Row]:
    d, x = arguments["d"], arguments[STATE]
    rows = []
    for place in spec.layout.places.values():
        error = np.abs(back[:, place.error] - d[:, place.error])
        if isinstance(place.block, HeadingBlock):
            error = _turned_back(error)
        # An additive error is known to the rounding of the stored value it moves.
        stored = np.max(np.abs(x[:, place.storage]), axis=1, keepdims=True)
        radius = 6.4e6 if place.block.kind == "geodetic" else 0.0
        scale = np.abs(d[:, place.error]).max(axis=1, keepdims=True) + stored + radius + 1.0
        worst = Worst(place.block.units[1])
        worst.add(error, np.broadcast_to(scale, error.shape), np.arange(len(d)))
        rows.append(
            Row(
                "State",
                place.block.name,
                f"{name} retract then local",
                worst.relative,
                worst.absolute,
                worst.unit,
                worst.samples,
                _reproduction(x, d, worst.index),
            )
        )
    return rows


def _reproduction(x: Array, d: Array, index: int) -> str:
    if index < 0:
        return "  no state and error inside the declared ranges stayed inside them"
    return (
        f"  State.local(x, State.retract(x, d)) at x={x[index].tolist()!r}, d={d[index].tolist()!r}"
    )


def _retract_rows(
    spec: Spec, retract: Derivation, arguments: Mapping[str, Array], moved: Array
) -> list[Row]:
    exact = Exact(spec, retract)
    rows = []
    with mp.workdps(DIGITS):
        for place in spec.layout.places.values():
            worst = Worst(place.block.units[0])
            for k in range(len(moved)):
                numbers = {n: [mp.mpf(float(v)) for v in a[k]] for n, a in arguments.items()}
                truth = exact_retract(
                    place.block,
                    numbers[STATE][place.storage],
                    numbers["d"][place.error],
                    lambda s, t, n=numbers: exact.matrix(n, s, t),  # type: ignore[misc]
                )
                got = moved[k : k + 1, place.storage]
                error = np.abs(differences(got, truth))
                if place.block.kind in ("heading", "geodetic"):
                    error = np.where(error > np.pi, _turned_back(error), error)
                scale = np.abs(got) + np.abs(arguments["d"][k, place.error]).max() * 1e-6 + 1.0
                worst.add(error, scale, np.array([k]))
            rows.append(
                Row(
                    "State",
                    place.block.name,
                    "native retract vs 50 digits",
                    worst.relative,
                    worst.absolute,
                    worst.unit,
                    worst.samples,
                    "",
                )
            )
    return rows


def _turned_back(angle: Array) -> Array:
    """Size of an angle that is known up to whole turns."""
    size: Array = np.abs((angle + np.pi) % (2.0 * np.pi) - np.pi)
    return size
