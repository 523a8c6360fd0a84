"""Sine and cosine of angles of a few turns, as the emitted C evaluates them itself.

A C library is free to give any neighbour of the true sine, so that the same source has other bits
on another target, and no compiler puts a call of it into vector registers. Angles of a navigation
state are within a few turns. For those, arithmetic alone is enough: it has the same bits wherever
IEEE 754 holds, takes no branch, and runs over items and epochs side by side.

The method is the classical one (W. J. Cody and W. Waite, Software Manual for the Elementary
Functions, 1980): the nearest whole number of quarter turns is taken away, with pi/2 in parts that
are short enough for their products to be exact, and polynomials give sine and cosine of what is
left. What rounding takes from that rest is carried along. Results are within one unit in the last
place; tests compare all single-precision angles between 2**-13 and ``LIMIT``.
"""

from __future__ import annotations

from dataclasses import dataclass

#: Angles are at most so large, in radians: ten half turns. A product of ``parts[0]`` and as many
#: quarter turns stays exact in both types, and so does the rest in single precision.
LIMIT = 32.0


@dataclass(frozen=True, slots=True)
class Coefficients:
    """What the method needs in one type.

    With t the square of the rest r, which is within pi/4 but for a rounding,

        sin r = r + r t (s0 + s1 t + ...)
        cos r = 1 - t/2 + t t (c0 + c1 t + ...)

    Attributes:
        quarters_per_radian: 2/pi.
        ones: a number whose neighbours are one apart: adding it and taking it away rounds to the
            nearest whole number, and four times it to the nearest multiple of four.
        parts: pi/2 as a sum; the products of all but the last with small whole numbers are exact.
        sine: s0, s1 ... of least largest relative error in sin r.
        cosine: c0, c1 ... of least largest error in cos r.
    """

    quarters_per_radian: float
    ones: float
    parts: tuple[float, float, float]
    sine: tuple[float, ...]
    cosine: tuple[float, ...]


DOUBLE = Coefficients(
    quarters_per_radian=0.6366197723675814,
    ones=1.5 * 2.0**52,
    parts=(1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21),
    sine=(
        -0.1666666666666663, 0.008333333333322108, -0.0001984126982958018,
        2.755731361800663e-06, -2.5050747215085692e-08, 1.589619740246635e-10,
    ),
    cosine=(
        0.0416666666666666, -0.0013888888888874125, 2.480158728948234e-05,
        -2.755731435237199e-07, 2.0875723278108346e-09, -1.1359648041096236e-11,
    ),
)  # fmt: skip
"""For IEEE 754 double precision: the polynomials are within 2**-56 of what they stand for."""

SINGLE = Coefficients(
    quarters_per_radian=0.6366197466850281,
    ones=1.5 * 2.0**23,
    parts=(1.5706787109375, 0.00011761486530303955, 9.92093629470503e-10),
    sine=(-0.16666655242443085, 0.00833216030150652, -0.00019515218446031213),
    cosine=(0.04166664555668831, -0.0013887366512790322, 2.4438380933133885e-05),
)
"""For IEEE 754 single precision: the polynomials are within 2**-26 of what they stand for."""
