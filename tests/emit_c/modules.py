"""Modules written by hand: every feature of the representation, small enough to check on paper."""

from __future__ import annotations

import math
from dataclasses import replace

from symnav import ir
from tests.emit_c.building import (
    ERROR_SIZE,
    STATE,
    STATE_SIZE,
    Expression,
    Op,
    X,
    add,
    argument,
    call,
    domain,
    function,
    integers,
    mul,
    output,
    sub,
    x,
)


def rotation(at: int) -> tuple[list[ir.Step], list[list[str]]]:
    """Statements for R(q) of the unit quaternion stored from element ``at`` on."""
    w, i, j, k = (x(at + n) for n in range(4))

    def diagonal(first: Expression, second: Expression) -> Expression:
        return sub(1.0, mul(2.0, add(mul(first, first), mul(second, second))))

    def plus(first: Expression, second: Expression, third: Expression) -> Expression:
        return mul(2.0, add(mul(first, second), mul(w, third)))

    def minus(first: Expression, second: Expression, third: Expression) -> Expression:
        return mul(2.0, sub(mul(first, second), mul(w, third)))

    table = [
        [diagonal(j, k), minus(i, j, k), plus(i, k, j)],
        [plus(i, j, k), diagonal(i, k), minus(j, k, i)],
        [minus(i, k, j), plus(j, k, i), diagonal(i, j)],
    ]
    names = [[f"R{row}{column}" for column in range(3)] for row in range(3)]
    steps: list[ir.Step] = [
        ir.Statement(names[row][column], table[row][column], "R(q)" if row + column == 0 else "")
        for row in range(3)
        for column in range(3)
    ]
    return steps, names


def _lever(names: list[list[str]], of: str) -> list[ir.Statement]:
    arm = [ir.Load(of, axis) for axis in range(3)]
    return [
        ir.Statement(
            f"arm_{axis}",
            add(*(mul(names[row][column], arm[column]) for column in range(3))),
            "lever arm in n",
        )
        for row, axis in enumerate("xyz")
    ]


def antenna(**more: object) -> ir.Function:
    """Position of an antenna on a rotated lever arm that may not be too short."""
    steps, names = rotation(3)
    lever_arm = domain(
        "lever_arm", 0, "xyz", 0.0, frame="b", lower=(-2.0, -3.0, -4.0), upper=(2.0, 3.0, 0.1)
    )
    arm = [ir.Load("lever_arm", axis) for axis in range(3)]
    squared = ir.Check(
        target="length_squared",
        value=add(*(mul(a, a) for a in arm)),
        lower=1e-4,
        upper=math.inf,
        substitute=1.0,
        status=ir.Status.DOMAIN,
        comment="the lever arm is not shorter than a centimetre",
    )
    length = ir.Statement("length", call(Op.SQRT, "length_squared"), "length of the lever arm")
    value = [((row,), add(x(row), f"arm_{axis}")) for row, axis in enumerate("xyz")]
    value.append(((3,), ir.Ref("length")))

    # d(R l) = -R [l]x d for an error on the right
    def cross(row: int, column: int) -> Expression:
        first, second = (column + 1) % 3, (column + 2) % 3
        return sub(mul(names[row][second], arm[first]), mul(names[row][first], arm[second]))

    jacobian: list[tuple[tuple[int, ...], Expression | float]] = []
    for row in range(3):
        jacobian.append(((row, row), 1.0))
        jacobian += [((row, 3 + column), cross(row, column)) for column in range(3)]
    by_arm: list[tuple[tuple[int, ...], Expression | float]] = [
        ((row, column), ir.Ref(names[row][column])) for row in range(3) for column in range(3)
    ]
    by_arm += [((3, axis), call(Op.DIV, arm[axis], "length")) for axis in range(3)]
    base = function(
        "gps",
        [X, argument(lever_arm)],
        shared=(*steps, *_lever(names, "lever_arm"), squared, length),
        outputs=(
            output("value", (4,), value),
            output("jacobian", (4, ERROR_SIZE), jacobian),
            output("jacobian_lever_arm", (4, 3), by_arm),
        ),
    )
    return replace(base, **more)  # type: ignore[arg-type]


