"""What a retraction returns is what the next call takes: angles at the seam, in either type."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from symnav import ir, pipeline
from symnav.export.arithmetic.evaluation import evaluate, kind_of
from symnav.export.testing.golden import dense
from symnav.spec import Spec, from_table

COUNT = 4000
DECLARED: list[dict[str, Any]] = [
    {},
    {"range": [-math.pi, math.pi]},
    {"range": [-3.14159, 3.14159]},
    {"range": [-3.1416, 3.1416]},
]


def spec(heading: dict[str, Any], longitude: list[float] | None = None) -> Spec:
    """A heading and a place on the Earth."""
    place: dict[str, Any] = {"kind": "geodetic", "frame": "e", "error_frame": "n"}
    if longitude is not None:
        place["range"] = [[-1.4, 1.4], longitude, [-100.0, 1e4]]
    frames = [{"name": "e", "axes": "ecef"}, {"name": "n", "axes": "ned"}]
    states = [
        {"name": "yaw", "kind": "heading", "maps": "L -> G", **heading},
        {"name": "place", **place},
    ]
    return from_table({"name": "tracker", "frame": frames, "state": states})


def near_the_seam(rng: np.random.Generator, kind: Any) -> NDArray[Any]:
    """Angles some numbers of the type away from half a turn, on either side of it."""
    angles = kind.type(math.pi) + np.spacing(kind.type(math.pi)) * rng.integers(-9, 10, COUNT)
    moved = np.where(rng.random(COUNT) < 0.3, rng.uniform(-6.0, 6.0, COUNT), angles)
    return np.asarray(moved * rng.choice([-1.0, 1.0], COUNT), dtype=kind)


@pytest.mark.parametrize("scalar", list(ir.Scalar))
@pytest.mark.parametrize("declared", DECLARED)
def test_what_retract_returns_is_in_range(declared: dict[str, Any], scalar: ir.Scalar) -> None:
    loaded = spec(declared, declared.get("range"))
    retract = next(
        f for f in pipeline.c_route(loaded, pipeline.derive(loaded)) if f.name == "retract"
    )
    kind, rng = kind_of(scalar), np.random.default_rng(11)
    x, d = np.zeros((COUNT, 4), dtype=kind), np.zeros((COUNT, 4), dtype=kind)
    x[:, 0] = rng.uniform(-3.0, 3.0, COUNT)
    x[:, 2] = rng.uniform(-3.0, 3.0, COUNT)
    seen = 0.0
    for _ in range(3):
        d[:, 0] = np.clip(near_the_seam(rng, kind) - x[:, 0], -6.0, 6.0)
        d[:, 2] = 6378137.0 * (near_the_seam(rng, kind).clip(-4.0, 4.0) - x[:, 2])
        outcome = evaluate(retract, scalar, {"x": x, "d": d})
        assert not outcome.status.any(), sorted(set(outcome.status.tolist()))
        x = dense(retract.outputs[0], outcome)
        seen = max(seen, float(np.abs(x[:, [0, 2]]).max()))
    assert seen >= kind.type(math.pi)  # the seam was met
    assert seen < math.pi + 4.0 * float(np.spacing(kind.type(6.0)))


@pytest.mark.parametrize("end", [math.pi, 3.14159, 3.1415, 3.1416, 3.14159265])
def test_pi_of_a_few_digits_is_pi(end: float) -> None:
    """Users write it one way or another; other ends stay as they are."""
    yaw, place = spec({"range": [-1.0, end]}, [-end, 3.0]).layout.blocks
    assert (yaw.lower, yaw.upper) == ((-1.0,), (3.1416,))
    assert (place.lower[1], place.upper[1]) == (-3.1416, 3.0)


def test_an_input_may_be_a_whole_turn() -> None:
    """Nothing wraps what is only read."""
    states = [{"name": "p", "kind": "vector", "size": 3, "unit": "m", "frame": "n"}]
    entry = {"name": "gps", "model": "gnss_position", "position": "p", "heading": "turn"}
    turn = {"name": "turn", "maps": "n -> g", "axis": "z", "range": [0.0, 6.2831]}
    table = {"name": "rover", "state": states, "measurement": [entry], "input": [turn]}
    assert from_table(table).inputs["turn"].block.upper == (6.2831,)
