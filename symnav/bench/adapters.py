"""Candidates from a generated C tree: every way to call a function, behind one adapter each.

An adapter finds the inputs of one evaluation in one flat record of doubles: the arguments one
after another, those of the items for all items.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path

from symnav import ir
from symnav.bench.candidate import Candidate, adapter
from symnav.emit.lanes import block_size, lanes_of

EPOCHS = 64
"""Epochs in one call of the batch form."""


@dataclass(frozen=True)
class Entries:
    """The entry points of one function of a generated tree.

    Attributes:
        prefix: of every symbol of the tree.
        function: what is called.
        tree: directory with ``include`` and ``src``.
        items: how many items each call has; ignored where the function is not mapped.
        label: tells apart candidates of one name in one program.
    """

    prefix: str
    function: ir.Function
    tree: Path
    items: int = 0
    label: str = ""

    @property
    def count(self) -> int:
        """Items of a call, one where the function is not mapped."""
        return self.items if self.function.maximum is not None else 1

    @property
    def offsets(self) -> dict[str, int]:
        """Where each argument starts in a record."""
        found, at = {}, 0
        for argument in self.function.arguments:
            found[argument.name] = at
            at += self.length(argument)
        return found

    @property
    def record(self) -> int:
        """Length of a record."""
        return sum(self.length(argument) for argument in self.function.arguments)

    def length(self, argument: ir.Argument) -> int:
        """Elements of an argument in a record."""
        return argument.size * (self.count if argument.item else 1)

    def dense(self, name: str) -> Candidate:
        """One epoch, Jacobians in full."""
        places, at = [], 0
        for output in self.function.outputs:
            places.append(f"out + {at}")
            at += self._size(output)
        return self._candidate(name, "", self._one_epoch(places), at)

    def nonzeros(self, name: str) -> Candidate:
        """One epoch, Jacobians as structural non-zeros."""
        places, at = [], 0
        for output in self.function.outputs:
            if not output.name.startswith("jacobian"):
                places.append(f"out + {at}")
                at += self._size(output)
            elif output.entries:
                places.append(f"out + {at}")
                at += len(output.entries) * (self._limit if output.item else 1)
        return self._candidate(name, "_nz", self._one_epoch(places), at)

    def batch(self, name: str, *, nonzeros: bool = False) -> Candidate:
        """Many epochs in one call, from rows to rows: Jacobians in full, or their non-zeros."""
        arguments = [str(EPOCHS)]
        for argument in self.function.arguments:
            arguments += [self._place(argument), str(self.record)]
            if self._mapped and len(arguments) == 3:
                arguments.append("items")
        at = 0
        for output in self.function.outputs:
            size = self._sparse_size(output) if nonzeros else self._size(output)
            if size:
                arguments.append(f"out + {at}")
                at += EPOCHS * size
        arguments += ["status", *(["item_status"] if self._mapped else [])]
        room = [*self._count(), f"static unsigned char status[{EPOCHS}];"]
        room += (
            [f"static unsigned char item_status[{EPOCHS * self.items}];"] if self._mapped else []
        )
        suffix = "_batch_nz" if nonzeros else "_batch"
        return self._candidate(name, suffix, (room, arguments), at, EPOCHS)

    def blocks(self, name: str) -> Candidate:
        """Many epochs side by side in blocks; laid out once, outside of what is timed."""
        arguments, room = [str(EPOCHS)], [f"static unsigned char status[{EPOCHS}];"]
        filled: list[str] = []
        lanes = lanes_of(self.function)
        for argument in self.function.arguments:
            kind, size = ("int32_t" if argument.integer else "double"), argument.size
            place = f"(e / {lanes} * {size} + k) * {lanes} + e % {lanes}"
            room.append(f"static {kind} lanes_{argument.name}[{EPOCHS * size}];")
            filled += [
                f"for (int e = 0; e < {EPOCHS}; ++e) {{",
                f"    for (int k = 0; k < {size}; ++k) {{",
                f"        lanes_{argument.name}[{place}]",
                f"            = ({kind})in[e * {self.record} + {self.offsets[argument.name]} + k];",
                "    }",
                "}",
            ]
            arguments.append(f"lanes_{argument.name}")
        at = 0
        for output in self.function.outputs:
            if block_size(output):
                arguments.append(f"out + {at}")
                at += EPOCHS * block_size(output)
        room.append("static const double *seen;")
        once = ["if (seen != in) {", *(f"    {line}" for line in filled), "    seen = in;", "}"]
        call = (room, [*arguments, "status"])
        return self._candidate(name, "_blocks", call, at, EPOCHS, once=once)

    @property
    def _mapped(self) -> bool:
        return self.function.maximum is not None

    @property
    def _limit(self) -> int:
        return self.function.maximum or 1

    def _size(self, output: ir.Output) -> int:
        return prod(output.shape) * (self.count if output.item else 1)

    def _sparse_size(self, output: ir.Output) -> int:
        """Elements of an output where Jacobians are their non-zeros."""
        return block_size(output) * (self.count if output.item else 1)

    def _place(self, argument: ir.Argument) -> str:
        return argument.name if argument.integer else f"in + {self.offsets[argument.name]}"

    def _one_epoch(self, outputs: Sequence[str]) -> tuple[list[str], list[str]]:
        """Locals of an adapter and the arguments of its call."""
        first, *rest = [self._place(argument) for argument in self.function.arguments]
        items = ["item_status"] if self._mapped else []
        arguments = [first, *(["items"] if self._mapped else []), *rest, *outputs, *items]
        room = [f"static unsigned char item_status[{self.items}];"] if self._mapped else []
        return [*self._count(), *room], arguments

    def _count(self) -> list[str]:
        """The count, which is a run-time argument and must not be one the compiler knows."""
        return [f"static volatile int32_t items = {self.items};"] if self._mapped else []

    def _candidate(
        self,
        name: str,
        suffix: str,
        call: tuple[Sequence[str], Sequence[str]],
        size: int,
        epochs: int = 1,
        once: Sequence[str] = (),
    ) -> Candidate:
        room, arguments = call
        root = f"{self.prefix}_{self.function.name}"
        symbol = f"bench{self.label}_{root}{suffix or '_dense'}"
        integers = [] if once else self._integers(epochs)
        body = [*room, *integers, *once, f"(void){root}{suffix}({', '.join(arguments)});"]
        source = f'#include "{root}.c"\n\n{adapter(symbol, body)}'
        include = (self.tree / "include", self.tree / "src")
        return Candidate(
            name=name, symbol=symbol, source=source, size=size, include=include,
            root=root + suffix, epochs=epochs,
        )  # fmt: skip

    def _integers(self, epochs: int) -> Iterator[str]:
        """Selectors and slots, converted."""
        for argument in self.function.arguments:
            if argument.integer:
                start, length = self.offsets[argument.name], self.length(argument)
                step = self.record if epochs > 1 else 0
                room = (epochs - 1) * step + length
                yield f"static int32_t {argument.name}[{room}];"
                yield f"for (int e = 0; e < {epochs}; ++e) {{"
                yield f"    for (int k = 0; k < {length}; ++k) {{"
                given = f"in[{start} + e * {self.record} + k]"
                yield f"        {argument.name}[e * {step} + k] = (int32_t){given};"
                yield "    }"
                yield "}"
