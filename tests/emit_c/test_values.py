"""Values and Jacobians of the compiled C against 50 digits, in every way of calling it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from symnav import ir
from tests.emit_c import modules
from tests.emit_c.harness import UNTOUCHED, UNTOUCHED_BYTE, Library, Outcome
from tests.emit_c.interpreter import evaluate
from tests.emit_c.samples import Inputs, draw

FUNCTIONS = {function.name: function for function in modules.all_functions()}
SINGLE = [name for name, function in FUNCTIONS.items() if function.maximum is None]
MAPPED = [name for name, function in FUNCTIONS.items() if function.maximum is not None]
ITEMS = (0, 1, 4, 16, 17, 20)

# Rounding of some tens of operations, relative to the largest operand that occurs.
ULPS = 64


def sample(function: ir.Function, seed: int, n: int, library: Library) -> Inputs:
    """Inputs for which nearly every item passes its checks."""
    inputs = draw(function, seed, n, library.real)
    if function.name.startswith("rows"):
        inputs["x"][:2] *= 1e-3
        inputs["anchor"] *= 0.25
    return inputs


def assert_close(
    found: NDArray[Any], expected: NDArray[np.float64], inputs: Inputs, library: Library
) -> None:
    """Equal within the rounding of the type."""
    largest = max([1.0, *(float(np.max(np.abs(v))) for v in inputs.values() if v.size)])
    scale = max(largest, float(np.max(np.abs(expected), initial=0.0)))
    tolerance = ULPS * float(np.finfo(library.real).eps) * scale
    assert_allclose(np.asarray(found, np.float64), expected, rtol=0.0, atol=tolerance)


def dense(function: ir.Function, outcome: Outcome, output: ir.Output, n: int) -> NDArray[Any]:
    """A dense output of one epoch as an array with its item axis in front."""
    flat = outcome[output.name]
    jacobian = output.name.startswith("jacobian")
    if function.maximum is None or not output.item:
        if function.column_major and jacobian:
            return flat.reshape(output.shape[::-1]).T
        return flat.reshape(output.shape)
    if function.column_major and jacobian:
        rows = output.shape[0] if len(output.shape) > 1 else 1
        items = flat.size // int(np.prod(output.shape))
        by_row = flat.reshape((output.shape[-1], items, rows)).transpose(1, 2, 0)
        return by_row.reshape((items, *output.shape))[:n]
    return flat.reshape((-1, *output.shape))[:n]


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("name", SINGLE)
def test_one_epoch(library: Library, name: str, seed: int) -> None:
    """Dense outputs are right and all others agree with them to the bit."""
    function = FUNCTIONS[name]
    inputs = sample(function, seed, 0, library)
    expected = evaluate(function, inputs)
    joint = library.evaluate(function, inputs)
    assert joint.status is expected.status
    if expected.status is not ir.Status.OK:
        assert joint.untouched
        return
    for output in function.outputs:
        found = dense(function, joint, output, 0)
        assert_close(found, expected.outputs[output.name], inputs, library)


@pytest.mark.parametrize(
    "name", [name for name in SINGLE if name not in ("retract", "all", "all_outer")]
)
def test_one_epoch_variants(library: Library, name: str) -> None:
    """Values, Jacobians and non-zeros alone are the same bits as the joint call."""
    function = FUNCTIONS[name]
    inputs = sample(function, 1, 0, library)
    joint = library.evaluate(function, inputs)
    assert joint.status is ir.Status.OK
    for variant in ("_value", "_jacobian"):
        alone = library.evaluate(function, inputs, variant=variant)
        assert alone.status is ir.Status.OK
        for key, array in alone.outputs.items():
            assert_array_equal(array, joint[key])
    sparse = library.evaluate(function, inputs, variant="_nz")
    assert sparse.status is ir.Status.OK
    for output in function.outputs:
        full = dense(function, joint, output, 0)
        if not output.name.startswith("jacobian"):
            assert_array_equal(sparse[output.name].reshape(output.shape), full)
            continue
        rows = _table(library, function, output, "rows")
        columns = _table(library, function, output, "columns")
        assert_array_equal(full[rows, columns], sparse[output.name])
        rest = full.copy()
        rest[rows, columns] = 0.0
        assert not rest.any()


@pytest.mark.parametrize("n", ITEMS)
@pytest.mark.parametrize("name", MAPPED)
def test_items(library: Library, name: str, n: int) -> None:
    """Dense rows of a mapped function are right, and rows from n on are untouched."""
    function = FUNCTIONS[name]
    inputs = sample(function, n, n, library)
    expected = evaluate(function, inputs, n)
    found = library.evaluate(function, inputs, n)
    assert found.status is expected.status
    # Where what the items share fails, none of them is looked at.
    statuses = [int(status) for status in expected.item_status] or [UNTOUCHED_BYTE] * n
    assert list(found["item_status"][:n]) == statuses
    if expected.status not in (ir.Status.OK, ir.Status.PARTIAL):
        assert found.untouched
        return
    for output in function.outputs:
        array = dense(function, found, output, n)
        assert_close(array, expected.outputs[output.name], inputs, library)
    assert np.sum(found["value"] != UNTOUCHED) == n * int(np.prod(function.outputs[0].shape))


@pytest.mark.parametrize("name", MAPPED)
def test_item_variants(library: Library, name: str) -> None:
    """Values, Jacobians and columns of non-zeros are the same bits as the joint call."""
    function = FUNCTIONS[name]
    n = 19
    inputs = sample(function, 5, n, library)
    joint = library.evaluate(function, inputs, n)
    assert joint.status in (ir.Status.OK, ir.Status.PARTIAL)
    for variant in ("_value", "_jacobian", "_nz"):
        alone = library.evaluate(function, inputs, n, variant=variant)
        assert alone.status is joint.status
        assert_array_equal(alone["item_status"], joint["item_status"])
        for output in function.outputs:
            if output.name not in alone.outputs:
                continue
            if variant != "_nz" or not output.name.startswith("jacobian"):
                assert_array_equal(alone[output.name], joint[output.name])
                continue
            full = dense(function, joint, output, n)
            _compare_columns(library, function, output, inputs, alone[output.name], full)


def _compare_columns(
    library: Library,
    function: ir.Function,
    output: ir.Output,
    inputs: Inputs,
    sparse: NDArray[Any],
    full: NDArray[Any],
) -> None:
    n = full.shape[0]
    columns = sparse.reshape((len(output.entries), -1))
    assert np.all(columns[:, n:] == UNTOUCHED)
    at = [_table(library, function, output, axis) for axis in ("rows", "columns")]
    rebuilt = np.zeros_like(full)
    for position, entry in enumerate(output.entries):
        moved = any(isinstance(step, ir.Offset) for step in entry.index)
        for item in range(n):
            slot = int(inputs["slot"][item, 0]) if moved else 0
            place = [int(table[position]) for table in at if table is not None]
            place[-1] += slot
            rebuilt[(item, *place)] = columns[position, item]
    assert_array_equal(rebuilt, full)


def _table(
    library: Library, function: ir.Function, output: ir.Output, axis: str
) -> list[int] | None:
    name = f"{library.prefix}_{function.name}_{output.name}_{axis}"
    if axis == "rows" and len(output.shape) == 1:
        assert not hasattr(library.extension.lib, name)
        return None
    return list(library.constant(name))


@pytest.mark.parametrize("epochs", [0, 1, 63, 64, 65, 200])
@pytest.mark.parametrize("name", SINGLE)
def test_batch(library: Library, name: str, epochs: int) -> None:
    """A batch is the same bits as one call per epoch; failed epochs are left alone."""
    function = FUNCTIONS[name]
    samples = [sample(function, seed, 0, library) for seed in range(epochs)]
    for spoilt in samples[3::7]:
        spoilt[function.arguments[0].name][0] = np.nan
    found = library.batch(function, samples)
    expected = [library.evaluate(function, one) for one in samples]
    assert list(found["status"]) == [one.status for one in expected]
    failed = any(one.status is not ir.Status.OK for one in expected)
    assert found.status is (ir.Status.PARTIAL if failed else ir.Status.OK)
    for output in function.outputs:
        for row, one in zip(found[output.name], expected, strict=True):
            if one.status is ir.Status.OK:
                assert_array_equal(row, dense(function, one, output, 0))
            else:
                assert np.all(row == UNTOUCHED)


def test_batch_with_common_input(library: Library) -> None:
    """A step of zero reads the same input for all epochs."""
    function = FUNCTIONS["gps"]
    samples = [sample(function, seed, 0, library) for seed in range(70)]
    for one in samples:
        one["lever_arm"] = samples[0]["lever_arm"]
    found = library.batch(function, samples, common=("lever_arm",))
    assert found.status is ir.Status.OK
    for row, one in zip(found["jacobian"], samples, strict=True):
        assert_array_equal(row.ravel(), library.evaluate(function, one)["jacobian"])


@pytest.mark.parametrize("n", [0, 3, 18])
@pytest.mark.parametrize("name", MAPPED)
def test_batch_of_items(library: Library, name: str, n: int) -> None:
    """Every epoch of a batch of a mapped function is the same bits as a call of its own."""
    function = FUNCTIONS[name]
    samples = [sample(function, seed, n, library) for seed in range(9)]
    samples[2]["x"][1] = np.inf
    found = library.batch(function, samples, n)
    expected = [library.evaluate(function, one, n) for one in samples]
    assert list(found["status"]) == [one.status for one in expected]
    for epoch, one in enumerate(expected):
        done = one.status in (ir.Status.OK, ir.Status.PARTIAL)
        assert_array_equal(found["item_status"][epoch], one["item_status"][:n])
        for output in function.outputs:
            row = found[output.name][epoch]
            if done:
                assert_array_equal(row, dense(function, one, output, n))
            else:
                assert np.all(row == UNTOUCHED)


def test_row_and_column_order_agree(library: Library) -> None:
    """Column-major output is the transpose of row-major output."""
    inputs = sample(FUNCTIONS["gps"], 3, 0, library)
    by_row = library.evaluate(FUNCTIONS["gps"], inputs)["jacobian"]
    by_column = library.evaluate(FUNCTIONS["gps_columns"], inputs)["jacobian"]
    assert_array_equal(by_row.reshape(4, -1), by_column.reshape(-1, 4).T)
    assert not np.array_equal(by_row, by_column)
