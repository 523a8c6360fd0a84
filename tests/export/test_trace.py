"""Every line the trace table names does what the table says, shown by changing it.

The kernels are compiled with a switch in each of those statements: thrown in an output's statement
it must change that very element of the dense output and no other, in a guard's it must give the
status the table names, and in an input's a NaN there must be refused.
"""

from __future__ import annotations

import csv
import ctypes
import io
import re
import shutil
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

import pytest

from symnav import ir
from symnav.emit import c
from symnav.emit.c.header import Section
from symnav.export.documents.example import values_of
from symnav.export.records import Tree
from tests.export.bundles import OUTER, QUICK, bundle_of, cases, records_of, run

pytestmark = pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")

SHIFT = 1024.0
SWITCHES = f"""\
#include <math.h>
extern int thrown;
#define SHIFT(k) ((thrown == (k)) ? {SHIFT} : 0.0)
#define FAIL(k) (thrown == (k))
"""
Row = Mapping[str, str]


def rows_of(folder: Path) -> list[Row]:
    """The table as anybody reads it."""
    return list(csv.DictReader(io.StringIO((folder / "docs/trace.csv").read_text())))


def switched(statement: str, row: Row, k: int, copies: Mapping[tuple[str, str], str]) -> str:
    """A statement with switch number k.

    Args:
        statement: as it stands in the file.
        row: what the table says about it.
        k: number of the switch.
        copies: text of the copy of an input, by function and element.
    """
    if row["kind"] == "output":
        return re.sub(r" = (.*);$", rf" = SHIFT({k}) + (\1);", statement, flags=re.DOTALL)
    if row["kind"] == "guard":
        return re.sub(r" =\s(.*);$", rf" = !FAIL({k}) && \1;", statement, flags=re.DOTALL)
    # Elements of an epoch are a stride apart, which is one where there is one epoch.
    name, index = row["element"].rstrip("]").split("[")
    strides = ("stride", "in->stride")
    forms = [f"{name}[{index}]", *(f"{name}[{index} * {stride}]" for stride in strides)]
    forms += [f"{name}[{stride}]" for stride in strides if index == "1"]
    if row["kind"] == "range":
        forms.append(copies.get((row["function"], row["element"]), ""))
    (element,) = (form for form in forms if form and re.search(whole(form), statement))
    # Elements of a rotation are looked at where its norm does not bound them.
    statement = re.sub(r"\bbounded\b", f"(!FAIL({k}) && bounded)", statement)
    return re.sub(whole(element), rf"(FAIL({k}) ? {bad(row)} : \1)", statement, count=1)


def whole(form: str) -> str:
    """Pattern of a text that does not go on, with the pointer it may be read through."""
    return rf"((?:\bin->)?\b{re.escape(form)}(?!\w))"


def bad(row: Row) -> str:
    """A value no guard lets pass."""
    return "INT32_MAX" if "take_index" in row["statement"] or "index" in row["statement"] else "NAN"


def instrument(folder: Path, rows: list[Row]) -> None:
    """Put a switch into every statement of the table; lines keep their numbers."""
    by_file: dict[str, list[tuple[int, Row]]] = {}
    copies = {
        (row["function"], row["element"]): row["statement"].split(" = ")[0]
        for row in rows
        if row["kind"] == "input" and "->" in row["statement"].split(" = ")[0]
    }
    for k, row in enumerate(rows):
        by_file.setdefault(row["file"], []).append((k, row))
    for path, listed in by_file.items():
        lines = (folder / path).read_text().splitlines()
        for k, row in sorted(listed, key=lambda pair: -int(pair[1]["line"])):
            first = int(row["line"]) - 1
            last = first
            bare = [re.sub(r"/\*.*?\*/", "", line).rstrip() for line in lines]
            while not bare[last].endswith(";"):
                last += 1
            statement = "\n".join(bare[first : last + 1])
            # Several elements are judged by one statement, which has switches already then.
            assert " ".join(statement.split()) == row["statement"] or row["kind"] == "range"
            lines[first : last + 1] = switched(statement, row, k, copies).split("\n")
        (folder / path).write_text("\n".join(lines) + "\n")


@dataclass(frozen=True)
class Machine:
    """A compiled tree and a way to call its dense entry points."""

    library: ctypes.CDLL

    def throw(self, switch: int) -> None:
        ctypes.c_int.in_dll(self.library, "thrown").value = switch

    def call(self, tree: Tree, section: Section) -> tuple[ir.Status, dict[str, list[float]]]:
        """Status of the call, or of its only item, and the outputs."""
        entry, function = section.entries[0], section.kernel.function
        real: Any = ctypes.c_double if tree.module.scalar is ir.Scalar.DOUBLE else ctypes.c_float
        given = {a.name: a for a in function.arguments}
        items = function.maximum or 1
        passed: dict[str, Any] = {}
        for parameter in entry.parameters:
            name = parameter.name
            if name in given:
                passed[name] = array(real, given[name])
            elif name == "n":
                passed[name] = ctypes.c_int32(1)
            elif name == "item_status":
                passed[name] = (ctypes.c_uint8 * items)()
            else:
                shape = next(o.shape for o in function.outputs if o.name == name)
                passed[name] = (real * (prod(shape) * items))()
        border = [other for other in section.entries if other.border]
        for called in (*border, entry):
            own = [passed[parameter.name] for parameter in called.parameters]
            status = ir.Status(getattr(self.library, called.symbol)(*own))
            if status is not ir.Status.OK:
                break
        if status is ir.Status.PARTIAL:
            status = ir.Status(passed["item_status"][0])
        results = [p.name for p in entry.parameters if p.direction == "out"]
        return status, {name: list(passed[name]) for name in results}


