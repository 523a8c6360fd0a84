"""A specification written as TOML is the same specification."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from symnav import pipeline
from symnav.spec import loads
from symnav.spec.builder import build, frame, measurement, vector
from symnav.spec.writing import as_toml

VALUES = st.recursive(
    st.booleans() | st.integers(-(2**60), 2**60) | st.text() | st.floats(allow_nan=False),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=6,
)


@pytest.mark.parametrize("model", [name for name, _ in pipeline.shipped()])
def test_shipped_specifications_read_back(model: str) -> None:
    spec = pipeline.load(model)
    again = loads(spec.toml)
    assert again.text == spec.text
    assert again.toml == spec.toml


def test_order_of_keys_does_not_matter_but_that_of_states_does() -> None:
    rows: list[dict[str, Any]] = [
        {"name": "b", "kind": "scalar"},
        {"kind": "scalar", "name": "a"},
    ]
    text = as_toml({"state": rows, "name": "t"})
    assert text == as_toml({"name": "t", "state": [dict(reversed(r.items())) for r in rows]})
    assert text != as_toml({"name": "t", "state": rows[::-1]})


@given(st.dictionaries(st.text(), VALUES, max_size=4))
def test_any_value_reads_back(row: dict[str, Any]) -> None:
    assert tomllib.loads(as_toml({"name": "t", "state": [row]})) == {"name": "t", "state": [row]}


def test_python_functions_have_no_toml() -> None:
    spec = build(
        "t",
        frame("n", "ned"),
        vector("position", 3, "m", frame="n"),
        measurement("z", equation=lambda q: q.position),
    )
    assert spec.toml == ""


def test_expressions_and_lets_read_back() -> None:
    spec = build(
        "t",
        vector("p", 3, "m", frame="n"),
        measurement(
            "z", equation=["both * 2 + more"], let={"both": "p + p", "more": "both + p"}, unit="m"
        ),
    )
    assert loads(spec.toml).text == spec.text
