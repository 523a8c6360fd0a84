"""libFuzzer with address and undefined-behaviour sanitizers over every entry point."""

from __future__ import annotations

import re
import tempfile
from dataclasses import dataclass
from pathlib import Path

from symnav.export.runners import tools
from symnav.export.runners.records import Record, Verdict

SCRIPT = "proof/run_fuzz.sh"
_DONE = re.compile(r"Done (\d+) runs")
_COVERED = re.compile(r"cov: (\d+)")
_SUMMARY = re.compile(r"^(?:SUMMARY: .*|.*runtime error: .*)$", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Fuzz:
    """No run of the fuzzer breaks a promise of the headers.

    Attributes:
        runs: calls of entry points.
        seed: of the fuzzer.
        seconds: after which it ends in any case.
    """

    runs: int = 200_000
    seed: int = 1
    seconds: int = 60
    name: str = "fuzz"

    def missing(self) -> str:
        """Why it cannot run here: no clang, or none with libFuzzer."""
        clang = _clang()
        if not clang:
            return "clang is not installed"
        with tempfile.TemporaryDirectory(prefix="symnav-") as scratch:
            source = Path(scratch) / "probe.c"
            source.write_text(
                "#include <stddef.h>\n"
                "int LLVMFuzzerTestOneInput(const unsigned char *d, size_t n);\n"
                "int LLVMFuzzerTestOneInput(const unsigned char *d, size_t n)\n"
                "{ (void)d; (void)n; return 0; }\n",
                encoding="utf-8",
            )
            command = [clang, "-fsanitize=fuzzer,address,undefined", "probe.c", "-o", "probe"]
            done = tools.call(command, Path(scratch))
        return "" if done.code == 0 else "clang has no libFuzzer (apt: libclang-rt-dev)"

    def run(self, folder: Path) -> Record:
        """Build the harness of the bundle outside of it, and run it."""
        options = [f"-runs={self.runs}", f"-seed={self.seed}", f"-max_total_time={self.seconds}"]
        with tempfile.TemporaryDirectory(prefix="symnav-") as scratch:
            done = tools.call(
                ["sh", SCRIPT, *options, "-max_len=4096"],
                folder,
                environment={"CLANG": _clang(), "OUT": scratch},
            )
        runs, covered = _DONE.findall(done.output), _COVERED.findall(done.output)
        findings = [line.strip() for line in _SUMMARY.findall(done.output)]
        if (done.code or not runs) and not findings:
            findings.append(f"exit status {done.code}: {done.output.strip()[-500:]}")
        return Record(
            self.name,
            tools.version([_clang(), "--version"]),
            Verdict.FAILED if findings else Verdict.PASSED,
            f"{runs[-1] if runs else 0} runs with sanitizers, {len(findings)} findings",
            f"sh {SCRIPT} {' '.join(options)} -max_len=4096",
            assumptions=("What the fuzzer did not try is not shown.",),
            findings=tuple(findings),
            details={"seed": self.seed, "edges": int(covered[-1]) if covered else 0},
        )


def _clang() -> str:
    return tools.find(
        "clang", "clang-19", "clang-18", "clang-17", "clang-16", "clang-15", "clang-14"
    )
