"""symnav itself: the files of its generated package, as they are."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from benchmarks.contestants.contestant import Contestant, adapter
from benchmarks.problems import Problem
from symnav import pipeline

FUNCTION = "model"
EPOCHS = 64


def contestants(problem: Problem, folder: Path) -> Iterator[Contestant]:
    """Dense, non-zeros and batch, without guards; and with them, as it flies."""
    bare = generated(problem, folder / "bare", guarded=False)
    flown = generated(problem, folder / "guarded", guarded=True)
    yield _nonzeros(problem, "symnav_nz", bare)
    yield _dense(problem, "symnav_dense", bare)
    yield _batch(problem, "symnav_batch", bare)
    yield _nonzeros(problem, "symnav_nz_guarded", flown)
    yield _dense(problem, "symnav_dense_guarded", flown)
    yield _batch(problem, "symnav_batch_guarded", flown)


def generated(problem: Problem, folder: Path, *, guarded: bool) -> Path:
    """The C tree of the problem's package."""
    text = problem.spec.read_text(encoding="utf-8")
    if not guarded:
        text = text.replace('name = "model"\n', 'name = "model"\nguards = "assume"\n')
    folder.mkdir(parents=True, exist_ok=True)
    spec = folder / f"{problem.package}.toml"
    spec.write_text(text, encoding="utf-8")
    return pipeline.generate(pipeline.load(spec), folder, force=True).package / "c"


def _nonzeros(problem: Problem, name: str, tree: Path) -> Contestant:
    values = problem.rows
    call = _call(problem, "_nz", ["out", f"out + {values}"])
    if problem.items:
        limit = 32
        count = len(problem.nonzeros[0])
        order = [
            *range(values),
            *(values + column * limit + i for i in range(problem.items) for column in range(count)),
        ]
        size = values + count * limit
    else:
        order = list(range(values + len(problem.pattern)))
        size = len(order)
    return _contestant(problem, name, tree, call, order, size)


def _dense(problem: Problem, name: str, tree: Path) -> Contestant:
    values, columns = problem.rows, problem.columns
    call = _call(problem, "", ["out", f"out + {values}"])
    order = [*range(values), *(values + row * columns + column for row, column in problem.pattern)]
    return _contestant(problem, name, tree, call, order, values * (1 + columns))


def _batch(problem: Problem, name: str, tree: Path) -> Contestant:
    values, columns = problem.rows, problem.columns
    block = EPOCHS * values
    inputs = _arguments(problem)
    arguments = [str(EPOCHS)]
    for place in inputs:
        arguments += [place, str(problem.record)]
        arguments += [str(problem.items)] if problem.items and len(arguments) == 3 else []
    arguments += ["out", f"out + {block}", "status", *(["items"] if problem.items else [])]
    call = [
        f"static unsigned char status[{EPOCHS}];",
        *([f"static unsigned char items[{EPOCHS * problem.items}];"] if problem.items else []),
        f"(void){problem.package}_{FUNCTION}_batch({', '.join(arguments)});",
    ]
    order: list[int] = []
    for epoch in range(EPOCHS):
        order += range(epoch * values, (epoch + 1) * values)
        start = block + epoch * values * columns
        order += [start + row * columns + column for row, column in problem.pattern]
    size = block * (1 + columns)
    return _contestant(problem, name, tree, call, order, size, "_batch", EPOCHS)


def _arguments(problem: Problem) -> list[str]:
    names = ["x", *(name for name, _ in problem.inputs)]
    return [f"in + {problem.offsets[name]}" for name in names]


def _call(problem: Problem, suffix: str, outputs: Sequence[str]) -> list[str]:
    state, *inputs = _arguments(problem)
    count = [str(problem.items)] if problem.items else []
    items = ["items"] if problem.items else []
    arguments = [state, *count, *inputs, *outputs, *items]
    locals_ = [f"static unsigned char items[{problem.items}];"] if problem.items else []
    return [*locals_, f"(void){problem.package}_{FUNCTION}{suffix}({', '.join(arguments)});"]


def _contestant(
    problem: Problem,
    name: str,
    tree: Path,
    call: Sequence[str],
    order: Sequence[int],
    size: int,
    suffix: str | None = None,
    epochs: int = 1,
) -> Contestant:
    symbol = f"{problem.package}_{FUNCTION}"
    called = next(line for line in call if line.startswith("(void)"))
    root = called.removeprefix("(void)").partition("(")[0]
    source = f'#include "{symbol}.c"\n\n' + adapter(problem, name, call)
    include = (tree / "include", tree / "src")
    return Contestant(
        name, problem, source, tuple(order), size, include=include, root=root, epochs=epochs
    )


def lines(tree: Path, problem: Problem) -> Mapping[str, int]:
    """Lines of the kernel file."""
    kernel = tree / "src" / f"{problem.package}_{FUNCTION}_kernel.h"
    return {kernel.name: len(kernel.read_text(encoding="utf-8").splitlines())}