def pseudorange(**more: object) -> ir.Function:
    """Ranges to satellites with a clock per system and a slot per item."""
    steps, names = rotation(3)
    arguments = [
        X,
        argument(domain("lever_arm", 0, "xyz", 5.0, frame="b")),
        argument(domain("satellite_position", 0, "xyz", 6e7), item=True),
        argument(domain("correction", 0, ["value"], 1e4, frame=""), item=True),
        argument(integers("system", 0.0, 1.0), item=True),
        argument(integers("slot", 0.0, 10.0), item=True),
    ]
    shared: list[ir.Step] = [*steps, *_lever(names, "lever_arm")]
    shared += [
        ir.Statement(f"antenna_{axis}", add(x(row), f"arm_{axis}"), "antenna in n")
        for row, axis in enumerate("xyz")
    ]
    shared.append(
        ir.Check(
            "height",
            ir.Ref("antenna_z"),
            -9e4,
            9.9e4,
            0.0,
            ir.Status.DOMAIN,
            "the antenna is below the clouds",
        )
    )
    item: list[ir.Step] = [
        ir.Statement(
            f"d{axis}", sub(f"antenna_{axis}", ir.Load("satellite_position", row)), "line of sight"
        )
        for row, axis in enumerate("xyz")
    ]
    item.append(
        ir.Check(
            "range_squared",
            add(*(mul(f"d{axis}", f"d{axis}") for axis in "xyz")),
            1.0,
            1e18,
            1.0,
            ir.Status.DOMAIN,
            "the antenna is not at the satellite",
        )
    )
    item.append(ir.Statement("range", call(Op.SQRT, "range_squared"), "geometric range"))
    item.append(ir.Statement("inverse", call(Op.DIV, 1.0, "range")))
    item += [ir.Statement(f"u{axis}", mul(f"d{axis}", "inverse")) for axis in "xyz"]
    system = ir.Load("system", 0)
    item.append(
        ir.Statement(
            "clock", call(Op.SELECT, call(Op.EQ, system, 0.0), x(7), x(8)), "of this system"
        )
    )
    arm = [ir.Load("lever_arm", axis) for axis in range(3)]
    body = [
        add(*(mul(names[row][column], f"u{axis}") for row, axis in enumerate("xyz")))
        for column in range(3)
    ]
    item += [ir.Statement(f"b{column}", body[column]) for column in range(3)]
    spare = ir.Load("x", ir.Offset(9, ir.Load("slot", 0)))
    value = add("range", "clock", ir.Load("correction", 0), mul("height", 1e-3), mul(spare, 0.5))
    jacobian: list[tuple[tuple[int | ir.Offset, ...], Expression | float | str]] = [
        ((axis,), f"u{name}") for axis, name in enumerate("xyz")
    ]
    for column in range(3):
        first, second = (column + 1) % 3, (column + 2) % 3
        crossed = sub(mul(f"b{second}", arm[first]), mul(f"b{first}", arm[second]))
        jacobian.append(((3 + column,), crossed))
    jacobian += [
        ((6,), call(Op.SELECT, call(Op.EQ, system, 0.0), 1.0, 0.0)),
        ((7,), call(Op.SELECT, call(Op.EQ, system, 1.0), 1.0, 0.0)),
        ((ir.Offset(8, ir.Load("slot", 0)),), 0.5),
    ]
    base = function(
        "range",
        arguments,
        shared=tuple(shared),
        item=tuple(item),
        outputs=(
            output("value", (), [((), value)], item=True),
            output("jacobian", (ERROR_SIZE,), jacobian, item=True),
        ),
        maximum=20,
        single_difference=True,
    )
    return replace(base, **more)  # type: ignore[arg-type]


def two_rows(**more: object) -> ir.Function:
    """Two rows an item, one output that is common to all items, and no shared steps."""
    arguments = [X, argument(domain("anchor", 0, "xy", 1e3), item=True)]
    gap = [sub(x(axis), ir.Load("anchor", axis)) for axis in range(2)]
    item: tuple[ir.Step, ...] = (
        ir.Check("along", gap[0], -500.0, 500.0, 0.0, ir.Status.DOMAIN, "not too far along"),
        ir.Check("across", gap[1], -400.0, 400.0, 0.0, ir.Status.INDEX, "nor along the second"),
    )
    base = function(
        "rows",
        arguments,
        item=item,
        outputs=(
            output("value", (2,), [((0,), "along"), ((1,), mul("along", "across"))], item=True),
            output(
                "jacobian",
                (2, ERROR_SIZE),
                [((0, 0), 1.0), ((1, 0), "across"), ((1, 1), "along")],
                item=True,
            ),
            output("offset", (3,), [((1,), x(7))]),
        ),
        maximum=33,
    )
    return replace(base, **more)  # type: ignore[arg-type]


