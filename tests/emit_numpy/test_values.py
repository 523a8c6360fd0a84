"""What the kernels compute, against a plain interpreter of the same records."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from symnav import ir
from tests.emit_numpy import interpreter, modules, packages

FUNCTIONS = {function.name: function for function in modules.module().functions}
MAPPED = {"ranges", "strict"}


def epoch_of(
    function: ir.Function, given: dict[str, Any], epoch: tuple[int, ...]
) -> dict[str, Any]:
    """The arguments of one epoch."""
    return {argument.name: given[argument.name][epoch] for argument in function.arguments}


def assert_agrees(function: ir.Function, result: Any, given: dict[str, Any]) -> None:
    """Every epoch of a result is what the interpreter gives."""
    batch = np.shape(given[function.arguments[0].name])
    batch = batch[: len(batch) - (function.arguments[0].size > 1)]
    for epoch in np.ndindex(batch):
        answer = interpreter.evaluate(function, epoch_of(function, given, epoch))
        assert np.asarray(result.status)[epoch] == answer.status
        good = answer.status in (ir.Status.OK, ir.Status.PARTIAL)
        for name, expected in answer.outputs.items():
            own = np.asarray(getattr(result, name))[epoch]
            if good:
                assert own == pytest.approx(expected, rel=1e-13, abs=1e-12), (name, epoch)
            else:
                assert np.isnan(own).all(), (name, epoch)
        if function.maximum is not None and good:
            assert result.item_status[epoch].tolist() == answer.item_status


@pytest.mark.parametrize("batch", packages.BATCHES, ids=str)
@pytest.mark.parametrize("name", FUNCTIONS)
def test_agrees_with_the_interpreter(
    package: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...]
) -> None:
    """Values, Jacobians and statuses of every function over leading axes."""
    function = FUNCTIONS[name]
    given = packages.arguments(function, rng, *batch)
    result = packages.called(getattr(package, name), given)
    assert_agrees(function, result, given)


@pytest.mark.parametrize("items", [0, 1, 8])
@pytest.mark.parametrize("name", sorted(MAPPED))
def test_any_number_of_items(
    package: ModuleType, rng: np.random.Generator, name: str, items: int
) -> None:
    """None, one, and as many as declared."""
    function = FUNCTIONS[name]
    given = packages.arguments(function, rng, 2, items=items)
    result = packages.called(getattr(package, name), given)
    assert result.value.shape == (2, items)
    assert result.jacobian.shape == (2, items, modules.ERROR_SIZE)
    assert_agrees(function, result, given)


def test_shapes_broadcast(package: ModuleType, rng: np.random.Generator) -> None:
    """Leading axes of arguments broadcast as NumPy's do."""
    x, arm = packages.states(rng, 4, 1), rng.uniform(-5.0, 5.0, size=(3, 3))
    result = package.gps(x, lever_arm=arm)
    assert result.value.shape == (4, 3, 3)
    assert result.status.shape == (4, 3)
    for i, j in np.ndindex(4, 3):
        one = package.gps(x[i, 0], lever_arm=arm[j])
        assert result.value[i, j] == pytest.approx(one.value, rel=1e-15)
        assert result.jacobian[i, j] == pytest.approx(one.jacobian, rel=1e-15)


def test_shared_arguments_broadcast_against_items(
    package: ModuleType, rng: np.random.Generator
) -> None:
    """One set of satellites serves many states."""
    function = FUNCTIONS["ranges"]
    given = packages.arguments(function, rng)
    given["x"] = packages.states(rng, 6)
    result = packages.called(package.ranges, given)
    assert result.value.shape == (6, 5)
    assert result.top.shape == (6,)
    one = packages.called(package.ranges, {**given, "x": given["x"][4]})
    assert result.jacobian[4] == pytest.approx(one.jacobian, rel=1e-15)


