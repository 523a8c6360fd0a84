"""Twenty random layouts generate, build and verify."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, Phase, given, settings

from symnav import pipeline
from symnav.spec import from_table
from tests.random_layouts import tables


@settings(
    max_examples=20,
    deadline=None,
    derandomize=True,
    phases=[Phase.explicit, Phase.generate],  # a smaller layout that fails takes minutes to find
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
@given(table=tables())
def test_any_layout_generates_builds_and_verifies(table: dict[str, Any]) -> None:
    spec = from_table(table, "random")
    with tempfile.TemporaryDirectory() as folder:
        sheet = pipeline.verify(spec, samples=40, seed=7, out=Path(folder))
    assert sheet.passed, "\n".join(sheet.failures()[:5])
    assert not sheet.notes
    compared = {row.function for row in sheet.rows}
    assert {entry.name for entry in spec.entries} <= compared
