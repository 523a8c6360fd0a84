"""Inputs checked where they enter: the verdicts of a guarded call, and calls that rely on them."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from symnav import ir
from symnav.emit import c
from tests.emit_c import modules
from tests.emit_c.harness import UNTOUCHED_BYTE, Library
from tests.emit_c.samples import Inputs, changed, draw

FUNCTIONS = {function.name: function for function in modules.all_functions()}
PAIRS = {
    "gps_outer": "gps",
    "range_outer": "range",
    "strict_outer": "strict",
    "all_outer": "all",
}
"""Functions checked at the border, and the same ones checked in every call."""
ITEMS = 5
Status = ir.Status


def count(name: str) -> int:
    """Items in the calls of these tests."""
    return 0 if FUNCTIONS[name].maximum is None else ITEMS


def sample(name: str, library: Library, seed: int = 4) -> Inputs:
    """Inputs that every check accepts."""
    inputs = draw(FUNCTIONS[PAIRS[name]], seed, count(name), library.real)
    if name == "all_outer":
        inputs["pair"][:] = 0.0
    return inputs


def places(name: str) -> list[tuple[ir.Argument, int | tuple[int, int]]]:
    """Every element of every input; of the items, those of the last one."""
    return [
        (argument, (ITEMS - 1, k) if argument.item else k)
        for argument in FUNCTIONS[name].arguments
        for k in range(argument.size)
    ]


@pytest.mark.parametrize("name", PAIRS)
def test_every_element_is_checked(library: Library, name: str) -> None:
    """What a guarded call says of an input, the check says: of the call and of every item."""
    function, guarded = FUNCTIONS[name], FUNCTIONS[PAIRS[name]]
    good = sample(name, library)
    assert library.border(function, good, count(name)).status is Status.OK
    refused = set()
    for argument, place in places(name):
        reals = (np.nan, np.inf, -np.inf, 1e30, 0.6)
        for bad in (2**31 - 1, -(2**31)) if argument.integer else reals:
            values = changed(good, argument.name, place, bad)
            expected = library.evaluate(guarded, values, count(name))
            found = library.border(function, values, count(name))
            if expected.status in (Status.DOMAIN, Status.INDEX):
                assert found.status is Status.OK  # singular, which only an evaluation can find
                continue
            refused.add(found.status)
            assert found.status is expected.status, (argument.name, place, bad)
            if count(name):
                statuses = expected["item_status"]
                evaluated = (Status.DOMAIN, Status.INDEX)
                assert_array_equal(
                    found["item_status"], np.where(np.isin(statuses, evaluated), 0, statuses)
                )
    wanted = Status.PARTIAL if name == "range_outer" else Status.RANGE
    assert {wanted, Status.OK} <= refused


@pytest.mark.parametrize("scale", [0.9993, 1.0007])
@pytest.mark.parametrize("name", ["gps_outer", "range_outer", "strict_outer"])
def test_norm_is_checked(library: Library, name: str, scale: float) -> None:
    """A quaternion that is not of unit norm is refused; items are not looked at then."""
    inputs = sample(name, library)
    inputs["x"][3:7] *= scale
    found = library.border(FUNCTIONS[name], inputs, count(name))
    assert found.status is Status.QNORM
    assert all(np.all(array == UNTOUCHED_BYTE) for array in found.outputs.values())


@pytest.mark.parametrize("name", PAIRS)
def test_results_are_those_of_a_guarded_call(library: Library, name: str) -> None:
    """Bit by bit, in every form; a singular value is refused as there."""
    function, guarded = FUNCTIONS[name], FUNCTIONS[PAIRS[name]]
    for seed in range(6):
        inputs = sample(name, library, seed)
        for variant in ("", "_value", "_jacobian", "_nz") if name != "all_outer" else ("",):
            expected = library.evaluate(guarded, inputs, count(name), variant=variant)
            found = library.evaluate(function, inputs, count(name), variant=variant)
            assert found.status is expected.status
            for output, array in found.outputs.items():
                assert_array_equal(array, expected[output])


def test_a_call_finds_what_is_singular(library: Library) -> None:
    """The check accepts a lever arm of no length, the call does not."""
    inputs = sample("gps_outer", library)
    inputs["lever_arm"][:] = 0.0
    assert library.border(FUNCTIONS["gps_outer"], inputs).status is Status.OK
    found = library.evaluate(FUNCTIONS["gps_outer"], inputs)
    assert found.status is Status.DOMAIN
    assert found.untouched


def test_a_call_does_not_look_again(library: Library) -> None:
    """Reals outside their ranges pass; integers, which address memory, do not."""
    inputs = sample("gps_outer", library)
    inputs["x"][0] = 3e5
    assert library.evaluate(FUNCTIONS["gps_outer"], inputs).status is Status.OK
    items = sample("range_outer", library)
    items["slot"][1, 0] = 11
    found = library.evaluate(FUNCTIONS["range_outer"], items, ITEMS)
    assert found.status is Status.PARTIAL
    assert found["item_status"][1] == Status.RANGE


@pytest.mark.parametrize("n", [-1, 21, 2**31 - 1, -(2**31)])
def test_counts(library: Library, n: int) -> None:
    """A count beyond the maximum is refused before anything is read."""
    inputs = draw(FUNCTIONS["range"], 1, 20, library.real)
    found = library.border(FUNCTIONS["range_outer"], inputs, n)
    assert found.status is Status.COUNT
    assert np.all(found["item_status"] == UNTOUCHED_BYTE)


@pytest.mark.parametrize("name", ["gps_outer", "range_outer"])
def test_null_pointers(library: Library, name: str) -> None:
    """Each pointer in turn."""
    function = FUNCTIONS[name]
    first, *rest = library.inputs(function, sample(name, library)).values()
    mapped = function.maximum is not None
    status = [np.zeros(function.maximum or 0, np.uint8)] if mapped else []
    arguments: list[object] = [first, *([ITEMS] if mapped else []), *rest, *status]
    assert library.call(f"{name}_check", arguments) is Status.OK
    for k, argument in enumerate(arguments):
        if isinstance(argument, np.ndarray):
            passed = [None if j == k else other for j, other in enumerate(arguments)]
            assert library.call(f"{name}_check", passed) is Status.NULL


def test_the_check_stands_in_a_file_of_its_own() -> None:
    """A program that trusts its inputs need not link it; nothing else has one."""
    files = c.emit(modules.module(*modules.all_functions()))
    checks = {path for path in files if path.endswith("_check.c")}
    assert checks == {f"c/src/rover_{name}_check.c" for name in PAIRS}
    text = files["c/src/rover_gps_outer_check.c"]
    assert "_kernel.h" not in text
    header = files["c/include/rover/rover.h"]
    assert header.count("has checked the inputs with") == len(PAIRS)
