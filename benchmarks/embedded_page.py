"""Writes the tables of ``docs/embedded.md`` from the files of two runs of ``embedded.py``.

usage: python benchmarks/embedded_page.py     reads benchmarks/results/cortex-m{4,7}.json
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.embedded import MODELS
from benchmarks.page import DOCS, RESULTS, table
from symnav.build.objects import said

CPUS = {"cortex-m4": "Cortex-M4F", "cortex-m7": "Cortex-M7"}
OWN = ("symnav_nz", "symnav_dense", "symnav_nz_guarded", "symnav_dense_guarded")
RIVALS = ("hand", "casadi_sym_mended", "casadi_mended", "casadi_sym", "casadi")

Figures = Mapping[str, Mapping[str, Mapping[str, Any]]]


def main() -> None:
    """Reads the results and writes the tables."""
    runs = {cpu: json.loads((RESULTS / f"{cpu}.json").read_text(encoding="utf-8")) for cpu in CPUS}
    text = "\n".join(page(runs)) + "\n"
    (DOCS / "embedded-results.md").write_text(text, encoding="utf-8")


def page(runs: Mapping[str, Figures]) -> Iterator[str]:
    """The tables, in Markdown."""
    yield "<!-- Written by benchmarks/embedded_page.py; do not edit. -->"
    yield ""
    yield f"{tools()}, casadi {version('casadi')}."
    yield ""
    for cpu, figures in runs.items():
        yield from counted(f"## Instructions of one call, {CPUS[cpu]}", figures, "instructions")
    first = runs["cortex-m4"]
    yield from ratios("## Instructions: `symnav_nz` over the others", first, "instructions")
    yield from counted("## Code and constants, Cortex-M4F (bytes)", first, "code")
    yield from ratios("## Code and constants: `symnav_nz` over the others", first, "code")
    heading = "## What a program grows by, libraries included, Cortex-M4F (bytes)"
    yield from counted(heading, first, "flash")
    yield from counted("## Stack, libraries left out, Cortex-M4F (bytes)", first, "stack")


def counted(heading: str, figures: Figures, what: str) -> Iterator[str]:
    """One figure of every contestant."""
    yield heading
    yield ""
    yield from table(
        ["contestant", *MODELS],
        [[f"`{n}`", *(f"{figures[m][n][what]:.0f}" for m in MODELS)] for n in (*OWN, *RIVALS)],
    )


def ratios(heading: str, figures: Figures, what: str) -> Iterator[str]:
    """The non-zeros form over each rival."""
    yield heading
    yield ""
    rows: list[list[str]] = []
    for rival in RIVALS:
        shares: Sequence[float] = [
            figures[m]["symnav_nz"][what] / figures[m][rival][what] for m in MODELS
        ]
        rows.append([f"`{rival}`", *(f"{share:.2f}" for share in shares)])
    yield from table(["", *MODELS], rows)


def tools() -> str:
    """Compiler and emulator."""
    compiler = said("arm-none-eabi-gcc", "--version").splitlines()[0]
    emulator = said("qemu-system-arm", "--version").splitlines()[0]
    return f"{compiler}; {emulator}"


if __name__ == "__main__":
    main()
