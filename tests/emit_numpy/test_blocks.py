"""Many epochs in blocks: their edges, failures in some of them, arrays that are given."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from symnav import ir
from tests.emit_numpy import modules, packages
from tests.emit_numpy.packages import backend, called
from tests.emit_numpy.test_values import assert_agrees

FUNCTIONS = {function.name: function for function in modules.module().functions}
BLOCK = 4


@pytest.fixture
def short(package: ModuleType, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The package with blocks of four epochs."""
    blocks = backend(package, "_blocks")
    monkeypatch.setattr(blocks, "LENGTH", 1)
    monkeypatch.setattr(blocks, "SHORTEST", BLOCK)
    return package


def outputs(result: Any) -> list[Any]:
    """The arrays of a result, statuses included."""
    return [np.asarray(array) for array in result]


@pytest.mark.parametrize("count", [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK, 2 * BLOCK + 1])
@pytest.mark.parametrize("name", FUNCTIONS)
def test_any_number_of_epochs(
    short: ModuleType, rng: np.random.Generator, name: str, count: int
) -> None:
    """Whole blocks and what is left over."""
    given = packages.arguments(FUNCTIONS[name], rng, count)
    result = called(getattr(short, name), given)
    assert result.status.shape == (count,)
    assert_agrees(FUNCTIONS[name], result, given)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_blocks_make_no_difference(
    package: ModuleType, rng: np.random.Generator, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same bits, however long a block is."""
    given = packages.arguments(FUNCTIONS[name], rng, 37)
    whole = outputs(called(getattr(package, name), given))
    for length in (1, 5, 36):
        monkeypatch.setattr(backend(package, "_blocks"), "LENGTH", length)
        monkeypatch.setattr(backend(package, "_blocks"), "SHORTEST", length)
        parts = outputs(called(getattr(package, name), given))
        assert all(np.array_equal(a, b) for a, b in zip(whole, parts, strict=True))


@pytest.mark.parametrize("bad", [(0,), (3, 4), (9,), (1, 5, 8), tuple(range(10))], ids=str)
def test_failures_stay_in_their_epochs(
    short: ModuleType, rng: np.random.Generator, bad: tuple[int, ...]
) -> None:
    """First and last of a block, several blocks, all of them; nothing else changes."""
    given = packages.arguments(FUNCTIONS["gps"], rng, 10)
    fine = called(short.gps, given)
    given["x"][list(bad), 2] = np.nan
    result = called(short.gps, given)
    failed = np.isin(np.arange(10), bad)
    assert result.status.tolist() == np.where(failed, ir.Status.RANGE, ir.Status.OK).tolist()
    for own, other in zip(result[:-1], fine[:-1], strict=True):
        assert np.isnan(own[failed]).all()
        assert np.array_equal(own[~failed], other[~failed])


@pytest.mark.parametrize("name", ["gps", "ranges", "strict", "frame_map"])
def test_given_arrays_keep_failed_epochs(
    short: ModuleType, rng: np.random.Generator, name: str
) -> None:
    """What fails in one block is untouched, and zeros are written everywhere else."""
    function = FUNCTIONS[name]
    given = packages.arguments(function, rng, 10)
    fine = called(getattr(short, name), given)
    given["x"][[3, 8], 0] = 1e9
    fields = [output.name for output in function.outputs]
    arrays = [np.full_like(getattr(fine, field), 777.0) for field in fields]
    result = called(getattr(short, name), given, out=tuple(arrays))
    failed = np.isin(np.arange(10), (3, 8))
    assert np.array_equal(result.status != 0, failed)
    for field, array in zip(fields, arrays, strict=True):
        assert getattr(result, field) is array
        assert (array[failed] == 777.0).all()
        assert np.array_equal(array[~failed], getattr(fine, field)[~failed])


def test_items_fail_in_their_blocks(short: ModuleType, rng: np.random.Generator) -> None:
    """A skipped item has a zero row, a rejected epoch none, in given arrays as well."""
    given = packages.arguments(FUNCTIONS["ranges"], rng, 9)
    fine = called(short.ranges, given)
    given["satellite"][2, 4, 0] = np.inf
    given["satellite"][8, 1, 2] = np.nan
    for arrays in (None, [np.full_like(a, 777.0) for a in fine[:3]]):
        result = called(short.ranges, given, out=arrays)
        assert result.status.tolist() == [0, 0, 7, 0, 0, 0, 0, 0, 7]
        assert np.argwhere(result.item_status).tolist() == [[2, 4], [8, 1]]
        good = result.item_status == 0
        assert (result.value[~good] == 0.0).all() and not result.jacobian[~good].any()
        assert np.array_equal(result.value[good], fine.value[good])
    assert called(short.strict, given).status.tolist() == [0, 0, 2, 0, 0, 0, 0, 0, 2]
    differences = called(short.ranges.single_difference, given, reference=1)
    assert differences.status.tolist() == [0, 0, 7, 0, 0, 0, 0, 0, ir.Status.RANGE]
    expected = np.delete(fine.value - fine.value[:, 1:2], 1, axis=1)
    assert np.array_equal(differences.value[[0, 1, 3]], expected[[0, 1, 3]])


def test_axes_broadcast_over_blocks(short: ModuleType, rng: np.random.Generator) -> None:
    """Shared arguments, axes of length one, and axes that only some arguments have."""
    x, arm = packages.states(rng, 4, 3), rng.uniform(-5.0, 5.0, size=(4, 3, 3))
    whole = short.gps(x, lever_arm=arm)
    assert whole.value.shape == (4, 3, 3)
    for own, other in (
        (x[:, :1], arm),
        (x[:1, :1], arm),
        (x[0, 0], arm),
        (x, arm[0]),
        (x[:, :1], arm[0]),
        (x, arm[:1, :1]),
        (x[:1], arm[:, :1]),
    ):
        result = short.gps(own, lever_arm=other)
        lead = np.broadcast_shapes(own.shape[:-1], other.shape[:-1])
        every = np.broadcast_to(own, (*lead, 13)), np.broadcast_to(other, (*lead, 3))
        expected = short.gps(every[0].copy(), lever_arm=every[1].copy())
        assert result.status.shape == lead
        assert all(
            np.array_equal(a, b) for a, b in zip(outputs(result), outputs(expected), strict=True)
        )


def test_a_bad_shared_argument_fails_every_epoch(
    short: ModuleType, rng: np.random.Generator
) -> None:
    """In every block; ranges of all arguments are reported before norms, as in the C."""
    x = packages.states(rng, 9)
    x[5, 3:7] *= 1.05
    result = short.gps(x, lever_arm=(11.0, 0.0, 0.0))
    assert result.status.tolist() == [ir.Status.RANGE] * 9
    assert np.isnan(result.value).all()
    result = short.gps(x, lever_arm=(9.0, 0.0, 0.0))
    assert result.status.tolist() == [ir.Status.OK] * 5 + [ir.Status.QNORM] + [ir.Status.OK] * 3
    result = short.gps(x[0] * np.nan, lever_arm=np.tile((99.0, 0.0, 0.0), (9, 1)))
    assert result.status.tolist() == [ir.Status.RANGE] * 9


def test_quick_guards_decide_like_close_ones(short: ModuleType, rng: np.random.Generator) -> None:
    """Norms within a few roundings of the tolerance, ranges at their very ends."""
    x = packages.states(rng, 400)
    scale = np.sqrt(1.0 + 1e-6 * (1.0 + rng.uniform(-3e-9, 3e-9, size=400)))
    x[:, 3:7] *= scale[:, None]
    w, i, j, k = x[:, 3:7].T
    bad = np.abs(w * w + i * i + j * j + k * k - 1.0) > 1e-6
    assert 50 < bad.sum() < 350
    result = short.gps(x, lever_arm=(1.0, 2.0, 3.0))
    assert np.array_equal(result.status == ir.Status.QNORM, bad)
    x = packages.states(rng, 3)
    x[:, 0] = (1e5, -1e5, np.nextafter(1e5, np.inf))
    assert short.gps(x, lever_arm=(10.0, -10.0, 1.0)).status.tolist() == [0, 0, 2]


@pytest.mark.parametrize("name", ["gps", "ranges", "frame_map", "operations"])
def test_complex_steps_run_in_blocks(
    short: ModuleType, rng: np.random.Generator, name: str
) -> None:
    """Imaginary parts in blocks as epoch by epoch; a failure is NaN there as well."""
    given = packages.arguments(FUNCTIONS[name], rng, 9)
    first = next(iter(given))
    given[first] = given[first] + 1e-40j
    bad = np.zeros(9, dtype=bool)
    bad[6] = True
    given[first][6] = np.nan
    result = called(getattr(short, name), given)
    assert np.array_equal(result.status != 0, bad)
    for epoch in np.flatnonzero(~bad):
        single = called(getattr(short, name), {k: v[epoch : epoch + 1] for k, v in given.items()})
        assert np.array_equal(result[0][epoch], single[0][0])
    assert np.isnan(result[0][6]).all() and result[0].dtype == np.complex128


def test_blocks_agree_with_jax(short: ModuleType, rng: np.random.Generator) -> None:
    """Failures in different blocks, against the same kernel traced as a whole."""
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    given = packages.arguments(FUNCTIONS["ranges"], rng, 10)
    given["satellite"][4, 2] = np.nan
    given["x"][9, 3] = 2.0
    own = called(short.ranges, given)
    other = jax.jit(lambda values: called(short.ranges, values))(
        {name: jax.numpy.asarray(value) for name, value in given.items()}
    )
    for left, right in zip(own, other, strict=True):
        assert np.asarray(right) == pytest.approx(left, rel=1e-13, abs=1e-12, nan_ok=True)


def test_bound_calls_see_new_numbers_in_every_block(
    short: ModuleType, rng: np.random.Generator
) -> None:
    """Numbers that change between calls, outputs that stay."""
    x, arm = packages.states(rng, 9), rng.uniform(-3.0, 3.0, size=(9, 3))
    numpy = backend(short, "numpy")
    run = numpy.gps.bind(x, lever_arm=arm)
    first = run()
    before = first.value.copy()
    x[7, 0] += 5.0
    again = run()
    assert again.value is first.value
    assert (again.value - before)[7, 0] == pytest.approx(5.0)
    assert np.array_equal(np.delete(again.value, 7, axis=0), np.delete(before, 7, axis=0))


def test_given_arguments_are_not_changed(short: ModuleType, rng: np.random.Generator) -> None:
    """Strides, order and read-only memory of arguments are the caller's."""
    x, arm = packages.states(rng, 9), rng.uniform(-3.0, 3.0, size=(9, 3))
    expected = outputs(short.gps(x, lever_arm=arm))
    x.flags.writeable = arm.flags.writeable = False
    for own in (x, np.asfortranarray(x), np.repeat(x, 2, axis=0)[::2], x[::-1].copy()[::-1]):
        kept = own.copy()
        found = outputs(short.gps(own, lever_arm=arm))
        assert all(np.array_equal(a, b) for a, b in zip(found, expected, strict=True))
        assert np.array_equal(own, kept)


def test_plans_follow_the_shapes(package: ModuleType, rng: np.random.Generator) -> None:
    """Other numbers of epochs and items, other types and orders of names, one after another."""
    given = {n: packages.arguments(FUNCTIONS["ranges"], rng, n, items=n + 1) for n in (1, 3, 7)}
    expected = {n: called(package.ranges, given[n]) for n in given}
    for n in (3, 1, 7, 3):
        backwards = dict(reversed(given[n].items()))
        narrow = {**given[n], "x": given[n]["x"].astype(np.float32)}
        assert called(package.ranges, narrow).value.shape == (n, n + 1)
        for own in (given[n], backwards):
            found = called(package.ranges, own)
            pairs = zip(outputs(found), outputs(expected[n]), strict=True)
            assert all(np.array_equal(a, b) for a, b in pairs)
    with pytest.raises(ValueError, match=r"but \w+ has n"):
        called(package.ranges, {**given[3], "slot": given[1]["slot"]})


def test_a_known_shape_is_planned_once(
    package: ModuleType, rng: np.random.Generator, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The second call decides nothing; more shapes than are kept are planned again."""
    blocks, arrays = backend(package, "_blocks"), backend(package, "_arrays")
    planned: list[int] = []
    original = blocks.Blocks.plan

    def plan(self: Any, part: Any, given: Any, extent: Any, *more: Any) -> Any:
        planned.append(extent.batch[0])
        return original(self, part, given, extent, *more)

    monkeypatch.setattr(blocks.Blocks, "plan", plan)
    monkeypatch.setattr(arrays, "_MOST_PLANS", 2)
    for count in (11, 11, 12, 11, 13, 13, 11):
        given = packages.arguments(FUNCTIONS["gps"], rng, count)
        assert called(package.gps, given).value.shape == (count, 3)
    assert planned == [11, 12, 13, 11]
    both = rng.uniform(1.0, 2.0, size=14)
    for _ in range(2):
        result = package.operations(a=both, b=both)
        assert_agrees(FUNCTIONS["operations"], result, {"a": both, "b": both})


def test_elements_are_inside_their_ranges_where_norms_are_good(
    short: ModuleType, rng: np.random.Generator
) -> None:
    """Ranges that follow from a norm are still guarded: NaN, infinities, and what is too long."""
    for element in range(9):
        given = packages.arguments(FUNCTIONS["frame_map"], rng, 6)
        for epoch, value in ((1, np.nan), (3, np.inf), (5, 1.5)):
            given["turn"][epoch, element] = value
        expected = [0, ir.Status.RANGE, 0, ir.Status.RANGE, 0, ir.Status.RANGE]
        assert called(short.frame_map, given).status.tolist() == expected
    for element in range(3, 7):
        given = packages.arguments(FUNCTIONS["gps"], rng, 6)
        given["x"][[1, 4], element] = np.nan, -1.5
        expected = [0, ir.Status.RANGE, 0, 0, ir.Status.RANGE, 0]
        assert called(short.gps, given).status.tolist() == expected


def test_every_defect_of_a_matrix_is_seen(short: ModuleType, rng: np.random.Generator) -> None:
    """The quick guards compute what the close ones do, and each defect alone is refused."""
    tables, explain = backend(short, "_tables"), backend(short, "_explain")
    rows = rng.normal(size=(9, 5))
    found = np.empty((7, 5))
    tables._matrix_defects(rows, found)
    expected = explain.norm_defects(backend(short, "_runtime").Kind.MATRIX, list(rows))
    assert np.abs(found[[0, 3, 1, 4, 5, 6]]) == pytest.approx(np.array(expected), rel=1e-12)
    for place, change in ((0, 1e-5), (4, 1e-5), (3, 1e-5), (8, -1e-5), (2, 1e-5), (5, 1e-5)):
        given = packages.arguments(FUNCTIONS["frame_map"], rng, 6)
        given["turn"][4] = np.eye(3).reshape(9)
        given["turn"][4, place] += change
        status = called(short.frame_map, given).status
        assert status[4] in (ir.Status.QNORM, ir.Status.RANGE)
        assert not np.delete(status, 4).any()
