"""How much of a bundle's C its own tests reach: lines, branches, and conditions by MC/DC.

The test program is built with clang's source-based coverage and run. A line, a way of a branch or
a condition of the source counts once, however many files include it: as reached when some
inclusion of it is. Modified condition/decision coverage wants each condition of a decision shown
to decide it alone.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from symnav.build.objects import said
from symnav.errors import BuildError, ProofError

#: Versions of clang that know modified condition/decision coverage, the one that is tested first.
VERSIONS = ("19", "20", "21", "22", "18")

FLAGS = (
    *("-std=c99", "-O0", "-ffp-contract=off"),
    *("-fprofile-instr-generate", "-fcoverage-mapping", "-fcoverage-mcdc"),
)


UNION = (
    "A line, a way of a branch or a condition counts once, however many copies of it there are: as "
    "covered when it is in any of the places that include or inline it. Counts of llvm-cov itself "
    "add up the copies."
)
"""What a count of something that several files include rests on."""


@dataclass(frozen=True)
class Count:
    """How many of some things were reached."""

    reached: int
    total: int

    @property
    def is_complete(self) -> bool:
        """True when nothing is missing."""
        return self.reached == self.total

    @property
    def percent(self) -> float:
        """Reached in a hundred; a hundred where there is nothing to reach."""
        return 100.0 * self.reached / self.total if self.total else 100.0

    def __add__(self, other: Count) -> Count:
        return Count(self.reached + other.reached, self.total + other.total)


@dataclass(frozen=True)
class FileCoverage:
    """Coverage of one source file.

    Attributes:
        path: inside the bundle.
        lines: executable lines.
        branches: both ways of every condition.
        conditions: those of decisions with two or more, each shown to decide alone.
    """

    path: str
    lines: Count
    branches: Count
    conditions: Count

    @property
    def is_complete(self) -> bool:
        """True when nothing is missing."""
        return all(c.is_complete for c in (self.lines, self.branches, self.conditions))


@dataclass(frozen=True)
class Coverage:
    """Coverage of a bundle.

    Attributes:
        files: every file of ``src/`` that holds code, in order.
        tool: the compiler's first line about itself.
    """

    files: tuple[FileCoverage, ...]
    tool: str

    @property
    def is_complete(self) -> bool:
        """True when there is something to reach and nothing is missing."""
        return bool(self.files) and all(file.is_complete for file in self.files)

    @property
    def total(self) -> FileCoverage:
        """All files together."""
        zero = Count(0, 0)
        return FileCoverage(
            "src",
            sum((file.lines for file in self.files), zero),
            sum((file.branches for file in self.files), zero),
            sum((file.conditions for file in self.files), zero),
        )


@dataclass(frozen=True)
class _Tools:
    clang: str
    profdata: str
    cov: str


def available() -> bool:
    """True when a clang with its coverage tools is installed."""
    return _tools() is not None


def command() -> str:
    """How to repeat a measurement by hand, from the folder of a bundle.

    What is counted is left in ``build/coverage.json`` (branches and conditions) and in
    ``build/coverage.info`` (lines).
    """
    tools = _tools() or _Tools("clang", "llvm-profdata", "llvm-cov")
    made = "build/coverage"
    export = f"{tools.cov} export {made} -instr-profile={made}.profile"
    return " && ".join(
        (
            "mkdir -p build",
            f"{tools.clang} {' '.join(FLAGS)} -Iinclude -Itest src/*.c test/test_*.c -lm -o {made}",
            f"LLVM_PROFILE_FILE={made}.raw {made}",
            f"{tools.profdata} merge {made}.raw -o {made}.profile",
            f"{export} -skip-expansions -skip-functions > {made}.json",
            f"{export} -format=lcov > {made}.info",
        )
    )


def measure(folder: Path) -> Coverage:
    """Build the tests of a bundle for coverage, run them, and count.

    Args:
        folder: a written bundle.

    Raises:
        BuildError: when there is no clang 18 or later with llvm-cov and llvm-profdata, or it
            refuses the code.
        ProofError: when the tests fail.
    """
    tools = _tools()
    if tools is None:
        raise BuildError(
            "coverage by MC/DC needs clang 18 or later with llvm-cov and llvm-profdata; install "
            "the packages clang-19 and llvm-19"
        )
    root = folder.resolve()
    sources = sorted((root / "src").glob("*.c")) + sorted((root / "test").glob("test_*.c"))
    with tempfile.TemporaryDirectory(prefix="symnav-coverage-") as name:
        work = Path(name)
        program, raw, profile = work / "tests", work / "raw", work / "profile"
        include = (f"-I{root / 'include'}", f"-I{root / 'test'}")
        said(tools.clang, *FLAGS, *include, *map(str, sources), "-lm", "-o", str(program))
        ran = subprocess.run(
            [str(program)],
            env={**os.environ, "LLVM_PROFILE_FILE": str(raw)},
            capture_output=True,
            text=True,
            check=False,
        )
        if ran.returncode != 0:
            raise ProofError(f"the tests of {folder} fail:\n{ran.stdout.strip()}")
        said(tools.profdata, "merge", str(raw), "-o", str(profile))
        report = [tools.cov, "export", str(program), f"-instr-profile={profile}"]
        records = said(*report, "-skip-expansions", "-skip-functions")
        lines = _lines(said(*report, "-format=lcov"))
    return Coverage(_files(records, lines, root), _version(tools))


def _tools() -> _Tools | None:
    for version in VERSIONS:
        names = (f"clang-{version}", f"llvm-profdata-{version}", f"llvm-cov-{version}")
        if all(shutil.which(name) for name in names):
            return _Tools(*names)
    return None


def _version(tools: _Tools) -> str:
    return said(tools.clang, "--version").splitlines()[0]


def _lines(text: str) -> dict[str, Count]:
    """Executable lines by file; a line counts as reached when any inclusion of it is."""
    found: dict[str, Count] = {}
    path = ""
    for record in text.splitlines():
        kind, _, rest = record.partition(":")
        if kind == "SF":
            path = rest
        elif kind == "DA":
            hits = int(rest.split(",")[1])
            found[path] = found.get(path, Count(0, 0)) + Count(int(hits > 0), 1)
    return found


def _files(records: str, lines: Mapping[str, Count], root: Path) -> tuple[FileCoverage, ...]:
    found = []
    for entry in json.loads(records)["data"][0]["files"]:
        path = Path(entry["filename"])
        if path.parent == root / "src":
            # From line and column to line and column, how often true, how often false.
            ways = [(tuple(b[:4]), [b[4] > 0, b[5] > 0]) for b in entry["branches"]]
            # From line and column to line and column, ..., for every condition whether it decided.
            decided = [(tuple(d[:4]), list(d[-1])) for d in entry["mcdc_records"]]
            line = lines.get(entry["filename"], Count(0, 0))
            found.append(FileCoverage(f"src/{path.name}", line, _united(ways), _united(decided)))
    return tuple(sorted(found, key=lambda file: file.path))


def _united(records: Iterable[tuple[tuple[int, ...], list[bool]]]) -> Count:
    """What any inclusion of a place reached of it."""
    places: dict[tuple[int, ...], list[bool]] = {}
    for place, reached in records:
        known = places.setdefault(place, [False] * len(reached))
        places[place] = [a or b for a, b in zip(known, reached, strict=True)]
    flags = [flag for reached in places.values() for flag in reached]
    return Count(sum(flags), len(flags))
