"""References written from the book: loaded from a directory, called with plain numbers.

A reference is a Python file ``<model>.py`` with ``value(q, options)``. It is code the user points
at, outside this package; it sees quantities as numbers and knows nothing of layouts.
"""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

from symnav.binding import STATE
from symnav.blocks import Block, GeodeticBlock, HeadingBlock, RotationBlock, frame_map
from symnav.equations import library
from symnav.errors import InputError
from symnav.spec.records import BySlot, BySystem, Entry, Spec, ToConstant, ToInput, ToState

_PACKAGE = "symnav_references"


class References:
    """The references of one directory.

    Raises:
        InputError: when the directory does not exist or holds no reference.
    """

    def __init__(self, directory: Path) -> None:
        if not directory.is_dir():
            raise InputError(f"{directory}: no such directory of references")
        self._directory = directory.resolve()
        if not any(self.has(model) for model in library()):
            raise InputError(
                f"{directory}: holds no reference; one is a file <model>.py with a function "
                f"value(q, options), the models being {', '.join(library())}"
            )
        self._load_package()

    def has(self, model: str) -> bool:
        """True when there is a reference of a model."""
        return (self._directory / f"{model}.py").is_file()

    def __call__(
        self, model: str, quantities: Mapping[str, Any], options: Mapping[str, Any]
    ) -> Mapping[str, Sequence[Any]]:
        """Evaluate the reference of a model; empty where there is none."""
        if not self.has(model):
            return {}
        module = importlib.import_module(f"{_PACKAGE}.{model}")
        result: Mapping[str, Sequence[Any]] = module.value(dict(quantities), dict(options))
        return result

    def _load_package(self) -> None:
        for name in [n for n in sys.modules if n == _PACKAGE or n.startswith(f"{_PACKAGE}.")]:
            del sys.modules[name]
        init = self._directory / "__init__.py"
        package = ModuleType(_PACKAGE)
        if init.is_file():
            spec = importlib.util.spec_from_file_location(_PACKAGE, init)
            assert spec is not None and spec.loader is not None
            package = importlib.util.module_from_spec(spec)
        package.__path__ = [str(self._directory)]
        sys.modules[_PACKAGE] = package
        if package.__spec__ is not None and package.__spec__.loader is not None:
            package.__spec__.loader.exec_module(package)


def quantities(spec: Spec, entry: Entry, numbers: Mapping[str, Sequence[Any]]) -> dict[str, Any]:
    """The bound quantities of an entry as numbers, by role.

    Args:
        spec: for layout and inputs.
        entry: its bindings.
        numbers: stored elements by argument, one item's.
    """
    earth = {frame.name: "ecef" for frame in spec.frames if frame.axes == "ecef"}
    bound = _bound(spec, entry, numbers)
    return {role: _with_frames(quantity, earth) for role, quantity in bound.items()}


def _with_frames(quantity: Mapping[str, Any], names: Mapping[str, str]) -> dict[str, Any]:
    """The quantity with the user's name of the earth-fixed frame replaced by ``ecef``."""
    renamed = dict(quantity)
    if renamed.get("frame"):
        renamed["frame"] = names.get(renamed["frame"], renamed["frame"])
    if "maps" in renamed:
        renamed["maps"] = tuple(names.get(end, end) for end in renamed["maps"])
    return renamed


def _bound(spec: Spec, entry: Entry, numbers: Mapping[str, Sequence[Any]]) -> dict[str, Any]:
    result: dict[str, Any] = {}
    for role, binding in entry.bindings.items():
        if isinstance(binding, ToState):
            place = spec.layout.places[binding.block]
            result[role] = _described(place.block, numbers[STATE][place.storage])
        elif isinstance(binding, ToInput):
            result[role] = _described(spec.inputs[binding.name].block, numbers[binding.name])
        elif isinstance(binding, ToConstant):
            result[role] = _constant(entry, role, binding)
        elif isinstance(binding, BySystem):
            chosen = binding.choices[int(numbers[binding.selector][0])][1]
            if isinstance(chosen, ToState):
                place = spec.layout.places[chosen.block]
                result[role] = _described(place.block, numbers[STATE][place.storage])
            else:
                result[role] = _described(spec.inputs[chosen.name].block, numbers[chosen.name])
        elif isinstance(binding, BySlot):
            place = spec.layout.places[binding.block]
            slot = place.start + int(numbers[binding.slot][0])
            unit = place.block.units[0]
            result[role] = {"value": [numbers[STATE][slot]], "frame": None, "unit": unit}
    return result


def _described(block: Block, x: Sequence[Any]) -> dict[str, Any]:
    if isinstance(block, RotationBlock):
        if block.storage == "dcm":
            return {"matrix": list(x), "maps": frame_map(block.maps)}
        q = list(x) if block.storage == "wxyz" else [x[3], *x[:3]]
        return {"wxyz": q, "maps": frame_map(block.maps)}
    if isinstance(block, HeadingBlock):
        return {"angle": x[0], "axis": block.axis, "maps": frame_map(block.maps)}
    if isinstance(block, GeodeticBlock):
        return {
            "llh": list(x),
            "frame": block.frame,
            "level": block.error_frame,
            "axes": block.error_axes,
        }
    frame, _ = block.frames
    return {"value": list(x), "frame": frame or None, "unit": block.units[0]}


def _constant(entry: Entry, role: str, binding: ToConstant) -> dict[str, Any]:
    from mpmath import mp

    declared = entry.model.role(role)
    values = [mp.mpf(v) for v in binding.values]
    if declared.kind == "rotation":
        source, target = frame_map(declared.frame)
        return {"wxyz": values, "maps": (entry.frames[source], entry.frames[target])}
    return {"value": values, "frame": entry.frames.get(declared.frame), "unit": declared.units[0]}
