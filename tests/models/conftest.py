"""Generated packages of shipped models, by back end."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import symnav

MODELS = Path(symnav.__file__).parent / "models"


def specification(model: str) -> str:
    """The text of a shipped model, to be changed."""
    return (MODELS / f"{model}.toml").read_text(encoding="utf-8")


@dataclass(frozen=True)
class Package:
    """One back end of a generated package.

    Attributes:
        functions: the module whose attributes are the functions.
        state: layout of the state vector.
        guard_error: what a call for one epoch raises.
    """

    functions: Any
    state: Any
    guard_error: type[Exception]


@pytest.fixture(params=["native", "numpy"])
def package(
    request: pytest.FixtureRequest, generated: Callable[[str | Path], ModuleType]
) -> Callable[[str], Package]:
    """The package of a shipped model, or of the text of a specification, in each back end."""

    def make(spec: str) -> Package:
        module: Any = generated(spec)
        functions = importlib.import_module(f"{module.__name__}.{request.param}")
        return Package(functions, module.State, module.GuardError)

    return make
