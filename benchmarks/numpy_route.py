"""The NumPy route against SymPy's ``lambdify``, for one epoch and for many.

usage: python benchmarks/numpy_route.py [--json FILE] [--only MODEL,...] [--repetitions N]
                                        [--patience SECONDS]

Every row is one call, interleaved with the others of its size in one process. NumPy's are timed by
the processor time of their thread, which other work on the machine disturbs least:

- ``numpy``: the package's NumPy back end as it is shipped. Arrays in, value and dense Jacobian as
  arrays out, every argument guarded.
- ``numpy_assume``: the same with ``guards = "assume"``, which guards nothing, as ``lambdify`` does.
- ``lambdify_dense``: a flat list with ``cse=True``: the same arrays in, the same arrays out,
  nothing guarded. One epoch lists its zeros; many write column by column into zeros.
- ``lambdify_flat``: the same function alone. Numbers or contiguous columns in, a list of results
  out; nothing is taken apart, put together or guarded.
- ``lambdify_matrices``: ``lambdify`` of a vector and a matrix, as it is usually written; one epoch
  only, since its results cannot be broadcast.
- ``jax``: the package's NumPy back end under ``jax.jit``; ``jax_lambdify``: the flat function. They
  take turns among themselves and are timed by the clock on the wall: JAX has threads of its own.
"""

from __future__ import annotations

import argparse
import importlib
import json
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np
import sympy as sp

from benchmarks import python_calls
from benchmarks.contestants import derivatives
from benchmarks.contestants.symnav_code import FUNCTION
from benchmarks.measuring import records
from benchmarks.problems import PROBLEMS, Problem
from benchmarks.python_calls import Array, Call, arguments, lambdified
from benchmarks.quiet import Core, add_options, core
from symnav import pipeline

SIZES = (1, 1024, 100_000)
MODELS = ("gps", "ekfcal", "pr8", "pr32", "imu1", "imu4")
AGREEMENT = 1e-12
NAMED = 'name = "model"\n'


def main() -> None:
    """Measures, prints a table and, when asked for, writes the figures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures here")
    parser.add_argument("--only", default=",".join(MODELS), help="models, separated by commas")
    add_options(parser, python_calls.REPETITIONS, 90.0)
    options = parser.parse_args()
    figures: dict[str, dict[str, dict[str, float]]] = {}
    with tempfile.TemporaryDirectory() as folder:
        own = core(Path(folder), options.patience)
        for problem in (p for p in PROBLEMS if p.name in options.only.split(",")):
            figures[problem.name] = measure(problem, Path(folder), own, options.repetitions)
            print_table(problem.name, figures[problem.name])
    if options.json:
        options.json.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")


def measure(
    problem: Problem, folder: Path, own: Core, repetitions: int
) -> dict[str, dict[str, float]]:
    """Nanoseconds per epoch by number of epochs and by way."""
    function = imported(problem, folder / problem.name, assume=False)
    unguarded = imported(problem, folder / f"{problem.name}_assume", assume=True)
    drawn = records(problem)
    found = {}
    for epochs in SIZES:
        chosen = np.resize(drawn, (epochs, problem.record)) if epochs > 1 else drawn[0]
        named = dict(ways(problem, function, unguarded, chosen))
        found[str(epochs)] = {
            name: ns
            for jax in (False, True)
            for name, ns in python_calls.timed(
                {n: (call, epochs) for n, call in named.items() if n.startswith("jax") is jax},
                own,
                repetitions,
                time.perf_counter_ns if jax else time.thread_time_ns,
            ).items()
        }
    return found


def imported(problem: Problem, folder: Path, *, assume: bool) -> Callable[..., Any]:
    """The function of a package generated with guards or without."""
    text = problem.spec.read_text(encoding="utf-8")
    if assume:
        text = text.replace(NAMED, f'{NAMED}guards = "assume"\n')
        assert "assume" in text
    folder.mkdir()
    spec = folder / problem.spec.name
    spec.write_text(text, encoding="utf-8")
    package = pipeline.import_package(pipeline.generate(pipeline.load(spec), folder).package)
    function: Call = getattr(package.numpy, FUNCTION)
    return function


def ways(
    problem: Problem,
    function: Callable[..., Any],
    unguarded: Callable[..., Any],
    chosen: Array,
) -> Iterator[tuple[str, Call]]:
    """Every way to evaluate one record or many; those that give the same arrays agree."""
    x, given = arguments(problem, chosen)
    expected = function(x, **given)
    yield "numpy", lambda: function(x, **given)
    for own, other in zip(expected, unguarded(x, **given), strict=True):
        assert np.array_equal(own, other)
    yield "numpy_assume", lambda: unguarded(x, **given)
    dense = (one_dense if chosen.ndim == 1 else many_dense)(problem)
    parts = [x, *given.values()]
    for own, other in zip(expected, dense(*parts), strict=False):
        assert own.shape == other.shape
        assert np.abs(own - other).max() <= AGREEMENT * max(1.0, np.abs(own).max())
    yield "lambdify_dense", lambda: dense(*parts)
    if chosen.ndim == 1:
        yield from one_epoch(problem, chosen)
        return
    columns = [np.ascontiguousarray(column) for column in chosen.T]
    flat = lambdified(problem, "numpy")
    yield "lambdify_flat", lambda: flat(*columns)
    yield from jitted(problem, function, (x, given), columns)


def one_epoch(problem: Problem, record: Array) -> Iterator[tuple[str, Call]]:
    """``lambdify`` with Python's numbers, and of matrices."""
    flat = lambdified(problem, "math")
    numbers = record.tolist()
    yield "lambdify_flat", lambda: flat(*numbers)
    symbols, entries = derivatives.flat(problem)
    jacobian = sp.zeros(problem.rows, problem.columns)
    for place, entry in zip(problem.pattern, entries[problem.rows :], strict=True):
        jacobian[place] = entry
    both = [sp.Matrix(entries[: problem.rows]), jacobian]
    matrices = sp.lambdify(symbols, both, modules="numpy", cse=True)
    yield "lambdify_matrices", lambda: matrices(*numbers)


