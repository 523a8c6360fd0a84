"""What callers are told when they call a function wrongly, on every back end."""

from __future__ import annotations

import inspect
import pickle
import warnings
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend, called

ARM = np.array([1.0, 2.0, 3.0])


@pytest.fixture(params=["native", "numpy", "casadi"])
def functions(package: ModuleType, request: pytest.FixtureRequest) -> ModuleType:
    """Each back end in turn."""
    return backend(package, request.param)


@pytest.fixture
def x(rng: np.random.Generator) -> Any:
    """A state."""
    return packages.states(rng)


def satellites(rng: np.random.Generator, **changes: Any) -> dict[str, Any]:
    """Arguments of the mapped function, some changed."""
    (ranges,) = (f for f in modules.module().functions if f.name == "ranges")
    return {**packages.arguments(ranges, rng), **changes}


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"arm": ARM}, r"gps\(\) has no argument 'arm'; did you mean 'lever_arm'\?"),
        ({"lever_arm": ARM, "colour": 1}, r"gps\(\) has no argument 'colour'; it takes x, lever"),
        ({}, r"gps\(\) needs lever_arm: expected \(\.\.\., 3\)"),
        ({"lever_arm": "abc"}, "lever_arm: expected real numbers, got <U3"),
        ({"lever_arm": [None, 1, 2]}, "lever_arm: expected real numbers, got object"),
    ],
)
def test_wrong_names_and_types(
    functions: ModuleType, x: Any, given: dict[str, Any], message: str
) -> None:
    """A TypeError that says what was meant."""
    with pytest.raises(TypeError, match=message):
        functions.gps(x, **given)


def test_missing_state(functions: ModuleType, x: Any) -> None:
    """The state comes first and alone."""
    blocks = r"position\[3\] attitude\[4\] bias_gps\[1\] bias_galileo\[1\] ambiguity\[4\]"
    with pytest.raises(TypeError, match=rf"gps\(\) needs x: expected \(\.\.\., 13\) = {blocks}"):
        functions.gps(lever_arm=ARM)
    with pytest.raises(TypeError, match=r"positional|by position"):
        functions.gps(x, ARM)


@pytest.mark.parametrize(
    ("state", "arm", "message"),
    [
        (np.zeros(15), ARM, r"x: expected \(\.\.\., 13\) = position\[3\] .*; got \(15,\)"),
        (np.zeros(()), ARM, r"x: expected .*; got \(\)"),
        (None, np.zeros(2), r"lever_arm: expected \(\.\.\., 3\); got \(2,\)"),
        (None, 1.0, r"lever_arm: expected \(\.\.\., 3\); got \(\)"),
        (
            np.zeros((4, 13)),
            np.zeros((3, 3)),
            r"gps: leading axes do not broadcast: x \(4,\), lever_arm \(3,\)",
        ),
    ],
)
def test_wrong_shapes(functions: ModuleType, x: Any, state: Any, arm: Any, message: str) -> None:
    """A ValueError with the shape that was expected."""
    with pytest.raises(ValueError, match=message):
        functions.gps(x if state is None else state, lever_arm=arm)


def test_wrong_items(functions: ModuleType, rng: np.random.Generator) -> None:
    """Counts that differ, exceed the maximum, or are not there at all."""
    with pytest.raises(ValueError, match=r"system: expected \(\.\.\., n\); got \(4,\), but satel"):
        called(functions.ranges, satellites(rng, system=np.zeros(4, dtype=int)))
    with pytest.raises(ValueError, match=r"satellite: expected \(\.\.\., n, 3\); got \(3,\)"):
        called(functions.ranges, satellites(rng, satellite=ARM))
    many = {
        "satellite": np.full((9, 3), 1e7),
        "system": np.zeros(9, dtype=int),
        "slot": np.zeros(9, dtype=int),
    }
    with pytest.raises(ValueError, match=r"ranges: COUNT: .* has n = 9, the declared maximum is 8"):
        called(functions.ranges, satellites(rng, **many))


def test_indices_are_integers(functions: ModuleType, rng: np.random.Generator) -> None:
    """No rounding, and no wrapping around."""
    with pytest.raises(TypeError, match="slot: expected integers, got float64"):
        called(functions.ranges, satellites(rng, slot=np.ones(5)))
    wrapped = np.array([0, 1, 2, 3, 2**32], dtype=np.int64)
    result = called(functions.ranges, satellites(rng, slot=wrapped))
    assert result.item_status.tolist() == [0, 0, 0, 0, 2]
    assert called(functions.ranges, satellites(rng, slot=[0, 1, 2, 3, 0])).status == 0


