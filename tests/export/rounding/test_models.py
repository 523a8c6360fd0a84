"""Bounds of the shipped models: finite, never exceeded, tight where it matters."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from symnav import ir, pipeline
from symnav.export.rounding.bounds import bounds
from symnav.export.rounding.formats import FORMATS
from symnav.export.rounding.sampling import samples
from symnav.export.rounding.search import can_judge, errors, search
from symnav.spec.loading import loads
from tests.export.rounding.kernels import DOUBLE, FLOAT

MODELS = [name for name, _ in pipeline.shipped()]
SAMPLES = 4000


@cache
def functions(model: str, scalar: ir.Scalar) -> tuple[ir.Function, ...]:
    """The functions of a model that may be in a type, lowered as they are exported."""
    spec = pipeline.load(model)
    lowered = pipeline.c_route(spec, pipeline.derive(spec))
    wide = {entry.name for entry in spec.entries if entry.model.always_double}
    return tuple(f for f in lowered if scalar is DOUBLE or f.name not in wide)


def named(model: str, name: str, scalar: ir.Scalar = FLOAT) -> ir.Function:
    return next(f for f in functions(model, scalar) if f.name == name)


EVERY = [(model, scalar) for model in MODELS for scalar in ir.Scalar]


@pytest.mark.parametrize(("model", "scalar"), EVERY)
def test_every_output_has_a_bound_that_samples_keep(model: str, scalar: ir.Scalar) -> None:
    for function in functions(model, scalar):
        found = bounds(function, scalar)
        for output in function.outputs:
            assert len(found[output.name]) == len(output.entries)
            assert all(
                math.isfinite(r.bound) and 0.0 <= r.smooth <= r.bound for r in found[output.name]
            )
        if can_judge(scalar):
            points = samples(function, scalar, SAMPLES, np.random.default_rng(1))
            for name, worst in errors(function, scalar, points).items():
                limits = [r.bound for r in found[name]] or [0.0]
                # The judge itself is off by a thousandth of the bound of its narrower type.
                assert np.all(worst.max(axis=0) <= np.array(limits) * 1.001), (function.name, name)


def test_the_position_of_the_rover_is_within_three_times_what_a_search_finds() -> None:
    gps = named("rover", "gps")
    bound = max(r.bound for r in bounds(gps, FLOAT)["value"])
    worst = search(gps, FLOAT, "value", budget=1 << 16, seed=1)
    assert worst.evaluations == 1 << 16
    assert worst.error <= bound <= 3.0 * worst.error
    assert bound < 0.004


def test_a_search_is_the_same_every_time() -> None:
    gps = named("rover", "gps")
    first, second = (search(gps, FLOAT, "jacobian", budget=6000, seed=3) for _ in range(2))
    assert first == second and first.evaluations <= 6000
    again = {name: np.array([values]) for name, values in first.arguments.items()}
    assert errors(gps, FLOAT, again)["jacobian"][0, first.entry] == first.error
    assert search(gps, FLOAT, "jacobian", budget=40000, seed=3).error >= first.error


@pytest.mark.parametrize(
    ("weakened", "what"),
    [
        (replace(FORMATS[FLOAT], bits=25), "the unit roundoff is half of what it is"),
        (replace(FORMATS[FLOAT], bits=26), "the unit roundoff is a quarter of what it is"),
    ],
    ids=["half", "quarter"],
)
def test_samples_see_a_model_that_is_too_good(weakened: object, what: str) -> None:
    """The comparison above has teeth: with less rounding than there is, it fails."""
    gps = named("rover", "gps")
    assert isinstance(weakened, type(FORMATS[FLOAT]))
    limit = max(r.bound for r in bounds(gps, FLOAT, weakened)["value"])
    assert search(gps, FLOAT, "value", budget=1 << 14, seed=1).error > limit, what


def test_attitudes_keep_their_precision_across_the_switches() -> None:
    """Series and closed forms of exponential and logarithm: no gap where they meet."""
    for name, limit in (("retract", 1e-5), ("local", 2e-5)):
        function = named("rover", name)
        value = bounds(function, FLOAT)["value"]
        rows = next(r for r in function.outputs[0].rows if r.name == "attitude")
        elements = value[rows.start : rows.start + rows.size]
        assert all(r.smooth < limit for r in elements)
    # Half a turn one way is half a turn the other way: there, and only there, a whole turn apart.
    assert all(6.28 < r.bound < 6.29 for r in elements)


def test_declared_ranges_decide() -> None:
    """The relative form in single precision: kilometres or decimetres, as the ranges say."""
    near = bounds(named("reference_relative", "range"), FLOAT)
    assert max(near[name][0].bound for name in ("value", "residual")) < 0.25
    assert max(entry.bound for entry in near["jacobian"]) < 2.0
    text = (pipeline._models() / "reference_relative.toml").read_text(encoding="utf-8")
    undeclared = re.sub(r"\[\[input\]\]\n(\w.*\n)+\n", "", text)
    assert undeclared.count("[[input]]") == 0 < text.count("[[input]]")
    spec = loads(undeclared)
    (function,) = (f for f in pipeline.c_route(spec, pipeline.derive(spec)) if f.name == "range")
    assert bounds(function, FLOAT)["value"][0].bound > 1e5
