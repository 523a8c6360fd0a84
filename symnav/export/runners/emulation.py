"""Runs a bundle on an emulated Cortex-M: tests, bits, instructions, flash and stack.

Needs what ``TOOLS`` names. Everything that is built goes to ``build/`` inside the bundle. The
emulator counts instructions, not cycles: they rank code and show growth, they are no times.
"""

from __future__ import annotations

import math
import shutil
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from symnav.build.objects import Binutils, said, stack_bytes
from symnav.errors import BuildError
from symnav.export.building.targets import FOLDER, TICK

TOOLS = ("make", "gcc", "arm-none-eabi-gcc", "arm-none-eabi-ld", "qemu-system-arm")
ARM = Binutils("arm-none-eabi-")
PATIENCE = 300.0
"""Seconds after which an emulated program hangs."""
MOST_ULPS = {"float": 2.0, "double": 8.0}
"""Between two mathematics libraries, each of which may be off by one and a bit, and what follows.

The bound is meant for floats; that of doubles is far below one unit of theirs.
"""
SUPPORT = frozenset({"memcpy", "memset"})
EXACT = frozenset({"sqrt", "sqrtf", "fabs", "fabsf", "floor", "floorf", "fmin", "fminf", "fmax",
                   "fmaxf"})  # fmt: skip
