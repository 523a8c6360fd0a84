"""One epoch with Python's numbers: when it is taken, what it gives, when the arrays take over."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from symnav import ir
from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend, called
from tests.emit_numpy.records import add, argument, call, domain, function, mul, number, output, ref

Op = ir.Operation


def plain_ranges() -> ir.Function:
    """Ranges without run-time places, which need arrays."""
    original = modules.ranges("plain")
    outputs = tuple(
        replace(o, entries=tuple(e for e in o.entries if all(isinstance(i, int) for i in e.index)))
        for o in original.outputs
    )
    return replace(original, outputs=outputs, maximum=200, single_difference=False)


def wide() -> ir.Function:
    """A Jacobian of mostly zeros, and one of nothing else."""
    first = ir.Load("a", 0)
    return function(
        "wide",
        (argument(domain("a", 3, (-1e9, 1e9))),),
        (
            output("value", (1,), [((0,), mul(first, ir.Load("a", 2)))]),
            output("jacobian", (2, 300), [((0, 3), ir.Load("a", 2)), ((1, 299), first)]),
            output("jacobian_a", (2, 5), []),
        ),
    )


def pair() -> ir.Function:
    """Two indices in one argument."""
    own = domain("k", 2, (0.0, 3.0), kind=ir.Kind.INTEGER, unit="1")
    total = add(ir.Load("k", 0), ir.Load("k", 1))
    return function("pair", (argument(own),), (output("value", (1,), [((0,), total)]),))


def divided() -> ir.Function:
    """What Python's numbers refuse: a division by zero, a root, a logarithm, an overflow."""
    a = ir.Load("a", 0)
    values: list[ir.Expression] = [
        call(Op.DIV, number(1.0), a),
        call(Op.SQRT, a),
        call(Op.LOG, a),
        call(Op.EXP, mul(a, number(1e3))),
        call(Op.ASIN, mul(a, number(3.0))),
        call(Op.SELECT, call(Op.LT, a, number(0.0)), call(Op.SQRT, call(Op.NEG, a)), a),
        add(call(Op.MIN, a, call(Op.MUL, a, a)), call(Op.MAX, a, call(Op.MUL, a, a))),
    ]
    return function(
        "divided",
        (argument(domain("a", 1, (-9.0, 9.0))),),
        (output("value", (len(values),), [((i,), v) for i, v in enumerate(values)]),),
    )


def known(value: float) -> ir.Function:
    """A condition on a number that depends on no argument."""
    checked = ir.Check("checked", number(value), 1.0, 2.0, 1.5, ir.Status.DOMAIN, "known")
    return function(
        "within" if 1.0 <= value <= 2.0 else "outside",
        (argument(domain("a", 1, (-9.0, 9.0))),),
        (output("value", (1,), [((0,), mul(ir.Load("a", 0), ref("checked")))]),),
        shared=[checked],
    )


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """A package of the functions above, and some that need arrays."""
    functions = (
        modules.gps(), modules.ranges(), modules.frame_map(), modules.operations(), plain_ranges(),
        wide(), divided(), known(1.25), known(3.0), modules.choice(), pair(),
        modules.unguarded(replace(divided(), name="free")),
    )  # fmt: skip
    module = modules.module(*functions)
    folder = tmp_path_factory.mktemp("numbers") / "small"
    return packages.load(packages.write(packages.text_of(module), folder))


