"""Why a call for one epoch failed: looks at its arguments again and says so in words."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ._runtime import Argument, Array, Domain, GuardError, Kind, Signature, Status

_Find = Callable[[str, Argument, Domain, tuple[int, ...], Sequence[float]], GuardError | None]

#: Most roundings, of numbers about one, in the defect of a norm.
_ROUNDINGS = 8.0


def explain(signature: Signature, status: Status, arrays: Sequence[Array]) -> GuardError:
    """Looks at the arguments of one epoch again and names what failed."""
    find: _Find = _outside if status is Status.RANGE else _distorted
    found = _first(find, signature, status, arrays)
    if found is None and status is Status.QNORM:
        # Close to the tolerance the rounding of compiled code, in its own precision, decides.
        rounding = max(float(np.finfo(a.dtype).eps) for a in arrays if a.dtype.kind in "fc")
        find = partial(_distorted, slack=_ROUNDINGS * rounding)
        found = _first(find, signature, status, arrays)
    found = found or _violated(signature, status, arrays)
    if found is not None:
        return found
    meanings = "; ".join(
        f"{condition.meaning} must lie in [{condition.lower:g}, {condition.upper:g}]"
        for condition in signature.conditions
        if condition.status is status
    )
    return GuardError(status, f"{signature.name}: {status.name}: {meanings or 'refused'}")


def _first(
    find: _Find, signature: Signature, status: Status, arrays: Sequence[Array]
) -> GuardError | None:
    """The first domain of an argument that fails with this status."""
    for argument, array in zip(signature.arguments, arrays, strict=True):
        rows = np.reshape(np.real(array), (-1, argument.size))
        for number, row in enumerate(rows):
            item = (number,) if argument.item else ()
            for domain in argument.domains:
                if domain.kind is Kind.UNREAD:
                    continue
                elements = row[domain.start : domain.start + domain.size].tolist()
                error = find(signature.name, argument, domain, item, elements)
                if error is not None and error.status is status:
                    return error
    return None


class _Failure(NamedTuple):
    """A check of an intermediate value that failed: the first item, or empty where all share it."""

    status: Status
    item: tuple[int, ...]
    value: float
    bounds: tuple[float, float]


class _Trace:
    """Guards of one epoch that remember every intermediate value that failed."""

    def __init__(self, guards: Any) -> None:
        self._guards = guards
        self.failures: list[_Failure] = []

    def __getattr__(self, name: str) -> Any:
        return getattr(self._guards, name)

    def check(self, value: Array, *limits: Any) -> Array:
        """Of a value that all items share."""
        self._watch(value, *limits, item=False)
        return self._guards.check(value, *limits)

    def check_item(self, value: Array, *limits: Any) -> Array:
        """Of a value of each item."""
        self._watch(value, *limits, item=True)
        return self._guards.check_item(value, *limits)

    def _watch(
        self,
        value: Array,
        lower: float,
        upper: float,
        _substitute: float,
        status: Status,
        *,
        item: bool,
    ) -> None:
        flat = np.reshape(np.real(value), -1)
        failed = np.flatnonzero(~((lower <= flat) & (flat <= upper)))
        if failed.size:
            first = int(failed[0])
            place = (first,) if item else ()
            self.failures.append(_Failure(status, place, float(flat[first]), (lower, upper)))


def _violated(signature: Signature, status: Status, arrays: Sequence[Array]) -> GuardError | None:
    """The first intermediate value outside its domain, found by NumPy whatever failed."""
    from . import numpy  # it imports this module
    from ._arrays import ArrayFunction

    kernel = vars(numpy).get(f"_{signature.name}_kernel")
    if kernel is None:
        return None
    function = ArrayFunction(signature, kernel)
    guards, wide = function.guard(np, [np.real(array) for array in arrays])
    trace = _Trace(guards)
    with np.errstate(all="ignore"):
        function.run(np, trace, wide)
    for failure in trace.failures:
        if failure.status is not status:
            continue
        lower, upper = failure.bounds
        # Back ends check in an order of their own; only the limits tell conditions apart.
        meanings = dict.fromkeys(
            condition.meaning
            for condition in signature.conditions
            if (condition.status, condition.lower, condition.upper) == (status, lower, upper)
        )
        where = "".join(f" of item [{number}]" for number in failure.item)
        return GuardError(
            status,
            f"{signature.name}: {status.name}: {' or '.join(meanings)}{where} must lie in "
            f"[{lower:g}, {upper:g}]; it is {failure.value:g}",
            index=failure.item,
            value=failure.value,
            bounds=failure.bounds,
        )
    return None


def _outside(
    function: str,
    argument: Argument,
    domain: Domain,
    item: tuple[int, ...],
    elements: Sequence[float],
) -> GuardError | None:
    """The first element of a domain that is not in its range, if any."""
    unit = "" if domain.unit in ("", "1") else f" {domain.unit}"
    for offset, value in enumerate(elements):
        lower, upper = domain.lower[offset], domain.upper[offset]
        if math.isfinite(value) and lower <= value <= upper:
            continue
        index = item if argument.scalar else (*item, domain.start + offset)
        place = argument.name + "".join(f"[{number}]" for number in index)
        words = [domain.name] if domain.name != argument.name else []
        words += [domain.labels[offset]] if domain.size > 1 else []
        meaning = f" ({' '.join(words)})" if words else ""
        return GuardError(
            Status.RANGE,
            f"{function}: RANGE: {place}{meaning} = {value!r} is outside the declared range "
            f"[{lower:g}, {upper:g}]{unit}",
            argument.name,
            index,
            value,
            (lower, upper),
        )
    return None


def _distorted(
    function: str,
    argument: Argument,
    domain: Domain,
    item: tuple[int, ...],
    elements: Sequence[float],
    slack: float = 0.0,
) -> GuardError | None:
    """The defect of a quaternion or matrix that is not normalised, if any."""
    defects = norm_defects(domain.kind, elements)
    if all(defect <= domain.tolerance - slack for defect in defects):
        return None
    rule = "a unit quaternion" if domain.kind is Kind.QUATERNION else "a rotation matrix"
    span = f"[{domain.start}:{domain.start + domain.size}]"
    place = argument.name + "".join(f"[{number}]" for number in item) + span
    meaning = f" ({domain.name})" if domain.name != argument.name else ""
    return GuardError(
        Status.QNORM,
        f"{function}: QNORM: {place}{meaning} is not {rule}: off by {max(defects):.3g}, the "
        f"tolerance is {domain.tolerance:g}",
        argument.name,
        (*item, domain.start),
        max(defects),
        (0.0, domain.tolerance),
    )


def norm_defects(kind: Kind, elements: Sequence[Any]) -> list[Any]:
    """How far a quaternion is from unit norm, or a row-major matrix from a rotation.

    Of a rotation matrix the first two columns are orthonormal and the third is their cross product.
    The elements are numbers or arrays, and so are the defects: one for a quaternion, six for a
    matrix, none for anything else.
    """
    if kind is Kind.QUATERNION:
        w, x, y, z = elements
        return [abs(w * w + x * x + y * y + z * z - 1.0)]
    if kind is not Kind.MATRIX:
        return []
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (elements[number::3] for number in range(3))
    return [
        abs(ax * ax + ay * ay + az * az - 1.0),
        abs(bx * bx + by * by + bz * bz - 1.0),
        abs(ax * bx + ay * by + az * bz),
        abs(ay * bz - az * by - cx),
        abs(az * bx - ax * bz - cy),
        abs(ax * by - ay * bx - cz),
    ]
