"""Both routes, node type by node type: what comes out computes what went in."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import casadi as ca
import pytest
import sympy as sp
from mpmath import mp, mpf

from symnav import ir
from symnav.binding import Origin
from symnav.derive import Derivation, DerivedOutput, Equation
from symnav.graph import Definition, Guard
from symnav.lower.casadi_bridge import to_casadi
from tests.core.interpreter import Interpreter, Result
from tests.core.specs import ROUTES, layout, vector

A, B, C = sp.symbols("a b c", real=True)
SYMBOLS = (A, B, C)
POINTS = [(0.7, -1.3, 2.9), (-0.4, 0.9, 0.3), (0.25, 0.25, 1.0)]
S = sp.Symbol("s0")

Meaning = Callable[[Any, Any, Any], Any]
UNEVALUATED = sp.Mul(sp.Rational(1, 3), sp.Add(A, B, evaluate=False), evaluate=False)
NODES: dict[str, tuple[sp.Basic, Meaning]] = {
    "symbol": (A, lambda a, b, c: a),
    "integer": (sp.Integer(7), lambda a, b, c: 7),
    "negative integer": (sp.Integer(-7), lambda a, b, c: -7),
    "rational": (sp.Rational(-2, 7), lambda a, b, c: mpf(-2 / 7)),
    "float": (sp.Float(2.9, 17), lambda a, b, c: mpf(2.9)),
    "floats are not truncated": (0.5 * A + 2.9, lambda a, b, c: a / 2 + mpf(2.9)),
    "small float": (6.5e-11 * A, lambda a, b, c: mpf(6.5e-11) * a),
    "pi": (sp.pi * A, lambda a, b, c: mpf(math.pi) * a),
    "sum": (A + B + C + 1, lambda a, b, c: a + b + c + 1),
    "difference": (A - B - C, lambda a, b, c: a - b - c),
    "negative sum": (-A - B, lambda a, b, c: -a - b),
    "sum with negative number": (A - 3, lambda a, b, c: a - 3),
    "sum of scaled": (2 * A - 3 * B - C / 2, lambda a, b, c: 2 * a - 3 * b - c / 2),
    "negated product": (C - A * B, lambda a, b, c: c - a * b),
    "opposite": (-A, lambda a, b, c: -a),
    "opposite product": (-A * B, lambda a, b, c: -a * b),
    "scaled product": (-5 * A * B, lambda a, b, c: -5 * a * b),
    "quotient": (A / C, lambda a, b, c: a / c),
    "quotient of products": (A * B / (C * (2 + A)), lambda a, b, c: a * b / (c * (2 + a))),
    "negative quotient": (-A / C, lambda a, b, c: -a / c),
    "reciprocal": (1 / C, lambda a, b, c: 1 / c),
    "unevaluated": (UNEVALUATED, lambda a, b, c: mpf(1 / 3) * (a + b)),
    "square": (B**2, lambda a, b, c: b * b),
    "cube": (-(B**3), lambda a, b, c: -b * b * b),
    "fifth power": (B**5, lambda a, b, c: b**5),
    "negative power": (B**-3, lambda a, b, c: b**-3),
    "root": (sp.sqrt(C), lambda a, b, c: mp.sqrt(c)),
    "reciprocal root": (1 / sp.sqrt(C), lambda a, b, c: 1 / mp.sqrt(c)),
    "three halves": (C ** sp.Rational(3, 2), lambda a, b, c: c * mp.sqrt(c)),
    "minus five halves": (C ** sp.Rational(-5, 2), lambda a, b, c: 1 / (c * c * mp.sqrt(c))),
    "sine": (sp.sin(A + B), lambda a, b, c: mp.sin(a + b)),
    "cosine": (sp.cos(A * B), lambda a, b, c: mp.cos(a * b)),
    "tangent": (sp.tan(A), lambda a, b, c: mp.tan(a)),
    "arcsine": (sp.asin(A), lambda a, b, c: mp.asin(a)),
    "arccosine": (sp.acos(A), lambda a, b, c: mp.acos(a)),
    "arctangent": (sp.atan(B), lambda a, b, c: mp.atan(b)),
    "arctangent of two": (sp.atan2(B, A), lambda a, b, c: mp.atan2(b, a)),
    "exponential": (sp.exp(A), lambda a, b, c: mp.exp(a)),
    "logarithm": (sp.log(C), lambda a, b, c: mp.log(c)),
    "absolute": (sp.Abs(B), lambda a, b, c: abs(b)),
    "floor": (sp.floor(3 * B), lambda a, b, c: mp.floor(3 * b)),
    "least": (sp.Min(A, B, C), lambda a, b, c: min(a, b, c)),
    "greatest": (sp.Max(A, B, C), lambda a, b, c: max(a, b, c)),
    "less": (sp.Piecewise((A, A < B), (C, True)), lambda a, b, c: a if a < b else c),
    "less or equal": (sp.Piecewise((1, A <= B), (2, True)), lambda a, b, c: 1 if a <= b else 2),
    "greater": (sp.Piecewise((A, B > A), (-C, True)), lambda a, b, c: a if b > a else -c),
    "greater or equal": (sp.Piecewise((1, B >= A), (2, True)), lambda a, b, c: 1 if b >= a else 2),
    "equal": (sp.Piecewise((A, sp.Eq(A, B)), (C, True)), lambda a, b, c: a if a == b else c),
    "unequal": (sp.Piecewise((A, sp.Ne(A, B)), (C, True)), lambda a, b, c: a if a != b else c),
    "three branches": (
        sp.Piecewise((A, A < -0.1), (B, B < 0), (C, True)),
        lambda a, b, c: a if a < -0.1 else b if b < 0 else c,
    ),
    "nested": (
        sp.Piecewise((sp.Piecewise((A, B < 0), (B, True)), A > 0), (C, True)),
        lambda a, b, c: (a if b < 0 else b) if a > 0 else c,
    ),
    "and": (
        sp.Piecewise((A, sp.And(A > 0, B > 0)), (C, True)),
        lambda a, b, c: a if a > 0 and b > 0 else c,
    ),
    "or": (
        sp.Piecewise((A, sp.Or(A < 0, B < 0)), (C, True)),
        lambda a, b, c: a if a < 0 or b < 0 else c,
    ),
    "not": (
        sp.Piecewise((A, sp.Not(sp.And(A < 0.5, B > 0))), (C, True)),
        lambda a, b, c: c if a < 0.5 and b > 0 else a,
    ),
    "choice in arithmetic": (
        2 * A - sp.Piecewise((B, A < B), (C, True)),
        lambda a, b, c: 2 * a - (b if a < b else c),
    ),
}


def derivation(
    expressions: list[sp.Basic],
    definitions: tuple[Definition, ...] = (),
) -> Derivation:
    """A function of a three-vector without any derivative."""
    entries = {(i, 0): e for i, e in enumerate(expressions)}
    output = DerivedOutput("value", "value", len(expressions), 0, entries, {}, "", "", "")
    origins = {symbol: Origin("x", k) for k, symbol in enumerate(SYMBOLS)}
    equation = Equation((), {}, {}, {}, (), frozenset())
    return Derivation(
        "local", None, definitions, (output,), origins, ("x",), False, equation, frozenset()
    )


def run(route: str, made: Derivation, point: tuple[float, ...]) -> Result:
    """Lower by one route and evaluate."""
    function = ROUTES[route](layout(vector("v")), made)
    return Interpreter(function).run({"x": [mpf(e) for e in point]})


@pytest.mark.parametrize("name", list(NODES))
def test_node(name: str) -> None:
    """Each kind of node, as an output and under a name, by both routes and by the bridge alone."""
    expression, meaning = NODES[name]
    named = (Definition(S, expression, item=False),)
    table = {symbol: ca.SX.sym(symbol.name) for symbol in SYMBOLS}
    bridged = ca.Function("f", list(table.values()), [to_casadi(expression, table)])
    for point in POINTS:
        expected = mpf(meaning(*(mpf(e) for e in point)))
        for route in ROUTES:
            for made in (derivation([expression]), derivation([A * S], named)):
                actual = run(route, made, point).outputs["value"][(0,)]
                factor = mpf(point[0]) if made.definitions else 1
                assert abs(actual - factor * expected) <= 4e-16 * (1 + abs(expected)), route
        assert math.isclose(bridged(*point), expected, rel_tol=1e-15, abs_tol=1e-15)


@pytest.mark.parametrize("expression", [sp.gamma(A), A**B, C ** sp.Rational(1, 3), sp.zoo * A])
def test_unknown_nodes_are_refused(expression: sp.Expr) -> None:
    """Never converted into something near it."""
    table = {symbol: ca.SX.sym(symbol.name) for symbol in SYMBOLS}
    with pytest.raises(TypeError, match="no CasADi counterpart"):
        to_casadi(expression, table)
    with pytest.raises(TypeError, match="no counterpart"):
        run("sympy", derivation([expression]), POINTS[0])


@pytest.mark.parametrize("truth", [sp.true, sp.false])
def test_truth(truth: sp.Basic) -> None:
    """Conditions that are decided already."""
    assert float(to_casadi(truth, {})) == float(bool(truth))


@pytest.mark.parametrize("route", list(ROUTES))
def test_guards_substitute(route: str) -> None:
    """What follows a failed check reads the substitute; what passes reads the value."""
    t, u, r = sp.symbols("t u r")
    guard = Guard(0.25, 4.0, 1.0, "square")
    second = Guard(0.0, 1.5, 1.25, "root")
    definitions = (
        Definition(t, A * A, item=False, guard=guard),
        Definition(u, sp.sqrt(t), item=False, guard=second),
        Definition(r, B / u, item=False),
    )
    made = derivation([r, A * A], definitions)
    good = run(route, made, (1.0, 3.0, 0.0))
    assert good.outputs["value"] == {(0,): 3, (1,): 1} and not good.failed
    bad = run(route, made, (0.125, 3.0, 0.0))
    assert bad.outputs["value"] == {(0,): 3, (1,): mpf(1) / 64}
    assert bad.failed == [ir.Status.DOMAIN]
    worse = run(route, made, (1.75, 3.0, 0.0))
    assert worse.outputs["value"][(0,)] == mpf(3) / mpf(1.25)
    assert worse.failed == [ir.Status.DOMAIN]


@pytest.mark.parametrize("route", list(ROUTES))
def test_names_and_reuse(route: str) -> None:
    """A name given in the equation reaches the steps; a repeated term is computed once."""
    length = sp.Symbol("length")
    definitions = (Definition(length, sp.sqrt(A * A + B * B), item=False),)
    repeated = sp.sin(A * C)
    made = derivation([length, repeated + 1, repeated * length], definitions)
    function = ROUTES[route](layout(vector("v")), made)
    targets = [step.target for step in function.shared]
    assert "length" in targets
    assert len(targets) == len(set(targets))
    sines = [s for s in function.shared if _contains(s.value, ir.Operation.SIN)]
    assert len(sines) == 1


def test_names_beside_checks() -> None:
    """A name stands for its own term also where checks travel with the terms."""
    t, length, ratio = sp.symbols("t length ratio")
    definitions = (
        Definition(t, A * A + B * B, item=False, guard=Guard(0.0, 9.0, 1.0, "square")),
        Definition(length, sp.sqrt(t), item=False),
        Definition(ratio, A / length, item=False),
    )
    function = ROUTES["casadi"](layout(vector("v")), derivation([ratio, length + 1], definitions))
    steps = {step.target: step.value for step in function.shared}
    assert isinstance(steps["length"], ir.Call) and isinstance(steps["ratio"], ir.Call)
    assert steps["length"].operation is ir.Operation.SQRT
    assert steps["ratio"] == ir.Call(ir.Operation.DIV, (ir.Load("x", 0), ir.Ref("length")))


def _contains(expression: ir.Expression, operation: ir.Operation) -> bool:
    if not isinstance(expression, ir.Call):
        return False
    return expression.operation is operation or any(
        _contains(operand, operation) for operand in expression.operands
    )


def test_vectors_are_summed_alike_and_products_of_short_sums_first() -> None:
    """Neighbouring elements differ in their names alone, so that they may be computed together."""
    names = sp.symbols("d_0:12")
    table = {name: ca.SX.sym(name.name) for name in names}
    x, y = (sum(names[i] for i in range(k, 12, 3)) for k in (0, 1))
    shifted = str(to_casadi(y, table))
    for i in range(0, 12, 3):
        shifted = re.sub(rf"\bd_{i + 1}\b", f"d_{i}", shifted)
    assert shifted == str(to_casadi(x, table))
    a, b, c, d, e, *_ = names
    assert str(to_casadi(a * b - c - d * e, table)) == "(((d_0*d_1)-(d_3*d_4))-d_2)"
