"""Epochs side by side in blocks, batches that share threads, and the straight ways of batches."""

from __future__ import annotations

import gc
import itertools
import os
import subprocess
import sys
import threading
import time
import weakref
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from symnav import ir
from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend, called

ENTRIES = (ir.Role.MEASUREMENT, ir.Role.CORRECTION)
FUNCTIONS = {function.name: function for function in modules.module().functions}
SINGLE = [name for name, one in FUNCTIONS.items() if one.maximum is None and one.role in ENTRIES]


@pytest.fixture(params=["native", "numpy", "casadi"])
def functions(package: ModuleType, request: pytest.FixtureRequest) -> ModuleType:
    """Each back end in turn."""
    return backend(package, request.param)


@pytest.fixture
def threaded(package: ModuleType) -> Iterator[ModuleType]:
    """The compiled back end with two threads."""
    native = backend(package, "native")
    native.set_threads(2)
    yield native
    native.set_threads(1)


def blocked(form: Any, given: dict[str, Any]) -> dict[str, Any]:
    """Arguments of many epochs as blocks."""
    return {name: form.to_lanes(array) for name, array in given.items()}


@pytest.mark.parametrize("epochs", [1, 32, 45])
@pytest.mark.parametrize("name", SINGLE)
def test_blocks_are_the_rows(
    functions: ModuleType, rng: np.random.Generator, name: str, epochs: int
) -> None:
    """Values and non-zeros of every epoch; what fails is NaN."""
    form = getattr(functions, name)
    given = {
        key: np.asarray(value)
        for key, value in packages.arguments(FUNCTIONS[name], rng, epochs).items()
    }
    if "x" in given and epochs > 3:
        given["x"][3, 0] = np.nan
    rows = called(form, given)
    found = called(form.blocks, blocked(form, given), epochs=epochs)
    assert_array_equal(found.status, rows.status)
    jacobians = [o.name for o in FUNCTIONS[name].outputs if o.name.startswith("jacobian")]
    sparse = called(form.nonzeros, given) if jacobians else ()
    sparse = sparse if isinstance(sparse, tuple) else (sparse,)
    expected = dict(zip(jacobians, sparse, strict=True))
    for output, array in found.outputs.items():
        row = expected.get(output, getattr(rows, output))
        assert_array_equal(form.from_lanes(array, epochs), row.reshape(epochs, -1))
        assert np.isnan(form.from_lanes(array)[epochs:]).all()


