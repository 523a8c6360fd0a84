"""What editors and type checkers see of a package."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from symnav import ir
from tests.emit_numpy import modules, packages

USE = """
from rover import BACKEND, GpsResult, State, Status, gps, ranges
import rover.native
import rover.native_f32
import rover.numpy

x = State.pack(position=[1.0, 2.0, 3.0])
r = gps(x, lever_arm=[0.1, 0.2, 0.3])
reveal_type(r)
reveal_type(r.jacobian)
reveal_type(gps.value(x, lever_arm=[0.1, 0.2, 0.3]))
reveal_type(gps.bind(x, lever_arm=x[:3]))
reveal_type(State.position)
reveal_type(State.unpack(x).attitude)
reveal_type(rover.native_f32.gps(x, lever_arm=x[:3]).value)
again: GpsResult = rover.numpy.gps(x, lever_arm=x[:3], out=r)
d = ranges.single_difference(
    x, height=1.0, satellite=x, system=[0], slot=[1], reference=2
).item_status
"""

MISUSE = """
from rover import State, gps

gps(State.pack(), arm=[0.1, 0.2, 0.3])
gps(State.pack(), [0.1, 0.2, 0.3])
gps(State.pack(), lever_arm=[0.1, 0.2, 0.3]).jacobean
State.pack(velocity=1.0)
State.velocity
"""


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Files of a package in both scalar types, not compiled."""
    module = modules.module()
    text = packages.text_of(module, replace(module, name="rover_f32", scalar=ir.Scalar.FLOAT))
    return packages.write(text, tmp_path_factory.mktemp("typed") / "rover")


def check(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Runs mypy in a folder, whatever the configuration of this project says."""
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file=", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def test_package_and_its_use_are_typed(package: Path) -> None:
    """Strict checking passes, and types come out as narrow as they are."""
    (package.parent / "use.py").write_text(USE, encoding="utf-8")
    done = check(package.parent, "rover", "use.py")
    assert done.returncode == 0, done.stdout
    revealed = [line.split('"')[1] for line in done.stdout.splitlines() if "Revealed" in line]
    result, jacobian, values, bound, block, attitude, single = revealed
    assert result.endswith("rover.GpsResult]")
    assert re.search(r"float64|floating\[.*_64Bit\]", jacobian)
    assert values == f"tuple[{jacobian}, {jacobian}]"
    assert bound.startswith("def () -> ") and bound.endswith("rover.GpsResult]")
    assert "slice" in block
    assert attitude == jacobian
    assert re.search(r"float32|floating\[.*_32Bit\]", single)


def test_misuse_is_found_before_running(package: Path) -> None:
    """Wrong keywords, positions, fields and blocks."""
    (package.parent / "misuse.py").write_text(MISUSE, encoding="utf-8")
    done = check(package.parent, "misuse.py")
    lines = {int(line.split(":")[1]) for line in done.stdout.splitlines() if ": error:" in line}
    assert lines == {4, 5, 6, 7, 8}, done.stdout


def test_implementations_are_typed_without_their_stubs(package: Path, tmp_path: Path) -> None:
    """The code behind the stubs passes as well."""
    copy = tmp_path / "rover"
    copy.mkdir()
    for file in package.glob("*.py"):
        (copy / file.name).write_text(file.read_text(encoding="utf-8"), encoding="utf-8")
    done = check(tmp_path, "rover")
    assert done.returncode == 0, done.stdout


def keywords(tree: ast.Module, form: str, method: str) -> list[str]:
    """Keyword names of a method in a stub."""
    (own,) = (n for n in tree.body if isinstance(n, ast.ClassDef) and n.name == form)
    (found,) = (n for n in own.body if isinstance(n, ast.FunctionDef) and n.name == method)
    return [argument.arg for argument in found.args.kwonlyargs]


def test_stubs_carry_every_keyword(package: Path) -> None:
    """What completion offers is what the function takes."""
    tree = ast.parse((package / "__init__.pyi").read_text(encoding="utf-8"))
    forms = {"gps": "_Gps", "ranges": "_Ranges", "operations": "_Operations"}
    for function in modules.module().functions:
        if function.name in forms:
            names = [argument.name for argument in function.arguments if argument.name != "x"]
            for method in ("__call__", "value", "bind"):
                assert keywords(tree, forms[function.name], method) == [*names, "out"]
    assert "reference" in keywords(tree, "_Ranges", "single_difference")


def test_stubs_match_what_is_there(package: Path) -> None:
    """Every name a stub promises exists, also in the back ends."""
    imported = packages.load(package)
    for stub, module in (("__init__", imported), ("numpy", packages.backend(imported, "numpy"))):
        tree = ast.parse((package / f"{stub}.pyi").read_text(encoding="utf-8"))
        promised = [
            n.target.id
            for n in tree.body
            if isinstance(n, ast.AnnAssign) and isinstance(n.target, ast.Name)
        ]
        assert len(promised) >= 7
        missing = [n for n in promised if not n.startswith("_") and not hasattr(module, n)]
        assert missing == []
        imports = [n.names for n in tree.body if isinstance(n, ast.ImportFrom) and n.module]
        public = [a.asname for names in imports for a in names if a.asname == a.name]
        assert [n for n in public if n and not hasattr(module, n)] == []
    forms = {
        n.name: n
        for n in ast.parse((package / "__init__.pyi").read_text()).body
        if isinstance(n, ast.ClassDef)
    }
    for name in ("gps", "ranges"):
        for member in forms[f"_{name.capitalize()}"].body:
            if isinstance(member, ast.FunctionDef) and member.name != "__call__":
                assert callable(getattr(getattr(imported, name), member.name))


def test_stub_documents_the_joint_call(package: Path) -> None:
    """Hovering over a function shows shapes, units and frames."""
    tree = ast.parse((package / "__init__.pyi").read_text(encoding="utf-8"))
    (form,) = (n for n in tree.body if isinstance(n, ast.ClassDef) and n.name == "_Gps")
    (joint,) = (n for n in form.body if isinstance(n, ast.FunctionDef) and n.name == "__call__")
    text = ast.get_docstring(joint) or ""
    assert "lever_arm : array_like, shape (..., 3)" in text
    assert "jacobian : array, shape (..., 3, 12)" in text
