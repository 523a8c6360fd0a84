"""Operations of quantities: values, derivatives, units, frames, and what they refuse."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from mpmath import mp

from symnav import quantities as ops
from symnav import units
from symnav.elimination import jacobian
from symnav.errors import EquationError
from symnav.graph import Graph, identity
from symnav.quantities import Quantity, Rotation
from tests.core.judging import assert_close

STANDING = (mp.mpf(2), mp.mpf(-3), mp.mpf("0.5"))
NUMBERS = {"a": (0.7, -1.9, 2.3), "b": (-0.4, 1.1, 3.2), "s": (1.7,), "t": (-0.6,)}


class World:
    """A graph with two moving vectors in frame f, two moving scalars, and a vector that stands."""

    def __init__(self) -> None:
        self.graph = Graph()
        self.sources: dict[str, int] = {}
        self.numbers: dict[sp.Symbol, Any] = {}
        self.a = self._moving("a", "m", "f")
        self.b = self._moving("b", "m", "f")
        self.s = self._moving("s", "m")
        self.t = self._moving("t", "m")
        fixed = self.graph.argument(["c0", "c1", "c2"])
        self.numbers.update(zip(fixed, STANDING, strict=True))
        self.c = Quantity(self.graph, fixed, units.parse("m"), "f")

    def _moving(self, name: str, unit: str, frame: str | None = None) -> Quantity:
        values = NUMBERS[name]
        symbols = self.graph.argument([f"{name}{k}" for k in range(len(values))])
        source = self.graph.source(f"error of {name}", len(values)).name
        self.sources[source] = len(values)
        self.graph.attach(name, symbols, len(values), {source: identity(len(values))})
        self.numbers.update(zip(symbols, map(mp.mpf, values), strict=True))
        return Quantity(self.graph, symbols, units.parse(unit), frame)

    def evaluate(self, expressions: Any) -> list[Any]:
        """Numbers of expressions over the graph."""
        known = dict(self.numbers)
        for definition in self.graph.definitions:
            known[definition.symbol] = _number(definition.expression, known)
        return [_number(e, known) for e in expressions]


def _number(expression: sp.Expr, known: dict[sp.Symbol, Any]) -> Any:
    symbols = sorted(expression.free_symbols, key=str)
    return mp.mpf(sp.lambdify(symbols, expression, "mpmath")(*(known[s] for s in symbols)))


Operation = Callable[[World], Quantity]
Truth = Callable[[Any, Any, Any, Any], list[Any]]


def combined(function: Callable[..., Any], *vectors: Any) -> list[Any]:
    """A function of the elements of several vectors."""
    return [function(*elements) for elements in zip(*vectors, strict=True)]


def cross_product(a: Any, b: Any) -> list[Any]:
    """By components."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def one_third(w: World) -> Quantity:
    """A division by a number."""
    return ops.divide("d", w.a, ops.constant(w.graph, (3.0,), units.ONE))


def polynomial(w: World) -> Quantity:
    """1/2 - 3 st + 5/7 (st)^2."""
    return ops.series("p", w.s * w.t, [Fraction(1, 2), Fraction(-3), Fraction(5, 7)])


def turned(
    world: World,
    matrix: Sequence[Any] = sp.symbols("C0:9"),
    source: str = "f",
    target: str = "g",
    tangent: str | None = None,
    side: str = "right",
) -> Rotation:
    """A rotation; entries need not be those of a rotation for its rules to hold."""
    entries = tuple(sp.sympify(e) for e in matrix)
    return Rotation(world.graph, "C", source, target, entries, tangent, side)


MATRIX = (2, -3, 5, 7, 1, -4, 3, 8, -6)


def mixed(w: World) -> Quantity:
    """A vector whose elements belong to two others, in another order."""
    elements = (w.a.elements[2], w.b.elements[0], w.a.elements[1])
    return Quantity(w.graph, elements, w.a.unit, "f")


def rotated(a: Any) -> list[Any]:
    """The matrix times a vector."""
    return [mp.fdot(MATRIX[3 * i : 3 * i + 3], a) for i in range(3)]


