"""The mutation run: ``python -m tests.mutation.run``.

Works on a copy of the project made at the start, so that the working tree may be edited meanwhile.
A mutant meets the quick tests of its file first; what survives those is written into a copy of its
own and meets every test that could notice, compilers included. The table is written after every
mutant; ``--resume`` goes on where it stands and repeats what has changed since.
"""

from __future__ import annotations

import argparse
import ast
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue

from tests.mutation import suites, table
from tests.mutation.mutants import Mutant, mutants, mutated

PROJECT = Path(__file__).resolve().parents[2]
COPIED = ("symnav", "templates", "tests", "generated", "docs", "pyproject.toml", "README.md")
QUICK_LIMIT = 240.0
FULL_LIMIT = 1800.0
ENVIRONMENT = {"OPENBLAS_NUM_THREADS": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}


@contextmanager
def copy_of(project: Path) -> Iterator[Path]:
    """A copy of what tests need, in a temporary directory."""
    with tempfile.TemporaryDirectory(prefix="mutation-") as folder:
        for name in COPIED:
            source, target = project / name, Path(folder) / name
            if source.is_dir():
                shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
            elif source.is_file():
                shutil.copyfile(source, target)
        yield Path(folder)


class Worker:
    """A process that evaluates mutants in forks of itself."""

    def __init__(self, root: Path) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.mutation.worker"],
            cwd=root,
            env={**os.environ, **ENVIRONMENT},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def __call__(self, mutant: Mutant | None, tests: Sequence[str]) -> str | None:
        """The first test that fails under the mutant (or without any), or None."""
        assert self._process.stdin is not None and self._process.stdout is not None
        name = None if mutant is None else mutant.id
        request = {"id": name, "tests": list(tests), "limit": QUICK_LIMIT}
        print(json.dumps(request), file=self._process.stdin, flush=True)
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError("the worker ended; its message is above")
        killed_by: str | None = json.loads(line)["killed_by"]
        return killed_by

    def close(self) -> None:
        """Let the process end."""
        assert self._process.stdin is not None and self._process.stdout is not None
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()


@dataclass
class Run:
    """What one run needs: the copy, the workers, and what an earlier run knew."""

    root: Path
    workers: SimpleQueue[Worker]
    known: dict[str, table.Row]
    thorough: bool

    def __call__(self, mutant: Mutant) -> table.Row:
        """Evaluate one mutant: its earlier killer, the quick tests, then everything."""
        worker = self.workers.get()
        try:
            killer = self._killer(mutant)
            killed_by = worker(mutant, [killer]) if killer else None
            if killed_by is None or killed_by.startswith("pytest ended"):
                killed_by = worker(mutant, suites.quick(self.root, mutant.file))
        finally:
            self.workers.put(worker)
        if killed_by is not None or not self.thorough:
            return table.row(mutant, "quick", killed_by)
        return table.row(mutant, "full", run_everything(self.root, mutant))

    def _killer(self, mutant: Mutant) -> str | None:
        entry = self.known.get(mutant.id)
        if entry is None or "::" not in entry.killed_by:
            return None
        exists = (self.root / entry.killed_by.partition("::")[0]).is_file()
        return entry.killed_by if exists else None


def run_everything(root: Path, mutant: Mutant) -> str | None:
    """Every test that could notice, on a copy of the project that holds the mutant as text.

    A test that fails without the mutant as well is left out, and the rest run again.
    """
    failing: list[str] = []
    with copy_of(root) as folder:
        path = folder / mutant.file
        tree = mutated(path.read_text(encoding="utf-8"), mutant)
        path.write_text(ast.unparse(tree), encoding="utf-8")
        while True:
            killer = _first_failure(folder, [*suites.full(folder, mutant.file), *_without(failing)])
            if killer is None or "::" not in killer:
                return killer
            if _first_failure(root, [killer]) is None:
                return killer
            failing.append(killer)


def _without(tests: Sequence[str]) -> list[str]:
    return [word for test in tests for word in ("--deselect", test)]


