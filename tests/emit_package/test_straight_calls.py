"""Calls for one epoch that C takes from Python: what they make, give back and leave behind."""

from __future__ import annotations

import inspect
import sys
import tracemalloc
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from symnav import build
from symnav.emit import c
from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend, called
from tests.emit_package.test_straight import FUNCTIONS, epoch


def test_calls_make_what_they_are_not_given(package: ModuleType, rng: np.random.Generator) -> None:
    """Arrays of the shapes of one epoch, or those that `out` holds, in a result of its own type."""
    native = backend(package, "native")
    kind = type(native.gps(*epoch(rng)[:1], lever_arm=epoch(rng)[1]))
    call = native._library.call("gps", kind)
    x, arm, *out = epoch(rng)
    fresh, expected = call(x, arm, None), backend(package, "numpy").gps(x, lever_arm=arm)
    assert type(fresh) is kind and fresh.status is package.Status.OK
    for array, other in zip(fresh[:-1], expected[:-1], strict=True):
        assert type(array) is np.ndarray and array.dtype == other.dtype
        assert array.shape == other.shape
        assert array.flags.c_contiguous and array.flags.owndata and array.flags.writeable
        assert array == pytest.approx(other, rel=1e-13)
    holders: list[Any] = [out, tuple(out), (*out, None), kind(*out, None)]
    for holder in holders:
        for array in out:
            array.fill(777.0)
        filled = call(x, arm, holder)
        for given, array, other in zip(out, filled, fresh, strict=False):
            assert array is given
            assert_array_equal(array, other)
    alone = epoch(rng)[2]
    others: list[Any] = [out[:-1], [*out, None, None], iter(out), out[0], {}, "four", 4, b"four"]
    for holder in [*others, [*out[:-1], None], [*out[:-1], alone[:2]]]:
        assert call(x, arm, holder) is None
    for given in ((), (x,), (x, arm), (x, arm, None, None)):
        assert call(*given) is None


def grown(call: Callable[[], Any], times: int = 200) -> int:
    """Bytes that calls leave behind; an array has a hundred, its memory apart."""
    tracemalloc.start()
    try:
        call()
        before, _ = tracemalloc.get_traced_memory()
        for _ in range(times):
            call()
        return tracemalloc.get_traced_memory()[0] - before
    finally:
        tracemalloc.stop()


def test_calls_keep_count_of_what_they_hold(package: ModuleType, rng: np.random.Generator) -> None:
    """Whatever becomes of a call, every object has as many owners afterwards as before."""
    native = backend(package, "native")
    kind = type(called(native.ranges, packages.arguments(FUNCTIONS["ranges"], rng)))
    call = native._library.call("ranges", kind)
    given = list(packages.arguments(FUNCTIONS["ranges"], rng, items=5).values())
    out: list[Any] = [np.zeros(5), np.zeros(()), np.zeros((5, 12))]
    failing = [given[0] * np.nan, *given[1:]]
    bound = native._library.bound("ranges", [*given, *out, np.zeros(5, np.uint8)], out, int)
    held = [*given, *out, out, package.Status.OK, kind]
    before = [sys.getrefcount(one) for one in held]
    for _ in range(100):
        assert call(*given, None) is not None
        assert call(*given, out) is not None
        assert call(*given, [*out[:2], None]) is None
        assert call(*failing, None) is None
        assert call(*failing, out) is None
        assert bound() is out
    assert [sys.getrefcount(one) for one in held] == before
    found = call(*given, None)
    assert [np.shape(one) for one in found] == [(5,), (), (5, 12), (), (5,)]
    assert found[3] is package.Status.OK and found[4].dtype == np.uint8
    assert grown(lambda: (call(*given, None), call(*failing, None), call(*failing, out))) < 4000


FORMS = ["gps.value", "gps.jacobian", "gps.nonzeros", "ranges.value", "ranges.jacobian",
         "ranges.nonzeros", "retract.value", "operations.value"]  # fmt: skip


