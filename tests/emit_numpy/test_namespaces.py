"""Kernels over other libraries: JAX, and one that refuses all but the array API standard."""

from __future__ import annotations

import warnings
from types import ModuleType
from typing import Any

import array_api_strict
import numpy as np
import pytest

from tests.emit_numpy import modules, packages

FUNCTIONS = {function.name: function for function in modules.module().functions}


@pytest.fixture(scope="session")
def strict() -> Any:
    """The reference implementation of the array API standard."""
    return array_api_strict


@pytest.fixture(scope="session")
def jax() -> Any:
    """JAX in double precision."""
    found = pytest.importorskip("jax")
    found.config.update("jax_enable_x64", True)
    return found


def assert_same(other: Any, reference: Any) -> None:
    """Two results agree, whatever library they are in."""
    for name in reference._fields:
        own = np.asarray(getattr(other, name))
        expected = np.asarray(getattr(reference, name))
        assert own.shape == expected.shape, name
        assert own == pytest.approx(expected, rel=1e-13, abs=1e-12, nan_ok=True), name


@pytest.mark.parametrize("batch", packages.BATCHES, ids=str)
@pytest.mark.parametrize("name", FUNCTIONS)
def test_standard_namespace_is_enough(
    package: ModuleType,
    strict: Any,
    rng: np.random.Generator,
    name: str,
    batch: tuple[int, ...],
) -> None:
    """Nothing outside the standard is called, in any function."""
    given = packages.arguments(FUNCTIONS[name], rng, *batch)
    form = getattr(package, name)
    result = packages.called(form, {k: strict.asarray(v) for k, v in given.items()})
    assert all(isinstance(array, type(strict.asarray(0.0))) for array in result)
    assert_same(result, packages.called(form, given))


def test_standard_namespace_is_enough_for_the_other_forms(
    package: ModuleType, strict: Any, rng: np.random.Generator
) -> None:
    """Values, Jacobians, non-zeros, differences and complex steps."""
    given = packages.arguments(FUNCTIONS["ranges"], rng, 2)
    foreign = {k: strict.asarray(v) for k, v in given.items()}
    form = package.ranges
    for part in (form.jacobian, form.nonzeros):
        expected = packages.called(part, given)
        assert np.asarray(packages.called(part, foreign)) == pytest.approx(expected, rel=1e-14)
    assert_same(
        packages.called(form.single_difference, foreign, reference=1),
        packages.called(form.single_difference, given, reference=1),
    )
    a = np.array([0.5, -2.0])
    stepped = package.operations.value(a=strict.asarray(a + 1e-30j), b=strict.asarray(a))
    assert np.asarray(stepped[0]) == pytest.approx(
        package.operations.value(a=a + 1e-30j, b=a)[0], rel=1e-15
    )


def test_failures_are_reported_not_raised(
    package: ModuleType, strict: Any, rng: np.random.Generator
) -> None:
    """Another library may not know its values yet, so that one epoch reports like many."""
    arm = strict.asarray([99.0, 0.0, 0.0])
    result = package.gps(strict.asarray(packages.states(rng)), lever_arm=arm)
    assert int(result.status) == package.Status.RANGE
    assert np.isnan(np.asarray(result.value)).all()


@pytest.mark.parametrize("name", FUNCTIONS)
def test_jax_compiles_every_function(
    package: ModuleType, jax: Any, rng: np.random.Generator, name: str
) -> None:
    """Traced without values, run with them."""
    given = packages.arguments(FUNCTIONS[name], rng, 3)
    form = getattr(package, name)

    def run(arguments: dict[str, Any]) -> Any:
        return packages.called(form, arguments)

    reference = packages.called(form, given)
    compiled = jax.jit(run)({k: jax.numpy.asarray(v) for k, v in given.items()})
    assert type(compiled) is type(reference)
    assert_same(compiled, reference)


def test_jax_compiles_failures(package: ModuleType, jax: Any, rng: np.random.Generator) -> None:
    """Statuses come out of a compiled function."""
    given = packages.arguments(FUNCTIONS["ranges"], rng, 3)
    given["satellite"][0, 2] = np.nan
    given["x"][1, 3] = 2.0
    run = jax.jit(lambda arguments: packages.called(package.ranges, arguments).status)
    status = run({k: jax.numpy.asarray(v) for k, v in given.items()})
    assert status.tolist() == packages.called(package.ranges, given).status.tolist() == [7, 2, 0]


def test_jax_differentiates(package: ModuleType, jax: Any, rng: np.random.Generator) -> None:
    """Automatic differentiation of the value gives the generated Jacobian."""
    x = jax.numpy.asarray(packages.states(rng))
    arm = jax.numpy.asarray([1.0, -2.0, 0.5])
    slope = jax.jit(jax.jacfwd(lambda own: package.gps.value(x, lever_arm=own)[0]))(arm)
    expected = package.gps(np.asarray(x), lever_arm=np.asarray(arm)).jacobian_lever_arm
    assert np.asarray(slope) == pytest.approx(expected, rel=1e-14)


def test_what_is_written_to_is_of_numpy(
    package: ModuleType, strict: Any, jax: Any, rng: np.random.Generator
) -> None:
    """Arrays of another library are results, never written to; what is given is not ignored."""
    given = packages.arguments(FUNCTIONS["gps"], rng)
    out = [np.full_like(array, 7.0) for array in packages.called(package.gps, given)[:-1]]
    for asarray in (strict.asarray, jax.numpy.asarray):
        foreign = {name: asarray(value) for name, value in given.items()}
        with pytest.raises(TypeError, match="out: gps writes to it only from NumPy's arrays"):
            packages.called(package.gps, foreign, out=out)
        with pytest.raises(TypeError, match="bind: x must be a contiguous NumPy array"):
            packages.called(package.gps.bind, foreign)
    assert all((array == 7.0).all() for array in out)


def test_indices_of_other_libraries(
    package: ModuleType, strict: Any, jax: Any, rng: np.random.Generator
) -> None:
    """A half is no index there either, traced or not."""
    given = packages.arguments(FUNCTIONS["ranges"], rng)
    for asarray in (strict.asarray, jax.numpy.asarray):
        for index in (np.full(5, 0.5), np.zeros(5, bool)):
            foreign = {k: asarray(v) for k, v in {**given, "slot": index}.items()}
            with pytest.raises(TypeError, match=r"slot: expected integers, got .*(float64|bool)"):
                packages.called(package.ranges, foreign)
    with pytest.raises(TypeError, match="slot: expected integers"):
        jax.jit(lambda slot: packages.called(package.ranges, {**given, "slot": slot}).value)(
            jax.numpy.zeros(5)
        )


def test_libraries_mix(package: ModuleType, jax: Any, rng: np.random.Generator) -> None:
    """Lists and NumPy arrays follow the one array that belongs elsewhere."""
    x = packages.states(rng, 2)
    result = package.gps(x, lever_arm=jax.numpy.asarray([1.0, 2.0, 3.0]))
    assert isinstance(result.value, jax.Array)
    assert_same(result, package.gps(x, lever_arm=[1, 2, 3]))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        integers = package.gps(jax.numpy.asarray(x), lever_arm=jax.numpy.asarray([1, 2, 3]))
    assert_same(integers, package.gps(x, lever_arm=[1, 2, 3]))
