"""The forms of WarpTwin's class: places of the non-zeros, both readings, what is refused."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from examples.warpos.gps_measurements import GPSMeasurements

Array = NDArray[np.float64]
Call = Callable[..., tuple[int, Array, Array]]

ROOT = Path(__file__).parents[2]
GENERATED = ROOT / "generated" / "warpos_gps" / "c"
INCLUDES = [GENERATED / "include", GENERATED / "src", ROOT / "examples" / "warpos"]
WARNINGS = ["-O1", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
UNTOUCHED = -7.0
INDEX, RANGE, QNORM = 6, 2, 4

PLACES = [(3, 0), (7, 0), (7, 2), (7, 4), (15, 4), (15, 12), (40, 0), (40, 19), (40, 37)]
"""Lengths of the state and starts of the position, square Jacobian and both ends among them."""


def compiled(language: str, folder: Path) -> Any:
    """The shared library of one language's form."""
    compiler, standard, suffix = {
        "c": ("gcc", "-std=c99", "c"),
        "c++": ("g++", "-std=c++17", "cpp"),
    }[language]
    if shutil.which(compiler) is None:
        pytest.skip(f"needs {compiler}")
    shim = Path(__file__).with_name(f"warpos_shim.{suffix}")
    objects = [str(folder / f"{path.stem}.o") for path in sorted(GENERATED.glob("src/*.c"))]
    include = [f"-I{path}" for path in INCLUDES]
    library = folder / "form.so"
    for path, target in zip(sorted(GENERATED.glob("src/*.c")), objects, strict=True):
        plain = ["gcc", "-std=c99", "-fPIC", *include, "-c", str(path), "-o", target]
        subprocess.run(plain, check=True)
    command = [compiler, standard, *WARNINGS, "-fPIC", "-shared", *include, str(shim), *objects]
    command += ["-o", str(library)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return ctypes.CDLL(str(library))


def foreign(library: Any) -> Call:
    """Calls a compiled form like the Python one."""

    def doubles(array: Array) -> Any:
        return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))

    def call(
        n: int, indices: tuple[int, int, int], order: str, rotate: bool, x: Array, q: Array
    ) -> tuple[int, Array, Array]:
        value, jacobian = np.full(3, UNTOUCHED), np.full(3 * n, UNTOUCHED)
        library.both.restype = ctypes.c_int16
        status = library.both(
            ctypes.c_uint32(n), (ctypes.c_uint32 * 3)(*indices), int(order == "column"),
            int(rotate), doubles(x), doubles(q), doubles(value), doubles(jacobian),
        )  # fmt: skip
        return int(status), value, jacobian

    return call


def in_python(
    n: int, indices: tuple[int, int, int], order: Any, rotate: bool, x: Array, q: Array
) -> tuple[int, Array, Array]:
    """Calls the Python form."""
    model = GPSMeasurements(n, *indices, order=order, rotate_to_ref=rotate)
    value, jacobian = np.full(3, UNTOUCHED), np.full(3 * n, UNTOUCHED)
    status = model.calculate_measurements(0.0, x, q, value)
    again = model.calculate_measurements_matrix(0.0, x, q, jacobian)
    assert isinstance(status, np.int16) and isinstance(again, np.int16)
    assert status == again
    return int(status), value, jacobian


