"""Norms that are close to one bound the elements, and are never off: on the compiled helpers."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from symnav import ir
from symnav.emit import c
from symnav.emit.c.judging import _SPACINGS
from tests.emit_c import modules
from tests.emit_c.building import argument, domain, function, output
from tests.emit_c.harness import write_package

Array = NDArray[Any]
KINDS: dict[ir.Scalar, type[np.floating[Any]]] = {
    ir.Scalar.FLOAT: np.float32,
    ir.Scalar.DOUBLE: np.float64,
}
SIZES = {"quaternion": 4, "matrix": 9}

JUDGED = """
#include <stdio.h>
#include "%(prefix)s_check.h"

int main(void)
{
    %(prefix)s_real_t m[%(size)d + 1];

    while (fread(m, sizeof m, 1, stdin) == 1U) {
        const unsigned char verdict[2] = {
            (unsigned char)is_near_%(kind)s(%(elements)s),
            (unsigned char)(is_skewed_%(kind)s(%(elements)s) != 0U),
        };
        (void)fwrite(verdict, sizeof verdict, 1, stdout);
    }
    return 0;
}
"""


def judged(folder: Path, scalar: ir.Scalar, kind: str, given: Array) -> tuple[Array, Array]:
    """What the helpers say of rows of elements with a tolerance behind them: near, skewed."""
    module = modules.module(*modules.all_functions(), scalar=scalar)
    package = write_package(folder, module)
    prefix = next((package / "c/src").glob("*_check.h")).name.removesuffix("_check.h")
    size = SIZES[kind]
    elements = ", ".join(f"m[{k}]" for k in range(size + 1))
    text = JUDGED % {"prefix": prefix, "size": size, "kind": kind, "elements": elements}
    (folder / "main.c").write_text(text, encoding="utf-8")
    include = [f"-I{package}/c/include", f"-I{package}/c/src"]
    command = ["gcc", "-std=gnu99", "-O2", "-march=native", *include, "main.c", "-lm", "-o", "main"]
    subprocess.run(command, cwd=folder, check=True)
    done = subprocess.run(
        [str(folder / "main")], input=given.tobytes(), capture_output=True, check=True
    )
    verdicts = np.frombuffer(done.stdout, dtype=np.uint8).reshape(-1, 2).astype(bool)
    assert len(verdicts) == len(given)
    return verdicts[:, 0], verdicts[:, 1]


def almost(kind: str, rng: np.random.Generator, count: int, scalar: ir.Scalar) -> Array:
    """Rotations that are off by about their tolerance, in one element or in all; reflections."""
    spacing = np.finfo(KINDS[scalar]).eps
    quaternions = rng.normal(size=(count, 4))
    # Often along an axis, where one element is as large as it can be.
    quaternions[::3] *= np.eye(4)[rng.integers(4, size=len(quaternions[::3]))] + 1e-4
    quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
    exact = quaternions if kind == "quaternion" else matrices(quaternions)
    tolerance = 10.0 ** rng.uniform(np.log10(_SPACINGS * spacing), -0.01, count)
    tolerance[::2] = 1e-5
    moved = rng.normal(size=exact.shape)
    moved[::2] *= np.eye(exact.shape[1])[rng.integers(exact.shape[1], size=len(moved[::2]))]
    moved *= (tolerance * 10.0 ** rng.uniform(-1.5, 0.5, count))[:, None]
    elements = exact + moved
    elements[::41] *= -1.0
    elements[::43, -1] = np.nan
    elements[::47, 0] = np.inf
    return np.column_stack([elements, tolerance]).astype(KINDS[scalar])


def matrices(quaternions: Array) -> Array:
    """Rotation matrices by row, (count, 9)."""
    w, x, y, z = quaternions.T
    return np.column_stack(
        [
            *(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            *(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            *(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        ]
    )


@pytest.mark.skipif(not shutil.which("gcc"), reason="needs gcc")
@pytest.mark.parametrize("scalar", KINDS)
@pytest.mark.parametrize("kind", SIZES)
def test_what_is_near_is_inside_and_not_skewed(
    kind: str, scalar: ir.Scalar, tmp_path: Path
) -> None:
    """The bound is the declared one, 1 + tolerance, rounded as the header rounds it."""
    given = almost(kind, np.random.default_rng(5), 200_000, scalar)
    near, skewed = judged(tmp_path, scalar, kind, given)
    elements, tolerance = given[:, :-1], given[:, -1:]
    bound = (1.0 + tolerance.astype(float)).astype(KINDS[scalar])
    with np.errstate(invalid="ignore"):
        inside = np.all(np.abs(elements) <= bound, axis=1)
    assert inside[near].all()
    assert not skewed[near].any()
    # Neither is a matter of course: what is not near may be anything.
    assert 0.2 < near.mean() < 0.8
    for rest in (inside[~near], skewed[~near], ~inside[~near], ~skewed[~near]):
        assert rest.sum() > 1000
    if kind == "quaternion":
        return
    # A reflection is as orthonormal as a rotation.
    assert skewed[::41].all()


@pytest.mark.parametrize("scalar", KINDS)
@pytest.mark.parametrize(("spacings", "near"), [(1.0, False), (2.0 * _SPACINGS, True)])
def test_a_tolerance_of_roundings_has_every_element_looked_at(
    spacings: float, near: bool, scalar: ir.Scalar
) -> None:
    """What rounding takes from a norm is not room that the bound can spare."""
    tolerance = spacings * float(np.finfo(KINDS[scalar]).eps)
    attitude = domain(
        *("attitude", 0, "wxyz", 1.0 + tolerance), kind=ir.Kind.QUATERNION, tolerance=tolerance
    )
    value = output("value", (1,), [((0,), ir.Load("attitude", 0))])
    read = function("read", [argument(attitude)], outputs=(value,))
    text = "".join(c.emit(modules.module(read, scalar=scalar)).values())
    assert ("is_near_quaternion" in text) is near
    assert "is_skewed_quaternion" in text and "are_four_centred" in text
