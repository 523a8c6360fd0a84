"""Packages on disk made from hand-written modules, and arguments to call them with."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir, pipeline
from symnav.emit import numpy as numpy_target
from symnav.emit import python as python_target
from tests.emit_numpy import modules

BATCHES: tuple[tuple[int, ...], ...] = ((), (1,), (3, 1, 2))


def text_of(module: ir.Module, single: ir.Module | None = None) -> dict[str, str]:
    """The Python files of a package."""
    return {**python_target.emit(module, single), **numpy_target.emit(module)}


def write(text: Mapping[str, str], package: Path) -> Path:
    """Writes files below a package's directory."""
    for path, content in text.items():
        file = package / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content, encoding="utf-8")
    return package


def load(package: Path) -> ModuleType:
    """Imports a package from where it is."""
    return pipeline.import_package(package)


def backend(package: ModuleType, name: str) -> ModuleType:
    """One of its back ends."""
    return importlib.import_module(f"{package.__name__}.{name}")


def states(rng: np.random.Generator, *batch: int) -> NDArray[np.float64]:
    """State vectors inside their ranges, with unit quaternions."""
    x = rng.uniform(-100.0, 100.0, size=(*batch, modules.SIZE))
    q = rng.normal(size=(*batch, 4))
    x[..., 3:7] = q / np.linalg.norm(q, axis=-1, keepdims=True)
    return x


def arguments(
    function: ir.Function, rng: np.random.Generator, *batch: int, items: int = 5
) -> dict[str, Any]:
    """Arguments inside their ranges, by name."""
    made: dict[str, Any] = {}
    for argument in function.arguments:
        axes = (*batch, items) if argument.item else batch
        scalar = argument.size == 1
        shape = axes if scalar else (*axes, argument.size)
        (own, *others) = argument.domains
        if others:
            made[argument.name] = states(rng, *batch)
        elif own.kind is ir.Kind.MATRIX:
            made[argument.name] = _turns(rng, batch)
        elif argument.integer:
            made[argument.name] = rng.integers(
                int(own.lower[0]), int(own.upper[0]) + 1, size=shape, dtype=np.int32
            )
        else:
            bound = min(own.upper[0], 1e7)
            made[argument.name] = rng.uniform(-bound, bound, size=shape) * 0.4
    return made


def _turns(rng: np.random.Generator, batch: tuple[int, ...]) -> NDArray[np.float64]:
    """Rotations by a random angle about the third axis, by row."""
    angle = rng.uniform(-3.0, 3.0, size=batch)
    zero, one = np.zeros(batch), np.ones(batch)
    rows = [
        np.cos(angle),
        -np.sin(angle),
        zero,
        np.sin(angle),
        np.cos(angle),
        zero,
        zero,
        zero,
        one,
    ]
    return np.stack(rows, axis=-1)


def called(form: Any, given: Mapping[str, Any], **more: Any) -> Any:
    """Calls a function with arguments by name, the state by position."""
    rest = {name: value for name, value in given.items() if name != "x"}
    state = (given["x"],) if "x" in given else ()
    return form(*state, **rest, **more)
