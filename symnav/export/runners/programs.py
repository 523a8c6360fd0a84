"""The test program of a bundle, really run: on this machine, for coverage, and on Cortex-M."""

from __future__ import annotations

import re
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from symnav.errors import BuildError, ProofError
from symnav.export.runners import coverage, emulation, tools
from symnav.export.runners.records import Record, Verdict, broken

_C99 = ("-std=c99", "-O2", "-ffp-contract=off")
_CHECKED = ("-std=c99", "-O1", "-g", "-ffp-contract=off")
_PROGRAM = "build/tests"
_SUMMARY = re.compile(r"(\w+): (\d+) checks, (\d+) failures")


@dataclass(frozen=True, slots=True)
class Way:
    """A way to build and run a program.

    Attributes:
        name: in a few words.
        compilers: the first of these that is installed builds it.
        flags: of the compiler.
        under: what it runs under.
    """

    name: str
    compilers: tuple[str, ...]
    flags: tuple[str, ...]
    under: tuple[str, ...] = ()

    def missing(self) -> str:
        """What is not installed."""
        needed = (self.compilers, *((word,) for word in self.under[:1]))
        return ", ".join(names[0] for names in needed if not tools.find(*names))

    def command(self, sources: Sequence[str], program: str) -> list[str]:
        """What builds it, from the folder of the bundle."""
        compiler = tools.find(*self.compilers)
        return [compiler, *self.flags, "-Iinclude", "-Itest", *sources, "-lm", "-o", program]

    def repeated(self) -> str:
        """How to repeat it by hand, from the folder of the bundle."""
        sources = ("src/*.c", "test/test_*.c")
        name, *words = self.command(sources, _PROGRAM)
        return " ".join((Path(name).name, *words, "&&", *self.under, _PROGRAM))

    def versions(self) -> tuple[str, ...]:
        """What its compiler, and what the program runs under, say about themselves."""
        asked = [(tools.find(*self.compilers), "--version")]
        asked += [(tools.find(word), "--version") for word in self.under[:1]]
        return tuple(tools.version(command) for command in asked)


WAYS = (
    Way("gcc", ("gcc",), _C99),
    Way("clang", ("clang-19", "clang"), _C99),
    Way("tcc", ("tcc",), ("-std=c99",)),
    Way("C++17", ("g++",), ("-x", "c++", "-std=c++17", "-O2", "-ffp-contract=off")),
    Way(
        "address and undefined-behaviour sanitizers",
        ("gcc",),
        (*_CHECKED, "-fsanitize=address,undefined", "-fno-sanitize-recover=all"),
    ),
    Way("valgrind", ("gcc",), _CHECKED, ("valgrind", "-q", "--error-exitcode=9")),
)
"""With -ffp-contract=off results are the golden vectors bit for bit where IEEE 754 fixes them."""


@dataclass(frozen=True, slots=True)
class HostTests:
    """The test program passes on this machine, whatever compiles it."""

    name: str = "tests"

    def missing(self) -> str:
        """Why it cannot run here."""
        return "" if any(not way.missing() for way in WAYS) else "no C compiler is installed"

    def run(self, folder: Path) -> Record:
        """Build and run it in every way there is."""
        sources = [
            *tools.sources(folder),
            *(f"test/{path.name}" for path in sorted((folder / "test").glob("test_*.c"))),
        ]
        ways = [way for way in WAYS if not way.missing()]
        with tempfile.TemporaryDirectory(prefix="symnav-") as scratch:
            program = str(Path(scratch) / "tests")
            said = {way.name: _tried(way, folder, sources, program) for way in ways}
        findings = tuple(f"{name}: {text}" for name, text in said.items() if not _passed(text))
        left_out = [f"{way.name} (no {way.missing()})" for way in WAYS if way.missing()]
        checks = max((_checks(text) for text in said.values()), default=0)
        without = f"; left out: {', '.join(left_out)}" if left_out else ""
        return Record(
            self.name,
            "; ".join(dict.fromkeys(version for way in ways for version in way.versions())),
            Verdict.FAILED if findings else Verdict.PASSED,
            f"{checks} checks passed with {', '.join(said)}{without}"
            if not findings
            else f"the test program fails in {len(findings)} of {len(said)} ways",
            " && ".join(("mkdir -p build", *(way.repeated() for way in ways))),
            assumptions=("The golden vectors were judged against 50 digits when they were made.",),
            findings=findings,
            details={
                "checks": checks,
                "ways": [_described(way) for way in ways],
                "left out": left_out,
            },
        )