@pytest.mark.parametrize("form", FORMS)
def test_parts_go_straight_and_give_the_same(
    package: ModuleType, rng: np.random.Generator, form: str
) -> None:
    """As the general way does: arrays alone or in a tuple, given ones too, and nothing kept."""
    native = backend(package, "native")
    name, _, part = form.partition(".")
    public = getattr(getattr(native, name), part)
    given = packages.arguments(FUNCTIONS[name], rng)
    as_lists = {key: array.tolist() for key, array in given.items()}
    expected = called(public, as_lists)
    found = called(public, given)
    assert type(found) is type(expected)
    arrays, others = ((f,) if isinstance(f, np.ndarray) else f for f in (found, expected))
    for array, other in zip(arrays, others, strict=True):
        assert_array_equal(array, other)
        assert array.flags.c_contiguous and array.dtype == np.float64
    out = [np.full(array.shape, 777.0) for array in arrays]
    held = [*given.values(), *out]
    before = [sys.getrefcount(one) for one in held]
    for _ in range(10):
        written = called(public, given, out=out)
        for array, one in zip(out, [written] if len(out) == 1 else written, strict=True):
            assert one is array
        del written, one, array
        called(public, given)
    for array, other in zip(out, others, strict=True):
        assert_array_equal(array, other)
    del array
    assert [sys.getrefcount(one) for one in held] == before
    straight = native._library.call(form if name in ("gps", "ranges") else name)
    if form != "ranges.nonzeros":  # columns as long as the most items
        assert straight(*given.values(), None) is not None
        assert straight(*given.values(), out) is not None
        assert grown(lambda: straight(*given.values(), None)) < 4000
        assert grown(lambda: straight(*given.values(), out)) < 4000
        assert straight(*given.values(), [*out, None]) is None
        assert straight(*given.values(), [*out, None, None]) is None


def test_parts_refuse_as_ever(package: ModuleType, rng: np.random.Generator) -> None:
    """What fails has the same message; what is missing or unknown, too."""
    gps = backend(package, "native").gps
    x, arm, *_ = epoch(rng)
    for part in (gps.value, gps.jacobian, gps.nonzeros):
        with pytest.raises(package.GuardError, match="lever_arm"):
            part(x, lever_arm=np.array([np.nan, 0.0, 0.0]))
        with pytest.raises(TypeError, match="lever_arm"):
            part(x)
        with pytest.raises(TypeError, match="arm"):
            part(x, arm=arm)
        with pytest.raises(TypeError, match="position"):
            part(x, arm, lever_arm=arm)


class Odd(list[Any]):
    """What it holds is not what one finds in it."""

    def __iter__(self) -> Iterator[Any]:
        """Nothing of what it holds."""
        return iter(())


@pytest.mark.parametrize("given", [(), ("x", "arm"), ("x", "arm", "arm")])
def test_every_back_end_says_what_goes_by_name(
    package: ModuleType, rng: np.random.Generator, given: tuple[str, ...]
) -> None:
    """Arguments by position that go by name, and none at all: refused in the same words."""
    x, arm, *_ = epoch(rng)
    state = [x if name == "x" else arm for name in given]
    said = set()
    for name in ("numpy", "native"):
        inputs = {} if len(given) > 1 else {"lever_arm": arm}
        with pytest.raises(TypeError, match=r"^gps\(\) (takes|needs) x") as refused:
            backend(package, name).gps(*state, **inputs)
        said.add(str(refused.value))
    assert len(said) == 1


def test_lists_that_are_none(package: ModuleType, rng: np.random.Generator) -> None:
    """What Python would iterate over counts, not what is stored."""
    native = backend(package, "native")
    x, arm, *out = epoch(rng)
    assert native._library.call("gps", type(native.gps(x, lever_arm=arm)))(x, arm, Odd(out)) is None
    with pytest.raises(TypeError, match="got 0 arrays"):
        native.gps(x, lever_arm=arm, out=Odd(out))


def test_items_that_fail_are_told_in_the_result(
    package: ModuleType, rng: np.random.Generator
) -> None:
    """Some of them: the result says so, as the general way does; the parts come all the same."""
    native = backend(package, "native")
    given = packages.arguments(FUNCTIONS["ranges"], rng, items=5)
    given["satellite"] = given["satellite"].copy()
    given["satellite"][3] = np.nan
    kind = type(called(native.ranges, given))
    found = native._library.call("ranges", kind)(*given.values(), None)
    assert found.status is package.Status.PARTIAL and found.item_status.tolist() == [0, 0, 0, 2, 0]
    expected = called(native.ranges, {name: one.tolist() for name, one in given.items()})
    for array, other in zip(found, expected, strict=True):
        assert_array_equal(array, other)
    value = native._library.call("ranges.value")(*given.values(), None)
    assert_array_equal(value[0], expected[0])


