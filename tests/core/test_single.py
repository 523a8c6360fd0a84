"""Numbers of single precision, against NumPy's."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from symnav import single

INFO = np.finfo(np.float32)
FINITE = st.floats(min_value=-single.LARGEST, max_value=single.LARGEST)


def test_ends() -> None:
    """The largest number and the smallest with all its digits."""
    assert float(INFO.max) == single.LARGEST and float(INFO.smallest_normal) == single.SMALLEST
    assert single.not_below(1e39) == math.inf and single.not_above(-1e39) == -math.inf
    assert single.not_above(1e39) == single.LARGEST == -single.not_below(-1e39)


@given(FINITE)
def test_neighbours(value: float) -> None:
    """Nearest and next are NumPy's; a number lies between those that are not beyond it."""
    number = np.float32(value)
    assert single.nearest(value) == float(number)
    if abs(float(number)) < single.LARGEST:
        for way in (True, False):
            towards = np.float32(math.inf if way else -math.inf)
            wanted = float(np.nextafter(number, towards))
            assert single.neighbour(float(number), upwards=way) == wanted
    low, high = single.not_above(value), single.not_below(value)
    assert low <= value <= high
    assert low == high or single.neighbour(low, upwards=True) == high
