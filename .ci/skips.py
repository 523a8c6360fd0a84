"""Reads JUnit reports: which tests were skipped, why, and whether another run made up for it.

usage: python .ci/skips.py files REPORT             the test files of what was skipped
       python .ci/skips.py none REPORT [EARLIER]    fails when a test of REPORT was skipped, or one
                                                    that EARLIER skipped is not in REPORT
       python .ci/skips.py summary REPORT ...       what ran, and what ran nowhere and why

Commands that could not be installed are named, with blanks between them, in CI_ABSENT. A test that
is skipped because of one of them is listed and does not fail the run; every other skip does.
"""

from __future__ import annotations

import os
import re
import sys
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class Case:
    """One test of a report.

    Attributes:
        module: dotted name.
        name: of the test; empty where a module was skipped as a whole.
        skipped: True when it did not run; what is expected to fail ran.
        reason: why not.
    """

    module: str
    name: str
    skipped: bool
    reason: str

    @property
    def label(self) -> str:
        """As it is listed."""
        return f"{self.module}::{self.name}"

    @property
    def excused(self) -> bool:
        """True when its reason names a command that could not be installed."""
        words = set(re.findall(r"[\w+.-]+", self.reason))
        return bool(words & set(os.environ.get("CI_ABSENT", "").split()))


def cases(report: Path) -> Iterator[Case]:
    """Every test of a report."""
    for case in ElementTree.parse(report).iter("testcase"):
        skipped = case.find("skipped")
        gone = skipped is not None and skipped.get("type") != "pytest.xfail"
        reason = (skipped.get("message", "") or skipped.text or "") if skipped is not None else ""
        path, name = case.get("classname", ""), case.get("name", "")
        if not path:
            yield Case(name, "", gone, reason)
            continue
        parts = path.split(".")
        while len(parts) > 1 and not parts[-1].startswith("test_"):
            name = f"{parts.pop()}.{name}"
        yield Case(".".join(parts), name, gone, reason)


def files(report: Path) -> list[str]:
    """Test files, relative to the root, in which something was skipped."""
    modules = {case.module for case in cases(report) if case.skipped}
    return sorted(f"{module.replace('.', '/')}.py" for module in modules)


def missing(*reports: Path) -> list[Case]:
    """What was skipped and ran in none of the reports."""
    every = [case for report in reports for case in cases(report)]
    ran = {(case.module, case.name) for case in every if not case.skipped}
    modules = {module for module, _ in ran}
    found = {
        case.label: case
        for case in every
        if case.skipped
        and not ((case.module, case.name) in ran if case.name else case.module in modules)
    }
    return [found[label] for label in sorted(found)]


def none(report: Path, earlier: Path | None) -> int:
    """1 when a test is missing without an excuse, or none ran."""
    here = [case for case in cases(report) if case.skipped]
    before = missing(report, earlier) if earlier else []
    found = {case.label: case for case in (*here, *before)}
    count = sum(not case.skipped for case in cases(report))
    print(f"{count} tests ran, {len(found)} did not")
    for label in sorted(found):
        print(f"  skipped: {label}: {found[label].reason}")
    return int(not count or not all(case.excused for case in found.values()))


def summary(*reports: Path) -> int:
    """Prints what ran in each run, and by reason what ran in none of them."""
    for report in reports:
        print(f"{report.stem}: {sum(not case.skipped for case in cases(report))} tests ran")
    absent = os.environ.get("CI_ABSENT", "").split()
    print(f"could not be installed: {', '.join(absent) or 'nothing'}")
    by_reason: dict[str, list[str]] = defaultdict(list)
    for case in missing(*reports):
        by_reason[case.reason or "no reason given"].append(case.label)
    print(f"did not run: {sum(map(len, by_reason.values())) or 'nothing'}")
    for reason, labels in sorted(by_reason.items()):
        print(f"  {reason}:", *labels, sep="\n    ")
    return 0


def main(verb: str, *reports: str) -> int:
    """Prints what the verb asks for; 1 when a test is missing."""
    paths = [Path(report) for report in reports]
    if verb == "files":
        print("\n".join(files(paths[0])))
        return 0
    if verb == "summary":
        return summary(*paths)
    return none(paths[0], paths[1] if len(paths) > 1 else None)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