def test_single_differences_go_straight_and_give_the_same(
    package: ModuleType, rng: np.random.Generator
) -> None:
    """As the general way does, whatever the reference and the items; given arrays, too."""
    native = backend(package, "native")
    difference = native.ranges.single_difference
    call = native._library.call("ranges.single_difference", tuple)
    for items, bad in ((1, None), (2, None), (5, None), (5, 3)):
        given = packages.arguments(FUNCTIONS["ranges"], rng, items=items)
        given["satellite"] = given["satellite"].copy()
        if bad is not None:
            given["satellite"][bad] = np.nan
        x, *others = given.values()
        as_lists = {name: one.tolist() for name, one in given.items()}
        for reference in {*range(items)} - {bad}:
            assert call(x, reference, *others, None) is not None
            expected = called(difference, as_lists, reference=reference)
            found = called(difference, given, reference=reference)
            assert type(found) is type(expected) and found.status is expected.status
            out = [np.full(np.shape(one), 777.0) for one in expected[:-2]]
            written = called(difference, given, reference=reference, out=out)
            assert all(one is array for one, array in zip(written, out, strict=False))
            for one, other, third in zip(found, expected, written, strict=True):
                assert_array_equal(one, other)
                assert_array_equal(third, other)
            assert grown(partial(called, difference, given, reference=reference)) < 4000
            fewer = [one[:-1] if one.ndim else one for one in out]
            assert items == 1 or call(x, reference, *others, fewer) is None
        wrong: list[Any] = [-1, items, bad, 0.0, True, "0", None, 2**40]
        for reference in wrong:
            assert call(x, reference, *others, None) is None
        with pytest.raises(package.GuardError, match="INDEX"):
            called(difference, given, reference=items)
        with pytest.raises(TypeError, match="reference is the index of an item"):
            called(difference, given, reference=0.0)
        assert called(difference, given, reference=np.int64(0)).status is not None
    with pytest.raises(TypeError):
        difference(x, reference=0)


def test_results_and_calls_are_what_python_expects(
    package: ModuleType, rng: np.random.Generator
) -> None:
    """A result of arrays has no hash; a bound call has a signature and takes nothing."""
    native = backend(package, "native")
    x, arm, *_ = epoch(rng)
    with pytest.raises(TypeError, match="unhashable"):
        hash(native.gps(x, lever_arm=arm))
    bound = native.gps.bind(x, lever_arm=arm)
    assert not inspect.signature(bound).parameters and "arrays" in bound.__doc__
    with pytest.raises(TypeError, match="no arguments"):
        bound(x)


@pytest.mark.parametrize("what", ["resized", "retyped", "locked"])
def test_arrays_that_are_no_longer_what_they_were(
    package: ModuleType, rng: np.random.Generator, what: str
) -> None:
    """A bound call does not write to memory that is gone, nor read bits as other numbers."""
    x, arm, *out = epoch(rng)
    bound = backend(package, "native").gps.bind(x, lever_arm=arm, out=out)
    bound()
    if what == "resized":
        out[2].resize((3, 5000), refcheck=False)
    elif what == "retyped":
        arm.dtype = np.dtype(np.int64)
    else:
        out[0].flags.writeable = False
    with pytest.raises(ValueError, match="an array was resized, retyped or locked since bind"):
        bound()


def test_many_items_let_others_run(tmp_path: Path, rng: np.random.Generator) -> None:
    """More items than are worth it to hold the interpreter for, by several threads at once."""
    ranges = replace(modules.ranges(), maximum=3000)
    made = modules.module(ranges, name="many")
    packages.write({**packages.text_of(made), **c.emit(made)}, tmp_path / "many")
    build.build(tmp_path / "many")
    many = packages.load(tmp_path / "many")
    given = [packages.arguments(ranges, rng, items=n) for n in (256, 257, 3000)]
    expected = [called(backend(many, "numpy").ranges, one) for one in given]
    bound = called(many.ranges.bind, given[-1])
    with ThreadPoolExecutor(4) as pool:
        for place, found in enumerate(
            pool.map(lambda k: called(many.ranges, given[k % 3]), range(300))
        ):
            assert_allclose(found.jacobian, expected[place % 3].jacobian, rtol=1e-12)
        assert all(pool.map(lambda _: bound() is bound(), range(100)))