@pytest.fixture(scope="module", params=["python", "c", "c++"])
def form(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Call:
    """One of the three forms."""
    if request.param == "python":
        return in_python
    return foreign(compiled(request.param, tmp_path_factory.mktemp("warpos")))


def drawn(n: int) -> tuple[Array, Array]:
    """A state and an observer's quaternion without any symmetry."""
    rng = np.random.default_rng(n)
    q = rng.standard_normal(4)
    return rng.uniform(-7e6, 7e6, n), q / np.linalg.norm(q)


@pytest.mark.parametrize(("n", "start"), PLACES)
def test_ones_by_row(form: Call, n: int, start: int) -> None:
    """Read literally: the position itself, ones at i N + start + i, nothing else."""
    x, q = drawn(n)
    status, value, jacobian = form(n, (start, 0, 0), "row", False, x, q)
    assert status == 0
    np.testing.assert_array_equal(value, x[start : start + 3])
    assert set(np.flatnonzero(jacobian)) == {i * n + start + i for i in range(3)}
    assert set(jacobian) == {0.0, 1.0} if n > 1 else {1.0}


@pytest.mark.parametrize(("n", "start"), PLACES)
def test_ones_by_column(form: Call, n: int, start: int) -> None:
    """By column the ones stand at 3 (start + i) + i."""
    x, q = drawn(n)
    status, _, jacobian = form(n, (start, 0, 0), "column", False, x, q)
    assert status == 0
    assert set(np.flatnonzero(jacobian)) == {(start + i) * 3 + i for i in range(3)}


@pytest.mark.parametrize("order", ["row", "column"])
@pytest.mark.parametrize(("n", "start"), PLACES)
def test_turned_to_the_receiver(form: Call, n: int, start: int, order: str) -> None:
    """The other reading: value and columns turned by the transpose of quat_F_REF.

    The block is not symmetric, so that the order shows even where the Jacobian is square.
    """
    x, q = drawn(n)
    to_state = Rotation.from_quat(np.roll(q, -1)).as_matrix()
    status, value, jacobian = form(n, (start, 0, 0), order, True, x, q)
    assert status == 0
    np.testing.assert_allclose(value, to_state.T @ x[start : start + 3], rtol=0, atol=4e-9)
    expected = np.zeros((3, n))
    expected[:, start : start + 3] = to_state.T
    flat = expected.ravel("C" if order == "row" else "F")
    np.testing.assert_allclose(jacobian, flat, rtol=0, atol=4e-16)


def test_observer_is_not_read(form: Call) -> None:
    """In the state's frame any observer will do, even one that is no rotation."""
    x, _ = drawn(15)
    status, value, _ = form(15, (4, 0, 0), "row", False, x, np.full(4, np.nan))
    assert status == 0
    np.testing.assert_array_equal(value, x[4:7])


@pytest.mark.parametrize("rotate", [False, True])
def test_other_elements_are_not_read(form: Call, rotate: bool) -> None:
    """What the filter keeps elsewhere in its state does not matter."""
    x, q = drawn(15)
    x[[0, 3, 7, 14]] = np.inf, np.nan, 1e300, -1e300
    assert form(15, (4, 0, 0), "row", rotate, x, q)[0] == 0


@pytest.mark.parametrize("rotate", [False, True])
def test_status_of_a_bad_state(form: Call, rotate: bool) -> None:
    """A position that is not a number gives a status, and outputs stay untouched."""
    x, q = drawn(7)
    x[3] = np.nan
    status, value, jacobian = form(7, (2, 0, 0), "row", rotate, x, q)
    assert status == RANGE
    assert set(value) == set(jacobian) == {UNTOUCHED}


def test_status_of_a_bad_observer(form: Call) -> None:
    """So does a quaternion that is not of unit norm."""
    x, q = drawn(7)
    status, value, jacobian = form(7, (2, 0, 0), "row", True, x, 0.9 * q)
    assert status == QNORM
    assert set(value) == set(jacobian) == {UNTOUCHED}


@pytest.mark.parametrize(
    ("n", "indices", "name"),
    [
        (7, (5, 0, 0), "state_pos_index"),
        (3, (1, 0, 0), "state_pos_index"),
        (7, (7, 0, 0), "state_pos_index"),
        (7, (2**32 - 2, 0, 0), "state_pos_index"),
        (7, (2, 1, 0), "observer_quat_index"),
        (7, (2, 0, 1), "meas_pos_index"),
        (7, (2, 0, 3), "meas_pos_index"),
    ],
)
def test_refused_indices(form: Call, n: int, indices: tuple[int, int, int], name: str) -> None:
    """Indices that leave no room: an exception in Python, a status elsewhere."""
    x, q = drawn(n)
    if form is in_python:
        with pytest.raises(ValueError, match=name):
            form(n, indices, "row", False, x, q)
        return
    status, value, jacobian = form(n, indices, "row", False, x, q)
    assert status == INDEX
    assert set(value) == set(jacobian) == {UNTOUCHED}


def test_python_refuses_other_arguments() -> None:
    """A short state, a negative start and an unknown order are named."""
    with pytest.raises(ValueError, match="state_pos_index"):
        GPSMeasurements(7, -1)
    with pytest.raises(ValueError, match="order"):
        GPSMeasurements(7, 2, order="diagonal")  # type: ignore[arg-type]  # what is refused
    model = GPSMeasurements(7, 2)
    with pytest.raises(ValueError, match=r"tar_state: expected \(7,\), got \(6,\)"):
        model.calculate_measurements(0.0, np.zeros(6), np.zeros(4), np.zeros(3))
