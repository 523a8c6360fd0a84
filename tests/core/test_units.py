"""Units: reading, multiplying, printing; what is refused."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest

from symnav.errors import EquationError
from symnav.units import BASE, ONE, Unit, parse


def exponents(**powers: Fraction | int) -> Unit:
    """A unit from its base units by name."""
    return Unit(tuple(Fraction(powers.get(base, 0)) for base in BASE))


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("m", exponents(m=1)),
        ("1", ONE),
        ("rad", ONE),
        ("rad/s", exponents(s=-1)),
        ("m/s^2", exponents(m=1, s=-2)),
        ("m / s ^ 2", exponents(m=1, s=-2)),
        ("m*s^-2", exponents(m=1, s=-2)),
        ("m/s/s", exponents(m=1, s=-2)),
        ("m/s*kg", exponents(m=1, s=-1, kg=1)),
        ("m^1/2", exponents(m=Fraction(1, 2))),
        ("m/s^3/2", exponents(m=1, s=Fraction(-3, 2))),
        ("1/m", exponents(m=-1)),
        ("Hz", exponents(s=-1)),
        ("N", exponents(kg=1, m=1, s=-2)),
        ("N*m", exponents(kg=1, m=2, s=-2)),
        ("J", exponents(kg=1, m=2, s=-2)),
        ("W", exponents(kg=1, m=2, s=-3)),
        ("Pa", exponents(kg=1, m=-1, s=-2)),
        ("C", exponents(A=1, s=1)),
        ("V", exponents(kg=1, m=2, s=-3, A=-1)),
        ("T", exponents(kg=1, s=-2, A=-1)),
        ("N^2/kg", exponents(kg=1, m=2, s=-4)),
    ],
)
def test_reading(text: str, unit: Unit) -> None:
    """Products, quotients and powers of base and derived units; printing reads back."""
    assert parse(text) == unit
    assert parse(str(unit)) == unit


def test_algebra() -> None:
    """Products, quotients and powers."""
    metre, second = parse("m"), parse("s")
    assert metre / second == parse("m/s")
    assert (metre / second) * second == metre
    assert metre**2 / second**2 == (metre / second) ** 2
    assert (metre**2) ** Fraction(1, 2) == metre


@pytest.mark.parametrize(
    ("unit", "text"),
    [
        (ONE, "1"),
        (exponents(s=-1), "1/s"),
        (exponents(m=1, s=-2), "m/s^2"),
        (exponents(m=2, kg=1, s=-1), "m^2*kg/s"),
        (exponents(m=-1, s=-2), "1/m/s^2"),
    ],
)
def test_printing(unit: Unit, text: str) -> None:
    """As a person would write it."""
    assert str(unit) == text


@pytest.mark.parametrize(
    ("text", "advice"),
    [
        ("deg", "'rad'"),
        ("km", "'m'"),
        ("m/ms", "'s'"),
        ("g", "'m/s^2'"),
        ("furlong", "not known"),
        ("m^", "cannot be read"),
        ("", "cannot be read"),
        ("m//s", "cannot be read"),
        ("2m", "cannot be read"),
    ],
)
def test_refusals(text: str, advice: str) -> None:
    """The message names the unit to use."""
    with pytest.raises(EquationError, match=re.escape(advice)):
        parse(text)
