"""Every status, and what it leaves untouched."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from symnav import ir
from tests.emit_c import modules
from tests.emit_c.harness import UNTOUCHED_BYTE, Library
from tests.emit_c.interpreter import evaluate
from tests.emit_c.samples import changed, draw

FUNCTIONS = {function.name: function for function in modules.all_functions()}
GUARDED = [name for name, function in FUNCTIONS.items() if function.checks_inputs]
Status = ir.Status


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e30, -1e30])
@pytest.mark.parametrize("name", GUARDED)
def test_every_element_of_the_shared_inputs(library: Library, name: str, bad: float) -> None:
    """One bad element, read by the kernel or not, refuses the call and touches nothing."""
    function = FUNCTIONS[name]
    n = 0 if function.maximum is None else 2
    inputs = draw(function, 4, n, library.real)
    for argument in function.arguments:
        if argument.item or argument.integer:
            continue
        for index in range(argument.size):
            found = library.evaluate(function, changed(inputs, argument.name, index, bad), n)
            assert found.status is Status.RANGE, (argument.name, index)
            assert found.untouched


@pytest.mark.parametrize("name", [name for name in GUARDED if name != "all"])
def test_ends_of_ranges(library: Library, name: str) -> None:
    """The ends belong to the range, the next number outside does not."""
    function = FUNCTIONS[name]
    inputs = draw(function, 4, 1, library.real)
    argument = function.arguments[1]
    domain = argument.domains[0]
    item = argument.item
    for index, (lower, upper) in enumerate(zip(domain.lower, domain.upper, strict=True)):
        for end, beyond in ((lower, -np.inf), (upper, np.inf)):
            inside = library.real(end)  # what a caller has who writes the end in the type
            outside = np.nextafter(inside, library.real(beyond))
            at = (0, index) if item else index
            kept = library.evaluate(function, changed(inputs, argument.name, at, float(inside)), 1)
            refused = library.evaluate(
                function, changed(inputs, argument.name, at, float(outside)), 1
            )
            statuses = [one["item_status"][0] if item else one.status for one in (kept, refused)]
            assert statuses[0] != Status.RANGE, (index, end)
            assert statuses[1] == Status.RANGE, (index, end)


@pytest.mark.parametrize("scale", [0.0, 0.9, 0.9993, 1.0007])
def test_norm_of_a_quaternion(library: Library, scale: float) -> None:
    """A quaternion too long or too short is refused, however far."""
    inputs = draw(FUNCTIONS["gps"], 2, 0, library.real)
    inputs["x"][3:7] *= scale
    found = library.evaluate(FUNCTIONS["gps"], inputs)
    assert found.status is Status.QNORM
    assert found.untouched
    inputs["x"][3:7] *= 1.0003 / scale if scale else 1.0
    assert library.evaluate(FUNCTIONS["gps"], inputs).status is (
        Status.OK if scale else Status.QNORM
    )


def test_range_is_reported_before_norm(library: Library) -> None:
    """An element outside its range is the more telling fault."""
    inputs = draw(FUNCTIONS["gps"], 2, 0, library.real)
    inputs["x"][3] = 5.0
    assert library.evaluate(FUNCTIONS["gps"], inputs).status is Status.RANGE


@pytest.mark.parametrize(("row", "column"), list(itertools.product(range(3), range(3))))
def test_orthonormality_of_a_matrix(library: Library, row: int, column: int) -> None:
    """Each of the nine elements takes part in the check."""
    function = FUNCTIONS["all"]
    inputs = draw(function, 0, 0, library.real)
    inputs["pair"][:] = 0.5
    inputs["mounting"] = np.eye(3).ravel()
    assert library.evaluate(function, inputs).status is Status.OK
    bent = changed(inputs, "mounting", 3 * row + column, 0.02 if row != column else 0.98)
    assert library.evaluate(function, bent).status is Status.QNORM


@pytest.mark.parametrize("sign", [(-1, -1, -1), (1, 1, -1), (-1, 1, 1)])
def test_reflection_is_no_rotation(library: Library, sign: tuple[int, int, int]) -> None:
    """Orthonormal columns are not enough: the third is the cross product of the others."""
    function = FUNCTIONS["all"]
    inputs = draw(function, 0, 0, library.real)
    inputs["pair"][:] = 0.5
    inputs["mounting"] = np.diag(sign).astype(library.real).ravel()
    found = library.evaluate(function, inputs)
    assert found.status is Status.QNORM
    assert evaluate(function, inputs).status is Status.QNORM
    assert found.untouched


def test_statuses_of_checks_in_order(library: Library) -> None:
    """The first check that fails decides, though later ones fail as well."""
    function = FUNCTIONS["all"]
    inputs = draw(function, 0, 0, library.real)
    for a, b, status in (
        (0.0, 0.0, Status.OK),
        (3.9, 0.0, Status.DOMAIN),
        (0.0, -2.0, Status.INDEX),
        (3.9, -2.0, Status.DOMAIN),
    ):
        inputs["pair"][:] = a, b
        found = library.evaluate(function, inputs)
        assert found.status is status
        assert evaluate(function, inputs).status is status
        assert found.untouched is (status is not Status.OK)


@pytest.mark.parametrize("choice", [-3, 4, 2**31 - 1, -(2**31)])
def test_integers_are_checked(library: Library, choice: int) -> None:
    """An integer outside its range is refused."""
    inputs = draw(FUNCTIONS["all"], 0, 0, library.real)
    inputs["choice"][0] = choice
    assert library.evaluate(FUNCTIONS["all"], inputs).status is Status.RANGE


def test_singular_lever_arm(library: Library) -> None:
    """A guard on an intermediate value; at the singularity itself as well."""
    inputs = draw(FUNCTIONS["gps"], 2, 0, library.real)
    for length, status in ((0.0, Status.DOMAIN), (0.009, Status.DOMAIN), (0.02, Status.OK)):
        inputs["lever_arm"][:] = length, 0.0, 0.0
        found = library.evaluate(FUNCTIONS["gps"], inputs)
        assert found.status is status
        assert found.untouched is (status is not Status.OK)


@pytest.mark.parametrize("name", list(FUNCTIONS))
def test_null_pointers(library: Library, name: str) -> None:
    """Each pointer in turn; nothing is written through the others."""
    function = FUNCTIONS[name]
    mapped = function.maximum is not None
    given = list(library.inputs(function, draw(function, 1, 1, library.real)).values())
    sizes = [int(np.prod(o.shape)) * (function.maximum or 1) for o in function.outputs]
    outputs = [np.full(size, -1.0, library.real) for size in sizes]
    status = [np.full(function.maximum or 0, UNTOUCHED_BYTE, np.uint8)] if mapped else []
    arguments: list[object] = [given[0], *([1] if mapped else []), *given[1:], *outputs, *status]
    pointers = [k for k, argument in enumerate(arguments) if isinstance(argument, np.ndarray)]
    for missing in pointers:
        passed = [None if k == missing else argument for k, argument in enumerate(arguments)]
        assert library.call(name, passed) is Status.NULL
    assert all(np.all(output == -1.0) for output in outputs)
    assert library.call(name, arguments) is not Status.NULL


@pytest.mark.parametrize("n", [-1, 21, 2**31 - 1, -(2**31)])
@pytest.mark.parametrize("name", ["range", "strict", "bare"])
@pytest.mark.parametrize("variant", ["", "_value", "_jacobian", "_nz"])
def test_counts(library: Library, name: str, variant: str, n: int) -> None:
    """A count beyond the maximum is refused before anything is read, guarded or not."""
    function = FUNCTIONS[name]
    inputs = draw(function, 1, 20, library.real)
    found = library.evaluate(function, inputs, n, variant=variant)
    assert found.status is Status.COUNT
    assert found.untouched
    assert np.all(found["item_status"] == UNTOUCHED_BYTE)


def test_counts_of_a_batch(library: Library) -> None:
    """Neither a negative number of epochs nor too many items."""
    for name, count in (("gps", ()), ("range", (2,)), ("range", (21,)), ("range", (-1,))):
        function = FUNCTIONS[name]
        given = list(library.inputs(function, draw(function, 1, 2, library.real)).values())
        arguments: list[object] = [-1 if count in ((), (2,)) else 1, given[0], 0, *count]
        for argument in given[1:]:
            arguments += [argument, 0]
        arguments += [np.zeros(900, library.real) for _ in function.outputs]
        arguments += [np.full(1, 7, np.uint8), *([np.zeros(40, np.uint8)] if count else [])]
        assert library.call(f"{name}_batch", arguments) is Status.COUNT


def test_one_bad_item_is_skipped(library: Library) -> None:
    """Its row is zero and carries its own status; the others are the bits they were."""
    function = FUNCTIONS["range"]
    n = 18
    inputs = draw(function, 8, n, library.real)
    good = library.evaluate(function, inputs, n)
    assert good.status is Status.OK
    inputs["satellite_position"][4, 1] = np.nan
    inputs["slot"][9, 0] = 11
    antenna = inputs["x"][:3] + 1e-9
    inputs["lever_arm"][:] = 0.0
    inputs["satellite_position"][17] = antenna
    good = library.evaluate(function, {**inputs, **_without(inputs, (4, 9, 17))}, n)
    for variant in ("", "_nz"):
        found = library.evaluate(function, inputs, n, variant=variant)
        assert found.status is Status.PARTIAL
        expected = [Status.OK] * n
        expected[4] = expected[9] = Status.RANGE
        expected[17] = Status.DOMAIN
        assert list(found["item_status"][:n]) == expected
        if not variant:
            rows = found["jacobian"].reshape(20, -1)[:n]
            whole = good["jacobian"].reshape(20, -1)[:n]
            for item, status in enumerate(expected):
                if status is Status.OK:
                    assert_array_equal(rows[item], whole[item])
                    assert found["value"][item] == good["value"][item]
                else:
                    assert not rows[item].any() and found["value"][item] == 0.0
        else:
            columns = found["jacobian"].reshape(9, 20)
            assert not columns[:, [4, 9, 17]].any()
            assert columns[0, 5] != 0.0


def _without(inputs: dict[str, np.ndarray], items: tuple[int, ...]) -> dict[str, np.ndarray]:
    """Harmless values for some items."""
    positions, slots = inputs["satellite_position"].copy(), inputs["slot"].copy()
    for item in items:
        positions[item], slots[item] = 2e7, 0
    return {"satellite_position": positions, "slot": slots}


@pytest.mark.parametrize("variant", ["", "_value", "_jacobian", "_nz", "_sd"])
def test_one_bad_item_rejects_the_call(library: Library, variant: str) -> None:
    """Nothing is written but the statuses of the items."""
    function = FUNCTIONS["strict"]
    inputs = draw(function, 8, 18, library.real)
    inputs["correction"][11, 0] = np.inf
    inputs["correction"][17, 0] = np.inf
    reference = 2 if variant == "_sd" else None
    found = library.evaluate(function, inputs, 18, variant=variant, reference=reference)
    assert found.status is Status.RANGE
    assert found.untouched
    assert [k for k in range(18) if found["item_status"][k] != Status.OK] == [11, 17]


def test_all_items_bad_is_partial(library: Library) -> None:
    """Every row is zero; the call still says PARTIAL."""
    inputs = draw(FUNCTIONS["range"], 8, 3, library.real)
    inputs["correction"][:] = np.nan
    found = library.evaluate(FUNCTIONS["range"], inputs, 3)
    assert found.status is Status.PARTIAL
    assert not found["value"][:3].any()


def test_shared_check_fails_the_call(library: Library) -> None:
    """A shared guard comes before the items; their statuses are not written."""
    inputs = draw(FUNCTIONS["range"], 8, 3, library.real)
    inputs["x"][2] = 99999.0
    found = library.evaluate(FUNCTIONS["range"], inputs, 3)
    assert found.status is Status.DOMAIN
    assert found.untouched
    assert np.all(found["item_status"] == UNTOUCHED_BYTE)


def test_unguarded_functions_do_not_check_values(library: Library) -> None:
    """Outside the range they compute, and integers that address memory are still checked."""
    inputs = draw(FUNCTIONS["gps_bare"], 2, 0, library.real)
    inputs["x"][0] = 3e5
    inputs["x"][19] = np.nan
    found = library.evaluate(FUNCTIONS["gps_bare"], inputs)
    assert found.status is Status.OK
    assert abs(found["value"][0] - 3e5) < 10.0
    items = draw(FUNCTIONS["bare"], 2, 2, library.real)
    items["slot"][1, 0] = 11
    assert library.evaluate(FUNCTIONS["bare"], items, 2).status is Status.RANGE
