"""What models and layout functions declare: domains, sizes, frames, rules, documentation."""

from __future__ import annotations

import pytest

from symnav import ir, units
from symnav.blocks import frame_map
from symnav.equations import library
from symnav.equations.model import Model, no_rule
from symnav.frames import earth
from tests.core.specs import geodetic, layout, layout_functions, rotation, vector
from tests.reference import broadcast_orbit

MODELS = list(library().values())
NAMES = [model.name for model in MODELS]


@pytest.mark.parametrize("model", MODELS, ids=NAMES)
def test_roles(model: Model) -> None:
    """Every default domain has an inside; it excludes zero where the equation divides."""
    options = {option.name: option.default for option in model.options}
    names = [role.name for role in model.roles]
    assert len(set(names)) == len(names)
    assert set(model.differentiated) <= set(names)
    for role in model.roles:
        assert role.size_for(options) >= 1
        assert all(units.parse(unit) for unit in role.units)
        assert role.description.endswith(".")
        if role.kind == "rotation":
            assert len(set(frame_map(role.frame))) == 2
        if role.kind != "geodetic":
            assert role.lower < role.upper, role.name
            assert role.lower > 0 if role.positive else role.lower <= 0 <= role.upper, role.name
    assert model.role(names[0]) is model.roles[0]


@pytest.mark.parametrize("model", MODELS, ids=NAMES)
def test_documentation(model: Model) -> None:
    """Every choice of every option has its sentences."""
    defaults = {option.name: option.default for option in model.options}
    for option in model.options:
        assert option.default == option.choices[0]
        for choice in option.choices:
            sentences = model.conventions({**defaults, option.name: choice})
            assert sentences and all(s.endswith(".") for s in sentences)
    assert model.conventions(defaults)
    assert model.title and model.equation and model.source


def test_symmetric_ranges_and_angles() -> None:
    """Vectors reach as far one way as the other."""
    for model in MODELS:
        for role in model.roles:
            if role.kind in ("vector", "rotation", "point"):
                assert role.lower == -role.upper, role.name
    elements = {role.name: role for role in library()["broadcast_orbit"].roles}
    assert elements["mean_anomaly"].lower == -elements["mean_anomaly"].upper == -3.2
    assert elements["time"].lower < 0 and elements["time"].upper > elements["toe"].upper


def test_samples_scale_the_size() -> None:
    """Three elements for every sub-sample."""
    role = library()["specific_force"].role("delta_theta")
    assert [role.size_for({"samples": n}) for n in (1, 2, 5)] == [3, 6, 15]


def test_observer_or_heading() -> None:
    """One of them, not both."""
    check = library()["gnss_position"].check
    assert check({}, frozenset({"heading"})) == ()
    (problem,) = check({}, frozenset({"heading", "observer_attitude"}))
    assert problem[0] == "heading"


def test_sagnac_needs_the_satellite() -> None:
    """The relative form is told where the satellite is."""
    check = library()["pseudorange_relative"].check
    assert [key for key, _ in check({"sagnac": "first_order"}, frozenset())] == ["satellite_xy"]
    assert check({"sagnac": "first_order"}, frozenset({"satellite_xy"})) == ()
    assert check({"sagnac": "none"}, frozenset()) == ()


def test_frame_rules() -> None:
    """A position names the earth-fixed or the navigation frame."""
    rule = library()["pseudorange"].frame_rule
    axes = {"e": "ecef", "n": "ned"}
    assert rule({}, axes, None) == {}
    assert rule({"place": "e"}, axes, None) == {"ecef": "e"}
    assert rule({"place": "n"}, axes, None) == {"nav": "n"}
    assert rule({"place": "e"}, axes, "l") == {"ecef": "e", "nav": "l"}
    assert no_rule({"place": "e"}, axes, None) == {}
    assert library()["specific_force"].frame_rule({}, axes, None) == {}


def test_constants_of_the_satellite_systems() -> None:
    """As the interface documents print them."""
    for system, value in broadcast_orbit.GRAVITATION.items():
        assert earth.GRAVITATIONAL_PARAMETER[system] == float(value)
    for system, value in broadcast_orbit.RELATIVITY.items():
        assert earth.RELATIVISTIC_CLOCK[system] == float(value)


def test_arguments_of_layout_functions() -> None:
    """Errors may be of either sign and turn by more than half a turn."""
    spec = layout(vector("v", 2), rotation("q", storage="xyzw"), geodetic("p"))
    retract, local = layout_functions(spec)
    assert [a.name for a in retract.arguments] == ["x", "d"]
    assert [a.name for a in local.arguments] == ["x", "y"]
    (x, d), (_, y) = retract.arguments, local.arguments
    assert x.domains == y.domains
    assert [(domain.start, domain.size) for domain in x.domains] == [(0, 2), (2, 4), (6, 3)]
    assert [(domain.start, domain.size) for domain in d.domains] == [(0, 2), (2, 3), (5, 3)]
    assert [domain.kind for domain in x.domains] == [
        ir.Kind.REAL, ir.Kind.QUATERNION, ir.Kind.REAL,
    ]  # fmt: skip
    for domain in d.domains:
        assert domain.upper == tuple(-low for low in domain.lower)
        assert all(high > 3.1416 for high in domain.upper)
