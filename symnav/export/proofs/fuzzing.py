"""The fuzz harness of a bundle: every entry point with inputs a fuzzer chooses."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.templates import render
from symnav.export.records import Bundle, Tree
from symnav.export.testing.entries import Array, Entry, entries

SCRIPT = "proof/run_fuzz.sh"

_SIGMA = "{'r', 1, 0.0, 1000.0}"


@dataclass(frozen=True, slots=True)
class Type:
    """A type of elements: how C calls it and how names of functions do."""

    type: str
    name: str
    real: bool


@dataclass(frozen=True, slots=True)
class Harness:
    """The function that gives one entry point what the fuzzer chooses."""

    tree: Tree
    entry: Entry
    function: ir.Function

    @property
    def symbol(self) -> str:
        """Name of the entry point."""
        return self.entry.symbol

    @property
    def lines(self) -> list[str]:
        """Its body."""
        return [*self._declared(), "", *self._called(), "", *self._looked_at(), *self._freed()]

    def _declared(self) -> Iterator[str]:
        entry = self.entry
        if entry.epochs:
            yield f"    const int32_t epochs = (int32_t)(next(in, 1) % {entry.epochs + 1}U);"
        if entry.counted:
            # Two counts that are refused as well, with arrays as for the largest that is not.
            wish = f"(int32_t)(next(in, 1) % {entry.maximum + 3}U) - 1"
            yield f"    const int32_t n = {wish};"
            inside = f"((n < 0) || (n > {entry.maximum})) ? {entry.maximum} : n"
            yield f"    const int32_t count = {inside};"
        if entry.referenced:
            yield f"    const int32_t reference = (int32_t)(next(in, 1) % {entry.maximum + 2}U);"
        given = {
            a.name: argument
            for a, argument in zip(entry.inputs, self.function.arguments, strict=False)
        }
        for array in entry.inputs:
            argument = given.get(array.name) if array.name != "sigma" else None
            yield from self._input(array, argument)
        for array in entry.outputs:
            yield from comments.code(
                f"{array.type} *{array.name} = marked_{name_of(array.type)}({self._room(array)});"
            )

    def _input(self, array: Array, argument: ir.Argument | None) -> Iterator[str]:
        domains = [_SIGMA] if argument is None else list(_domains(argument))
        yield from comments.code(
            f"static const domain_t {array.name}_domains[{len(domains)}] = {{"
            f"{', '.join(domains)}}};"
        )
        per_item = argument is None or argument.item
        times = "count" if per_item else "1"
        if self.entry.epochs:
            times = f"{self.entry.maximum if per_item else 1} * epochs"
        wild = "false" if array.name in self.entry.promised else "true"
        yield from comments.code(
            f"{array.type} *{array.name} = fill_{name_of(array.type)}(in, {array.name}_domains, "
            f"{len(domains)}, {times}, {self.entry.lanes}, {wild});"
        )

    def _room(self, array: Array) -> str:
        if self.entry.epochs:
            return str(array.elements)
        if array.runs is None or array.runs.items == "1" or " * " in array.runs.items:
            return str(array.size)
        if array.runs.pitch == 1:
            return f"count * {array.runs.stride}"
        return f"({array.runs.pitch * (array.runs.results - 1)}) + count"

    def _called(self) -> Iterator[str]:
        kind = f"{self.tree.prefix}_status_t"
        text = f"{self.symbol}({', '.join(self.entry.arguments({False: '', True: ''}))})"
        yield from comments.code(f"const {kind} result = {text};")
        done = [f"(result == {self._code('OK')})"]
        if "PARTIAL" in self.entry.prototype.statuses:
            done.append(f"(result == {self._code('PARTIAL')})")
        yield f"    const bool outcome = {' || '.join(done)};"

    def _looked_at(self) -> Iterator[str]:
        codes = " && ".join(
            f"(result != {self._code(status)})" for status in self.entry.prototype.statuses
        )
        yield from comments.code(f"if ({codes}) {{")
        yield "        abort();"
        yield "    }"
        for array in self.entry.results:
            yield from comments.code(
                f"look_at_{name_of(array.type)}({array.name}, {self._room(array)}, outcome);"
            )

    def _freed(self) -> Iterator[str]:
        yield from (f"    free({array.name});" for array in self.entry.arrays)

    def _code(self, status: str) -> str:
        return f"{self.tree.prefix.upper()}_{status}"


def name_of(kind: str) -> str:
    """A type as part of a name."""
    return kind.removesuffix("_t")


def files(bundle: Bundle) -> Mapping[str, str]:
    """The harness and the script that builds and runs it."""
    harnesses = [
        Harness(tree, entry, function)
        for tree in bundle.trees
        for function, listed in entries(tree)
        for entry in listed
    ]
    return {
        f"proof/fuzz_{bundle.name}.c": render(
            "export/proof/fuzz.c.j2",
            name=bundle.name,
            prefixes=[tree.prefix for tree in bundle.trees],
            types=_types(harnesses),
            entries=harnesses,
        ),
        SCRIPT: render("export/proof/run_fuzz.sh.j2", name=bundle.name),
    }


def _types(harnesses: Sequence[Harness]) -> list[Type]:
    kinds = {array.type: array.real for one in harnesses for array in one.entry.arrays}
    return [Type(kind, name_of(kind), real) for kind, real in sorted(kinds.items())]


def _domains(argument: ir.Argument) -> Iterator[str]:
    kinds = {ir.Kind.QUATERNION: "q", ir.Kind.MATRIX: "m", ir.Kind.INTEGER: "i"}
    for domain in argument.domains:
        kind = kinds.get(domain.kind, "r")
        if kind in "qm":
            yield f"{{'{kind}', {domain.size}, 0.0, 0.0}}"
            continue
        for low, high in zip(domain.lower, domain.upper, strict=True):
            low, high = max(low, -1e30), min(high, 1e30)
            yield f"{{'{kind}', 1, {low!r}, {high!r}}}"
