"""Two number systems for witnesses: many digits, and doubles that carry a gradient."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import sympy as sp
from mpmath import mp
from numpy.typing import NDArray

Array = NDArray[np.float64]


class ManyDigits:
    """mpmath numbers at the precision the caller set.

    A float literal of an equation stands for the double it will be in C.
    """

    functions: ClassVar[Mapping[Any, Callable[..., Any]]] = {
        sp.sqrt: mp.sqrt,
        sp.sin: mp.sin,
        sp.cos: mp.cos,
        sp.tan: mp.tan,
        sp.asin: mp.asin,
        sp.acos: mp.acos,
        sp.atan: mp.atan,
        sp.atan2: mp.atan2,
        sp.exp: mp.exp,
        sp.log: mp.log,
        sp.Abs: abs,
        sp.floor: mp.floor,
        sp.Min: min,
        sp.Max: max,
        sp.And: lambda *a: all(a),
        sp.Or: lambda *a: any(a),
        sp.Not: lambda a: not a,
    }

    def number(self, value: sp.Expr) -> Any:
        """A rational exactly, a float as its double."""
        if isinstance(value, sp.Rational):
            return mp.mpf(int(value.p)) / int(value.q)
        return mp.mpf(float(value))

    def select(self, condition: Any, yes: Callable[[], Any], no: Callable[[], Any]) -> Any:
        """Only the branch that holds is evaluated."""
        return yes() if condition else no()


@dataclass(frozen=True, eq=False)
class Graded:
    """A batch of doubles, the gradient of each by every input, and what it was added up from.

    Attributes:
        value: (S,).
        slope: (S, n).
        size: (S,): the value with every sum taken over absolute values. A sum of large terms that
            cancel is known to the rounding of its size, not of its value.
    """

    value: Array
    slope: Array
    size: Array

    def __add__(self, other: Graded | float) -> Graded:
        o = _graded(other, self)
        return Graded(self.value + o.value, self.slope + o.slope, self.size + o.size)

    __radd__ = __add__

    def __mul__(self, other: Graded | float) -> Graded:
        o = _graded(other, self)
        slope = self.slope * o.value[:, None] + o.slope * self.value[:, None]
        return Graded(self.value * o.value, slope, self.size * o.size)

    __rmul__ = __mul__

    def __rtruediv__(self, other: float) -> Graded:
        inverse = 1.0 / self.value
        return self.chain(other * inverse, -other * inverse * inverse)

    def __pow__(self, power: int) -> Graded:
        return self.chain(self.value**power, power * self.value ** (power - 1))

    def __lt__(self, other: Graded | float) -> Any:
        return self.value < _value(other)

    def __le__(self, other: Graded | float) -> Any:
        return self.value <= _value(other)

    def __gt__(self, other: Graded | float) -> Any:
        return self.value > _value(other)

    def __ge__(self, other: Graded | float) -> Any:
        return self.value >= _value(other)

    def __eq__(self, other: object) -> Any:
        return np.equal(self.value, _value(other))

    def __ne__(self, other: object) -> Any:
        return np.not_equal(self.value, _value(other))

    __hash__ = None  # type: ignore[assignment]  # compared by value, element by element

    def chain(self, value: Array, derivative: Array) -> Graded:
        """A function of this number, by its value and derivative."""
        size = np.maximum(np.abs(value), np.abs(derivative) * self.size)
        return Graded(value, self.slope * derivative[:, None], size)


class Gradients:
    """Doubles with gradients over a batch of samples."""

    functions: ClassVar[Mapping[Any, Callable[..., Any]]] = {
        sp.sqrt: lambda a: a.chain(np.sqrt(a.value), 0.5 / np.sqrt(a.value)),
        sp.sin: lambda a: a.chain(np.sin(a.value), np.cos(a.value)),
        sp.cos: lambda a: a.chain(np.cos(a.value), -np.sin(a.value)),
        sp.tan: lambda a: a.chain(np.tan(a.value), 1.0 / np.cos(a.value) ** 2),
        sp.asin: lambda a: a.chain(np.arcsin(a.value), 1.0 / np.sqrt(1.0 - a.value**2)),
        sp.acos: lambda a: a.chain(np.arccos(a.value), -1.0 / np.sqrt(1.0 - a.value**2)),
        sp.atan: lambda a: a.chain(np.arctan(a.value), 1.0 / (1.0 + a.value**2)),
        sp.atan2: lambda y, x: _atan2(y, x),
        sp.exp: lambda a: a.chain(np.exp(a.value), np.exp(a.value)),
        sp.log: lambda a: a.chain(np.log(a.value), 1.0 / a.value),
        sp.Abs: lambda a: a.chain(np.abs(a.value), np.sign(a.value)),
        sp.floor: lambda a: a.chain(np.floor(a.value), np.zeros_like(a.value)),
        sp.And: lambda *a: np.logical_and.reduce(a),
        sp.Or: lambda *a: np.logical_or.reduce(a),
        sp.Not: np.logical_not,
    }

    def number(self, value: sp.Expr) -> Any:
        """A plain float."""
        return float(value)

    def select(self, condition: Any, yes: Callable[[], Any], no: Callable[[], Any]) -> Any:
        """Both branches are evaluated; each sample keeps its own."""
        a, b = yes(), no()
        like = a if isinstance(a, Graded) else b
        if not isinstance(like, Graded):
            condition = np.asarray(condition)
            value = np.where(condition, a, b)
            return Graded(value, np.zeros((condition.size, 1)), np.abs(value))
        first, second = _graded(a, like), _graded(b, like)
        return Graded(
            np.where(condition, first.value, second.value),
            np.where(np.asarray(condition)[:, None], first.slope, second.slope),
            np.where(condition, first.size, second.size),
        )


def _atan2(y: Graded, x: Graded) -> Graded:
    square = (x.value**2 + y.value**2)[:, None]
    slope = (x.value[:, None] * y.slope - y.value[:, None] * x.slope) / square
    value = np.arctan2(y.value, x.value)
    turned = (np.abs(x.value) * y.size + np.abs(y.value) * x.size) / square[:, 0]
    return Graded(value, slope, np.maximum(np.abs(value), turned))


def _graded(number: Graded | float, like: Graded) -> Graded:
    if isinstance(number, Graded):
        return number
    value = np.full_like(like.value, number)
    return Graded(value, np.zeros_like(like.slope), np.abs(value))


def _value(number: object) -> Any:
    return number.value if isinstance(number, Graded) else number
