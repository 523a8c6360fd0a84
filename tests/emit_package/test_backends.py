"""The compiled back ends answer as the NumPy back end does, in every form of every function."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend, called

FUNCTIONS = {function.name: function for function in modules.module().functions}
ENTRIES = [name for name in FUNCTIONS if name not in ("retract", "local")]
MAPPED = ["ranges", "strict"]
BATCHES = [*packages.BATCHES, (70,), (0,)]


def assert_same(own: Any, expected: Any, tolerance: float = 1e-13) -> None:
    """Two results or arrays agree, NaN and statuses included."""
    pairs = zip(own, expected, strict=True) if isinstance(own, tuple) else [(own, expected)]
    for left, right in pairs:
        assert np.shape(left) == np.shape(right)
        close = pytest.approx(np.asarray(right), rel=tolerance, abs=tolerance * 10, nan_ok=True)
        assert np.asarray(left) == close


def spoil(given: dict[str, Any], items: bool) -> None:
    """Makes one epoch fail and, where there are items, one item of another."""
    given["x"][(0,) * (given["x"].ndim - 1)][0] = 9e9
    if items:
        given["satellite"][(-1,) * (given["satellite"].ndim - 2)][2] = np.inf


def test_native_is_chosen(package: ModuleType) -> None:
    """The package works with the compiled C once it is there."""
    assert package.BACKEND == "native"
    assert package.gps.__module__.endswith(".native")
    assert package.numpy.gps is not package.gps


@pytest.mark.parametrize("batch", BATCHES, ids=str)
@pytest.mark.parametrize("name", FUNCTIONS)
def test_native_agrees(
    package: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...]
) -> None:
    """All outputs, values alone, Jacobians alone and non-zeros."""
    given = packages.arguments(FUNCTIONS[name], rng, *batch)
    native, vectorised = getattr(package, name), getattr(backend(package, "numpy"), name)
    assert_same(called(native, given), called(vectorised, given))
    for form in ("value", "jacobian", "nonzeros"):
        assert hasattr(native, form) == hasattr(vectorised, form)
        if hasattr(native, form):
            assert_same(
                called(getattr(native, form), given), called(getattr(vectorised, form), given)
            )


@pytest.mark.parametrize("name", ["gps", "frame_map", *MAPPED])
def test_native_agrees_on_failures(
    package: ModuleType, rng: np.random.Generator, name: str
) -> None:
    """The same epochs and items fail, with the same status, and look the same."""
    given = packages.arguments(FUNCTIONS[name], rng, 4)
    spoil(given, name in MAPPED)
    native, vectorised = getattr(package, name), getattr(backend(package, "numpy"), name)
    result, expected = called(native, given), called(vectorised, given)
    assert result.status[0] == package.Status.RANGE
    assert_same(result, expected)
    for form in ("value", "jacobian", "nonzeros"):
        assert_same(called(getattr(native, form), given), called(getattr(vectorised, form), given))


@pytest.mark.parametrize("items", [0, 1, 8])
@pytest.mark.parametrize("batch", [(), (3,)], ids=str)
@pytest.mark.parametrize("name", MAPPED)
def test_any_number_of_items(
    package: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...], items: int
) -> None:
    """Compiled loops over none, one and the most items."""
    given = packages.arguments(FUNCTIONS[name], rng, *batch, items=items)
    for other in ("native", "casadi"):
        form = getattr(backend(package, other), name)
        expected = called(getattr(backend(package, "numpy"), name), given)
        assert_same(called(form, given), expected, 1e-11)


@pytest.mark.parametrize("batch", [(), (3,)], ids=str)
@pytest.mark.parametrize("other", ["native", "casadi"])
@pytest.mark.parametrize("name", ["ranges", "strict"])
def test_differences_agree(
    package: ModuleType, rng: np.random.Generator, name: str, other: str, batch: tuple[int, ...]
) -> None:
    """Differenced rows, also with a bad item and a bad reference, where items are refused too."""
    given = packages.arguments(FUNCTIONS[name], rng, *batch)
    form = getattr(backend(package, other), name).single_difference
    expected = getattr(backend(package, "numpy"), name).single_difference
    for reference in range(5):
        own = called(form, given, reference=reference)
        assert_same(own, called(expected, given, reference=reference), 1e-11)
    if batch:
        status = package.Status
        given["satellite"][1, 3] = np.nan
        given["satellite"][2, 1] = np.nan
        given["satellite"][2, 0] = 1e300
        own = called(form, given, reference=1)
        one_bad = status.PARTIAL if name == "ranges" else status.RANGE
        assert own.status.tolist() == [status.OK, one_bad, status.RANGE]
        assert own.item_status[1].tolist() == [0, 0, 0, status.RANGE, 0]
        assert_same(own, called(expected, given, reference=1), 1e-11)


@pytest.mark.parametrize("batch", [(), (1,), (2, 3)], ids=str)
@pytest.mark.parametrize("name", ENTRIES)
def test_casadi_agrees(
    package: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...]
) -> None:
    """CasADi's own C, called epoch by epoch and item by item."""
    given = packages.arguments(FUNCTIONS[name], rng, *batch)
    own = getattr(backend(package, "casadi"), name)
    expected = getattr(backend(package, "numpy"), name)
    assert_same(called(own, given), called(expected, given), 1e-11)
    if hasattr(own, "nonzeros"):
        assert_same(called(own.nonzeros, given), called(expected.nonzeros, given), 1e-11)