def array(real: Any, argument: ir.Argument) -> Any:
    """An argument of one item, inside its ranges."""
    values = values_of(argument)
    if argument.integer:
        return (ctypes.c_int32 * len(values))(*(int(value) for value in values))
    return (real * len(values))(*values)


def place(row: Row, function: ir.Function) -> tuple[str, int]:
    """Output and flat index of an element of the table, slots taken as zero."""
    name = row["element"].partition("[")[0]
    output = next(o for o in function.outputs if o.name == name)
    index = [int(part.split()[0]) for part in re.findall(r"\[([^]]+)\]", row["element"])]
    assert len(index) == len(output.shape)
    axes = list(zip(output.shape, index, strict=True))
    if function.column_major and name.startswith("jacobian"):
        axes.reverse()
        if function.maximum is not None:  # columns are as long as there can be items
            axes.append((function.maximum, 0))
    flat = 0
    for length, step in axes:
        flat = flat * length + step
    return name, flat


@pytest.fixture
def machine(model: str, scalar: str, tmp_path: Path) -> tuple[Machine, list[Row]]:
    folder = bundle_of(model, scalar)
    rows = rows_of(folder)
    shutil.copytree(folder, tmp_path / "bundle")
    instrument(tmp_path / "bundle", rows)
    (tmp_path / "switches.h").write_text(SWITCHES)
    (tmp_path / "thrown.c").write_text("int thrown = -1;\n")
    sources = sorted((tmp_path / "bundle/src").glob("*.c"))
    flags = ["-std=c99", "-shared", "-fPIC", "-include", "switches.h", "-Ibundle/include"]
    run(["gcc", *flags, *sources, "thrown.c", "-lm", "-o", "traced.so"], tmp_path)
    return Machine(ctypes.CDLL(str(tmp_path / "traced.so"))), rows


def sections(model: str, scalar: str) -> Iterator[tuple[Tree, Section]]:
    for tree in records_of(model, scalar).trees:
        for section in c.sections(tree.module):
            yield tree, section


def is_reading(row: Row) -> bool:
    """True where an input is read and not looked at."""
    return row["kind"] == "input" and "|=" not in row["statement"]


@pytest.mark.parametrize(("model", "scalar"), cases((*QUICK, OUTER)))
def test_lines_do_what_the_table_says(
    model: str, scalar: str, machine: tuple[Machine, list[Row]]
) -> None:
    compiled, rows = machine
    for tree, section in sections(model, scalar):
        compiled.throw(-1)
        status, usual = compiled.call(tree, section)
        assert status is ir.Status.OK, section.kernel.symbol
        for k, row in enumerate(rows):
            if row["function"] != section.kernel.symbol:
                continue
            compiled.throw(k)
            status, found = compiled.call(tree, section)
            if row["kind"] == "guard":
                assert status.name == row["element"].split()[0], row
            elif section.kernel.function.checks_at_border and is_reading(row):
                # What the one item does not choose among its clock biases changes nothing.
                idle = (row["function"], row["element"]) == ("rover_range", "x[20]")
                assert (status is ir.Status.OK and str(found) == str(usual)) == idle, row
            elif row["kind"] in ("input", "range"):
                assert status is ir.Status.RANGE, row
            else:
                assert status is ir.Status.OK, row
                name, flat = place(row, section.kernel.function)
                moved = {
                    (output, index): found[output][index] - value
                    for output, values in usual.items()
                    for index, value in enumerate(values)
                    if found[output][index] != value
                }
                assert moved == {(name, flat): pytest.approx(SHIFT, rel=1e-4)}, row


@pytest.mark.parametrize(("model", "scalar"), cases((*QUICK, OUTER)))
def test_nothing_is_left_out(model: str, scalar: str) -> None:
    rows = rows_of(bundle_of(model, scalar))
    for _, section in sections(model, scalar):
        function = section.kernel.function
        own = [row for row in rows if row["function"] == section.kernel.symbol]
        kinds = [row["kind"] for row in own]
        checks = [s for s in (*function.shared, *function.item) if isinstance(s, ir.Check)]
        assert kinds.count("output") == sum(len(o.entries) for o in function.outputs)
        assert kinds.count("guard") == len(checks)
        read = sum(
            domain.size
            for argument in function.arguments
            for domain in argument.domains
            if domain.kind is not ir.Kind.UNREAD
        )
        found = [
            {row["element"] for row in own if row["kind"] == kind} for kind in ("input", "range")
        ]
        judged = sum(
            domain.size
            for argument in function.arguments
            for domain in argument.domains
            if domain.kind is not ir.Kind.UNREAD and not (argument.item or argument.integer)
        )
        assert len(found[0] | found[1]) == read
        assert kinds.count("range") == len(found[1]) == judged
        assert all(row["equation"] and row["source"] and row["meaning"] for row in own)