def _first_failure(folder: Path, arguments: Sequence[str]) -> str | None:
    """The first test that fails in a copy of the project, or what ended pytest, or None."""
    command = [sys.executable, "-m", "pytest", "-x", "-q", "--tb=no", "-p", "no:cacheprovider"]
    try:
        done = subprocess.run(
            [*command, *arguments], cwd=folder, timeout=FULL_LIMIT, capture_output=True, text=True,
            check=False, env={**os.environ, "PYTHONPATH": str(folder), "OPENBLAS_NUM_THREADS": "1"},
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return "timeout"
    if done.returncode == 0:
        return None
    lines = [line for line in done.stdout.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    named = [line.partition(" ")[2].partition(" - ")[0] for line in lines]
    return next(iter(named), f"pytest ended with {done.returncode}")


def evaluate(
    root: Path,
    chosen: Sequence[Mutant],
    known: dict[str, table.Row],
    *,
    jobs: int,
    thorough: bool,
    report: Callable[[table.Row], None],
    baseline: bool = True,
) -> None:
    """Evaluate mutants on a copy of the project; every result is reported when it is there.

    ``baseline`` asks that the quick tests pass without any mutant, before anything else.

    Raises:
        RuntimeError: when the tests fail without any mutant.
    """
    with ExitStack() as stack:
        queue: SimpleQueue[Worker] = SimpleQueue()
        for _ in range(jobs):
            worker = Worker(root)
            stack.callback(worker.close)
            queue.put(worker)
        if baseline:
            _require_passing(root, queue, chosen)
        run, lock = Run(root, queue, known, thorough), threading.Lock()

        def one(mutant: Mutant) -> None:
            result = run(mutant)
            with lock:
                report(result)

        with ThreadPoolExecutor(jobs) as pool:
            list(pool.map(one, chosen))


def _require_passing(root: Path, queue: SimpleQueue[Worker], chosen: Sequence[Mutant]) -> None:
    first = queue.get()
    tests = dict.fromkeys(t for m in chosen for t in suites.quick(root, m.file))
    failing = first(None, list(tests)) if tests else None
    if failing is not None:
        raise RuntimeError(f"without any mutant, {failing} fails; mend that first")
    queue.put(first)


def sample(everything: Sequence[Mutant], count: int | None, seed: int) -> list[Mutant]:
    """Some of the mutants, or all; the same ones for the same seed."""
    if count is None or count >= len(everything):
        return list(everything)
    return sorted(random.Random(seed).sample(list(everything), count))


def status(everything: Sequence[Mutant], rows: dict[str, table.Row]) -> str:
    """How the table stands, in a few lines."""
    reviewed = table.reviews()
    fresh = [m for m in everything if table.is_fresh(m, rows)]
    killed = [m for m in fresh if rows[m.id].verdict == "killed"]
    alive = [m for m in fresh if rows[m.id].verdict == "survived"]
    open_ = [m for m in alive if not table.is_reviewed(m, reviewed)]
    lines = [
        f"{len(everything)} mutants: {len(killed)} killed, {len(alive)} survived "
        f"({len(alive) - len(open_)} reviewed), {len(everything) - len(fresh)} not evaluated"
    ]
    lines += [f"  {m.id} (line {m.line}): {m.change}" for m in open_]
    return "\n".join(lines)


def main() -> int:
    """Run as the arguments say; 1 when a survivor has no reason."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutation.run", description=__doc__)
    parser.add_argument("--sample", type=int, help="evaluate so many mutants, chosen by the seed")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--resume", action="store_true", help="keep rows that are still true")
    parser.add_argument("--file", help="only mutants of files that contain this text")
    parser.add_argument("--quick", action="store_true", help="leave out the full tests")
    parser.add_argument("--status", action="store_true", help="say how the table stands and stop")
    given = parser.parse_args()
    rows = table.read()
    if given.status:
        print(status(mutants(PROJECT), rows))
        return 0
    with copy_of(PROJECT) as root:
        everything = mutants(root)
        chosen = sample(everything, given.sample, given.seed)
        chosen = [m for m in chosen if given.file is None or given.file in m.file]
        if given.resume:
            thorough = not given.quick
            chosen = [m for m in chosen if not table.is_settled(m, rows, thorough=thorough)]

        def report(result: table.Row) -> None:
            rows[result.id] = result
            table.write(rows.values(), everything)
            print(f"{result.verdict:9}{result.id}: {result.change}  [{result.killed_by}]")

        evaluate(root, chosen, dict(rows), jobs=given.jobs, thorough=not given.quick, report=report)
    text = status(everything, rows)
    print(text)
    return int("\n" in text)


if __name__ == "__main__":
    sys.exit(main())
