"""SymPy alone: ``cse`` over values and non-zeros, printed as C."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import sympy as sp
from sympy.codegen.rewriting import create_expand_pow_optimization
from sympy.printing.c import C99CodePrinter

from benchmarks.contestants import derivatives
from benchmarks.contestants.contestant import Contestant, natural, symbol_of
from benchmarks.problems import Problem
from symnav.bench.candidate import Candidate, adapter


def contestants(problem: Problem, _folder: Path) -> Iterator[Contestant]:
    """One contestant, as far as plain differentiation reaches."""
    if not derivatives.reached(problem):
        return
    symbols, entries = derivatives.flat(problem)
    replacements, reduced = sp.cse(entries)
    expand = create_expand_pow_optimization(4)
    printer = C99CodePrinter()
    places = {symbol: sp.Symbol(f"in[{k}]") for k, symbol in enumerate(symbols)}

    def text(expression: sp.Expr) -> str:
        return str(printer.doprint(expand(expression.xreplace(places))))

    name = "sympy_cse"
    function = f"{problem.name}_{name}"
    lines = [f"    const double {left} = {text(right)};" for left, right in replacements]
    lines += [f"    out[{k}] = {text(entry)};" for k, entry in enumerate(reduced)]
    head = f"void {function}(const double in[restrict], double out[restrict])"
    symbol, order = symbol_of(problem, name), natural(problem)
    whole = ["#include <math.h>", f"{head};", head, "{", *lines, "}", ""]
    source = "\n".join(whole) + adapter(symbol, [f"{function}(in, out);"])
    candidate = Candidate(name=name, symbol=symbol, source=source, size=len(order), root=function)
    yield Contestant(
        problem=problem, candidate=candidate, order=order, text=source, functions=(function,)
    )
