"""Writing into given arrays, bound calls, and tables of non-zeros."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend, called

FUNCTIONS = {function.name: function for function in modules.module().functions}


@pytest.fixture(params=["native", "numpy", "casadi"])
def functions(package: ModuleType, request: pytest.FixtureRequest) -> ModuleType:
    """Each back end in turn."""
    return backend(package, request.param)


def shifted(array: Any) -> Any:
    """The same numbers one byte off, as in packed records."""
    moved = np.zeros(array.nbytes + 1, np.uint8)[1:].view(array.dtype).reshape(array.shape)
    moved[...] = array
    return moved


def empty(name: str, batch: tuple[int, ...], items: int | None = None) -> dict[str, Any]:
    """Arrays for every output, filled with a number no function gives."""
    made = {}
    for output in FUNCTIONS[name].outputs:
        own = (*batch, *([items] if output.item and items is not None else []), *output.shape)
        made[output.name] = np.full(own, 777.0)
    return made


@pytest.mark.parametrize("batch", [(), (3,), (2, 2)], ids=str)
@pytest.mark.parametrize("kind", ["dict", "tuple", "result"])
def test_given_arrays_are_filled(
    functions: ModuleType, rng: np.random.Generator, batch: tuple[int, ...], kind: str
) -> None:
    """By name, by order, or the result of an earlier call."""
    given = packages.arguments(FUNCTIONS["gps"], rng, *batch)
    fresh = called(functions.gps, given)
    arrays = empty("gps", batch)
    out = {
        "dict": arrays,
        "tuple": tuple(arrays.values()),
        "result": type(fresh)(*arrays.values(), None),
    }[kind]
    result = called(functions.gps, given, out=out)
    for name, array in arrays.items():
        assert getattr(result, name) is array
        assert array == pytest.approx(getattr(fresh, name), rel=1e-15)


def test_parts_fill_given_arrays(functions: ModuleType, rng: np.random.Generator) -> None:
    """Values, Jacobians and non-zeros alone."""
    given = packages.arguments(FUNCTIONS["frame_map"], rng, 2)
    for form, shape in (("value", (2, 3)), ("jacobian", (2, 3, 12)), ("nonzeros", (2, 9))):
        call = getattr(functions.frame_map, form)
        out = np.full(shape, 777.0)
        assert called(call, given, out=out) is out
        assert out == pytest.approx(called(call, given), rel=1e-15)


@pytest.mark.parametrize("batch", [(), (3,), (2, 2)], ids=str)
@pytest.mark.parametrize("order", ["as given", "by row"])
def test_nonzeros_of_items_fill_what_an_earlier_call_gave(
    functions: ModuleType, rng: np.random.Generator, batch: tuple[int, ...], order: str
) -> None:
    """Compiled code leaves them in columns; rows do as well."""
    call = functions.ranges.nonzeros
    earlier, given = (packages.arguments(FUNCTIONS["ranges"], rng, *batch) for _ in range(2))
    out = called(call, earlier)
    if order == "by row":
        out = np.ascontiguousarray(out)
    assert called(call, given, out=out) is out
    assert out == pytest.approx(called(call, given), rel=1e-13)


def test_failed_items_of_given_nonzeros(functions: ModuleType, rng: np.random.Generator) -> None:
    """Zeros for an item that fails, nothing for an epoch that does."""
    given = packages.arguments(FUNCTIONS["ranges"], rng, 3)
    out = called(functions.ranges.nonzeros, given)
    out[...] = 777.0
    given["satellite"][0, 3] = np.inf
    given["x"][1, 0] = np.nan
    called(functions.ranges.nonzeros, given, out=out)
    assert (out[0, 3] == 0.0).all() and (out[1] == 777.0).all()
    assert (out[2] != 777.0).all() and (np.delete(out[0], 3, axis=0) != 777.0).all()


def test_failed_epochs_leave_given_arrays_alone(
    functions: ModuleType, rng: np.random.Generator
) -> None:
    """Rows that fail keep what was there; new arrays hold NaN there."""
    given = packages.arguments(FUNCTIONS["gps"], rng, 3)
    given["x"][1, 0] = np.nan
    arrays = empty("gps", (3,))
    result = called(functions.gps, given, out=arrays)
    assert result.status.tolist() == [0, 2, 0]
    fresh = called(functions.gps, given)
    for name, array in arrays.items():
        assert (array[1] == 777.0).all()
        assert np.isnan(getattr(fresh, name)[1]).all()
        assert array[::2] == pytest.approx(getattr(fresh, name)[::2], rel=1e-15)
    out = np.full((3, 12), 777.0), np.full((3, 9), 777.0)
    called(functions.gps.nonzeros, given, out=out)
    assert [(part[1] == 777.0).all() for part in out] == [True, True]


def test_failed_call_leaves_given_arrays_alone(
    package: ModuleType, functions: ModuleType, rng: np.random.Generator
) -> None:
    """One epoch raises and writes nothing."""
    given = packages.arguments(FUNCTIONS["gps"], rng)
    given["lever_arm"] = np.zeros(3)
    if functions.__name__.endswith("casadi"):
        given["lever_arm"] = np.full(3, np.nan)
    arrays = empty("gps", ())
    with pytest.raises(package.GuardError):
        called(functions.gps, given, out=arrays)
    assert all((array == 777.0).all() for array in arrays.values())


def test_bad_items_write_zero_rows(functions: ModuleType, rng: np.random.Generator) -> None:
    """An epoch that passes in part is written whole."""
    given = packages.arguments(FUNCTIONS["ranges"], rng, 2)
    given["satellite"][1, 3] = np.inf
    arrays = empty("ranges", (2,), 5)
    result = called(functions.ranges, given, out=arrays)
    assert result.status.tolist() == [0, 7]
    assert arrays["value"][1, 3] == 0.0
    assert (arrays["jacobian"][1, 3] == 0.0).all()
    assert (arrays["jacobian"] != 777.0).all()


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"value": None}, TypeError, "out: gps also writes value"),
        ({"valu": np.zeros(3)}, TypeError, "out has no argument 'valu'; did you mean 'value'"),
        ({"value": [0.0] * 3}, TypeError, "out: value must be a NumPy array, got list"),
        ({"value": np.zeros(4)}, ValueError, r"out: value must be float64 of shape \(3,\); got"),
        ({"value": np.zeros(3, np.float32)}, ValueError, "got float32"),
        ({"value": np.zeros(6)[::2]}, ValueError, "out: value must be contiguous"),
        ({"value": np.broadcast_to(0.0, (3,))}, ValueError, "out: value is read-only"),
        ({"value": shifted(np.zeros(3))}, ValueError, "out: value must be aligned in memory"),
    ],
)
def test_unfit_arrays_are_refused(
    functions: ModuleType,
    rng: np.random.Generator,
    change: dict[str, Any],
    error: type[Exception],
    message: str,
) -> None:
    """Type, shape, strides and names of what is written to."""
    given = packages.arguments(FUNCTIONS["gps"], rng)
    out = {key: value for key, value in {**empty("gps", ()), **change}.items() if value is not None}
    with pytest.raises(error, match=message):
        called(functions.gps, given, out=out)


def test_what_is_no_array_is_refused(functions: ModuleType, rng: np.random.Generator) -> None:
    """A number, for instance."""
    given = packages.arguments(FUNCTIONS["gps"], rng)
    with pytest.raises(TypeError, match=r"out: expected arrays for value, .*; got int"):
        called(functions.gps, given, out=5)


def test_overlap_is_refused(functions: ModuleType, rng: np.random.Generator) -> None:
    """Compiled code assumes that what it writes is not what it reads."""
    given = packages.arguments(FUNCTIONS["gps"], rng)
    arrays = empty("gps", ())
    with pytest.raises(ValueError, match="an output shares memory with x"):
        called(functions.gps, given, out={**arrays, "value": given["x"][:3]})
    with pytest.raises(ValueError, match="an output shares memory with another output"):
        memory = np.zeros(36)
        overlap = {**arrays, "value": memory[:3], "jacobian": memory.reshape(3, 12)}
        called(functions.gps, given, out=overlap)
    with pytest.raises(TypeError, match=r"out: gps writes value, length, jacobian, .*; got 2"):
        called(functions.gps, given, out=(np.zeros(3), np.zeros(())))


@pytest.mark.parametrize("batch", [(), (4,)], ids=str)
@pytest.mark.parametrize("name", ["gps", "ranges"])
def test_bound_calls_see_changes(
    functions: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...]
) -> None:
    """A bound call reads its arrays anew and writes the same arrays each time."""
    form = getattr(functions, name)
    given = packages.arguments(FUNCTIONS[name], rng, *batch)
    given["x"] = np.ascontiguousarray(given["x"])
    call = called(form.bind, {k: np.asarray(v) for k, v in given.items()})
    first = call()
    held = first.value.copy()
    given["x"][..., :3] += 10.0
    second = call()
    assert second.value is first.value
    assert not np.array_equal(second.value, held)
    assert second.value == pytest.approx(called(form, given).value, rel=1e-15)


def test_bound_calls_write_to_given_arrays(
    package: ModuleType, functions: ModuleType, rng: np.random.Generator
) -> None:
    """Outputs may be parts of larger arrays; failures raise as ever."""
    given = packages.arguments(FUNCTIONS["gps"], rng)
    arrays = empty("gps", ())
    stack = np.zeros((9, 12))
    arrays["jacobian"] = stack[3:6]
    call = called(functions.gps.bind, given, out=arrays)
    call()
    assert stack[3:6] == pytest.approx(called(functions.gps, given).jacobian, rel=1e-15)
    given["lever_arm"][2] = 11.0
    with pytest.raises(package.GuardError, match=r"lever_arm\[2\]"):
        call()
    given["lever_arm"][2] = 1.0
    assert call().status == package.Status.OK


@pytest.mark.parametrize("lead", [(), (1, 1), (2, 1), (2, 2)], ids=str)
def test_bound_calls_of_many_epochs(
    package: ModuleType, functions: ModuleType, rng: np.random.Generator, lead: tuple[int, ...]
) -> None:
    """Arguments may be shared or spread; an epoch that fails leaves its rows as they were."""
    given = packages.arguments(FUNCTIONS["gps"], rng, 2, 2)
    given["lever_arm"] = np.ascontiguousarray(np.broadcast_to([0.1, 0.2, 0.3], (*lead, 3)))
    arrays = empty("gps", (2, 2))
    call = called(functions.gps.bind, given, out=arrays)
    first = call()
    held = {name: array.copy() for name, array in arrays.items()}
    assert held["value"] == pytest.approx(called(functions.gps, given).value, rel=1e-15)
    given["x"][0, 1, 0] = np.nan
    given["x"][1, 0, :3] += 1.0
    result = call()
    assert result.status.tolist() == [[0, package.Status.RANGE], [0, 0]]
    assert result.value is first.value
    for name, array in arrays.items():
        assert np.array_equal(array[0, 1], held[name][0, 1])
    assert not np.array_equal(result.value[1, 0], held["value"][1, 0])


def test_bound_calls_report_bad_items(
    package: ModuleType, functions: ModuleType, rng: np.random.Generator
) -> None:
    """A partial epoch is a result, and the next one is whole again."""
    given = packages.arguments(FUNCTIONS["ranges"], rng)
    call = called(functions.ranges.bind, given)
    assert call().status == package.Status.OK
    keep = given["satellite"][1, 1]
    given["satellite"][1, 1] = np.nan
    result = call()
    assert (result.status, result.item_status.tolist()) == (7, [0, 2, 0, 0, 0])
    given["satellite"][1, 1] = keep
    assert call().item_status.tolist() == [0, 0, 0, 0, 0]


def test_only_lasting_arrays_are_bound(functions: ModuleType, rng: np.random.Generator) -> None:
    """What would be copied could not be seen to change."""
    given = packages.arguments(FUNCTIONS["gps"], rng)
    unfit = ([1.0, 2.0, 3.0], np.zeros(3, np.float32), np.zeros(6)[::2], shifted(np.zeros(3)))
    for arm in unfit:
        with pytest.raises(TypeError, match="bind: lever_arm must be a contiguous NumPy array of"):
            functions.gps.bind(given["x"], lever_arm=arm)
    assert functions.operations.bind(a=0.5, b=1.5)().value[0] == 2.0


@pytest.mark.parametrize("batch", [(), (3,), (2, 2)], ids=str)
@pytest.mark.parametrize("single", [False, True])
def test_compiled_code_reads_aligned_memory(
    package: ModuleType,
    rng: np.random.Generator,
    monkeypatch: pytest.MonkeyPatch,
    batch: tuple[int, ...],
    single: bool,
) -> None:
    """Columns of packed records are moved first: C may not look at them where they lie."""
    native = backend(package, "native_f32" if single else "native")
    pointer, seen = native._library.pointer, []

    def watched(array: Any) -> Any:
        seen.append(array.flags.aligned)
        return pointer(array)

    real = native._library.real
    for name in ("gps", "frame_map"):
        form = getattr(native, name)
        monkeypatch.setattr(vars(native)[f"_{name}_function"], "_pointer", watched)
        given = {
            key: np.asarray(value, dtype=real)
            for key, value in packages.arguments(FUNCTIONS[name], rng, *batch).items()
        }
        moved = {key: shifted(value) for key, value in given.items()}
        for own in (form, form.value, form.nonzeros):
            seen.clear()
            found, expected = called(own, moved), called(own, given)
            found, expected = (r if isinstance(r, tuple) else (r,) for r in (found, expected))
            for one, other in zip(found, expected, strict=True):
                assert np.array_equal(one, other)
            assert seen and all(seen)


def test_tables_of_nonzeros(functions: ModuleType, rng: np.random.Generator) -> None:
    """Rows and columns put the non-zeros back where they belong."""
    given = packages.arguments(FUNCTIONS["gps"], rng, 2)
    dense = np.zeros((2, 3, 12))
    nonzeros = called(functions.gps.nonzeros, given)[0]
    dense[:, functions.gps.jacobian_rows, functions.gps.jacobian_columns] = nonzeros
    assert dense == pytest.approx(called(functions.gps, given).jacobian, rel=1e-15)
    with pytest.raises(ValueError, match="read-only"):
        functions.gps.jacobian_rows[0] = 1


def test_tables_of_moving_nonzeros(functions: ModuleType, rng: np.random.Generator) -> None:
    """A non-zero in the column of a slot is listed at index zero."""
    given = packages.arguments(FUNCTIONS["ranges"], rng)
    columns = np.tile(functions.ranges.jacobian_columns, (5, 1))
    assert columns[0].tolist() == [0, 1, 2, 6, 7, 8]
    columns[:, 5] += given["slot"]
    dense = np.zeros((5, 12))
    dense[np.arange(5)[:, None], columns] = called(functions.ranges.nonzeros, given)
    assert dense == pytest.approx(called(functions.ranges, given).jacobian, rel=1e-15)
