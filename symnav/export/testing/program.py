"""The test program of a bundle: plain C, golden vectors and guards, no file and no argument.

What is tested follows from the emitter's own list of entry points: each is called with every
buffer it takes, by number, and what it must have stored follows from its form. An entry point of
a form that is not known here is an error, so that none can be left untested.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any, Protocol

from symnav import ir
from symnav.emit.c import sections
from symnav.emit.c.difference import LARGEST
from symnav.emit.c.header import Section
from symnav.emit.c.literals import integer_bounds
from symnav.emit.c.pieces import Parameter
from symnav.emit.c.store import is_jacobian
from symnav.emit.templates import render
from symnav.export.arithmetic.evaluation import declared, read_domains
from symnav.export.arithmetic.slack import UNITS
from symnav.export.records import Bundle, Tree
from symnav.export.testing.golden import Golden, golden
from symnav.export.testing.tables import Tables, hexadecimal, short
from symnav.export.testing.turns import turns

#: How an entry point stores, by what stands behind the name of its function.
FORMS: Mapping[str, str] = {
    "": "DENSE",
    "_value": "DENSE",
    "_jacobian": "DENSE",
    "_nz": "NONZEROS",
    "_batch": "STACKED",
    "_batch_nz": "PACKED",
    "_blocks": "BLOCKS",
    "_sd": "DIFFERENCES",
    "_difference_matrix": "DENSE",
    "_difference_covariance": "DENSE",
    "_check": "BORDER",
}


class EntryPoint(Protocol):
    """A public symbol, as the emitter lists it."""

    @property
    def symbol(self) -> str:
        """Its name."""

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """In order."""


_PAIR = ("_difference_matrix", "_difference_covariance")
_GAP = 4  # elements behind every output that must stay untouched


def files(bundle: Bundle) -> dict[str, str]:
    """The test program and its headers, below ``test/``."""
    first = bundle.trees[0].module
    trees = [tree for tree in bundle.trees if tree.module.functions]
    text = {
        f"test/test_{bundle.name}.c": render(
            "export/test/test.c.j2",
            name=bundle.name,
            generator=first.generator,
            digest=first.digest[:16],
            trees=[tree.prefix for tree in trees],
        )
    }
    for tree in trees:
        text |= _tree_files(bundle, tree)
    return text


def _tree_files(bundle: Bundle, tree: Tree) -> dict[str, str]:
    derivations = {derivation.name: derivation for derivation in bundle.derivations}
    module = tree.module
    tables = Tables(f"test_{tree.prefix}", f"{tree.prefix}_real_t", module.scalar)
    functions = [
        _Function(
            section,
            function,
            golden(bundle.spec, derivations[function.name], function, module.scalar),
            tables,
            _lanes(tree, section.kernel.symbol),
        )
        for section, function in zip(sections(module), module.functions, strict=True)
    ]
    contexts = [function.context() for function in functions]
    double = module.scalar is ir.Scalar.DOUBLE
    common: dict[str, Any] = {
        "p": tree.prefix,
        "m": tree.prefix.upper(),
        "t": tables.prefix,
        "real": tables.real,
        "generator": module.generator,
        "digest": module.digest[:16],
        "zero": "0.0" if double else "0.0F",
        "one": "1.0" if double else "1.0F",
        "fabs": "fabs" if double else "fabsf",
        "nextafter": "nextafter" if double else "nextafterf",
        "units": f"{UNITS:g}",
        "layout": f"0x{module.state.digest[:8].upper()}U",
        "sizes": _sizes(functions),
        "differences": any(function.is_differenced for function in functions),
        "tables": tables.listed,
        "functions": contexts,
        "entries": [entry for context in contexts for entry in context["adapters"]],
        "macros": [pair for context in contexts for pair in context["macros"]],
    }
    return {
        f"test/{tree.prefix}_{part}.h": render(f"export/test/{part}.h.j2", **common)
        for part in ("harness", "expect", "checks", "golden", "cases")
    }


def _lanes(tree: Tree, symbol: str) -> int:
    """Epochs that a function evaluates side by side, as its C says."""
    pattern = re.compile(rf"^#define {symbol.upper()}_LANES (\d+)$", re.MULTILINE)
    found = [int(number) for text in tree.files.values() for number in pattern.findall(text)]
    return max(found, default=1)


@dataclass(frozen=True)
class _Function:
    """One function of a tree with its golden vectors, on its way to C."""

    section: Section
    function: ir.Function
    golden: Golden
    tables: Tables
    lanes: int

    @property
    def is_differenced(self) -> bool:
        """True when it has a matrix and a covariance of differences."""
        return self.function.single_difference

    @property
    def fallible(self) -> bool:
        """True when something about an item is checked."""
        arguments = self.function.arguments
        return self._checked or any(a.integer for a in arguments if a.item)

    @property
    def _checked(self) -> bool:
        """True when the range of every input is looked at, in every call or in one of its own."""
        return self.function.checks_inputs or self.function.checks_at_border

    @property
    def epochs(self) -> int:
        """Epochs of a long batch: beyond a block, and beyond the samples."""
        if self.function.maximum is not None:
            return self.golden.samples + 2
        return max(self.lanes + 3, self.golden.samples + 2)

    def context(self) -> dict[str, Any]:
        """What the template of the cases needs."""
        function, golden_of = self.function, self.golden
        groups, turned = self._groups(), self._turns()
        entries = self.section.entries
        kind = f"test_{self.section.kernel.target.prefix}".upper()
        plain = [entry for entry in entries if self._suffix(entry) not in _PAIR]
        pair = [entry for entry in entries if self._suffix(entry) in _PAIR]
        rejects = self.fallible and function.items is ir.Items.REJECT
        numbers = (
            *(golden_of.samples, golden_of.items, function.maximum or 0, self.epochs),
            self.lanes,
            *(int(function.column_major), int(rejects), int(function.checks_domain)),
            int(function.checks_at_border),
            *(len(function.arguments), len(function.outputs), len(groups), len(turned)),
            len(plain),
        )
        return {
            "local": self._named("of"),
            "inputs": [self._input(argument) for argument in function.arguments],
            "outputs": [self._output(output) for output in function.outputs],
            "groups": groups,
            "turns": turned,
            "entries": [self._entry(entry, kind) for entry in plain],
            "pair": [self._entry(entry, kind) for entry in pair],
            "adapters": [self._adapter(entry) for entry in entries],
            "numbers": numbers,
            "shared": self.tables.bytes(
                f"{function.name}_shared", golden_of.shared, "Status of samples."
            ),
            "status": self.tables.bytes(
                f"{function.name}_status", golden_of.status.ravel(), "Status of items."
            ),
            "largest": hexadecimal(LARGEST[self.tables.scalar], self.tables.scalar),
            "macros": [(c.name, c.value) for c in self.section.constants],
        }

    def _named(self, what: str) -> str:
        return f"{self.tables.prefix}_{what}_{self.function.name}"

    def _suffix(self, entry: EntryPoint) -> str:
        suffix = entry.symbol.removeprefix(self.section.kernel.symbol)
        if suffix not in FORMS:
            raise AssertionError(f"no test is known for the entry point {entry.symbol}")
        return suffix

    def _input(self, argument: ir.Argument) -> list[str]:
        stem = f"{self.function.name}_{argument.name}"
        values = self.golden.inputs[argument.name].ravel()
        head = [str(argument.size), str(int(argument.item))]
        if argument.integer:
            limits = [
                int(text)
                for domain in argument.domains
                for pair in zip(domain.lower, domain.upper, strict=True)
                for text in integer_bounds(*pair)
            ]
            return [
                *(*head, "NULL", "NULL", "NULL"),
                self.tables.integers(stem, values, f"Input {argument.name}."),
                self.tables.integers(f"{stem}_limits", limits, "Declared range: low, high."),
            ]
        ends = [
            declared(low, high, self.tables.scalar)
            for domain in argument.domains
            for low, high in zip(domain.lower, domain.upper, strict=True)
        ]
        remark = "Declared range, in the type"
        return [
            *head,
            self.tables.reals(stem, values, f"Input {argument.name}, sample by sample."),
            self.tables.reals(f"{stem}_lower", (low for low, _ in ends), f"{remark}: lower ends."),
            self.tables.reals(
                f"{stem}_upper", (high for _, high in ends), f"{remark}: upper ends."
            ),
            "NULL",
            "NULL",
        ]

    def _output(self, output: ir.Output) -> list[str]:
        stem, count = f"{self.function.name}_out_{output.name}", len(output.entries)
        rows, columns = _shape(output)
        values = self.golden.outputs[output.name].ravel()
        allowed = None if self.golden.slack is None else self.golden.slack[output.name].ravel()
        places = [self._place(output, entry) for entry in output.entries]
        listed = is_jacobian(output) and bool(output.entries)
        table = f"{self.section.kernel.symbol}_{output.name}"
        return [
            *(str(rows), str(columns), str(int(output.item)), str(int(is_jacobian(output)))),
            str(count),
            self.tables.places(
                f"{stem}_places", places, f"Non-zeros of {output.name}: row, column."
            ),
            self.tables.reals(stem, values, f"Non-zeros of {output.name}."),
            "NULL"
            if allowed is None or not allowed.any()
            else self.tables.reals(
                f"{stem}_slack", map(short, allowed), f"How far {output.name} may be off."
            ),
            f"{table}_rows" if listed and len(output.shape) > 1 else "NULL",
            f"{table}_columns" if listed else "NULL",
        ]

    def _place(self, output: ir.Output, entry: ir.Entry) -> tuple[int, int, int, int]:
        index = entry.index if len(entry.index) > 1 else _spread(output, entry.index)
        row, column = index
        if isinstance(row, ir.Offset):
            raise AssertionError(f"{self.function.name}: no test is known for rows that move")
        if not isinstance(column, ir.Offset):
            return row, column, -1, 0
        names = [argument.name for argument in self.function.arguments]
        assert isinstance(column.slot.index, int)
        return row, column.base, names.index(column.slot.argument), column.slot.index

    def _groups(self) -> list[list[str]]:
        found = []
        for k, argument in enumerate(self.function.arguments):
            for domain in read_domains(argument):
                if self._checked or argument.integer:
                    free = domain.kind is ir.Kind.REAL
                    status = f"{self.tables.prefix.upper()}_ANY" if free else "0"
                    found.append([str(k), str(domain.start), str(domain.size), status, "NULL"])
        return found

    def _turns(self) -> list[list[str]]:
        found = []
        for k, argument in enumerate(self.function.arguments):
            for domain in read_domains(argument):
                if not self._checked or domain.kind not in _TURNING:
                    continue
                for number, turn in enumerate(turns(domain, self.tables.scalar)):
                    wish = f"{self.function.name}_{domain.name}_turn_{number}"
                    table = self.tables.reals(wish, turn.elements, f"Elements of {domain.name}.")
                    bad = f"(int32_t){self.section.kernel.target.code(ir.Status.QNORM)}"
                    status = f"{self.tables.prefix.upper()}_ANY" if turn.accepted else bad
                    found.append([str(k), str(domain.start), str(domain.size), status, table])
        return found

    def _entry(self, entry: EntryPoint, kind: str) -> list[str]:
        mask = sum(1 << self._buffers[p.name][0] for p in entry.parameters if p.pointer)
        return [
            f'"{entry.symbol}"',
            f"{self.tables.prefix}_call_{entry.symbol}",
            f"{kind}_{FORMS[self._suffix(entry)]}",
            f"0x{mask:X}U" if mask < 2**32 else f"0x{mask:X}ULL",
        ]

    def _adapter(self, entry: EntryPoint) -> dict[str, Any]:
        return {
            "adapter": f"{self.tables.prefix}_call_{entry.symbol}",
            "symbol": entry.symbol,
            "arguments": [self._argument(p.name, pointer=p.pointer) for p in entry.parameters],
        }

    def _argument(self, name: str, *, pointer: bool) -> str:
        if pointer:
            number, kind = self._buffers[name]
            return f"({kind} *)call->buffer[{number}]"
        if name in ("n", "epochs", "reference"):
            return f"call->{name}"
        return f"call->step[{self._steps[name]}]"

    @property
    def _steps(self) -> dict[str, int]:
        arguments = self.section.kernel.function.arguments
        return {f"{argument.name}_step": k for k, argument in enumerate(arguments)}

    @property
    def _buffers(self) -> dict[str, tuple[int, str]]:
        """Number and type of every buffer, by the name of the parameter that takes it."""
        function = self.section.kernel.function  # whose arguments are named as in the C
        real = self.tables.real
        found = {
            argument.name: (k, "const int32_t" if argument.integer else f"const {real}")
            for k, argument in enumerate(function.arguments)
        }
        first = len(function.arguments)
        for k, output in enumerate(function.outputs):
            found[output.name] = found[f"{output.name}_nz"] = (first + k, real)
        first += len(function.outputs)
        found["status"], found["item_status"] = (first, "uint8_t"), (first + 1, "uint8_t")
        found["sigma"] = (first + 2, f"const {real}")
        found["matrix"] = found["covariance"] = (first + 3, real)
        return found


_TURNING = (ir.Kind.QUATERNION, ir.Kind.MATRIX)


def _spread(
    output: ir.Output, index: Sequence[int | ir.Offset]
) -> tuple[int | ir.Offset, int | ir.Offset]:
    """Row and column of an element of a scalar or a vector; a Jacobian's vector is a row."""
    (only,) = index or (0,)
    return (0, only) if is_jacobian(output) else (only, 0)


