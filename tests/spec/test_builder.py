"""Python and TOML are one format: random layouts come out the same from both."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from symnav.errors import SpecError
from symnav.spec import Spec, build, loads
from symnav.spec.builder import (
    Piece,
    argument,
    correction,
    frame,
    geodetic,
    heading,
    measurement,
    rotation,
    scalar,
    table,
    vector,
)

FRAMES = (frame("n", "ned"), frame("u", "enu"), frame("e", "ecef"))


def toml(value: Any) -> str:
    """TOML of a value; JSON's text and numbers are TOML's, tables and booleans differ."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(v)}" for key, v in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(toml(v) for v in value) + "]"
    return json.dumps(value)


def written(name: str, pieces: tuple[Piece, ...], **head: Any) -> str:
    """A specification as TOML text, made without the package's own tables."""
    lines = [f"name = {toml(name)}", *(f"{key} = {toml(v)}" for key, v in head.items())]
    for piece in pieces:
        lines.append(f"[[{piece.section}]]")
        lines += [f"{key} = {toml(value)}" for key, value in piece.fields.items()]
    return "\n".join(lines)


bounds = st.tuples(st.floats(-1e6, -1e-3), st.floats(1e-3, 1e6)).map(list)
error_sign = st.sampled_from(["true_minus_estimate", "estimate_minus_true"])


def optional(**fields: st.SearchStrategy[Any]) -> st.SearchStrategy[dict[str, Any]]:
    """Any subset of fields."""
    return st.fixed_dictionaries({}, optional=fields)


@st.composite
def state(draw: st.DrawFn, name: str) -> Piece:
    """A state block of any kind."""
    kind = draw(st.sampled_from(["vector", "framed", "scalar", "rotation", "heading", "geodetic"]))
    if kind == "vector":
        size = draw(st.integers(1, 12))
        fields = draw(optional(error_sign=error_sign, range=bounds))
        return vector(name, size, draw(st.sampled_from(["m", "rad/s", "m/s^2", "1"])), **fields)
    if kind == "framed":
        fields = draw(
            optional(
                range=st.lists(bounds, min_size=3, max_size=3), description=st.just("A vector.")
            )
        )
        return vector(name, 3, "m", frame=draw(st.sampled_from("bn")), **fields)
    if kind == "scalar":
        return scalar(name, "s", **draw(optional(error_sign=error_sign, range=bounds)))
    if kind == "rotation":
        fields = draw(
            optional(
                storage=st.sampled_from(["wxyz", "xyzw"]),
                error=st.sampled_from(["right", "left", "left_negative", "storage"]),
                normalise=st.booleans(),
                norm_tolerance=st.floats(1e-9, 0.5),
            )
        )
        return rotation(name, draw(st.sampled_from(["b -> n", "n -> b"])), **fields)
    if kind == "heading":
        return heading(name, "L -> G", **draw(optional(axis=st.sampled_from("xyz"))))
    level = draw(st.sampled_from("nu"))
    return geodetic(
        name, "e", level, **draw(optional(attitude_frame=st.sampled_from(["fixed", "moving"])))
    )


@st.composite
def layouts(draw: st.DrawFn) -> tuple[Piece, ...]:
    """Frames, states and a few functions of them."""
    pieces = [draw(state(f"block_{k}")) for k in range(draw(st.integers(1, 6)))]
    position = vector("position", 3, "m", frame="n")
    attitude = rotation("attitude", draw(st.sampled_from(["b -> n", "n -> b"])))
    arm = draw(st.sampled_from(["input", "none", [0.1, 0.0, -0.3]]))
    functions: list[Piece] = [
        measurement(
            "gps", "gnss_position", position="position", attitude="attitude", lever_arm=arm
        ),
        correction("imu", "specific_force", attitude="attitude", samples=draw(st.integers(1, 5))),
    ]
    if draw(st.booleans()):
        functions.append(measurement("depth", equation="position[2] + offset"))
        functions.append(argument("offset", unit="m", range=(-5.0, 5.0)))
    return (*FRAMES, *draw(st.permutations([position, attitude, *pieces])), *functions)


@settings(max_examples=40, deadline=None)
@given(layouts(), st.sampled_from([{}, {"scalars": ["double", "float"]}, {"scalar": "float"}]))
def test_both_doors_lead_to_the_same_specification(
    pieces: tuple[Piece, ...], head: dict[str, Any]
) -> None:
    built = build("random", *pieces, **head)
    read = loads(written("random", pieces, **head))
    assert built == read
    assert built.text == read.text
    names = [piece.fields["name"] for piece in pieces if piece.section == "state"]
    assert list(built.layout.places) == names


@settings(max_examples=20, deadline=None)
@given(layouts(), st.randoms())
def test_the_order_of_declared_tables_matters_only_where_it_is_memory(
    pieces: tuple[Piece, ...], random: Any
) -> None:
    def shuffled(section: str) -> list[Piece]:
        chosen = [piece for piece in pieces if piece.section == section]
        random.shuffle(chosen)
        return chosen

    rest = [piece for piece in pieces if piece.section != "frame"]
    assert build("random", *rest, *shuffled("frame")).text == build("random", *pieces).text
    states = [piece for piece in pieces if piece.section == "state"]
    backwards = [piece for piece in pieces if piece.section != "state"]
    moved = build("random", *backwards, *states[::-1])
    assert moved.layout.digest != build("random", *pieces).layout.digest


def test_pieces_may_be_shared() -> None:
    common = (frame("n", "ned"), vector("position", 3, "m", frame="n"))
    gps = measurement("gps", "gnss_position", position="position")
    one: Spec = build("one", *common, gps)
    two: Spec = build("two", *common, vector("velocity", 3, "m/s", frame="n"), gps)
    assert one.layout.size == 3
    assert two.layout.size == 6
    assert table("one", (*common, gps))["measurement"][0]["model"] == "gnss_position"


def test_mistakes_are_found_by_the_same_validation() -> None:
    with pytest.raises(SpecError) as caught:
        build("rover", vector("position", 3, "m"), measurement("gps", "gnss_postion"))
    assert [p.path for p in caught.value.problems] == ["measurement[0].model"]
    with pytest.raises(SpecError, match="is not an equation"):
        nested: Any = [lambda q: q.x]
        build("rover", measurement("gps", equation=nested))