def everything(**more: object) -> ir.Function:
    """Every operation, a rotation matrix as an input, and checks with two different statuses."""
    matrix = domain(
        "mounting",
        0,
        [f"{row}{column}" for row in range(3) for column in range(3)],
        1.01,
        kind=ir.Kind.MATRIX,
        tolerance=1e-2,
        unit="1",
        frame="b -> n",
    )
    pair = domain("pair", 0, ["first", "second"], 4.0, unit="1", frame="")
    choice = integers("choice", -2.0, 3.0)
    a, b = ir.Load("pair", 0), ir.Load("pair", 1)
    m = [ir.Load("mounting", index) for index in range(9)]
    unary = (
        *(Op.NEG, Op.SQRT, Op.SIN, Op.COS, Op.TAN, Op.ASIN, Op.ACOS, Op.ATAN, Op.EXP, Op.LOG),
        *(Op.OWN_SIN, Op.OWN_COS),
    )
    shared: list[ir.Step] = [
        ir.Check("bounded", call(Op.DIV, a, 5.0), -0.75, 0.75, 0.0, ir.Status.DOMAIN, "asin, acos"),
        ir.Check("positive", add(b, 1.5), 0.25, 6.0, 1.0, ir.Status.INDEX, "sqrt, log"),
        ir.Check("gap", sub(b, 4.5), -9.0, -0.25, -1.0, ir.Status.INDEX, "division"),
    ]
    inputs = {Op.SQRT: "positive", Op.LOG: "positive", Op.ASIN: "bounded", Op.ACOS: "bounded"}
    values: list[Expression] = [call(op, inputs.get(op, a)) for op in unary]
    values += [call(op, a, b) for op in (Op.ADD, Op.SUB, Op.MUL, Op.ATAN2, Op.MIN, Op.MAX)]
    values += [call(Op.DIV, a, "gap"), call(Op.ABS, a), call(Op.FLOOR, b)]
    conditions = [
        call(Op.LT, a, b),
        call(Op.LE, a, b),
        call(Op.EQ, call(Op.FLOOR, a), call(Op.FLOOR, b)),
        call(Op.NE, ir.Load("choice", 0), 2.0),
        call(Op.AND, call(Op.LT, a, 0.0), call(Op.LT, b, 0.0)),
        call(Op.OR, call(Op.LT, a, 0.0), call(Op.LT, b, 0.0)),
        call(Op.NOT, call(Op.AND, call(Op.NOT, call(Op.LT, a, 0.0)), call(Op.LE, b, a))),
    ]
    values += [call(Op.SELECT, condition, 1.25, mul(-0.1, a)) for condition in conditions]
    # Groupings that only parentheses keep.
    values += [
        sub(a, sub(b, m[1])),
        sub(sub(a, b), m[1]),
        call(Op.DIV, a, call(Op.DIV, "gap", "positive")),
        mul(a, call(Op.DIV, b, "gap")),
        call(Op.NEG, call(Op.NEG, add(a, call(Op.NEG, b)))),
        sub(ir.Number(-3.0), ir.Number(-1e-7)),
        add(*m),
        mul(call(Op.SELECT, call(Op.LT, a, b), a, b), ir.Load("choice", 0)),
    ]
    base = function(
        "all",
        [X, argument(matrix), argument(pair), argument(choice)],
        shared=tuple(shared),
        outputs=(output("value", (len(values),), [((k,), v) for k, v in enumerate(values)]),),
    )
    return replace(base, **more)  # type: ignore[arg-type]


def retract() -> ir.Function:
    """A retract of vectors only, in which one element is constant and names need care."""
    step = domain("d", 0, [str(k) for k in range(ERROR_SIZE)], 10.0, unit="1", frame="")
    entries: list[tuple[tuple[int, ...], Expression | float | str]] = [
        ((k,), add(x(k), ir.Load("d", k))) for k in range(3)
    ]
    entries += [((3,), 1.0), ((7,), "in"), ((8,), "IN"), ((9,), "double"), ((10,), "y1")]
    shared = tuple(
        ir.Statement(name, mul(x(7 + k), 2.0), "a name */ that C has taken /* already")
        for k, name in enumerate(("in", "IN", "double", "y1"))
    )
    return function(
        "retract",
        [X, argument(step)],
        role=ir.Role.RETRACT,
        shared=shared,
        outputs=(output("value", (STATE_SIZE,), entries),),
    )


def module(*functions: ir.Function, scalar: ir.Scalar = ir.Scalar.DOUBLE) -> ir.Module:
    """A module of some functions, called ``rover``; in single precision, ``rover_f32``."""
    name = "rover" if scalar is ir.Scalar.DOUBLE else "rover_f32"
    return ir.Module(name, scalar, STATE, functions, "0123abcd" * 8, "symnav for tests")


def all_functions() -> tuple[ir.Function, ...]:
    """Every function in every variant, each under a name of its own."""
    return (
        retract(),
        antenna(),
        antenna(name="gps_columns", column_major=True),
        antenna(name="gps_bare", guards=ir.Guards.ASSUME),
        antenna(name="gps_outer", guards=ir.Guards.OUTER),
        pseudorange(),
        pseudorange(name="strict", items=ir.Items.REJECT),
        pseudorange(name="columns", column_major=True),
        pseudorange(name="bare", guards=ir.Guards.ASSUME, items=ir.Items.REJECT),
        pseudorange(name="range_outer", guards=ir.Guards.OUTER),
        pseudorange(name="strict_outer", guards=ir.Guards.OUTER, items=ir.Items.REJECT),
        two_rows(),
        two_rows(name="rows_columns", column_major=True, single_difference=True),
        everything(),
        # Without the state, of which it reads nothing.
        everything(name="all_outer", guards=ir.Guards.OUTER, arguments=everything().arguments[1:]),
    )