def test_reference_in_range(functions: ModuleType, rng: np.random.Generator) -> None:
    """A reference that is no item."""
    for reference in (-1, 5):
        with pytest.raises(ValueError, match=rf"reference = {reference}, but there are 5 items"):
            called(functions.ranges.single_difference, satellites(rng), reference=reference)


def test_numbers_in_any_clothes(functions: ModuleType, x: Any) -> None:
    """Lists, other types, other strides and sub-classes are read as what they mean."""
    expected = functions.gps(x, lever_arm=ARM).value
    wide = np.zeros((3, 2))
    wide[:, 0] = ARM
    backwards = x[::-1].copy()[::-1]
    for own, arm in (
        (x.tolist(), [1, 2, 3]),
        (x, ARM.astype(np.int16)),
        (backwards, wide[:, 0]),
        (x.astype(">f8"), ARM.astype(np.longdouble)),
        (np.ma.masked_array(x), ARM),
    ):
        assert functions.gps(own, lever_arm=arm).value == pytest.approx(expected, rel=1e-15)


def test_masked_elements_are_refused(functions: ModuleType, x: Any) -> None:
    """What stands behind a mask is no data."""
    hidden = np.ma.masked_array(x, mask=np.arange(x.size) == 1)
    with pytest.raises(TypeError, match="x: some elements are masked; fill them"):
        functions.gps(hidden, lever_arm=ARM)
    with pytest.raises(TypeError, match="a: some elements are masked"):
        functions.operations(a=np.ma.masked_array(0.5, mask=True), b=1.0)


def test_ragged_lists_are_named(functions: ModuleType, x: Any) -> None:
    """NumPy does not say which argument it was."""
    with pytest.raises(ValueError, match=r"lever_arm: expected \(\.\.\., 3\); .*inhomogeneous"):
        functions.gps(x, lever_arm=[1.0, [2.0, 3.0]])


def test_the_state_is_given_once(functions: ModuleType, x: Any) -> None:
    """By position, or by name where somebody insists; without a state nothing has a position."""
    expected = functions.gps(x, lever_arm=ARM).value
    assert functions.gps(x=x, lever_arm=ARM).value.tolist() == expected.tolist()
    with pytest.raises(TypeError, match=r"gps\(\) got x both by position and by name"):
        functions.gps(x, x=x + 1.0, lever_arm=ARM)
    with pytest.raises(TypeError, match=r"positional|by position"):
        functions.operations(0.5, b=1.0)


def test_norms_come_after_all_ranges(package: ModuleType, rng: np.random.Generator) -> None:
    """Two arguments fail: the range of the second is looked at before the norm of the first."""
    x = np.array([1.0, 0.0, 0.0, 0.8, 0.0, 0.0, 0.8, *np.zeros(6)])
    d = np.full(modules.ERROR_SIZE, 2e3)
    for name in ("native", "numpy"):
        form = backend(package, name).retract
        assert form(x[None], d=d[None]).status.tolist() == [package.Status.RANGE]
        with pytest.raises(package.GuardError, match=r"retract: RANGE: d\[0\]"):
            form(x, d=d)


def test_single_precision_names_what_failed(package: ModuleType, rng: np.random.Generator) -> None:
    """Where rounding decides about a norm as well; what overflows warns of nothing."""
    form = backend(package, "native_f32").gps
    refused = 0
    for x in packages.states(rng, 300):
        x[3:7] *= np.sqrt(1.0 + 1e-6 * rng.uniform(0.8, 1.0))
        try:
            form(x, lever_arm=ARM)
        except package.GuardError as error:
            refused += 1
            assert error.argument == "x" and error.index == (3,)
            assert "x[3:7] (attitude) is not a unit quaternion" in str(error)
    assert refused > 0
    x[0] = 1e300
    with warnings.catch_warnings(), pytest.raises(package.GuardError, match=r"x\[0\] .* = inf"):
        warnings.simplefilter("error")
        form(x, lever_arm=ARM)


def test_more_items_than_memory_holds(package: ModuleType, rng: np.random.Generator) -> None:
    """The number of items is the error, not the arrays made for their results."""
    items = 2**40
    wide = {
        name: np.broadcast_to(np.asarray(value)[0], (items, *np.shape(value)[1:]))
        for name, value in satellites(rng).items()
        if name in ("satellite", "system", "slot")
    }
    with pytest.raises(package.GuardError, match=f"ranges: COUNT: .* has n = {items}"):
        called(backend(package, "native").ranges, satellites(rng, **wide))


