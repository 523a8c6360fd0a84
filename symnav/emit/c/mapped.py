"""Entry points of a function mapped over items: any number of satellites up to a maximum.

The non-zeros of an item are computed for several items side by side: straight into the caller's
columns where only non-zeros are stored, else into a small block on the stack from which full rows
are filled. What all items share is computed, and checked, once before.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import prod

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.ahead import argument_rows, fetches
from symnav.emit.c.columns import Columns, column_name, column_size
from symnav.emit.c.entries import EntryPoint, has_nonzeros, variants
from symnav.emit.c.inputs import INPUT_POINTER
from symnav.emit.c.interface import EPOCHS, Interface
from symnav.emit.c.items import ItemLoops, scaled
from symnav.emit.c.kernel import OUTPUT_POINTER, SHARED_POINTER, slots_of
from symnav.emit.c.pieces import Field, Routine, Struct, call, head
from symnav.emit.c.store import Use, is_jacobian, stores_of
from symnav.emit.templates import render

LANES = 16


@dataclass(frozen=True, slots=True)
class Mapped(ItemLoops):
    """The source file of a mapped function.

    Attributes:
        batches: True when there are entry points for many epochs.
    """

    batches: bool

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
        if not self.batches:
            return listed
        parameters = (EPOCHS, *interface.stepped_arguments(), *interface.stacked_outputs())
        brief = f"{function.title}: many epochs in one call, the same number of items in each."
        listed.append(EntryPoint(f"{symbol}_batch", brief, parameters))
        if has_nonzeros(function):
            outputs = interface.stacked_outputs(nonzeros=True)
            parameters = (EPOCHS, *interface.stepped_arguments(), *outputs)
            brief = f"{function.title}: values and structural non-zeros of many epochs."
            listed.append(EntryPoint(f"{symbol}_batch_nz", brief, parameters))
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
            verdict=self.verdict,
            block_status=self.status("block.failures[lane]"),
            column_status=self.status("failures[i]"),
            prologue=self.prologue(),
            begin=self.begin(),
            check_call=self.check_call(),
            rows=rows,
            calls=[
                self._public(entries[symbol + suffix], f"{self.kernel.local}_rows{suffix}")
                for suffix, _, _ in kinds
            ],
            columns=Columns(self.kernel).columns(entries) if has_nonzeros(function) else None,
            batches=self._batches(entries, by_row=stacked) if self.batches else [],
        )

    def prologue(self) -> dict[str, object]:
        """Locals and calls that prepare what all items share."""
        kernel = self.kernel
        shared_arguments = [a.name for a in kernel.function.arguments if not a.item]
        struct, shared = kernel.inputs.struct(item=False), kernel.shared_struct
        given = [f"&{INPUT_POINTER}"] if struct else []
        read = given if kernel.main_reads_input else []
        made = [f"&{SHARED_POINTER}"] if shared else []
        doubtful = kernel.inputs.can_fail(item=False) or kernel.shared_fails
        certain = f"{kernel.target.macro}_OK"
        first = self.check_call() if self.rejects and not doubtful else certain
        return {
            "locals": [
                *([f"{struct.name} {INPUT_POINTER};"] if struct else []),
                *([f"{shared.name} {SHARED_POINTER};"] if shared else []),
            ],
            "load": call(f"{kernel.local}_load", [*shared_arguments, *given]),
            "evaluate": call(f"{kernel.local}_shared", [*read, *made]),
            "load_fails": kernel.inputs.can_fail(item=False),
            "fallible": kernel.shared_fails,
            "first": first,
            "judges": self.rejects and doubtful,
            # Where only columns are stored, what cannot fail waits for what can.
            "waits": kernel.inputs.can_fail(item=False) and not kernel.shared_fails,
        }

    def begin(self) -> str:
        """What opens the part of a function that runs when nothing has failed so far."""
        kernel = self.kernel
        fails = kernel.inputs.can_fail(item=False) or kernel.shared_fails or self.rejects
        return f"if (status == {kernel.target.macro}_OK) {{" if fails else "{"

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

    def slot_value(self, slot: ir.Load, block: str, lane: str) -> str:
        """The slot of an item, or of the call where it is not per item."""
        element = self.kernel.inputs.table[slot]
        if element.argument.item:
            return f"{block}.{element.field}[{lane}]"
        return f"{INPUT_POINTER}.{element.field}"

    @property
    def _item_slots(self) -> list[ir.Load]:
        table = self.kernel.inputs.table
        return [slot for slot in self.kernel.slots if table[slot].argument.item]

    def _stacks_by_row(self) -> bool:
        outputs = self.kernel.function.outputs
        return self.batches and any(
            store.suffix for store in stores_of(self.kernel, outputs, Use.STACKED)
        )

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
        if self.skips:
            fields.append(Field("flag_t", "failures", self.lanes_macro))
        brief = "Non-zeros of a block of items, each stored contiguously across the items."
        return Struct(f"{kernel.local}_block_t", brief, tuple(fields))

    def _routines(self) -> list[Routine]:
        kernel, function = self.kernel, self.kernel.function
        puts = [store.putting() for store in stores_of(kernel, kernel.results, Use.DENSE)]
        uses = [Use.DENSE, *([Use.STACKED] if self.batches else [])]
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
        copiers = [kernel.inputs.copier(item=True)] if self.copies else []
        return [*copiers, *puts, *fills.values(), *(clears.values() if self.skips else ())]

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
            "head": self.loop_head(
                f"{kernel.local}_lanes{suffix}", f"static {kernel.target.macro}_WIDE void", [block]
            ),
            **self.evaluation("lane", passed=self.rejects),
            "puts": self.statements(puts, 2),
        }

    def _check(self) -> dict[str, object]:
        status = f"uint8_t item_status[{self.kernel.target.macro}_RESTRICT]"
        result = f"{self.kernel.target.macro}_INLINE {self.kernel.target.status}"
        name = f"{self.kernel.local}_check_items"
        return {"head": self.loop_head(name, result, [status]), **self.evaluation("i")}

    def check_call(self) -> str:
        """Call that finds the status of every item."""
        arguments = [*self.context(address=True), "n", *(a.name for a in self.item_arguments)]
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

    def _batches(
        self, entries: Mapping[str, EntryPoint], *, by_row: bool
    ) -> list[dict[str, object]]:
        """The loops over epochs: full rows, and non-zeros in columns as long as there are items."""
        local, symbol = self.kernel.local, self.kernel.symbol
        outputs = self.kernel.function.outputs
        rows = [(output.name, output, prod(output.shape)) for output in outputs]
        inner = f"{local}_rows{'_by_row' if by_row else ''}"
        batches = [self._batch(entries[f"{symbol}_batch"], inner, [], rows)]
        if has_nonzeros(self.kernel.function):
            columns = [
                (column_name(output), output, column_size(output))
                for output in outputs
                if output.entries or not is_jacobian(output)
            ]
            entry = entries[f"{symbol}_batch_nz"]
            stride = ["n"] if Columns(self.kernel).strided else []
            batches.append(self._batch(entry, f"{local}_sparse", stride, columns, wide=True))
        return batches

    def _batch(
        self,
        entry: EntryPoint,
        inner: str,
        first: Sequence[str],
        outputs: Sequence[tuple[str, ir.Output, int]],
        *,
        wide: bool = False,
    ) -> dict[str, object]:
        """One loop over epochs; rows are asked for ahead, columns are quick to come anyhow."""
        kernel = self.kernel
        arguments: list[str] = []
        for argument in kernel.function.arguments:
            arguments.append(f"&{argument.name}[epoch * {argument.name}_step]")
            arguments += ["n"] if len(arguments) == 1 else []
        arguments += [f"&{name}[{_row(output, size, 'epoch')}]" for name, output, size in outputs]
        text = call(inner, [*first, *arguments, "&item_status[epoch * n]"])
        written = [
            (name, scaled(size, "n") if output.item else str(size), _row(output, size, "next"))
            for name, output, size in outputs
        ]
        clones = f"{kernel.target.macro}_WIDE " if wide else ""
        return {
            "head": entry.prototype(f"{clones}{kernel.target.status}"),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "ahead": []
            if wide
            else fetches([*argument_rows(kernel.function.arguments, "next"), *written], depth=5),
            "call": comments.code(f"const {kernel.target.status} outcome = {text};", depth=4),
        }


def _row(output: ir.Output, size: int, epoch: str) -> str:
    """Where an epoch begins in an output, which has ``size`` numbers for each item or epoch."""
    count = scaled(size, epoch)
    if not output.item:
        return count
    return f"({count}) * n" if "*" in count else f"{count} * n"
