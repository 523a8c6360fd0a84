"""Non-zeros of a mapped function straight into the caller's columns, one for each non-zero.

Columns are contiguous across the items, a stride apart: the declared maximum in a call for one
epoch, the number of items in a call for many.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import prod

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.entries import EntryPoint
from symnav.emit.c.interface import Interface
from symnav.emit.c.items import ItemLoops
from symnav.emit.c.kernel import OUTPUT_POINTER, SHARED_POINTER
from symnav.emit.c.pieces import call, head
from symnav.emit.c.store import Store, Use, is_jacobian, stores_of


@dataclass(frozen=True, slots=True)
class Columns(ItemLoops):
    """What the source file of a mapped function says about columns."""

    @property
    def strided(self) -> bool:
        """True when an item has several non-zeros, which are then a stride apart."""
        outputs = self.kernel.function.outputs
        return any(o.item and is_jacobian(o) and len(o.entries) > 1 for o in outputs)

    def columns(self, entries: Mapping[str, EntryPoint]) -> dict[str, object]:
        """The entry point that stores non-zeros, column by column across the items."""
        kernel, limit = self.kernel, Interface(self.kernel).limit
        entry = entries[f"{kernel.symbol}_nz"]
        stride, most = (["int32_t stride"], [limit]) if self.strided else ([], [])
        outputs = [output for output in kernel.function.outputs if output.item]
        stores = [
            store
            for store in stores_of(kernel, outputs, Use.DENSE)
            if store.count or not is_jacobian(store.output)
        ]
        parameters = [
            parameter.declaration
            for parameter in entry.parameters
            if parameter.direction == "out"
            and parameter.name.removesuffix("_nz") in {store.output.name for store in stores}
        ]
        failures = [f"flag_t failures[{kernel.target.macro}_RESTRICT]"] if self.skips else []
        name = f"{kernel.local}_columns"
        result = "flag_t" if self.skips else "void"
        kept = "const flag_t failed = " if self.skips else ""
        passed = [
            *(["stride"] if self.strided else []),
            *self.context(address=True),
            "n",
            *(argument.name for argument in self.item_arguments),
            *(column_name(store.output) for store in stores),
            *(["failures"] if self.skips else []),
        ]
        return {
            "head": entry.prototype(f"{kernel.target.macro}_WIDE {kernel.target.status}"),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "loop_head": self.loop_head(
                name,
                f"{kernel.target.macro}_INLINE {result}",
                [*parameters, *failures],
                before=stride,
            ),
            **self.evaluation("i", passed=self.rejects),
            "stores": self.statements((self._column_store(s) for s in stores), 2),
            "sparse_head": head(
                f"{kernel.target.macro}_INLINE {kernel.target.status}",
                f"{kernel.local}_sparse",
                [*stride, *(parameter.declaration for parameter in entry.parameters)],
            ),
            "call": comments.code(f"{kept}{call(name, passed)};", depth=2),
            "common": self.statements(self._common_columns(), 2),
            "clears": [line for s in stores for line in self._column_clear(s)],
            "sparse_call": comments.code(
                "status = "
                + call(f"{kernel.local}_sparse", [*most, *(p.name for p in entry.parameters)])
                + ";",
                depth=3,
            ),
        }

    def _column_store(self, store: Store) -> str:
        name = store.output.name
        if is_jacobian(store.output):
            stride = ["stride"] if store.count > 1 else []
            return call(store.put, [f"&{OUTPUT_POINTER}", *stride, f"&{name}_nz[i]"]) + ";"
        arguments = [f"{OUTPUT_POINTER}.{name}"] if store.count else []
        arguments += ["1"] if store.count > 1 else []
        arguments += [self.kernel.inputs.place(slot, pointers=False) for slot in store.slots]
        return call(store.fill, [*arguments, self.row(store, "i")]) + ";"

    def _column_clear(self, store: Store) -> list[str]:
        if not is_jacobian(store.output):
            return self.statements([call(store.clear, [self.row(store, "i")]) + ";"], 5)
        zero = self.kernel.target.literal(0.0)
        if store.count == 1:
            return self.statements([f"{store.output.name}_nz[i] = {zero};"], 5)
        indent = "    " * 5
        return [
            f"{indent}for (int32_t k = 0; k < {store.count}; ++k) {{",
            f"{indent}    {store.output.name}_nz[(k * stride) + i] = {zero};",
            f"{indent}}}",
        ]

    def _common_columns(self) -> list[str]:
        lines: list[str] = []
        for store in stores_of(self.kernel, self.kernel.common, Use.DENSE):
            name = store.output.name
            if not is_jacobian(store.output):
                lines += self.common_fills([store.output], Use.DENSE)
                continue
            lines += [f"{name}_nz[{k}] = {SHARED_POINTER}.{name}[{k}];" for k in range(store.count)]
        return lines


def column_name(output: ir.Output) -> str:
    """What the memory of an output is called where only non-zeros are stored."""
    return f"{output.name}_nz" if is_jacobian(output) else output.name


def column_size(output: ir.Output) -> int:
    """Elements that one epoch stores, of each item where there are items."""
    return len(output.entries) if is_jacobian(output) else prod(output.shape)
