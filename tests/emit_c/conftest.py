"""The C of every hand-written function, compiled once in both scalar types."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from symnav import build, ir
from tests.emit_c import modules
from tests.emit_c.harness import Library, load_extension, write_package


@pytest.fixture(scope="session")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Both trees as files."""
    functions = modules.all_functions()
    return write_package(
        tmp_path_factory.mktemp("emit_c"),
        *(modules.module(*functions, scalar=scalar) for scalar in ir.Scalar),
    )


@pytest.fixture(scope="session")
def libraries(package: Path) -> dict[ir.Scalar, Library]:
    """Both trees compiled into one extension."""
    extension = load_extension(build.build(package))
    return {
        ir.Scalar.DOUBLE: Library(extension, "rover", np.float64),
        ir.Scalar.FLOAT: Library(extension, "rover_f32", np.float32),
    }


@pytest.fixture(params=list(ir.Scalar), ids=str)
def library(request: pytest.FixtureRequest, libraries: dict[ir.Scalar, Library]) -> Library:
    """Each of them in turn."""
    return libraries[request.param]