def test_scalars(functions: ModuleType) -> None:
    """An input of one element has no axis of its own."""
    expected = functions.operations(a=0.5, b=2.0).value
    for a in (np.float64(0.5), np.array(0.5), np.float32(0.5)):
        assert functions.operations(a=a, b=2).value == pytest.approx(expected, rel=1e-15)
    assert functions.operations(a=[0.5, 0.5], b=2.0).value.shape == (2, len(expected))


@pytest.mark.parametrize(
    ("element", "value", "message"),
    [
        (0, 2e5, r"gps: RANGE: x\[0\] \(position x\) = 200000.0 is outside the declared range "
                 r"\[-100000, 100000\] m$"),
        (7, np.nan, r"gps: RANGE: x\[7\] \(bias_gps\) = nan is outside the declared range"),
        (4, 1.05, r"gps: QNORM: x\[3:7\] \(attitude\) is not a unit quaternion: off by 1\.\d+, "
                  r"the tolerance is 1e-06"),
    ],
)  # fmt: skip
def test_guard_names_the_element(
    functions: ModuleType, x: Any, element: int, value: float, message: str
) -> None:
    """One epoch that fails says which number was wrong and what was declared."""
    x[3:7] = (0.0, 0.0, 0.0, 1.0)
    x[element] = value
    with pytest.raises(ValueError, match=message):
        functions.gps(x, lever_arm=ARM)


def test_guard_error_carries_what_it_says(package: ModuleType, x: Any) -> None:
    """For programs that want to react."""
    with pytest.raises(package.GuardError) as caught:
        package.gps(x, lever_arm=(1.0, -11.0, 0.0))
    error = caught.value
    assert error.status == package.Status.RANGE
    assert (error.argument, error.index, error.value) == ("lever_arm", (1,), -11.0)
    assert error.bounds == (-10.0, 10.0)
    assert "lever_arm[1] (y) = -11.0" in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), vars(again)) == (str(error), vars(error))


def test_guard_names_items_scalars_and_conditions(
    package: ModuleType, rng: np.random.Generator
) -> None:
    """A row of an item, an input without an axis, a matrix, an intermediate value."""
    given = satellites(rng, slot=[0, 1, 7, 3, 2])
    with pytest.raises(package.GuardError, match=r"strict: RANGE: slot\[2\] = 7 is outside"):
        called(package.strict, given)
    with pytest.raises(package.GuardError, match=r"operations: RANGE: a = 10.0 is outside .* m$"):
        package.operations(a=10.0, b=1.0)
    turn = np.eye(3)
    turn[0, 1] = 0.1
    with pytest.raises(package.GuardError, match=r"QNORM: turn\[0:9\] is not a rotation mat"):
        package.frame_map(given["x"], turn=turn.reshape(9))
    with pytest.raises(
        package.GuardError,
        match=r"gps: DOMAIN: squared length of the lever arm must lie in \[1e-06, inf\]",
    ):
        package.gps(given["x"], lever_arm=np.zeros(3))


def test_complex_numbers_go_to_numpy(package: ModuleType, x: Any) -> None:
    """Compiled code says where complex steps work."""
    with pytest.raises(TypeError, match=r"lever_arm: .*complex128; use the numpy back end"):
        package.gps(x, lever_arm=ARM + 1j)


def test_signatures_are_readable(functions: ModuleType) -> None:
    """Interactive help shows names, not machinery."""
    assert str(inspect.signature(functions.gps)) == "(x, /, *, lever_arm, out=None)"
    assert functions.gps.__name__ == "gps"
    assert "reference" in inspect.signature(functions.ranges.single_difference).parameters
    text = inspect.getdoc(functions.gps) or ""
    assert "lever_arm : array_like, shape (..., 3)" in text
    assert "m, frame b, range [-10, 10]; elements x y z" in text


def test_functions_can_be_pickled(package: ModuleType, functions: ModuleType) -> None:
    """They are found again by the name of their module, and so are their forms."""
    forms = [functions.gps, *vars(functions.gps).values(), *vars(functions.ranges).values()]
    for form in filter(callable, forms):
        assert pickle.loads(pickle.dumps(form)) is form
