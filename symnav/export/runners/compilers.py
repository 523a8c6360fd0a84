"""gcc: a strict set of warnings, its analyser, and the stack every entry point takes."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from symnav.export.runners import controls, tools
from symnav.export.runners.records import Record, Verdict

WARNINGS = (
    "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wfloat-conversion",
    "-Wdouble-promotion", "-Wfloat-equal", "-Wstrict-prototypes", "-Wmissing-prototypes",
    "-Wmissing-declarations", "-Wold-style-definition", "-Wredundant-decls", "-Wnested-externs",
    "-Wshadow", "-Wcast-qual", "-Wcast-align=strict", "-Wpointer-arith", "-Wwrite-strings",
    "-Wundef", "-Wunused-macros", "-Wswitch-default", "-Wswitch-enum", "-Wlogical-op",
    "-Wduplicated-cond", "-Wduplicated-branches", "-Wnull-dereference", "-Wjump-misses-init",
    "-Wvla", "-Walloca", "-Wformat=2", "-Wstrict-overflow=2", "-Wstack-protector",
)  # fmt: skip
"""Asked of every source. Not among them: what C90 lacks, and styles the generator does not have."""

FLOAT_WARNINGS = ("-Wunsuffixed-float-constants",)
"""Asked of sources in single precision, where a number without a suffix would be a double."""

BASE = ("-std=c99", "-O2", "-ffp-contract=off", "-Iinclude", "-Isrc")
WARNS = controls.Control(
    "gcc",
    r"(?i)\bgcc\b.*\d+\.\d+",
    {
        "[-Wunused-variable]": "int unused;",
        "[-Wfloat-conversion]": "int n = x;",
        "[-Wunsuffixed-float-constants]": "float step = 0.5;",
    },
)
ANALYSES = controls.Control(
    "gcc -fanalyzer",
    WARNS.product,
    {"[-Wanalyzer-null-dereference]": "return n + *p + (int)(x * step);"},
)
"""What the strict flags, and the path analysis, must find before their silence counts."""

_DIAGNOSTIC = re.compile(r"^.*(?:warning|error): .*$", re.MULTILINE)
_NODE = re.compile(r'node: \{ title: "([^"]+)" label: "[^"]*?\\n(\d+) bytes \(([\w,]+)')
_EDGE = re.compile(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"')
_ENTRY = re.compile(r"^(?:\w+_(?:WIDE|NARROW) )?\w+_status_t (\w+)\(", re.MULTILINE)


def _command(folder: Path, source: str, extra: Sequence[str], out: str) -> list[str]:
    own = FLOAT_WARNINGS if tools.in_float(folder, source) else ()
    return _compile((*extra, *own), source, out)


def _compile(flags: Sequence[str], source: str, out: str) -> list[str]:
    return [tools.find("gcc"), *BASE, *flags, "-c", source, "-o", out]


def _repeated(folder: Path, extra: Sequence[str]) -> str:
    """How to repeat by hand what is asked; sources in single precision are asked for more."""
    sources = tools.sources(folder)
    single = [source for source in sources if tools.in_float(folder, source)]
    parts = [(single, FLOAT_WARNINGS), ([one for one in sources if one not in single], ())]
    asked = [(chosen, own) for chosen, own in parts if chosen]
    return " && ".join(
        " ".join(("gcc", *BASE, *extra, *own, "-c", *(chosen if len(asked) > 1 else ["src/*.c"])))
        for chosen, own in asked
    )


def _heard(folder: Path, extra: Sequence[str]) -> list[str]:
    """What gcc says about every source; that it compiled nothing is said as well."""
    found: list[str] = []
    with tempfile.TemporaryDirectory(prefix="symnav-") as scratch:
        for source in tools.sources(folder):
            out = Path(scratch) / f"{Path(source).stem}.o"
            said = _said(tools.call(_command(folder, source, extra, str(out)), folder))
            written = out.is_file() and out.stat().st_size > 0
            found += said if said or written else [f"{source}: no object file was written"]
    return found


def _missing() -> str:
    return "" if tools.find("gcc") else "gcc is not installed"


@dataclass(frozen=True, slots=True)
class Warnings:
    """gcc says nothing at all."""

    name: str = "gcc"

    def missing(self) -> str:
        """Why it cannot run here."""
        return _missing()

    def run(self, folder: Path) -> Record:
        """Compile every source with every warning."""
        version = tools.version([tools.find("gcc"), "--version"])
        command = _repeated(folder, WARNINGS)
        asked = _compile((*WARNINGS, *FLOAT_WARNINGS), controls.NAME, "control.o")
        if doubts := WARNS.doubts(version, asked):
            return WARNS.distrusted(self.name, version, command, doubts)
        findings = _heard(folder, WARNINGS)
        count = len(tools.sources(folder))
        flags = [flag for flag in (*WARNINGS, *FLOAT_WARNINGS) if flag in command.split()]
        return Record(
            self.name,
            version,
            Verdict.FAILED if findings else Verdict.PASSED,
            f"{len(findings)} warnings in {count} sources under {len(flags)} flags",
            command,
            findings=tuple(findings),
            details={
                "sources": count,
                "flags": flags,
                "planted": list(WARNS.planted),
            },
        )


@dataclass(frozen=True, slots=True)
class Analyser:
    """gcc's path analysis finds nothing."""

    name: str = "gcc_analyzer"

    def missing(self) -> str:
        """Why it cannot run here."""
        return _missing()

    def run(self, folder: Path) -> Record:
        """Analyse every source."""
        version = tools.version([tools.find("gcc"), "--version"])
        command = _repeated(folder, ("-fanalyzer",))
        asked = _compile(("-fanalyzer",), controls.NAME, "control.o")
        if doubts := ANALYSES.doubts(version, asked):
            return ANALYSES.distrusted(self.name, version, command, doubts)
        findings = _heard(folder, ("-fanalyzer",))
        count = len(tools.sources(folder))
        return Record(
            self.name,
            version,
            Verdict.FAILED if findings else Verdict.PASSED,
            f"{len(findings)} findings of the path analysis in {count} sources",
            command,
            assumptions=("The analysis looks for defects; that it finds none is no proof.",),
            findings=tuple(findings),
            details={"planted": list(ANALYSES.planted)},
        )


