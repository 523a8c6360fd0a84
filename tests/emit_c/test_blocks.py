"""Blocks of epochs side by side, and batches of non-zeros: the bits of one call per epoch."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from symnav import ir
from tests.emit_c import modules
from tests.emit_c.harness import UNTOUCHED, Library
from tests.emit_c.samples import changed, draw

FUNCTIONS = {function.name: function for function in modules.all_functions()}
SINGLE = [name for name, function in FUNCTIONS.items() if function.maximum is None]
MAPPED = [name for name, function in FUNCTIONS.items() if function.maximum is not None]
SPARSE = {
    name
    for name, function in FUNCTIONS.items()
    if any(o.name.startswith("jacobian") and o.entries for o in function.outputs)
}
Status = ir.Status


def _variant(name: str) -> str:
    """The call for one epoch that gives what a block holds."""
    return "_nz" if name in SPARSE else ""


def _spoilt(library: Library, name: str, epochs: int) -> list[dict[str, np.ndarray]]:
    """Samples of which every seventh is not a number somewhere."""
    function = FUNCTIONS[name]
    samples = [draw(function, seed, 0, library.real) for seed in range(epochs)]
    for spoilt in samples[3::7]:
        spoilt[function.arguments[0].name][0] = np.nan
    return samples


@pytest.mark.parametrize("epochs", [0, 1, 31, 32, 33, 100])
@pytest.mark.parametrize("name", SINGLE)
def test_blocks(library: Library, name: str, epochs: int) -> None:
    """Whole and broken blocks, epochs that fail and none; lanes to spare stay as they are."""
    function = FUNCTIONS[name]
    for samples in (
        [draw(function, seed, 0, library.real) for seed in range(epochs)],
        _spoilt(library, name, epochs),
    ):
        found = library.blocks(function, samples)
        expected = [library.evaluate(function, one, variant=_variant(name)) for one in samples]
        assert list(found["status"]) == [one.status for one in expected]
        failed = any(one.status is not Status.OK for one in expected)
        assert found.status is (Status.PARTIAL if failed else Status.OK)
        for output, rows in found.outputs.items():
            for row, one in zip(rows, expected, strict=True):
                if output == "status":
                    continue
                if one.status is Status.OK:
                    assert_array_equal(row, one[output])
                else:
                    assert np.all(row == UNTOUCHED)


@pytest.mark.parametrize("name", [name for name in SINGLE if FUNCTIONS[name].checks_inputs])
def test_every_element_of_every_lane_is_checked(library: Library, name: str) -> None:
    """One element out of its range fails its own lane, with the status of a single call."""
    function = FUNCTIONS[name]
    good = draw(function, 4, 0, library.real)
    places = [
        (argument, index) for argument in function.arguments for index in range(argument.size)
    ]
    samples = [good]
    for argument, index in places:
        bad = 2**31 - 1 if argument.integer else np.inf
        samples.append(changed(good, argument.name, index, bad))
    found = library.blocks(function, samples)
    expected = [library.evaluate(function, one).status for one in samples]
    assert list(found["status"]) == expected
    assert expected[0] is Status.OK and Status.RANGE in expected


def test_guards_inside_of_a_kernel(library: Library) -> None:
    """A singular value fails its lane and nothing else."""
    function = FUNCTIONS["gps"]
    samples = [draw(function, seed, 0, library.real) for seed in range(40)]
    samples[17]["lever_arm"][:] = 0.0
    samples[33]["x"][3:7] = 0.6
    found = library.blocks(function, samples)
    assert {k: s for k, s in enumerate(found["status"]) if s} == {
        17: Status.DOMAIN,
        33: Status.QNORM,
    }
    assert np.all(found["value"][17] == UNTOUCHED) and np.all(found["jacobian"][33] == UNTOUCHED)


@pytest.mark.parametrize("suffix", ["_blocks", "_batch_nz"])
def test_null_pointers_and_counts(library: Library, suffix: str) -> None:
    """Every pointer in turn; a negative number of epochs."""
    function = FUNCTIONS["gps"]
    given = list(library.inputs(function, draw(function, 1, 0, library.real)).values())
    wide = [np.resize(array, (len(array), library.lanes(function))) for array in given]
    arguments: list[object] = [1]
    for array in wide:
        arguments += [np.ascontiguousarray(array), *([0] if suffix == "_batch_nz" else [])]
    outputs = [np.full(4000, -1.0, library.real) for _ in function.outputs]
    arguments += [*outputs, np.zeros(64, np.uint8)]
    for k, argument in enumerate(arguments):
        if isinstance(argument, np.ndarray):
            passed = [*arguments[:k], None, *arguments[k + 1 :]]
            assert library.call(f"gps{suffix}", passed) is Status.NULL
    assert library.call(f"gps{suffix}", [-1, *arguments[1:]]) is Status.COUNT
    assert all(np.all(output == -1.0) for output in outputs)
    assert library.call(f"gps{suffix}", [0, *arguments[1:]]) is Status.OK


@pytest.mark.parametrize("epochs", [0, 1, 33, 70])
@pytest.mark.parametrize("name", [name for name in SINGLE if name in SPARSE])
def test_batch_of_nonzeros(library: Library, name: str, epochs: int) -> None:
    """From rows to rows; epochs that fail are left alone."""
    function = FUNCTIONS[name]
    samples = _spoilt(library, name, epochs)
    found = library.batch(function, samples, nonzeros=True)
    expected = [library.evaluate(function, one, variant="_nz") for one in samples]
    assert list(found["status"]) == [one.status for one in expected]
    for output in function.outputs:
        for epoch, one in enumerate(expected if output.name in found.outputs else ()):
            row = found[output.name][epoch].ravel()
            if one.status is Status.OK:
                assert_array_equal(row, one[output.name])
            else:
                assert np.all(row == UNTOUCHED)


@pytest.mark.parametrize("n", [0, 3, 18])
@pytest.mark.parametrize("name", [name for name in MAPPED if name in SPARSE])
def test_batch_of_nonzeros_of_items(library: Library, name: str, n: int) -> None:
    """Columns are as long as there are items."""
    function = FUNCTIONS[name]
    samples = [draw(function, seed, n, library.real) for seed in range(9)]
    samples[2]["x"][1] = np.inf
    found = library.batch(function, samples, n, nonzeros=True)
    expected = [library.evaluate(function, one, n, variant="_nz") for one in samples]
    assert list(found["status"]) == [one.status for one in expected]
    for output in function.outputs:
        for epoch, one in enumerate(expected if output.name in found.outputs else ()):
            row = found[output.name][epoch]
            if one.status not in (Status.OK, Status.PARTIAL):
                assert np.all(row == UNTOUCHED)
            elif output.item and output.name.startswith("jacobian"):
                whole = one[output.name].reshape(len(output.entries), -1)
                assert_array_equal(row, whole[:, :n])
            else:
                assert_array_equal(row.ravel(), one[output.name][: row.size])
