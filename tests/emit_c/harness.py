"""Calls into compiled C, with outputs that show whether they were touched."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_file_location
from math import prod
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import build, ir
from symnav.emit import c
from tests.emit_c.interpreter import Array

UNTOUCHED = -123456.75
UNTOUCHED_BYTE = 0xA5


@dataclass
class Outcome:
    """What a call returned and what it left in its outputs."""

    status: ir.Status
    outputs: dict[str, NDArray[Any]] = field(default_factory=dict)

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self.outputs[name]

    @property
    def untouched(self) -> bool:
        """True when no output was written; statuses of items may have been."""
        return all(
            bool(np.all(array == UNTOUCHED))
            for array in self.outputs.values()
            if array.dtype != np.uint8
        )


def write_package(folder: Path, *modules: ir.Module) -> Path:
    """The C of some modules as a package directory."""
    package = folder / modules[0].name
    for module in modules:
        for path, text in c.emit(module).items():
            (package / path).parent.mkdir(parents=True, exist_ok=True)
            (package / path).write_text(text, encoding="utf-8")
    return package


def load_extension(result: build.BuildResult, key: str = "native") -> ModuleType:
    """Import an extension that was built."""
    path = result.modules[key]
    name = path.name.partition(".")[0]
    spec = spec_from_file_location(name, path, loader=ExtensionFileLoader(name, str(path)))
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@dataclass
class Library:
    """The compiled functions of one module."""

    extension: ModuleType
    prefix: str
    real: type[np.floating[Any]]

    def call(self, name: str, arguments: Sequence[object]) -> ir.Status:
        """Call a symbol with arrays, integers and None for a null pointer."""
        ffi = self.extension.ffi
        passed = []
        for argument in arguments:
            if isinstance(argument, np.ndarray):
                kinds = {np.dtype(np.int32): "int32_t[]", np.dtype(np.uint8): "uint8_t[]"}
                kind = kinds.get(
                    argument.dtype, "double[]" if self.real is np.float64 else "float[]"
                )
                passed.append(ffi.from_buffer(kind, argument))
            else:
                passed.append(ffi.NULL if argument is None else argument)
        return ir.Status(getattr(self.extension.lib, f"{self.prefix}_{name}")(*passed))

    def constant(self, name: str) -> Any:
        """A constant or table of the headers."""
        return getattr(self.extension.lib, name)

    def inputs(self, function: ir.Function, values: Mapping[str, Array]) -> dict[str, NDArray[Any]]:
        """Inputs in the types the C expects."""
        return {
            argument.name: np.ascontiguousarray(
                values[argument.name], np.int32 if argument.integer else self.real
            ).ravel()
            for argument in function.arguments
        }

    def evaluate(
        self,
        function: ir.Function,
        values: Mapping[str, Array],
        n: int = 0,
        *,
        variant: str = "",
        reference: int | None = None,
    ) -> Outcome:
        """Call an entry point for one epoch."""
        given = list(self.inputs(function, values).values())
        mapped = function.maximum is not None
        items = function.maximum or 0
        arguments: list[object] = [given[0], *([n] if mapped else [])]
        arguments += [] if reference is None else [reference]
        arguments += given[1:]
        outputs: dict[str, NDArray[Any]] = {}
        for output in function.outputs:
            jacobian = output.name.startswith("jacobian")
            if (variant == "_value" and jacobian) or (variant == "_jacobian" and not jacobian):
                continue
            sparse = variant == "_nz" and jacobian
            size = len(output.entries) if sparse else prod(output.shape)
            rows = items - (reference is not None)
            count = size * rows if mapped and output.item else size
            outputs[output.name] = np.full(count, UNTOUCHED, self.real)
        if mapped:
            outputs["item_status"] = np.full(items, UNTOUCHED_BYTE, np.uint8)
        status = self.call(function.name + variant, [*arguments, *outputs.values()])
        return Outcome(status, outputs)

    def border(self, function: ir.Function, values: Mapping[str, Array], n: int = 0) -> Outcome:
        """Call the function that checks inputs."""
        first, *rest = self.inputs(function, values).values()
        outputs: dict[str, NDArray[Any]] = {}
        count: list[object] = []
        if function.maximum is not None:
            outputs["item_status"] = np.full(function.maximum, UNTOUCHED_BYTE, np.uint8)
            count = [n]
        status = self.call(f"{function.name}_check", [first, *count, *rest, *outputs.values()])
        return Outcome(status, outputs)

    def batch(
        self,
        function: ir.Function,
        values: Sequence[Mapping[str, Array]],
        n: int = 0,
        *,
        common: Sequence[str] = (),
        nonzeros: bool = False,
    ) -> Outcome:
        """Call an entry point for many epochs; some arguments may be common to all of them."""
        epochs = len(values)
        mapped = function.maximum is not None
        listed = [self.inputs(function, one) for one in values]
        arguments: list[object] = [epochs]
        for place, argument in enumerate(function.arguments):
            if argument.name in common:
                arguments += [listed[0][argument.name], 0]
            else:
                # A gap between epochs shows that steps are respected.
                kind = np.int32 if argument.integer else self.real
                rows = [np.append(one[argument.name], kind(0)) for one in listed]
                stacked = np.concatenate([*rows, np.zeros(1, kind)])
                arguments += [stacked, len(rows[0]) if rows else 0]
            arguments += [n] if mapped and place == 0 else []
        outputs: dict[str, NDArray[Any]] = {}
        for output in function.outputs:
            items = (n,) if mapped and output.item else ()
            shape = (*items, *output.shape)
            if nonzeros and output.name.startswith("jacobian"):
                if not output.entries:
                    continue
                shape = (len(output.entries), *items)
            outputs[output.name] = np.full((epochs, *shape), UNTOUCHED, self.real)
        outputs["status"] = np.full(epochs, UNTOUCHED_BYTE, np.uint8)
        if mapped:
            outputs["item_status"] = np.full((epochs, n), UNTOUCHED_BYTE, np.uint8)
        suffix = "_batch_nz" if nonzeros else "_batch"
        status = self.call(f"{function.name}{suffix}", [*arguments, *outputs.values()])
        return Outcome(status, outputs)

    def lanes(self, function: ir.Function) -> int:
        """Epochs side by side in a block."""
        name = f"{self.prefix}_{function.name}_LANES".upper()
        return int(self.constant(name))

    def blocks(
        self, function: ir.Function, values: Sequence[Mapping[str, Array]], spare: float = np.nan
    ) -> Outcome:
        """Call the entry point for blocks of epochs; outputs come back with an epoch a row.

        Args:
            function: not mapped.
            values: inputs of every epoch.
            spare: what stands in lanes behind the last epoch.
        """
        lanes, epochs = self.lanes(function), len(values)
        blocks = -(-epochs // lanes)
        listed = [self.inputs(function, one) for one in values]
        arguments: list[object] = [epochs]
        for argument in function.arguments:
            kind = np.int32 if argument.integer else self.real
            filling = 2**31 - 1 if argument.integer else spare
            array = np.full((blocks, argument.size, lanes), filling, kind)
            for epoch, one in enumerate(listed):
                array[epoch // lanes, :, epoch % lanes] = one[argument.name]
            arguments.append(array)
        outputs: dict[str, NDArray[Any]] = {}
        for output in function.outputs:
            sparse = output.name.startswith("jacobian")
            size = len(output.entries) if sparse else prod(output.shape)
            if size or not sparse:
                outputs[output.name] = np.full((blocks, size, lanes), UNTOUCHED, self.real)
        outputs["status"] = np.full(blocks * lanes, UNTOUCHED_BYTE, np.uint8)
        status = self.call(f"{function.name}_blocks", [*arguments, *outputs.values()])
        assert np.all(outputs["status"][epochs:] == UNTOUCHED_BYTE)
        for name, array in outputs.items():
            if name != "status":
                rows = array.transpose(0, 2, 1).reshape(blocks * lanes, array.shape[1])
                assert np.all(rows[epochs:] == UNTOUCHED)
                outputs[name] = rows[:epochs]
        outputs["status"] = outputs["status"][:epochs]
        return Outcome(status, outputs)
