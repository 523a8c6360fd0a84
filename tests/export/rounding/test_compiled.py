"""The compiled C of real bundles never errs by more than its bounds say."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from symnav import ir, pipeline
from symnav.export.rounding.bounds import bounds
from symnav.export.rounding.sampling import samples
from symnav.export.rounding.search import WIDER, can_judge, values
from tests.export.rounding.compiled import FLAGS, ITEMS, Compiled, compile_sources, shared_by_items
from tests.export.rounding.kernels import DOUBLE, FLOAT
from tests.export.rounding.test_models import MODELS, functions

pytestmark = pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")

CASES = [(model, scalar) for model in MODELS for scalar in ir.Scalar]
QUICK = [("rover", FLOAT), ("ekf_cal_online", DOUBLE), ("ekf_cal_online", FLOAT)]
FUSED = ("-std=c99", "-O2", "-march=native", "-ffp-contract=fast")
_BATCH = 50_000
EVALUATIONS = {FLOAT: 1_000_000, DOUBLE: 200_000}


def trees(folder: Path, model: str, scalar: ir.Scalar) -> str:
    """Export a model and give the prefix of the tree in the type."""
    pipeline.export(pipeline.load(model), folder, scalar=scalar.value, batches=True)
    bundle = json.loads((folder / "proof" / "error_bounds.json").read_text())
    return next(str(t["prefix"]) for t in bundle["trees"] if t["type"] == scalar.value)


def check(model: str, scalar: ir.Scalar, count: int, folder: Path, flags: tuple[str, ...]) -> int:
    """Compare every function of a tree; the number of evaluations that passed the guards."""
    prefix = trees(folder, model, scalar)
    library = compile_sources(folder, prefix, flags)
    rng = np.random.default_rng(7)
    good = 0
    count = -(-count // ITEMS) * ITEMS  # every batch a whole number of calls
    for function in functions(model, scalar):
        compiled = Compiled(library, prefix, function, scalar)
        limits = bounds(function, scalar)
        for start in range(0, count, _BATCH):
            points = samples(function, scalar, min(_BATCH, count - start), rng)
            points = shared_by_items(function, points)
            found, passed = compiled(points)
            judged, meant = values(function, points, WIDER[scalar], WIDER[scalar])
            both = passed & meant
            good += int(both.sum())
            assert both.mean() > 0.3, f"{function.name}: the guards refuse most samples"
            for name, computed in found.items():
                if not limits[name]:
                    continue
                error = np.abs(computed[both].astype(WIDER[scalar]) - judged[name][both])
                # The judge itself is off by a thousandth of the bound of its narrower type.
                allowed = np.array([r.bound for r in limits[name]]) * 1.001
                assert np.all(error.max(axis=0) <= allowed), (function.name, name)
    return good


@pytest.mark.parametrize(("model", "scalar"), QUICK)
def test_compiled_c_keeps_its_bounds(model: str, scalar: ir.Scalar, tmp_path: Path) -> None:
    if not can_judge(scalar):
        pytest.skip("no type wide enough to judge with")
    assert check(model, scalar, 2000, tmp_path, FLAGS) > 1000


def test_fused_operations_keep_the_bounds(tmp_path: Path) -> None:
    """Fusing leaves roundings out: the bounds hold without -ffp-contract=off as well."""
    assert check("rover", FLOAT, 20_000, tmp_path, FUSED) > 10_000


@pytest.mark.slow
@pytest.mark.parametrize("model", MODELS)
def test_a_million_evaluations_keep_the_bounds(model: str, tmp_path: Path) -> None:
    """Of every model: a million in float, fewer in double, whose judge takes much longer."""
    for scalar, least in EVALUATIONS.items():
        if can_judge(scalar):
            each = -(-least // len(functions(model, scalar))) * 3 // 2
            assert check(model, scalar, each, tmp_path / scalar.value, FLAGS) > least


@pytest.mark.slow
def test_a_million_positions_of_the_rover(tmp_path: Path) -> None:
    gps = next(f for f in functions("rover", FLOAT) if f.name == "gps")
    prefix = trees(tmp_path, "rover", FLOAT)
    compiled = Compiled(compile_sources(tmp_path, prefix), prefix, gps, FLOAT)
    limits = {name: [r.bound for r in found] for name, found in bounds(gps, FLOAT).items()}
    rng, worst = np.random.default_rng(11), 0.0
    for _ in range(20):
        points = samples(gps, FLOAT, 50_000, rng)
        found, passed = compiled(points)
        exact, _ = values(gps, points, np.float64, np.float64)
        assert passed.all()
        for name, computed in found.items():
            error = np.abs(computed.astype(np.float64) - exact[name])
            assert np.all(error.max(axis=0) <= np.array(limits[name]))
        worst = max(worst, float(np.abs(found["value"].astype(np.float64) - exact["value"]).max()))
    assert worst > max(limits["value"]) / 3.0


def test_double_is_judged_by_something_wider() -> None:
    assert can_judge(FLOAT)
    assert can_judge(DOUBLE) == (np.finfo(np.longdouble).nmant > 60)
