"""The C compiler and its flags: what each is for, and which of them a machine takes."""

from __future__ import annotations

import os
import platform
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from symnav.errors import BuildError

WINDOWS = os.name == "nt"

FLAGS: Mapping[str, str] = {
    "-O3": "vectorises loops over items and epochs",
    "-std=c99": "the language the C is written in; without GNU extensions",
    "-fno-math-errno": "nothing reads errno; lets square roots be one instruction",
    "-fno-trapping-math": "no handler waits for exceptions; lets guards become selections",
    "-ffp-contract=off": "no fused operations, so that results are the same bits everywhere",
}
"""Flags of every kernel and why. Nothing here changes a result; -ffast-math would."""

LIGHT_FLAGS: Mapping[str, str] = {
    **{flag: reason for flag, reason in FLAGS.items() if flag != "-O3"},
    "-O2": "retract and local are called once per update: compile time matters more",
}
"""Flags of retract and local."""

NATIVE_FLAG = "-march=native"
"""Added on request: the instructions of this very machine, and a file for no other."""

UNFUSED_FLAGS: Mapping[str, str] = {
    "-mno-fma": "GCC 12 fuses alternating sums and differences even with -ffp-contract=off",
    "-mno-avx512f": "which has fused instructions of its own; costs up to a fifth where it exists",
}
"""Added with ``-march=native`` on x86, so that results stay the same bits there as well."""

DISPATCH_FLAG = "-DSYMNAV_DISPATCH"
"""Added without ``-march=native`` where gcc and the GNU C library can: loops for AVX2 beside those
for every processor, chosen when the extension is loaded. The same bits either way."""

WINDOWS_FLAGS: Mapping[str, str] = {
    "/O2": "optimises for speed",
    "/std:c11": "the oldest standard this compiler follows",
    "/fp:precise": "no fused or reordered operations",
}
"""Flags for the compiler of Visual Studio."""

ADVICE = (
    "Debian and Ubuntu: apt install gcc libc6-dev python3-dev; Fedora: dnf install gcc "
    "python3-devel; macOS: xcode-select --install; Windows: Build Tools for Visual Studio"
)


@dataclass(frozen=True, slots=True)
class Compiler:
    """A C compiler.

    Attributes:
        command: how it is called.
        identity: its version and the machine it compiles for.
    """

    command: tuple[str, ...]
    identity: str


def find_compiler() -> Compiler:
    """The compiler of the environment variable ``CC``, of this Python, or the first there is.

    Raises:
        BuildError: when there is none, or the one asked for does not exist.
    """
    if WINDOWS:
        return Compiler(("cl",), f"Visual Studio, {sys.version}")
    asked = shlex.split(os.environ.get("CC", ""))
    if asked and shutil.which(asked[0]) is None:
        raise BuildError(f"the compiler {asked[0]!r} that CC names does not exist; {ADVICE}")
    of_python = shlex.split(sysconfig.get_config_var("CC") or "")
    for command in (asked, of_python[:1], ["cc"], ["gcc"], ["clang"]):
        if command and shutil.which(command[0]):
            return Compiler(tuple(command), _identity(tuple(command)))
    raise BuildError(f"no C compiler found; {ADVICE}")


@cache
def _identity(command: tuple[str, ...]) -> str:
    version = subprocess.run([*command, "--version"], capture_output=True, text=True, check=False)
    machine = subprocess.run(
        [*command, "-dumpmachine"], capture_output=True, text=True, check=False
    )
    first = (version.stdout or version.stderr).strip().splitlines()
    return f"{first[0] if first else command[0]}, {machine.stdout.strip()}"


def native_flags(compiler: Compiler) -> list[str]:
    """Flags for this very machine."""
    if WINDOWS:
        return []
    machine = compiler.identity.rpartition(", ")[2]
    is_x86 = re.match(r"x86_64|i\d86", machine) is not None
    return [NATIVE_FLAG, *(UNFUSED_FLAGS if is_x86 else ())]


def dispatch_flags(compiler: Compiler) -> list[str]:
    """Flags for code that carries loops for several processors."""
    if WINDOWS or platform.libc_ver()[0] != "glibc":
        return []
    name, _, machine = compiler.identity.rpartition(", ")
    return [DISPATCH_FLAG] if machine.startswith("x86_64") and "clang" not in name else []


def machine_macros(compiler: Compiler) -> str:
    """What the compiler knows about this processor."""
    command = [*compiler.command, NATIVE_FLAG, "-dM", "-E", "-x", "c", os.devnull]
    macros = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    return "\n".join(sorted(macros.splitlines()))


def flags_of(source: Path, flags: Sequence[str]) -> list[str]:
    """Retract and local are compiled lightly."""
    if not source.stem.endswith(("_retract", "_local")):
        return list(flags)
    return [*LIGHT_FLAGS, *(flag for flag in flags if flag not in FLAGS)]
