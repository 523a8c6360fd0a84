"""CasADi's own code generation: automatic differentiation, and SymPy's derivatives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import casadi as ca

from benchmarks.contestants import derivatives
from benchmarks.contestants.contestant import Contestant, natural, symbol_of
from benchmarks.contestants.single import mended
from benchmarks.problems import Functions, Problem
from symnav.bench.candidate import Candidate, adapter
from symnav.lower.casadi_bridge import to_casadi

FUNCTIONS = Functions(ca.sqrt, ca.sin, ca.cos)


def contestants(problem: Problem, _folder: Path) -> Iterator[Contestant]:
    """Each derivation with and without common-subexpression elimination."""
    automatic = automatically(problem)
    yield _contestant(problem, "casadi", *_shared(*automatic))
    yield _contestant(problem, "casadi_nocse", *automatic)
    if derivatives.reached(problem):
        symbolic = symbolically(problem)
        yield _contestant(problem, "casadi_sym", *_shared(*symbolic))
        yield _contestant(problem, "casadi_sym_nocse", *symbolic)


def in_single(problem: Problem) -> Iterator[Contestant]:
    """What CasADi writes when floats are asked for, and the same with literals and calls mended.

    Its literals and its calls of the mathematics library stay those of doubles.
    """
    derived = {"casadi": _shared(*automatically(problem))}
    if derivatives.reached(problem):
        derived["casadi_sym"] = _shared(*symbolically(problem))
    for name, found in derived.items():
        comes = _contestant(problem, name, *found, real="float")
        yield comes
        yield mended(comes, f"{name}_mended")


def automatically(problem: Problem) -> tuple[ca.SX, ca.SX]:
    """The flat inputs; values and non-zeros differentiated through the moved quaternion."""
    record = ca.SX.sym("x", problem.record)
    error = ca.SX.sym("d", problem.columns)
    given = problem.split(ca.vertsplit(record))
    value = ca.vertcat(*problem.equation(given, FUNCTIONS))
    moved = problem.moved(given, ca.vertsplit(error))
    slopes = ca.jacobian(ca.vertcat(*problem.equation(moved, FUNCTIONS)), error)
    slopes = ca.substitute(slopes, error, ca.SX.zeros(problem.columns))
    chosen = [slopes[row, column] for row, column in problem.pattern]
    return record, ca.vertcat(value, *chosen)


def symbolically(problem: Problem) -> tuple[ca.SX, ca.SX]:
    """The same with SymPy's derivatives."""
    symbols, entries = derivatives.flat(problem)
    record = ca.SX.sym("x", len(symbols))
    table = dict(zip(symbols, ca.vertsplit(record), strict=True))
    return record, ca.vertcat(*(to_casadi(entry, table) for entry in entries))


def _shared(record: ca.SX, result: ca.SX) -> tuple[ca.SX, ca.SX]:
    return record, ca.cse(result)


def _contestant(
    problem: Problem, name: str, record: ca.SX, result: ca.SX, real: str = "double"
) -> Contestant:
    function = f"{problem.name}_{name}"
    values = problem.rows
    sizes: Sequence[int] = [size for size in problem.sizes.values() if size]
    parts = [ca.SX.sym(f"a{k}", size) for k, size in enumerate(sizes)]
    named = ca.Function("whole", [record], [result[:values], result[values:]])
    outputs = named(ca.vertcat(*parts))
    generator = ca.CodeGenerator(f"{function}.c", {"casadi_int": "int", "casadi_real": real})
    generator.add(ca.Function(function, parts, list(outputs)))
    body = [
        f"const {real} *arguments[{len(parts)}] = "
        f"{{{', '.join(f'in + {offset}' for offset in _starts(sizes))}}};",
        f"{real} *results[2] = {{out, out + {values}}};",
        f"(void){function}(arguments, results, 0, 0, 0);",
    ]
    symbol, order = symbol_of(problem, name), natural(problem)
    called = adapter(symbol, body).replace("double", real)
    source = f"{generator.dump()}\n{called}"
    candidate = Candidate(name=name, symbol=symbol, source=source, size=len(order), root=function)
    return Contestant(
        problem=problem, candidate=candidate, order=order, text=source, functions=("casadi_f0",)
    )


def _starts(sizes: Sequence[int]) -> list[int]:
    starts, at = [], 0
    for size in sizes:
        starts.append(at)
        at += size
    return starts
