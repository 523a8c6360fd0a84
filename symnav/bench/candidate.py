"""A piece of code that can be timed, whatever wrote it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """Code that evaluates something through ``void <symbol>(const double *, double *)``.

    Attributes:
        name: as reported.
        symbol: the adapter's name in C, unique in one program.
        source: a whole translation unit that defines the adapter.
        size: elements one call writes.
        language: ``c`` or ``c++``.
        include: directories of its headers.
        root: the function whose code and stack are reported; the adapter where it is empty.
        epochs: records one call reads, one after another.
        flags: for the compiler, after those that all candidates share.
    """

    name: str
    symbol: str
    source: str
    size: int
    language: str = "c"
    include: tuple[Path, ...] = ()
    root: str = ""
    epochs: int = 1
    flags: tuple[str, ...] = ()

    @property
    def measured(self) -> str:
        """The function whose code is reported."""
        return self.root or self.symbol

    @property
    def file(self) -> str:
        """Name of its source file."""
        return f"{self.symbol}{'.c' if self.language == 'c' else '.cpp'}"


def adapter(symbol: str, body: Sequence[str]) -> str:
    """The adapter around a call, in C."""
    lines = "\n".join(f"    {line}" for line in body)
    head = f"void {symbol}(const double *in, double *out)"
    return f"{head};\n{head}\n{{\n{lines}\n}}\n"
