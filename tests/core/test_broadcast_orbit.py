"""Broadcast orbits: position, velocity and clock, both systems, across the change of week."""

from __future__ import annotations

from typing import Any

import pytest
from mpmath import mp, mpf

from symnav.equations import library
from tests.core.interpreter import Interpreter
from tests.core.judging import Judge, assert_close, check, draw
from tests.core.specs import ROUTES, Case, derived, vector

ELEMENTS: dict[str, Any] = {
    "time": (518_400.5,),
    "toe": (511_200.0,),
    "toc": (511_216.0,),
    "sqrt_a": (5153.67,),
    "eccentricity": (0.0123,),
    "mean_anomaly": (-2.17,),
    "mean_motion_difference": (4.7e-9,),
    "inclination": (0.963,),
    "inclination_rate": (-3.1e-10,),
    "right_ascension": (1.71,),
    "right_ascension_rate": (-8.2e-9,),
    "argument_of_perigee": (-0.81,),
    "cuc": (-2.7e-6,),
    "cus": (8.1e-6,),
    "crc": (231.5,),
    "crs": (-51.3,),
    "cic": (1.7e-7,),
    "cis": (-2.3e-7,),
    "af0": (3.3e-4,),
    "af1": (-2.7e-11,),
    "af2": (1.3e-16,),
    "group_delay": (-1.1e-8,),
}


def orbit(system: str, delayed: bool = True) -> Case:
    """Every element an input."""
    roles = {role.name: role for role in library()["broadcast_orbit"].roles}
    names = [name for name in roles if delayed or name != "group_delay"]
    inputs = [vector(name, 1, roles[name].units[0], bound=1e9) for name in names]
    padding = [vector("padding", 1)]
    bindings = {name: name for name in names}
    frames = {"ecef": "ecef"}
    return Case("broadcast_orbit", padding, inputs, bindings, frames, {"system": system})


@pytest.mark.parametrize("system", ["gps", "galileo"])
def test_orbit(system: str) -> None:
    """Micrometres are visible: the literals are doubles, nothing else is rounded."""
    check(orbit(system), absolute="1e-6", **ELEMENTS)


def test_parts_are_told_apart() -> None:
    """Each output to a part in 1e13, clock and clock rate included, whose numbers are small."""
    spec = orbit("gps").spec()
    point = draw(spec, **ELEMENTS)
    expected = Judge(spec, point).outputs()
    for lower in ROUTES.values():
        result = Interpreter(lower(spec, derived(spec))).run(point)
        for name, elements in expected.items():
            actual = result.dense(name, len(elements))
            size = max(abs(e) for e in elements)
            assert_close([a / size for a in actual], [e / size for e in elements], name, "1e-13")


@pytest.mark.parametrize(("time", "toe"), [(604_700, 600), (300, 604_200), (302_000, 0)])
def test_change_of_week(time: float, toe: float) -> None:
    """The nearer side is taken."""
    elements = {**ELEMENTS, "time": (time,), "toe": (toe,), "toc": (toe + 16,)}
    check(orbit("gps"), absolute="1e-6", **elements)


def test_large_eccentricity_and_no_delay() -> None:
    """Kepler's equation converges at the end of its range."""
    elements = {**ELEMENTS, "eccentricity": (0.1,), "mean_anomaly": (0.9,)}
    del elements["group_delay"]
    check(orbit("galileo", delayed=False), absolute="1e-6", **elements)


@pytest.mark.parametrize("name", ["mean_anomaly", "eccentricity", "sqrt_a", "toe", "cus", "af2"])
def test_jacobian_by_an_element(name: str) -> None:
    """The derivative of Kepler's solution is that of the implicit function."""
    case = orbit("gps")
    spec = Case(
        case.model, case.blocks, case.inputs, case.bindings, case.frames, case.options,
        {"jacobian_inputs": (name,)},
    ).spec()  # fmt: skip
    point = draw(spec, **ELEMENTS)
    expected = [row[0] for row in Judge(spec, point).input_jacobian(name)]
    scale = max(mpf("1e-9"), *(abs(e) for e in expected))
    for lower in ROUTES.values():
        result = Interpreter(lower(spec, derived(spec))).run(point)
        actual = result.dense(f"jacobian_{name}", 3, 1)
        assert_close([a / scale for a in actual], [e / scale for e in expected], name, "1e-12")


def test_newton_steps_suffice() -> None:
    """What the conventions promise: below 1e-16 for every eccentricity up to 0.1."""
    spec = orbit("gps").spec()
    function = ROUTES["sympy"](spec, derived(spec))
    for mean in range(-3, 4):
        point = draw(spec, **{**ELEMENTS, "eccentricity": (0.1,), "mean_anomaly": (mean,)})
        expected = Judge(spec, point).outputs()["clock"][0]
        actual = Interpreter(function).run(point).outputs["clock"][()]
        assert abs(actual - expected) < mp.mpf("1e-18")