OPERATIONS: dict[str, tuple[Operation, Truth]] = {
    "rotation": (
        lambda w: ops.rotate(turned(w, MATRIX, target="f", source="g"), ops.let("m", 2.0 * w.a)),
        lambda a, b, s, t: [2 * mp.fdot(MATRIX[i::3], a) for i in range(3)],
    ),
    "rotation of a mixture": (
        lambda w: ops.rotate(turned(w, MATRIX), mixed(w)),
        lambda a, b, s, t: rotated([a[2], b[0], a[1]]),
    ),
    "norm of a mixture": (
        lambda w: ops.norm("r", mixed(w)),
        lambda a, b, s, t: [mp.norm([a[2], b[0], a[1]])],
    ),
    "sum": (
        lambda w: w.a + w.b + w.c,
        lambda a, b, s, t: combined(lambda x, y, z: x + y + z, a, b, STANDING),
    ),
    "difference": (lambda w: w.a - w.b, lambda a, b, s, t: combined(lambda x, y: x - y, a, b)),
    "opposite": (lambda w: -w.a, lambda a, b, s, t: [-x for x in a]),
    "scaled": (lambda w: 0.1 * w.a, lambda a, b, s, t: [mp.mpf(0.1) * x for x in a]),
    "product": (lambda w: (w.s + w.t) * w.a, lambda a, b, s, t: [(s + t) * x for x in a]),
    "square": (lambda w: w.s * w.t, lambda a, b, s, t: [s * t]),
    "element": (lambda w: w.a[1] * w.s, lambda a, b, s, t: [a[1] * s]),
    "cross": (lambda w: ops.cross(w.a, w.b), lambda a, b, s, t: cross_product(a, b)),
    "dot": (lambda w: ops.dot(w.a, w.b), lambda a, b, s, t: [mp.fdot(a, b)]),
    "norm": (
        lambda w: ops.norm("r", w.a - w.b),
        lambda a, b, s, t: [mp.norm(combined(lambda x, y: x - y, a, b))],
    ),
    "total": (
        lambda w: ops.total(w.a, None, w.b),
        lambda a, b, s, t: combined(lambda x, y: x + y, a, b),
    ),
    "named": (lambda w: ops.let("n", w.s * w.a), lambda a, b, s, t: [s * x for x in a]),
    "quotient": (lambda w: ops.divide("d", w.a, w.t), lambda a, b, s, t: [x / t for x in a]),
    "third": (one_third, lambda a, b, s, t: [x / 3 for x in a]),
    "over": (lambda w: ops.over(w.a, w.t), lambda a, b, s, t: [x / t for x in a]),
    "root": (
        lambda w: ops.square_root("q", w.s * w.s + w.t * w.t),
        lambda a, b, s, t: [mp.hypot(s, t)],
    ),
    "angle": (lambda w: ops.arctangent2("k", w.t, w.s), lambda a, b, s, t: [mp.atan2(t, s)]),
    "sine": (
        lambda w: ops.elementwise("e", sp.sin, w.s * w.t, units.ONE),
        lambda a, b, s, t: [mp.sin(s * t)],
    ),
    "series": (
        polynomial,
        lambda a, b, s, t: [mp.mpf(1) / 2 - 3 * s * t + mp.mpf(5) / 7 * (s * t) ** 2],
    ),
}


@pytest.mark.parametrize("name", list(OPERATIONS))
def test_value_and_derivatives(name: str) -> None:
    """Every operation against its meaning, and its Jacobian against differences of that."""
    operation, truth = OPERATIONS[name]
    world = World()
    result = operation(world)
    if any(world.graph.moves(e) and not e.is_Symbol for e in result.elements):
        result = ops.let("result", result)

    def true(flat: list[Any]) -> list[Any]:
        return truth(flat[:3], flat[3:6], flat[6], flat[7])

    centre = [mp.mpf(v) for values in NUMBERS.values() for v in values]
    expected = true(centre)
    assert_close(world.evaluate(result.elements), expected, name, "1e-20")
    blocks = jacobian(world.graph, result.elements, world.sources)
    step = mp.mpf(10) ** -8
    column = 0
    for source, size in world.sources.items():
        for k in range(size):
            ends = [
                true([v + (sign * step if i == column else 0) for i, v in enumerate(centre)])
                for sign in (1, -1)
            ]
            slopes = [(x - y) / (2 * step) for x, y in zip(*ends, strict=True)]
            actual = world.evaluate([row[k] for row in blocks[source]])
            assert_close(actual, slopes, f"{source}, {k}", "1e-13")
            column += 1


def test_units_and_frames_of_results() -> None:
    """Every operation says what it gives."""
    world = World()
    results = {name: operation(world) for name, (operation, _) in OPERATIONS.items()}
    squares = {"product", "square", "element", "cross", "dot", "named"}
    plain = {"quotient", "over", "angle", "sine", "series"}
    for name, result in results.items():
        power = 2 if name in squares else 0 if name in plain else 1
        assert result.unit == units.parse("m") ** power, name
        vector = name in {"sum", "difference", "opposite", "scaled", "product", "cross", "total"}
        vector = (
            vector or name in {"named", "quotient", "over", "third"} or name.startswith("rotation")
        )
        frame = "g" if name.startswith("rotation") else "f"
        assert result.frame == (frame if vector else None), name
        assert result.size == (3 if vector else 1), name


