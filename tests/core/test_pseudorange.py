"""Pseudoranges: every treatment of the earth's rotation, every clock, every place of the body."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

from symnav.blocks import Block
from symnav.spec.records import BySlot, BySystem, Input, ToInput, ToState
from tests.core.interpreter import SINGLE, Interpreter
from tests.core.judging import Judge, check, draw
from tests.core.specs import Case, derived, geodetic, lowered, ranges, rotation, vector

SAGNAC = ["none", "first_order", "rotate_once", "exact"]
#: A place on the earth and a satellite, so that the earth's rotation shows as it does in use.
GEOMETRY: dict[str, Any] = {
    "p": (4.1e6, 1.3e6, 4.6e6),
    "s": (1.49e7, -1.71e7, 1.36e7),
}
#: Far enough for the third and fourth power of the angle turned during the travel time to matter.
DISTANT: dict[str, Any] = {"p": (6e6, -3e6, 4e6), "s": (-9.1e7, 8.3e7, 2.7e7)}


@pytest.mark.parametrize("sagnac", SAGNAC)
def test_earth_rotation(sagnac: str) -> None:
    """Ranges to a picometre or so, with Jacobians."""
    check(ranges(sagnac), absolute="1e-12", **GEOMETRY)
    check(ranges(sagnac), absolute="2e-11", seed=2, **DISTANT)


@pytest.mark.parametrize("sagnac", ["none", "exact"])
@pytest.mark.parametrize("maps", ["n -> ecef", "ecef -> n"])
def test_navigation_frame(maps: str, sagnac: str) -> None:
    """A position in a navigation frame goes through its attitude and origin."""
    base = ranges(sagnac, place="n")
    case = replace(
        base,
        blocks=[*base.blocks, vector("o", frame="ecef", bound=7e6)],
        inputs=[base.inputs[0], rotation("C", maps=maps), base.inputs[2]],
        bindings={**base.bindings, "origin": "o"},
        entry={"jacobian_inputs": ("C", "l", "s")},
    )
    check(case, absolute="1e-11", o=(4.1e6, 1.3e6, 4.6e6), s=GEOMETRY["s"])


def test_constants() -> None:
    """Everything but the satellite is folded, or only the clock is estimated."""
    base = ranges("exact", place="n")
    fixed = {
        "nav_to_ecef": (0.5, 0.5, -0.5, 0.5),
        "lever_arm": (1.0, 2.0, -0.7),
        "clock_bias": (12.3,),
    }
    satellite = base.inputs[2]
    case = replace(base, bindings={**base.bindings, **fixed}, inputs=[satellite])
    check(case, absolute="1e-9", s=GEOMETRY["s"])
    bindings = {"position": GEOMETRY["p"], "clock_bias": "b", "satellite_position": "s"}
    frames = {"place": "ecef", "ecef": "ecef"}
    clock = replace(
        base, blocks=[vector("b", 1)], bindings=bindings, inputs=[satellite], frames=frames
    )
    check(clock, absolute="1e-11", s=GEOMETRY["s"])


@pytest.mark.parametrize("axes", ["ned", "enu"])
@pytest.mark.parametrize("attitude_frame", ["fixed", "moving"])
def test_geodetic_position(attitude_frame: str, axes: str) -> None:
    """A geodetic position brings its own local-level axes."""
    case = Case(
        "pseudorange",
        [geodetic("p", axes, attitude_frame), rotation("q"), vector("l", frame="b", bound=5.0)],
        [vector("s", frame="ecef", bound=3e7)],
        {"position": "p", "attitude": "q", "lever_arm": "l", "satellite_position": "s"},
        {"body": "b", "nav": "n", "ecef": "ecef"},
        {"sagnac": "first_order"},
    )
    check(case, absolute="1e-8", s=GEOMETRY["s"])


@pytest.mark.parametrize("unit", ["m", "s"])
def test_clocks_delays_and_residual(unit: str) -> None:
    """Every term with its sign; the residual is measured less predicted."""
    blocks = [
        vector("p", frame="ecef", bound=7e6),
        vector("b", 1, unit, bound=1e3 if unit == "m" else 1e-3),
    ]
    inputs: list[Block | Input] = [
        vector("s", frame="ecef", bound=3e7),
        vector("dts", 1, "s", bound=1e-3),
        vector("T", 1, "m", bound=20.0),
        vector("I", 1, "m", bound=20.0),
        Input(vector("measured", 1, "m", bound=3e7), item=True),
    ]
    bindings = {
        "position": "p",
        "clock_bias": "b",
        "satellite_position": "s",
        "satellite_clock": "dts",
        "troposphere": "T",
        "ionosphere": "I",
        "measured": "measured",
    }
    entry = {"residual": True, "jacobian_inputs": ("dts", "T", "I", "s")}
    case = Case("pseudorange", blocks, inputs, bindings, {"ecef": "ecef"}, entry=entry)
    check(case, absolute="1e-10", **GEOMETRY)


@pytest.mark.parametrize("system", [0, 1, 2])
def test_one_clock_for_each_system(system: int) -> None:
    """The item's system chooses the clock and its column; a clock may be an input."""
    clocks = BySystem(
        (("gps", ToState("b0")), ("galileo", ToState("b1")), ("beidou", ToInput("b2"))), "system"
    )
    case = Case(
        "pseudorange",
        [vector("b1", 1), vector("p", frame="ecef", bound=7e6), vector("b0", 1)],
        [
            vector("b2", 1),
            vector("s", frame="ecef", bound=3e7),
            Input(vector("system", 1, "1", bound=2), item=True, integer=True),
        ],
        {"position": "p", "clock_bias": clocks, "satellite_position": "s"},
        {"ecef": "ecef"},
    )
    check(case, absolute="1e-12", system=(system,), **GEOMETRY)


