"""Straight ways from NumPy's arrays into compiled C: what they take and what they decline."""

from __future__ import annotations

import gc
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from symnav import build
from symnav.emit import c
from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend, called

FUNCTIONS = {function.name: function for function in modules.module().functions}
UNFIT = -1
Change = Callable[[list[Any]], None]


class Marked(np.ndarray[Any, Any]):
    """A subclass, whose elements may mean something else."""


def epoch(rng: np.random.Generator, *batch: int) -> list[Any]:
    """Arguments of gps and arrays for its results: state, arm, value, length, Jacobians."""
    given = packages.arguments(FUNCTIONS["gps"], rng, *batch)
    outputs = [np.full((*batch, *output.shape), 777.0) for output in FUNCTIONS["gps"].outputs]
    return [given["x"], given["lever_arm"], *outputs]


def entered(way: Callable[..., int], arrays: list[Any], *more: int) -> int:
    """What a straight way for many epochs answers."""
    given = (np.ndarray, *arrays)
    return way(id(given), *more)


def once(library: Any, name: str, arrays: list[Any]) -> int:
    """The status of a bound call, or that it takes the general way."""
    call = library.bound(name, arrays, 0, int)
    return UNFIT if call is None else int(call())


def test_arrays_are_taken_as_they_are(package: ModuleType, rng: np.random.Generator) -> None:
    """One epoch, and some of many."""
    native = backend(package, "native")
    arrays = epoch(rng)
    assert once(native._library, "gps", arrays) == 0
    fresh = backend(package, "numpy").gps(arrays[0], lever_arm=arrays[1])
    for array, expected in zip(arrays[2:], fresh, strict=False):
        assert array == pytest.approx(expected, rel=1e-13)
    many = [*epoch(rng, 6), np.full(6, 99, np.uint8)]
    assert entered(native._library.straight("gps_batch"), many, 2, 3) == 0
    assert many[-1].tolist() == [99, 99, 0, 0, 0, 99]
    fresh = backend(package, "numpy").gps(many[0], lever_arm=many[1])
    assert many[4][2:5] == pytest.approx(fresh.jacobian[2:5], rel=1e-13)
    assert (many[4][[0, 1, 5]] == 777.0).all()


def misaligned(array: Any) -> Any:
    """The same numbers, one byte off."""
    memory = np.zeros(array.nbytes + 1, np.uint8)
    moved = memory[1:].view(array.dtype).reshape(array.shape)
    moved[...] = array
    return moved


def put(place: int, change: Callable[[Any], Any]) -> Change:
    """Replaces one of the arrays."""

    def changed(arrays: list[Any]) -> None:
        arrays[place] = change(arrays[place])

    return changed


def locked(array: Any) -> Any:
    """Read-only."""
    array.flags.writeable = False
    return array


UNFITTING: dict[str, Change] = {
    "list": put(1, lambda a: a.tolist()),
    "none": put(1, lambda a: None),
    "number": put(1, lambda a: 1.0),
    "subclass": put(1, lambda a: a.view(Marked)),
    "single": put(1, lambda a: a.astype(np.float32)),
    "integers": put(1, lambda a: a.astype(np.int64)),
    "other byte order": put(1, lambda a: a.astype(a.dtype.newbyteorder())),
    "every second": put(1, lambda a: np.repeat(a, 2)[::2]),
    "misaligned": put(1, misaligned),
    "shorter": put(1, lambda a: a[:2]),
    "longer": put(0, lambda a: np.append(a, 0.0)),
    "an axis more": put(1, lambda a: a[None]),
    "an axis less": put(4, lambda a: a.reshape(-1)),
    "by column": put(4, np.asfortranarray),
    "turned": put(4, lambda a: np.zeros(a.shape[::-1]).T),
    "read-only": put(2, locked),
    "misaligned output": put(2, misaligned),
}


@pytest.mark.parametrize("change", UNFITTING)
def test_what_does_not_fit_is_declined(
    package: ModuleType, rng: np.random.Generator, change: str
) -> None:
    """Type, kind, shape and memory; nothing is written then."""
    arrays = epoch(rng)
    UNFITTING[change](arrays)
    held = [np.array(array) for array in arrays[2:]]
    library = backend(package, "native")._library
    assert once(library, "gps", arrays) == UNFIT
    call = library.call("gps", tuple)
    assert call(*arrays[:2], arrays[2:]) is None
    for array, before in zip(arrays[2:], held, strict=True):
        assert_array_equal(array, before)


def test_overlap_is_declined_and_neighbours_are_not(
    package: ModuleType, rng: np.random.Generator
) -> None:
    """To the byte: from the first element of one to the last of the other."""
    library = backend(package, "native")._library
    fresh = epoch(rng)
    for start, answer in ((0, UNFIT), (2, UNFIT), (3, 0), (4, UNFIT), (5, UNFIT), (6, 0)):
        memory = np.zeros(9)
        arrays = list(fresh)
        arrays[1] = memory[:3] if start < 4 else memory[3:6]
        arrays[1][...] = fresh[1]
        arrays[2] = memory[start : start + 3]
        assert once(library, "gps", arrays) == answer, start
    memory = np.zeros(39)
    pair = [*fresh[:2], memory[:3], fresh[3], memory[3:39].reshape(3, 12), fresh[5]]
    assert once(library, "gps", pair) == 0
    pair[4] = memory[2:38].reshape(3, 12)
    assert once(library, "gps", pair) == UNFIT


