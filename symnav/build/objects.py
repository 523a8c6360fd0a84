"""What compiled code weighs and needs: read from object files with binutils and gcc's accounts.

Objects are to be compiled with ``-ffunction-sections``, and with ``-fstack-usage`` where stack is
asked for. A toolchain prefix such as ``arm-none-eabi-`` reads those of another processor.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from symnav.errors import BuildError


@dataclass(frozen=True, slots=True)
class Binutils:
    """The tools of one toolchain.

    Attributes:
        prefix: of their names; empty for those of this machine.
    """

    prefix: str = ""

    def kept(self, item: Path, root: str) -> Path:
        """The part of an object that stays when nothing but a function is asked for."""
        kept = item.with_suffix(f".{root}.kept.o")
        link = [f"{self.prefix}ld", "-r", "--gc-sections", "-u", root, "-e", root]
        said(*link, str(item), "-o", str(kept))
        return kept

    def section_bytes(self, item: Path, names: str) -> int:
        """Bytes of the sections whose names begin with a pattern, such as ``text|rodata``."""
        listed = said(f"{self.prefix}size", "-A", str(item))
        found = re.findall(rf"^\.(?:{names})\S*\s+(\d+)", listed, re.MULTILINE)
        return sum(int(size) for size in found)

    def undefined(self, item: Path) -> tuple[str, ...]:
        """Symbols an object expects from elsewhere, in alphabetical order."""
        listed = said(f"{self.prefix}nm", "-u", str(item))
        return tuple(sorted(line.split()[-1] for line in listed.splitlines() if line.strip()))

    def needed(self, kept: Path) -> tuple[str, ...]:
        """Symbols the kept part of an object refers to; its list still holds those of the rest."""
        stripped = kept.with_suffix(".stripped.o")
        said(f"{self.prefix}objcopy", "--strip-unneeded", str(kept), str(stripped))
        return self.undefined(stripped)

    def functions(self, item: Path) -> frozenset[str]:
        """Functions an object defines, seen from elsewhere or not."""
        listed = said(f"{self.prefix}nm", str(item)).splitlines()
        return frozenset(line.split()[-1] for line in listed if " t " in line.lower())


def stack_bytes(account: Path, functions: frozenset[str]) -> int:
    """Stack of some functions on top of each other, by the account of ``-fstack-usage``.

    Copies the compiler specialises are named after their function, with a point in between.
    """
    names = {name.partition(".")[0] for name in functions}
    total = 0
    for line in account.read_text(encoding="utf-8").splitlines():
        place, size, _ = line.split("\t")
        function = place.rpartition(":")[2].partition(".")[0]
        if any(function == name or f"{name}(" in function for name in names):
            total += int(size)
    return total


def said(*command: str, folder: Path | None = None, seconds: float | None = None) -> str:
    """Standard output of a command that must succeed.

    Args:
        *command: the program and its arguments.
        folder: where it runs.
        seconds: after which it has failed; None for never.

    Raises:
        BuildError: when it is not installed, fails or takes longer.
    """
    if "/" not in command[0] and shutil.which(command[0]) is None:
        raise BuildError(f"{command[0]} is needed to measure and is not installed")
    name = " ".join(command[:2])
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, cwd=folder, timeout=seconds,
            stdin=subprocess.DEVNULL,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise BuildError(f"{name} ...: not done after {seconds:g} s") from None
    if done.returncode:
        shown = "\n".join(text.strip()[-2000:] for text in (done.stdout, done.stderr) if text)
        raise BuildError(f"{name} ...: {shown or f'exit status {done.returncode}'}")
    return done.stdout
