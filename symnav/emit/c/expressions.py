"""Expressions of the intermediate representation as C, in the order they are written down.

Floating-point arithmetic is not associative, so the text keeps every grouping of the tree:
parentheses are left out only where C's own rules give the same grouping and a reader needs no
table of precedences to see it (chains of sums, chains of products).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from functools import singledispatch

from symnav import ir
from symnav.emit.c.target import Target

Operation = ir.Operation

_SYMBOLS = {
    Operation.ADD: "+",
    Operation.SUB: "-",
    Operation.MUL: "*",
    Operation.DIV: "/",
    Operation.LT: "<",
    Operation.LE: "<=",
    Operation.AND: "&&",
    Operation.OR: "||",
}

_LIBRARY = {
    Operation.SQRT: "sqrt",
    Operation.SIN: "sin",
    Operation.COS: "cos",
    Operation.TAN: "tan",
    Operation.ASIN: "asin",
    Operation.ACOS: "acos",
    Operation.ATAN: "atan",
    Operation.ATAN2: "atan2",
    Operation.EXP: "exp",
    Operation.LOG: "log",
    Operation.ABS: "fabs",
    Operation.FLOOR: "floor",
}

# Operations that call the library, which may tell of an argument outside their domain.
LIBRARY_CALLS = frozenset(_LIBRARY) - {Operation.SQRT, Operation.ABS, Operation.FLOOR}

# Operations C99 has no operator or fast function for; each is an inline helper of the check file.
HELPERS = {
    Operation.MIN: "smaller_of",
    Operation.MAX: "larger_of",
    Operation.EQ: "is_equal",
    Operation.NE: "is_equal",
}

# Inline functions of the trigonometry file.
SINUSOIDS = {
    Operation.OWN_SIN: "sine_of",
    Operation.OWN_COS: "cosine_of",
}


class Level(IntEnum):
    """How tightly a piece of text holds together."""

    ATOM = 0
    PRODUCT = 1
    QUOTIENT = 2
    SUM = 3
    SIGN = 4
    RELATION = 5
    CONJUNCTION = 6
    DISJUNCTION = 7
    CHOICE = 8


_LEVELS = {
    Operation.ADD: Level.SUM,
    Operation.SUB: Level.SUM,
    Operation.MUL: Level.PRODUCT,
    Operation.DIV: Level.QUOTIENT,
    Operation.LT: Level.RELATION,
    Operation.LE: Level.RELATION,
    Operation.AND: Level.CONJUNCTION,
    Operation.OR: Level.DISJUNCTION,
}

_CHAINS = frozenset({Level.SUM, Level.PRODUCT, Level.CONJUNCTION, Level.DISJUNCTION})


@dataclass(frozen=True, slots=True)
class Text:
    """A piece of C and how tightly it holds together."""

    text: str
    level: Level = Level.ATOM

    @property
    def operand(self) -> str:
        """The text as an operand of something else."""
        return self.text if self.level is Level.ATOM else f"({self.text})"


@dataclass(frozen=True, slots=True)
class Scope:
    """What names and loads are called at one place of the C.

    Attributes:
        target: the tree.
        reference: C text of the value of an earlier step, by its name.
        load: C text of an element of an argument.
    """

    target: Target
    reference: Callable[[str], str]
    load: Callable[[ir.Load], Text]


def format_expression(expression: ir.Expression, scope: Scope) -> str:
    """The whole expression as C text."""
    return _text(expression, scope).text


@singledispatch
def _text(expression: ir.Expression, scope: Scope) -> Text:
    raise TypeError(f"not an expression: {expression!r}")


@_text.register
def _(expression: ir.Number, scope: Scope) -> Text:
    text = scope.target.literal(expression.value)
    return Text(text, Level.SIGN if text.startswith("-") else Level.ATOM)


@_text.register
def _(expression: ir.Ref, scope: Scope) -> Text:
    return Text(scope.reference(expression.name))


@_text.register
def _(expression: ir.Load, scope: Scope) -> Text:
    return scope.load(expression)


@_text.register
def _(expression: ir.Call, scope: Scope) -> Text:
    operation = expression.operation
    operands = [_text(operand, scope) for operand in expression.operands]
    if operation in _SYMBOLS:
        return _infix(operation, *operands)
    if operation in SINUSOIDS:
        return _invoke(SINUSOIDS[operation], operands)
    if operation in _LIBRARY:
        return _invoke(scope.target.function(_LIBRARY[operation]), operands)
    if operation is Operation.NEG:
        return Text(f"-{operands[0].operand}", Level.SIGN)
    if operation is Operation.NOT:
        return Text(f"!{operands[0].operand}", Level.SIGN)
    if operation is Operation.SELECT:
        condition, chosen, otherwise = (operand.operand for operand in operands)
        return Text(f"{condition} ? {chosen} : {otherwise}", Level.CHOICE)
    helper = _invoke(HELPERS[operation], operands)
    return Text(f"!{helper.text}", Level.SIGN) if operation is Operation.NE else helper


def _infix(operation: ir.Operation, left: Text, right: Text) -> Text:
    """Two operands; only a chain of the same kind goes without parentheses, and on the left."""
    level = _LEVELS[operation]
    first = left.text if left.level is level and level in _CHAINS else left.operand
    return Text(f"{first} {_SYMBOLS[operation]} {right.operand}", level)


def _invoke(name: str, operands: list[Text]) -> Text:
    return Text(f"{name}({', '.join(operand.text for operand in operands)})")
