"""Finding the compiled extension: what is refused, what is advised, what is used instead."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from symnav import build
from symnav.emit import c
from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend

MODULE = modules.module(modules.gps(), name="small")
ARM = np.array([1.0, 2.0, 3.0])


@pytest.fixture(scope="module")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A compiled package that no test changes."""
    folder = tmp_path_factory.mktemp("compiled") / "small"
    package = packages.write({**packages.text_of(MODULE), **c.emit(MODULE)}, folder)
    build.build(package)
    return package


@pytest.fixture
def copy(compiled: Path, tmp_path: Path) -> Path:
    """A copy to spoil."""
    return Path(shutil.copytree(compiled, tmp_path / "small"))


def missing(package: Path, name: str = "native") -> str:
    """What importing a back end says, while the package itself works."""
    imported = packages.load(package)
    x = imported.State.pack()
    assert imported.gps(x, lever_arm=ARM).value.tolist() == [1.5, 2.5, 3.5]
    with pytest.raises(ImportError) as caught:
        backend(imported, name)
    return str(caught.value)


def test_compiled_package_uses_it(compiled: Path) -> None:
    """The extension is found by what ``_build.json`` says."""
    assert packages.load(compiled).BACKEND == "native"


def test_not_compiled(tmp_path: Path) -> None:
    """The advice names the command and how to get a compiler."""
    package = packages.write(packages.text_of(MODULE), tmp_path / "small")
    assert packages.load(package).BACKEND == "numpy"
    message = missing(package)
    assert "small: not compiled yet; run: symnav build " in message
    assert "apt install gcc libc6-dev python3-dev" in message


def test_sources_changed(copy: Path) -> None:
    """Compiled from other C than what lies beside it: refused, and the file is named."""
    source = copy / "c" / "src" / "small_gps.c"
    source.write_text(source.read_text() + "\n")
    message = missing(copy)
    assert (
        "small: sources changed since the build (c/src/small_gps.c); run: symnav build" in message
    )
    assert packages.load(copy).BACKEND == "numpy"


def test_source_removed(copy: Path) -> None:
    """A source that is gone counts as changed."""
    (copy / "c" / "src" / "small_gps.c").unlink()
    assert "sources changed" in missing(copy)


def test_source_added(copy: Path) -> None:
    """So does one that was not there when the extension was built."""
    (copy / "c" / "src" / "small_extra.c").write_text("int small_extra;\n")
    assert "sources changed since the build (c/src/small_extra.c)" in missing(copy)


def test_other_interpreter(copy: Path) -> None:
    """An extension of another Python is not even tried."""
    for file in copy.glob("_small_*"):
        file.rename(file.with_name(file.name.split(".")[0] + ".cpython-27-old.so"))
    assert "was built for another Python" in missing(copy)


def test_broken_extension(copy: Path) -> None:
    """A file that is no extension is an ImportError like the others."""
    for file in copy.glob("_small_*.so"):
        file.write_bytes(b"not an extension")
    assert "small" in missing(copy)
    assert packages.load(copy).BACKEND == "numpy"


def test_back_end_not_built(copy: Path) -> None:
    """CasADi's C is optional."""
    assert "no casadi extension was built" in missing(copy, "casadi")


def test_broken_record(copy: Path) -> None:
    """A build record that cannot be read asks for a build."""
    (copy / "_build.json").write_text("{")
    assert "_build.json cannot be read; run: symnav build" in missing(copy)
    (copy / "_build.json").write_text(json.dumps({"native": "x"}))
    assert "_build.json cannot be read" in missing(copy)


def test_back_ends_are_attributes(compiled: Path) -> None:
    """``rover.numpy`` works without importing it; what does not exist is an AttributeError."""
    imported = packages.load(compiled)
    assert isinstance(imported.numpy, ModuleType)
    with pytest.raises(AttributeError, match="has no attribute 'fortran'"):
        _ = imported.fortran


def test_package_stands_on_its_own(compiled: Path) -> None:
    """NumPy and the cffi run time are all a generated package needs."""
    code = (
        "import sys, small, small.native, small.numpy\n"
        "heavy = {'symnav', 'jinja2', 'sympy', 'casadi', 'pydantic', 'click', 'cffi'}\n"
        "assert small.BACKEND == 'native'\n"
        "print(sorted(heavy & {name.partition('.')[0] for name in sys.modules}))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=compiled.parent,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize("spoil", [np.asfortranarray, lambda x: x.astype(np.float32)])
def test_straight_way_and_general_way_agree(
    compiled: Path, spoil: Callable[[object], object]
) -> None:
    """Arguments that do not fit the straight way give the same through the other."""
    gps = packages.load(compiled).gps
    x = np.round(packages.states(np.random.default_rng(1)), 2)
    x[3:7] = (0.6, 0.0, 0.8, 0.0)
    straight = gps(x, lever_arm=ARM)
    other = gps(spoil(x.astype(np.float64)), lever_arm=spoil(ARM))
    assert other.value == pytest.approx(straight.value, rel=1e-6)
    assert type(other) is type(straight)
    assert type(straight.status) is type(other.status)
    assert gps(np.vstack([x, x])[::2][0], lever_arm=ARM).value.tolist() == straight.value.tolist()


def test_no_cffi_runtime(copy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The message says what to install."""
    monkeypatch.setitem(sys.modules, "_cffi_backend", None)
    assert "need the cffi runtime; run: python -m pip install cffi" in missing(copy)