def bad_elements(function: ir.Function) -> list[tuple[str, int, float]]:
    """For every element of every argument, values that its guard refuses."""
    found = []
    for argument in function.arguments:
        for domain in argument.domains:
            for offset in range(domain.size):
                values = [domain.upper[offset] * 1.5 + 1.0]
                values += [] if argument.integer else [np.nan, np.inf, -np.inf]
                found += [(argument.name, domain.start + offset, value) for value in values]
    return found


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_guard_acts(package: ModuleType, rng: np.random.Generator, name: str) -> None:
    """One bad element in one epoch of many fails that epoch (or item) and no other."""
    function = FUNCTIONS[name]
    for argument, element, value in bad_elements(function):
        given = packages.arguments(function, rng, 3)
        array = given[argument].astype(np.int64 if given[argument].dtype.kind == "i" else float)
        last = array.reshape((*array.shape, 1)) if own_size(function, argument) == 1 else array
        place = (1, 2, element) if is_item(function, argument) else (1, element)
        last[place] = value
        given[argument] = array
        result = packages.called(getattr(package, name), given)
        assert_agrees(function, result, given)
        assert result.status[1] != 0
        assert result.status[0] == result.status[2] == 0


def own_size(function: ir.Function, name: str) -> int:
    """Elements of an argument."""
    return next(a.size for a in function.arguments if a.name == name)


def is_item(function: ir.Function, name: str) -> bool:
    """True for an argument with a row for each item."""
    return next(a.item for a in function.arguments if a.name == name)


@pytest.mark.parametrize(
    ("name", "change", "status"),
    [
        ("gps", {"lever_arm": (0.0, 0.0, 0.0)}, ir.Status.DOMAIN),
        ("gps", {"x": (3, 1.01)}, ir.Status.QNORM),
        ("frame_map", {"turn": (1.0, 0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)}, ir.Status.QNORM),
        ("ranges", {"height": 60.0}, ir.Status.DOMAIN),
    ],
)
def test_statuses(
    package: ModuleType,
    rng: np.random.Generator,
    name: str,
    change: dict[str, Any],
    status: ir.Status,
) -> None:
    """Singular intermediates, norms and orthonormality have their own status."""
    function = FUNCTIONS[name]
    given = packages.arguments(function, rng, 2)
    for argument, value in change.items():
        if argument == "x":
            given["x"][1, value[0]] = value[1]
        else:
            given[argument][1] = value
    result = packages.called(getattr(package, name), given)
    assert result.status.tolist() == [0, status]
    assert_agrees(function, result, given)


def test_first_failure_counts(package: ModuleType, rng: np.random.Generator) -> None:
    """A range is reported rather than a norm, an argument rather than an intermediate."""
    given = packages.arguments(FUNCTIONS["gps"], rng, 3)
    given["x"][0, 3:7] *= 1.05
    given["lever_arm"][0] = 0.0
    given["x"][1, 3:7] *= 1.05
    given["x"][1, 0] = np.nan
    given["lever_arm"][2] = 0.0
    result = packages.called(package.gps, given)
    assert result.status.tolist() == [ir.Status.QNORM, ir.Status.RANGE, ir.Status.DOMAIN]


def test_bad_items(package: ModuleType, rng: np.random.Generator) -> None:
    """A skipped item costs its row; a rejecting function gives up the epoch."""
    given = packages.arguments(FUNCTIONS["ranges"], rng)
    given["satellite"][3, 1] = np.nan
    result = packages.called(package.ranges, given)
    assert result.status == package.Status.PARTIAL
    assert result.item_status.tolist() == [0, 0, 0, ir.Status.RANGE, 0]
    assert result.value[3] == 0.0
    assert not result.jacobian[3].any()
    assert np.isfinite(result.value).all()
    with pytest.raises(package.GuardError, match=r"strict: RANGE: satellite\[3\]\[1\] \(y\) = nan"):
        packages.called(package.strict, given)


def test_index_chooses_column_and_element(package: ModuleType, rng: np.random.Generator) -> None:
    """Each item reads its own slot and has its derivative in that column."""
    given = packages.arguments(FUNCTIONS["ranges"], rng, items=4)
    given["slot"] = np.array([3, 0, 2, 1], dtype=np.int32)
    given["height"] = np.array(0.0)
    base = packages.called(package.ranges, given)
    for item, slot in enumerate(given["slot"]):
        assert base.jacobian[item, 8:12].tolist() == [float(k == slot) for k in range(4)]
        moved = given["x"].copy()
        moved[9 + slot] += 2.5
        change = packages.called(package.ranges, {**given, "x": moved}).value - base.value
        assert change == pytest.approx([2.5 * (k == item) for k in range(4)], abs=1e-8)


