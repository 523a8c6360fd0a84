"""Under ``__FRAMAC__`` the C says some things once more; what it computes must be the same."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from symnav import build, ir
from symnav.ir import Status
from tests.emit_c import modules
from tests.emit_c.harness import Library, load_extension, write_package
from tests.emit_c.samples import draw

FUNCTIONS = {function.name: function for function in modules.all_functions()}


@pytest.fixture(scope="module")
def proven(tmp_path_factory: pytest.TempPathFactory) -> Library:
    """The C that Frama-C analyses, compiled."""
    module = modules.module(*FUNCTIONS.values())
    package = write_package(tmp_path_factory.mktemp("proven"), module)
    changed = 0
    for file in Path(package).rglob("*.[ch]"):
        text = file.read_text(encoding="utf-8")
        file.write_text(text.replace("#ifdef __FRAMAC__", "#if 1"), encoding="utf-8")
        changed += text.count("#ifdef __FRAMAC__")
    assert changed > 7  # comparisons, norms, what is discarded, and copies
    return Library(load_extension(build.build(package)), "rover", np.float64)


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_what_is_proven_computes_what_flies(
    proven: Library, libraries: dict[ir.Scalar, Library], name: str
) -> None:
    """One epoch, in order and with every input spoilt in turn: statuses and bits."""
    function, flies = FUNCTIONS[name], libraries[ir.Scalar.DOUBLE]
    n = min(function.maximum or 0, 18)
    statuses = set()
    for seed in range(2):
        inputs = draw(function, seed, n, np.float64)
        for argument in function.arguments:
            size = inputs[argument.name].size
            # The first, the last and a middle one: an element of each end and of another item.
            places = sorted({0, size // 2, size - 1}) if size else [0]
            spoilt = () if argument.integer else (None, np.nan, np.inf, 1e300, -1e9, -0.0)
            for bad, where in product(spoilt, places):
                given = {key: array.copy() for key, array in inputs.items()}
                if bad is not None and size:
                    given[argument.name].flat[where] = bad
                one, other = (lib.evaluate(function, given, n) for lib in (flies, proven))
                assert one.status is other.status
                assert one.outputs.keys() == other.outputs.keys()
                for key, array in one.outputs.items():
                    assert_array_equal(array.view(np.uint8), other[key].view(np.uint8))
                statuses.add(one.status)
    assert statuses & {Status.OK, Status.PARTIAL}


@pytest.mark.parametrize("name", sorted(n for n, f in FUNCTIONS.items() if f.maximum is None))
def test_many_epochs_are_the_same(
    proven: Library, libraries: dict[ir.Scalar, Library], name: str
) -> None:
    """Blocks, which are checked first and copied afterwards."""
    function = FUNCTIONS[name]
    samples = [draw(function, seed, 0, np.float64) for seed in range(70)]
    first = next(argument.name for argument in function.arguments if not argument.integer)
    samples[33][first].flat[0] = np.nan
    one, other = (
        library.blocks(function, samples) for library in (libraries[ir.Scalar.DOUBLE], proven)
    )
    for key, array in one.outputs.items():
        assert_array_equal(array, other[key])
