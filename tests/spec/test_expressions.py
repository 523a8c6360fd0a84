"""Expressions: what they build, what they refuse, and the derivatives of what they build."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from symnav import units
from symnav.blocks import RotationBlock, VectorBlock
from symnav.errors import EquationError
from symnav.graph import Graph, identity
from symnav.quantities import Quantity
from symnav.spec.expressions import FUNCTIONS, Evaluator, names, normal_form, parse
from symnav.spec.trial import attach


def scalar(graph: Graph, name: str, unit: str = "1") -> Quantity:
    """A scalar that moves with an error of its own."""
    (symbol,) = graph.argument([name])
    source = graph.source(f"error of {name}", 1)
    graph.attach(name, [symbol], 1, {source.name: identity(1)})
    return Quantity(graph, (symbol,), units.parse(unit))


def value(quantity: Quantity, at: Mapping[str, float]) -> list[mpmath.mpf]:
    """Elements with every definition substituted, in 50 digits."""
    known: dict[sp.Symbol, sp.Expr] = {sp.Symbol(k): sp.Float(v, 50) for k, v in at.items()}
    for definition in quantity.graph.definitions:
        known[definition.symbol] = definition.expression.subs(known).evalf(50)
    return [mpmath.mpf(str(e.subs(known).evalf(50))) for e in quantity.elements]


def derivative(quantity: Quantity, name: str, at: Mapping[str, float]) -> mpmath.mpf:
    """Chain rule over the graph's own partials, by recursion."""
    graph = quantity.graph
    known: dict[sp.Symbol, sp.Expr] = {sp.Symbol(k): sp.Float(v, 50) for k, v in at.items()}
    for definition in graph.definitions:
        known[definition.symbol] = definition.expression.subs(known).evalf(50)

    def by(partials: Mapping[str, tuple[tuple[sp.Expr, ...], ...]]) -> sp.Expr:
        total = sp.Integer(0)
        for parent, rows in partials.items():
            for j, entry in enumerate(rows[0]):
                inner = sp.Integer(1) if parent == f"error of {name}" else (
                    by({p: (r[j],) for p, r in graph.vertices[parent].partials.items()})
                )  # fmt: skip
                if parent.startswith("error of ") and parent != f"error of {name}":
                    inner = sp.Integer(0)
                total += entry.subs(known) * inner
        return total

    return mpmath.mpf(str(by(graph.local_partials(quantity.elements)).evalf(50)))


REFERENCE: Mapping[str, Callable[[Any, Any], Any]] = {
    "sqrt(a)": lambda a, b: mpmath.sqrt(a),
    "abs(a - 3)": lambda a, b: abs(a - 3),
    "sin(a * b)": lambda a, b: mpmath.sin(a * b),
    "cos(a) + a": lambda a, b: mpmath.cos(a) + a,
    "tan(a / 4)": lambda a, b: mpmath.tan(a / 4),
    "asin(a / 8)": lambda a, b: mpmath.asin(a / 8),
    "acos(b / 8)": lambda a, b: mpmath.acos(b / 8),
    "atan(a - b)": lambda a, b: mpmath.atan(a - b),
    "atan2(a, -b)": lambda a, b: mpmath.atan2(a, -b),
    "atan2(b, a) * b": lambda a, b: mpmath.atan2(b, a) * b,
    "exp(-a) * log(b)": lambda a, b: mpmath.exp(-a) * mpmath.log(b),
    "a ** 3 / (b + 1)": lambda a, b: a**3 / (b + 1),
    "(a + b) ** 2 - 2 * 3 / 4 * a": lambda a, b: (a + b) ** 2 - mpmath.mpf(1.5) * a,
    "norm([a, b, 2])": lambda a, b: mpmath.sqrt(a * a + b * b + 4),
    "dot([a, b, 1], [b, b, a])": lambda a, b: a * b + b * b + a,
    "cross([a, 1, b], [b, a, 2])[2]": lambda a, b: a * a - b,
    "+a - -b": lambda a, b: a + b,
}


