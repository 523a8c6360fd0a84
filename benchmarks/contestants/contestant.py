"""What a contestant is, whatever wrote its code."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from benchmarks.problems import Problem


@dataclass(frozen=True)
class Contestant:
    """Code that evaluates one problem through ``void <symbol>(const double *, double *)``.

    Attributes:
        name: as reported.
        problem: what it evaluates.
        source: a whole translation unit that defines the adapter.
        order: where in its output every element of the problem's result stands.
        size: elements it writes.
        language: ``c`` or ``c++``.
        include: directories of its headers.
        root: the function whose code bytes are reported; the adapter where its code is inlined.
        epochs: results of one call; inputs and outputs lie one record after another.
    """

    name: str
    problem: Problem
    source: str
    order: tuple[int, ...]
    size: int
    language: str = "c"
    include: tuple[Path, ...] = field(default=())
    root: str = ""
    epochs: int = 1

    @property
    def symbol(self) -> str:
        """Name of the adapter."""
        return symbol_of(self.problem, self.name)

    @property
    def suffix(self) -> str:
        """Suffix of its source file."""
        return ".c" if self.language == "c" else ".cpp"


def symbol_of(problem: Problem, name: str) -> str:
    """Name of the adapter of a contestant."""
    return f"bench_{problem.name}_{name}"


def adapter(problem: Problem, name: str, body: Sequence[str]) -> str:
    """The adapter in C around a call."""
    symbol = symbol_of(problem, name)
    lines = "\n".join(f"    {line}" for line in body)
    head = f"void {symbol}(const double *in, double *out)"
    return f"{head};\n{head}\n{{\n{lines}\n}}\n"


def natural(problem: Problem) -> tuple[int, ...]:
    """The order of a contestant that writes values, then non-zeros by row."""
    return tuple(range(problem.rows + len(problem.pattern)))
