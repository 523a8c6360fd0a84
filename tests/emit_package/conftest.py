"""Packages with every back end, compiled once for the tests of this folder."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from symnav import build, ir
from symnav.emit import c
from tests.emit_numpy import modules, packages
from tests.emit_package import foreign


def make(module: ir.Module, folder: Path) -> ModuleType:
    """Writes, compiles and imports a package with both scalar types and CasADi's C."""
    single = replace(module, name=f"{module.name}_f32", scalar=ir.Scalar.FLOAT)
    text = {
        **packages.text_of(module, single),
        **c.emit(module),
        **c.emit(single),
        **foreign.sources(module),
    }
    package = packages.write(text, folder / module.name)
    build.build(package)
    return packages.load(package)


@pytest.fixture(scope="session")
def package(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """All hand-written functions, stored by row."""
    return make(modules.module(), tmp_path_factory.mktemp("packages"))


@pytest.fixture(scope="session")
def by_column(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """Functions whose C stores Jacobians by column."""
    chosen = (modules.gps(), modules.ranges(), modules.frame_map())
    turned = tuple(replace(function, column_major=True) for function in chosen)
    return make(modules.module(*turned, name="turned"), tmp_path_factory.mktemp("packages"))


@pytest.fixture
def rng() -> np.random.Generator:
    """The same numbers in every run."""
    return np.random.default_rng(20240229)
