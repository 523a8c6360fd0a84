"""The two public headers: types and layout, and the functions.

What stands between the two interface marks of a header is plain C without conditionals: comments,
integer macros, enumerations, types, constant tables and prototypes. The build derives its foreign
declarations from exactly that text.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.blocks import Blocks
from symnav.emit.c.documentation import banner, entry_comment, status_text
from symnav.emit.c.entries import EntryPoint
from symnav.emit.c.interface import meaning_text
from symnav.emit.c.kernel import Kernel
from symnav.emit.c.store import is_jacobian
from symnav.emit.c.target import Target
from symnav.emit.lanes import lanes_of
from symnav.emit.templates import render

_PER_LINE = 16


@dataclass(frozen=True, slots=True)
class Enumerator:
    """A named integer with a remark."""

    name: str
    value: int
    remark: str = ""

    @property
    def lines(self) -> list[str]:
        """The definition inside an enumeration."""
        return comments.code(f"{self.name} = {self.value},", remark=self.remark)


@dataclass(frozen=True, slots=True)
class Section:
    """What the header holds for one function."""

    kernel: Kernel
    entries: Sequence[EntryPoint]

    @property
    def constants(self) -> list[Enumerator]:
        """Counts that stand in the prototypes."""
        function = self.kernel.function
        stem = f"{self.kernel.target.macro}_{function.name.upper()}"
        listed: list[Enumerator] = []
        if function.maximum is not None:
            listed.append(Enumerator(f"{stem}_MAX_ITEMS", function.maximum, "most items in a call"))
        elif any(entry.symbol.endswith("_blocks") for entry in self.entries):
            macro = Blocks(self.kernel).macro
            listed.append(Enumerator(macro, lanes_of(function), "epochs in one block"))
        for output in function.outputs:
            if is_jacobian(output) and output.entries:
                count = len(output.entries)
                name = f"{stem}_{output.name.upper()}_NNZ"
                listed.append(Enumerator(name, count, f"structural non-zeros of {output.name}"))
        return listed

    @property
    def tables(self) -> list[list[str]]:
        """Row and column tables of the structural non-zeros."""
        tables: list[list[str]] = []
        for output in self.kernel.function.outputs:
            if is_jacobian(output) and output.entries:
                tables += _tables(f"{self.kernel.symbol}_{output.name}", output)
        return tables

    @property
    def prototypes(self) -> list[list[str]]:
        """Documented prototypes."""
        target = self.kernel.target
        listed: list[list[str]] = []
        for entry in self.entries:
            *front, last = entry.prototype(target.status)
            documented = entry_comment(self.kernel.function, entry, target)
            listed.append([*documented, *front, f"{last};"])
        return listed


def types_header(module: ir.Module, target: Target) -> str:
    """Text of ``<prefix>_types.h``."""
    file = f"{target.prefix}_types.h"
    return render(
        "c/types.h.j2",
        banner=banner(module, file, f"Types, status values and state layout of {module.name}."),
        target=target,
        scalar=module.scalar.value,
        statuses=[
            Enumerator(target.code(status), status.value, status_text(status))
            for status in ir.Status
        ],
        storage=_storage(module.state, target),
        errors=_errors(module.state, target),
        blocks=[line for block in module.state.blocks for line in _block_text(block)],
        digest=module.state.digest,
        digest_word=f"0x{module.state.digest[:8].upper()}U",
    )


def functions_header(module: ir.Module, target: Target, sections: Sequence[Section]) -> str:
    """Text of ``<prefix>.h``."""
    file = f"{target.prefix}.h"
    return render(
        "c/header.h.j2",
        banner=banner(module, file, f"Functions of the navigation state {module.name}."),
        target=target,
        sections=sections,
    )


def _storage(state: ir.State, target: Target) -> list[Enumerator]:
    listed: list[Enumerator] = []
    for block in state.blocks:
        name = block.name.upper()
        storage = block.storage
        remark = _quantity(storage.labels, storage.unit, storage.frame)
        listed.append(Enumerator(f"{target.macro}_X_{name}", storage.start, remark))
        listed.append(Enumerator(f"{target.macro}_XSIZE_{name}", storage.size))
    return [*listed, Enumerator(f"{target.macro}_STATE_SIZE", state.size, "elements in all")]


def _errors(state: ir.State, target: Target) -> list[Enumerator]:
    listed: list[Enumerator] = []
    for block in state.blocks:
        name = block.name.upper()
        remark = _quantity(block.error_labels, block.error_unit, block.error_frame)
        listed.append(Enumerator(f"{target.macro}_E_{name}", block.error_start, remark))
        listed.append(Enumerator(f"{target.macro}_ESIZE_{name}", block.error_size))
    return [*listed, Enumerator(f"{target.macro}_ERROR_SIZE", state.error_size, "elements in all")]


def _quantity(labels: Sequence[str], unit: str, frame: str) -> str:
    parts = [" ".join(labels), "" if unit == "1" else unit, frame]
    return ", ".join(part for part in parts if part.strip())


def _block_text(block: ir.StateBlock) -> list[str]:
    storage = block.storage
    text = f"- {block.name} ({block.kind}): {meaning_text(storage)}"
    if block.convention.strip():
        text += f" {block.convention}"
    return comments.paragraph(text, hang="  ")


def _tables(stem: str, output: ir.Output) -> list[list[str]]:
    axes = ("rows", "columns") if len(output.shape) > 1 else ("columns",)
    tables: list[list[str]] = []
    for axis, name in enumerate(axes):
        indices = [entry.index[axis] for entry in output.entries]
        values = [index.base if isinstance(index, ir.Offset) else index for index in indices]
        moving = [index.slot for index in indices if isinstance(index, ir.Offset)]
        remark = f"{name.capitalize()} of the structural non-zeros of {output.name}"
        if moving:
            places = (str(k) for k, index in enumerate(indices) if isinstance(index, ir.Offset))
            remark += (
                f"; for non-zero {', '.join(places)} add element {moving[0].index} of the item's "
                f"{moving[0].argument}"
            )
        lines = ["/**", *comments.paragraph(f"{remark}."), " */"]
        lines.append(f"static const int32_t {stem}_{name}[{len(values)}] = {{")
        for first in range(0, len(values), _PER_LINE):
            row = ", ".join(str(value) for value in values[first : first + _PER_LINE])
            lines.append(f"    {row}{',' if first + _PER_LINE < len(values) else ''}")
        lines.append("};")
        tables.append(lines)
    return tables
