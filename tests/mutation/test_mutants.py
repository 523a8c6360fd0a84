"""The mutants themselves: which sites there are, and that each changes what it says."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.mutation import suites, table
from tests.mutation.mutants import Mutant, files, mutants, mutants_of, mutated
from tests.mutation.run import PROJECT, sample

SOURCE = '''
def f(a: "int - x", b, m, q, k):
    """One - two."""
    c = cross(a, b) - skew(a, b)
    d = [m[3 * i + j] for i in range(k - 1) for j in range(3)]
    e = transpose(m)[i][j] + -a[k - 1]
    names = ["x"] + list(k) + [f"-{b - 1}"]
    names += e[k][k]
    return product(*q), Operation.SUB, "-", m.T, tuple(zip(*m))


class C:
    value = 1 - 2
'''
CHANGES = [
    "cross(a, b) - skew(a, b) -> cross(a, b) + skew(a, b)",
    "cross(a, b) -> cross(b, a)",
    "skew(a, b) -> skew(a, -b)",
    "3 * i + j -> 3 * j + i",
    "transpose(m)[i][j] + -a[k - 1] -> transpose(m)[i][j] - -a[k - 1]",
    "transpose(m)[i][j] -> transpose(m)[j][i]",
    "transpose(m) -> m",
    "-a[k - 1] -> a[k - 1]",
    "product(*q) -> product(*q[::-1])",
    "Operation.SUB -> Operation.ADD",
    "'-' -> '+'",
    "'-' -> '+'",
    "m.T -> m",
    "zip(*m) -> m",
    "1 - 2 -> 1 + 2",
]
FOUND = mutants_of("f.py", SOURCE)


def test_sites() -> None:
    """Arithmetic counts; indices, ranges, text, lists and annotations do not."""
    assert sorted(m.change for m in FOUND) == sorted(CHANGES)
    assert {m.function for m in FOUND} == {"f", "C"}


@pytest.mark.parametrize("mutant", FOUND, ids=lambda m: str(m.id))
def test_one_change_each(mutant: Mutant) -> None:
    """The text differs, and going through it again finds the rest unchanged."""
    before, after = ast.unparse(ast.parse(SOURCE)), ast.unparse(mutated(SOURCE, mutant))
    assert before != after
    lines = zip(before.splitlines(), after.splitlines(), strict=True)
    assert len([1 for a, b in lines if a != b]) == 1


def test_names_are_stable() -> None:
    """A change of one function leaves the mutants of the others as they are."""
    moved = "import math\n\n\nX = 5\n" + SOURCE.replace("1 - 2", "1 - 3")
    before = {m.id: (m.change, m.digest) for m in mutants_of("f.py", SOURCE)}
    after = {m.id: (m.change, m.digest) for m in mutants_of("f.py", moved)}
    assert {k: v for k, v in before.items() if "::f#" in k} == {
        k: v for k, v in after.items() if "::f#" in k
    }
    assert before["f.py::C#1"][1] != after["f.py::C#1"][1]


def test_every_file_of_the_mathematics_is_there() -> None:
    """Names are unique; every room has its sites."""
    everything = mutants(PROJECT)
    assert len({m.id for m in everything}) == len(everything) > 300
    holding = {m.file for m in everything}
    for name in ("graph", "elimination", "derive", "binding"):
        assert f"symnav/{name}.py" in holding
    for room in ("quantities", "equations", "blocks", "frames", "lower", "emit"):
        assert any(file.startswith(f"symnav/{room}/") for file in holding), room
    for name in ("symnav/emit/c/expressions.py", "symnav/emit/numpy/expressions.py"):
        assert name in holding


def test_every_file_has_its_tests() -> None:
    """All of them exist; what no mutant meets is left out by name."""
    for file in files(PROJECT):
        assert suites.quick(PROJECT, file) and suites.full(PROJECT, file)
    folder = PROJECT / "tests"
    there = {p.name for p in folder.iterdir() if p.is_dir() or p.name.startswith("test_")}
    there -= {"__pycache__"}
    assert suites.listed() | set(suites.LEFT_OUT) == there
    assert not suites.listed() & set(suites.LEFT_OUT)


def test_a_misspelt_name_is_an_error(tmp_path: Path) -> None:
    """A folder that is not there would spare every mutant that only it notices."""
    with pytest.raises(FileNotFoundError, match=r"suites\.py lists core"):
        suites.full(tmp_path, "symnav/graph.py")


def test_samples_follow_the_seed() -> None:
    """The same mutants for the same seed."""
    everything = mutants(PROJECT)
    assert sample(everything, 30, 1) == sample(everything, 30, 1) != sample(everything, 30, 2)
    assert sample(everything, None, 1) == everything


def test_table(tmp_path: Path) -> None:
    """Written rows read back, in the order of the mutants; a change makes them stale."""
    path = tmp_path / "table.csv"
    first, second = mutants_of("f.py", SOURCE)[:2]
    rows = [table.row(second, "full", None), table.row(first, "quick", "tests/t.py::test_a")]
    table.write(rows, [first, second], path)
    read = table.read(path)
    assert list(read) == [first.id, second.id]
    assert read[first.id].killed_by == "tests/t.py::test_a"
    assert (read[second.id].verdict, read[second.id].stage) == ("survived", "full")
    assert table.is_fresh(first, read) and table.is_settled(second, read, thorough=True)
    changed = mutants_of("f.py", SOURCE.replace("return product", "return 1 * product"))[0]
    assert changed.id == first.id and not table.is_fresh(changed, read)
    quick = {second.id: table.row(second, "quick", None)}
    assert table.is_settled(second, quick, thorough=False)
    assert not table.is_settled(second, quick, thorough=True)
