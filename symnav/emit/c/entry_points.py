"""Entry points of a function that is not mapped: load, kernel, store."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.interface import EPOCHS, Interface
from symnav.emit.c.kernel import Kernel
from symnav.emit.c.pieces import Field, Parameter, Routine, Struct, call, head
from symnav.emit.c.store import Store, Use, is_jacobian, stores_of
from symnav.emit.templates import render

_SCRATCH = 16384  # bytes a block of epochs may take on the stack


@dataclass(frozen=True, slots=True)
class EntryPoint:
    """One public symbol.

    Attributes:
        symbol: its name.
        brief: one sentence.
        parameters: in order.
        full: True for the one that carries the whole documentation.
    """

    symbol: str
    brief: str
    parameters: tuple[Parameter, ...]
    full: bool = False

    def prototype(self, status: str) -> tuple[str, ...]:
        """Its head, on as many lines as it needs."""
        return head(status, self.symbol, [parameter.declaration for parameter in self.parameters])

    @property
    def pointers(self) -> str:
        """Condition under which no pointer is null."""
        names = [parameter.name for parameter in self.parameters if parameter.pointer]
        if len(names) == 1:
            return f"{names[0]} != NULL"
        return " && ".join(f"({name} != NULL)" for name in names)


def variants(function: ir.Function) -> list[tuple[str, str, tuple[ir.Output, ...]]]:
    """Suffix, meaning and outputs of the dense entry points."""
    outputs = function.outputs
    joint = [("", "", outputs)]
    values = tuple(output for output in outputs if not is_jacobian(output))
    jacobians = tuple(output for output in outputs if is_jacobian(output))
    if not values or not jacobians:
        return joint
    return [
        *joint,
        ("_value", "values only", values),
        ("_jacobian", "Jacobians only", jacobians),
    ]


@dataclass(frozen=True, slots=True)
class Single:
    """The source file of a function that is not mapped."""

    kernel: Kernel

    @property
    def lanes(self) -> int:
        """Epochs side by side in one block."""
        width = 8 * sum(len(output.entries) for output in self.kernel.results) + 4
        return next((lanes for lanes in (64, 32, 16) if lanes * width <= _SCRATCH), 8)

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
        parameters = (EPOCHS, *interface.stepped_arguments(), *interface.stacked_outputs())
        brief = f"{function.title}: many epochs in one call."
        listed.append(EntryPoint(f"{symbol}_batch", brief, parameters))
        return listed

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
            lanes=self.lanes,
            lanes_macro=f"{symbol.upper()}_LANES",
            block=self._block(),
            routines=self._routines(),
            calls=calls,
            batch=self._batch_context(entries[f"{symbol}_batch"]),
        )

    def _routines(self) -> list[Routine]:
        outputs = self.kernel.function.outputs
        puts = [store.putting() for store in stores_of(self.kernel, self.kernel.results, Use.DENSE)]
        fills = {
            store.fill: store.filling()
            for use in (Use.DENSE, Use.STACKED)
            for store in stores_of(self.kernel, outputs, use)
        }
        return [*puts, *fills.values()]

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
        return {
            "head": entry.prototype(self.kernel.target.status),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "locals": self._locals(),
            "load": self._load(names),
            "evaluate": self._evaluate(),
            "stores": [line for store in stores for line in comments.code(store, depth=3)],
        }

    def _locals(self) -> list[str]:
        struct = self.kernel.inputs.struct(item=False)
        lines = [f"{struct.name} in;"] if struct else []
        return [*lines, f"{self.kernel.output_struct.name} out;"]

    def _load(self, sources: Sequence[str]) -> str:
        struct = self.kernel.inputs.struct(item=False)
        return call(f"{self.kernel.local}_load", [*sources, *(["&in"] if struct else [])])

    def _evaluate(self) -> str:
        given = ["&in"] if self.kernel.main_reads_input else []
        return call(f"{self.kernel.local}_kernel", [*given, "&out"])

    def _block(self) -> Struct:
        macro = f"{self.kernel.symbol.upper()}_LANES"
        real = self.kernel.target.real
        fields = [
            Field(real, output.name, f"{len(output.entries)} * {macro}")
            for output in self.kernel.results
        ]
        fields += [
            Field("int32_t", self.kernel.inputs.table[slot].field, macro)
            for slot in self.kernel.slots
        ]
        fields.append(Field("flag_t", "status", macro))
        brief = "Non-zeros of a block of epochs, each stored contiguously across the epochs."
        return Struct(f"{self.kernel.local}_block_t", brief, tuple(fields))

    def _batch_context(self, entry: EntryPoint) -> dict[str, object]:
        kernel = self.kernel
        macro = f"{kernel.symbol.upper()}_LANES"
        arguments = kernel.function.arguments
        declarations = [self._lane_declaration(argument) for argument in arguments]
        block = f"{self._block().name} *{kernel.target.macro}_RESTRICT block"
        puts = [
            call(
                store.put,
                [
                    "&out",
                    *([macro] if store.count > 1 else []),
                    f"&block->{store.output.name}[lane]",
                ],
            )
            + ";"
            for store in stores_of(kernel, kernel.results, Use.DENSE)
        ]
        puts += [
            f"block->{kernel.inputs.table[slot].field}[lane] = "
            f"{kernel.inputs.place(slot, pointers=False)};"
            for slot in kernel.slots
        ]
        passed = [f"&{name}[first * {name}_step], {name}_step" for name in _names(arguments)]
        return {
            "lanes_head": head(
                f"static {kernel.target.macro}_WIDE void",
                f"{kernel.local}_lanes",
                ["int32_t count", *declarations, block],
            ),
            "locals": self._locals(),
            "load": comments.code(
                "const flag_t loaded = "
                + self._load([f"&{name}[lane * {name}_step]" for name in _names(arguments)])
                + ";",
                depth=2,
            ),
            "evaluate": self._evaluate(),
            "puts": [line for put in puts for line in comments.code(put, depth=2)],
            "head": entry.prototype(kernel.target.status),
            "pointers": comments.code(f"if ({entry.pointers}) {{"),
            "lanes_call": comments.code(
                call(f"{kernel.local}_lanes", ["count", *passed, "&block"]) + ";", depth=4
            ),
            "fills": self._block_fills(macro),
        }

    def _lane_declaration(self, argument: ir.Argument) -> str:
        kind = "int32_t" if argument.integer else self.kernel.target.real
        restrict = f"{self.kernel.target.macro}_RESTRICT"
        return f"const {kind} {argument.name}[{restrict}], ptrdiff_t {argument.name}_step"

    def _block_fills(self, macro: str) -> list[str]:
        lines: list[str] = []
        for store in stores_of(self.kernel, self.kernel.function.outputs, Use.STACKED):
            size, name = store.layout.size, store.output.name
            arguments = [f"&block.{name}[lane]"] if store.count else []
            arguments += [macro] if store.count > 1 else []
            arguments += [f"block.{store.slot_name(slot)}[lane]" for slot in store.slots]
            place = "epoch" if size == 1 else f"{size} * epoch"
            arguments.append(f"&{name}[{place}]")
            lines += comments.code(call(store.fill, arguments) + ";", depth=5)
        return lines


def has_nonzeros(function: ir.Function) -> bool:
    """True when some Jacobian has a structural non-zero."""
    return any(is_jacobian(output) and output.entries for output in function.outputs)


def _names(arguments: Sequence[ir.Argument]) -> list[str]:
    return [argument.name for argument in arguments]