def test_read_only_inputs_are_taken(package: ModuleType, rng: np.random.Generator) -> None:
    """What is read need not be writable."""
    arrays = epoch(rng)
    locked(arrays[0])
    assert once(backend(package, "native")._library, "gps", arrays) == 0


def test_epochs_that_do_not_fit_are_declined(package: ModuleType, rng: np.random.Generator) -> None:
    """As many of everything that is not shared; none behind the last; all outputs of their own."""
    way = backend(package, "native")._library.straight("gps_batch")
    status = np.zeros(4, np.uint8)
    for first, count, answer in ((0, 4, 0), (3, 1, 0), (4, 0, 0), (0, 5, UNFIT), (3, 2, UNFIT),
                                 (-1, 2, UNFIT), (2, -1, UNFIT)):  # fmt: skip
        assert entered(way, [*epoch(rng, 4), status], first, count) == answer
    shared = [*epoch(rng, 4), status]
    shared[1] = shared[1][0].copy()
    assert entered(way, shared, 0, 4) == 0
    for place in range(6):
        arrays = [*epoch(rng, 4), status]
        arrays[place] = np.array(arrays[place][:3])
        assert entered(way, arrays, 0, 3) == UNFIT, place
    for place in range(2, 7):
        arrays = [*epoch(rng, 4), status]
        arrays[place] = np.array(arrays[place][0])
        assert entered(way, arrays, 0, 4) == UNFIT, place


def test_items_are_counted(package: ModuleType, rng: np.random.Generator) -> None:
    """All arrays of items have the same number of them; more than the most have a status."""
    library = backend(package, "native")._library

    def made(items: int) -> list[Any]:
        given = packages.arguments(FUNCTIONS["ranges"], rng, items=items)
        values = [np.zeros(items), np.zeros(()), np.zeros((items, 12)), np.zeros(items, np.uint8)]
        return [*given.values(), *values]

    assert once(library, "ranges", made(5)) == 0
    assert once(library, "ranges", made(0)) == 0
    assert once(library, "ranges", made(9)) == package.Status.COUNT
    for place in (2, 3, 4, 5, 7, 8):
        arrays = made(5)
        arrays[place] = np.array(arrays[place][:4])
        assert once(library, "ranges", arrays) == UNFIT, place


