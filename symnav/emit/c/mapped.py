"""Entry points of a function mapped over items: any number of satellites up to a maximum.

The non-zeros of an item are computed for several items side by side: straight into the caller's
columns where only non-zeros are stored, else into a small block on the stack from which full rows
are filled. What all items share is computed, and checked, once before.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import prod

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.entry_points import EntryPoint, has_nonzeros, variants
from symnav.emit.c.inputs import INPUT_POINTER, ITEM_POINTER
from symnav.emit.c.interface import EPOCHS, Interface
from symnav.emit.c.kernel import OUTPUT_POINTER, SHARED_POINTER, Kernel, slots_of
from symnav.emit.c.pieces import Field, Routine, Struct, call, head
from symnav.emit.c.store import Store, Use, is_jacobian, stores_of
from symnav.emit.templates import render

LANES = 16


@dataclass(frozen=True, slots=True)
class Mapped:
    """The source file of a mapped function."""

    kernel: Kernel

    @property
    def lanes_macro(self) -> str:
        """Macro that holds the items side by side in one block."""
        return f"{self.kernel.symbol.upper()}_LANES"

    @property
    def fallible(self) -> bool:
        """True when an item can fail: something about it is checked."""
        function = self.kernel.function
        return function.guarded or any(a.integer for a in function.arguments if a.item)

    @property
    def rejects(self) -> bool:
        """True when one bad item fails the call."""
        return self.fallible and self.kernel.function.items is ir.Items.REJECT

    @property
    def skips(self) -> bool:
        """True when a bad item has a row of zeros."""
        return self.fallible and not self.rejects

    def entry_points(self) -> list[EntryPoint]:
        """Public symbols in the order of the header."""
        interface = Interface(self.kernel)
        function, symbol = self.kernel.function, self.kernel.symbol
        arguments, status = interface.arguments(), interface.item_status()
        listed = [
            EntryPoint(
                symbol + suffix,
                f"{function.title}{': ' + meaning if meaning else ''}.",
                (*arguments, *interface.outputs(outputs), *status),
                full=not suffix,
            )
            for suffix, meaning, outputs in variants(function)
        ]
        if has_nonzeros(function):
            brief = f"{function.title}: values and structural non-zeros of the Jacobians."
            parameters = (*arguments, *interface.nonzero_outputs(), *status)
            listed.append(EntryPoint(f"{symbol}_nz", brief, parameters))
        parameters = (EPOCHS, *interface.stepped_arguments(), *interface.stacked_outputs())
        brief = f"{function.title}: many epochs in one call, the same number of items in each."
        listed.append(EntryPoint(f"{symbol}_batch", brief, parameters))
        return listed

    def source(self, banner: Sequence[str]) -> str:
        """Text of the source file."""
        entries = {entry.symbol: entry for entry in self.entry_points()}
        symbol, function = self.kernel.symbol, self.kernel.function
        kinds = variants(function)
        stacked = self._stacks_by_row()
        rows = [self._rows(suffix, outputs, Use.DENSE) for suffix, _, outputs in kinds]
        rows += [self._rows("", function.outputs, Use.STACKED)] if stacked else []
        return render(
            "c/mapped_function.c.j2",
            banner=banner,
            target=self.kernel.target,
            symbol=symbol,
            limit=Interface(self.kernel).limit,
            lanes=LANES,
            lanes_macro=self.lanes_macro,
            block=self._block(),
            routines=self._routines(),
            fallible=self.fallible,
            rejects=self.rejects,
            skips=self.skips,
            check=self._check() if self.rejects else None,
            lanes_routines=[self._lanes(suffix, outputs) for suffix, _, outputs in kinds],
            prologue=self.prologue(),
            check_call=self._check_call(),
            rows=rows,
            calls=[
                self._public(entries[symbol + suffix], f"{self.kernel.local}_rows{suffix}")
                for suffix, _, _ in kinds
            ],
            columns=self._columns(entries[f"{symbol}_nz"]) if has_nonzeros(function) else None,
            batch=self._batch(entries[f"{symbol}_batch"], by_row=stacked),
        )

    def prologue(self) -> dict[str, object]:
        """Locals and calls that prepare what all items share."""
        kernel = self.kernel
        shared_arguments = [a.name for a in kernel.function.arguments if not a.item]
        struct, shared = kernel.inputs.struct(item=False), kernel.shared_struct
        given = [f"&{INPUT_POINTER}"] if struct else []
        read = given if kernel.main_reads_input else []
        made = [f"&{SHARED_POINTER}"] if shared else []
        return {
            "locals": [
                *([f"{struct.name} {INPUT_POINTER};"] if struct else []),
                *([f"{shared.name} {SHARED_POINTER};"] if shared else []),
            ],
            "load": call(f"{kernel.local}_load", [*shared_arguments, *given]),
            "evaluate": call(f"{kernel.local}_shared", [*read, *made]),
        }

    def context(self, *, address: bool) -> list[str]:
        """What a loop over items needs of the shared part, as arguments of a call."""
        mark = "&" if address else ""
        names = [f"{mark}{INPUT_POINTER}"] if self.kernel.item_reads_input else []
        return [*names, *([f"{mark}{SHARED_POINTER}"] if self.kernel.item_reads_shared else [])]

    def items_from(self, first: str) -> list[str]:
        """The item arguments from one item on."""
        return [
            f"&{argument.name}[{scaled(argument.size, first)}]" for argument in self._item_arguments
        ]

    def fills(
        self, outputs: Iterable[ir.Output], use: Use, row: str, *, block: str = "block"
    ) -> list[str]:
        """Statements that fill the rows of one lane."""
        lines: list[str] = []
        for store in stores_of(self.kernel, self._per_item(outputs), use):
            arguments = [f"&{block}.{store.output.name}[lane]"] if store.count else []
            arguments += [self.lanes_macro] if store.count > 1 else []
            arguments += [self.slot_value(slot, block, "lane") for slot in store.slots]
            arguments.append(self.row(store, row))
            lines.append(call(store.fill, arguments) + ";")
        return lines

    def clears(self, outputs: Iterable[ir.Output], use: Use, row: str) -> list[str]:
        """Statements that write zero rows."""
        return [
            call(store.clear, [self.row(store, row)]) + ";"
            for store in stores_of(self.kernel, self._per_item(outputs), use)
        ]

    def common_fills(self, outputs: Iterable[ir.Output], use: Use) -> list[str]:
        """Statements that store what does not depend on the item."""
        chosen = [output for output in outputs if not output.item]
        return [
            call(
                store.fill,
                [
                    *([f"{SHARED_POINTER}.{store.output.name}"] if store.count else []),
                    *(["1"] if store.count > 1 else []),
                    store.output.name,
                ],
            )
            + ";"
            for store in stores_of(self.kernel, chosen, use)
        ]

    def slot_value(self, slot: ir.Load, block: str, lane: str) -> str:
        """The slot of an item, or of the call where it is not per item."""
        element = self.kernel.inputs.table[slot]
        if element.argument.item:
            return f"{block}.{element.field}[{lane}]"
        return f"{INPUT_POINTER}.{element.field}"

    @staticmethod
    def row(store: Store, item: str) -> str:
        """Address of the row of an item in a dense output."""
        return f"&{store.output.name}[{scaled(store.layout.item or 1, item)}]"

    def statements(self, texts: Iterable[str], depth: int) -> list[str]:
        """Statements, wrapped."""
        return [line for text in texts for line in comments.code(text, depth=depth)]

    @property
    def _item_arguments(self) -> list[ir.Argument]:
        return [argument for argument in self.kernel.function.arguments if argument.item]

    @property
    def _item_slots(self) -> list[ir.Load]:
        table = self.kernel.inputs.table
        return [slot for slot in self.kernel.slots if table[slot].argument.item]

    def _stacks_by_row(self) -> bool:
        outputs = self.kernel.function.outputs
        return any(store.suffix for store in stores_of(self.kernel, outputs, Use.STACKED))

    @staticmethod
    def _per_item(outputs: Iterable[ir.Output]) -> list[ir.Output]:
        return [output for output in outputs if output.item]

    def _block(self) -> Struct:
        kernel = self.kernel
        fields = [
            Field(kernel.target.real, output.name, f"{len(output.entries)} * {self.lanes_macro}")
            for output in kernel.results
        ]
        fields += [
            Field("int32_t", kernel.inputs.table[slot].field, self.lanes_macro)
            for slot in self._item_slots
        ]
        if self.fallible:
            fields.append(Field("flag_t", "status", self.lanes_macro))
        brief = "Non-zeros of a block of items, each stored contiguously across the items."
        return Struct(f"{kernel.local}_block_t", brief, tuple(fields))

    def _routines(self) -> list[Routine]:
        kernel, function = self.kernel, self.kernel.function
        puts = [store.putting() for store in stores_of(kernel, kernel.results, Use.DENSE)]
        uses = [Use.DENSE, Use.STACKED]
        fills = {
            store.fill: store.filling()
            for use in uses
            for store in stores_of(kernel, function.outputs, use)
        }
        uses += [Use.DIFFERENCED] if function.single_difference else []
        clears = {
            store.clear: store.clearing()
            for use in uses
            for store in stores_of(kernel, self._per_item(function.outputs), use)
        }
        return [*puts, *fills.values(), *(clears.values() if self.skips else ())]

    def _loop_head(self, name: str, result: str, last: Sequence[str]) -> tuple[str, ...]:
        """Head of a function that loops over items."""
        kernel = self.kernel
        restrict = f"{kernel.target.macro}_RESTRICT"
        struct, shared = kernel.inputs.struct(item=False), kernel.shared_struct
        declarations: list[str] = []
        if kernel.item_reads_input:
            declarations.append(f"const {struct.name} *{restrict} {INPUT_POINTER}")
        if kernel.item_reads_shared:
            declarations.append(f"const {shared.name} *{restrict} {SHARED_POINTER}")
        declarations.append("int32_t count")
        for argument in self._item_arguments:
            kind = "int32_t" if argument.integer else kernel.target.real
            declarations.append(f"const {kind} {argument.name}[{restrict}]")
        return head(result, name, [*declarations, *last])

    def _evaluation(self, place: str) -> dict[str, object]:
        """Locals and calls for one item in a loop."""
        kernel = self.kernel
        item = kernel.inputs.struct(item=True)
        copy = [f"&{ITEM_POINTER}"] if item else []
        read = copy if kernel.item_reads_item else []
        load = call(f"{kernel.local}_load_item", [*self.items_from(place), *copy])
        evaluate = call(
            f"{kernel.local}_item",
            [*self.context(address=False), *read, f"&{OUTPUT_POINTER}"],
        )
        return {
            "locals": [
                *([f"{item.name} {ITEM_POINTER};"] if item else []),
                f"{kernel.output_struct.name} {OUTPUT_POINTER};",
            ],
            "load": comments.code(f"{self._kept('loaded')}{load};", depth=2),
            "evaluate": comments.code(f"{self._kept('evaluated')}{evaluate};", depth=2),
        }

    def _kept(self, name: str) -> str:
        """What stands in front of a call whose verdict matters only where items can fail."""
        return f"const flag_t {name} = " if self.fallible else "(void)"

    def _lanes(self, suffix: str, outputs: Sequence[ir.Output]) -> dict[str, object]:
        kernel = self.kernel
        block = f"{self._block().name} *{kernel.target.macro}_RESTRICT block"
        chosen = [output for output in kernel.results if output in outputs]
        puts = [
            call(
                store.put,
                [
                    f"&{OUTPUT_POINTER}",
                    *([self.lanes_macro] if store.count > 1 else []),
                    f"&block->{store.output.name}[lane]",
                ],
            )
            + ";"
            for store in stores_of(kernel, chosen, Use.DENSE)
        ]
        puts += [
            f"block->{kernel.inputs.table[slot].field}[lane] = "
            f"{kernel.inputs.place(slot, pointers=False)};"
            for slot in self._item_slots
            if any(slot in slots_of(output) for output in chosen)
        ]
        return {
            "head": self._loop_head(
                f"{kernel.local}_lanes{suffix}", f"static {kernel.target.macro}_WIDE void", [block]
            ),
            **self._evaluation("lane"),
            "puts": self.statements(puts, 2),
        }

    def _check(self) -> dict[str, object]:
        status = f"uint8_t item_status[{self.kernel.target.macro}_RESTRICT]"
        result = f"static {self.kernel.target.status}"
        name = f"{self.kernel.local}_check_items"
        return {"head": self._loop_head(name, result, [status]), **self._evaluation("i")}

    def _check_call(self) -> str:
        arguments = [*self.context(address=True), "n", *(a.name for a in self._item_arguments)]
        return call(f"{self.kernel.local}_check_items", [*arguments, "item_status"])

    def lanes_call(self, suffix: str, first: str, count: str, block: str) -> str:
        """Call that evaluates some items into a block."""
        arguments = [*self.context(address=True), count, *self.items_from(first)]
        return call(f"{self.kernel.local}_lanes{suffix}", [*arguments, f"&{block}"]) + ";"

    def _rows(self, suffix: str, outputs: Sequence[ir.Output], use: Use) -> dict[str, object]:
        """The function behind a dense entry point, for pointers and counts known to be good."""
        interface = Interface(self.kernel)
        name = f"{self.kernel.local}_rows{suffix}{'_by_row' if use is Use.STACKED else ''}"
        parameters = [
            *interface.arguments(),
            *interface.outputs(outputs),
            *interface.item_status(),
        ]
        declarations = [parameter.declaration for parameter in parameters]
        return {
            "head": head(f"static {self.kernel.target.status}", name, declarations),
            "lanes": comments.code(self.lanes_call(suffix, "first", "count", "block"), depth=3),
            "common": self.statements(self.common_fills(outputs, use), 2),
            "fills": self.statements(self.fills(outputs, use, "i"), 5 if self.skips else 4),
            "clears": self.statements(self.clears(outputs, use, "i"), 5),
        }

    def _public(self, entry: EntryPoint, inner: str) -> dict[str, object]:
        names = [parameter.name for parameter in entry.parameters]
        return {
            "head": entry.prototype(self.kernel.target.status),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "call": comments.code(f"status = {call(inner, names)};", depth=3),
        }

    def _columns(self, entry: EntryPoint) -> dict[str, object]:
        """The entry point that stores non-zeros, column by column across the items."""
        kernel, limit = self.kernel, Interface(self.kernel).limit
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
        codes = [f"flag_t codes[{kernel.target.macro}_RESTRICT]"] if self.fallible else []
        name = f"{kernel.local}_columns"
        passed = [
            *self.context(address=True),
            "n",
            *(argument.name for argument in self._item_arguments),
            *(_column_name(store.output) for store in stores),
            *(["codes"] if self.fallible else []),
        ]
        return {
            "head": entry.prototype(f"{kernel.target.macro}_WIDE {kernel.target.status}"),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "loop_head": self._loop_head(
                name, f"{kernel.target.macro}_INLINE void", [*parameters, *codes]
            ),
            **self._evaluation("i"),
            "stores": self.statements((self._column_store(s, limit) for s in stores), 2),
            "call": comments.code(call(name, passed) + ";", depth=4),
            "common": self.statements(self._common_columns(), 4),
            "clears": [line for s in stores for line in self._column_clear(s, limit)],
        }

    def _column_store(self, store: Store, limit: str) -> str:
        name = store.output.name
        if is_jacobian(store.output):
            stride = [limit] if store.count > 1 else []
            return call(store.put, [f"&{OUTPUT_POINTER}", *stride, f"&{name}_nz[i]"]) + ";"
        arguments = [f"{OUTPUT_POINTER}.{name}"] if store.count else []
        arguments += ["1"] if store.count > 1 else []
        arguments += [self.kernel.inputs.place(slot, pointers=False) for slot in store.slots]
        return call(store.fill, [*arguments, self.row(store, "i")]) + ";"

    def _column_clear(self, store: Store, limit: str) -> list[str]:
        if not is_jacobian(store.output):
            return self.statements([call(store.clear, [self.row(store, "i")]) + ";"], 6)
        zero = self.kernel.target.literal(0.0)
        indent = "    " * 6
        return [
            f"{indent}for (int32_t k = 0; k < {store.count}; ++k) {{",
            f"{indent}    {store.output.name}_nz[(k * {limit}) + i] = {zero};",
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

    def _batch(self, entry: EntryPoint, *, by_row: bool) -> dict[str, object]:
        kernel = self.kernel
        arguments: list[str] = []
        for argument in kernel.function.arguments:
            arguments.append(f"&{argument.name}[epoch * {argument.name}_step]")
            arguments += ["n"] if len(arguments) == 1 else []
        for output in kernel.function.outputs:
            count = scaled(prod(output.shape), "epoch")
            place = f"({count}) * n" if "*" in count else f"{count} * n"
            arguments.append(f"&{output.name}[{place if output.item else count}]")
        inner = f"{kernel.local}_rows{'_by_row' if by_row else ''}"
        text = call(inner, [*arguments, "&item_status[epoch * n]"])
        return {
            "head": entry.prototype(kernel.target.status),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "call": comments.code(f"const {kernel.target.status} outcome = {text};", depth=4),
        }


def scaled(size: int, index: str) -> str:
    """``size * index`` without needless arithmetic."""
    if size == 1 or index == "0":
        return index
    return f"{size} * {index}"


def _column_name(output: ir.Output) -> str:
    return f"{output.name}_nz" if is_jacobian(output) else output.name
