"""Packages written from hand-made modules, and arguments to call them with."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import pytest

from symnav import ir
from symnav.emit import numpy as numpy_target
from symnav.emit import python as python_target
from tests.emit_numpy import modules


def write(module: ir.Module, folder: Path) -> Path:
    """Writes the Python files of a package below a folder."""
    package = folder / module.name
    for path, text in {**python_target.emit(module), **numpy_target.emit(module)}.items():
        file = package / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return package


def load(package: Path, name: str) -> ModuleType:
    """Imports a package from its folder under a name of its own."""
    parent = importlib.machinery.ModuleSpec(package.parent.name, None, is_package=True)
    parent.submodule_search_locations = [str(package.parent)]
    sys.modules.setdefault(package.parent.name, importlib.util.module_from_spec(parent))
    return importlib.import_module(f"{package.parent.name}.{name}")