def test_unguarded_functions_compute_whatever_they_get(
    rng: np.random.Generator, tmp_path: Any
) -> None:
    """Without guards only indices are checked, since they lead into memory."""
    function = modules.unguarded(modules.ranges())
    module = modules.module(function)
    package = packages.load(packages.write(packages.text_of(module), tmp_path / "rover"))
    given = packages.arguments(function, rng)
    given["x"][0] = 9e9
    result = packages.called(package.ranges, given)
    assert result.status == package.Status.OK
    assert result.value[0] == pytest.approx(
        interpreter.evaluate(function, given).outputs["value"][0], rel=1e-14
    )
    given["slot"][2] = 4
    assert packages.called(package.ranges, given).item_status.tolist() == [0, 0, 2, 0, 0]


def test_differences(package: ModuleType, rng: np.random.Generator) -> None:
    """Rows less the reference's, which goes; a bad item has a zero row, a bad reference fails."""
    given = packages.arguments(FUNCTIONS["ranges"], rng, 3)
    given["satellite"][1, 4] = np.nan
    given["satellite"][2, 2] = np.nan
    whole = packages.called(package.ranges, given)
    result = packages.called(package.ranges.single_difference, given, reference=2)
    matrix: NDArray[np.float64] = package.ranges.difference_matrix(5, 2)
    assert result.value[0] == pytest.approx(matrix @ whole.value[0], rel=1e-13)
    assert result.jacobian[0] == pytest.approx(matrix @ whole.jacobian[0], rel=1e-13, abs=1e-15)
    assert result.value[1, :3] == pytest.approx((matrix @ whole.value[1])[:3], rel=1e-13)
    assert result.value[1, 3] == 0.0
    assert np.isnan(result.value[2]).all()
    assert result.status.tolist() == [0, ir.Status.PARTIAL, ir.Status.RANGE]
    assert result.top[:2] == pytest.approx(whole.top[:2])


def test_difference_covariance(package: ModuleType, rng: np.random.Generator) -> None:
    """D diag(sigma^2) D' over leading axes."""
    sigma = rng.uniform(0.5, 2.0, size=(2, 4))
    matrix = package.ranges.difference_matrix(4, 1)
    assert matrix.tolist() == [[1, -1, 0, 0], [0, -1, 1, 0], [0, -1, 0, 1]]
    covariance = package.ranges.difference_covariance(sigma, 1)
    for own, one in zip(covariance, sigma, strict=True):
        assert own == pytest.approx(matrix @ np.diag(one**2) @ matrix.T, rel=1e-15)


def test_differences_are_guarded_like_the_c(package: ModuleType) -> None:
    """Standard deviations in their range, no more items than declared, an index for a reference."""
    form = package.ranges
    for sigma in ([1.0, np.nan, 3.0], [1.0, -1.0, 3.0], [1.0, np.inf, 3.0], [1.0, 1e151, 3.0]):
        with pytest.raises(ValueError, match=r"RANGE: sigma\[1\] = .* is outside") as caught:
            form.difference_covariance(sigma, 1)
        assert (caught.value.argument, caught.value.index) == ("sigma", (1,))  # type: ignore[attr-defined]
    assert np.isfinite(form.difference_covariance([0.0, 1e150], 1)).all()
    most = FUNCTIONS["ranges"].maximum
    assert most is not None
    assert form.difference_matrix(most, 0).shape == (most - 1, most)
    with pytest.raises(ValueError, match=f"COUNT: count has n = {most + 1}"):
        form.difference_matrix(most + 1, 0)
    with pytest.raises(ValueError, match=f"COUNT: sigma has n = {most + 1}"):
        form.difference_covariance(np.ones(most + 1), 0)
    with pytest.raises(ValueError, match="INDEX: reference = 3"):
        form.difference_matrix(3, 3)
    with pytest.raises(TypeError, match=r"reference is the index of an item, an integer; got 1\.0"):
        form.difference_matrix(3, 1.0)
