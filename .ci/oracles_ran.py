"""Asserts from a JUnit report that every third-party comparison ran and none was skipped.

usage: python .ci/oracles_ran.py REPORT
"""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

ORACLES = Path(__file__).parents[1] / "tests" / "oracles"


def main(report: str) -> int:
    """Counts the tests of every file of ``tests/oracles``; 1 when one did not run."""
    ran: Counter[str] = Counter()
    skipped: Counter[str] = Counter()
    for case in ElementTree.parse(report).iter("testcase"):
        module = case.get("classname", "")
        counter = skipped if case.find("skipped") is not None else ran
        counter.update([name for name in expected() if f"oracles.{name}" in module])
    for name in expected():
        print(f"{name}: {ran[name]} ran, {skipped[name]} skipped")
    return int(any(not ran[name] or skipped[name] for name in expected()))


def expected() -> list[str]:
    """The test files, one per library."""
    return sorted(path.stem for path in ORACLES.glob("test_*.py"))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
