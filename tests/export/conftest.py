"""Bundles of shipped models, each exported once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.export import hosts

Exported = Callable[[str, str], Path]


@pytest.fixture(scope="session")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> Exported:
    """Export a model in a scalar type; the folder must not be changed."""
    known: dict[tuple[str, str], Path] = {}

    def export(model: str, scalar: str) -> Path:
        if (model, scalar) not in known:
            folder = tmp_path_factory.mktemp(f"{model}_{scalar}".replace(" ", "_"))
            known[model, scalar] = hosts.exported(model, scalar, folder)
        return known[model, scalar]

    return export
