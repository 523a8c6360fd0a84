"""A function guards the blocks it reads, and no others."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType

import numpy as np
import pytest


@pytest.mark.parametrize("backend", ["native", "numpy"])
def test_a_bad_value_elsewhere_is_not_its_business(
    generated: Callable[[str], ModuleType], backend: str
) -> None:
    package = generated("rover")
    function = getattr(package, backend).gps
    x = np.array(package.State.initial)
    expected = function(x)
    x[package.State.velocity] = np.nan
    assert np.array_equal(function(x).value, expected.value)
    many = function(np.stack([x, x]))
    assert np.array_equal(many.status, [0, 0])
    x[package.State.position.start] = np.nan
    with pytest.raises(package.GuardError, match=r"x\[0\] \(position x\) = nan"):
        function(x)
