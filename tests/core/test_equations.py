"""The models of positions under every kind of binding, both routes, against the references."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from tests.core.judging import check
from tests.core.specs import Case, calibrated_gps, geodetic, gps, heading, rotation, vector

POSITION = {
    "position": "p",
    "attitude": "q",
    "lever_arm": "l",
    "offset": "o",
    "observer_attitude": "c",
    "origin": "g",
}


def everything(**changes: Any) -> dict[str, Any]:
    """Blocks for every quantity of the antenna's position, some replaced."""
    blocks = {
        "p": vector("p", frame="n"),
        "q": rotation("q"),
        "l": vector("l", frame="b", bound=5.0),
        "o": vector("o", frame="n"),
        "c": rotation("c", maps="n -> g"),
        "g": vector("g", frame="g"),
    }
    return {**blocks, **changes}


def position(state: str, **changes: Any) -> Case:
    """The antenna's position with the quantities named in ``state`` estimated, the rest given."""
    blocks = everything(**changes)
    held = [block for name, block in blocks.items() if name not in state]
    moving = [blocks[name] for name in state]
    return Case(
        "gnss_position",
        moving,
        held,
        POSITION,
        {"body": "b", "nav": "n", "state": "n", "observer": "g"},
        entry={"jacobian_inputs": tuple(block.name for block in held)},
    )


@pytest.mark.parametrize("make", [gps, calibrated_gps])
def test_source_systems(make: Any) -> None:
    """The layouts of the source systems."""
    check(make())


@pytest.mark.parametrize("state", ["plqocg", "qp", "cgl", "o"])
def test_any_quantity_is_state_or_input(state: str) -> None:
    """Jacobians toward states and toward inputs, in any order of the layout."""
    check(position(state, **{"q": rotation("q", maps="n -> b")}))
    check(position(state, **{"c": rotation("c", maps="g -> n")}), seed=2)


def test_constants() -> None:
    """Constants are folded: a lever arm, an attitude that is not quite of unit length."""
    check(
        Case(
            "gnss_position",
            [vector("p", frame="n")],
            [],
            {"position": "p", "attitude": (0.8, 0.1, -0.5, 0.3), "lever_arm": (0.1, -2.9, 0.7)},
            {"body": "b", "nav": "n", "state": "n"},
        )
    )


def test_quantities_bound_to_none() -> None:
    """Terms disappear."""
    check(Case("gnss_position", [vector("p", frame="n")], [], {"position": "p"}, {"state": "n"}))


@pytest.mark.parametrize("maps", ["n -> g", "g -> n"])
@pytest.mark.parametrize("axis", ["x", "y", "z"])
@pytest.mark.parametrize("state", ["pqloc", ""])
def test_heading_of_the_observer(state: str, axis: str, maps: str) -> None:
    """A heading about any axis, written either way, estimated or given."""
    blocks = everything(c=heading("c", maps=maps, axis=axis))
    moving = [blocks[name] for name in state] or [vector("padding", 2)]
    held = [block for name, block in blocks.items() if name not in state]
    bindings = {("heading" if r == "observer_attitude" else r): n for r, n in POSITION.items()}
    frames = {"body": "b", "nav": "n", "state": "n", "observer": "g"}
    entry = {"jacobian_inputs": tuple(block.name for block in held)}
    check(Case("gnss_position", moving, held, bindings, frames, entry=entry))


@pytest.mark.parametrize("attitude_frame", ["fixed", "moving"])
@pytest.mark.parametrize("axes", ["ned", "enu"])
@pytest.mark.parametrize("error", ["right", "left"])
def test_geodetic_position(axes: str, attitude_frame: str, error: str) -> None:
    """Errors in metres; the lever arm follows the local-level axes or not."""
    check(
        Case(
            "gnss_position",
            [rotation("q", error=error), geodetic("p", axes, attitude_frame)],
            [vector("l", frame="b", bound=5.0)],
            {"position": "p", "attitude": "q", "lever_arm": "l"},
            {"body": "b", "nav": "n", "state": "ecef"},
        )
    )


@pytest.mark.parametrize("wanted", [(), ("p",)])
def test_geodetic_position_given(wanted: tuple[str, ...]) -> None:
    """As an input, with and without Jacobian."""
    case = Case(
        "gnss_position",
        [rotation("q")],
        [geodetic("p"), vector("l", frame="b", bound=5.0)],
        {"position": "p", "attitude": "q", "lever_arm": "l"},
        {"body": "b", "nav": "n", "state": "ecef"},
        entry={"jacobian_inputs": wanted},
    )
    check(case)


def test_one_block_for_two_quantities() -> None:
    """Its columns are the sum of both."""
    case = gps()
    check(replace(case, bindings={**case.bindings, "offset": "p"}))


def test_error_frame_of_an_input() -> None:
    """An input's error may be resolved in another frame too."""
    case = gps()
    place = vector("p", frame="n", error_frame="b")
    entry = {"jacobian_inputs": ("p",)}
    check(replace(case, blocks=case.blocks[1:], inputs=[place, *case.inputs], entry=entry))


@pytest.mark.parametrize("covariance", [True, False])
@pytest.mark.parametrize("maps", ["r -> n", "n -> r"])
def test_fix_in_the_state_frame(maps: str, covariance: bool) -> None:
    """The receiver-side transformation, with its covariance."""
    bindings = {
        "receiver_position": "z",
        "observer_attitude": "c",
        "origin_offset": "o",
        "attitude": "q",
        "lever_arm": "l",
    }
    inputs = [
        vector("z", frame="r"),
        rotation("c", maps=maps),
        vector("o", frame="n"),
        vector("P", 9, "m^2", bound=100.0),
    ]
    if covariance:
        bindings["covariance"] = "P"
    check(
        Case(
            "gnss_position_to_state_frame",
            [rotation("q"), vector("l", frame="b", bound=5.0)],
            inputs if covariance else inputs[:-1],
            bindings,
            {"reference": "r", "state": "n", "body": "b"},
        )
    )


@pytest.mark.parametrize("turned", [None, "n -> L", "L -> n"])
@pytest.mark.parametrize("axes", ["ned", "enu"])
def test_local_from_geodetic(axes: str, turned: str | None) -> None:
    """A geodetic fix in local axes, with its noise, near and far from the reference."""
    bindings = {"fix": "z", "reference": "o", "covariance": "P"}
    blocks = [vector("padding", 1)] if turned is None else [heading("psi", maps=turned)]
    if turned is not None:
        bindings["heading"] = "psi"
    case = Case(
        "local_from_geodetic",
        blocks,
        [geodetic("z"), geodetic("o"), vector("P", 9, "1", bound=100.0)],
        bindings,
        {"level": "n", "local": "L"},
        {"axes": axes},
    )
    check(case)
    given = replace(case, bindings={**bindings, "reference": (0.7, -1.3, 250.0)})
    check(given, z=(0.7000001, -1.2999997, 251.0))
    check(case, z=(0.7000001, -1.2999997, 251.0), o=(0.7, -1.3, 250.0), absolute="1e-14")