"""Functions of the mathematics library whose results IEEE 754 prescribes to the last bit."""
LIBM = EXACT | {
    f"{name}{f}" for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log")
    for f in ("", "f")
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Target:
    """A processor and the board that is emulated.

    Attributes:
        cpu: as the compiler calls it.
        fpu: its floating-point unit, single precision both.
        machine: as the emulator calls the board.
    """

    cpu: str
    fpu: str
    machine: str

    @property
    def flags(self) -> tuple[str, ...]:
        """What the compiler is told; without contraction results are those of any other machine."""
        return (f"-mcpu={self.cpu}", "-mthumb", "-mfloat-abi=hard", f"-mfpu={self.fpu}", "-O2",
                "-fno-math-errno", "-ffp-contract=off")  # fmt: skip

    def emulated(self, program: Path) -> str:
        """Output of a program that ends by itself; every instruction takes a nanosecond."""
        return said(
            "qemu-system-arm", "-M", self.machine, "-display", "none", "-monitor", "none",
            "-serial", "none", "-chardev", "stdio,id=output", "-semihosting-config",
            "enable=on,target=native,chardev=output", "-icount", "shift=0", "-kernel", str(program),
            seconds=PATIENCE,
        )  # fmt: skip


TARGETS: Mapping[str, Target] = {
    target.cpu: target
    for target in (
        Target("cortex-m4", "fpv4-sp-d16", "mps2-an386"),
        Target("cortex-m7", "fpv5-sp-d16", "mps2-an500"),
    )
}


@dataclass(frozen=True, slots=True)
class Unit:
    """A translation unit of the bundle.

    Attributes:
        source: its path.
        scalar: type of its numbers.
        undefined: symbols it expects from elsewhere.
    """

    source: str
    scalar: str
    undefined: tuple[str, ...]

    @property
    def foreign(self) -> tuple[str, ...]:
        """What it expects beyond the mathematics library and copying, emulated doubles apart.

        In single precision only functions of floats are expected, and no arithmetic at all.
        """
        single = self.scalar == "float"
        allowed = SUPPORT | {name for name in LIBM if not single or name.endswith("f")}
        emulated = () if single else ("__aeabi_",)
        return tuple(n for n in self.undefined if n not in allowed and not n.startswith(emulated))


@dataclass(frozen=True, slots=True)
class Called:
    """One way to call a function.

    Attributes:
        symbol: what was called.
        scalar: type of its numbers.
        instructions: of one call, all it calls included, on the average of the samples.
        flash: bytes of code and constants, the mathematics library left out.
        stack: bytes of stack, the mathematics library left out.
        exact: True when it uses arithmetic and roots alone, so that its bits are prescribed.
        ulps: largest difference from the host, in units in the last place of the largest result of
            the same call in the same unit; infinite where a status differs.
    """

    symbol: str
    scalar: str
    instructions: float
    flash: int
    stack: int
    exact: bool
    ulps: float


@dataclass(frozen=True, slots=True)
class Emulated:
    """What one run found.

    Attributes:
        cpu: the processor.
        machine: the emulated board.
        compiler: name and version.
        emulator: name and version.
        flags: of the compiler.
        tests: what the tests printed; they passed, or there is nothing.
        units: of the library.
        calls: of its functions.
    """

    cpu: str
    machine: str
    compiler: str
    emulator: str
    flags: tuple[str, ...]
    tests: str
    units: tuple[Unit, ...]
    calls: tuple[Called, ...]

    @property
    def findings(self) -> tuple[str, ...]:
        """What must not be: foreign symbols, bits that differ though they are prescribed."""
        foreign = [f"{u.source}: {', '.join(u.foreign)}" for u in self.units if u.foreign]
        differing = [
            f"{c.symbol}: {c.ulps:.3g} ULP from the host"
            for c in self.calls
            if not c.ulps <= (0.0 if c.exact else MOST_ULPS[c.scalar])
        ]
        return (*foreign, *differing)


def missing() -> tuple[str, ...]:
    """Tools that are not installed."""
    return tuple(tool for tool in TOOLS if shutil.which(tool) is None)


def run(folder: Path, cpu: str) -> Emulated:
    """Build a bundle for a processor, run its tests there and compare it with this machine.

    Args:
        folder: the bundle.
        cpu: a key of ``TARGETS``.

    Raises:
        BuildError: when a tool is missing, something does not compile, or a test fails.
    """
    target = TARGETS[cpu]
    place = folder / "build" / "semihost" / cpu
    make = ("make", "-s", "-j2", "-C", str(folder / FOLDER), f"CPU={cpu}")
    said(*make, "all")
    tests = said(*make, "run", seconds=PATIENCE).strip()
    here = _printed(_on_host(folder))
    there = _printed(target.emulated(place / "count.elf"))
    if here.forms.keys() != there.forms.keys():
        raise BuildError(f"{cpu}: the run that counts ended early")
    return Emulated(
        cpu=cpu,
        machine=target.machine,
        compiler=said("arm-none-eabi-gcc", "--version").splitlines()[0],
        emulator=said("qemu-system-arm", "--version").splitlines()[0],
        flags=target.flags,
        tests=tests,
        units=tuple(_units(folder, place)),
        calls=tuple(_calls(place, here, there)),
    )


@dataclass(frozen=True, slots=True)
class _Form:
    """What the counting program printed of one function.

    Attributes:
        scalar: type of its numbers.
        blocks: a number for every element, one for what shares a unit.
        statuses: of every sample.
        rows: the elements of every sample.
    """

    scalar: str
    blocks: NDArray[np.intp]
    statuses: tuple[int, ...]
    rows: tuple[NDArray[np.floating], ...]


@dataclass(frozen=True, slots=True)
class _Printed:
    """All it printed: results, and ticks over calls, by function."""

    forms: Mapping[str, _Form]
    ticks: Mapping[str, float]

    def instructions(self, symbol: str) -> float:
        """Of one call, less those of a call of nothing."""
        return round(TICK * (self.ticks[symbol] - self.ticks["nothing"]), 1)


def _on_host(folder: Path) -> str:
    """Output of the counting program on this machine."""
    program = folder / "build" / "semihost" / "host"
    program.parent.mkdir(parents=True, exist_ok=True)
    sources = sorted(str(path.relative_to(folder)) for path in (folder / "src").glob("*.c"))
    said(
        "gcc", "-std=c99", "-O2", "-ffp-contract=off", "-Iinclude", *sources,
        "test/semihost/count.c", "-lm", "-o", str(program.relative_to(folder)), folder=folder,
    )  # fmt: skip
    return said(str(program.resolve()))


def _printed(text: str) -> _Printed:
    """What the counting program printed."""
    samples: dict[str, list[list[str]]] = {}
    blocks, ticks = {}, {}
    for line in text.splitlines():
        symbol, *words = line.split()
        if words[0] == "takes":
            ticks[symbol] = int(words[1]) / int(words[3])
        elif words[0] == "blocks":
            blocks[symbol] = np.array(words[1:], np.intp)
        else:
            samples.setdefault(symbol, []).append(words)
    forms = {symbol: _form(blocks[symbol], lines) for symbol, lines in samples.items()}
    return _Printed(forms, ticks)


def _form(blocks: NDArray[np.intp], lines: Sequence[Sequence[str]]) -> _Form:
    scalar = lines[0][0]
    kind: type[np.floating] = np.float32 if scalar == "float" else np.float64
    words = [np.array([int(word, 16) for word in line[3:]], np.uint32) for line in lines]
    rows = tuple(row.view(kind) for row in words)
    return _Form(scalar, blocks, tuple(int(line[2]) for line in lines), rows)


def _units(folder: Path, place: Path) -> Iterator[Unit]:
    """Every source with what its object needs from outside the bundle."""
    objects = {path: place / "src" / f"{path.stem}.o" for path in (folder / "src").glob("*.c")}
    own = frozenset[str]().union(*(ARM.functions(item) for item in objects.values()))
    for path, item in sorted(objects.items()):
        needed = tuple(name for name in ARM.undefined(item) if name not in own)
        yield Unit(path.relative_to(folder).as_posix(), _scalar(path, folder), needed)


def _scalar(source: Path, folder: Path) -> str:
    """Type of the numbers of a source, as the header it includes says."""
    text = source.read_text(encoding="utf-8")
    prefix = text.partition('#include "')[2].partition("/")[0]
    types = folder / "include" / prefix / f"{prefix}_types.h"
    return "float" if "typedef float " in types.read_text(encoding="utf-8") else "double"


def _calls(place: Path, here: _Printed, there: _Printed) -> Iterator[Called]:
    """Every function that was called, compared and counted."""
    items = sorted((place / "src").glob("*.o"))
    homes = {name: item for item in items if ".kept." not in item.name
             for name in ARM.functions(item)}  # fmt: skip
    for symbol, form in there.forms.items():
        item = homes[symbol]
        kept = ARM.kept(item, symbol)
        needed = {n for n in ARM.needed(kept) if not n.startswith("__aeabi_")}
        yield Called(
            symbol=symbol,
            scalar=form.scalar,
            instructions=there.instructions(symbol),
            flash=ARM.section_bytes(kept, "text|rodata"),
            stack=stack_bytes(item.with_suffix(".su"), ARM.functions(kept)),
            exact=needed <= SUPPORT | EXACT,
            ulps=_difference(here.forms[symbol], form),
        )


def _difference(here: _Form, there: _Form) -> float:
    """Largest difference in units in the last place of the largest result of its block."""
    if here.statuses != there.statuses:
        return math.inf
    worst = 0.0
    for one, other in zip(here.rows, there.rows, strict=True):
        if np.array_equal(one.view(np.uint32), other.view(np.uint32)):
            continue
        if not (np.isfinite(one).all() and np.isfinite(other).all()):
            return math.inf
        largest = np.zeros(here.blocks.max() + 1, one.dtype)
        np.maximum.at(largest, here.blocks, np.abs(one))
        apart = np.abs(one.astype(float) - other.astype(float))
        worst = max(worst, float((apart / np.spacing(largest)[here.blocks]).max()))
    return worst
