"""Loops over items: their heads, what stands inside, and where the rows of an item are."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.inputs import INPUT_POINTER, ITEM_POINTER
from symnav.emit.c.kernel import OUTPUT_POINTER, SHARED_POINTER, Kernel
from symnav.emit.c.pieces import call, head
from symnav.emit.c.store import Store, Use, stores_of


@dataclass(frozen=True, slots=True)
class ItemLoops:
    """What the loops of a mapped function have in common."""

    kernel: Kernel

    @property
    def lanes_macro(self) -> str:
        """Macro that holds the items side by side in one block."""
        return f"{self.kernel.symbol.upper()}_LANES"

    @property
    def fallible(self) -> bool:
        """True when an item can fail: something about it is checked."""
        function = self.kernel.function
        integers = any(a.integer for a in function.arguments if a.item)
        return function.checks_inputs or integers or self.kernel.item_fails

    @property
    def rejects(self) -> bool:
        """True when one bad item fails the call."""
        return self.fallible and self.kernel.function.items is ir.Items.REJECT

    @property
    def skips(self) -> bool:
        """True when a bad item has a row of zeros."""
        return self.fallible and not self.rejects

    def helpers(self) -> set[str]:
        """Names of the inline helpers that the loops call."""
        if self.rejects:
            return {"first_failure"}
        both = self.fallible and self.kernel.inputs.can_fail(item=True)
        return {"both_failures", "first_of_both"} if both else set()

    def context(self, *, address: bool) -> list[str]:
        """What a loop over items needs of the shared part, as arguments of a call."""
        mark = "&" if address else ""
        names = [f"{mark}{INPUT_POINTER}"] if self.kernel.item_reads_input else []
        return [*names, *([f"{mark}{SHARED_POINTER}"] if self.kernel.item_reads_shared else [])]

    def items_from(self, first: str) -> list[str]:
        """The item arguments from one item on."""
        return [
            f"&{argument.name}[{scaled(argument.size, first)}]" for argument in self.item_arguments
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

    @staticmethod
    def row(store: Store, item: str) -> str:
        """Address of the row of an item in a dense output."""
        return f"&{store.output.name}[{scaled(store.layout.item or 1, item)}]"

    def statements(self, texts: Iterable[str], depth: int) -> list[str]:
        """Statements, wrapped."""
        return [line for text in texts for line in comments.code(text, depth=depth)]

    @property
    def item_arguments(self) -> list[ir.Argument]:
        """Arguments that have one row per item."""
        return [argument for argument in self.kernel.function.arguments if argument.item]

    def loop_head(
        self, name: str, result: str, last: Sequence[str], before: Sequence[str] = ()
    ) -> tuple[str, ...]:
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
        for argument in self.item_arguments:
            kind = "int32_t" if argument.integer else kernel.target.real
            declarations.append(f"const {kind} {argument.name}[{restrict}]")
        return head(result, name, [*before, *declarations, *last])

    @property
    def copies(self) -> bool:
        """True when items are copied in a second pass, after all of them have been checked."""
        return self.rejects and self.kernel.inputs.can_fail(item=True)

    def evaluation(self, place: str, *, passed: bool = False) -> dict[str, object]:
        """Locals and calls for one item in a loop.

        Args:
            place: which item.
            passed: True where every item has passed its checks.
        """
        kernel = self.kernel
        item = kernel.inputs.struct(item=True)
        copy = [f"&{ITEM_POINTER}"] if item else []
        read = copy if kernel.item_reads_item else []
        load = f"{self._loaded}{self._load(place, copy)}"
        if passed and self.copies:
            load = self._copy(place, copy) if item else ""
        told = [str(passed).lower()] if kernel.item_is_told else []
        evaluate = call(
            f"{kernel.local}_item",
            [*self.context(address=False), *read, f"&{OUTPUT_POINTER}", *told],
        )
        verdict = "(void)" if passed else self.kept("evaluated")
        return {
            "locals": [
                *([f"{item.name} {ITEM_POINTER};"] if item else []),
                f"{kernel.output_struct.name} {OUTPUT_POINTER};",
            ],
            "load": comments.code(f"{load};", depth=2) if load else [],
            "evaluate": comments.code(f"{verdict}{evaluate};", depth=2),
        }

    def _load(self, place: str, copy: Sequence[str]) -> str:
        """Call that checks and copies the inputs of an item."""
        name = self.kernel.inputs.loader_name(item=True)
        return call(name, [*self.items_from(place), *copy])

    def _copy(self, place: str, copy: Sequence[str]) -> str:
        """Call that copies them where they have passed."""
        inputs = self.kernel.inputs
        copied = {argument.name for argument in inputs.copied_arguments(item=True)}
        pairs = zip(self.item_arguments, self.items_from(place), strict=True)
        given = [text for argument, text in pairs if argument.name in copied]
        return call(inputs.copier_name(item=True), [*given, *copy])

    @property
    def verdict(self) -> str:
        """C text of what a loop keeps about the checks of an item; zero where all have passed."""
        if not self.kernel.inputs.can_fail(item=True):
            return "evaluated"
        return f"{'first_failure' if self.rejects else 'both_failures'}(loaded, evaluated)"

    def status(self, kept: str) -> str:
        """C text of the status of an item that does not fail the call, from what a loop kept."""
        both = self.kernel.inputs.can_fail(item=True)
        return f"(uint8_t)first_of_both({kept})" if both else f"(uint8_t){kept}"

    @property
    def _loaded(self) -> str:
        """What stands in front of the call that loads an item."""
        return self.kept("loaded") if self.kernel.inputs.can_fail(item=True) else "(void)"

    def kept(self, name: str) -> str:
        """What stands in front of a call whose verdict matters only where items can fail."""
        return f"const flag_t {name} = " if self.fallible else "(void)"


def scaled(size: int, index: str) -> str:
    """``size * index`` without needless arithmetic."""
    if size == 1 or index == "0":
        return index
    return f"{size} * {index}"