def _described(way: Way) -> dict[str, object]:
    return {
        "name": way.name,
        "version": "; ".join(way.versions()),
        "command": way.repeated(),
        "flags": way.flags,
        "under": way.under,
    }


def _tried(way: Way, folder: Path, sources: Sequence[str], program: str) -> str:
    built = tools.call(way.command(sources, program), folder)
    if built.code:
        said = built.output.strip()[:500] or f"exit status {built.code}"
        return f"does not compile: {said}"
    ran = tools.call([*way.under, program], folder)
    return ran.output.strip() if not ran.code else f"exit status {ran.code}: {ran.output[-500:]}"


def _passed(text: str) -> bool:
    found = _SUMMARY.findall(text)
    return bool(found) and all(failures == "0" for _, _, failures in found)


def _checks(text: str) -> int:
    return sum(int(checks) for _, checks, _ in _SUMMARY.findall(text))


@dataclass(frozen=True, slots=True)
class Reach:
    """The test program reaches every line, branch and condition."""

    name: str = "mcdc"

    def missing(self) -> str:
        """Why it cannot run here."""
        return "" if coverage.available() else "clang 18 or later with llvm-cov is not installed"

    def run(self, folder: Path) -> Record:
        """Build it for coverage and count."""
        try:
            found = coverage.measure(folder)
        except (BuildError, ProofError) as error:
            return broken(self.name, coverage.command(), str(error))
        total = found.total
        findings = tuple(
            f"{file.path}: {kind} {count.reached} of {count.total}"
            for file in found.files
            for kind, count in _counts(file)
            if not count.is_complete
        )
        counted = ", ".join(f"{c.reached} of {c.total} {kind}" for kind, c in _counts(total))
        return Record(
            self.name,
            found.tool,
            Verdict.PASSED if found.is_complete else Verdict.FAILED,
            f"{counted} (MC/DC) reached",
            coverage.command(),
            assumptions=(coverage.UNION,),
            findings=findings,
            details={kind: [c.reached, c.total] for kind, c in _counts(total)},
        )


def _counts(file: coverage.FileCoverage) -> Iterator[tuple[str, coverage.Count]]:
    yield "lines", file.lines
    yield "branches", file.branches
    yield "conditions", file.conditions


@dataclass(frozen=True, slots=True)
class CortexM:
    """The test program passes on an emulated processor, and the bits are those of this machine."""

    cpu: str

    @property
    def name(self) -> str:
        """Stem of the record's file."""
        return self.cpu.replace("-", "_")

    def missing(self) -> str:
        """Why it cannot run here."""
        lacking = emulation.missing()
        return f"{', '.join(lacking)} not installed" if lacking else ""

    def run(self, folder: Path) -> Record:
        """Build a copy for the processor and run it."""
        command = f"make -C test/semihost run CPU={self.cpu}"
        try:
            with tempfile.TemporaryDirectory(prefix="symnav-") as scratch:
                copy = Path(scratch) / "bundle"
                shutil.copytree(folder, copy, ignore=shutil.ignore_patterns("build"))
                found = emulation.run(copy, self.cpu)
        except BuildError as error:
            return broken(self.name, command, str(error))
        exact = sum(call.exact for call in found.calls)
        most = max((call.flash for call in found.calls), default=0)
        return Record(
            self.name,
            f"{found.compiler}; {found.emulator}",
            Verdict.FAILED if found.findings else Verdict.PASSED,
            f"tests pass; {exact} of {len(found.calls)} calls prescribed to the last bit and equal "
            f"to this machine's; at most {most} bytes of flash",
            command,
            assumptions=(
                "The emulator executes instructions; it says nothing about cycles.",
                "Two mathematics libraries may differ by 2 units in the last place.",
            ),
            findings=found.findings,
            details={
                "machine": found.machine,
                "flags": found.flags,
                "calls": [
                    {
                        "symbol": call.symbol,
                        "instructions": round(call.instructions, 1),
                        "flash": call.flash,
                        "stack": call.stack,
                    }
                    for call in found.calls
                ],
            },
        )
