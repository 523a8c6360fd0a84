"""What kernels are called with and what they return, whatever evaluates them.

A kernel is straight-line code. Every argument is a sequence of its elements, each a number or an
array (an argument of one element without an axis of its own is that element). The kernel is called
with a namespace of functions, a :class:`Guards` and its arguments, and returns the structural
non-zeros of every output. That of a mapped function is called with the arguments that all items
share; it returns the outputs they share and a function of the items' arguments, which returns the
outputs of the items.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from ._explain import norm_defects
from ._runtime import Argument, Array, Kind, Signature, Status

Nonzeros = tuple[tuple[Any, ...], ...]
Mapped = tuple[Nonzeros, Callable[..., Nonzeros]]
Kernel = Callable[..., Any]


def run(
    signature: Signature, kernel: Kernel, xp: Any, guards: Any, elements: Mapping[str, Any]
) -> list[Sequence[Any]]:
    """The non-zeros of every output; elements of items and results of items are arrays."""
    shared = [elements[argument.name] for argument in signature.arguments if not argument.item]
    if not signature.mapped:
        return list(kernel(xp, guards, *shared))
    together, item = kernel(xp, guards, *shared)
    own = item(*(elements[argument.name] for argument in signature.arguments if argument.item))
    once, each = iter(together), iter(own)
    return [next(each if output.item else once) for output in signature.outputs]


class ComplexStep:
    """A namespace that continues real functions to first order in the imaginary part.

    Comparisons look at real parts, so that a step ``1e-100j`` on an argument gives a derivative
    without cancellation.
    """

    def __init__(self, xp: Any) -> None:
        self._xp = xp

    def __getattr__(self, name: str) -> Any:
        return getattr(self._xp, name)

    def real(self, value: Any) -> Any:
        """The real part of an array of any type."""
        dtype = getattr(value, "dtype", None)
        mixed = dtype is not None and is_complex(self._xp, dtype)
        return self._xp.real(value) if mixed else value

    def less(self, left: Any, right: Any) -> Any:
        """Compares real parts."""
        return self._xp.less(self.real(left), self.real(right))

    def less_equal(self, left: Any, right: Any) -> Any:
        """Compares real parts."""
        return self._xp.less_equal(self.real(left), self.real(right))

    def equal(self, left: Any, right: Any) -> Any:
        """Compares real parts."""
        return self._xp.equal(self.real(left), self.real(right))

    def not_equal(self, left: Any, right: Any) -> Any:
        """Compares real parts."""
        return self._xp.not_equal(self.real(left), self.real(right))

    def minimum(self, left: Any, right: Any) -> Any:
        """The operand whose real part is smaller."""
        return self._xp.where(self.less_equal(left, right), left, right)

    def maximum(self, left: Any, right: Any) -> Any:
        """The operand whose real part is larger."""
        return self._xp.where(self.less_equal(right, left), left, right)

    def abs(self, value: Any) -> Any:
        """The operand with a real part that is not negative; not the modulus."""
        return self._xp.where(self.less(value, 0.0), -value, value)

    def floor(self, value: Any) -> Any:
        """Constant between jumps, so that the imaginary part vanishes."""
        return self._xp.floor(self.real(value))

    def atan2(self, sine: Any, cosine: Any) -> Any:
        """The angle, and its differential in the imaginary part."""
        y, x = self.real(sine), self.real(cosine)
        turn = (x * (sine - y) - y * (cosine - x)) / (x * x + y * y)
        return self._xp.atan2(y, x) + turn


def is_complex(xp: Any, dtype: Any) -> bool:
    return bool(dtype.kind == "c" if xp is np else xp.isdtype(dtype, "complex floating"))


def is_float(xp: Any, dtype: Any) -> bool:
    kinds = ("real floating", "complex floating")
    return bool(dtype.kind in "fc" if xp is np else xp.isdtype(dtype, kinds))


class Guards:
    """Remembers which epochs and items fail a guard; the first failure of each counts."""

    def __init__(self, xp: Any, real: Any) -> None:
        self._xp = xp
        self.real = real
        self.shared = self.item = xp.zeros((), dtype=xp.uint8)

    def constant(self, value: float) -> Array:
        """A number as an array, where the standard asks for one."""
        return self._xp.asarray(value, dtype=self.real)

    def check(
        self, value: Array, lower: float, upper: float, substitute: float, status: Status
    ) -> Array:
        """A value of the whole call, or the substitute where it is out of range."""
        passed = self._inside(value, lower, upper)
        self.shared = self._note(self.shared, passed, status)
        return self._xp.where(passed, value, substitute)

    def check_item(
        self, value: Array, lower: float, upper: float, substitute: float, status: Status
    ) -> Array:
        """A value of each item, or the substitute where it is out of range."""
        passed = self._inside(value, lower, upper)
        self.item = self._note(self.item, passed, status)
        return self._xp.where(passed, value, substitute)

    def pick(self, array: Sequence[Array], base: int, index: Array, first: int, last: int) -> Array:
        """Element ``base + index`` of an array, for an index that depends on the item."""
        chosen = array[base + first]
        for number in range(first + 1, last + 1):
            chosen = self._xp.where(index == number, array[base + number], chosen)
        return chosen

    def load(self, given: Sequence[tuple[Argument, Array]]) -> None:
        """Guards the elements of arguments: the ranges of all of them first, then norms."""
        failures = [
            (argument, passed, status)
            for argument, array in given
            for passed, status in self._loaded(argument, array)
        ]
        for argument, passed, status in sorted(failures, key=lambda found: found[2]):
            if argument.item:
                self.item = self._note(self.item, passed, status)
            else:
                self.shared = self._note(self.shared, passed, status)

    def _loaded(self, argument: Argument, array: Array) -> list[tuple[Array, Status]]:
        xp = self._xp
        lower = [bound for domain in argument.domains for bound in domain.lower]
        upper = [bound for domain in argument.domains for bound in domain.upper]
        if argument.scalar:
            passed = (array >= lower[0]) & (array <= upper[0]) & xp.isfinite(array)
            return [(passed, Status.RANGE)]
        low, high = (xp.asarray(bounds, dtype=array.dtype) for bounds in (lower, upper))
        inside = (array >= low) & (array <= high) & xp.isfinite(array)
        unread = [d.kind is Kind.UNREAD for d in argument.domains for _ in range(d.size)]
        if any(unread):
            inside = inside | xp.asarray(unread)
        passed = xp.all(inside, axis=-1)
        failures = [(passed, Status.RANGE)]
        for domain in argument.domains:
            if domain.kind in (Kind.QUATERNION, Kind.MATRIX):
                elements = [array[..., domain.start + number] for number in range(domain.size)]
                for defect in norm_defects(domain.kind, elements):
                    failures.append((defect <= domain.tolerance, Status.QNORM))
        return failures

    def _inside(self, value: Array, lower: float, upper: float) -> Array:
        xp = self._xp
        above, below = xp.less_equal(lower, value), xp.less_equal(value, upper)
        return above & below & xp.isfinite(value)

    def _note(self, noted: Array, passed: Array, status: Status) -> Array:
        xp = self._xp
        return xp.where(passed | (noted != 0), noted, xp.asarray(int(status), dtype=xp.uint8))