@pytest.fixture
def alone(small: ModuleType, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The same without arrays."""

    def refuse(*_arguments: Any, **_more: Any) -> None:
        raise AssertionError("arrays were asked")

    monkeypatch.setattr(backend(small, "_blocks").Plan, "run", refuse)
    return small


FUNCTIONS = {f.name: f for f in (modules.gps(), modules.frame_map(), modules.operations(), wide())}


def by_arrays(form: Callable[..., Any], given: dict[str, Any]) -> Any:
    """One epoch as a batch of one."""
    return called(form, {name: np.asarray(value)[None] for name, value in given.items()})


def assert_same(one: Any, many: Any) -> None:
    """An epoch and a batch of one agree, in type and shape as well."""
    assert type(one) is type(many)
    for own, other in zip(one, many, strict=True):
        own = np.asarray(own)
        assert own.shape == other.shape[1:]
        assert own == pytest.approx(other[0], rel=1e-14, abs=1e-300)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_ordinary_arguments_need_no_arrays(
    alone: ModuleType, rng: np.random.Generator, name: str
) -> None:
    """Arrays of doubles in, arrays of doubles out."""
    given = packages.arguments(FUNCTIONS[name], rng)
    result = called(getattr(alone, name), given)
    assert result.status is alone.Status.OK
    for array in result[:-1]:
        assert isinstance(array, np.ndarray) and array.dtype == np.float64
        assert array.flags.c_contiguous and array.flags.writeable


@pytest.mark.parametrize("name", FUNCTIONS)
def test_agrees_with_arrays(small: ModuleType, rng: np.random.Generator, name: str) -> None:
    """The same numbers to the last places."""
    for _ in range(5):
        given = packages.arguments(FUNCTIONS[name], rng)
        assert_same(called(getattr(small, name), given), by_arrays(getattr(small, name), given))


@pytest.mark.parametrize("items", [1, 5, 64])
def test_items_need_no_arrays(alone: ModuleType, rng: np.random.Generator, items: int) -> None:
    """The part of an item runs item by item."""
    given = packages.arguments(plain_ranges(), rng, items=items)
    result = called(alone.plain, given)
    assert result.status is alone.Status.OK
    assert result.item_status.tolist() == [0] * items
    assert result.item_status.dtype == np.uint8
    assert result.jacobian.shape == (items, modules.ERROR_SIZE)


@pytest.mark.parametrize("items", [0, 1, 5, 64, 65, 200])
def test_items_agree_with_arrays(small: ModuleType, rng: np.random.Generator, items: int) -> None:
    """Few items and many."""
    given = packages.arguments(plain_ranges(), rng, items=items)
    assert_same(called(small.plain, given), by_arrays(small.plain, given))


def test_failed_items_are_left_to_arrays(small: ModuleType, rng: np.random.Generator) -> None:
    """A bad element, a bad distance, an index out of range: that row is zero."""
    given = packages.arguments(plain_ranges(), rng)
    for name, place, value in (
        ("satellite", (3, 1), np.nan),
        ("satellite", (0, 0), -np.inf),
        ("satellite", (2, 2), 2e8),
        ("slot", (4,), 7),
        ("slot", (1,), -1),
    ):
        changed = {key: np.array(array) for key, array in given.items()}
        changed[name][place] = value
        result = called(small.plain, changed)
        assert result.status == ir.Status.PARTIAL
        assert np.flatnonzero(result.item_status).tolist() == [place[0]]
        assert not result.jacobian[place[0]].any() and np.isfinite(result.value).all()
    changed = {key: np.array(array) for key, array in given.items()}
    changed["height"] = np.array(0.0)
    changed["satellite"][2] = changed["x"][:3]
    assert called(small.plain, changed).item_status.tolist() == [0, 0, ir.Status.DOMAIN, 0, 0]


def test_indices_are_integers_for_one_epoch(small: ModuleType, rng: np.random.Generator) -> None:
    """A half is no index, and neither is a truth value, one by one or in arrays."""
    given = packages.arguments(plain_ranges(), rng)
    for index in (np.zeros(5), np.full(5, 0.5), np.zeros(5, bool)):
        for name in ("system", "slot"):
            with pytest.raises(TypeError, match=f"{name}: expected integers, got {index.dtype}"):
                called(small.plain, {**given, name: index})
    x = packages.states(rng)
    assert small.choice(x, k=1).value[0] == small.choice(x, k=np.uint8(1)).value[0] == x[1]
    for wrong in (True, 1.0, np.float64(1.0), np.array(1.0), np.ma.masked_array(1.0)):
        with pytest.raises(TypeError, match="k: expected integers"):
            small.choice(x, k=wrong)


def test_pairs_of_indices_are_integers(small: ModuleType) -> None:
    """Arrays of doubles are no indices, whole or not."""
    assert small.pair(k=np.array([1, 2])).value[0] == small.pair(k=[1, 2]).value[0] == 3.0
    with pytest.raises(TypeError, match="k: expected integers, got float64"):
        small.pair(k=np.array([0.5, 1.0]))


def test_only_the_state_has_a_position(small: ModuleType) -> None:
    """Also where the first argument could be taken for one."""
    with pytest.raises(TypeError, match="takes nothing by position"):
        small.operations(0.5, b=1.0)
    with pytest.raises(TypeError, match="takes nothing by position"):
        small.wide(np.zeros(3))


@pytest.mark.parametrize(
    ("element", "value", "status"),
    [(0, 2e5, 2), (1, np.nan, 2), (7, np.inf, 2), (2, -np.inf, 2), (4, 1.05, 4), (3, 1.01, 4)],
)
def test_failures_raise_as_ever(
    small: ModuleType, rng: np.random.Generator, element: int, value: float, status: int
) -> None:
    """Ranges, what is not finite, norms."""
    x = packages.states(rng)
    x[3:7] = (0.0, 0.0, 0.0, 1.0) if element != 3 else (1.0, 0.0, 0.0, 0.0)
    x[element] = value
    with pytest.raises(small.GuardError) as caught:
        small.gps(x, lever_arm=np.array([1.0, 2.0, 3.0]))
    assert caught.value.status == status


def test_other_failures_raise_as_ever(small: ModuleType, rng: np.random.Generator) -> None:
    """A condition inside the kernel, a matrix that turns nothing, a scalar, more items than fit."""
    x = packages.states(rng)
    with pytest.raises(small.GuardError, match="DOMAIN"):
        small.gps(x, lever_arm=np.zeros(3))
    turn = np.eye(3)
    turn[2, 0] = 1e-5
    with pytest.raises(small.GuardError, match="QNORM"):
        small.frame_map(x, turn=turn.reshape(9))
    for bad in (10.0, np.nan, -np.inf):
        with pytest.raises(small.GuardError, match="RANGE: a"):
            small.operations(a=bad, b=1.0)
    given = packages.arguments(plain_ranges(), rng, items=201)
    with pytest.raises(small.GuardError, match="COUNT"):
        called(small.plain, given)
    given = {**packages.arguments(plain_ranges(), rng), "slot": np.zeros(4, dtype=np.int32)}
    with pytest.raises(ValueError, match=r"slot: expected \(\.\.\., n\); got \(4,\)"):
        called(small.plain, given)


@pytest.mark.parametrize("value", [0.0, -0.5, 0.9, 5.0, -0.0])
def test_what_python_refuses(small: ModuleType, value: float) -> None:
    """Infinities and NaN come out of the arrays, and raise nothing."""
    expected = small.divided(a=np.array([value])).value[0]
    assert np.array_equal(small.divided(a=value).value, expected, equal_nan=True)
    assert np.array_equal(small.free(a=value).value, expected, equal_nan=True)


def test_conditions_on_known_numbers(small: ModuleType) -> None:
    """They pass or fail for one epoch and for many."""
    assert small.within(a=2.0).value == small.within(a=np.array([2.0])).value[0] == 2.5
    assert small.outside(a=np.array([2.0, 3.0])).status.tolist() == [ir.Status.DOMAIN] * 2
    with pytest.raises(small.GuardError, match="known must lie in"):
        small.outside(a=2.0)


def test_without_guards_anything_passes(small: ModuleType) -> None:
    """NaN and infinities go through."""
    for value in (math.nan, math.inf, 1e300):
        found, expected = small.free(a=value), small.free(a=np.array([value]))
        assert found.status == ir.Status.OK
        assert np.array_equal(found.value, expected.value[0], equal_nan=True)


def test_unusual_arguments_are_left_to_arrays(small: ModuleType, rng: np.random.Generator) -> None:
    """Lists, other types and strides, complex numbers, arrays that are written to."""
    x, arm = packages.states(rng), np.array([1.0, 2.0, 3.0])
    expected = small.gps(x, lever_arm=arm)
    strided = np.repeat(x, 2)[::2]
    for own, other in ((x.tolist(), arm), (x, [1, 2, 3]), (strided, arm.astype(np.int8)),
                       (x.astype(">f8"), arm), (x.view(np.ma.MaskedArray), arm)):  # fmt: skip
        result = small.gps(own, lever_arm=other)
        assert result.jacobian == pytest.approx(expected.jacobian, rel=1e-14)
    stepped = small.gps(x, lever_arm=arm + 1e-40j)
    assert stepped.value.dtype == np.complex128 and np.imag(stepped.value).any()
    out = tuple(np.full_like(array, 7.0) for array in expected[:-1])
    assert small.gps(x, lever_arm=arm, out=out).value is out[0]
    assert small.operations(a=1, b=True).value == pytest.approx(
        small.operations(a=1.0, b=1.0).value
    )
    with pytest.raises(TypeError, match="did you mean 'lever_arm'"):
        small.gps(x, leverarm=arm)
    with pytest.raises(TypeError, match="needs lever_arm"):
        small.gps(x)
    with pytest.raises(TypeError, match="by position"):
        small.gps(x, arm)


def test_functions_of_numbers(small: ModuleType, rng: np.random.Generator) -> None:
    """Every function a kernel may call gives what NumPy's gives, NaN included."""
    numbers = backend(small, "_numbers").Numbers
    samples = [*rng.uniform(-3.0, 3.0, size=20).tolist(), 0.0, 1.0, math.nan]
    names = {name for name in vars(numbers) if not name.startswith("_")}
    pairs = {"atan2", "minimum", "maximum", "less", "less_equal", "equal", "not_equal"}
    logical = {"logical_and", "logical_or", "logical_not", "where"}
    assert logical | pairs <= names
    with np.errstate(all="ignore"):
        for name in sorted(names - logical):
            columns = [samples, samples[::-1]] if name in pairs else [samples]
            for operands in zip(*columns, strict=True):
                try:
                    own = getattr(numbers, name)(*operands)
                except ValueError:
                    continue
                expected = getattr(np, name)(*operands)
                assert own == pytest.approx(expected, rel=1e-15, nan_ok=True), (name, operands)
    for left in (True, False):
        assert numbers.logical_not(left) is not left
        assert numbers.where(left, 1.0, 2.0) == (1.0 if left else 2.0)
        for right in (True, False):
            assert numbers.logical_and(left, right) is (left and right)
            assert numbers.logical_or(left, right) is (left or right)


def test_shipped_packages_agree(
    generated: Callable[[str], ModuleType], rng: np.random.Generator
) -> None:
    """The kernels of a real package: an attitude, satellites of two systems, increments."""
    package = generated("rover")
    x = np.array(package.State.initial)
    assert_same(package.numpy.gps(x), package.numpy.gps(x[None]))
    items = 9
    given = {
        "nav_to_ecef": np.array([1.0, 0.0, 0.0, 0.0]),
        "origin": np.array([6378137.0, 0.0, 0.0]),
        "system": np.array([0, 1] * 4 + [0], dtype=np.int32),
        "satellite_position": rng.uniform(1.0e7, 2.0e7, size=(items, 3)),
        "satellite_clock": rng.uniform(-1e-4, 1e-4, size=items),
        "troposphere": rng.uniform(0.0, 5.0, size=items),
        "ionosphere": rng.uniform(0.0, 5.0, size=items),
        "measured": rng.uniform(1.0e7, 2.0e7, size=items),
    }
    one = package.numpy.range(x, **given)
    assert one.status == package.Status.OK
    many = package.numpy.range(x[None], **{name: value[None] for name, value in given.items()})
    assert_same(one, many)
    for place in range(items):
        changed = {**given, "troposphere": given["troposphere"].copy()}
        changed["troposphere"][place] = np.nan
        bad = package.numpy.range(x, **changed)
        assert np.flatnonzero(bad.item_status).tolist() == [place]
        assert bad.value[place] == 0.0


def test_kernels_are_written_once(tmp_path: Path) -> None:
    """Numbers, blocks and other libraries run the same text."""
    text = packages.text_of(modules.module(plain_ranges()))["numpy.py"]
    assert text.count("xp.sqrt(") == 1
    assert "    def item(satellite: Any, system: Any, slot: Any)" in text