@dataclass(frozen=True, slots=True)
class Stack:
    """The stack of every entry point is bounded, and known.

    Attributes:
        limit: bytes no entry point may exceed.
    """

    limit: int = 32768
    name: str = "stack"

    def missing(self) -> str:
        """Why it cannot run here."""
        return _missing()

    def run(self, folder: Path) -> Record:
        """Add up frames along the call graph of every source."""
        depths: dict[str, int] = {}
        findings: list[str] = []
        with tempfile.TemporaryDirectory(prefix="symnav-") as scratch:
            for source in tools.sources(folder):
                out = Path(scratch) / f"{Path(source).stem}.o"
                command = _command(folder, source, ("-fcallgraph-info=su",), str(out))
                said = _said(tools.call(command, folder))
                graph = out.with_suffix(".ci")
                if said or not graph.is_file():
                    findings += said or [f"{source}: no call graph"]
                    continue
                entries = _ENTRY.findall((folder / source).read_text(encoding="utf-8"))
                measured, unbounded = _depths(graph.read_text(encoding="utf-8"), entries)
                depths |= measured
                findings += [f"{source}: {reason}" for reason in unbounded]
        findings += [
            f"{name}: {size} bytes, above {self.limit}"
            for name, size in depths.items()
            if size > self.limit
        ]
        deepest = max(depths, key=lambda name: depths[name], default="")
        return Record(
            self.name,
            tools.version([tools.find("gcc"), "--version"]),
            Verdict.FAILED if findings or not depths else Verdict.PASSED,
            f"{len(depths)} entry points without recursion; deepest {deepest} with "
            f"{depths.get(deepest, 0)} bytes",
            _repeated(folder, ("-fcallgraph-info=su",)),
            assumptions=(
                "Frames are those of this compiler for this machine; functions of the C library "
                "are not counted.",
            ),
            findings=tuple(findings),
            details={"bytes": dict(sorted(depths.items())), "limit": self.limit},
        )


def _said(done: tools.Outcome) -> list[str]:
    """Diagnostics of a compiler, and that it failed where it did."""
    found = [line.strip() for line in _DIAGNOSTIC.findall(done.output)]
    if done.code and not found:
        found.append(f"exit status {done.code}: {done.output.strip()[-500:]}")
    return found


def _depths(graph: str, entries: Sequence[str]) -> tuple[Mapping[str, int], list[str]]:
    """Bytes below each entry point, and what is unbounded, from a call graph."""
    frames: dict[str, int] = {}
    unbounded: list[str] = []
    for title, size, kind in _NODE.findall(graph):
        frames[title] = int(size)
        if kind not in ("static", "dynamic,bounded"):
            unbounded.append(f"{title} has a {kind} frame")
    callees: dict[str, list[str]] = {title: [] for title in frames}
    for caller, callee in _EDGE.findall(graph):
        if caller in frames and callee in frames:
            callees[caller].append(callee)
    depths: dict[str, int] = {}

    def depth(title: str, above: tuple[str, ...]) -> int:
        if title in above:
            unbounded.append(f"{title} calls itself")
            return 0
        if title not in depths:
            below = (depth(callee, (*above, title)) for callee in callees[title])
            depths[title] = frames[title] + max(below, default=0)
        return depths[title]

    named = {title.rpartition(":")[2]: title for title in frames}
    lost = [entry for entry in entries if entry not in named]
    unbounded += [f"{entry} is not in the call graph" for entry in lost]
    return {entry: depth(named[entry], ()) for entry in entries if entry in named}, unbounded
