"""SI units of quantities: parsed from a spec, multiplied by equations, printed in documentation.

The radian counts as dimensionless (an angle times a velocity is a velocity), so ``rad`` and ``1``
are the same dimension; degrees, kilometres and every other scaled unit are refused, because a
factor that nobody sees is how a unit error reaches flight.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from symnav.errors import EquationError

BASE = ("m", "kg", "s", "A", "K", "mol", "cd")
_DERIVED: dict[str, dict[str, int]] = {
    "1": {},
    "rad": {},
    "Hz": {"s": -1},
    "N": {"kg": 1, "m": 1, "s": -2},
    "Pa": {"kg": 1, "m": -1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
    "C": {"A": 1, "s": 1},
    "V": {"kg": 1, "m": 2, "s": -3, "A": -1},
    "T": {"kg": 1, "s": -2, "A": -1},
}
_SCALED = {
    "deg": "rad", "degree": "rad", "degrees": "rad", "arcsec": "rad", "rpm": "rad/s",
    "km": "m", "cm": "m", "mm": "m", "ft": "m", "nmi": "m",
    "ms": "s", "us": "s", "ns": "s", "min": "s", "h": "s", "g": "m/s^2", "mg": "m/s^2",
    "kt": "m/s", "knots": "m/s", "kmh": "m/s", "kph": "m/s",
    "ppm": "1", "percent": "1", "%": "1", "G": "T", "Gauss": "T",
}  # fmt: skip
_FACTOR = re.compile(r"([A-Za-z%]+|1)(?:\^(-?\d+)(?:/(\d+))?)?")


@dataclass(frozen=True, slots=True)
class Unit:
    """A product of powers of the SI base units, in the order of ``BASE``."""

    exponents: tuple[Fraction, ...]

    def __mul__(self, other: Unit) -> Unit:
        return Unit(tuple(a + b for a, b in zip(self.exponents, other.exponents, strict=True)))

    def __truediv__(self, other: Unit) -> Unit:
        return Unit(tuple(a - b for a, b in zip(self.exponents, other.exponents, strict=True)))

    def __pow__(self, power: Fraction | int) -> Unit:
        return Unit(tuple(a * power for a in self.exponents))

    def __str__(self) -> str:
        named = list(zip(BASE, self.exponents, strict=True))
        above = "*".join(_power(name, e) for name, e in named if e > 0)
        below = "/".join(_power(name, -e) for name, e in named if e < 0)
        return f"{above or '1'}/{below}" if below else above or "1"


def _power(name: str, exponent: Fraction) -> str:
    return name if exponent == 1 else f"{name}^{exponent}"


ONE = Unit((Fraction(0),) * len(BASE))


def parse(text: str) -> Unit:
    """Read a unit such as ``m``, ``rad/s``, ``m/s^2`` or ``m^1/2``, written with * / and ^.

    Raises:
        EquationError: for an unknown or scaled unit; the message names the SI unit to use.
    """
    result, divide = ONE, False
    for position, token in enumerate(re.split(r"([*/])(?!\d)", text.replace(" ", ""))):
        if position % 2:
            divide = token == "/"
            continue
        factor = _factor(token, text)
        result = result / factor if divide else result * factor
    return result


def _factor(token: str, text: str) -> Unit:
    match = _FACTOR.fullmatch(token)
    if match is None:
        raise EquationError(f"unit {text!r} cannot be read at {token!r}; write it like 'm/s^2'")
    name, above, below = match.groups()
    if name in _SCALED:
        raise EquationError(
            f"unit {text!r}: {name!r} is not an SI base unit; convert and declare {_SCALED[name]!r}"
        )
    if name in BASE:
        powers = {name: 1}
    elif name in _DERIVED:
        powers = _DERIVED[name]
    else:
        known = ", ".join([*BASE, *(key for key in _DERIVED if key != "1")])
        raise EquationError(f"unit {text!r}: {name!r} is not known; use products of {known}")
    power = Fraction(int(above or 1), int(below or 1))
    return Unit(tuple(Fraction(powers.get(base, 0)) for base in BASE)) ** power
