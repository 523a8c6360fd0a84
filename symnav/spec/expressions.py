"""Expressions of user equations: text to quantities, through a white list of syntax.

The text is parsed to Python's syntax tree and walked node by node; whatever is not listed here is
refused by name. Nothing is ever evaluated as code, and length, depth and number of nodes are
bounded before anything is built.
"""

from __future__ import annotations

import ast
import math
import re
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from symnav import quantities, units
from symnav.blocks import GeodeticPoint, Value
from symnav.errors import EquationError
from symnav.graph import Graph, Guard
from symnav.quantities import Quantity, Rotation
from symnav.spec.problems import suggestion

LONGEST = 2000
DEEPEST = 100
MOST_NODES = 1000
LARGEST_POWER = 8
LARGEST_NUMBER = 1e30
#: Arcsine and arccosine keep this distance from +-1, where their derivative has no bound.
ARC_MARGIN = 1e-9
LARGEST_EXPONENT = 80.0

_CHARACTERS = re.compile(r"[A-Za-z0-9_\s.,+\-*/^()\[\]\"']*")

Term = Value | float


def parse(text: str) -> ast.expr:
    """The syntax tree of an expression of bounded size.

    Raises:
        EquationError: when the text is too long, too deep or not an expression.
    """
    source = " ".join(text.split())
    if not source:
        raise EquationError("the expression is empty")
    if len(source) > LONGEST:
        raise EquationError(f"the expression has {len(source)} characters; {LONGEST} are allowed")
    if _CHARACTERS.fullmatch(source) is None:
        strange = next(c for c in source if _CHARACTERS.fullmatch(c) is None)
        raise EquationError(f"{strange!r} is not part of an expression")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(source, mode="eval").body
    except (SyntaxError, ValueError, MemoryError, RecursionError) as error:
        detail = error.msg if isinstance(error, SyntaxError) else "it is nested too deeply"
        raise EquationError(f"{_short(source)} cannot be read: {detail}") from None
    _bound(tree)
    return tree


def normal_form(text: str) -> str:
    """The expression without redundant blanks and parentheses."""
    return ast.unparse(parse(text))