def test_casadi_guards_its_arguments(package: ModuleType, rng: np.random.Generator) -> None:
    """Ranges are checked in Python; what is not finite counts as outside the domain."""
    casadi = backend(package, "casadi")
    given = packages.arguments(FUNCTIONS["gps"], rng, 2)
    given["x"][1, 0] = 9e9
    assert called(casadi.gps, given).status.tolist() == [0, package.Status.RANGE]
    with pytest.raises(package.GuardError, match="DOMAIN"):
        casadi.operations(a=1.0, b=0.0)
    with pytest.raises(TypeError, match="complex"):
        casadi.operations(a=1.0 + 1j, b=0.5)


@pytest.mark.parametrize("batch", [(), (3,)], ids=str)
@pytest.mark.parametrize("name", ["gps", "ranges", "frame_map"])
def test_storage_by_column_shows_nowhere(
    by_column: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...]
) -> None:
    """Python sees the same axes, whatever order the C stores."""
    given = packages.arguments(FUNCTIONS[name], rng, *batch)
    native, vectorised = getattr(by_column, name), getattr(backend(by_column, "numpy"), name)
    expected = called(vectorised, given)
    assert_same(called(native, given), expected)
    assert_same(called(native.jacobian, given), called(vectorised.jacobian, given))
    names = [output.name for output in FUNCTIONS[name].outputs]
    out = {output: np.zeros_like(getattr(expected, output)) for output in names}
    assert_same(called(native, given, out=out), expected)
    assert_same(out["jacobian"], expected.jacobian)


@pytest.mark.parametrize("batch", [(), (3,)], ids=str)
@pytest.mark.parametrize("name", ["gps", "ranges", "frame_map"])
def test_results_by_column_are_written_to_again(
    by_column: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...]
) -> None:
    """A result is fit for ``out``, and a bound call makes its own."""
    given = packages.arguments(FUNCTIONS[name], rng, *batch)
    form = getattr(by_column, name)
    result = called(form, given)
    held = [np.array(array) for array in result]
    again = called(form, given, out=result)
    assert again.jacobian is result.jacobian
    assert_same(tuple(again), tuple(held))
    call = called(form.bind, {key: np.asarray(value) for key, value in given.items()})
    assert_same(tuple(call()), tuple(held))
    jacobian = called(form.nonzeros, given) if not batch else called(form.jacobian, given)
    part = form.nonzeros if not batch else form.jacobian
    assert called(part, given, out=jacobian) is not None


def test_storage_by_column_of_differences(by_column: ModuleType, rng: np.random.Generator) -> None:
    """The differenced form has shorter columns."""
    given = packages.arguments(FUNCTIONS["ranges"], rng)
    own = called(by_column.ranges.single_difference, given, reference=2)
    other = called(backend(by_column, "numpy").ranges.single_difference, given, reference=2)
    assert_same(own, other)


@pytest.mark.parametrize("batch", [(), (3,)], ids=str)
@pytest.mark.parametrize("name", ["gps", "frame_map", "operations"])
def test_single_precision(
    package: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...]
) -> None:
    """The float tree takes and gives float32."""
    given = packages.arguments(FUNCTIONS[name], rng, *batch)
    if name == "operations":
        given = {"a": np.full(batch, 0.75), "b": np.full(batch, -1.5)}
    single = {key: np.asarray(value, dtype=np.float32) for key, value in given.items()}
    result = called(getattr(backend(package, "native_f32"), name), single)
    assert result.value.dtype == np.float32
    assert_same(result, called(getattr(package, name), given), 2e-5)
    with_doubles = called(getattr(backend(package, "native_f32"), name), given)
    assert_same(with_doubles, result)