def test_lanes_and_back(functions: ModuleType, rng: np.random.Generator) -> None:
    """Element k of epoch e stands in its lane; lanes to spare repeat the last epoch."""
    form = functions.gps
    rows = rng.normal(size=(70, 5))
    blocks = form.to_lanes(rows)
    assert blocks.shape == (-(-70 // form.lanes), 5, form.lanes) and blocks.flags.c_contiguous
    for epoch in (0, 31, 32, 69):
        assert_array_equal(blocks[epoch // form.lanes, :, epoch % form.lanes], rows[epoch])
    assert_array_equal(blocks[-1, :, -1], rows[-1])
    assert_array_equal(form.from_lanes(blocks, 70), rows)
    assert form.to_lanes(np.zeros((0, 5))).shape == (0, 5, form.lanes)
    assert form.to_lanes(np.arange(3)).shape == (1, 1, form.lanes)
    with pytest.raises(ValueError, match="to_lanes: expected"):
        form.to_lanes(np.zeros((2, 2, 2)))
    with pytest.raises(ValueError, match="from_lanes: expected"):
        form.from_lanes(rows)
    with pytest.raises(ValueError, match="epochs = 97, but the blocks hold 96"):
        form.from_lanes(blocks, 97)


def test_given_blocks(functions: ModuleType, rng: np.random.Generator) -> None:
    """Lanes that fail and lanes to spare of given arrays stay as they are."""
    form = functions.gps
    given = packages.arguments(FUNCTIONS["gps"], rng, 40)
    given["x"][7, 0] = np.inf
    blocks = blocked(form, given)
    fresh = called(form.blocks, blocks, epochs=40)
    out = {name: np.full_like(array, 777.0) for name, array in fresh.outputs.items()}
    done = called(form.blocks, blocks, epochs=40, out=out)
    for name, array in out.items():
        assert done.outputs[name] is array
        rows, expected = form.from_lanes(array), form.from_lanes(fresh.outputs[name])
        assert (rows[7] == 777.0).all() and (rows[40:] == 777.0).all()
        assert_array_equal(np.delete(rows[:40], 7, 0), np.delete(expected[:40], 7, 0))


def test_bound_blocks_see_changes(functions: ModuleType, rng: np.random.Generator) -> None:
    """The same arrays every time."""
    form = functions.gps
    blocks = blocked(form, packages.arguments(FUNCTIONS["gps"], rng, 32))
    call = called(form.bind_blocks, blocks)
    first = call().outputs["value"].copy()
    blocks["x"][:, 0] += 1.0
    done = call()
    assert_array_equal(done.outputs["value"][:, 1], first[:, 1])
    assert (done.outputs["value"][:, 0] > first[:, 0]).all()
    with pytest.raises(TypeError, match="bind_blocks: lever_arm must be a contiguous array"):
        called(form.bind_blocks, {**blocks, "lever_arm": blocks["lever_arm"].tolist()})


def test_bound_blocks_begin_with_nothing(functions: ModuleType, rng: np.random.Generator) -> None:
    """New arrays hold NaN until an epoch passes, and what passed after it fails."""
    form = functions.gps
    given = packages.arguments(FUNCTIONS["gps"], rng, 40)
    given["x"][7, 0] = np.inf
    blocks = blocked(form, given)
    call = called(form.bind_blocks, blocks, epochs=40)
    rows = form.from_lanes(call().outputs["value"])
    assert np.isnan(rows[7]).all() and np.isnan(rows[40:]).all()
    assert np.isfinite(np.delete(rows[:40], 7, 0)).all()
    blocks["x"][0, 0, 3] = np.inf
    assert_array_equal(form.from_lanes(call().outputs["value"]), rows)


def test_rows_are_no_view_of_blocks(functions: ModuleType) -> None:
    """Not even those of one element."""
    for elements in (1, 2):
        blocks = np.zeros((2, elements, functions.gps.lanes))
        rows = functions.gps.from_lanes(blocks)
        assert not np.shares_memory(rows, blocks) and rows.flags.writeable


def test_unfit_blocks_are_refused(functions: ModuleType, rng: np.random.Generator) -> None:
    """Shapes, numbers of epochs and arrays to write to."""
    form = functions.gps
    blocks = blocked(form, packages.arguments(FUNCTIONS["gps"], rng, 40))
    wrong = {**blocks, "lever_arm": blocks["lever_arm"][:1].copy()}
    with pytest.raises(ValueError, match=r"lever_arm: expected \(2, 3, 32\); got \(1, 3, 32\)"):
        called(form.blocks, wrong)
    with pytest.raises(ValueError, match=r"x: expected \(blocks, "):
        called(form.blocks, {**blocks, "x": blocks["x"][..., :16].copy()})
    for epochs in (65, -1):
        with pytest.raises(ValueError, match="but the blocks hold 64"):
            called(form.blocks, blocks, epochs=epochs)
    with pytest.raises(TypeError, match="out: expected a dict of arrays for value"):
        called(form.blocks, blocks, out={"value": np.zeros((2, 3, 32))})
    out = called(form.blocks, blocks).outputs
    with pytest.raises(ValueError, match="out: value must be a contiguous float64 array"):
        called(form.blocks, blocks, out={**out, "value": np.zeros((2, 4, 32))})
    with pytest.raises(ValueError, match="an output shares memory with lever_arm"):
        called(form.blocks, blocks, out={**out, "value": blocks["lever_arm"]})


@pytest.mark.parametrize("name", ["gps", "ranges"])
def test_threads_change_no_bit(
    package: ModuleType, rng: np.random.Generator, threaded: ModuleType, name: str
) -> None:
    """Full rows, non-zeros and blocks, bound or not, by two threads as by one."""
    epochs = 1999
    form, given = getattr(threaded, name), packages.arguments(FUNCTIONS[name], rng, epochs)
    given["x"][5::97, 0] = np.nan
    ways: dict[str, Any] = {
        "full": lambda: called(form, given),
        "bound": lambda: called(form.bind, {k: np.asarray(v) for k, v in given.items()})(),
        "nonzeros": lambda: (called(form.nonzeros, given),),
    }
    if name == "gps":
        blocks = blocked(form, given)
        ways["nonzeros"] = lambda: called(form.nonzeros, given)
        ways["blocks"] = lambda: (
            *(done := called(form.blocks, blocks, epochs=epochs)).outputs.values(), done.status
        )  # fmt: skip
    for way in ways.values():
        threaded.set_threads(2)
        shared = way()
        threaded.set_threads(1)
        for one, two in zip(way(), shared, strict=True):
            assert_array_equal(one, two)


def test_threads_share_the_epochs(threaded: ModuleType) -> None:
    """Few epochs stay together; many are shared out without gap or overlap."""
    library = threaded._library
    assert library.shares(1000) == [(0, 1000)]
    assert library.shares(2047) == [(0, 1023), (1023, 1024)]
    assert library.shares(100, 32) == [(0, 50), (50, 50)]
    threaded.set_threads(3)
    assert [count for _, count in library.shares(10_000)] == [3333, 3333, 3334]
    for wrong in (0, -2):
        with pytest.raises(ValueError, match="set_threads: count"):
            threaded.set_threads(wrong)
    with pytest.raises(TypeError):
        threaded.set_threads(1.5)


def test_threads_hold_the_memory_they_use(
    threaded: ModuleType, rng: np.random.Generator, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A caller that is interrupted leaves; its arrays stay until the last thread is done."""
    started: list[Callable[[], Any]] = []

    def interrupted(calls: Sequence[Callable[[], Any]]) -> None:
        started.extend(calls)
        raise KeyboardInterrupt

    monkeypatch.setattr(threaded._library, "run", interrupted)
    given = packages.arguments(FUNCTIONS["gps"], rng, 2000)
    state = weakref.ref(given["x"])
    with pytest.raises(KeyboardInterrupt):
        called(threaded.gps, given)
    del given
    gc.collect()
    assert len(started) == 2 and state() is not None
    assert [call() for call in started] == [0, 0]
    started.clear()
    gc.collect()
    assert state() is None


def test_threads_are_done_when_one_fails(threaded: ModuleType) -> None:
    """Nothing writes to the caller's arrays after the error."""
    done: list[int] = []

    def late() -> None:
        time.sleep(0.2)
        done.append(1)

    def wrong() -> None:
        raise RuntimeError("here")

    with pytest.raises(RuntimeError, match="here"):
        threaded._library.run([wrong, late])
    assert done == [1]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
def test_a_forked_process_has_threads_of_its_own(package: ModuleType) -> None:
    """The child does not wait for threads that stayed behind."""
    code = (
        "import os, signal, threading; import numpy as np; import rover.native as native\n"
        "native.set_threads(2); run = native._library.run\n"
        "together = [threading.Barrier(2).wait] * 2\n"
        "assert sorted(run(together)) == [0, 1]\n"
        "child = os.fork()\n"
        "if not child: signal.alarm(20); os._exit(sorted(run(together)) != [0, 1])\n"
        "assert os.waitpid(child, 0)[1] == 0\n"
        "assert sorted(run(together)) == [0, 1]"
    )
    folder = Path(str(package.__file__)).parent.parent
    command = [sys.executable, "-W", "ignore", "-c", code]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_the_number_of_threads_may_change_at_any_time(
    threaded: ModuleType, rng: np.random.Generator
) -> None:
    """A call that is under way keeps the threads it began with."""
    library, over = threaded._library, threading.Event()

    def change() -> None:
        for number in itertools.cycle((1, 2, 3)):
            threaded.set_threads(number)
            if over.is_set():
                return

    other = threading.Thread(target=change)
    other.start()
    try:
        for _ in range(300):
            assert library.run([lambda: 3, lambda: 4]) == [3, 4]
    finally:
        over.set()
        other.join()


def test_an_error_in_a_thread_is_raised(threaded: ModuleType) -> None:
    """Nothing that goes wrong in a thread is lost."""

    def wrong() -> None:
        raise RuntimeError("here")

    with pytest.raises(RuntimeError, match="here"):
        threaded._library.run([wrong, wrong])


def test_views_and_owners_are_told_apart(package: ModuleType, rng: np.random.Generator) -> None:
    """Rows of one array may be read and written side by side; an overlap is refused."""
    native = backend(package, "native")
    form, given = native.gps, packages.arguments(FUNCTIONS["gps"], rng)
    fresh = called(form, given)
    states = np.stack([given["x"]] * 3)
    history = [np.full((4, *np.shape(array)), 777.0) for array in fresh[:-1]]
    for k in range(3):
        out = tuple(array[k, ...] for array in history)
        result = form(states[k], lever_arm=given["lever_arm"], out=out)
        assert all(a is b for a, b in zip(result, out, strict=False))
    for array, expected in zip(history, fresh, strict=False):
        assert_array_equal(array[:3], np.stack([expected] * 3))
        assert (array[3] == 777.0).all()
    own = [np.zeros(np.shape(array)) for array in fresh[:-1]]
    with pytest.raises(ValueError, match="an output shares memory with lever_arm"):
        form(given["x"], lever_arm=own[0], out=own)
    with pytest.raises(ValueError, match="an output shares memory with lever_arm"):
        form(given["x"], lever_arm=own[0][:], out=own)
    maps = native.retract
    state, written = np.array(given["x"]), np.zeros(given["x"].shape)
    error = np.zeros(modules.module().state.error_size)
    assert maps(state, d=error, out=[written]).value is written
    with pytest.raises(ValueError, match="an output shares memory with x"):
        maps(written[:], d=error, out=[written])
    flat = np.zeros(60)
    flat[:3] = given["lever_arm"]
    with pytest.raises(ValueError, match="an output shares memory with lever_arm"):
        form(given["x"], lever_arm=flat[:3], out=[flat[2:5], *own[1:]])
    own[0].flags.writeable = False
    with pytest.raises(ValueError, match="out: value is read-only"):
        called(form, given, out=own)


@pytest.mark.parametrize("name", ["gps", "ranges"])
def test_batches_that_need_no_detour(
    package: ModuleType, rng: np.random.Generator, name: str
) -> None:
    """Contiguous rows, common arguments and given arrays are the same as spread ones."""
    form = getattr(backend(package, "native"), name)
    given = {k: np.asarray(v) for k, v in packages.arguments(FUNCTIONS[name], rng, 6).items()}
    common = next(key for key in given if key != "x")
    given[common] = np.array(given[common][0])
    spread = {k: (np.stack([v] * 6) if k == common else v) for k, v in given.items()}
    detour = called(form, {k: np.asfortranarray(v)[None] for k, v in spread.items()})
    direct = called(form, given)
    for one, two in zip(direct, detour, strict=True):
        assert_array_equal(one, two[0])
    out = [np.full_like(array, 777.0) for array in direct[: len(FUNCTIONS[name].outputs)]]
    again = called(form, given, out=out)
    assert all(a is b for a, b in zip(again, out, strict=False))
    for one, two in zip(direct, again, strict=True):
        assert_array_equal(one, two)
    memory = max(out, key=np.size).reshape(-1)[: given["x"].size].reshape(given["x"].shape)
    with pytest.raises(ValueError, match="an output shares memory with x"):
        called(form, {**given, "x": memory}, out=out)
