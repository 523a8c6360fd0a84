"""The fuzz harness: it builds, it finds nothing, and it finds what is broken."""

from __future__ import annotations

from pathlib import Path

import pytest

from symnav import pipeline
from symnav.export.runners import Verdict
from symnav.export.runners.fuzz import Fuzz
from tests.export.bundles import MODELS, copy_of, replace_in

pytestmark = pytest.mark.slow


@pytest.fixture(autouse=True)
def needs_fuzzer() -> None:
    """There is a clang with libFuzzer."""
    reason = Fuzz().missing()
    if reason:
        pytest.skip(reason)


@pytest.mark.parametrize("model", MODELS)
def test_nothing_is_found(model: str, tmp_path: Path) -> None:
    record = Fuzz().run(copy_of(model, "float", tmp_path))
    assert record.verdict is Verdict.PASSED, record.findings
    assert int(record.shown.split()[0]) > 0


def test_epochs_side_by_side_fill_whole_blocks(tmp_path: Path) -> None:
    pipeline.export(pipeline.load("navtk_specific_force"), tmp_path, scalar="double", batches=True)
    assert "_blocks(" in next(tmp_path.glob("proof/fuzz_*.c")).read_text()
    record = Fuzz().run(tmp_path)
    assert record.verdict is Verdict.PASSED, record.findings


@pytest.mark.parametrize(
    ("path", "old", "new"),
    [
        # An item too many, and an output that is written although the count is refused.
        ("src/rover_range.c", "i < count; ++i", "i <= count; ++i"),
        ("src/rover_range.c", "status = ROVER_COUNT;", "status = ROVER_COUNT; value[0] = 0.0;"),
    ],
)
def test_what_is_broken_is_found(path: str, old: str, new: str, tmp_path: Path) -> None:
    folder = copy_of("rover", "double", tmp_path)
    replace_in(folder / path, old, new, 1)
    record = Fuzz(runs=300_000, seconds=60).run(folder)
    assert record.verdict is Verdict.FAILED and record.findings
