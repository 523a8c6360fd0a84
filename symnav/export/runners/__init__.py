"""Proof runners: one for each tool, each used where its tool is installed."""

from __future__ import annotations

from symnav.export.runners.compilers import Analyser, Stack, Warnings
from symnav.export.runners.eva import Eva
from symnav.export.runners.fuzz import Fuzz
from symnav.export.runners.linters import ClangTidy, Cppcheck, Lizard
from symnav.export.runners.programs import CortexM, HostTests, Reach
from symnav.export.runners.records import Record, Runner, Verdict

RUNNERS: tuple[Runner, ...] = (
    HostTests(),
    Reach(),
    CortexM("cortex-m4"),
    CortexM("cortex-m7"),
    Warnings(),
    Analyser(),
    Stack(),
    Lizard(),
    Cppcheck(),
    ClangTidy(),
    Fuzz(),
    Eva(),
)
"""In the order they run: what really runs, then what is read, the quick ones first."""

__all__ = ["RUNNERS", "Record", "Runner", "Verdict"]