def test_rotation_of_constants() -> None:
    """A fixed rotation of a fixed vector is only named; the frame picks the direction."""
    world = World()
    forward = ops.rotate(turned(world), world.c)
    m, c = sp.symbols("C0:9"), world.c.elements
    definitions = {d.symbol: d.expression for d in world.graph.definitions}
    assert definitions[forward.elements[1]] == m[3] * c[0] + m[4] * c[1] + m[5] * c[2]
    back = ops.rotate(turned(world, source="g", target="f"), world.c)
    definitions = {d.symbol: d.expression for d in world.graph.definitions}
    assert definitions[back.elements[1]] == m[1] * c[0] + m[4] * c[1] + m[7] * c[2]
    assert (forward.frame, back.frame) == ("g", "g")
    assert "C_rotated" not in world.graph.vertices


@pytest.mark.parametrize("side", ["right", "left"])
@pytest.mark.parametrize("forward", [True, False])
def test_rotation_that_moves_with_its_operand(side: str, forward: bool) -> None:
    """Both ways from one error add up: d(M Exp(d) (a + d)) = M (I - [a]x) d, and its kin."""
    world = World()
    ends = {"source": "f", "target": "g"} if forward else {"source": "g", "target": "f"}
    out = ops.rotate(turned(world, MATRIX, tangent="a", side=side, **ends), world.a)
    rows = jacobian(world.graph, out.elements, {"error of a": 3})["error of a"]
    actual = sp.Matrix(3, 3, world.evaluate([e for row in rows for e in row]))
    matrix = sp.Matrix(3, 3, MATRIX)
    a = sp.Matrix(NUMBERS["a"])
    if not forward:
        matrix = matrix.T
    sign = -1 if forward else 1
    if (side == "right") == forward:
        expected = matrix * (sp.eye(3) + sign * cross_matrix(a))
    else:
        expected = matrix + sign * cross_matrix(matrix * a)
    assert max(abs(e) for e in actual - expected) < 1e-13


def cross_matrix(v: Any) -> sp.Matrix:
    """The matrix of the vector product with v from the left."""
    return sp.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def test_names_are_given_once() -> None:
    """What is a symbol or a number already gets no other name."""
    world = World()
    ops.norm("r", world.a)
    assert [str(d.symbol) for d in world.graph.definitions][:2] == ["r_squared", "r"]


@pytest.mark.parametrize(
    ("value", "exact"),
    [(3.0, sp.Integer(3)), (-0.25, sp.Rational(-1, 4)), (1 / 64, sp.Rational(1, 64))],
)
def test_short_numbers_are_exact(value: float, exact: sp.Expr) -> None:
    """Integers and short binary fractions."""
    assert ops.number(value) == exact
    assert ops.number(value).is_Rational


@pytest.mark.parametrize("value", [0.1, 2.9, 1 / 128, 1e7, -6.7e-11])
def test_other_numbers_are_their_double(value: float) -> None:
    """Nothing is rounded, nothing truncated."""
    assert float(ops.number(value)) == value
    assert ops.number(value).is_Float


MISTAKES: dict[str, tuple[Callable[[World], Any], str]] = {
    "sizes": (lambda w: w.a + w.s, "added to"),
    "frames": (lambda w: w.a + ops.rotate(turned(w), w.a), "frame 'g'"),
    "units": (lambda w: w.s + w.s * w.s, "m"),
    "plain number": (lambda w: operator.sub(w.s, 1.0), "plain number"),
    "vectors": (lambda w: w.a * w.b, "dot"),
    "index": (lambda w: w.a[3], "element 3"),
    "negative index": (lambda w: w.a[-1], "element -1"),
    "cross": (lambda w: ops.cross(w.a, w.s), "cross"),
    "cross frames": (lambda w: ops.cross(w.a, ops.rotate(turned(w), w.a)), "cross"),
    "dot": (lambda w: ops.dot(w.a, w.s), "dot"),
    "rotate": (lambda w: ops.rotate(turned(w), w.s), "3-vector"),
    "rotate frame": (lambda w: ops.rotate(turned(w, source="h"), w.a), "h -> g"),
    "division by a vector": (lambda w: ops.divide("d", w.s, w.a), "divided by"),
    "division by zero": (
        lambda w: ops.divide("d", w.s, ops.constant(w.graph, (0.0,), units.ONE)),
        "divided by zero",
    ),
    "root": (lambda w: ops.square_root("q", w.a), "square root"),
    "angle": (lambda w: ops.arctangent2("k", w.s, w.s * w.s), "atan2"),
    "function": (lambda w: ops.elementwise("e", sp.sin, w.a, units.ONE), "needs a scalar"),
}


@pytest.mark.parametrize("name", list(MISTAKES))
def test_mistakes(name: str) -> None:
    """The message says what does not fit."""
    mistake, words = MISTAKES[name]
    with pytest.raises(EquationError, match=words):
        mistake(World())
