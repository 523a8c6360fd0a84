"""CasADi's own function of the undifferentiated equation: the same values and Jacobians."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from symnav.lower import casadi_witness
from symnav.spec.records import BySlot, Input
from tests.core.interpreter import Interpreter
from tests.core.judging import draw
from tests.core.specs import (
    Case,
    calibrated_gps,
    derived,
    geodetic,
    gps,
    lowered,
    ranges,
    rotation,
    vector,
)
from tests.core.test_broadcast_orbit import ELEMENTS, orbit
from tests.core.test_pseudorange import GEOMETRY


def by_inputs() -> Case:
    """Jacobians toward a matrix, a quaternion and a vector that are given."""
    base = ranges("first_order", place="n")
    inputs = [*base.inputs, rotation("q", error="left")]
    entry = {"jacobian_inputs": ("C", "q", "l")}
    return replace(base, blocks=[base.blocks[0], base.blocks[2]], inputs=inputs, entry=entry)


def slotted() -> Case:
    """One element of the state for each item."""
    return Case(
        "pseudorange",
        [vector("iono", 4), vector("p", frame="ecef", bound=7e6)],
        [
            vector("s", frame="ecef", bound=3e7),
            Input(vector("slot", 1, "1", bound=3), item=True, integer=True),
        ],
        {"position": "p", "ionosphere": BySlot("iono", "slot"), "satellite_position": "s"},
        {"ecef": "ecef"},
    )


def covariance() -> Case:
    """A noise map through a derivative by stored elements."""
    return Case(
        "local_from_geodetic",
        [vector("padding", 1)],
        [geodetic("z"), geodetic("o"), vector("P", 9, "1", bound=100.0)],
        {"fix": "z", "reference": "o", "covariance": "P"},
        {"level": "n", "local": "L"},
        entry={"jacobian_inputs": ("z",)},
    )


def held() -> Case:
    """Level axes that stay where they are while the error moves the position."""
    return Case(
        "gnss_position",
        [rotation("q", error="rotation_vector"), geodetic("p")],
        [vector("l", frame="b", bound=5.0)],
        {"position": "p", "attitude": "q", "lever_arm": "l"},
        {"body": "b", "nav": "n", "state": "ecef"},
    )


def turned(maps: str) -> Case:
    """A given position whose error is resolved in the frame of the attitude of the state."""
    return Case(
        "gnss_position",
        [rotation("q", error="left", maps=maps)],
        [replace(vector("p0", frame="n", bound=9.0), error_frame="b")],
        {"position": "p0", "attitude": "q", "lever_arm": (1.0, -2.0, 0.5)},
        {"body": "b", "nav": "n", "state": "n"},
        entry={"jacobian_inputs": ("p0",)},
    )


CASES = {
    "gps": gps(),
    "calibrated gps": calibrated_gps(),
    "inputs": by_inputs(),
    "slots": slotted(),
    "covariance": covariance(),
    "held axes": held(),
    "orbit": orbit("gps"),
    "turned error of an input": turned("b -> n"),
    "turned error, map the other way": turned("n -> b"),
}
GIVEN = {**GEOMETRY, **ELEMENTS, "slot": (2,)}


@pytest.mark.parametrize("name", list(CASES))
def test_against_the_route(name: str) -> None:
    """Every output that the witness gives, in the order of the derivation."""
    case = CASES[name]
    spec = case.spec()
    derivation = derived(spec)
    blocks = [*spec.layout.blocks, *(i.block for i in spec.inputs.values())]
    given = {b.name: GIVEN[b.name] for b in blocks if len(GIVEN.get(b.name, ())) == len(b.lower)}
    given.pop("p", None)
    point = draw(spec, 6, **given)
    result = Interpreter(lowered(spec, "sympy")).run(point)
    function = casadi_witness.function(spec, derivation, "witness")
    outputs = function.call([[float(e) for e in point[a]] for a in derivation.arguments])
    for output, matrix in zip(derivation.outputs, outputs, strict=True):
        expected = result.dense(output.name, output.rows, output.columns)
        scale = max(1.0, *(abs(float(e)) for e in expected))
        actual = np.array(matrix).ravel()
        for a, e in zip(actual, expected, strict=True):
            assert abs(float(a) - float(e)) <= 1e-10 * scale, output.name


def test_sources() -> None:
    """One C file and its header for all entries."""
    spec = gps().spec()
    files = casadi_witness.sources(spec, [derived(spec)])
    assert list(files) == ["casadi/t_casadi.c", "casadi/t_casadi.h"]
    assert "int t_casadi_f(const double **arg" in files["casadi/t_casadi.h"]
    assert "t_casadi_f(" in files["casadi/t_casadi.c"]
