"""Bundles on disk, and the ways their test programs are built and run on this machine."""

from __future__ import annotations

import platform
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from symnav import pipeline
from symnav.build.compiler import Compiler, native_flags

C99 = ("-std=c99", "-O2", "-ffp-contract=off")
#: As the extension is built with --native: GCC fuses some sums even with -ffp-contract=off.
NATIVE = tuple(native_flags(Compiler(("gcc",), f"gcc, {platform.machine()}")))
STRICT = (
    *("-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Wsign-conversion"),
    *("-Wdouble-promotion", "-Wcast-qual", "-Wundef", "-Wfloat-equal", "-Werror"),
)
SANITIZE = ("-fsanitize=address,undefined,float-cast-overflow", "-fno-sanitize-recover=all")


@dataclass(frozen=True)
class Host:
    """A compiler with its flags, and what the program runs under.

    Attributes:
        compiler: command and flags.
        under: command in front of the program.
    """

    compiler: tuple[str, ...]
    under: tuple[str, ...] = ()

    def skip_without_tools(self) -> None:
        """Skip the running test where a tool is missing."""
        for tool in (self.compiler[0], *self.under[:1]):
            if shutil.which(tool) is None:
                pytest.skip(f"needs {tool}")

    def build(self, folder: Path, program: Path) -> None:
        """Build the test program of a bundle."""
        ran = subprocess.run(
            [
                *self.compiler,
                *(f"-I{folder / part}" for part in ("include", "test")),
                *map(str, sources(folder)),
                *("-lm", "-o", str(program)),
            ],
            capture_output=True,
            text=True,
            check=False,
        )
        assert ran.returncode == 0, ran.stderr

    def run(self, program: Path) -> subprocess.CompletedProcess[str]:
        """Run it."""
        return subprocess.run(
            [*self.under, str(program)], capture_output=True, text=True, check=False, timeout=300
        )


HOSTS = {
    "gcc": Host(("gcc", *C99, *STRICT)),
    "gcc of this processor": Host(("gcc", *C99, "-O3", *NATIVE)),
    "clang": Host(("clang-19", *C99, *STRICT, "-Wpass-failed")),
    "tcc": Host(("tcc", "-std=c99")),
    "C++17": Host(
        ("g++", "-x", "c++", "-std=c++17", "-O2", "-ffp-contract=off", "-Wall", "-Werror")
    ),
    "sanitizers": Host(("clang-19", "-std=c99", "-O1", "-g", "-ffp-contract=off", *SANITIZE)),
    "valgrind": Host(
        ("gcc", "-std=c99", "-O1", "-g", "-ffp-contract=off"),
        ("valgrind", "-q", "--error-exitcode=9"),
    ),
}


def sources(folder: Path) -> Sequence[Path]:
    """The C files of a bundle and its test program."""
    return (*sorted((folder / "src").glob("*.c")), *sorted((folder / "test").glob("test_*.c")))


def exported(model: str, scalar: str, folder: Path) -> Path:
    """A bundle of a shipped model, as a user gets it.

    Args:
        model: its name.
        scalar: type, and behind a space where checks stand if that is chosen.
        folder: becomes the bundle.
    """
    kind, _, guards = scalar.partition(" ")
    pipeline.export(pipeline.load(model), folder, scalar=kind, guards=guards or None)
    return folder
