"""The package every test of this folder calls."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

from symnav import ir
from tests.emit_numpy import modules, packages


@pytest.fixture(scope="session")
def module() -> ir.Module:
    """All hand-written functions."""
    return modules.module()


@pytest.fixture(scope="session")
def package(module: ir.Module, tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """Their package, imported."""
    folder = tmp_path_factory.mktemp("packages") / module.name
    return packages.load(packages.write(packages.text_of(module), folder))


@pytest.fixture
def rng() -> np.random.Generator:
    """The same numbers in every run."""
    return np.random.default_rng(20240229)
