"""The scale of an error.

The strict scale of an output is |h| + sum_j |dh/dx_j| |x_j| over its inputs: what one relative
rounding of every input does to it. It vanishes where inputs are zero or the geometry is symmetric
(a satellite on the axis, a half turn) although the terms of the equation are not small there. The
full scale adds sum_k |dh/dt_k| |t_k| over the named terms: what one rounding of every intermediate
step does, a term that is a sum counting with the size of what it adds up. An error passes when it
is within its limit at the strict scale, or within a few units in the last place at the full one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from symnav.derive import Derivation, DerivedOutput
from symnav.verify import closures
from symnav.verify.numbers import Array, Graded, Gradients

#: Samples per pass, so that the gradients by every term stay small in memory.
CHUNK = 64


@dataclass(frozen=True)
class Scales:
    """Strict and full scale of one output: (S, rows) or (S, rows, columns)."""

    strict: Array
    full: Array

    def limited(self, relative: float, roundings: float, underflow: float) -> Array:
        """The scale at which ``relative`` is the limit.

        Args:
            relative: limit at the strict scale.
            roundings: allowed at the full scale, in absolute terms (such as 8 * 2^-52).
            underflow: allowed at any scale, in the unit of the output.
        """
        scale: Array = np.maximum(self.strict, self.full * (roundings / relative))
        return np.maximum(scale, underflow / relative)

    def at(self, rows: NDArray[np.intp]) -> Scales:
        """The scales of some samples."""
        return Scales(self.strict[rows], self.full[rows])


class ScaleOf:
    """Scales of every output element of a derivation, Jacobians included."""

    def __init__(self, derivation: Derivation) -> None:
        self._derivation = derivation
        system = Gradients()
        self._steps = [
            (d.symbol, closures.closure(d.expression, system)) for d in derivation.definitions
        ]
        self._guards = {d.symbol: d.guard for d in derivation.definitions if d.guard is not None}
        self._values = {
            output.name: {key: closures.closure(e, system) for key, e in output.entries.items()}
            for output in derivation.outputs
        }

    def outputs(self, arguments: Mapping[str, Array]) -> dict[str, Scales]:
        """Scales by output name; zero where structurally zero.

        Args:
            arguments: (S, size) arrays by argument name, one item each.
        """
        count = len(next(iter(arguments.values())))
        pieces = [
            self._chunk({name: a[start : start + CHUNK] for name, a in arguments.items()})
            for start in range(0, count, CHUNK)
        ]
        return {
            output.name: Scales(
                np.concatenate([piece[output.name].strict for piece in pieces]),
                np.concatenate([piece[output.name].full for piece in pieces]),
            )
            for output in self._derivation.outputs
        }

    def inside(self, arguments: Mapping[str, Array]) -> NDArray[np.bool_]:
        """Where every guarded term is within its domain, whether the code checks it or not.

        Args:
            arguments: (S, size) arrays by argument name, one item each.
        """
        env, inputs = self._environment(arguments)
        good = np.ones(len(inputs), dtype=np.bool_)
        with np.errstate(all="ignore"):
            for symbol, value in self._steps:
                number = env[symbol] = value(env)
                guard = self._guards.get(symbol)
                if guard is not None:
                    plain = number.value if isinstance(number, Graded) else number
                    good &= (plain >= guard.lower) & (plain <= guard.upper)
        return good

    def _chunk(self, arguments: Mapping[str, Array]) -> dict[str, Scales]:
        env, inputs = self._environment(arguments)
        samples, width = inputs.shape
        sizes = np.zeros((samples, width))
        sizes[:, : len(env)] = np.abs(inputs[:, : len(env)])
        known = len(env)
        with np.errstate(all="ignore"):
            for k, (symbol, value) in enumerate(self._steps):
                number = value(env)
                if isinstance(number, Graded):
                    slope = np.broadcast_to(number.slope, sizes.shape).copy()
                    slope[:, known + k] = 1.0
                    sizes[:, known + k] = number.size
                    number = Graded(number.value, slope, np.abs(number.value))
                env[symbol] = number
            return {
                output.name: self._scales(output, env, sizes, known)
                for output in self._derivation.outputs
            }

    def _scales(
        self, output: DerivedOutput, env: Mapping[sp.Symbol, Graded], sizes: Array, known: int
    ) -> Scales:
        shape = (len(sizes), output.rows, max(output.columns, 1))
        strict, full = np.zeros(shape), np.zeros(shape)
        for (row, column), value in self._values[output.name].items():
            number = value(dict(env))
            if not isinstance(number, Graded):
                strict[:, row, column] = full[:, row, column] = abs(float(number))
                continue
            parts = np.abs(number.slope) * sizes
            parts = np.where(sizes == 0.0, 0.0, parts)
            strict[:, row, column] = np.abs(number.value) + parts[:, :known].sum(axis=1)
            full[:, row, column] = number.size + parts.sum(axis=1)
        if output.kind == "jacobian":
            return Scales(strict, full)
        return Scales(strict[:, :, 0], full[:, :, 0])

    def _environment(self, arguments: Mapping[str, Array]) -> tuple[dict[sp.Symbol, Graded], Array]:
        """Argument symbols with unit gradients; columns after them belong to the named terms."""
        derivation = self._derivation
        origins = [(s, o) for s, o in derivation.origins.items() if o.argument in arguments]
        width = len(origins) + len(self._steps)
        columns = []
        for _, origin in origins:
            values = arguments[origin.argument]
            if origin.slot is None:
                columns.append(values[:, origin.index])
                continue
            slots = arguments[derivation.origins[origin.slot].argument][:, 0].astype(np.intp)
            columns.append(values[np.arange(len(values)), origin.index + slots])
        stacked = np.stack(columns, axis=1)
        env = {}
        for k, (symbol, _) in enumerate(origins):
            slope = np.zeros((len(stacked), width))
            slope[:, k] = 1.0
            env[symbol] = Graded(stacked[:, k].copy(), slope, np.abs(stacked[:, k]))
        padded = np.zeros((len(stacked), width))
        padded[:, : len(origins)] = stacked
        return env, padded
