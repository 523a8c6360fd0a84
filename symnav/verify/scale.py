"""The scale of an error: |h| + sum_j |dh/dx_j| |x_j|.

An output that is a small difference of large inputs cannot be more exact than the inputs' own
rounding lets it be; errors are measured against what one part in 2^52 of each input would do.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from symnav.derive import Derivation
from symnav.verify import closures
from symnav.verify.numbers import Array, Graded, Gradients


class Scale:
    """Scales of every output element of a derivation, Jacobians included."""

    def __init__(self, derivation: Derivation) -> None:
        self._derivation = derivation
        system = Gradients()
        self._steps = [
            (d.symbol, closures.closure(d.expression, system)) for d in derivation.definitions
        ]
        self._outputs = {
            output.name: {key: closures.closure(e, system) for key, e in output.entries.items()}
            for output in derivation.outputs
        }

    def outputs(self, arguments: Mapping[str, NDArray[np.float64]]) -> dict[str, Array]:
        """Scales by output name: (S, rows) or (S, rows, columns); zero where structurally zero.

        Args:
            arguments: (S, size) arrays by argument name, one item each.
        """
        env = self._environment(arguments)
        samples = len(next(iter(arguments.values())))
        with np.errstate(all="ignore"):
            for symbol, value in self._steps:
                env[symbol] = value(env)
            return {
                output.name: self._dense(output.name, env, samples)
                for output in self._derivation.outputs
            }

    def _dense(self, name: str, env: dict[sp.Symbol, Graded], samples: int) -> Array:
        output = next(o for o in self._derivation.outputs if o.name == name)
        columns = max(output.columns, 1)
        result = np.zeros((samples, output.rows, columns))
        for (row, column), value in self._outputs[name].items():
            number = value(env)
            result[:, row, column] = self._magnitude(number)
        return result if output.kind == "jacobian" else result[:, :, 0]

    def _magnitude(self, number: Graded | float) -> Array | float:
        if not isinstance(number, Graded):
            return abs(float(number))
        moved: Array = np.sum(np.abs(number.slope) * self._inputs, axis=1)
        return np.abs(number.value) + moved

    def _environment(self, arguments: Mapping[str, NDArray[np.float64]]) -> dict[sp.Symbol, Graded]:
        origins = [(s, o) for s, o in self._derivation.origins.items() if o.argument in arguments]
        columns = []
        for _, origin in origins:
            index: int | NDArray[np.int64] = origin.index
            values = arguments[origin.argument]
            if origin.slot is not None:
                slot = self._derivation.origins[origin.slot]
                index = origin.index + arguments[slot.argument][:, 0].astype(np.int64)
                columns.append(values[np.arange(len(values)), index])
            else:
                columns.append(values[:, index])
        stacked = np.stack(columns, axis=1)
        self._inputs = np.abs(stacked)
        identity = np.eye(len(origins))
        return {
            symbol: Graded(stacked[:, k].copy(), np.tile(identity[k], (len(stacked), 1)))
            for k, (symbol, _) in enumerate(origins)
        }