@pytest.mark.parametrize("text", REFERENCE)
@settings(max_examples=5, deadline=None)
@given(a=st.floats(0.5, 2.5), b=st.floats(0.5, 2.5))
def test_values_and_derivatives(text: str, a: float, b: float) -> None:
    graph = Graph()
    quantities = {"a": scalar(graph, "a"), "b": scalar(graph, "b")}
    result = Evaluator(graph, quantities).quantity(parse(text))
    at = {"a": a, "b": b}
    with mpmath.workdps(50):
        x, y = mpmath.mpf(a), mpmath.mpf(b)
        reference = REFERENCE[text]
        assert mpmath.almosteq(value(result, at)[0], reference(x, y), 1e-30, 1e-30)
        by_a = mpmath.diff(lambda t: reference(t, y), x)
        assert mpmath.almosteq(derivative(result, "a", at), by_a, 1e-18, 1e-18)


def test_rotate_uses_the_frames() -> None:
    graph = Graph()
    attitude = attach(graph, RotationBlock("attitude", (), (), "", "b -> n"), False)
    arm = attach(graph, VectorBlock("arm", (), (), "", 3, "m", "b"), False)
    evaluator = Evaluator(graph, {"attitude": attitude, "arm": arm})
    turned = evaluator.quantity(parse("rotate(attitude, arm)"))
    back = evaluator.quantity(parse("rotate(attitude, rotate(attitude, arm))"))
    assert (turned.frame, back.frame) == ("n", "b")
    at = dict(zip(("w", "x", "y", "z"), (0.5, 0.5, 0.5, 0.5), strict=True))
    state = {f"attitude_{k}": v for k, v in at.items()}
    state |= {"arm_x": 1.0, "arm_y": 2.0, "arm_z": 3.0}
    assert [float(v) for v in value(turned, state)] == [3.0, 1.0, 2.0]
    assert [float(v) for v in value(back, state)] == [1.0, 2.0, 3.0]


def test_quantity_gives_numbers_a_unit_and_lists_a_frame() -> None:
    graph = Graph()
    evaluator = Evaluator(graph, {"a": scalar(graph, "a", "m")})
    speed = evaluator.quantity(parse("quantity(9.8, 'm/s^2')"))
    assert str(speed.unit) == "m/s^2"
    arm = evaluator.quantity(parse("quantity([a, a, quantity(0, 'm')], 'm', 'b')"))
    assert (arm.frame, arm.size) == ("b", 3)
    with pytest.raises(EquationError, match="is not in s"):
        evaluator.quantity(parse("quantity(a, 's')"))
    with pytest.raises(EquationError, match="only a 3-vector has a frame"):
        evaluator.quantity(parse("quantity(1, 's', 'b')"))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "is empty"),
        ("a +", "cannot be read"),
        ("a # comment", "'#' is not part of an expression"),
        ("a if a else b", "is not allowed"),
        ("lambda: a", "':' is not part of an expression"),
        ("[x for x in a]", "is not allowed"),
        ("a.real", "is not allowed"),
        ("a[b]", "is not a whole number"),
        ("a[-1]", "is not a whole number"),
        ("a[1]", "element 1 of a scalar in 1 does not exist"),
        ("(a, b)", "is not allowed"),
        ("'a'", "is not a number"),
        ("True", "is not a number"),
        ("3j * a", "is not a number"),
        ("1e31 * a", "larger than 1e\\+30"),
        ("1e30 * 1e30 * a", "larger than 1e\\+30"),
        ("a // b", "the operator // is not allowed"),
        ("a ^ 2", "the operator \\^ is not allowed"),
        ("a ** b", "the power 'b' is not allowed"),
        ("a ** 0.5", "the power '0.5' is not allowed"),
        ("a ** 9 ** 9", "the power '9 \\*\\* 9' is not allowed"),
        ("a / 0", "division by zero"),
        ("a / (1 - 1)", "division by zero"),
        ("sqrt(a, b)", "takes 1 argument"),
        ("sqrt(*a)", "takes plain arguments only"),
        ("norm(a=b)", "'=' is not part of an expression"),
        ("rotate(a, b)", "needs a rotation first"),
        ("sqr(a)", "did you mean 'sqrt'"),
        ("sin", "sin is a function, write sin"),
        ("c + a", "'c' is not a state block, an input or a let"),
        ("length + a", "a scalar in m cannot be added to a scalar in 1"),
        ("sin(length)", "needs an angle or a number"),
        ("[a, length]", "a list holds scalars of one unit"),
        ("[a, [a, b]]", "a list holds scalars, not"),
        ("[]", "at least one scalar"),
        ("[a, b] ** 2", "has no powers"),
        ("attitude + a", "'attitude' is a rotation"),
        ("quantity(a, b)", "a unit and a frame in quotes"),
        ("quantity(1, 'km')", "'km' is not an SI base unit"),
    ],
)
def test_refusals_name_the_reason(text: str, reason: str) -> None:
    graph = Graph()
    quantities = {
        "a": scalar(graph, "a"),
        "b": scalar(graph, "b"),
        "length": scalar(graph, "length", "m"),
        "attitude": attach(graph, RotationBlock("attitude", (), (), "", "b -> n"), False),
    }
    with pytest.raises(EquationError, match=reason):
        Evaluator(graph, quantities).quantity(parse(text))


