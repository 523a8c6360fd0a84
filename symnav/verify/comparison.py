"""The largest error of a comparison, and differences that keep their digits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.intp]


@dataclass
class Worst:
    """The largest error of one comparison so far."""

    unit: str
    relative: float = 0.0
    absolute: float = 0.0
    samples: int = 0
    index: int = -1

    def add(self, error: Array, scale: Array, rows: Indices) -> None:
        """Take in errors (S, ...) at scales; ``rows`` says which samples they are."""
        self.samples += error.size
        if error.size == 0:
            return
        with np.errstate(all="ignore"):
            relative = np.where(error == 0.0, 0.0, error / scale)
        relative = np.where(np.isnan(relative) | np.isnan(error), np.inf, relative)
        flat = relative.reshape(len(rows), -1).max(axis=1)
        worst = int(np.argmax(flat))
        if flat[worst] >= self.relative:
            self.relative = float(flat[worst])
            self.index = int(rows[worst])
        self.absolute = max(self.absolute, float(np.max(error)))


def differences(got: Array, truth: Sequence[Any]) -> Array:
    """What was computed less the truth, formed with all digits of the truth.

    Where the truth is no real number, neither is the difference.
    """
    flat = [_difference(float(a), b) for a, b in zip(got.ravel(), truth, strict=True)]
    return np.array(flat).reshape(got.shape)


def forget_remainders(error: Array, got: Array) -> None:
    """Errors that differences cannot tell from zero become zero.

    Central differences never quite vanish: of a structural zero they leave a remainder, which no
    scale would forgive.
    """
    error[np.abs(error) < REMAINDER * np.abs(got).max(initial=0.0)] = 0.0


REMAINDER = 1e-18
"""Part of the largest element of a Jacobian: far below a rounding of it, above what is left."""


def _difference(got: float, truth: Any) -> float:
    difference = mp.mpf(got) - truth
    return float(difference.real) if difference.imag == 0 else float("nan")