def test_numbers_are_taken(package: ModuleType) -> None:
    """Floats of Python and NumPy, and arrays without axes; integers take the general way."""
    native = backend(package, "native")
    outputs = [np.zeros(output.shape) for output in FUNCTIONS["operations"].outputs]
    numbers: list[Any] = [0.5, np.float64(0.5), np.array(0.5)]
    for number in numbers:
        assert once(native._library, "operations", [number, 1.5, *outputs]) == 0
        assert outputs[0][0] == 2.0
    others: list[Any] = [1, True, np.float32(0.5), "0.5", 0.5j]
    for number in others:
        assert once(native._library, "operations", [number, 1.5, *outputs]) == UNFIT
    assert native.operations(a=1, b=1.5).value[0] == 2.5
    single = backend(package, "native_f32")._library
    narrow = [array.astype(np.float32) for array in outputs]
    assert once(single, "operations", [0.1, 1.5, *narrow]) == 0
    assert narrow[0][0] == np.float32(0.1) + np.float32(1.5)


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """A package whose extension has no straight ways, as where NumPy has no headers."""
    module = modules.module(modules.gps(), modules.choice(), name="small")
    folder = tmp_path_factory.mktemp("without") / "small"
    text = {**packages.text_of(module), **c.emit(module)}
    package = packages.write(text, folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(np, "get_include", lambda: str(folder))
        build.build(package)
    return packages.load(package)


def test_nothing_depends_on_straight_ways(
    package: ModuleType, small: ModuleType, rng: np.random.Generator
) -> None:
    """The general way gives the same bits, writes to given arrays and refuses the same."""
    assert small.BACKEND == "native"
    assert not hasattr(backend(small, "native")._library.lib, "straight_small__open")
    for batch in ((), (5,)):
        arrays = epoch(rng, *batch)
        own = small.gps(arrays[0], lever_arm=arrays[1])
        for one, other in zip(own, package.gps(arrays[0], lever_arm=arrays[1]), strict=True):
            assert_array_equal(one, other)
        small.gps(arrays[0], lever_arm=arrays[1], out=arrays[2:])
        assert_array_equal(arrays[4], own.jacobian)
        with pytest.raises(ValueError, match="shares memory"):
            small.gps(arrays[0], lever_arm=arrays[2], out=arrays[2:])


def test_a_build_with_headers_is_another(small: ModuleType, tmp_path: Path) -> None:
    """An extension without straight ways is not taken for one that has them."""
    module = modules.module(modules.gps(), modules.choice(), name="small")
    made = packages.write({**packages.text_of(module), **c.emit(module)}, tmp_path / "small")
    build.build(made)
    native = backend(packages.load(made), "native")
    assert native._library.lib.straight_small__layout() == int(np.__version__.split(".")[0])
    assert native._module.__name__ != backend(small, "native")._module.__name__
    value = np.zeros(1)
    x = packages.states(np.random.default_rng(2))
    for number, answer in ((0, 0), (1, 0), (2, 2), (2**31, UNFIT), (2**70, UNFIT), (0.0, UNFIT)):
        assert once(native._library, "choice", [x, number, value]) == answer
    for number in (0, 1):
        assert once(native._library, "choice", [x, number, value]) == 0
        assert value[0] == x[number]
        assert native.choice(x, k=np.int64(number)).value[0] == x[number]


def test_functions_may_be_called_like_parts_of_the_extension(tmp_path: Path) -> None:
    """What the extension has of its own, no function of a specification can be called."""
    names = ("layout", "open", "call", "bind", "value")
    made = modules.module(*(replace(modules.choice(), name=name) for name in names), name="small")
    folder = packages.write({**packages.text_of(made), **c.emit(made)}, tmp_path / "small")
    build.build(folder)
    native = backend(packages.load(folder), "native")
    x = packages.states(np.random.default_rng(2))
    for name in names:
        function = getattr(native, name)
        assert function(x, k=1).value[0] == function.value(x, k=1)[0] == x[1]
        assert function.bind(x, k=1)().value[0] == x[1]


def test_an_index_may_be_a_number(tmp_path: Path) -> None:
    """Of Python or NumPy; bound, or where results are written to given arrays."""
    made = modules.module(modules.choice(), name="small")
    folder = packages.write({**packages.text_of(made), **c.emit(made)}, tmp_path / "small")
    build.build(folder)
    x, package = packages.states(np.random.default_rng(2)), packages.load(folder)
    numbers: list[Any] = [1, np.int64(1), np.array(1), np.uint8(1)]
    for choice in (backend(package, name).choice for name in ("native", "numpy")):
        for number in numbers:
            for given in (x, x.tolist()):
                out = np.zeros(1)
                assert choice(given, k=number, out=[out]).value is out and out[0] == x[1]
        assert choice.bind(x, k=1)().value[0] == x[1]


def test_bound_calls_outlive_their_arguments(
    package: ModuleType, small: ModuleType, rng: np.random.Generator
) -> None:
    """With and without straight ways; an array that is reshaped in place is read as it lies."""
    for chosen in (package, small):
        x, arm, *out = epoch(rng)
        expected = chosen.gps(x, lever_arm=arm)
        call = chosen.gps.bind(x, lever_arm=arm, out=out)
        del out
        gc.collect()
        assert_array_equal(call().jacobian, expected.jacobian)
        arm += 1.0
        arm.shape = (3, 1)
        expected = chosen.gps(x, lever_arm=arm[:, 0])
        assert_array_equal(call().jacobian, expected.jacobian)
        x[0] = np.nan
        with pytest.raises(chosen.GuardError, match="x"):
            call()


@pytest.mark.parametrize("other", ["3.0.1", "1.26.4"])
def test_other_arrays_than_those_compiled_for(
    package: ModuleType, rng: np.random.Generator, monkeypatch: pytest.MonkeyPatch, other: str
) -> None:
    """With another generation of NumPy, or another Python, every straight way declines."""
    native = backend(package, "native")
    extension = backend(package, "_extension")
    arrays = epoch(rng)
    monkeypatch.setattr(np, "__version__", other)
    library = extension.Library(native._module, "rover", "float64")
    assert once(library, "gps", arrays) == UNFIT
    monkeypatch.undo()
    monkeypatch.setattr(extension.sys.implementation, "name", "pypy")
    library = extension.Library(native._module, "rover", "float64")
    assert once(library, "gps", arrays) == UNFIT
    monkeypatch.undo()
    monkeypatch.setattr(extension.sys, "_is_gil_enabled", lambda: False, raising=False)
    library = extension.Library(native._module, "rover", "float64")
    assert once(library, "gps", arrays) == UNFIT
    monkeypatch.undo()
    library = extension.Library(native._module, "rover", "float64")
    assert once(library, "gps", arrays) == 0


def test_results_of_a_given_array(package: ModuleType, rng: np.random.Generator) -> None:
    """A function with one output takes it as it is."""
    native = backend(package, "native")
    given = packages.arguments(FUNCTIONS["retract"], rng)
    out = np.zeros(modules.SIZE)
    result = called(native.retract, given, out=out)
    assert result.value is out
    assert_array_equal(out, called(native.retract, given).value)
    with pytest.raises(ValueError, match="out: value must be float64 of shape"):
        called(native.retract, given, out=out[None])
