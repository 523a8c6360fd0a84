"""Drivers and script of the static proof: what Frama-C Eva is asked, and how.

Eva follows sets of values through the C. The drivers start it from every bit pattern of every
input; the script tells it where to keep cases apart (in the guards, so that it learns what a
check means) and where to join them (in loops over items, so that it ends).
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.border import SUFFIX as BORDER
from symnav.emit.c.expressions import SINUSOIDS
from symnav.emit.templates import render
from symnav.export.records import Bundle, Tree
from symnav.export.testing.entries import LANES, Array, Entry, Runs, entries
from symnav.trigonometry import LIMIT

SCRIPT = "proof/run_eva.sh"

_MARKS = {ir.Scalar.DOUBLE: "0x1p+1000", ir.Scalar.FLOAT: "0x1p+120F"}
_OUT = {False: "", True: "out."}
_LOWEST = "(-2147483647 - 1)"
_FUNCTION = re.compile(r"^(?P<result>\w[^\n;{}()=]*?)\s+(?P<name>\w+)\([^;{}]*\)\n\{", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Driver:
    """The functions that ask about one entry point."""

    tree: Tree
    entry: Entry

    @property
    def symbol(self) -> str:
        """Name of the entry point."""
        return self.entry.symbol

    @property
    def outputs(self) -> tuple[Array, ...]:
        """What it writes."""
        return self.entry.outputs

    @property
    def call(self) -> str:
        """Name of the function that calls the entry point once."""
        return f"call_{self.symbol}"

    @property
    def head(self) -> str:
        """Parameters of that function: the integers that are looked at one by one."""
        return ", ".join(f"int32_t {name}" for name in self._integers) or "void"

    @property
    def body(self) -> list[str]:
        """The call, and what holds after it."""
        real = self.entry
        lines = list(self._called(real.arguments(_OUT)))
        if real.epochs:
            lines += self._after_many()
            lines += [f"    out = {self.symbol}_marked;", ""]
            lines += comments.code(f"status = {self._text(real.arguments(_OUT, step=False))};")
            return lines + self._states() + self._after_many()
        return lines + self._after_one()

    @property
    def main(self) -> list[str]:
        """Every input, every count, every pointer that is missing."""
        lines = [line for array in self.entry.inputs for line in self._given(array)]
        # Of many epochs only finiteness is stated: there the outputs start from zero.
        lines += [
            f"    mark({self.symbol}_marked.{array.name}, {array.elements});"
            for array in self.entry.results
            if not self.entry.epochs
        ]
        return [*lines, "", *self._missing(), *self._wrong_counts(), *self._calls()]

    def _given(self, array: Array) -> Iterator[str]:
        """Any bits; inside the declared ranges where the caller has seen to that."""
        promise = self.entry.promised.get(array.name)
        yield f"    any_bits({array.name}, sizeof {array.name});"
        if promise is None or not promise.ranges:
            return
        yield f"    for (int32_t k = 0; k < {array.elements // promise.size}; ++k) {{"
        for element, (low, high) in promise.ranges.items():
            place = f"({promise.size} * k) + {element}"
            text = f"{array.name}[{place}] = {self._interval}({low}, {high});"
            yield from comments.code(text, depth=2)
        yield "    }"

    @property
    def _interval(self) -> str:
        """Function of Eva that returns any number between two."""
        kind = self.tree.module.scalar
        return f"Frama_C_{kind.value}_interval"

    @property
    def _integers(self) -> list[str]:
        names = ("epochs", "n", "reference")
        return [name for name in names if name in self.entry.prototype.names]

    def _code(self, status: str) -> str:
        return f"{self.tree.prefix.upper()}_{status}"

    def _text(self, arguments: Sequence[str]) -> str:
        return f"{self.symbol}({', '.join(arguments)})"

    def _called(self, arguments: Sequence[str]) -> Iterator[str]:
        kind = f"{self.tree.prefix}_status_t"
        yield from comments.code(f"{kind} status = {self._text(arguments)};")
        yield ""
        yield from self._states()

    def _states(self) -> list[str]:
        codes = " || ".join(
            f"status == {self._code(status)}" for status in self.entry.prototype.statuses
        )
        first, *rest = textwrap.wrap(f"/*@ assert {codes}; */", width=comments.WIDTH - 8)
        asserted = [f"    {first}", *(f"        {line}" for line in rest)]
        return [*asserted, "    Frama_C_show_each_status(status);"]

    def _after_many(self) -> list[str]:
        return [f"    expect_finite(out.{a.name}, {a.elements});" for a in self.entry.results]

    def _after_one(self) -> list[str]:
        done = f"status == {self._code('OK')}"
        if "PARTIAL" in self.entry.prototype.statuses:
            done = f"({done}) || (status == {self._code('PARTIAL')})"
        if self.entry.referenced:
            done = f"(n > 0) && ({done})"
        lines = [f"    if ({done}) {{"]
        for array in self.entry.results:
            lines += self._written(array)
        lines.append("    } else {")
        lines += [
            f"        expect_unwritten(out.{a.name}, 0, {a.size});" for a in self.entry.results
        ]
        return [*lines, "    }"]

    def _written(self, array: Array) -> Iterator[str]:
        """What holds of an output after success."""
        assert array.runs is not None
        runs, depth = array.runs, 2
        if runs.items != "1":
            yield f"        if (({runs.items}) > 0) {{"
            depth = 3
        pitch = "k" if runs.pitch == 1 else f"{runs.pitch} * k"
        value = f"expect_written(out.{array.name}, {pitch}, {runs.stride}, {runs.items})"
        indent = "    " * depth
        yield f"{indent}for (int32_t k = 0; k < {runs.results}; ++k) {{"
        yield from comments.code(f"Frama_C_show_each_{array.name}(k, {value});", depth=depth + 1)
        yield f"{indent}}}"
        if runs.items != "1":
            yield "        }"
            yield from self._behind(array, runs)

    @staticmethod
    def _behind(array: Array, runs: Runs) -> Iterator[str]:
        """What lies behind the last item was not written."""
        if runs.pitch == 1:
            begin = f"({runs.items}) * {runs.stride}"
            yield f"        expect_unwritten(out.{array.name}, {begin}, {array.size});"
            return
        yield f"        for (int32_t k = 0; k < {runs.results}; ++k) {{"
        begin, end = f"({runs.pitch} * k) + {runs.items}", f"{runs.pitch} * (k + 1)"
        yield f"            expect_unwritten(out.{array.name}, {begin}, {end});"
        yield "        }"

    def _missing(self) -> Iterator[str]:
        """Each pointer null."""
        for array in self.entry.arrays:
            arguments = self.entry.arguments({False: "", True: f"{self.symbol}_marked."})
            place = self.entry.prototype.names.index(array.name)
            arguments[place] = "NULL"
            known = {"epochs": "1", "n": "0", "reference": "0"}
            text = self._text([known.get(argument, argument) for argument in arguments])
            yield from self._expects(text, "NULL")

    def _wrong_counts(self) -> Iterator[str]:
        """Counts that no call takes."""
        good = {"epochs": "1", "n": "1", "reference": "0"}
        beyond = f"Frama_C_interval({self.entry.maximum + 1}, 2147483647)"
        below = f"Frama_C_interval({_LOWEST}, -1)"
        wrong = [("epochs", below, "COUNT")] if self.entry.epochs else []
        if self.entry.counted:
            wrong += [("n", below, "COUNT"), ("n", beyond, "COUNT")]
        if self.entry.referenced:
            at_or_above = "Frama_C_interval(1, 2147483647)"
            wrong += [("reference", below, "INDEX"), ("reference", at_or_above, "INDEX")]
        for name, value, status in wrong:
            known = {**good, name: value}
            arguments = self.entry.arguments({False: "", True: f"{self.symbol}_marked."})
            text = self._text([known.get(argument, argument) for argument in arguments])
            yield from self._expects(text, status)

    def _expects(self, call: str, status: str) -> Iterator[str]:
        yield "    {"
        kind = f"{self.tree.prefix}_status_t"
        yield from comments.code(f"const {kind} status = {call};", depth=2)
        yield ""
        yield f"        /*@ assert status == {self._code(status)}; */"
        yield "    }"

    def _calls(self) -> Iterator[str]:
        """Every count, one after the other."""
        maximum, epochs = self.entry.maximum, self.entry.epochs
        if epochs:
            for count in dict.fromkeys((0, 1, epochs // 2, epochs // 2 + 1)):
                items = (0, 1, maximum) if self.entry.counted else (None,)
                for n in items:
                    yield f"    {self.call}({count}{'' if n is None else f', {n}'});"
        elif self.entry.referenced:
            yield f"    {self.call}(0, 0);"
            for n in sorted({1, 2, 3, LANES, LANES + 1, maximum} & set(range(maximum + 1))):
                for reference in sorted({0, n // 2, n - 1}):
                    yield f"    {self.call}({n}, {reference});"
        elif self.entry.counted:
            yield f"    for (int32_t n = 0; n <= {maximum}; ++n) {{"
            yield f"        {self.call}(n);"
            yield "    }"
        else:
            yield f"    {self.call}();"


def files(bundle: Bundle) -> Mapping[str, str]:
    """Drivers, one file for each function, and the script that analyses them all."""
    text: dict[str, str] = {}
    commands: list[str] = []
    for tree in bundle.trees:
        for function, listed in entries(tree):
            symbol = f"{tree.prefix}_{function.name}"
            path = f"proof/eva_{symbol}.c"
            text[path] = _driver(tree, symbol, path, listed)
            options = {unit: _options(tree, symbol, unit) for unit in _units(tree, symbol)}
            largest = max(array.elements for entry in listed for array in entry.arrays)
            for entry in listed:
                unit = entry.symbol if f"src/{entry.symbol}.c" in tree.files else symbol
                commands.append(
                    f"eva eva_{entry.symbol} {symbol} {unit} {options[unit]} "
                    f"-eva-min-loop-unroll {largest + 1}"
                )
        if f"src/{tree.prefix}_trigonometry.h" in tree.files:
            unit = next(path for path in tree.files if path.endswith(".c"))
            text[f"proof/eva_{tree.prefix}_trigonometry.c"] = _bodies(tree)
            commands.append(
                f"eva eva_{tree.prefix}_sinusoids {tree.prefix}_trigonometry {Path(unit).stem}"
            )
    text[SCRIPT] = render("export/proof/run_eva.sh.j2", name=bundle.name, commands=commands)
    return text


def _bodies(tree: Tree) -> str:
    """Drivers of what other drivers take by contract."""
    return render(
        "export/proof/eva_trigonometry.c.j2",
        file=f"eva_{tree.prefix}_trigonometry.c",
        prefix=tree.prefix,
        real=f"{tree.prefix}_real_t",
        kind=tree.module.scalar.value,
        limit=f"{LIMIT:.1f}{'F' if tree.module.scalar is ir.Scalar.FLOAT else ''}",
    )


def _driver(tree: Tree, symbol: str, path: str, listed: Sequence[Entry]) -> str:
    inputs: dict[str, Array] = {}
    for array in (array for entry in listed for array in entry.inputs):
        known = inputs.get(array.name)
        if known is None or known.elements < array.elements:
            inputs[array.name] = array
    return render(
        "export/proof/eva.c.j2",
        file=path.removeprefix("proof/"),
        symbol=symbol,
        prefix=tree.prefix,
        real=f"{tree.prefix}_real_t",
        mark=_MARKS[tree.module.scalar],
        inputs=list(inputs.values()),
        entries=[Driver(tree, entry) for entry in listed],
    )


def _units(tree: Tree, symbol: str) -> Iterator[str]:
    """Source files of a function, without their ending."""
    yield from (u for u in (symbol, symbol + BORDER) if f"src/{u}.c" in tree.files)


def _options(tree: Tree, symbol: str, unit: str) -> str:
    """Where Eva keeps cases apart and where it joins them, function by function."""
    check = _defined(tree.files[f"src/{tree.prefix}_check.h"])
    text = tree.files[f"src/{symbol}_kernel.h"]
    kernel = _defined(text)
    source = _defined(tree.files[f"src/{unit}.c"])
    truths = [name for name, result in check.items() if result.endswith("bool")]
    statuses = [name for name, result in source.items() if result.endswith("_status_t")]
    levels = dict.fromkeys(check, 20)
    called = {**source, **(kernel if unit == symbol else {})}
    loaders = [name for name in called if name.endswith("_load")]
    levels |= {name: 8 if name in statuses else 0 for name in source}
    levels |= {name: 100 for name in kernel if unit == symbol and not name.endswith("_load_item")}
    levels |= dict.fromkeys(loaders, 100)
    kept = [f"{name}:0" for name in (*truths, *loaders)]  # apart: those that return 0
    split = ",".join((*kept, *(f"{name}:full" for name in statuses)))
    return (
        f"-eva-slevel-function {','.join(f'{name}:{level}' for name, level in levels.items())} "
        f"-eva-split-return-function {split} "
        f"-eva-slevel-merge-after-loop {','.join(statuses)}"
        f"{_by_contract(text) if unit == symbol else ''}"
    )


def _by_contract(kernel: str) -> str:
    """Functions Eva takes by their contract: it cannot follow the parts of an angle together."""
    called = [name for name in SINUSOIDS.values() if f"{name}(" in kernel]
    return f" -eva-use-spec {','.join(called)}" if called else ""


def _defined(text: str) -> dict[str, str]:
    """Functions a file defines, with what they return."""
    return {found["name"]: found["result"] for found in _FUNCTION.finditer(text)}
