"""Golden vectors: a few inputs of every function, and the bits that come out.

The inputs are samples of the proof, rounded into the type and kept inside the declared ranges:
random ones, edges, and enough of both that every branch of a selection is taken and sines and
cosines reach every quarter turn that any of them does. The expected bits are those of
``evaluation``; each is also judged against the equation with fifty digits, so that what the
vectors repeat is right. Behind them stand inputs at which a guard inside a kernel fails, where
such are found.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from symnav import ir
from symnav.blocks import RotationBlock
from symnav.derive import Derivation
from symnav.errors import ProofError
from symnav.export.arithmetic import rounded
from symnav.export.arithmetic.branches import beside_turns, decided, decisions, quarters
from symnav.export.arithmetic.evaluation import (
    Outcome,
    Rows,
    declared,
    evaluate,
    kind_of,
    positions,
)
from symnav.export.arithmetic.slack import slack
from symnav.export.testing import singular
from symnav.lower.passes.walk import expressions, nodes
from symnav.spec.records import Spec
from symnav.verify.comparison import differences, forget_remainders
from symnav.verify.exact import DIGITS, Exact
from symnav.verify.sampling import Samples, draw
from symnav.verify.scale import ScaleOf
from symnav.verify.sheet import LIMITS, roundings, underflow

SEED = 1
#: Random and mixed samples to choose from; those of single edges come on top.
DRAWN = 16
#: Items in each sample of a mapped function.
ITEMS = 3
#: Samples kept, unless more are needed to take every branch.
KEPT = 8

#: Rotation vectors as long as declared ranges let them be, by one axis and by three.
FAR_TURNS = np.array([[5.9, 0.0, 0.0], [5.9, -5.9, 5.9]])

Indices = NDArray[np.intp]


@dataclass(frozen=True)
class Golden:
    """Golden vectors of one function.

    Attributes:
        function: the function.
        scalar: its type.
        items: rows of each sample; 1 where the function is not mapped.
        inputs: (samples, size) by argument, (samples * items, size) where per item.
        shared: (samples,): status of the call as far as it does not depend on items.
        status: (samples, items): of the item; zero where the function is not mapped.
        outputs: structural non-zeros by output name: (samples * items, count).
        slack: as ``outputs``: how far each may be off; None where no library function is called.
    """

    function: ir.Function
    scalar: ir.Scalar
    items: int
    inputs: Rows
    shared: NDArray[np.int64]
    status: NDArray[np.int64]
    outputs: Mapping[str, NDArray[Any]]
    slack: Mapping[str, NDArray[Any]] | None

    @property
    def samples(self) -> int:
        """Number of samples."""
        return len(self.shared)


def golden(spec: Spec, derivation: Derivation, function: ir.Function, scalar: ir.Scalar) -> Golden:
    """Choose and judge the golden vectors of a function.

    Raises:
        ProofError: when no sample is inside the domain, when a result is not finite although every
            guard passed, or when one is further from the equation than rounding explains.
    """
    drawn = _drawn(spec, derivation, function)
    items = drawn.items or 1
    rows = _typed(function, scalar, drawn)
    outcome = evaluate(function, scalar, rows)
    _refuse_infinite(function, outcome)
    whole = outcome.ok.reshape(-1, items).all(axis=1)
    good = np.flatnonzero(whole & _finite(outcome).reshape(-1, items).all(axis=1))
    if not good.size:
        raise ProofError(
            f"{function.name}: no sample inside the declared ranges can be evaluated in "
            f"{scalar.value}; change the ranges or the equation"
        )
    taken = decisions(function, scalar, outcome)
    turned = quarters(function, scalar, outcome)
    chosen = _chosen(drawn, good, items, [*taken, *turned])
    flat = (chosen[:, None] * items + np.arange(items)).ravel()
    beside = [
        sample
        for sample in beside_turns(function, scalar, rows, items, good, taken)
        if evaluate(function, scalar, sample).ok.all()
    ]
    picked = {
        name: np.concatenate([array[flat], *(sample[name] for sample in beside)])
        for name, array in rows.items()
    }
    _judge(spec, derivation, function, scalar, picked)
    failing = singular.failing(function, scalar, rows, items, outcome)
    everything = {
        name: np.concatenate([array, *(block[name] for block in failing)])
        for name, array in picked.items()
    }
    return _recorded(function, scalar, items, everything)


def _drawn(spec: Spec, derivation: Derivation, function: ir.Function) -> Samples:
    """Samples inside the declared ranges, with what chance hardly ever finds.

    In one of those of ``local`` both states are the same: two that are drawn on their own are not
    close enough for the series of small angles. In two of those of ``retract`` attitudes turn so
    far that half the angle is in the third and in the fourth quarter of sine and cosine.
    """
    drawn = draw(spec, derivation, DRAWN, SEED, ITEMS)
    if function.role is ir.Role.LOCAL:
        same = {**drawn.arguments, "y": drawn.arguments["y"].copy()}
        same["y"][-1] = same["x"][-1]
        drawn = replace(drawn, arguments=same)
    if function.role is ir.Role.RETRACT:
        turned = {**drawn.arguments, "d": drawn.arguments["d"].copy()}
        for place in spec.layout.places.values():
            if isinstance(place.block, RotationBlock):
                turned["d"][-2:, place.error] = FAR_TURNS
        drawn = replace(drawn, arguments=turned)
    return drawn


def _recorded(function: ir.Function, scalar: ir.Scalar, items: int, rows: Rows) -> Golden:
    outcome = evaluate(function, scalar, rows)
    shared, status = outcome.status[::items], outcome.item.reshape(-1, items)
    inputs = {
        argument.name: rows[argument.name] if argument.item else rows[argument.name][::items]
        for argument in function.arguments
    }
    every = (node for expression in expressions(function) for node in nodes(expression))
    called = {node.operation for node in every if isinstance(node, ir.Call)}
    allowed = slack(function, scalar, outcome) if called & rounded.LIBRARY else None
    return Golden(function, scalar, items, inputs, shared, status, outcome.outputs, allowed)


def _typed(function: ir.Function, scalar: ir.Scalar, drawn: Samples) -> dict[str, NDArray[Any]]:
    """One row per item, in the type and inside its ranges."""
    flat = drawn.flat()
    typed: dict[str, NDArray[Any]] = {}
    for argument in function.arguments:
        array = flat[argument.name]
        if argument.integer:
            typed[argument.name] = array.astype(np.int32)
            continue
        array = array.astype(kind_of(scalar))
        for domain in argument.domains:
            for place in range(domain.size):
                low, high = declared(domain.lower[place], domain.upper[place], scalar)
                column = array[:, domain.start + place]
                array[:, domain.start + place] = np.clip(column, low, high)
        typed[argument.name] = array
    return typed


def _finite(outcome: Outcome) -> NDArray[np.bool_]:
    found = np.ones(len(outcome.status), dtype=np.bool_)
    for array in outcome.outputs.values():
        found &= np.isfinite(array).all(axis=1)
    return found


def _refuse_infinite(function: ir.Function, outcome: Outcome) -> None:
    """Status OK promises finite results."""
    if function.checks_domain and not _finite(outcome)[outcome.ok].all():
        raise ProofError(
            f"{function.name}: a result is not finite although every guard passed; narrow the "
            "declared ranges or generate this function in double"
        )


def _chosen(
    drawn: Samples, good: Indices, items: int, taken: Sequence[NDArray[np.int64]]
) -> Indices:
    """Samples that take every branch any good sample takes, then others from all over."""
    wanted = {int(sample): decided(taken, int(sample), items) for sample in good}
    missing = set().union(*wanted.values())
    chosen: list[int] = []
    while missing:
        best = max(wanted, key=lambda sample: (len(wanted[sample] & missing), -sample))
        chosen.append(best)
        missing -= wanted[best]
    # The first sample is an ordinary one: faults are put into it one at a time.
    ordinary = [int(s) for s in good if drawn.labels[int(s) * items] == ""] or [int(good[0])]
    rest = [int(s) for s in good if s not in chosen and s != ordinary[0]]
    room = max(KEPT - len({*chosen, ordinary[0]}), 0)
    spread = rest[:: max(1, len(rest) // room)][:room] if room else []
    others = sorted({*chosen, *spread} - {ordinary[0]})
    return np.array([ordinary[0], *others], dtype=np.intp)


def _judge(
    spec: Spec, derivation: Derivation, function: ir.Function, scalar: ir.Scalar, rows: Rows
) -> None:
    """Compare every result with the undifferentiated equation and its differences."""
    exact = Exact(spec, derivation)
    outcome = evaluate(function, scalar, rows)
    wide = {name: array.astype(np.float64) for name, array in rows.items()}
    scales = ScaleOf(derivation).outputs(wide)
    results = {output.name: dense(output, outcome) for output in function.outputs}
    label = "float" if scalar is ir.Scalar.FLOAT else "native"
    with mp.workdps(DIGITS):
        for row in range(len(outcome.status)):
            numbers = {n: [mp.mpf(float(v)) for v in a[row]] for n, a in wide.items()}
            truth = exact.outputs(numbers)
            for name, got in results.items():
                plain = name in derivation.equation.outputs
                comparison = f"{label} vs {'50 digits' if plain else 'differences'}"
                error = differences(got[row].astype(np.float64), truth[name])
                if not plain:
                    forget_remainders(error, got[row])
                if derivation.entry is None:
                    error = _turned_back(spec, derivation, error)
                scale = scales[name].at(np.array([row], dtype=np.intp))
                limit = LIMITS[comparison]
                room = scale.limited(limit, roundings(comparison), underflow(comparison))
                _refuse_far(function, scalar, name, row, np.abs(error), limit * room.ravel())


def _turned_back(spec: Spec, derivation: Derivation, error: NDArray[Any]) -> NDArray[Any]:
    """Angles of the state are known up to whole turns: at a half turn rounding picks the sign."""
    turned = error.copy()
    for place in spec.layout.places.values():
        if place.block.kind in ("heading", "geodetic"):
            part = place.storage if derivation.name == "retract" else place.error
            whole = np.abs(error[part]) > np.pi
            back = np.remainder(error[part] + np.pi, 2.0 * np.pi) - np.pi
            turned[part] = np.where(whole, back, error[part])
    return turned


def _refuse_far(
    function: ir.Function,
    scalar: ir.Scalar,
    output: str,
    row: int,
    error: NDArray[Any],
    allowed: NDArray[Any],
) -> None:
    far = ~(error <= allowed)
    if far.any():
        k = int(np.argmax(far))
        smallest = np.finfo(kind_of(scalar)).smallest_normal
        raise ProofError(
            f"{function.name}: element {k} of {output} of golden row {row} is {error[k]:.3g} from "
            f"the equation evaluated with fifty digits; rounding explains {allowed[k]:.3g}. In "
            f"{scalar.value} numbers below {smallest:.1e} lose their digits, products of small "
            "inputs among them: declare ranges that stay clear of that, in larger units if need "
            "be, or export in double"
        )


def dense(output: ir.Output, outcome: Outcome) -> NDArray[Any]:
    """Structural non-zeros in full, by row: (rows, elements)."""
    found = outcome.outputs[output.name]
    full = np.zeros((len(found), int(np.prod(output.shape, dtype=np.int64))), dtype=found.dtype)
    for k, entry in enumerate(output.entries):
        place = np.zeros(len(found), dtype=np.int64)
        for index, length in zip(entry.index, output.shape, strict=True):
            place = place * length + positions(index, outcome.copies)
        full[np.arange(len(found)), place] = found[:, k]
    return full
