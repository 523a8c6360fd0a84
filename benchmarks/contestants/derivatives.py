"""Values and non-zeros of a problem by SymPy's own differentiation, without any structure."""

from __future__ import annotations

from functools import cache

import sympy as sp

from benchmarks.problems import PROBLEMS, Functions, Problem

FUNCTIONS = Functions(sp.sqrt, sp.sin, sp.cos)


def reached(problem: Problem) -> bool:
    """True where plain differentiation takes seconds, not minutes."""
    return problem.items * problem.columns <= 32 * 7


def flat(problem: Problem) -> tuple[tuple[sp.Symbol, ...], tuple[sp.Expr, ...]]:
    """Symbols of the flat input record; values, then non-zeros by row."""
    return _flat(problem.name)


@cache
def _flat(name: str) -> tuple[tuple[sp.Symbol, ...], tuple[sp.Expr, ...]]:
    (problem,) = (p for p in PROBLEMS if p.name == name)
    symbols = sp.symbols(f"x0:{problem.record}", real=True)
    error = sp.symbols(f"d0:{problem.columns}", real=True)
    given = problem.split(symbols)
    values = problem.equation(given, FUNCTIONS)
    moved = problem.equation(problem.moved(given, error), FUNCTIONS)
    zero = dict.fromkeys(error, sp.Integer(0))
    slopes = [moved[row].diff(error[column]).subs(zero) for row, column in problem.pattern]
    return symbols, (*map(sp.sympify, values), *slopes)
