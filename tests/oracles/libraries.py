"""Access to the third-party libraries that the comparisons need."""

import importlib
import os
from types import ModuleType

import pytest

REQUIRE = "SYMNAV_REQUIRE_ORACLES"


def library(name: str) -> ModuleType:
    """Import a library, skipping the test where it is missing and not required."""
    if os.environ.get(REQUIRE) == "1":
        return importlib.import_module(name)
    module: ModuleType = pytest.importorskip(name)
    return module
