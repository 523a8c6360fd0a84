"""The function that checks the inputs of another where they enter: once, for many calls.

It looks at what the calls would look at, with the same verdicts, and evaluates nothing. It stands
in a source file of its own, so that a program that trusts its inputs need not link it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.elements import elements_of
from symnav.emit.c.entries import EntryPoint
from symnav.emit.c.inputs import Inputs
from symnav.emit.c.interface import Interface
from symnav.emit.c.items import scaled
from symnav.emit.c.kernel import Kernel
from symnav.emit.c.pieces import Routine, call
from symnav.emit.templates import render

SUFFIX = "_check"


@dataclass(frozen=True)
class Border:
    """The source file of the function that checks the inputs of a kernel.

    Attributes:
        kernel: whose inputs they are.
    """

    kernel: Kernel

    @property
    def symbol(self) -> str:
        """Name of the function and of its file."""
        return self.kernel.symbol + SUFFIX

    def entry_point(self) -> EntryPoint:
        """The public symbol."""
        interface, title = Interface(self.kernel), self.kernel.function.title
        remark = (
            "Looks at every input that the other entry points read and evaluates nothing. Data "
            "that it accepts may be passed to all of them, as often as they are needed."
        )
        if self._skips:
            remark += " Items that it refuses are to be left out; their own status says which."
        return EntryPoint(
            self.symbol,
            f"{title}: check of the inputs.",
            (*interface.arguments(), *interface.item_status()),
            remark=remark,
            border=True,
        )

    def source(self, banner: Sequence[str]) -> str:
        """Text of the source file."""
        kernel, entry = self.kernel, self.entry_point()
        return render(
            "c/border.c.j2",
            banner=banner,
            target=kernel.target,
            routines=self._routines(),
            mapped=kernel.mapped,
            skips=self._skips,
            limit=Interface(kernel).limit,
            head=entry.prototype(kernel.target.status),
            pointers=comments.code(f"if ({entry.pointers}) {{"),
            load=self._load(item=False),
            load_item=comments.code(f"const flag_t loaded = {self._load(item=True)};", depth=4),
        )

    def helpers(self) -> set[str]:
        """Names of the inline helpers the file calls."""
        rejects = self.kernel.mapped and not self._skips
        return self._inputs.helpers() | ({"first_failure"} if rejects else set())

    @property
    def _skips(self) -> bool:
        """True when a bad item does not fail the call."""
        return self.kernel.mapped and self.kernel.function.items is ir.Items.SKIP

    @cached_property
    def _inputs(self) -> Inputs:
        """Loaders that check every element and copy none."""
        own = replace(self.kernel.function, guards=ir.Guards.STATUS)
        table, _ = elements_of(own, ())
        nothing: frozenset[ir.Load] = frozenset()
        return Inputs(
            self.kernel.target, f"{own.name}{SUFFIX}", table, nothing, nothing, {},
            checked=True, strided=False, selected=nothing,
        )  # fmt: skip

    def _routines(self) -> list[Routine]:
        loaders = [self._inputs.loader(item=False)]
        return [*loaders, *([self._inputs.loader(item=True)] if self.kernel.mapped else [])]

    def _load(self, *, item: bool) -> str:
        """Call that checks the inputs of one call, or of one item."""
        arguments = [a for a in self.kernel.function.arguments if a.item is item]
        given = [f"&{a.name}[{scaled(a.size, 'i')}]" if item else a.name for a in arguments]
        return call(self._inputs.loader_name(item=item), given)
