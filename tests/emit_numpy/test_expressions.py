"""The text of expressions: groupings kept, parentheses where they say something."""

from __future__ import annotations

import itertools
import re

import pytest

from symnav import ir
from symnav.emit.numpy.expressions import Scope, text_of
from symnav.emit.numpy.kernel import kernel_of
from tests.emit_numpy import modules, records
from tests.emit_numpy.records import add, call, mul, number, ref, sub

Op = ir.Operation
A, B, C = (ir.Load("x", index) for index in range(3))
SCOPE = Scope({}, lambda load: "abc"[int(str(load.index))])


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (add(A, B, C), "a + b + c"),
        (add(A, add(B, C)), "a + (b + c)"),
        (sub(A, sub(B, C)), "a - (b - c)"),
        (add(mul(A, B), mul(B, C)), "a * b + b * c"),
        (mul(A, mul(B, C)), "a * (b * c)"),
        (mul(add(A, B), C), "(a + b) * c"),
        (call(Op.DIV, A, call(Op.DIV, B, C)), "a / (b / c)"),
        (call(Op.NEG, mul(A, B)), "-(a * b)"),
        (mul(call(Op.NEG, A), B), "-a * b"),
        (sub(A, call(Op.NEG, B)), "a - (-b)"),
        (add(A, number(-2.0)), "a + (-2.0)"),
        (call(Op.MAX, A, number(1e-12)), "xp.maximum(a, 1e-12)"),
        (call(Op.SELECT, call(Op.LT, A, B), A, number(0.0)), "xp.where(xp.less(a, b), a, 0.0)"),
        (call(Op.SQRT, number(2.0)), "1.4142135623730951"),
        (call(Op.SELECT, call(Op.LT, number(1.0), number(2.0)), A, B), "a"),
    ],
)
def test_text(expression: ir.Expression, text: str) -> None:
    """Each case as a person would write it."""
    assert text_of(expression, SCOPE).text == text


def trees(depth: int) -> list[ir.Expression]:
    """Every expression of two operations and signs over three elements."""
    if depth == 0:
        return [A, B, C]
    smaller = trees(depth - 1)[:9]
    grown: list[ir.Expression] = [
        call(operation, left, right)
        for operation in (Op.ADD, Op.SUB, Op.MUL, Op.DIV)
        for left, right in itertools.product(smaller, repeat=2)
    ]
    return [*grown, *(call(Op.NEG, one) for one in smaller)]


def test_python_groups_as_the_tree_does() -> None:
    """Python's own parser reads every text back as the tree it came from."""
    import ast

    symbols = {ast.Add: Op.ADD, ast.Sub: Op.SUB, ast.Mult: Op.MUL, ast.Div: Op.DIV}
    names = {"a": A, "b": B, "c": C}

    def read(node: ast.expr) -> ir.Expression:
        if isinstance(node, ast.Name):
            return names[node.id]
        if isinstance(node, ast.UnaryOp):
            return call(Op.NEG, read(node.operand))
        assert isinstance(node, ast.BinOp)
        return call(symbols[type(node.op)], read(node.left), read(node.right))

    cases = [tree for inner in trees(1)[::3] for tree in (mul(inner, C), sub(A, inner))]
    cases += trees(2)
    for tree in cases:
        assert read(ast.parse(text_of(tree, SCOPE).text, mode="eval").body) == tree


def test_locals_never_clash() -> None:
    """Keywords, names of the kernel itself and equal names of different things are told apart."""
    arm = records.argument(records.domain("lambda", 3, (-1.0, 1.0)))
    steps = [
        ir.Statement(name, add(ir.Load("lambda", 0), number(1.0)))
        for name in ("xp", "guards", "position_x", "class", "lambda_x", "2nd")
    ]
    entries = [((i,), add(ref(step.target), modules.x(0))) for i, step in enumerate(steps)]
    function = records.function(
        "odd", (modules.X, arm), (records.output("value", (6,), entries),), shared=steps
    )
    body = "\n".join(kernel_of(function).body)
    targets = [line.split(" = ")[0].strip() for line in body.splitlines() if " = " in line]
    assert len(targets) == len(set(targets))
    assert not {"xp", "guards", "class", "2nd"} & set(targets)


def test_constants_never_become_code() -> None:
    """What depends on no argument is worked out when the file is written."""
    body = "\n".join(kernel_of(modules.operations()).body)
    assert "two" not in body
    assert "root" not in body
    assert "1.4142135623730951 * a" in body


def test_names_are_deleted_when_nothing_reads_them() -> None:
    """Each once, after its last use; results, elements and what items read are kept."""
    for function in modules.module(modules.chain()).functions:
        lines = [line.strip() for line in kernel_of(function).body]
        deleted = [
            (name, place)
            for place, line in enumerate(lines)
            if line.startswith("del ")
            for name in line.removeprefix("del ").split(", ")
        ]
        names = [name for name, _ in deleted]
        assert len(names) == len(set(names))
        for name, place in deleted:
            word = re.compile(rf"\b{name}\b")
            assert any(word.match(line) for line in lines[:place])
            assert not any(word.search(line) for line in lines[place + 1 :])
        if function.name == "chain":
            assert names == [f"t{number}" for number in range(18)]