def one_dense(problem: Problem) -> Callable[..., tuple[Array, Array]]:
    """Numbers out of the arrays, one flat call, arrays of its list: zeros are part of the list."""
    symbols, entries = derivatives.flat(problem)
    whole: list[sp.Expr] = [sp.Float(0.0)] * (problem.rows * problem.columns)
    for (row, column), entry in zip(problem.pattern, entries[problem.rows :], strict=True):
        whole[row * problem.columns + column] = entry
    listed = [*entries[: problem.rows], *whole]
    flat = sp.lambdify(symbols, listed, modules="math", cse=True)
    rows, shape = problem.rows, (problem.rows, problem.columns)

    def call(*parts: Any) -> tuple[Array, Array]:
        numbers: list[float] = []
        for part in parts:
            numbers += [part] if isinstance(part, float) else part.ravel().tolist()
        found = flat(*numbers)
        return np.array(found[:rows]), np.array(found[rows:]).reshape(shape)

    return call


def many_dense(problem: Problem) -> Callable[..., tuple[Array, Array]]:
    """Columns copied out of the arrays, one flat call, columns written into zeros."""
    flat = lambdified(problem, "numpy")
    rows, pattern = problem.rows, problem.pattern

    def call(*parts: Array) -> tuple[Array, Array]:
        columns: list[Array] = []
        for part in parts:
            columns += list(np.ascontiguousarray(part.reshape(len(part), -1).T))
        found = flat(*columns)
        value = np.empty((len(parts[0]), rows))
        jacobian = np.zeros((len(parts[0]), rows, problem.columns))
        for row in range(rows):
            value[:, row] = found[row]
        for (row, column), entry in zip(pattern, found[rows:], strict=True):
            jacobian[:, row, column] = entry
        return value, jacobian

    return call


def jitted(
    problem: Problem,
    function: Callable[..., Any],
    given: tuple[Array, Mapping[str, Any]],
    columns: list[Array],
) -> Iterator[tuple[str, Call]]:
    """Both under ``jax.jit``, where it is installed."""
    try:
        jax = importlib.import_module("jax")
    except ImportError:
        return
    jax.config.update("jax_enable_x64", True)
    own = jax.jit(lambda x, inputs: function(x, **inputs))
    x, inputs = jax.tree.map(jax.numpy.asarray, given)
    yield "jax", lambda: jax.block_until_ready(own(x, inputs))
    if problem.items <= 8:
        symbols, entries = derivatives.flat(problem)
        other = jax.jit(sp.lambdify(symbols, list(entries), modules="jax", cse=True))
        arrays = [jax.numpy.asarray(column) for column in columns]
        yield "jax_lambdify", lambda: jax.block_until_ready(other(*arrays))


def print_table(model: str, found: Mapping[str, Mapping[str, float]]) -> None:
    """The figures of one model, ns per epoch, with the ratio of the route to ``lambdify``."""
    print(f"\n{model}")
    for epochs, times in found.items():
        cells = "  ".join(f"{name} {ns:.0f}" for name, ns in times.items())
        print(f"  {epochs:>6}: {cells}")
        for own in ("numpy", "numpy_assume"):
            dense, flat = (times[own] / times[f"lambdify_{name}"] for name in ("dense", "flat"))
            print(f"          {own} over dense {dense:.2f}, over flat {flat:.2f}")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
