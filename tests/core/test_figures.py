"""Numbers of documents read back as what they are."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from symnav.figures import readable


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.05, "0.05"),
        (1e9, "1e+09"),
        (-100.0, "-100"),
        (1234567.0, "1234567"),
        (1234567.891, "1234567.891"),
        (float("inf"), "inf"),
    ],
)
def test_examples(value: float, text: str) -> None:
    """Short where a few digits are enough, and never fewer than it takes."""
    assert readable(value) == text


@given(st.floats(allow_nan=False))
def test_reads_back(value: float) -> None:
    """Whatever the number."""
    assert float(readable(value)) == value
