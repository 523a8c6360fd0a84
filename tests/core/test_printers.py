"""Printed expressions read back: C's and Python's grammar give the tree that was printed."""

from __future__ import annotations

import ast
from collections.abc import Callable
from random import Random

import pytest

from symnav import ir
from symnav.emit.c import expressions as c
from symnav.emit.c.target import Target
from symnav.emit.numpy import expressions as numpy

Op = ir.Operation
INFIX = {ast.Add: Op.ADD, ast.Sub: Op.SUB, ast.Mult: Op.MUL, ast.Div: Op.DIV}
ARITHMETIC = (Op.ADD, Op.SUB, Op.MUL, Op.DIV)
NAMES = ("alpha", "beta", "gamma")


def element(load: ir.Load) -> str:
    """An element of an argument."""
    return f"{load.argument}[{load.index}]"


def in_c(expression: ir.Expression) -> str:
    """Text of the C printer; names and loads stand for themselves."""
    target = Target("t", ir.Scalar.DOUBLE)
    scope = c.Scope(
        target, lambda name: name, lambda load: c.Text(f"{load.argument}[{load.index}]")
    )
    return c.format_expression(expression, scope)


def in_numpy(expression: ir.Expression) -> str:
    """Text of the NumPy printer."""
    references = {name: numpy.Text(name) for name in NAMES}
    scope = numpy.Scope(references, element)
    return numpy.text_of(expression, scope).text


PRINTERS = [in_c, in_numpy]
Printer = Callable[[ir.Expression], str]


def read(text: str) -> ir.Expression:
    """The tree of an arithmetic text: the two languages group the same way."""
    return _read(ast.parse(text, mode="eval").body)


def _read(node: ast.expr) -> ir.Expression:
    if isinstance(node, ast.BinOp):
        return ir.Call(INFIX[type(node.op)], (_read(node.left), _read(node.right)))
    if isinstance(node, ast.UnaryOp):
        assert isinstance(node.op, ast.USub), ast.unparse(node)
        inner = _read(node.operand)
        if isinstance(inner, ir.Number):
            return ir.Number(-inner.value)
        return ir.Call(Op.NEG, (inner,))
    if isinstance(node, ast.Constant):
        return ir.Number(float(node.value))  # type: ignore[arg-type]
    if isinstance(node, ast.Subscript):
        assert isinstance(node.value, ast.Name) and isinstance(node.slice, ast.Constant)
        return ir.Load(node.value.id, int(str(node.slice.value)))
    if isinstance(node, ast.Call):
        return ir.Call(_operation(node.func), tuple(_read(a) for a in node.args))
    assert isinstance(node, ast.Name)
    return ir.Ref(node.id)


def _operation(function: ast.expr) -> ir.Operation:
    if isinstance(function, ast.Attribute):
        return Op(function.attr)
    assert isinstance(function, ast.Name)
    return Op(function.id)


def tree(rng: Random, depth: int) -> ir.Expression:
    """A random expression; every call reads at least one name, so that nothing is folded."""
    if depth == 0 or rng.random() < 0.15:
        return ir.Ref(rng.choice(NAMES)) if rng.random() < 0.7 else ir.Load("x", rng.randrange(9))
    kind = rng.randrange(6)
    if kind == 0:
        return ir.Call(Op.NEG, (tree(rng, depth - 1),))
    if kind == 1:
        return ir.Call(rng.choice((Op.SQRT, Op.SIN)), (tree(rng, depth - 1),))
    operands = [tree(rng, depth - 1), tree(rng, depth - 1)]
    if kind == 2:
        operands[rng.randrange(2)] = ir.Number(rng.choice((2.0, -0.5, 1e-300, 6378137.0)))
    return ir.Call(rng.choice(ARITHMETIC), tuple(operands))


@pytest.mark.parametrize("printer", PRINTERS)
@pytest.mark.parametrize("seed", range(5))
def test_random_trees(seed: int, printer: Printer) -> None:
    """Every grouping is kept: floating-point sums and products are not associative."""
    rng = Random(seed)
    for _ in range(200):
        expression = tree(rng, 5)
        assert read(printer(expression)) == expression


def chained(*operations: ir.Operation) -> ir.Expression:
    """A left-leaning tree."""
    result: ir.Expression = ir.Ref("alpha")
    for operation in operations:
        result = ir.Call(operation, (result, ir.Ref("beta")))
    return result


@pytest.mark.parametrize("printer", PRINTERS)
@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (chained(Op.ADD, Op.SUB), "alpha + beta - beta"),
        (chained(Op.MUL, Op.MUL), "alpha * beta * beta"),
        (ir.Call(Op.SUB, (ir.Ref("alpha"), chained(Op.SUB))), "alpha - (alpha - beta)"),
        (ir.Call(Op.DIV, (ir.Ref("beta"), chained(Op.DIV))), "beta / (alpha / beta)"),
        (ir.Call(Op.NEG, (ir.Ref("alpha"),)), "-alpha"),
        (ir.Call(Op.NEG, (chained(Op.ADD),)), "-(alpha + beta)"),
        (ir.Call(Op.SUB, (ir.Ref("alpha"), ir.Number(-2.0))), "alpha - (-2.0)"),
    ],
)
def test_parentheses(expression: ir.Expression, text: str, printer: Printer) -> None:
    """Only where the language would group otherwise, or a reader would have to think."""
    assert printer(expression) == text


@pytest.mark.parametrize(
    ("operation", "value"),
    [
        (Op.ADD, 9.0), (Op.SUB, 5.0), (Op.MUL, 14.0), (Op.DIV, 3.5), (Op.MIN, 2.0), (Op.MAX, 7.0),
    ],
)  # fmt: skip
def test_numpy_works_out_constants(operation: ir.Operation, value: float) -> None:
    """What depends on no argument is a number already."""
    assert in_numpy(ir.Call(operation, (ir.Number(7.0), ir.Number(2.0)))) == repr(value)
    assert in_numpy(ir.Call(Op.NEG, (ir.Number(7.0),))) == "-7.0"
    selected = ir.Call(operation, (ir.Number(7.0), ir.Number(2.0)))
    negated = ir.Call(Op.MUL, (ir.Ref("alpha"), ir.Call(Op.NEG, (selected,))))
    assert read(in_numpy(negated)) == ir.Call(Op.MUL, (ir.Ref("alpha"), ir.Number(-value)))


def test_choices_and_conditions() -> None:
    """In C by operators, in NumPy by functions of the namespace."""
    condition = ir.Call(Op.AND, (
        ir.Call(Op.LT, (ir.Ref("alpha"), ir.Ref("beta"))),
        ir.Call(Op.NOT, (ir.Call(Op.LE, (ir.Ref("beta"), ir.Ref("gamma"))),)),
    ))  # fmt: skip
    choice = ir.Call(Op.SELECT, (condition, ir.Ref("alpha"), ir.Ref("beta")))
    assert in_c(choice) == "((alpha < beta) && (!(beta <= gamma))) ? alpha : beta"
    assert in_numpy(choice) == (
        "xp.where(xp.logical_and(xp.less(alpha, beta), xp.logical_not(xp.less_equal(beta, gamma))),"
        " alpha, beta)"
    )
    unequal = ir.Call(Op.NE, (ir.Ref("alpha"), ir.Ref("beta")))
    assert in_c(unequal) == "!is_equal(alpha, beta)"
    assert in_numpy(unequal) == "xp.not_equal(alpha, beta)"
