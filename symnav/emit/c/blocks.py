"""Many epochs in one call: blocks of epochs side by side, which the compiler runs in vectors.

A block is an array of structures of arrays: element k of lane l of block b of an argument of
SIZE elements stands at ``[(b * SIZE + k) * LANES + l]``. Arrays that lie like this already are
read and written in place. Arrays by row are laid side by side in a block on the stack first.

A block is checked first and evaluated afterwards: where every lane passes, which is the rule, the
arithmetic reads what was checked without looking again, and the outputs of lanes that fail stay
as they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.ahead import fetches
from symnav.emit.c.entries import EntryPoint, has_nonzeros
from symnav.emit.c.inputs import INPUT_POINTER
from symnav.emit.c.interface import EPOCHS, Interface
from symnav.emit.c.items import scaled
from symnav.emit.c.kernel import OUTPUT_POINTER, Kernel
from symnav.emit.c.pieces import Field, Parameter, Routine, Struct, call, head
from symnav.emit.c.store import Store, Use, is_jacobian, stores_of
from symnav.emit.lanes import block_size


@dataclass(frozen=True, slots=True)
class Blocks:
    """What the source file of a function that is not mapped says about many epochs."""

    kernel: Kernel

    @property
    def macro(self) -> str:
        """Macro that holds the epochs side by side in one block."""
        return f"{self.kernel.symbol.upper()}_LANES"

    def entry_points(self) -> list[EntryPoint]:
        """Public symbols in the order of the header."""
        interface, kernel = Interface(self.kernel), self.kernel
        title, symbol = kernel.function.title, kernel.symbol
        stepped = (EPOCHS, *interface.stepped_arguments())
        listed = [
            EntryPoint(
                f"{symbol}_batch",
                f"{title}: many epochs in one call.",
                (*stepped, *interface.stacked_outputs()),
            )
        ]
        if has_nonzeros(kernel.function):
            listed.append(
                EntryPoint(
                    f"{symbol}_batch_nz",
                    f"{title}: values and structural non-zeros of many epochs.",
                    (*stepped, *interface.stacked_outputs(nonzeros=True)),
                )
            )
        listed.append(
            EntryPoint(
                f"{symbol}_blocks",
                f"{title}: many epochs that lie side by side in blocks.",
                (EPOCHS, *self._arguments(), *self._results()),
                remark=(
                    "Element k of lane l of block b of an array of SIZE elements per epoch stands "
                    f"at [(b * SIZE + k) * L + l], L = {self.macro}; epoch e is lane e % L of "
                    "block e / L. Lanes behind the last epoch are neither read nor written, nor "
                    "are outputs of an epoch whose status is not OK."
                ),
            )
        )
        return listed

    def helpers(self) -> set[str]:
        """Names of the inline helpers the source file calls."""
        inputs = self.kernel.inputs.lanes
        fails = self.kernel.fallible and inputs.can_fail(item=False)
        moving = {
            "indices_to_lanes" if argument.integer else "rows_to_lanes"
            for argument in self.kernel.function.arguments
            if inputs.runs(argument)
        }
        checking = inputs.helpers() | ({"first_failure"} if fails else set())
        return moving | checking | {"lanes_to_rows"}

    def routines(self) -> list[Routine]:
        """Functions that load side by side, copy what was checked, and store values in full."""
        inputs = self.kernel.inputs.lanes
        loaders = [inputs.loader(item=False)] if inputs.checked else []
        copies = self._copies and inputs.copied_arguments(item=False)
        copiers = [inputs.copier(item=False)] if copies else []
        spreads = [store.spreading() for store in self._value_stores() if not store.complete]
        return [*loaders, *copiers, *spreads]

    def context(self, entries: dict[str, EntryPoint]) -> dict[str, object]:
        """What the template says about many epochs."""
        kernel, symbol = self.kernel, self.kernel.symbol
        target = kernel.target
        nonzeros = entries.get(f"{symbol}_batch_nz")
        return {
            "macro": self.macro,
            "fallible": kernel.fallible,
            "struct": self._struct(),
            "check": self._check() if kernel.fallible else None,
            "evaluate": self._evaluate(),
            "block_head": head(
                f"static {target.status}",
                f"{kernel.local}_block",
                ["int32_t count", *self._declarations(self._arguments()), *self._written()],
            ),
            "check_call": self._statement(
                call(f"{kernel.local}_check_lanes", ["count", *self._names, "codes"]),
                before="const flag_t failed = ",
                depth=1,
            ),
            "whole": self._statement(self._evaluate_call("count", ""), depth=2),
            "single": self._statement(self._evaluate_call("1", "lane"), depth=4),
            "blocks": self._blocks(entries[f"{symbol}_blocks"]),
            "gather": self._gather(),
            "batches": [
                self._batch(entries[f"{symbol}_batch"], nonzeros=False),
                *([self._batch(nonzeros, nonzeros=True)] if nonzeros else []),
            ],
        }

    @property
    def _outputs(self) -> list[ir.Output]:
        """Values in full and Jacobians with non-zeros."""
        return [
            output
            for output in self.kernel.function.outputs
            if output.entries or not is_jacobian(output)
        ]

    @property
    def _names(self) -> list[str]:
        return [argument.name for argument in self.kernel.function.arguments]

    @staticmethod
    def _name(output: ir.Output) -> str:
        return f"{output.name}_nz" if is_jacobian(output) else output.name

    def _arguments(self) -> list[Parameter]:
        return Interface(self.kernel).blocked_arguments()

    def _results(self) -> list[Parameter]:
        return Interface(self.kernel).blocked_outputs()

    @staticmethod
    def _declarations(parameters: Sequence[Parameter]) -> list[str]:
        return [parameter.declaration for parameter in parameters]

    def _written(self) -> list[str]:
        return self._declarations(self._results())

    def _statement(self, text: str, *, before: str = "", depth: int) -> list[str]:
        return comments.code(f"{before}{text};", depth=depth)

    def _struct(self) -> Struct:
        real = self.kernel.target.real
        fields = [
            Field(
                "int32_t" if argument.integer else real,
                argument.name,
                f"{argument.size} * {self.macro}",
            )
            for argument in self.kernel.function.arguments
            if self.kernel.inputs.runs(argument)
        ]
        fields += [
            Field(real, self._name(output), f"{block_size(output)} * {self.macro}")
            for output in self._outputs
        ]
        return Struct(f"{self.kernel.local}_block_t", "A block of epochs.", tuple(fields))

    def _locals(self) -> list[str]:
        struct = self.kernel.inputs.struct(item=False)
        lines = [f"{struct.name} {INPUT_POINTER};"] if struct else []
        return [*lines, f"{self.kernel.output_struct.name} {OUTPUT_POINTER};"]

    def _kernel_call(self) -> str:
        given = [f"&{INPUT_POINTER}"] if self.kernel.main_reads_input else []
        return call(f"{self.kernel.local}_kernel", [*given, f"&{OUTPUT_POINTER}"])

    def _loop_head(
        self, result: str, name: str, arguments: Sequence[str], last: Sequence[str]
    ) -> tuple[str, ...]:
        """Head of a function that loops over lanes."""
        chosen = [p.declaration for p in self._arguments() if p.name in arguments]
        return head(
            f"static {self.kernel.target.macro}_WIDE {result}",
            f"{self.kernel.local}_{name}",
            ["int32_t count", *chosen, *last],
        )

    def _check(self) -> dict[str, object]:
        """Status of every lane of a block."""
        kernel = self.kernel
        restrict = f"{kernel.target.macro}_RESTRICT"
        inputs = kernel.inputs.lanes
        fails = inputs.can_fail(item=False)
        given = [f"&{name}[lane]" for name in self._names]
        given += [self.macro] if inputs.load_stride else []
        given += [f"&{INPUT_POINTER}"] if inputs.struct(item=False) else []
        return {
            "head": self._loop_head(
                "flag_t",
                "check_lanes",
                self._names,
                [f"flag_t codes[{restrict} {self.macro}]"],
            ),
            "locals": self._locals(),
            "load": self._statement(
                call(inputs.loader_name(item=False), given),
                before="const flag_t loaded = " if fails else "(void)",
                depth=2,
            ),
            "verdict": "first_failure(loaded, evaluated)" if fails else "evaluated",
            "evaluate": self._kernel_call(),
        }

    @property
    def _copies(self) -> bool:
        """True when what was checked is copied again; where nothing was, loading does that."""
        inputs = self.kernel.inputs
        return inputs.can_fail(item=False) or (self.kernel.fallible and not inputs.pointed)

    @property
    def _read(self) -> list[str]:
        """Arguments the evaluation reads."""
        inputs = self.kernel.inputs
        copied = [a.name for a in inputs.copied_arguments(item=False)]
        return copied if self._copies else self._names

    def _evaluate(self) -> dict[str, object]:
        """Results of the lanes of a block that were checked."""
        kernel, inputs = self.kernel, self.kernel.inputs.lanes
        struct = inputs.struct(item=False)
        given = [f"&{name}[lane]" for name in self._read]
        strided = inputs.copy_stride if self._copies else inputs.load_stride
        given += [self.macro] if strided else []
        copy = "copy" if self._copies else "load"
        text = call(f"{kernel.local}_{copy}", [*given, *([f"&{INPUT_POINTER}"] if struct else [])])
        void = "" if self._copies else "(void)"
        wanted = self._read or not self._copies
        stores = [line for store in self._stores() for line in self._put(store)]
        return {
            "head": self._loop_head("void", "evaluate_lanes", self._read, self._written()[:-1]),
            "locals": self._locals(),
            "load": self._statement(f"{void}{text}", depth=2) if wanted else [],
            "evaluate": self._kernel_call(),
            "stores": stores,
        }

    def _stores(self) -> list[Store]:
        return stores_of(self.kernel, self._outputs, Use.STACKED)

    def _value_stores(self) -> list[Store]:
        return [store for store in self._stores() if not is_jacobian(store.output)]

    def _put(self, store: Store) -> list[str]:
        """Statement that stores one lane of one output."""
        place = f"&{self._name(store.output)}[lane]"
        stride = [self.macro] if block_size(store.output) > 1 else []
        if is_jacobian(store.output) or store.complete:
            stride = [self.macro] if store.count > 1 else []
            text = call(store.put, [f"&{OUTPUT_POINTER}", *stride, place])
        else:
            given = [f"&{OUTPUT_POINTER}"] if store.count else []
            slots = [self.kernel.inputs.place(slot, pointers=False) for slot in store.slots]
            text = call(store.spread, [*given, *stride, *slots, place])
        return self._statement(text, depth=2)

    def _evaluate_call(self, count: str, lane: str) -> str:
        names = [*self._read, *(self._name(output) for output in self._outputs)]
        places = [f"&{name}[{lane}]" if lane else name for name in names]
        return call(f"{self.kernel.local}_evaluate_lanes", [count, *places])

    def _blocks(self, entry: EntryPoint) -> dict[str, object]:
        sizes = {argument.name: argument.size for argument in self.kernel.function.arguments}
        sizes |= {self._name(output): block_size(output) for output in self._outputs}
        places = [
            f"&{name}[first]" if size == 1 else f"&{name}[{size} * first]"
            for name, size in sizes.items()
        ]
        text = call(f"{self.kernel.local}_block", ["count", *places, "&status[first]"])
        return {
            "head": entry.prototype(self.kernel.target.status),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "call": self._statement(
                text, before=f"const {self.kernel.target.status} outcome = ", depth=3
            ),
        }

    def _gather(self) -> dict[str, object]:
        """Rows of epochs laid side by side."""
        kernel, lines = self.kernel, []
        declarations = []
        for argument in kernel.function.arguments:
            runs = kernel.inputs.runs(argument)
            if not runs:
                continue
            name = argument.name
            kind = "int32_t" if argument.integer else kernel.target.real
            restrict = f"{kernel.target.macro}_RESTRICT"
            declarations += [f"const {kind} {name}[{restrict}]", f"ptrdiff_t {name}_step"]
            helper = "indices_to_lanes" if argument.integer else "rows_to_lanes"
            for first, length in runs:
                source = f"&{name}[{first}]" if first else name
                place = f"&block->{name}[{first} * {self.macro}]" if first else f"block->{name}"
                rest = [] if argument.integer else ["rest"]
                given = ["count", *rest, source, f"{name}_step", str(length), self.macro, place]
                lines += self._statement(call(helper, given), depth=1)
        block = f"{self._struct().name} *{kernel.target.macro}_RESTRICT block"
        return {
            "head": head(
                "static void",
                f"{kernel.local}_gather",
                ["int32_t count", *self._rest("ptrdiff_t "), *declarations, block],
            ),
            "lines": lines,
        }

    def _rest(self, kind: str = "") -> list[str]:
        """How many epochs there are, of whom those behind the block are asked for."""
        arguments = self.kernel.function.arguments
        real = any(self.kernel.inputs.runs(a) for a in arguments if not a.integer)
        return [f"{kind}rest"] if real else []

    def _batch(self, entry: EntryPoint, *, nonzeros: bool) -> dict[str, object]:
        kernel = self.kernel
        loaded = [a.name for a in kernel.function.arguments if kernel.inputs.runs(a)]
        passed: list[str] = []
        for name in loaded:
            passed += [f"&{name}[first * {name}_step]", f"{name}_step"]
        inside = [f"block.{name}" if name in loaded else name for name in self._names]
        inside += [f"block.{self._name(output)}" for output in self._outputs]
        status = kernel.target.status
        stores = stores_of(kernel, kernel.function.outputs, Use.STACKED)
        rows, fills, written = [], [], []
        for store in stores:
            output = store.output
            if not is_jacobian(output) or (nonzeros and store.count):
                rows += self._row_store(store)
            elif not nonzeros:
                fills += self._fill(store)
                written.append((output.name, store.layout.size))
        return {
            "head": entry.prototype(status),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "ahead": fetches(
                ((name, str(size), scaled(size, "next")) for name, size in written), depth=5
            ),
            "gather": self._statement(
                call(f"{kernel.local}_gather", ["count", *self._rest(), *passed, "&block"]), depth=3
            ),
            "call": self._statement(
                call(f"{kernel.local}_block", ["count", *inside, "&status[first]"]),
                before=f"const {status} outcome = ",
                depth=3,
            ),
            "rows": rows,
            "fills": fills,
        }

    def _row_store(self, store: Store) -> list[str]:
        name, size = self._name(store.output), block_size(store.output)
        place = f"&{name}[first]" if size == 1 else f"&{name}[{size} * first]"
        given = ["count", "rest", "&status[first]", f"block.{name}", str(size), self.macro, place]
        return self._statement(call("lanes_to_rows", given), depth=3)

    def _fill(self, store: Store) -> list[str]:
        """Statement that fills the dense Jacobian of one lane."""
        size, name = store.layout.size, store.output.name
        given = [f"&block.{name}_nz[lane]"] if store.count else []
        given += [self.macro] if store.count > 1 else []
        given += [self._slot(slot) for slot in store.slots]
        place = "(first + lane)"
        given.append(f"&{name}[first + lane]" if size == 1 else f"&{name}[{size} * {place}]")
        return self._statement(call(store.fill, given), depth=5)

    def _slot(self, slot: ir.Load) -> str:
        """A run-time index of one lane."""
        assert isinstance(slot.index, int)
        lead = f"({slot.index} * {self.macro}) + " if slot.index else ""
        return f"block.{slot.argument}[{lead}lane]"
