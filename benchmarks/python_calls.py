"""Calls from Python: one epoch at a time, and many epochs in one call.

Everything runs in this process, interleaved, over the same inputs. ``python_*`` is one call for
one epoch; ``batch_*`` and ``small_batch_*`` are one call for many or for some, per epoch.
"""

from __future__ import annotations

import importlib
import importlib.util
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp

from benchmarks.contestants import derivatives
from benchmarks.contestants.symnav_code import FUNCTION, specification
from benchmarks.problems import Problem
from benchmarks.quiet import Core
from symnav import pipeline
from symnav.bench.quiet import Burst, Round, medians, quietest

Array = npt.NDArray[np.float64]
Call = Callable[[], Any]

BATCHES = {"batch": 1024, "small_batch": 128}
"""Epochs in one call. What 128 of gps read and write fits the first-level cache."""
REPETITIONS = 13
BURST = 1e-3


def measure(
    problem: Problem, folder: Path, inputs: Array, core: Core, *, native: bool
) -> dict[str, float]:
    """Nanoseconds per evaluation of every way to call, interleaved.

    Args:
        problem: what is evaluated.
        folder: for what is generated.
        inputs: flat records.
        core: what is timed is to have for itself.
        native: build for this very machine, as ``symnav build --native`` does.
    """
    folder.mkdir(parents=True, exist_ok=True)
    package = built(problem, folder, native=native)
    bare = built(problem, folder / "bare", native=native, guarded=False)
    ways: dict[str, tuple[Call, int]] = {}
    for name, call in one_epoch(problem, package, inputs[0], folder):
        ways[f"python_{name}"] = (call, 1)
    for size, epochs in BATCHES.items():
        records = np.tile(inputs, (epochs // len(inputs), 1))
        for name, call in many_epochs(problem, package, records, folder):
            ways[f"{size}_{name}"] = (call, epochs)
        for name, call in compiled_batches(problem, bare, records):
            ways[f"{size}_{name}_unguarded"] = (call, epochs)
    figures = timed(ways, core)
    if problem.name == "gps":
        figures |= streamed(problem, package, inputs, core)
    return figures


def built(problem: Problem, folder: Path, *, native: bool, guarded: bool = True) -> ModuleType:
    """The compiled package of a problem: as it is shipped, or without its guards."""
    spec = specification(problem, folder, guarded=guarded)
    made = pipeline.generate(spec, folder).package
    pipeline.build(made, native=native)
    return pipeline.import_package(made)


def timed(
    ways: Mapping[str, tuple[Call, int]],
    core: Core,
    repetitions: int = REPETITIONS,
    clock: Callable[[], int] = time.perf_counter_ns,
) -> dict[str, float]:
    """Median over rounds, a burst of every way in turn, that had a core to themselves.

    Args:
        ways: by name, what is called and for how many epochs.
        core: what is timed is to have for itself.
        repetitions: rounds.
        clock: in nanoseconds.

    Returns:
        Nanoseconds of one epoch, by name; nothing where there is nothing to time.
    """
    if not ways:
        return {}
    counts = {}
    for name, (call, _) in ways.items():
        call()
        start = time.perf_counter()
        call()
        counts[name] = max(1, int(BURST / (time.perf_counter() - start + 1e-9)))

    def in_turn() -> Iterator[Round]:
        bursts = {}
        for name, (call, epochs) in ways.items():
            before = core.room()
            start = clock()
            for _ in range(counts[name]):
                call()
            taken = (clock() - start) / counts[name] / epochs
            bursts[name] = Burst(taken, min(before, core.room()))
        yield bursts

    rounds, alone = quietest(in_turn, repetitions, core.quiet)
    if not alone:
        print(f"{', '.join(ways)}: the core was shared", file=sys.stderr)
    return medians(rounds)


def arguments(problem: Problem, records: Array) -> tuple[Array, dict[str, Any]]:
    """State and inputs of one record, or of many, as the package takes them."""
    given: dict[str, Any] = {}
    for name, size in problem.inputs:
        start = problem.offsets[name]
        part = records[..., start : start + problem.sizes[name]]
        if name in problem.per_item:
            part = part.reshape(*records.shape[:-1], problem.items, size)
        if name == "dt":
            given[name] = float(part[0]) if part.ndim == 1 else part[..., 0].copy()
        else:
            given[name] = np.ascontiguousarray(part)
    state = sum(size for _, size in problem.state)
    return np.ascontiguousarray(records[..., :state]), given


def results(problem: Problem, epochs: tuple[int, ...]) -> tuple[Array, Array]:
    """Arrays for values and Jacobians."""
    rows = (*epochs, problem.rows)
    return np.empty(rows), np.empty((*rows, problem.columns))


def one_epoch(
    problem: Problem, package: ModuleType, record: Array, folder: Path
) -> Iterator[tuple[str, Call]]:
    """Bound, checked, into given arrays, values alone, by NumPy; and the rivals."""
    function = getattr(package, FUNCTION)
    x, given = arguments(problem, record)
    out = results(problem, ())
    numpy = getattr(package.numpy, FUNCTION)
    yield "bound", function.bind(x, out=out, **given)
    yield "checked", as_written(function, x, given)
    yield "out", as_written(function, x, given, out=out)
    yield "value", as_written(function.value, x, given)
    yield "cffi", by_hand(problem, package, x, given)
    yield "numpy", as_written(numpy, x, given)
    if problem.items <= 8:
        flat = lambdified(problem, "math")
        numbers = [float(element) for element in record]
        yield "lambdify_math", lambda: flat(*numbers)
        compiled = numba_compiled(problem, folder)
        if compiled is not None:
            target = np.empty(problem.rows + len(problem.pattern))
            yield "numba", lambda: compiled(record, target)


def as_written(
    function: Callable[..., Any], x: Array, given: Mapping[str, Any], **more: Any
) -> Call:
    """``function(x, l=l, ...)`` with its keywords ready: unpacking a mapping takes longer."""
    return partial(function, x, **given, **more)


def by_hand(problem: Problem, package: ModuleType, x: Array, given: Mapping[str, Any]) -> Call:
    """The same C through cffi as one writes it by hand: new arrays, nothing looked at."""
    library = package.native._library
    inputs = {name: np.asarray(array) for name, array in given.items()}
    reals = ", ".join(f"pointer(reals, {name})" for name in (*inputs, "value", "jacobian"))
    count, states = "", ""
    if problem.items:
        count = f"{problem.items}, "
        states = f", pointer(bytes, empty({problem.items}, byte))"
    value, jacobian = (array.shape for array in results(problem, ()))
    text = (
        f"def call():\n    value, jacobian = empty({value}), empty({jacobian})\n"
        f"    status = entry(pointer(reals, x), {count}{reals}{states})\n"
        "    return value, jacobian, status\n"
    )
    names: dict[str, Any] = {
        **inputs, "x": x, "entry": library.entry(FUNCTION), "pointer": library.ffi.from_buffer,
        "reals": library.reals, "bytes": library.bytes, "empty": np.empty, "byte": np.uint8,
    }  # fmt: skip
    exec(text, names)
    call: Call = names["call"]
    return call


def many_epochs(
    problem: Problem, package: ModuleType, records: Array, folder: Path
) -> Iterator[tuple[str, Call]]:
    """Compiled and NumPy batches; vectorised lambdify, Numba and JAX."""
    function = getattr(package, FUNCTION)
    x, given = arguments(problem, records)
    yield from compiled_batches(problem, package, records)
    if not problem.items:
        blocked = {name: function.to_lanes(array) for name, array in given.items()}
        yield "native_blocks", function.bind_blocks(function.to_lanes(x), **blocked)
    numpy = getattr(package.numpy, FUNCTION)
    yield "numpy", lambda: numpy(x, **given)
    if problem.items > 8:
        return
    columns = [np.ascontiguousarray(column) for column in records.T]
    flat = lambdified(problem, "numpy")
    yield "lambdify", lambda: flat(*columns)
    yield "lambdify_rows", by_rows(problem, flat, x, given)
    compiled = numba_compiled(problem, folder, many=True)
    if compiled is not None:
        target = np.empty((len(records), problem.rows + len(problem.pattern)))
        yield "numba", lambda: compiled(records, target)
    jitted = jax_compiled(problem, columns)
    if jitted is not None:
        yield "jax", jitted


def compiled_batches(
    problem: Problem, package: ModuleType, records: Array
) -> Iterator[tuple[str, Call]]:
    """Dense and non-zeros, into new arrays, into given ones, and bound."""
    function = getattr(package, FUNCTION)
    x, given = arguments(problem, records)
    out = results(problem, (len(records),))
    yield "native_new", lambda: function(x, **given)
    yield "native", lambda: function(x, out=out, **given)
    yield "native_bound", function.bind(x, out=out, **given)
    yield "native_nz", lambda: function.nonzeros(x, **given)


def by_rows(problem: Problem, flat: Callable[..., Any], x: Array, given: Mapping[str, Any]) -> Call:
    """``lambdify`` from the arrays the package takes to arrays like those it gives.

    It reads columns of row-major arrays where they lie, and stores values and non-zeros by row.
    """
    epochs, values = len(x), problem.rows

    def call() -> tuple[Array, Array]:
        arrays = [array.reshape(epochs, -1) for array in (x, *given.values())]
        found = flat(*(column for array in arrays for column in array.T))
        value = np.empty((epochs, values))
        nonzeros = np.empty((epochs, len(problem.pattern)))
        for k, column in enumerate(found):
            if k < values:
                value[:, k] = column
            else:
                nonzeros[:, k - values] = column
        return value, nonzeros

    return call


def lambdified(problem: Problem, modules: str) -> Callable[..., Any]:
    """SymPy's own, in its fastest form: one flat list, common subexpressions shared."""
    symbols, entries = derivatives.flat(problem)
    return sp.lambdify(symbols, list(entries), modules=modules, cse=True)  # type: ignore[no-any-return]


def imported(name: str, text: str, folder: Path) -> ModuleType:
    """A module written for this run."""
    (folder / f"{name}.py").write_text(text, encoding="utf-8")
    found = importlib.util.spec_from_file_location(name, folder / f"{name}.py")
    assert found is not None and found.loader is not None
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module


def numba_compiled(
    problem: Problem, folder: Path, *, many: bool = False
) -> Callable[..., Any] | None:
    """The same expressions through Numba, where it is installed."""
    try:
        numba = importlib.import_module("numba")
    except ImportError:
        return None
    symbols, entries = derivatives.flat(problem)
    replacements, reduced = sp.cse(entries)
    places = {symbol: sp.Symbol(f"x[{k}]") for k, symbol in enumerate(symbols)}
    printed = sp.printing.pycode
    lines = [f"    {left} = {printed(right.xreplace(places))}" for left, right in replacements]
    lines += [f"    out[{k}] = {printed(e.xreplace(places))}" for k, e in enumerate(reduced)]
    text = "import math\n\n\ndef one(x, out):\n" + "\n".join(lines) + "\n"
    one = numba.njit(imported(f"numba_{problem.name}", text, folder).one)
    if not many:
        return one  # type: ignore[no-any-return]

    def loop(records: Array, out: Array) -> None:
        for k in range(records.shape[0]):
            one(records[k], out[k])

    return numba.njit(loop)  # type: ignore[no-any-return]


def jax_compiled(problem: Problem, columns: Sequence[Array]) -> Call | None:
    """The same expressions jitted by JAX over whole columns, where it is installed."""
    try:
        jax = importlib.import_module("jax")
    except ImportError:
        return None
    jax.config.update("jax_enable_x64", True)
    symbols, entries = derivatives.flat(problem)
    function = jax.jit(sp.lambdify(symbols, list(entries), modules="jax", cse=True))
    arrays = [jax.numpy.asarray(column) for column in columns]

    def call() -> Any:
        return jax.block_until_ready(function(*arrays))

    return call


def streamed(
    problem: Problem, package: ModuleType, inputs: Array, core: Core, epochs: int = 1_000_000
) -> dict[str, float]:
    """A million epochs from row-major arrays against a copy of the same bytes, in the same run."""
    records = np.tile(inputs, (epochs // len(inputs), 1))
    x, given = arguments(problem, records)
    out = results(problem, (len(records),))
    function = getattr(package, FUNCTION)
    length = x.size + sum(np.size(a) for a in given.values()) + sum(a.size for a in out)
    source, target = np.zeros(length // 2), np.zeros(length // 2)
    return timed(
        {
            "stream_native": (lambda: function(x, out=out, **given), len(records)),
            "stream_copy": (lambda: np.copyto(target, source), len(records)),
        },
        core,
    )
