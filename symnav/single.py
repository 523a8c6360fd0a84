"""The numbers of single precision: which of them is nearest to a number, or next to it.

They are the 32-bit numbers of IEEE 754, which is what C calls ``float``. Everything is exact:
Python's numbers hold every one of them.
"""

from __future__ import annotations

import math
import struct

LARGEST = 3.4028234663852886e38
"""The largest finite number."""

SMALLEST = 2.0**-126
"""The smallest number above zero that has all its digits; those below are called subnormal."""


def nearest(value: float) -> float:
    """The number nearest to ``value``, with its sign where it becomes zero.

    Raises:
        OverflowError: when it is so large that it would become infinite.
    """
    (number,) = struct.unpack("<f", struct.pack("<f", value))
    return float(number)


def neighbour(number: float, *, upwards: bool) -> float:
    """The number next to one that single precision holds."""
    if number == 0.0:
        return 2.0**-149 if upwards else -(2.0**-149)
    (bits,) = struct.unpack("<i", struct.pack("<f", number))
    away = (number > 0.0) == upwards
    (stepped,) = struct.unpack("<f", struct.pack("<i", bits + (1 if away else -1)))
    return float(stepped)


def not_below(value: float) -> float:
    """The smallest finite number that is not below ``value``; infinity where there is none."""
    if value <= -LARGEST:
        return -LARGEST
    if value > LARGEST:
        return math.inf
    number = nearest(value)
    return number if number >= value else neighbour(number, upwards=True)


def not_above(value: float) -> float:
    """The largest finite number that is not above ``value``; -infinity where there is none."""
    return -not_below(-value)
