"""Evaluates mutants one after the other, each in a child process of its own.

Run in a copy of the project: ``python -m tests.mutation.worker``. Reads one request per line and
answers with one line, both JSON. The heavy libraries are imported once; every mutant is a fork that
imports the package through a hook which compiles the changed syntax tree in place of one file.
Nothing is written anywhere.
"""

from __future__ import annotations

import importlib.abc
import importlib.machinery
import importlib.util
import json
import os
import select
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

import pytest

from tests.mutation.mutants import Mutant, mutants_of, mutated

PRELOADED = (
    "casadi", "hypothesis", "jinja2", "mpmath", "numpy", "pydantic", "scipy.spatial.transform",
    "sympy", "tests.reference.blocks", "tests.reference.broadcast_orbit",
    "tests.reference.drawing", "tests.reference.jacobian", "tests.reference.pseudorange",
    "tests.reference.specific_force",
)  # fmt: skip


class _Loader(importlib.machinery.SourceFileLoader):
    """Compiles the changed tree where the file's own text would be."""

    def __init__(self, name: str, path: str, mutant: Mutant) -> None:
        super().__init__(name, path)
        self._mutant = mutant

    def get_code(self, fullname: str) -> CodeType:
        source = Path(self.path).read_text(encoding="utf-8")
        return compile(mutated(source, self._mutant), self.path, "exec")


class _Finder(importlib.abc.MetaPathFinder):
    """Finds one module with a mutant in it, and leaves every other to the rest."""

    def __init__(self, mutant: Mutant) -> None:
        self._mutant = mutant
        stem = mutant.file.removesuffix(".py").removesuffix("/__init__")
        self._module = stem.replace("/", ".")

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        if fullname != self._module:
            return None
        location = str(Path(self._mutant.file).resolve())
        return importlib.util.spec_from_file_location(
            fullname, location, loader=_Loader(fullname, location, self._mutant)
        )


class _FirstFailure:
    """Remembers the first test that failed."""

    def __init__(self) -> None:
        self.where: str | None = None

    def pytest_runtest_logreport(self, report: Any) -> None:
        """Called by pytest after every phase of a test."""
        if report.failed and self.where is None:
            self.where = report.nodeid

    def pytest_collectreport(self, report: Any) -> None:
        """Called by pytest after a file was collected."""
        if report.failed and self.where is None:
            self.where = "import"


def _run(mutant: Mutant | None, tests: Sequence[str]) -> str | None:
    """In the child: the first failing test, or None."""
    if mutant is not None:
        sys.meta_path.insert(0, _Finder(mutant))
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    os.dup2(silence, 2)
    failure = _FirstFailure()
    options = ["-x", "-q", "-p", "no:cacheprovider", "--no-header", "--tb=no"]
    code = pytest.main([*options, *tests], plugins=[failure])
    if failure.where is None and code not in (pytest.ExitCode.OK, pytest.ExitCode.TESTS_FAILED):
        return f"pytest ended with {int(code)}"
    return failure.where


def evaluate(mutant: Mutant | None, tests: Sequence[str], limit: float) -> str | None:
    """Fork, run the tests in the child, wait no longer than ``limit`` seconds."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        answer = json.dumps({"killed_by": _run(mutant, tests)})
        os.write(writer, answer.encode())
        os._exit(0)
    os.close(writer)
    ready, _, _ = select.select([reader], [], [], limit)
    text = os.read(reader, 65536) if ready else b""
    os.close(reader)
    if not text:
        os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    if not ready:
        return "timeout"
    result: str | None = json.loads(text)["killed_by"] if text else "crash"
    return result


def _find(file: str, name: str) -> Mutant:
    source = Path(file).read_text(encoding="utf-8")
    return next(m for m in mutants_of(file, source) if m.id == name)


def serve() -> None:
    """Answer requests until the input ends."""
    for name in PRELOADED:
        if importlib.util.find_spec(name.partition(".")[0]) is not None:
            importlib.import_module(name)
    loaded = [name for name in sys.modules if name.partition(".")[0] == "symnav"]
    assert not loaded, f"mutants of {loaded} would never be imported"
    for line in sys.stdin:
        request = json.loads(line)
        name = request["id"]
        mutant = None if name is None else _find(name.partition("::")[0], name)
        result = evaluate(mutant, request["tests"], request["limit"])
        print(json.dumps({"killed_by": result}), flush=True)


if __name__ == "__main__":
    serve()
