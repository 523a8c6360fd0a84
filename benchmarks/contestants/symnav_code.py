"""symnav itself: the files of its generated package, as they are."""

from __future__ import annotations

import platform
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from benchmarks.contestants.contestant import Contestant
from benchmarks.contestants.single import mended_text
from benchmarks.problems import Problem
from symnav import ir, pipeline
from symnav.bench.adapters import EPOCHS, Entries
from symnav.bench.candidate import Candidate
from symnav.build.compiler import FLAGS, dispatch_flags, find_compiler
from symnav.emit import c
from symnav.emit.lanes import lanes_of
from symnav.lower.module import module
from symnav.spec.records import Spec

FUNCTION = "model"
PARTS = ("load", "kernel", "shared", "load_item", "item")
"""Functions of a kernel file; which of them there are depends on the model."""


def contestants(problem: Problem, folder: Path) -> Iterator[Contestant]:
    """Dense, non-zeros and batch, without guards; and with them, as it flies."""
    for guarded in (False, True):
        entries = generated(problem, folder / ("guarded" if guarded else "bare"), guarded=guarded)
        mark = "_guarded" if guarded else ""
        yield Contestant(
            problem=problem,
            candidate=entries.nonzeros(f"symnav_nz{mark}"),
            order=_nonzeros(problem, entries.function.maximum or 0),
            text=_kernel(entries),
            functions=tuple(f"{FUNCTION}_{part}" for part in PARTS),
        )
        yield Contestant(
            problem=problem,
            candidate=entries.dense(f"symnav_dense{mark}"),
            order=_dense(problem, 1),
        )
        if guarded:
            own = replace(entries, label=f"{entries.label}_packaged").dense("symnav_packaged")
            packaged = replace(own, flags=package_flags())
            yield Contestant(problem=problem, candidate=packaged, order=_dense(problem, 1))
        yield Contestant(
            problem=problem,
            candidate=entries.batch(f"symnav_batch{mark}"),
            order=_dense(problem, EPOCHS),
        )
        yield Contestant(
            problem=problem,
            candidate=entries.batch(f"symnav_batch_nz{mark}", nonzeros=True),
            order=_rows(problem),
        )
        if not problem.items:
            yield Contestant(
                problem=problem,
                candidate=entries.blocks(f"symnav_blocks{mark}"),
                order=_blocks(problem, lanes_of(entries.function)),
            )


def package_flags() -> tuple[str, ...]:
    """Flags of a package that is built for machines unknown, whatever stands before them."""
    portable = ("-march=x86-64",) if platform.machine() == "x86_64" else ()
    return (*FLAGS, *dispatch_flags(find_compiler()), *portable)


def in_single(problem: Problem, folder: Path) -> Iterator[Contestant]:
    """Dense and non-zeros in single precision, without guards and with them.

    A range to a satellite must be double and is refused as float elsewhere. Here floats compare
    the code.
    """
    for guarded in (False, True):
        place = folder / ("guarded" if guarded else "bare")
        spec = specification(problem, place, guarded=guarded)
        floats = tuple(replace(e, scalars=("double", "float")) for e in spec.entries)
        single = replace(spec, entries=floats)
        functions = pipeline.c_route(single, pipeline.derive(single))
        tree = module(single, functions, ir.Scalar.FLOAT)
        for path, text in c.emit(tree).items():
            file = place / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        (function,) = (f for f in functions if f.name == FUNCTION)
        entries = Entries(tree.name, function, place / "c", problem.items, f"_{problem.name}")
        mark = "_guarded" if guarded else ""
        limit = function.maximum or 0
        yield _in_single(problem, entries.nonzeros(f"symnav_nz{mark}"), _nonzeros(problem, limit))
        yield _in_single(problem, entries.dense(f"symnav_dense{mark}"), _dense(problem, 1))


def _in_single(problem: Problem, candidate: Candidate, order: tuple[int, ...]) -> Contestant:
    """The library is of floats already, its adapter becomes so."""
    changed = replace(candidate, source=mended_text(candidate.source))
    return Contestant(problem=problem, candidate=changed, order=order)


def specification(problem: Problem, folder: Path, *, guarded: bool) -> Spec:
    """The problem's specification, with or without guards."""
    text = problem.spec.read_text(encoding="utf-8")
    if not guarded:
        text = text.replace('name = "model"\n', 'name = "model"\nguards = "assume"\n')
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{problem.package}.toml"
    file.write_text(text, encoding="utf-8")
    return pipeline.load(file)


def generated(problem: Problem, folder: Path, *, guarded: bool) -> Entries:
    """The entry points of the problem's package."""
    spec = specification(problem, folder, guarded=guarded)
    package = pipeline.generate(spec, folder, force=True).package
    (function,) = (f for f in pipeline.c_route(spec, pipeline.derive(spec)) if f.name == FUNCTION)
    label = f"_{problem.name}_{'guarded' if guarded else 'bare'}"
    return Entries(problem.package, function, package / "c", problem.items, label)


def _kernel(entries: Entries) -> str:
    """The kernel file."""
    kernel = entries.tree / "src" / f"{entries.prefix}_{FUNCTION}_kernel.h"
    return kernel.read_text(encoding="utf-8")


def _nonzeros(problem: Problem, limit: int) -> tuple[int, ...]:
    """Values, then non-zeros: by row, or in columns as long as the most satellites."""
    values = problem.rows
    if not problem.items:
        return tuple(range(values + len(problem.pattern)))
    columns = range(len(problem.nonzeros[0]))
    places = (values + k * limit + i for i in range(problem.items) for k in columns)
    return (*range(values), *places)


def _rows(problem: Problem) -> tuple[int, ...]:
    """Values of all epochs, then their non-zeros; those of satellites in columns."""
    values, count = problem.rows, len(problem.pattern)
    per_item = count // problem.items if problem.items else 0
    order: list[int] = []
    for epoch in range(EPOCHS):
        order += range(epoch * values, (epoch + 1) * values)
        start = EPOCHS * values + epoch * count
        if problem.items:
            cells = ((k, i) for i in range(problem.items) for k in range(per_item))
            order += [start + k * problem.items + i for k, i in cells]
        else:
            order += range(start, start + count)
    return tuple(order)


def _blocks(problem: Problem, lanes: int) -> tuple[int, ...]:
    """Values, then non-zeros, each with the epochs of a block side by side."""
    order: list[int] = []
    for epoch in range(EPOCHS):
        block, lane = divmod(epoch, lanes)
        start = 0
        for size in (problem.rows, len(problem.pattern)):
            order += [start + (block * size + k) * lanes + lane for k in range(size)]
            start += EPOCHS * size
    return tuple(order)


def _dense(problem: Problem, epochs: int) -> tuple[int, ...]:
    """The problem's non-zeros in full Jacobians behind all the values."""
    values, columns = problem.rows, problem.columns
    order: list[int] = []
    for epoch in range(epochs):
        order += range(epoch * values, (epoch + 1) * values)
        start = epochs * values + epoch * values * columns
        order += [start + row * columns + column for row, column in problem.pattern]
    return tuple(order)
