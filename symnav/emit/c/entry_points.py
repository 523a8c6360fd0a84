"""Entry points of a function that is not mapped: load, kernel, store."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.blocks import Blocks
from symnav.emit.c.entries import EntryPoint, has_nonzeros, variants
from symnav.emit.c.interface import Interface
from symnav.emit.c.kernel import Kernel
from symnav.emit.c.pieces import Routine, call
from symnav.emit.c.store import Store, Use, is_jacobian, stores_of
from symnav.emit.templates import render


@dataclass(frozen=True, slots=True)
class Single:
    """The source file of a function that is not mapped.

    Attributes:
        kernel: what the entry points call.
        batches: True when there are entry points for many epochs.
    """

    kernel: Kernel
    batches: bool

    def entry_points(self) -> list[EntryPoint]:
        """Public symbols in the order of the header."""
        interface = Interface(self.kernel)
        function, symbol = self.kernel.function, self.kernel.symbol
        arguments = interface.arguments()
        listed = [
            EntryPoint(
                symbol + suffix,
                f"{function.title}{': ' + meaning if meaning else ''}.",
                (*arguments, *interface.outputs(outputs)),
                full=not suffix,
            )
            for suffix, meaning, outputs in variants(function)
        ]
        if has_nonzeros(function):
            brief = f"{function.title}: values and structural non-zeros of the Jacobians."
            parameters = (*arguments, *interface.nonzero_outputs())
            listed.append(EntryPoint(f"{symbol}_nz", brief, parameters))
        return [*listed, *(Blocks(self.kernel).entry_points() if self.batches else [])]

    def source(self, banner: Sequence[str]) -> str:
        """Text of the source file."""
        entries = {entry.symbol: entry for entry in self.entry_points()}
        symbol, function = self.kernel.symbol, self.kernel.function
        calls = [
            self._call_context(entries[symbol + suffix], self._dense_stores(outputs))
            for suffix, _, outputs in variants(function)
        ]
        if has_nonzeros(function):
            calls.append(self._call_context(entries[f"{symbol}_nz"], self._nonzero_stores()))
        return render(
            "c/function.c.j2",
            banner=banner,
            target=self.kernel.target,
            symbol=symbol,
            routines=self._routines(),
            load_fails=self.kernel.inputs.can_fail(item=False),
            kernel_fails=self.kernel.shared_fails,
            calls=calls,
            blocks=Blocks(self.kernel).context(entries) if self.batches else None,
        )

    def _routines(self) -> list[Routine]:
        outputs = self.kernel.function.outputs
        puts = [
            store.putting()
            for store in stores_of(self.kernel, self.kernel.results, Use.DENSE)
            if self.batches or is_jacobian(store.output)
        ]
        uses = (Use.DENSE, Use.STACKED) if self.batches else (Use.DENSE,)
        fills = {
            store.fill: store.filling()
            for use in uses
            for store in stores_of(self.kernel, outputs, use)
        }
        blocks = Blocks(self.kernel).routines() if self.batches else []
        return [*puts, *blocks, *fills.values()]

    def _dense_stores(self, outputs: Sequence[ir.Output]) -> list[str]:
        return [
            self._fill(store, "1", store.output.name)
            for store in stores_of(self.kernel, outputs, Use.DENSE)
        ]

    def _nonzero_stores(self) -> list[str]:
        lines: list[str] = []
        for store in stores_of(self.kernel, self.kernel.function.outputs, Use.DENSE):
            name = store.output.name
            if not is_jacobian(store.output):
                lines.append(self._fill(store, "1", name))
            elif store.count:
                lines.append(self._put(store, "1", f"{name}_nz"))
        return lines

    def _fill(self, store: Store, stride: str, dense: str) -> str:
        name = store.output.name
        arguments = [f"out.{name}"] if store.count else []
        arguments += [stride] if store.count > 1 else []
        arguments += [self.kernel.inputs.place(slot, pointers=False) for slot in store.slots]
        return call(store.fill, [*arguments, dense]) + ";"

    def _put(self, store: Store, stride: str, nonzeros: str) -> str:
        arguments = ["&out", *([stride] if store.count > 1 else []), nonzeros]
        return call(store.put, arguments) + ";"

    def _call_context(self, entry: EntryPoint, stores: Sequence[str]) -> dict[str, object]:
        names = [argument.name for argument in self.kernel.function.arguments]
        depth = 3 if self._can_fail else 2
        target = self.kernel.target
        return {
            "head": entry.prototype(f"{target.macro}_NARROW {target.status}"),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "locals": self._locals(),
            "load": self._load(names),
            "evaluate": self._evaluate(),
            "stores": [line for store in stores for line in comments.code(store, depth=depth)],
        }

    @property
    def _can_fail(self) -> bool:
        """True when a call with its pointers can refuse to store."""
        return self.kernel.inputs.can_fail(item=False) or self.kernel.shared_fails

    def _locals(self) -> list[str]:
        struct = self.kernel.inputs.struct(item=False)
        lines = [f"{struct.name} in;"] if struct else []
        return [*lines, f"{self.kernel.output_struct.name} out;"]

    def _load(self, sources: Sequence[str]) -> str:
        struct = self.kernel.inputs.struct(item=False)
        stride = ["1"] if self.kernel.inputs.load_stride else []
        return call(f"{self.kernel.local}_load", [*sources, *stride, *(["&in"] if struct else [])])

    def _evaluate(self) -> str:
        given = ["&in"] if self.kernel.main_reads_input else []
        return call(f"{self.kernel.local}_kernel", [*given, "&out"])
