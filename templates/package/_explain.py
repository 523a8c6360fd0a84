"""Why a call for one epoch failed: looks at its arguments again and says so in words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from ._runtime import Argument, Array, Domain, GuardError, Kind, Signature, Status


def explain(signature: Signature, status: Status, arrays: Sequence[Array]) -> GuardError:
    """Looks at the arguments of one epoch again and names what failed."""
    for argument, array in zip(signature.arguments, arrays, strict=True):
        rows = np.reshape(np.real(array), (-1, argument.size))
        for number, row in enumerate(rows):
            item = (number,) if argument.item else ()
            for domain in argument.domains:
                if domain.kind is Kind.UNREAD:
                    continue
                elements = row[domain.start : domain.start + domain.size].tolist()
                find = _outside if status is Status.RANGE else _distorted
                error = find(signature.name, argument, domain, item, elements)
                if error is not None and error.status is status:
                    return error
    meanings = "; ".join(
        f"{condition.meaning} must lie in [{condition.lower:g}, {condition.upper:g}]"
        for condition in signature.conditions
        if condition.status is status
    )
    return GuardError(status, f"{signature.name}: {status.name}: {meanings or 'refused'}")


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
) -> GuardError | None:
    """The defect of a quaternion or matrix that is not normalised, if any."""
    defects = norm_defects(domain.kind, elements)
    if all(defect <= domain.tolerance for defect in defects):
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
