"""Twenty random layouts generate, build and verify.

The same twenty every time; the environment variable ``SYMNAV_LAYOUT_SEED`` chooses others.
"""

from __future__ import annotations

import os
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings

from symnav import pipeline
from symnav.spec import from_table
from tests.random_layouts import tables

SEED = os.environ.get("SYMNAV_LAYOUT_SEED")


@settings(
    max_examples=20,
    deadline=None,
    database=None,
    derandomize=SEED is None,
    phases=[Phase.generate],  # a smaller layout that fails takes minutes to find
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
@given(table=tables())
def any_layout_generates_builds_and_verifies(table: dict[str, Any]) -> None:
    spec = from_table(table, "random")
    with tempfile.TemporaryDirectory() as folder:
        sheet = pipeline.verify(spec, samples=40, seed=7, out=Path(folder))
    assert sheet.passed, "\n".join(sheet.failures()[:5])
    assert not sheet.notes
    compared = {row.function for row in sheet.rows}
    assert {entry.name for entry in spec.entries} <= compared


def test_any_layout_generates_builds_and_verifies() -> None:
    run = any_layout_generates_builds_and_verifies
    (run if SEED is None else seed(int(SEED))(run))()


def test_everything_is_drawn() -> None:
    """Whatever a layout may hold turns up often enough."""
    seen: Counter[str] = Counter()

    @settings(max_examples=200, database=None, derandomize=True, phases=[Phase.generate])
    @given(table=tables())
    def look(table: dict[str, Any]) -> None:
        fix, ranges = table["measurement"]
        (imu,) = table.get("correction", [{}])
        clock = ranges.get("clock_bias")
        seen.update(f"state {block['kind']}" for block in table["state"])
        seen.update(f"input {block['storage']}" for block in table["input"])
        seen.update(table["scalars"])
        seen.update(f"clock {key}" for key in clock or () if isinstance(clock, dict))
        seen.update(key for key in ("residual", "heading", "observer_attitude") if fix.get(key))
        seen.update(key for key in ("difference",) if key in ranges)
        seen.update(f"imu {key}" for key, value in imu.items() if value == "input")
        seen.update(f"imu bias {value}" for value in imu.values() if str(value).endswith("_bias"))
        seen.update({f"samples {imu.get('samples')}"})

    look()
    for wanted in (
        "state heading", "state rotation", "state geodetic", "input dcm", "float", "clock gps",
        "clock block", "residual", "heading", "observer_attitude", "difference", "samples 5",
        "imu angular_rate_start", "imu previous_delta_theta", "imu bias gyro_bias",
        "imu bias accelerometer_bias",
    ):  # fmt: skip
        assert seen[wanted] >= 5, (wanted, seen)
