"""Single differences: rows, matrix and covariance."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from symnav import ir
from tests.emit_c import modules
from tests.emit_c.harness import UNTOUCHED, UNTOUCHED_BYTE, Library
from tests.emit_c.samples import draw
from tests.emit_c.test_values import dense, sample

FUNCTIONS = {function.name: function for function in modules.all_functions()}
NAMES = ["range", "strict", "columns", "rows_columns"]
Status = ir.Status


@pytest.mark.parametrize("reference", [0, 3, 17])
@pytest.mark.parametrize("name", NAMES)
def test_rows_are_differences(library: Library, name: str, reference: int) -> None:
    """Each row is the item's less the reference's, to the bit, in ascending order."""
    function, n = FUNCTIONS[name], 18
    inputs = sample(function, 2, n, library)
    joint = library.evaluate(function, inputs, n)
    found = library.evaluate(function, inputs, n, variant="_sd", reference=reference)
    assert found.status is joint.status is Status.OK
    assert_array_equal(found["item_status"], joint["item_status"])
    others = [item for item in range(n) if item != reference]
    for output in function.outputs:
        rows = dense(function, joint, output, n)
        expected = rows[others] - rows[reference] if output.item else rows
        assert_array_equal(dense(function, found, output, n - 1), expected)


def test_a_bad_item_is_a_zero_row(library: Library) -> None:
    """The rest is as without it."""
    function, n = FUNCTIONS["range"], 6
    inputs = draw(function, 2, n, library.real)
    whole = library.evaluate(function, inputs, n, variant="_sd", reference=1)
    inputs["correction"][4, 0] = np.nan
    found = library.evaluate(function, inputs, n, variant="_sd", reference=1)
    assert found.status is Status.PARTIAL
    assert list(found["item_status"][:n]) == [0, 0, 0, 0, Status.RANGE, 0]
    rows, good = (one["jacobian"].reshape(-1, 19)[: n - 1] for one in (found, whole))
    assert not rows[3].any() and found["value"][3] == 0.0
    assert_array_equal(np.delete(rows, 3, 0), np.delete(good, 3, 0))


def test_a_bad_reference_fails_the_call(library: Library) -> None:
    """There is nothing to subtract."""
    function = FUNCTIONS["range"]
    inputs = draw(function, 2, 6, library.real)
    inputs["correction"][4, 0] = np.nan
    found = library.evaluate(function, inputs, 6, variant="_sd", reference=4)
    assert found.status is Status.RANGE
    assert found.untouched
    assert found["item_status"][4] == Status.RANGE


@pytest.mark.parametrize(
    ("n", "reference", "status"),
    [
        (6, -1, Status.INDEX),
        (6, 6, Status.INDEX),
        (1, 0, Status.OK),
        (0, 0, Status.OK),
        (0, 5, Status.OK),
        (21, 0, Status.COUNT),
        (-1, 0, Status.COUNT),
    ],
)
def test_counts_and_references(library: Library, n: int, reference: int, status: Status) -> None:
    """In all three functions alike."""
    function = FUNCTIONS["range"]
    inputs = draw(function, 2, 20, library.real)
    found = library.evaluate(function, inputs, n, variant="_sd", reference=reference)
    assert found.status is status
    assert found.untouched
    if status is not Status.OK or n == 0:
        assert np.all(found["item_status"] == UNTOUCHED_BYTE)
    matrix = np.full(400, UNTOUCHED, library.real)
    assert library.call("range_difference_matrix", [n, reference, matrix]) is status
    sigma = np.ones(20, library.real)
    arguments = [n, reference, sigma, matrix]
    assert library.call("range_difference_covariance", arguments) is status
    assert np.all(matrix == UNTOUCHED)


@pytest.mark.parametrize(("n", "reference"), [(2, 0), (2, 1), (7, 0), (7, 3), (20, 19)])
def test_matrix_and_covariance(library: Library, n: int, reference: int) -> None:
    """The covariance is D diag(sigma^2) D', and D takes the differences."""
    matrix = np.full(20 * 19, UNTOUCHED, library.real)
    covariance = np.full(19 * 19, UNTOUCHED, library.real)
    sigma = np.random.default_rng(n).uniform(0.5, 3.0, 20).astype(library.real)
    assert library.call("range_difference_matrix", [n, reference, matrix]) is Status.OK
    arguments = [n, reference, sigma, covariance]
    assert library.call("range_difference_covariance", arguments) is Status.OK
    expected = np.delete(np.eye(n), reference, 0)
    expected[:, reference] = -1.0
    assert_array_equal(matrix[: n * (n - 1)].reshape(n - 1, n), expected)
    full = expected @ np.diag(sigma[:n].astype(float) ** 2) @ expected.T
    found = covariance[: (n - 1) ** 2].reshape(n - 1, n - 1)
    assert_allclose(found, full, rtol=8 * float(np.finfo(library.real).eps))
    assert np.all(covariance[(n - 1) ** 2 :] == UNTOUCHED)
    assert np.all(matrix[n * (n - 1) :] == UNTOUCHED)


@pytest.mark.parametrize("bad", [np.nan, -0.5, np.inf])
def test_standard_deviations_are_checked(library: Library, bad: float) -> None:
    """Only those of the items there are."""
    covariance = np.full(19 * 19, UNTOUCHED, library.real)
    sigma = np.ones(20, library.real)
    sigma[5] = bad
    call = [6, 0, sigma, covariance]
    assert library.call("range_difference_covariance", call) is Status.RANGE
    assert np.all(covariance == UNTOUCHED)
    assert library.call("range_difference_covariance", [5, 0, sigma, covariance]) is Status.OK


def test_null_pointers(library: Library) -> None:
    """Neither function follows one."""
    array = np.zeros(400, library.real)
    assert library.call("range_difference_matrix", [3, 0, None]) is Status.NULL
    assert library.call("range_difference_covariance", [3, 0, None, array]) is Status.NULL
    assert library.call("range_difference_covariance", [3, 0, array, None]) is Status.NULL
