"""IEEE 754 evaluation: correct rounding, guards in the type's rounding, slack of libraries."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp

from symnav import ir, pipeline
from symnav.export.arithmetic.evaluation import bounds, declared, evaluate
from symnav.export.arithmetic.rounded import library, nearest
from symnav.export.arithmetic.slack import slack

Operation = ir.Operation
DOUBLE, FLOAT = ir.Scalar.DOUBLE, ir.Scalar.FLOAT


def functions(model: str) -> dict[str, ir.Function]:
    spec = pipeline.load(model)
    return {f.name: f for f in pipeline.c_route(spec, pipeline.derive(spec))}


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_nearest_is_what_the_type_rounds_to(kind: type[np.floating]) -> None:
    rng = np.random.default_rng(3)
    for value in (10.0 ** rng.uniform(-320, 300, 400)) * rng.choice([-1.0, 1.0], 400):
        exact = Fraction(float(value))
        with np.errstate(all="ignore"):
            assert nearest(exact, np.dtype(kind)) == float(kind(value))


def test_nearest_rounds_once_and_ties_to_even() -> None:
    single = np.dtype(np.float32)
    tie = Fraction(1) + Fraction(1, 2**24)
    assert nearest(tie, single) == 1.0
    # Rounded to double first, this would become the tie and then fall the other way.
    assert nearest(tie + Fraction(1, 2**60), single) == 1.0 + 2.0**-23
    assert nearest(Fraction(1) + Fraction(3, 2**24), single) == 1.0 + 2.0**-22
    assert nearest(-(Fraction(2) ** 128), single) == -math.inf


@pytest.mark.parametrize("operation", [Operation.SIN, Operation.COS, Operation.ATAN, Operation.EXP])
@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_library_is_nearest_to_the_truth(operation: Operation, kind: type[np.floating]) -> None:
    x = np.random.default_rng(5).uniform(-6.0, 6.0, 40).astype(kind)
    got = library(operation, [x])
    assert got.dtype == kind
    with mp.workdps(60):
        for value, result in zip(x, got, strict=True):
            truth = getattr(mp, operation.value)(mp.mpf(float(value)))
            ends = (np.nextafter(result, -np.inf), np.nextafter(result, np.inf))
            error = abs(truth - mp.mpf(float(result)))
            assert all(error <= abs(truth - mp.mpf(float(end))) for end in ends)


def test_library_at_special_places() -> None:
    def of(operation: Operation, *x: float) -> float:
        return float(library(operation, [np.array([v]) for v in x])[0])

    assert math.copysign(1.0, of(Operation.SIN, -0.0)) == -1.0
    assert of(Operation.COS, 0.0) == 1.0
    assert of(Operation.ATAN2, -0.0, -1.0) == -math.pi
    assert of(Operation.ATAN2, 0.0, -2.0) == math.pi
    assert math.copysign(1.0, of(Operation.ATAN2, -0.0, 3.0)) == -1.0
    assert of(Operation.ATAN2, 1.0, 0.0) == math.pi / 2
    assert of(Operation.ATAN2, -1e-320, 1.0) == math.atan2(-1e-320, 1.0)
    for operation, x in ((Operation.ACOS, 1.5), (Operation.LOG, -1.0), (Operation.SIN, math.inf)):
        assert math.isnan(of(operation, x))
    assert of(Operation.LOG, 0.0) == -math.inf and math.isnan(of(Operation.SIN, math.nan))


def test_declared_ends_are_those_of_the_type() -> None:
    low, high = declared(-0.1, 0.05, FLOAT)
    assert low.dtype == high.dtype == np.float32
    assert float(low) == float(np.float32(-0.1)) and float(high) == float(np.float32(0.05))


def test_bounds_are_inside_the_declared_range() -> None:
    low, high = bounds(-0.1, 0.1, FLOAT)
    assert low.dtype == np.float32 and float(low) >= -0.1 and float(high) <= 0.1
    assert float(np.nextafter(high, np.float32(1.0))) > 0.1


def states(function: ir.Function, kind: type[np.floating], count: int) -> dict[str, np.ndarray]:
    rows = {a.name: np.zeros((count, a.size), dtype=kind) for a in function.arguments}
    rows["x"][:, 6] = 1.0
    return rows


@pytest.mark.parametrize(("scalar", "kind"), [(DOUBLE, np.float64), (FLOAT, np.float32)])
def test_guards_of_inputs(scalar: ir.Scalar, kind: type[np.floating]) -> None:
    function = functions("rover")["gps"]
    rows = states(function, kind, 9)
    high = bounds(-10.0, 10.0, scalar)[1]
    rows["x"][1, 16] = high
    rows["x"][2, 16] = np.nextafter(high, kind(np.inf))
    rows["x"][3, 0] = np.nan
    rows["x"][4, 0] = -np.inf
    rows["x"][5, 6] = 0.0  # a quaternion of norm zero
    rows["x"][6, 6:10] = (0.0, 0.6, 0.0, 0.8)
    rows["x"][7, 3] = np.nan  # the velocity is not read
    rows["x"][8, (0, 6)] = (np.nan, 0.0)  # the range is told before the norm
    outcome = evaluate(function, scalar, rows)
    assert outcome.status.tolist() == [0, 0, 2, 2, 2, 4, 0, 0, 2]
    assert all(np.isfinite(a).all() and a.dtype == kind for a in outcome.outputs.values())
    unguarded = evaluate(replace(function, guards=ir.Guards.ASSUME), scalar, rows)
    assert not unguarded.status.any()
    assert np.isnan(unguarded.outputs["value"][3, 0])


def test_guards_of_matrices_and_of_geometry() -> None:
    function = functions("farrell_tightly_coupled")["pseudorange"]
    rows = {a.name: np.zeros((4, a.size)) for a in function.arguments}
    rows["c_n_e"][:] = np.eye(3).ravel()
    rows["satellite_position"][:] = (2e7, 0.0, 0.0)
    rows["c_n_e"][1, 8] = -1.0  # a reflection
    rows["satellite_position"][2] = 0.0  # the antenna is at its satellite
    rows["measured"][3] = np.inf
    outcome = evaluate(function, DOUBLE, rows)
    assert outcome.status.tolist() == [0, 4, 0, 0]
    assert outcome.item.tolist() == [0, 0, 3, 2]
    assert outcome.ok.tolist() == [True, False, False, False]


def test_slack_is_none_where_no_library_is_called() -> None:
    found = functions("rover")
    plain = states(found["gps"], np.float64, 2)
    allowed = slack(found["gps"], DOUBLE, evaluate(found["gps"], DOUBLE, plain))
    assert not any(array.any() for array in allowed.values())
    # The sine of a half angle is the C's own, the arc tangent is the library's.
    turning = states(found["retract"], np.float64, 2)
    turning["d"][:, 6:9] = (0.5, -0.4, 0.3)
    turned = evaluate(found["retract"], DOUBLE, turning)
    assert not slack(found["retract"], DOUBLE, turned)["value"].any()
    apart = states(found["local"], np.float64, 2)
    apart["y"][:, 6:10] = (0.5, 0.5, -0.5, 0.5)
    outcome = evaluate(found["local"], DOUBLE, apart)
    moved = slack(found["local"], DOUBLE, outcome)["value"]
    names = [entry.index[0] for entry in found["local"].outputs[0].entries]
    attitude = [names.index(k) for k in range(6, 9)]
    assert (moved[:, attitude] > 2.0**-53).all() and (moved[:, attitude] < 64 * 2.0**-52).all()
    assert not np.delete(moved, attitude, axis=1).any()
