"""Where results go: non-zeros side by side, dense matrices, zero rows, differences of rows.

Four small inline functions per output do all the storing, so that every entry point is load,
kernel, store. Non-zeros are addressed with a stride: 1 in the results of one call, the number of
lanes in a block, the declared maximum in the columns a mapped function stores.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum
from math import prod

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.kernel import OUTPUT_POINTER, Kernel, slots_of
from symnav.emit.c.pieces import Routine, head

_LOOP = 8  # a run of at least this many zeros is written by a loop


class Use(Enum):
    """Which entry points a dense form belongs to."""

    DENSE = "dense"
    STACKED = "stacked"
    DIFFERENCED = "differenced"


@dataclass(frozen=True, slots=True)
class Layout:
    """How a dense output lies in memory.

    Attributes:
        shape: per item.
        strides: distance between neighbours along each axis.
        item: distance between items, or None where the output is not per item.
    """

    shape: tuple[int, ...]
    strides: tuple[int, ...]
    item: int | None

    @property
    def size(self) -> int:
        """Elements per item."""
        return prod(self.shape)


def is_jacobian(output: ir.Output) -> bool:
    """True for the derivative of another output."""
    return output.name.startswith("jacobian")


def layout_of(
    function: ir.Function, output: ir.Output, *, by_column: bool = True, items: int | None = None
) -> Layout:
    """The memory layout of an output in a dense entry point.

    Args:
        function: whose output it is.
        output: the output.
        by_column: False to lay every output out by row, whatever the function says.
        items: most rows of items, where it is not the declared maximum.
    """
    shape = output.shape
    per_item = output.item and function.maximum is not None
    if by_column and function.column_major and is_jacobian(output):
        rows = shape[0] if len(shape) > 1 else 1
        leading = rows * (items or function.maximum or 1) if per_item else rows
        down_a_column = (1, leading) if len(shape) > 1 else (leading,)
        return Layout(shape, down_a_column, rows if per_item else None)
    strides = tuple(prod(shape[axis + 1 :]) for axis in range(len(shape)))
    return Layout(shape, strides, prod(shape) if per_item else None)


@dataclass(frozen=True, slots=True)
class Store:
    """The storing functions of one output of a kernel.

    Attributes:
        kernel: whose output it is.
        output: the output.
        layout: of its dense form.
        suffix: tells two dense forms of one output apart.
    """

    kernel: Kernel
    output: ir.Output
    layout: Layout
    suffix: str = ""

    @property
    def put(self) -> str:
        """Name of the function that stores non-zeros with a stride."""
        return f"{self.kernel.local}_put_{self.output.name}"

    @property
    def fill(self) -> str:
        """Name of the function that stores the dense form."""
        return f"{self.kernel.local}_fill_{self.output.name}{self.suffix}"

    @property
    def spread(self) -> str:
        """Name of the function that stores the dense form with a stride."""
        return f"{self.kernel.local}_spread_{self.output.name}{self.suffix}"

    @property
    def clear(self) -> str:
        """Name of the function that stores a zero row."""
        return f"{self.kernel.local}_clear_{self.output.name}{self.suffix}"

    @property
    def difference(self) -> str:
        """Name of the function that stores the difference to the row of the reference."""
        return f"{self.kernel.local}_difference_{self.output.name}{self.suffix}"

    @property
    def count(self) -> int:
        """Number of structural non-zeros."""
        return len(self.output.entries)

    @property
    def complete(self) -> bool:
        """True when the non-zeros are the dense form, element by element."""
        positions = self._positions()
        places = [positions[place] for place in range(self.layout.size)]
        return [entry.index for entry in self.output.entries] == places

    @property
    def slots(self) -> tuple[ir.Load, ...]:
        """Elements that place a non-zero at run time."""
        return slots_of(self.output)

    def putting(self) -> Routine:
        """Non-zeros of the output structure to memory, with a stride."""
        real, name = self.kernel.target.real, self.output.name
        lines = [
            f"    nonzeros[{_product(position, 'stride')}] = {OUTPUT_POINTER}->{name}[{position}];"
            for position in range(self.count)
        ]
        parameters = [f"const {self.kernel.output_struct.name} *{OUTPUT_POINTER}"]
        parameters += ["int32_t stride"] if self.count > 1 else []
        return Routine(
            f"Store the non-zeros of {name}, a stride apart.",
            head(self._inline, self.put, [*parameters, f"{real} nonzeros[]"]),
            tuple(lines),
        )

    def filling(self) -> Routine:
        """Non-zeros with a stride to the dense form; every zero is written exactly once."""
        real = self.kernel.target.real
        parameters = [f"const {real} nonzeros[]"] if self.count else []
        parameters += ["int32_t stride"] if self.count > 1 else []
        parameters += [f"int32_t {self.slot_name(slot)}" for slot in self.slots]
        return Routine(
            f"Store {self.output.name} in full, structural zeros included.",
            head(self._inline, self.fill, [*parameters, f"{real} dense[]"]),
            (*self._elements("nonzeros[{0}]"), *self._moving("nonzeros[{0}]", "=", "")),
        )

    def spreading(self) -> Routine:
        """The output structure to the dense form, its elements a stride apart."""
        parameters = (
            [f"const {self.kernel.output_struct.name} *{OUTPUT_POINTER}"] if self.count else []
        )
        parameters += ["int32_t stride"] if self.layout.size > 1 else []
        parameters += [f"int32_t {self.slot_name(slot)}" for slot in self.slots]
        lines: list[str] = []
        fixed = {entry.index: position for position, entry in enumerate(self.output.entries)}
        for place, index in sorted(self._positions().items()):
            position = fixed.get(index)
            text = self.kernel.target.literal(0.0)
            if position is not None:
                text = f"{OUTPUT_POINTER}->{self.output.name}[{position}]"
            lines += comments.code(f"dense[{_product(place, 'stride')}] = {text};")
        lines += [
            line.replace("dense[", "dense[(").replace("] = ", ") * stride] = ", 1)
            for line in self._moving(f"{OUTPUT_POINTER}->{self.output.name}[{{0}}]", "=", "")
        ]
        return Routine(
            f"Store {self.output.name} in full, its elements a stride apart.",
            head(self._inline, self.spread, [*parameters, f"{self.kernel.target.real} dense[]"]),
            tuple(lines),
        )

    def differencing(self) -> Routine:
        """The dense row of an item less that of the reference item."""
        real = self.kernel.target.real
        parameters = [f"const {real} nonzeros[]", f"const {real} reference[]"] if self.count else []
        parameters += ["int32_t stride"] if self.count > 1 else []
        names = [self.slot_name(slot) for slot in self.slots]
        lead = "reference_"
        while not {f"{lead}{name}" for name in names}.isdisjoint(names):
            lead += "reference_"
        for name in names:
            parameters += [f"int32_t {name}", f"int32_t {lead}{name}"]
        lines = [
            *self._elements("nonzeros[{0}] - reference[{0}]"),
            *self._moving("nonzeros[{0}]", "+=", ""),
            *self._moving("reference[{0}]", "-=", lead),
        ]
        return Routine(
            f"Store {self.output.name} of an item less that of the reference item.",
            head(self._inline, self.difference, [*parameters, f"{real} dense[]"]),
            tuple(lines),
        )

    def clearing(self) -> Routine:
        """A zero row for an item that failed its checks."""
        real = self.kernel.target.real
        return Routine(
            f"Store zeros for {self.output.name} of an item that failed its checks.",
            head(self._inline, self.clear, [f"{real} dense[]"]),
            tuple(self._zeros(sorted(self._positions()))),
        )

    def slot_name(self, slot: ir.Load) -> str:
        """What the element that places a non-zero is called here."""
        return self.kernel.inputs.table[slot].field

    @property
    def _inline(self) -> str:
        return f"{self.kernel.target.macro}_INLINE void"

    def _positions(self) -> dict[int, tuple[int, ...]]:
        """Every index of the output by its place in memory."""
        indices: list[tuple[int, ...]] = [()]
        for length in self.layout.shape:
            indices = [(*index, step) for index in indices for step in range(length)]
        return {self._place(index): index for index in indices}

    def _place(self, index: tuple[int, ...]) -> int:
        return sum(step * stride for step, stride in zip(index, self.layout.strides, strict=True))

    def _elements(self, value: str) -> Iterator[str]:
        """Fixed elements in the order they lie in memory."""
        fixed = {entry.index: position for position, entry in enumerate(self.output.entries)}
        zeros: list[int] = []
        for place, index in sorted(self._positions().items()):
            position = fixed.get(index)
            if position is None:
                zeros.append(place)
                continue
            yield from self._zeros(zeros)
            zeros = []
            text = value.format(_product(position, "stride"))
            yield from comments.code(f"dense[{place}] = {text};")
        yield from self._zeros(zeros)

    def _zeros(self, places: list[int]) -> Iterator[str]:
        zero = self.kernel.target.literal(0.0)
        first = 0
        while first < len(places):
            last = first
            while last + 1 < len(places) and places[last + 1] == places[last] + 1:
                last += 1
            if last - first + 1 >= _LOOP:
                yield f"    for (int32_t k = {places[first]}; k <= {places[last]}; ++k) {{"
                yield f"        dense[k] = {zero};"
                yield "    }"
            else:
                yield from (f"    dense[{place}] = {zero};" for place in places[first : last + 1])
            first = last + 1

    def _moving(self, value: str, assign: str, prefix: str) -> Iterator[str]:
        """Elements whose place depends on a slot."""
        for position, entry in enumerate(self.output.entries):
            terms: list[str] = []
            fixed = 0
            for step, stride in zip(entry.index, self.layout.strides, strict=True):
                if isinstance(step, ir.Offset):
                    name = f"{prefix}{self.slot_name(step.slot)}"
                    fixed += step.base * stride
                    terms.append(name if stride == 1 else f"({stride} * {name})")
                else:
                    fixed += step * stride
            if terms:
                place = " + ".join([str(fixed), *terms])
                text = value.format(_product(position, "stride"))
                yield from comments.code(f"dense[{place}] {assign} {text};")


def _product(count: int, stride: str) -> str:
    """``count * stride`` without needless arithmetic."""
    return {0: "0", 1: stride}.get(count, f"{count} * {stride}")


def stores_of(kernel: Kernel, outputs: Iterable[ir.Output], use: Use) -> list[Store]:
    """The storing functions of some outputs for one use."""
    return [_store(kernel, output, use) for output in outputs]


def _store(kernel: Kernel, output: ir.Output, use: Use) -> Store:
    """Layouts that coincide share their functions; a suffix tells the others apart."""
    dense = layout_of(kernel.function, output)
    if use is Use.STACKED:
        rows = layout_of(kernel.function, output, by_column=False)
        return Store(kernel, output, rows, "" if rows == dense else "_by_row")
    if use is Use.DIFFERENCED:
        fewer = (kernel.function.maximum or 2) - 1
        rows = layout_of(kernel.function, output, items=fewer)
        return Store(kernel, output, rows, "" if rows == dense else "_differenced")
    return Store(kernel, output, dense)
