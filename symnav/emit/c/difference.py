"""Single differences: rows of items less the row of a reference item, and their covariance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.entries import EntryPoint
from symnav.emit.c.interface import Interface
from symnav.emit.c.kernel import Kernel
from symnav.emit.c.mapped import Mapped
from symnav.emit.c.pieces import Parameter, call, head
from symnav.emit.c.store import Use, stores_of
from symnav.emit.templates import render

LARGEST = {ir.Scalar.DOUBLE: 1e150, ir.Scalar.FLOAT: 1e18}
"""A standard deviation above this has a square that overflows the type."""


@dataclass(frozen=True, slots=True)
class Differenced:
    """The source file of a mapped function and its differenced form."""

    mapped: Mapped

    @property
    def kernel(self) -> Kernel:
        """The kernel of the function."""
        return self.mapped.kernel

    def entry_points(self) -> list[EntryPoint]:
        """Public symbols in the order of the header."""
        return [*self.mapped.entry_points(), *_entry_points(self.kernel)]

    def source(self, banner: Sequence[str]) -> str:
        """Text of the source file."""
        entries = {entry.symbol: entry for entry in self.entry_points()}
        return self.mapped.source(banner) + _source(self.mapped, entries)


def _entry_points(kernel: Kernel) -> list[EntryPoint]:
    """Public symbols of the differenced form."""
    interface = Interface(kernel)
    limit, symbol, title = interface.limit, kernel.symbol, kernel.function.title
    first, count, *rest = interface.arguments()
    reference = Parameter(
        "int32_t reference", "reference", False, "in", "The item that is subtracted, from 0."
    )
    array = f"{kernel.target.real} {{}}[{kernel.target.macro}_RESTRICT {{}}]"
    matrix = Parameter(
        array.format("matrix", f"({limit} - 1) * {limit}"),
        "matrix",
        True,
        "out",
        "[n - 1 x n] Differences as a product with the rows of the items, by row.",
    )
    sigma = Parameter(
        "const " + array.format("sigma", limit),
        "sigma",
        True,
        "in",
        f"[n] Standard deviations of the items; range 0 to {LARGEST[kernel.target.scalar]:g}.",
    )
    covariance = Parameter(
        array.format("covariance", f"({limit} - 1) * ({limit} - 1)"),
        "covariance",
        True,
        "out",
        "[n - 1 x n - 1] Covariance of the differences; every element off the diagonal is the "
        "variance of the reference.",
    )
    outputs = interface.outputs(kernel.function.outputs, fewer=1)
    parameters = (first, count, reference, *rest, *outputs, *interface.item_status())
    return [
        EntryPoint(
            f"{symbol}_sd",
            f"{title}: rows of the items in ascending order, without the reference, each less "
            "the row of the reference. With n = 0 nothing is read or written.",
            parameters,
        ),
        EntryPoint(
            f"{symbol}_difference_matrix",
            f"{title}: the matrix of the single differences.",
            (count, reference, matrix),
        ),
        EntryPoint(
            f"{symbol}_difference_covariance",
            f"{title}: covariance of the single differences of independent items.",
            (count, reference, sigma, covariance),
        ),
    ]


def _source(mapped: Mapped, entries: Mapping[str, EntryPoint]) -> str:
    """The differenced form, to follow the entry points of a mapped function."""
    kernel, symbol = mapped.kernel, mapped.kernel.symbol
    entry = entries[f"{symbol}_sd"]
    outputs = kernel.function.outputs
    per_item = [output for output in outputs if output.item]
    inner = f"{kernel.local}_differences"
    declarations = [parameter.declaration for parameter in entry.parameters]
    names = [parameter.name for parameter in entry.parameters]
    differences: list[str] = []
    for store in stores_of(kernel, per_item, Use.DIFFERENCED):
        name = store.output.name
        arguments = [f"&block.{name}[lane]", f"base.{name}"] if store.count else []
        arguments += [mapped.lanes_macro] if store.count > 1 else []
        for slot in store.slots:
            arguments.append(mapped.slot_value(slot, "block", "lane"))
            arguments.append(mapped.slot_value(slot, "base", "0"))
        differences.append(call(store.difference, [*arguments, mapped.row(store, "row")]) + ";")
    target = kernel.target
    return render(
        "c/difference.c.j2",
        target=target,
        local=kernel.local,
        limit=Interface(kernel).limit,
        lanes_macro=mapped.lanes_macro,
        block=f"{kernel.local}_block_t",
        routines=[s.differencing() for s in stores_of(kernel, per_item, Use.DIFFERENCED)],
        fallible=mapped.fallible,
        rejects=mapped.rejects,
        skips=mapped.skips,
        base_status=mapped.status("base.failures[0]"),
        block_status=mapped.status("block.failures[lane]"),
        inner_head=head(f"static {target.status}", inner, declarations),
        prologue=mapped.prologue(),
        begin=mapped.begin(),
        check_call=mapped.check_call(),
        base_call=comments.code(mapped.lanes_call("", "reference", "1", "base"), depth=2),
        lanes_call=comments.code(mapped.lanes_call("", "first", "count", "block"), depth=3),
        common=mapped.statements(mapped.common_fills(outputs, Use.DIFFERENCED), 2),
        differences=mapped.statements(differences, 6 if mapped.skips else 5),
        clears=mapped.statements(mapped.clears(outputs, Use.DIFFERENCED, "row"), 6),
        head=entry.prototype(target.status),
        pointers=comments.code(f"if ({entry.pointers}) {{"),
        call=comments.code(f"status = {call(inner, names)};", depth=3),
        matrix_head=entries[f"{symbol}_difference_matrix"].prototype(target.status),
        covariance_head=entries[f"{symbol}_difference_covariance"].prototype(target.status),
        guarded=kernel.function.checks_domain,
        deviation="deviation" if kernel.function.checks_domain else "sigma",
        zero=target.literal(0.0),
        one=target.literal(1.0),
        minus_one=target.literal(-1.0),
        largest=target.literal(LARGEST[target.scalar]),
    )
