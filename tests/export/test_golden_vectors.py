"""Golden vectors: right and not merely repeatable, in every branch, exact in the text of the C."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from symnav import ir, pipeline
from symnav.emit.c import sections
from symnav.errors import ProofError
from symnav.export.arithmetic.branches import decided, decisions, quarters
from symnav.export.arithmetic.evaluation import bounds, evaluate
from symnav.export.testing import program
from symnav.export.testing.golden import ITEMS, Golden, golden
from symnav.export.testing.tables import Tables, hexadecimal, short
from symnav.export.testing.turns import turns
from symnav.spec.loading import loads

DOUBLE, FLOAT = ir.Scalar.DOUBLE, ir.Scalar.FLOAT


def made(model: str, name: str, scalar: ir.Scalar) -> tuple[Golden, ir.Function]:
    spec = pipeline.load(model)
    derived = pipeline.derive(spec)
    (function,) = [f for f in pipeline.c_route(spec, derived) if f.name == name]
    (derivation,) = [d for d in (*derived.layout, *derived.entries) if d.name == name]
    return golden(spec, derivation, function, scalar), function


def test_a_wrong_sign_is_no_golden_vector() -> None:
    spec = pipeline.load("rover")
    derived = pipeline.derive(spec)
    functions = {f.name: f for f in pipeline.c_route(spec, derived)}
    gps = functions["gps"]
    value, jacobian = gps.outputs
    entry = jacobian.entries[1]
    turned = replace(entry, value=ir.Call(ir.Operation.NEG, (entry.value,)))
    entries = (jacobian.entries[0], turned, *jacobian.entries[2:])
    wrong = replace(gps, outputs=(value, replace(jacobian, entries=entries)))
    (derivation,) = [d for d in derived.entries if d.name == "gps"]
    for scalar in ir.Scalar:
        golden(spec, derivation, gps, scalar)
        with pytest.raises(ProofError, match=r"gps: element \d+ of jacobian .* fifty digits"):
            golden(spec, derivation, wrong, scalar)


SMALL = """
name = "small"
[[state]]
name = "p"
kind = "vector"
size = 3
unit = "m"
range = [1e-30, 2e-30]
[[measurement]]
name = "product"
equation = ["{equation}"]
"""


def of_small_numbers(equation: str, scalar: ir.Scalar) -> Golden:
    spec = loads(SMALL.format(equation=equation))
    derived = pipeline.derive(spec)
    (function,) = [f for f in pipeline.c_route(spec, derived) if f.name == "product"]
    return golden(spec, derived.entries[0], function, scalar)


def test_results_below_the_smallest_number_are_zero() -> None:
    """Which is right to the last place a float has there; in double they are numbers."""
    assert not of_small_numbers("dot(p, p)", FLOAT).outputs["value"].any()
    assert of_small_numbers("dot(p, p)", DOUBLE).outputs["value"].all()


def test_digits_lost_below_the_smallest_number_are_refused() -> None:
    """Where a product is lost that the result is made of, with words that say why."""
    said = r"^product: element 0 of value .* In float numbers below 1.2e-38 lose their digits"
    with pytest.raises(ProofError, match=said):
        of_small_numbers("dot(p, p) * 1e30", FLOAT)
    assert of_small_numbers("dot(p, p) * 1e30", DOUBLE).outputs["value"].all()


def test_every_branch_is_taken_and_turns_are_close() -> None:
    found, function = made("rover", "retract", FLOAT)
    outcome = evaluate(function, FLOAT, found.inputs)
    taken = decisions(function, FLOAT, outcome)
    both = set().union(*(decided(taken, k, 1) for k in range(found.samples)))
    assert both == {(k, code) for k in range(len(taken)) for code in (0, 1)}
    angle = np.linalg.norm(found.inputs["d"][:, 6:9].astype(np.float64), axis=1)
    assert ((angle > 0.05) & (angle < 0.1)).any() and ((angle > 0.1) & (angle < 0.2)).any()


@pytest.mark.parametrize("scalar", list(ir.Scalar))
@pytest.mark.parametrize(
    ("model", "name", "reached"),
    [("farrell_tightly_coupled", "retract", {0, 1, 2, 3}),
     ("ekf_cal_online", "gps_1", {0, 1, 2, 4, 6, 7})],
)  # fmt: skip
def test_sine_and_cosine_reach_every_quarter(
    model: str, name: str, reached: set[int], scalar: ir.Scalar
) -> None:
    """Each has a polynomial of its own: half a turn may be 5.2 rad, a heading from -pi to pi."""
    found, function = made(model, name, scalar)
    (codes,) = quarters(function, scalar, evaluate(function, scalar, found.inputs))
    assert set(codes.tolist()) == reached


def test_an_antenna_at_its_satellite_is_found() -> None:
    found, _ = made("farrell_tightly_coupled", "pseudorange_lever_arm", DOUBLE)
    assert found.status.shape == (found.samples, ITEMS)
    assert not found.status[:-1].any()
    assert found.status[-1].tolist() == [int(ir.Status.DOMAIN), 0, 0]


@pytest.mark.parametrize("scalar", list(ir.Scalar))
def test_inputs_are_inside_the_declared_ranges(scalar: ir.Scalar) -> None:
    found, function = made("ekf_cal_online", "gps_1", scalar)
    for argument in function.arguments:
        for domain in argument.domains:
            for k, (low, high) in enumerate(zip(domain.lower, domain.upper, strict=True)):
                column = found.inputs[argument.name][:, domain.start + k]
                lower, upper = bounds(low, high, scalar)
                assert ((column >= lower) & (column <= upper)).all()
    assert found.status.tolist() == [[0]] * found.samples


def test_turns_touch_the_tolerance() -> None:
    _, function = made("farrell_tightly_coupled", "pseudorange_lever_arm", DOUBLE)
    kinds = {d.kind: d for a in function.arguments for d in a.domains}
    for kind in (ir.Kind.QUATERNION, ir.Kind.MATRIX):
        for scalar in ir.Scalar:
            found = turns(kinds[kind], scalar)
            assert sum(turn.accepted for turn in found) == 2
            good = [np.array(turn.elements) for turn in found if turn.accepted]
            bad = [np.array(turn.elements) for turn in found if not turn.accepted]
            steps = [min(float(np.abs(g - b).max()) for b in bad) for g in good]
            assert max(steps) < 1e-6


@pytest.mark.parametrize("scalar", list(ir.Scalar))
def test_literals_are_exact(scalar: ir.Scalar) -> None:
    kind = np.float64 if scalar is DOUBLE else np.float32
    values = (1e3 * np.random.default_rng(7).normal(size=200)).astype(kind)
    for value in (*values, kind(0.0), kind(-0.0), kind(1.0), np.finfo(kind).smallest_subnormal):
        text = hexadecimal(value, scalar)
        assert text.endswith("F") is (scalar is FLOAT)
        back = float.fromhex(text.removesuffix("F"))
        assert back == float(value) and np.signbit(back) == np.signbit(value)


def test_bounds_of_slack_are_rounded_up() -> None:
    for value in np.random.default_rng(8).uniform(0.0, 1e-3, 300):
        assert value <= short(value) <= 1.02 * value
    assert short(0.0) == 0.0


def test_equal_tables_are_one() -> None:
    tables = Tables("t", "real_t", DOUBLE)
    first = tables.reals("a", [1.0, 2.0], "")
    assert tables.reals("b", [1.0, 2.0], "") == first == "t_a"
    assert tables.reals("a", [1.0, 3.0], "") == "t_a_2"
    assert tables.reals("c", [], "") == "NULL"


def test_an_unknown_entry_point_is_not_left_untested(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def more(module: ir.Module) -> tuple[object, ...]:
        first, *others = sections(module)
        entry = replace(first.entries[0], symbol=f"{first.kernel.symbol}_sideways")
        return (replace(first, entries=[*first.entries, entry]), *others)

    monkeypatch.setattr(program, "sections", more)
    with pytest.raises(AssertionError, match="warpos_gps_retract_sideways"):
        pipeline.export(pipeline.load("warpos_gps"), tmp_path)
