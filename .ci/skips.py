"""Reads JUnit reports: which tests were skipped, and whether another run made up for it.

usage: python .ci/skips.py files REPORT             the test files of what was skipped
       python .ci/skips.py none REPORT [EARLIER]    fails when a test of REPORT was skipped, or one
                                                    that EARLIER skipped is not in REPORT
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[1]


def cases(report: Path) -> Iterator[tuple[str, str, bool]]:
    """Module, test and whether it was skipped; a module skipped as a whole has no test.

    What is expected to fail ran.
    """
    for case in ElementTree.parse(report).iter("testcase"):
        skipped = case.find("skipped")
        gone = skipped is not None and skipped.get("type") != "pytest.xfail"
        path, name = case.get("classname", ""), case.get("name", "")
        if not path:
            yield name, "", gone
            continue
        parts = path.split(".")
        while len(parts) > 1 and not parts[-1].startswith("test_"):
            name = f"{parts.pop()}.{name}"
        yield ".".join(parts), name, gone


def files(report: Path) -> list[str]:
    """Test files, relative to the root, in which something was skipped."""
    modules = {module for module, _, skipped in cases(report) if skipped}
    return sorted(f"{module.replace('.', '/')}.py" for module in modules)


def missing(report: Path, earlier: Path | None) -> list[str]:
    """What was skipped, here or for good."""
    ran = {(module, name) for module, name, skipped in cases(report) if not skipped}
    modules = {module for module, _ in ran}
    found = [f"{module}::{name}" for module, name, skipped in cases(report) if skipped]
    for module, name, skipped in cases(earlier) if earlier else ():
        made_up = (module, name) in ran if name else module in modules
        if skipped and not made_up:
            found.append(f"{module}::{name}")
    return sorted(set(found))


def main(verb: str, report: str, earlier: str | None = None) -> int:
    """Prints what the verb asks for; 1 when a test is missing."""
    if verb == "files":
        print("\n".join(files(Path(report))))
        return 0
    found = missing(Path(report), Path(earlier) if earlier else None)
    count = sum(not skipped for _, _, skipped in cases(Path(report)))
    print(f"{count} tests ran, {len(found)} did not")
    for name in found:
        print(f"  skipped: {name}")
    return int(bool(found) or not count)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