def names(tree: ast.expr) -> tuple[str, ...]:
    """Names of quantities an expression reads, in the order they appear."""
    called = {id(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
    found = (n for n in ast.walk(tree) if isinstance(n, ast.Name) and id(n) not in called)
    return tuple(dict.fromkeys(node.id for node in found))


@dataclass(frozen=True)
class Evaluator:
    """Builds quantities from syntax trees.

    Attributes:
        graph: where intermediate results are named.
        values: states and inputs by name.
        terms: lets by name.
    """

    graph: Graph
    values: Mapping[str, Value]
    terms: Mapping[str, Quantity] = field(default_factory=dict)

    def quantity(self, tree: ast.expr) -> Quantity:
        """The scalar or vector an expression stands for.

        Raises:
            EquationError: for syntax, units, sizes or frames that do not fit.
        """
        return self._as_quantity(self._term(tree))

    def _term(self, node: ast.expr) -> Term:
        match node:
            case ast.Constant():
                return _number(node)
            case ast.Name(id=name):
                return self._named(name)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                inner = self._arithmetic(operand)
                return -inner
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self._arithmetic(operand)
            case ast.BinOp(left=left, op=operator, right=right):
                return self._binary(operator, left, right)
            case ast.Call():
                return self._call(node)
            case ast.Subscript(value=value, slice=index):
                return self._as_quantity(self._term(value))[_index(index)]
            case ast.List(elts=elements):
                return self._stack([self.quantity(element) for element in elements])
        raise EquationError(
            f"{_short(ast.unparse(node))} is not allowed; use names, numbers, + - * / **, "
            f"[element], lists of scalars and {', '.join(FUNCTIONS)}"
        )

    def _named(self, name: str) -> Value:
        if name in self.terms:
            return self.terms[name]
        if name not in self.values:
            hint = f"; {name} is a function, write {name}(...)" if name in FUNCTIONS else (
                suggestion(name, (*self.terms, *self.values))
            )  # fmt: skip
            raise EquationError(f"{name!r} is not a state block, an input or a let{hint}")
        return self.values[name]

    def _arithmetic(self, node: ast.expr) -> Quantity | float:
        term = self._term(node)
        return term if isinstance(term, float) else self._as_quantity(term)

    def _as_quantity(self, term: Term) -> Quantity:
        if isinstance(term, float):
            return quantities.constant(self.graph, (term,), units.ONE)
        if isinstance(term, Rotation):
            raise EquationError(
                f"{term.name!r} is a rotation ({term.source} -> {term.target}); "
                f"use rotate({term.name}, vector)"
            )
        return term.position if isinstance(term, GeodeticPoint) else term

    def _binary(self, operator: ast.operator, left: ast.expr, right: ast.expr) -> Quantity | float:
        if isinstance(operator, ast.Pow):
            return self._power(self._arithmetic(left), right)
        a, b = self._arithmetic(left), self._arithmetic(right)
        if isinstance(operator, ast.Mult):
            return _finite(a * b) if isinstance(a, float) and isinstance(b, float) else a * b
        if isinstance(operator, ast.Div):
            return self._quotient(a, b)
        if not isinstance(operator, (ast.Add, ast.Sub)):
            sign = "^" if isinstance(operator, ast.BitXor) else "//"
            raise EquationError(f"the operator {sign} is not allowed; use + - * / or **")
        plus = isinstance(operator, ast.Add)
        if isinstance(a, float) and isinstance(b, float):
            return _finite(a + b if plus else a - b)
        x, y = self._as_quantity(a), self._as_quantity(b)
        return x + y if plus else x - y

    def _quotient(self, a: Quantity | float, b: Quantity | float) -> Quantity | float:
        if isinstance(b, float) and b == 0.0:
            raise EquationError("division by zero")
        if isinstance(a, float) and isinstance(b, float):
            return _finite(a / b)
        return quantities.divide("quotient", self._as_quantity(a), self._as_quantity(b))

    def _power(self, base: Quantity | float, exponent: ast.expr) -> Quantity | float:
        count = _number(exponent) if isinstance(exponent, ast.Constant) else 0.0
        if count not in range(1, LARGEST_POWER + 1):
            raise EquationError(
                f"the power {_short(ast.unparse(exponent))} is not allowed; write a whole number "
                f"from 1 to {LARGEST_POWER}, sqrt(...) or a division"
            )
        if isinstance(base, float):
            return _finite(math.prod([base] * int(count)))
        if base.size != 1:
            raise EquationError(f"{base.describe()} has no powers; use dot(a, a)")
        factor = base if base.elements[0].is_Symbol else quantities.let("base", base)
        result = factor
        for _ in range(int(count) - 1):
            result = result * factor
        return result

    def _stack(self, scalars: Sequence[Quantity]) -> Quantity:
        for scalar in scalars:
            if scalar.size != 1:
                raise EquationError(f"a list holds scalars, not {scalar.describe()}")
            if scalar.unit != scalars[0].unit:
                raise EquationError(
                    f"a list holds scalars of one unit, not {scalars[0].unit} and {scalar.unit}"
                )
        if not scalars:
            raise EquationError("a list needs at least one scalar")
        elements = tuple(scalar.elements[0] for scalar in scalars)
        return Quantity(self.graph, elements, scalars[0].unit)

    def _call(self, node: ast.Call) -> Term:
        if not isinstance(node.func, ast.Name) or node.func.id not in FUNCTIONS:
            name = ast.unparse(node.func)
            raise EquationError(
                f"{_short(name)} is not a function of equations{suggestion(name, FUNCTIONS)} "
                f"({', '.join(FUNCTIONS)})"
            )
        name, least, most, apply = node.func.id, *FUNCTIONS[node.func.id]
        if node.keywords or any(isinstance(a, ast.Starred) for a in node.args):
            raise EquationError(f"{name} takes plain arguments only")
        if not least <= len(node.args) <= most:
            wanted = str(least) if least == most else f"{least} or {most}"
            raise EquationError(f"{name} takes {wanted} argument(s), got {len(node.args)}")
        return apply(self, node.args)

    def angle(self, name: str, node: ast.expr) -> Quantity:
        """A dimensionless scalar, as functions of angles and exponents need."""
        scalar = self.quantity(node)
        if scalar.size != 1 or scalar.unit != units.ONE:
            raise EquationError(f"{name} needs an angle or a number, got {scalar.describe()}")
        return scalar

    def rotation(self, node: ast.expr) -> Rotation:
        """A rotation, or the local-level rotation of a geodetic point."""
        term = self._term(node)
        if isinstance(term, GeodeticPoint):
            return term.level
        if not isinstance(term, Rotation):
            raise EquationError(f"rotate needs a rotation first, got {_short(ast.unparse(node))}")
        return term


def _rotate(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    return quantities.rotate(e.rotation(arguments[0]), e.quantity(arguments[1]))


def _cross(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    return quantities.cross(e.quantity(arguments[0]), e.quantity(arguments[1]))


def _dot(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    return quantities.dot(e.quantity(arguments[0]), e.quantity(arguments[1]))


def _norm(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    return quantities.norm("length", e.quantity(arguments[0]))


def _sqrt(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    return quantities.square_root("root", e.quantity(arguments[0]))


def _abs(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    """|a| as the root of its square: zero, where it has no derivative, is a domain error."""
    scalar = quantities.let("signed", e.quantity(arguments[0]))
    return quantities.square_root("magnitude", scalar * scalar)


def _tan(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    """Sine over cosine, so that a pole is a domain error."""
    angle = quantities.let("tangent_of", e.angle("tan", arguments[0]))
    sine = quantities.elementwise("sine", sp.sin, angle, units.ONE)
    cosine = quantities.elementwise("cosine", sp.cos, angle, units.ONE)
    return quantities.divide("tangent", sine, cosine)


def _atan2(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    return quantities.arctangent2("angle", e.quantity(arguments[0]), e.quantity(arguments[1]))


def _quantity(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
    """Numbers with a unit, and a list of scalars with a frame."""
    value, (unit, frame) = e.quantity(arguments[0]), _texts(arguments[1:])
    wanted = units.parse(unit)
    if value.unit not in (wanted, units.ONE) or (
        value.unit != wanted and any(not element.is_number for element in value.elements)
    ):
        raise EquationError(f"{value.describe()} is not in {wanted}")
    if frame and value.size != 3:
        raise EquationError(f"only a 3-vector has a frame, not {value.describe()}")
    if frame and value.frame not in (None, frame):
        raise EquationError(f"{value.describe()} is not in frame {frame!r}")
    return Quantity(e.graph, value.elements, wanted, frame or value.frame)


def _texts(arguments: Sequence[ast.expr]) -> tuple[str, str]:
    words = []
    for node in arguments:
        if not isinstance(node, ast.Constant) or not isinstance(node.value, str):
            raise EquationError("quantity takes a unit and a frame in quotes: quantity(9.8, 'm/s')")
        words.append(node.value)
    return words[0], words[1] if len(words) > 1 else ""


def _guarded(
    label: str, function: Callable[[sp.Expr], sp.Expr], lower: float, upper: float
) -> Callable[[Evaluator, Sequence[ast.expr]], Quantity]:
    """A function of a number that must lie between two bounds."""

    def apply(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
        inside = 1.0 if lower > 0.0 else 0.0
        guard = Guard(lower, upper, inside, f"argument of the {label}")
        argument = quantities.let(f"{label}_of", e.angle(label, arguments[0]), guard)
        return quantities.elementwise(label, function, argument, units.ONE)

    return apply


def _smooth(
    label: str, function: Callable[[sp.Expr], sp.Expr]
) -> Callable[[Evaluator, Sequence[ast.expr]], Quantity]:
    """A function of any number."""

    def apply(e: Evaluator, arguments: Sequence[ast.expr]) -> Quantity:
        return quantities.elementwise(label, function, e.angle(label, arguments[0]), units.ONE)

    return apply


#: Name -> least and greatest number of arguments, and what it does.
FUNCTIONS: Mapping[str, tuple[int, int, Callable[[Evaluator, Sequence[ast.expr]], Quantity]]] = {
    "rotate": (2, 2, _rotate),
    "cross": (2, 2, _cross),
    "dot": (2, 2, _dot),
    "norm": (1, 1, _norm),
    "sqrt": (1, 1, _sqrt),
    "abs": (1, 1, _abs),
    "sin": (1, 1, _smooth("sine", sp.sin)),
    "cos": (1, 1, _smooth("cosine", sp.cos)),
    "tan": (1, 1, _tan),
    "asin": (1, 1, _guarded("arcsine", sp.asin, ARC_MARGIN - 1.0, 1.0 - ARC_MARGIN)),
    "acos": (1, 1, _guarded("arccosine", sp.acos, ARC_MARGIN - 1.0, 1.0 - ARC_MARGIN)),
    "atan": (1, 1, _smooth("arctangent", sp.atan)),
    "atan2": (2, 2, _atan2),
    "exp": (1, 1, _guarded("exponential", sp.exp, -LARGEST_EXPONENT, LARGEST_EXPONENT)),
    "log": (1, 1, _guarded("logarithm", sp.log, 1 / LARGEST_NUMBER, LARGEST_NUMBER)),
    "quantity": (2, 3, _quantity),
}


def _bound(tree: ast.expr) -> None:
    level: list[ast.AST] = [tree]
    depth = count = 0
    while level:
        depth, count = depth + 1, count + len(level)
        if depth > DEEPEST or count > MOST_NODES:
            raise EquationError(
                "the expression is nested too deeply or too long; name parts of it with let"
            )
        level = [child for node in level for child in ast.iter_child_nodes(node)]


def _number(node: ast.Constant) -> float:
    value = node.value
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise EquationError(f"{_short(repr(value))} is not a number")
    if abs(value) > LARGEST_NUMBER:
        raise EquationError(f"a number larger than {LARGEST_NUMBER:g} is not allowed")
    return float(value)


def _finite(value: float) -> float:
    if not abs(value) <= LARGEST_NUMBER:
        raise EquationError(f"a number larger than {LARGEST_NUMBER:g} results")
    return value


def _index(node: ast.expr) -> int:
    if isinstance(node, ast.Constant) and type(node.value) is int:
        return node.value
    raise EquationError(
        f"the element {_short(ast.unparse(node))} is not a whole number from 0 upwards"
    )


def _short(text: str) -> str:
    return repr(text if len(text) <= 60 else f"{text[:57]}...")