@pytest.mark.parametrize(
    "text",
    [
        "(" * 1000 + "a" + ")" * 999,
        "-" * 1900 + "a",
        "+".join(["a"] * 900),
        "a" * 2001,
        "[" * 150 + "a" + "]" * 150,
        "sin(" * 120 + "a" + ")" * 120,
        "not " * 400 + "a",
    ],
)
def test_hostile_sizes_are_refused(text: str) -> None:
    with pytest.raises(EquationError):
        parse(text)


_FRAGMENTS = [
    *FUNCTIONS, *"ab01.,+-*/()[]'\" \n\\{}@:=~^%&|<>", "**", "1e9", "lambda", "await ", "import",
    "__class__", "attitude", "'m'", "None", "a.b",
]  # fmt: skip


@given(st.lists(st.sampled_from(_FRAGMENTS), max_size=30).map("".join))
def test_any_text_is_a_quantity_or_a_reason(text: str) -> None:
    graph = Graph()
    quantities = {
        "a": scalar(graph, "a"),
        "b": scalar(graph, "b", "m"),
        "attitude": attach(graph, RotationBlock("attitude", (), (), "", "b -> n"), False),
    }
    try:
        result = Evaluator(graph, quantities).quantity(parse(text))
    except EquationError as error:
        assert str(error)
    else:
        assert result.size >= 1


@given(st.text(max_size=60))
def test_arbitrary_text_never_escapes(text: str) -> None:
    try:
        parse(text)
    except EquationError as error:
        assert str(error)


def test_guards_stand_on_every_partial_function() -> None:
    for text, least in (("sqrt(a)", 1e-30), ("log(a)", 1e-30), ("1 / a", 1e-30), ("abs(a)", 1e-30),
                        ("tan(a)", 1e-30), ("atan2(a, a)", 1e-30), ("asin(a)", -1.0),
                        ("acos(a)", -1.0), ("exp(a)", -80.0), ("norm([a, a])", 1e-12)):  # fmt: skip
        graph = Graph()
        Evaluator(graph, {"a": scalar(graph, "a")}).quantity(parse(text))
        guards = [d.guard for d in graph.definitions if d.guard is not None]
        assert len(guards) == 1, text
        assert math.isclose(guards[0].lower, least, rel_tol=1e-6), text
        assert guards[0].lower <= guards[0].substitute <= guards[0].upper, text


def test_normal_form_forgets_formatting_only() -> None:
    assert normal_form(" ( a+b )*2 ") == normal_form("(a + b) * 2") == "(a + b) * 2"
    assert normal_form("a + b * 2") != normal_form("(a + b) * 2")
    assert set(names(parse("sin(b) + a * b + norm(c)"))) == {"a", "b", "c"}