def _shape(output: ir.Output) -> tuple[int, int]:
    """Rows and columns of an output, per item."""
    if len(output.shape) > 1:
        return output.shape[0], output.shape[1]
    length = prod(output.shape)
    return (1, length) if is_jacobian(output) else (length, 1)


def _sizes(functions: Sequence[_Function]) -> dict[str, int]:
    """Elements that the largest call needs."""
    found = dict.fromkeys(
        ("buffers", "inputs", "given", "integers", "stored", "largest", "bytes"), 1
    )
    for of in functions:
        function, items, epochs = of.function, of.golden.items, of.epochs
        filled = epochs + of.lanes  # whole blocks
        most = function.maximum or 1
        given = {
            kind: max(
                sum(a.size * (most if a.item else 1) for a in arguments),
                filled * sum(a.size * (items if a.item else 1) for a in arguments),
            )
            for kind, arguments in (
                ("given", [a for a in function.arguments if not a.integer]),
                ("integers", [a for a in function.arguments if a.integer]),
            )
        }
        single = [
            _GAP + prod(output.shape) * max(most, filled * (items if output.item else 1))
            for output in function.outputs
        ]
        needed = {
            **given,
            "buffers": len(function.arguments) + len(function.outputs) + 4,
            "inputs": len(function.arguments),
            "stored": sum(single),
            "largest": max(single),
            "bytes": max(most, epochs * items),
        }
        if of.is_differenced:
            needed["given"] = max(needed["given"], most + 1)
            needed["stored"] = max(needed["stored"], most * most)
            needed["largest"] = max(needed["largest"], most * most)
        found = {name: max(size, needed[name]) for name, size in found.items()}
    return found
