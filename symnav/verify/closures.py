"""SymPy expressions as Python closures over any number system.

The witnesses evaluate equations with many digits or with gradients attached; both are number
systems with the same few functions, and neither shares code with the emitters.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from typing import Any, ClassVar, Protocol

import sympy as sp
from sympy.core.relational import Relational

Number = Any
Environment = dict[sp.Symbol, Number]
Closure = Callable[[Environment], Number]


class System(Protocol):
    """A number system: arithmetic by operators, the rest by these functions."""

    functions: ClassVar[Mapping[Any, Callable[..., Any]]]

    def number(self, value: sp.Expr) -> Number:
        """A literal."""

    def select(self, condition: Any, yes: Callable[[], Number], no: Callable[[], Number]) -> Number:
        """``yes`` where the condition holds, else ``no``."""


def closure(expression: sp.Basic, system: System) -> Closure:
    """Turn an expression into a function of an environment of symbols.

    Raises:
        TypeError: for a node type the number system has no function for.
    """
    if isinstance(expression, sp.Symbol):
        return lambda env: env[expression]
    if isinstance(expression, (sp.Number, sp.NumberSymbol)):
        literal = system.number(expression)
        return lambda env: literal
    if isinstance(expression, sp.Piecewise):
        return _piecewise(expression, system)
    arguments = [closure(argument, system) for argument in expression.args]
    if isinstance(expression, sp.Add):
        return lambda env: reduce(lambda a, b: a + b, [f(env) for f in arguments])
    if isinstance(expression, sp.Mul):
        return lambda env: reduce(lambda a, b: a * b, [f(env) for f in arguments])
    if isinstance(expression, sp.Pow):
        return _power(expression, arguments[0], system)
    if isinstance(expression, Relational):
        return _relation(expression, arguments)
    function = system.functions.get(type(expression))
    if function is None:
        raise TypeError(f"no function for {type(expression).__name__} in {expression}")
    return lambda env: function(*(f(env) for f in arguments))


def _power(expression: sp.Pow, base: Closure, system: System) -> Closure:
    exponent = expression.exp
    root = system.functions[sp.sqrt]
    if exponent.is_Integer:
        count = int(exponent)
        if count > 0:
            return lambda env: reduce(lambda a, b: a * b, [base(env)] * count)
        return lambda env: 1 / reduce(lambda a, b: a * b, [base(env)] * -count)
    if exponent == sp.Rational(1, 2):
        return lambda env: root(base(env))
    if exponent == sp.Rational(-1, 2):
        return lambda env: 1 / root(base(env))
    if exponent.is_Rational and exponent.q == 2:
        whole = int(exponent.p)
        return lambda env: root(base(env)) ** whole
    raise TypeError(f"no function for the power {expression}")


def _relation(expression: Relational, arguments: Sequence[Closure]) -> Closure:
    left, right = arguments
    compare: Mapping[type, Callable[[Number, Number], Any]] = {
        sp.StrictLessThan: lambda a, b: a < b,
        sp.LessThan: lambda a, b: a <= b,
        sp.StrictGreaterThan: lambda a, b: a > b,
        sp.GreaterThan: lambda a, b: a >= b,
        sp.Equality: lambda a, b: a == b,
        sp.Unequality: lambda a, b: a != b,
    }
    test = compare[type(expression)]
    return lambda env: test(left(env), right(env))


def _piecewise(expression: sp.Piecewise, system: System) -> Closure:
    *branches, (last, _) = expression.args
    result = closure(last, system)
    for value, condition in reversed(branches):
        result = _branch(closure(condition, system), closure(value, system), result, system)
    return result


def _branch(condition: Closure, yes: Closure, no: Closure, system: System) -> Closure:
    return lambda env: system.select(condition(env), lambda: yes(env), lambda: no(env))
