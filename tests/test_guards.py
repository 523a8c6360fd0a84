"""What a failed guard says: the one that failed, whichever back end met it."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

SPEC = """
name = "several"
[[state]]
name = "p"
kind = "vector"
size = 3
unit = "m"
range = [-10.0, 10.0]
[[state]]
name = "v"
kind = "vector"
size = 3
unit = "m"
range = [-10.0, 10.0]
[[input]]
name = "beacon"
size = 3
unit = "m"
range = [-100.0, 100.0]
item = true
[[measurement]]
name = "mixed"
equation = ["log(norm(v) / norm(p)) + sqrt(p[1] / v[2])"]
[[measurement]]
name = "ranges"
equation = ["norm(beacon - p) * (norm(v) / norm(p))"]
maximum = 4
items = "reject"
"""
BACKENDS = ("native", "numpy")


@pytest.fixture(scope="module")
def several(generated: Callable[[str | Path], ModuleType]) -> ModuleType:
    """Functions with several guards each, some of them with the same limits."""
    return generated(SPEC)


def backend(package: ModuleType, name: str) -> ModuleType:
    """One back end of a package."""
    return import_module(f"{package.__name__}.{name}")


@pytest.mark.parametrize("name", BACKENDS)
@pytest.mark.parametrize(
    ("p", "v", "guard", "found"),
    [
        ((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), "squared length", "0"),
        ((1.0, 2.0, 3.0), (0.0, 0.0, 0.0), "squared length", "0"),
        ((1.0, 2.0, 3.0), (1.0, 2.0, 0.0), "squared divisor of quotient", "0"),
        ((1.0, -2.0, 3.0), (1.0, 2.0, 4.0), "argument of root", "-0.5"),
    ],
)
def test_the_guard_that_failed(
    several: ModuleType,
    name: str,
    p: tuple[float, ...],
    v: tuple[float, ...],
    guard: str,
    found: str,
) -> None:
    """Its meaning, its limits and what was found; none of those that passed have other limits."""
    with pytest.raises(several.GuardError, match=r"^mixed: DOMAIN: ") as caught:
        backend(several, name).mixed(np.array([*p, *v]))
    message, error = str(caught.value), caught.value
    assert guard in message and message.count("must lie in") == 1
    assert message.endswith(f"; it is {found}")
    assert f"{error.value:g}" == found and not error.bounds[0] <= error.value
    limits = f"[{error.bounds[0]:g}, {error.bounds[1]:g}]"
    assert limits in message
    told = message.removeprefix("mixed: DOMAIN: ").partition(" must lie in")[0].split(" or ")
    same = {c.meaning for c in conditions(several) if (c.lower, c.upper) == error.bounds}
    assert set(told) == same


def conditions(package: ModuleType) -> Any:
    """What is known of the guards of the function with several."""
    found = import_module(f"{package.__name__}._interface").MIXED.conditions
    assert len({(c.lower, c.upper) for c in found}) > 1
    return found


@pytest.mark.parametrize("name", BACKENDS)
def test_the_item_that_failed(several: ModuleType, name: str) -> None:
    """The first one, where a bad item refuses the epoch."""
    beacons = np.array([[50.0, 0.0, 0.0], [1.0, 2.0, 3.0], [0.0, 50.0, 0.0]])
    with pytest.raises(several.GuardError, match=r"of item \[1\] must lie in") as caught:
        backend(several, name).ranges(np.array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]), beacon=beacons)
    assert caught.value.index == (1,)
    assert caught.value.value == 0.0
