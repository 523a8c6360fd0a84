"""Sine and cosine of the trigonometry file as IEEE 754 arithmetic, operation by operation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import trigonometry

Real = NDArray[Any]

_OF: Mapping[Any, trigonometry.Coefficients] = {
    np.dtype(np.float64): trigonometry.DOUBLE,
    np.dtype(np.float32): trigonometry.SINGLE,
}


def sine(angle: Real) -> Real:
    """What ``sine_of`` returns, to the bit; ``angle`` decides the type."""
    turn = _turn(angle)
    return np.asarray(turn.cosine * _sine(turn) + turn.sine * _cosine(turn))


def cosine(angle: Real) -> Real:
    """What ``cosine_of`` returns, to the bit; ``angle`` decides the type."""
    turn = _turn(angle)
    return np.asarray(turn.cosine * _cosine(turn) - turn.sine * _sine(turn))


@dataclass(frozen=True, slots=True)
class _Turn:
    """As ``turn_t`` of the C, with the coefficients of its type."""

    known: trigonometry.Coefficients
    left: Real
    rest: Real
    sine: Real
    cosine: Real


def _turn(angle: Real) -> _Turn:
    kind = angle.dtype.type
    known = _OF[angle.dtype]
    parts = [kind(part) for part in known.parts]
    ones, fours = kind(known.ones), kind(4.0 * known.ones)

    def nearest_multiple(value: Real, spaced: Any) -> Real:
        return np.asarray((value + spaced) - spaced)

    quarters = nearest_multiple(angle * kind(known.quarters_per_radian), ones)
    corner = quarters - nearest_multiple(quarters, fours)
    size = np.abs(corner)
    coarse = angle - quarters * parts[0]
    fine = quarters * parts[1]
    left = coarse - fine
    rest = ((coarse - left) - fine) - quarters * parts[2]
    return _Turn(known, left, rest, corner * (kind(2.0) - size), kind(1.0) - size)


def _sine(turn: _Turn) -> Real:
    square = turn.left * turn.left
    tail = _polynomial(turn.known.sine, square)
    return np.asarray(turn.left + (turn.left * square * tail + turn.rest))


def _cosine(turn: _Turn) -> Real:
    kind = turn.left.dtype.type
    one, half = kind(1.0), kind(0.5)
    square = turn.left * turn.left
    drop = half * square
    rough = one - drop
    tail = _polynomial(turn.known.cosine, square)
    lost = ((one - rough) - drop) - turn.left * turn.rest
    return np.asarray(rough + (lost + (square * square) * tail))


def _polynomial(coefficients: Sequence[float], square: Real) -> Real:
    """By pairs, as the C does."""
    numbers = [square.dtype.type(coefficient) for coefficient in coefficients]
    fourth = square * square
    pairs = [numbers[k : k + 2] for k in range(0, len(numbers), 2)]
    values = [pair[0] if len(pair) == 1 else pair[0] + pair[1] * square for pair in pairs]
    result = values.pop()
    for outer in reversed(values):
        result = outer + fourth * result
    return np.asarray(result)
