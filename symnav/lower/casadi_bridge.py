"""SymPy expressions to CasADi, node type by node type; a node that is not listed is refused.

Numbers keep their value: a float is never truncated, a rational becomes its nearest double.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import reduce

import casadi as ca
import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFalse, BooleanTrue

Table = Mapping[sp.Symbol, ca.SX]


def to_casadi(expression: sp.Basic, table: Table) -> ca.SX:
    """Convert an expression whose symbols all stand in ``table``.

    Raises:
        TypeError: for a node type the bridge does not know; it names the type.
    """
    for kind, convert in _CONVERTERS:
        if isinstance(expression, kind):
            return convert(expression, table)
    raise TypeError(f"no CasADi counterpart for {type(expression).__name__}: {expression}")


def _symbol(expression: sp.Symbol, table: Table) -> ca.SX:
    return table[expression]


def _number(expression: sp.Number, table: Table) -> ca.SX:
    return ca.SX(float(expression))


def _sum(expression: sp.Add, table: Table) -> ca.SX:
    """Terms added and subtracted, a positive one first, so that no sign costs an operation.

    A long sum is taken in pairs, one term of each sign where there are both: differences of
    products stand together as in a cross product, and the terms do not wait for each other. In a
    short one single terms come last for the same reason.
    """
    signed = [_signed(term) for term in _as_counted(expression.args)]
    if len(signed) == LONGEST_CHAIN:
        signed.sort(key=lambda pair: pair[1].is_Atom)
    above = [to_casadi(term, table) for sign, term in signed if sign > 0]
    below = [to_casadi(term, table) for sign, term in signed if sign < 0]
    if not above:
        return -_total(below)
    if len(signed) <= LONGEST_CHAIN:
        return reduce(lambda a, b: a - b, below, _total(above))
    pairs = min(len(above), len(below))
    paired = [a - b for a, b in zip(above[-pairs:], below, strict=False)] if pairs else []
    total = _total([*above[: len(above) - pairs], *paired])
    return total - _total(below[pairs:]) if len(below) > pairs else total


LONGEST_CHAIN = 3
"""Most terms that are added one after another."""


def _as_counted(terms: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Multiples of names in the order people count: ``a_10`` after ``a_9``; the rest stays.

    The elements of a vector are then summed alike.
    """
    named = [term for term in terms if term.as_coeff_Mul()[1].is_Symbol]
    named.sort(key=lambda term: _counting(term.as_coeff_Mul()[1].name))
    following = iter(named)
    return [next(following) if term in named else term for term in terms]


def _counting(name: str) -> list[tuple[str, int]]:
    """A name as letters and numbers in turn."""
    return [(letters, int(digits or 0)) for letters, digits in _RUNS.findall(name)]


_RUNS = re.compile(r"(\D*)(\d*)")


def _total(terms: Sequence[ca.SX]) -> ca.SX:
    """The sum of terms: a short one from the left, a long one by halves."""
    if len(terms) <= LONGEST_CHAIN:
        return reduce(lambda a, b: a + b, terms)
    half = len(terms) // 2
    return _total(terms[:half]) + _total(terms[half:])


def _signed(term: sp.Expr) -> tuple[int, sp.Expr]:
    coefficient = term.args[0] if term.is_Mul else term
    if coefficient.is_number and coefficient.is_negative:
        return -1, -term
    return 1, term


def _product(expression: sp.Mul, table: Table) -> ca.SX:
    """Factors above and below one division line."""
    sign, above, below = 1, [], []
    for factor in expression.args:
        if factor == -1:
            sign = -sign
        elif factor.is_Pow and factor.exp.is_number and factor.exp.is_negative:
            below.append(to_casadi(sp.Pow(factor.base, -factor.exp), table))
        else:
            above.append(to_casadi(factor, table))
    top = reduce(lambda a, b: a * b, above) if above else ca.SX(1.0)
    result = top / reduce(lambda a, b: a * b, below) if below else top
    return -result if sign < 0 else result


def _power(expression: sp.Pow, table: Table) -> ca.SX:
    base, exponent = to_casadi(expression.base, table), expression.exp
    if exponent.is_Integer and exponent > 0:
        return reduce(lambda a, b: a * b, [base] * int(exponent))
    if exponent == sp.Rational(1, 2):
        return ca.sqrt(base)
    if exponent.is_Rational and exponent.q == 2 and exponent > 0:
        whole = reduce(lambda a, b: a * b, [base] * int(exponent.p // 2))
        return whole * ca.sqrt(base)
    if exponent.is_number and exponent.is_negative:
        return 1.0 / to_casadi(sp.Pow(expression.base, -exponent), table)
    raise TypeError(f"no CasADi counterpart for the power {expression}")


def _call(function: Callable[..., ca.SX]) -> Callable[[sp.Basic, Table], ca.SX]:
    def convert(expression: sp.Basic, table: Table) -> ca.SX:
        return function(*(to_casadi(argument, table) for argument in expression.args))

    return convert


def _piecewise(expression: sp.Piecewise, table: Table) -> ca.SX:
    *branches, (last, condition) = expression.args
    assert condition == sp.true, "a piecewise expression ends in a branch for everything else"
    result = to_casadi(last, table)
    for value, condition in reversed(branches):
        result = ca.if_else(to_casadi(condition, table), to_casadi(value, table), result)
    return result


def _relation(expression: Relational, table: Table) -> ca.SX:
    a, b = (to_casadi(side, table) for side in expression.args)
    compare = {
        sp.StrictLessThan: lambda: a < b,
        sp.LessThan: lambda: a <= b,
        sp.StrictGreaterThan: lambda: b < a,
        sp.GreaterThan: lambda: b <= a,
        sp.Equality: lambda: a == b,
        sp.Unequality: lambda: a != b,
    }
    return compare[type(expression)]()


def _fold(function: Callable[[ca.SX, ca.SX], ca.SX]) -> Callable[[sp.Basic, Table], ca.SX]:
    def convert(expression: sp.Basic, table: Table) -> ca.SX:
        return reduce(function, (to_casadi(argument, table) for argument in expression.args))

    return convert


_CONVERTERS: tuple[tuple[type | tuple[type, ...], Callable[..., ca.SX]], ...] = (
    (sp.Symbol, _symbol),
    ((sp.Number, sp.NumberSymbol), _number),
    (sp.Add, _sum),
    (sp.Mul, _product),
    (sp.Pow, _power),
    (sp.sin, _call(ca.sin)),
    (sp.cos, _call(ca.cos)),
    (sp.tan, _call(ca.tan)),
    (sp.asin, _call(ca.asin)),
    (sp.acos, _call(ca.acos)),
    (sp.atan, _call(ca.atan)),
    (sp.atan2, _call(ca.atan2)),
    (sp.exp, _call(ca.exp)),
    (sp.log, _call(ca.log)),
    (sp.Abs, _call(ca.fabs)),
    (sp.floor, _call(ca.floor)),
    (sp.Min, _fold(ca.fmin)),
    (sp.Max, _fold(ca.fmax)),
    (sp.Piecewise, _piecewise),
    (Relational, _relation),
    (sp.And, _fold(ca.logic_and)),
    (sp.Or, _fold(ca.logic_or)),
    (sp.Not, _call(ca.logic_not)),
    (BooleanTrue, lambda _e, _t: ca.SX(1.0)),
    (BooleanFalse, lambda _e, _t: ca.SX(0.0)),
)
