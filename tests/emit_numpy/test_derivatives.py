"""Jacobians against complex steps through the generated values: the same file, no differences."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.emit_numpy import modules, packages

STEP = 1e-60


def by_state(package: ModuleType, name: str, given: dict[str, Any]) -> list[NDArray[np.float64]]:
    """Derivatives of the value along every direction of the error vector."""
    form = getattr(package, name).value
    columns = []
    for direction in range(modules.ERROR_SIZE):
        d = np.zeros(modules.ERROR_SIZE, dtype=complex)
        d[direction] = 1j * STEP
        moved = package.retract.value(given["x"], d=d)
        value = packages.called(form, {**given, "x": moved})
        value = value[0] if isinstance(value, tuple) else value
        columns.append(np.imag(value) / STEP)
    return columns


@pytest.mark.parametrize("batch", packages.BATCHES, ids=str)
@pytest.mark.parametrize("name", ["gps", "ranges", "frame_map"])
def test_state_jacobian(
    package: ModuleType, rng: np.random.Generator, name: str, batch: tuple[int, ...]
) -> None:
    """The Jacobian is the derivative of the value through the retract."""
    (function,) = (f for f in modules.module().functions if f.name == name)
    given = packages.arguments(function, rng, *batch)
    jacobian = packages.called(getattr(package, name).jacobian, given)
    jacobian = jacobian[0] if isinstance(jacobian, tuple) else jacobian
    expected = np.stack(by_state(package, name, given), axis=-1)
    assert jacobian == pytest.approx(expected, rel=1e-14, abs=1e-13)


def test_input_jacobian(package: ModuleType, rng: np.random.Generator) -> None:
    """The same with respect to an input."""
    x, arm = packages.states(rng, 4), rng.uniform(-3.0, 3.0, size=(4, 3))
    jacobian = package.gps(x, lever_arm=arm).jacobian_lever_arm
    for direction in range(3):
        step = arm + 1j * STEP * np.eye(3)[direction]
        value, length = package.gps.value(x, lever_arm=step)
        assert jacobian[..., direction] == pytest.approx(np.imag(value) / STEP, rel=1e-14)
        slope = arm[:, direction] / np.linalg.norm(arm, axis=-1)
        assert np.imag(length) / STEP == pytest.approx(slope, rel=1e-14)


def test_every_operation_carries_a_derivative(
    package: ModuleType, rng: np.random.Generator
) -> None:
    """The imaginary part of each operation is a central difference of its real part."""
    a, b = rng.uniform(-3.0, 3.0, size=(2, 50))
    for da, db in ((1.0, 0.0), (0.0, 1.0), (0.7, -0.4)):
        stepped = package.operations.value(a=a + 1j * STEP * da, b=b + 1j * STEP * db)
        value = package.operations(a=a, b=b).value
        assert np.real(stepped[0]) == pytest.approx(value, rel=1e-15)
        h = 1e-6
        ahead = package.operations(a=a + h * da, b=b + h * db).value
        behind = package.operations(a=a - h * da, b=b - h * db).value
        slope = (ahead - behind) / (2 * h)
        smooth = np.abs(slope) < 1e4
        assert smooth.mean() > 0.95
        exact = np.imag(stepped[0]) / STEP
        assert exact[smooth] == pytest.approx(slope[smooth], rel=1e-5, abs=1e-6)


@pytest.mark.parametrize("batch", [(), (3,)], ids=str)
def test_steps_need_arrays_that_hold_them(
    package: ModuleType, rng: np.random.Generator, batch: tuple[int, ...]
) -> None:
    """What is written to is complex as well; real arrays would lose the derivative."""
    x, arm = packages.states(rng, *batch), np.full((*batch, 3), 1.0 + 1e-40j)
    fresh = package.gps(x, lever_arm=arm)
    real = [np.full(array.shape, 7.0) for array in fresh[:-1]]
    with pytest.raises(ValueError, match=r"out: value must be complex128 of shape .* float64"):
        package.gps(x, lever_arm=arm, out=real)
    assert all((array == 7.0).all() for array in real)
    out = [np.full_like(array, 7.0) for array in fresh[:-1]]
    call = package.gps.bind(x, lever_arm=arm)
    for result in (package.gps(x, lever_arm=arm, out=out), call(), call()):
        assert np.imag(result.value).any()
        for one, other in zip(result[:-1], fresh[:-1], strict=True):
            assert np.array_equal(one, other)


def test_guards_look_at_real_parts(package: ModuleType, rng: np.random.Generator) -> None:
    """A step does not lead out of a range; a bad real part still fails."""
    x = packages.states(rng, 2).astype(complex)
    x[0, 0] = 1e5 + 1j
    x[1, 0] = 2e5 + 1j
    result = package.gps(x, lever_arm=(1.0, 2.0, 3.0))
    assert result.status.tolist() == [0, package.Status.RANGE]
    assert result.value.dtype == np.complex128
