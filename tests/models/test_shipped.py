"""Every shipped model passes its own proof, references written from the books included."""

from __future__ import annotations

from pathlib import Path

import pytest

from symnav import pipeline

REFERENCE = Path(__file__).parents[1] / "reference"
DOCS = Path(__file__).parents[2] / "docs" / "models"
MODELS = [name for name, _ in pipeline.shipped()]


@pytest.mark.parametrize("model", MODELS)
def test_proof(model: str) -> None:
    """C, NumPy, CasADi, 50 digits, differences and references agree."""
    sheet = pipeline.verify(pipeline.load(model), samples=30, seed=3, reference=REFERENCE)
    assert sheet.passed, list(sheet.failures())


@pytest.mark.slow
@pytest.mark.parametrize("model", MODELS)
def test_proof_at_length(model: str) -> None:
    """With the samples of the command line, and another seed."""
    sheet = pipeline.verify(pipeline.load(model), samples=200, seed=11, reference=REFERENCE)
    assert sheet.passed, list(sheet.failures())


@pytest.mark.parametrize("model", MODELS)
def test_title_and_page(model: str) -> None:
    """The first line of a specification is its title; its page shows the file itself."""
    titles = dict(pipeline.shipped())
    assert titles[model] and len(titles[model]) <= 110
    page = (DOCS / f"{model}.md").read_text(encoding="utf-8")
    assert f"../../symnav/models/{model}.toml" in page
    assert page.startswith(f"# {model}\n")