@pytest.mark.parametrize("slot", [0, 3])
def test_one_state_for_each_item(slot: int) -> None:
    """The item's slot chooses the element of the state and the column."""
    case = Case(
        "pseudorange",
        [vector("padding", 2), vector("iono", 4), vector("p", frame="ecef", bound=7e6)],
        [
            vector("s", frame="ecef", bound=3e7),
            Input(vector("slot", 1, "1", bound=3), item=True, integer=True),
        ],
        {"position": "p", "ionosphere": BySlot("iono", "slot"), "satellite_position": "s"},
        {"ecef": "ecef"},
    )
    check(case, absolute="1e-12", slot=(slot,), **GEOMETRY)


def relative(sagnac: str) -> Case:
    """Ranges relative to a reference point, the body near it."""
    inputs = [
        rotation("C", maps="n -> ecef", storage="dcm"),
        vector("d", frame="ecef", bound=3e7),
        vector("r0", 1, bound=1e8, positive=True),
        vector("xy", 2, bound=3e7),
    ]
    bindings = {
        "position": "p",
        "attitude": "q",
        "lever_arm": "l",
        "nav_to_ecef": "C",
        "clock_bias": "b",
        "satellite_difference": "d",
        "reference_range": "r0",
        "satellite_xy": "xy",
    }
    if sagnac == "none":
        del bindings["satellite_xy"]
        inputs.pop()
    return Case(
        "pseudorange_relative",
        [
            vector("p", frame="n", bound=3e4),
            rotation("q"),
            vector("l", frame="b", bound=5.0),
            vector("b", 1, bound=100.0),
        ],
        inputs,
        bindings,
        {"body": "b", "nav": "n", "ecef": "ecef"},
        {"sagnac": sagnac},
    )


@pytest.mark.parametrize("sagnac", ["first_order", "none"])
def test_relative_range(sagnac: str) -> None:
    """The difference of two ranges without forming either; r0 only enters through the value."""
    d = [mpf(e) for e in ("1.3e7", "-1.9e7", "1.1e7")]
    r0 = mp.sqrt(sum(e * e for e in d))
    check(relative(sagnac), absolute="1e-11", d=d, r0=(r0,), xy=(1.7e7, -1.8e7))


def test_relative_range_in_single_precision() -> None:
    """At most a centimetre off within 30 km per axis, with every operation in float32.

    The body's place is given along earth-fixed axes: a matrix in float32 would by itself move it
    by half a centimetre.
    """
    base = relative("first_order")
    place = vector("p", frame="ecef", bound=3e4)
    bindings = {role: name for role, name in base.bindings.items() if role != "nav_to_ecef"}
    attitude = rotation("q", maps="b -> ecef")
    spec = replace(base, blocks=[place, attitude, *base.blocks[2:]], bindings=bindings).spec()
    interpreter = Interpreter(lowered(spec, "casadi"), SINGLE)
    rng = np.random.default_rng(7)
    for seed in range(100):
        direction = rng.normal(size=3)
        d = 2.3e7 * direction / np.linalg.norm(direction)
        fixed = {"xy": d[:2].tolist(), "b": (12.25,), "l": (0.5, -2.25, 1.0)}
        corner = rng.choice([-1.0, 1.0], 3) * rng.uniform(2e4, 3e4, 3)
        point = draw(spec, seed, d=d.tolist(), p=corner.tolist(), **fixed)
        # What the kernel receives are floats: so much is not the kernel's error.
        point = {name: [mpf(float(np.float32(e))) for e in x] for name, x in point.items()}
        point["r0"] = [mp.sqrt(sum(e * e for e in point["d"]))]
        expected = Judge(spec, point).outputs()["value"][0]
        single = {name: [np.float32(e) for e in x] for name, x in point.items()}
        actual = interpreter.run(single).outputs["value"][()]
        assert isinstance(actual, np.float32)
        assert abs(float(actual) - expected) < 0.010, seed


def test_satellite_at_the_antenna_is_a_domain_error() -> None:
    """No direction is defined there; the steps that follow stay finite."""
    case = Case(
        "pseudorange",
        [vector("p", frame="ecef", bound=7e6)],
        [vector("s", frame="ecef", bound=3e7)],
        {"position": "p", "satellite_position": "s"},
        {"ecef": "ecef"},
    )
    for route in ("casadi", "sympy"):
        function = lowered(case.spec(), route)
        point = {"x": [mpf(1), mpf(2), mpf(3)], "s": [mpf(1), mpf(2), mpf(3)]}
        assert len(Interpreter(function).run(point).failed) == 1
        point["s"][2] += mpf("1e-5")
        assert not Interpreter(function).run(point).failed


@pytest.mark.parametrize("error", ["right", "right_negative", "left", "left_negative", "storage"])
@pytest.mark.parametrize("arm", ["l", (0.3, -0.1, 0.2)], ids=["input", "constant"])
@pytest.mark.parametrize("maps", ["n -> ecef", "ecef -> n"])
def test_two_rotations_in_a_row(error: str, arm: Any, maps: str) -> None:
    """Composed where the error allows it, one after the other where not; the same numbers."""
    case = ranges("first_order")
    place, _, clock = case.blocks
    blocks = [place, rotation("q", error=error), clock]
    bindings: dict[str, Any] = {**case.bindings, "lever_arm": arm}
    arm_input, _, satellite = case.inputs
    inputs = [arm_input, rotation("C", maps=maps, storage="dcm"), satellite]
    check(replace(case, blocks=blocks, inputs=inputs, bindings=bindings))
    names = {d.symbol.name for d in derived(replace(case, blocks=blocks).spec()).definitions}
    assert ("C_q_00" in names) == error.startswith("right")
