"""Expressions of the intermediate representation as Python over an array namespace ``xp``.

Every grouping of the tree is kept, since floating-point arithmetic is not associative; parentheses
are left out only where Python groups the same way. What depends on no argument is worked
out here: the array API standard asks for at least one array in every call.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import IntEnum
from functools import singledispatch

from symnav import ir
from symnav.emit.python.text import literal

Operation = ir.Operation


class Level(IntEnum):
    """How loosely a piece of text holds together."""

    ATOM = 0
    SIGN = 1
    PRODUCT = 2
    SUM = 3


_INFIX = {
    Operation.ADD: ("+", Level.SUM),
    Operation.SUB: ("-", Level.SUM),
    Operation.MUL: ("*", Level.PRODUCT),
    Operation.DIV: ("/", Level.PRODUCT),
}

_NAMESPACE = {
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
    Operation.ABS: "abs",
    Operation.FLOOR: "floor",
    Operation.MIN: "minimum",
    Operation.MAX: "maximum",
    Operation.LT: "less",
    Operation.LE: "less_equal",
    Operation.EQ: "equal",
    Operation.NE: "not_equal",
    Operation.AND: "logical_and",
    Operation.OR: "logical_or",
    Operation.NOT: "logical_not",
    Operation.SELECT: "where",
}

_NUMBERS: Mapping[ir.Operation, Callable[..., float | bool]] = {
    Operation.ADD: operator.add,
    Operation.SUB: operator.sub,
    Operation.MUL: operator.mul,
    Operation.DIV: operator.truediv,
    Operation.NEG: operator.neg,
    Operation.SQRT: math.sqrt,
    Operation.SIN: math.sin,
    Operation.COS: math.cos,
    Operation.TAN: math.tan,
    Operation.ASIN: math.asin,
    Operation.ACOS: math.acos,
    Operation.ATAN: math.atan,
    Operation.ATAN2: math.atan2,
    Operation.EXP: math.exp,
    Operation.LOG: math.log,
    Operation.ABS: abs,
    Operation.FLOOR: math.floor,
    Operation.MIN: min,
    Operation.MAX: max,
    Operation.LT: operator.lt,
    Operation.LE: operator.le,
    Operation.EQ: operator.eq,
    Operation.NE: operator.ne,
    Operation.AND: lambda left, right: left and right,
    Operation.OR: lambda left, right: left or right,
    Operation.NOT: operator.not_,
    Operation.SELECT: lambda condition, chosen, otherwise: chosen if condition else otherwise,
}


@dataclass(frozen=True, slots=True)
class Text:
    """A piece of Python, or a number that is known already.

    Attributes:
        text: how it is written.
        level: how loosely it holds together.
        number: its value, where it depends on no argument.
    """

    text: str
    level: Level = Level.ATOM
    number: float | bool | None = None

    def within(self, loosest: Level) -> str:
        """The text as an operand, in parentheses where it is looser than the place allows."""
        return self.text if self.level <= loosest else f"({self.text})"


@dataclass(frozen=True, slots=True)
class Scope:
    """What names stand for at one place of a kernel.

    Attributes:
        references: earlier steps by target.
        load: the text of an element of an argument.
    """

    references: Mapping[str, Text]
    load: Callable[[ir.Load], str]


def number(value: float | bool) -> Text:
    """A literal that reads back exactly."""
    if isinstance(value, bool):
        return Text(repr(value), number=value)
    text = literal(value).replace("math.inf", "_inf")
    return Text(text, Level.SIGN if text.startswith("-") else Level.ATOM, float(value))


@singledispatch
def text_of(expression: ir.Expression, scope: Scope) -> Text:
    """The Python text of an expression."""
    raise TypeError(f"not an expression: {expression!r}")


@text_of.register
def _(expression: ir.Number, scope: Scope) -> Text:
    return number(expression.value)


@text_of.register
def _(expression: ir.Ref, scope: Scope) -> Text:
    return scope.references[expression.name]


@text_of.register
def _(expression: ir.Load, scope: Scope) -> Text:
    return Text(scope.load(expression))


@text_of.register
def _(expression: ir.Call, scope: Scope) -> Text:
    operands = [text_of(operand, scope) for operand in expression.operands]
    operation = expression.operation
    if operation is Operation.SELECT and operands[0].number is not None:
        return operands[1] if operands[0].number else operands[2]
    if all(operand.number is not None for operand in operands):
        return number(_NUMBERS[operation](*(operand.number for operand in operands)))
    if operation in _INFIX:
        return _infix(operation, *operands)
    if operation is Operation.NEG:
        return Text(f"-{operands[0].within(Level.ATOM)}", Level.SIGN)
    return Text(f"xp.{_NAMESPACE[operation]}({', '.join(_parameters(operation, operands))})")


def _infix(operation: ir.Operation, left: Text, right: Text) -> Text:
    symbol, level = _INFIX[operation]
    tightest = Level.PRODUCT if level is Level.SUM and right.level is Level.PRODUCT else Level.ATOM
    return Text(f"{left.within(level)} {symbol} {right.within(tightest)}", level)


def _parameters(operation: ir.Operation, operands: list[Text]) -> list[str]:
    texts = [operand.text for operand in operands]
    if operation is Operation.SELECT and operands[1].number is not None:
        # A choice between two numbers has no array that would give the result its type.
        texts[1] = f"guards.constant({texts[1]})"
    return texts
