"""Hand-written modules that between them use every feature of the intermediate representation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symnav import ir
from tests.emit_numpy.records import (
    INF,
    Op,
    add,
    argument,
    call,
    domain,
    function,
    mul,
    number,
    output,
    ref,
    sub,
)


def quaternion(w: ir.Load, x: ir.Load, y: ir.Load, z: ir.Load) -> list[list[ir.Expression]]:
    """The rotation matrix of a unit quaternion, row by row."""
    two = number(2.0)

    def twice(
        a: ir.Expression, b: ir.Expression, c: ir.Expression, d: ir.Expression, op: ir.Operation
    ) -> ir.Expression:
        return mul(two, call(op, mul(a, b), mul(c, d)))

    def diagonal(a: ir.Expression, b: ir.Expression) -> ir.Expression:
        return sub(number(1.0), twice(a, a, b, b, Op.ADD))

    return [
        [diagonal(y, z), twice(x, y, w, z, Op.SUB), twice(x, z, w, y, Op.ADD)],
        [twice(x, y, w, z, Op.ADD), diagonal(x, z), twice(y, z, w, x, Op.SUB)],
        [twice(x, z, w, y, Op.SUB), twice(y, z, w, x, Op.ADD), diagonal(x, y)],
    ]


STATE_DOMAINS = (
    domain("position", 3, (-1e5, 1e5), frame="n"),
    domain(
        "attitude",
        4,
        (-1.1, 1.1),
        start=3,
        kind=ir.Kind.QUATERNION,
        unit="1",
        frame="b -> n",
        tolerance=1e-6,
    ),
    domain("bias_gps", 1, (-1e6, 1e6), start=7),
    domain("bias_galileo", 1, (-1e6, 1e6), start=8),
    domain("ambiguity", 4, (-1e4, 1e4), start=9),
)
SIZE, ERROR_SIZE = 13, 12
X = ir.Argument("x", SIZE, False, False, STATE_DOMAINS)


def x(index: int) -> ir.Load:
    """An element of the state."""
    return ir.Load("x", index)


def state() -> ir.State:
    """Position, attitude, two clock biases, one ambiguity for each of four slots."""
    blocks, start = [], 0
    for own in STATE_DOMAINS:
        size = 3 if own.kind is ir.Kind.QUATERNION else own.size
        initial = (1.0, 0.0, 0.0, 0.0) if own.kind is ir.Kind.QUATERNION else (0.5,) * own.size
        blocks.append(
            ir.StateBlock(
                name=own.name,
                kind="rotation" if size != own.size else "vector",
                storage=own,
                error_start=start,
                error_size=size,
                error_unit="rad" if size != own.size else "m",
                error_frame="b",
                error_labels=tuple(str(n) for n in range(size)),
                convention="x = x0 + d",
                initial=initial,
            )
        )
        start += size
    return ir.State(tuple(blocks), SIZE, ERROR_SIZE, "0" * 64)


ROTATION = quaternion(x(3), x(4), x(5), x(6))


def rotated(
    matrix: list[list[ir.Expression]], vector: Sequence[ir.Expression]
) -> list[ir.Expression]:
    """A matrix times a vector."""
    return [add(*(mul(e, v) for e, v in zip(row, vector, strict=True))) for row in matrix]


def gps() -> ir.Function:
    """A rotated lever arm: a check on its length, an identity block, two Jacobians."""
    arm = [ir.Load("lever_arm", n) for n in range(3)]
    steps: list[ir.Step] = [
        ir.Statement(f"r{i}{j}", ROTATION[i][j], "rotation" if i == j else "")
        for i in range(3)
        for j in range(3)
    ]
    steps.append(
        ir.Check(
            "length",
            add(*(mul(a, a) for a in arm)),
            1e-6,
            INF,
            1.0,
            ir.Status.DOMAIN,
            "squared length of the lever arm",
        )
    )
    matrix: list[list[ir.Expression]] = [[ref(f"r{i}{j}") for j in range(3)] for i in range(3)]
    turned = rotated(matrix, arm)
    # R [l]x, column by column
    cross: list[list[ir.Expression]] = [
        [sub(mul(row[1], arm[2]), mul(row[2], arm[1])) for row in matrix],
        [sub(mul(row[2], arm[0]), mul(row[0], arm[2])) for row in matrix],
        [sub(mul(row[0], arm[1]), mul(row[1], arm[0])) for row in matrix],
    ]
    jacobian: list[tuple[tuple[int, ...], ir.Expression]] = []
    for i in range(3):
        jacobian.append(((i, i), number(1.0)))
        jacobian += [((i, 3 + j), call(Op.NEG, cross[j][i])) for j in range(3)]
    return function(
        "gps",
        (X, argument(domain("lever_arm", 3, (-10.0, 10.0), frame="b"))),
        (
            output("value", (3,), [((i,), add(x(i), turned[i])) for i in range(3)]),
            output("length", (), [((), call(Op.SQRT, ref("length")))]),
            output("jacobian", (3, ERROR_SIZE), jacobian),
            output(
                "jacobian_lever_arm",
                (3, 3),
                [((i, j), matrix[i][j]) for i in range(3) for j in range(3)],
            ),
        ),
        shared=steps,
    )


def ranges(name: str = "ranges", items: ir.Items = ir.Items.SKIP) -> ir.Function:
    """Ranges to satellites: a clock by system, an ambiguity by slot, a shared offset."""
    satellite = [ir.Load("satellite", n) for n in range(3)]
    system, slot = ir.Load("system", 0), ir.Load("slot", 0)
    shared: list[ir.Step] = [
        ir.Statement("antenna_z", add(x(2), ir.Load("height", 0))),
        ir.Check("scale", ir.Load("height", 0), -50.0, 50.0, 0.0, ir.Status.DOMAIN, "height"),
    ]
    antenna: list[ir.Expression] = [x(0), x(1), ref("antenna_z")]
    deltas = [sub(s, a) for s, a in zip(satellite, antenna, strict=True)]
    item: list[ir.Step] = [
        *(ir.Statement(f"d{i}", delta) for i, delta in enumerate(deltas)),
        ir.Check(
            "squared",
            add(*(mul(ref(f"d{i}"), ref(f"d{i}")) for i in range(3))),
            1.0,
            INF,
            1.0,
            ir.Status.DOMAIN,
            "squared range",
        ),
        ir.Statement("range", call(Op.SQRT, ref("squared"))),
        ir.Statement("inverse", call(Op.DIV, number(1.0), ref("range"))),
        ir.Statement(
            "clock",
            call(Op.SELECT, call(Op.EQ, system, number(0.0)), x(7), x(8)),
        ),
        ir.Statement("ambiguity", _by_slot(slot)),
    ]
    gradient: list[tuple[tuple[int | ir.Offset, ...], ir.Expression]] = [
        ((i,), call(Op.NEG, mul(ref(f"d{i}"), ref("inverse")))) for i in range(3)
    ]
    gradient += [
        ((6,), call(Op.SELECT, call(Op.EQ, system, number(0.0)), number(1.0), number(0.0))),
        ((7,), call(Op.SELECT, call(Op.EQ, system, number(1.0)), number(1.0), number(0.0))),
        ((ir.Offset(8, slot),), ref("scale_of_slot")),
    ]
    total = add(ref("range"), ref("clock"), ref("ambiguity"))
    item.append(ir.Statement("scale_of_slot", add(number(1.0), mul(ref("scale"), number(0.01)))))
    return function(
        name,
        (
            X,
            argument(domain("height", 1, (-100.0, 100.0))),
            argument(domain("satellite", 3, (-1e8, 1e8), frame="e"), item=True),
            argument(domain("system", 1, (0.0, 1.0), kind=ir.Kind.INTEGER, unit="1"), item=True),
            argument(domain("slot", 1, (0.0, 3.0), kind=ir.Kind.INTEGER, unit="1"), item=True),
        ),
        (
            output("value", (), [((), total)], item=True),
            output("top", (), [((), ref("antenna_z"))]),
            output("jacobian", (ERROR_SIZE,), gradient, item=True),
        ),
        shared=shared,
        item=item,
        maximum=8,
        items=items,
        single_difference=True,
    )


def _by_slot(slot: ir.Load) -> ir.Expression:
    """``(1 + height / 100)`` times the ambiguity of a slot."""
    chosen = ir.Load("x", ir.Offset(9, slot))
    return mul(chosen, add(number(1.0), mul(ref("scale"), number(0.01))))


def operations() -> ir.Function:
    """Every operation once, on two scalars, with constants that fold."""
    a, b = ir.Load("a", 0), ir.Load("b", 0)
    half = number(0.5)
    small = mul(half, call(Op.SIN, a))
    conditions = {
        "less": call(Op.LT, a, b),
        "less_or_equal": call(Op.LE, a, b),
        "equal": call(Op.EQ, a, b),
        "different": call(Op.NE, a, b),
        "both": call(Op.AND, call(Op.LT, a, b), call(Op.LT, number(0.0), b)),
        "either": call(Op.OR, call(Op.LT, b, a), call(Op.LT, b, number(0.0))),
        "neither": call(Op.NOT, call(Op.LT, a, b)),
        "known": call(Op.LE, number(1.0), number(2.0)),
    }
    values: list[ir.Expression] = [
        add(a, b),
        sub(a, sub(b, sub(a, b))),
        mul(a, add(a, b)),
        call(Op.DIV, a, call(Op.DIV, b, call(Op.DIV, a, number(3.0)))),
        call(Op.NEG, add(a, b)),
        call(Op.NEG, mul(a, call(Op.NEG, b))),
        call(Op.SQRT, mul(a, a)),
        call(Op.SIN, a),
        call(Op.COS, a),
        call(Op.TAN, a),
        call(Op.ASIN, small),
        call(Op.ACOS, small),
        call(Op.ATAN, a),
        call(Op.ATAN2, a, b),
        call(Op.EXP, a),
        call(Op.LOG, add(mul(a, a), number(1.0))),
        call(Op.ABS, a),
        call(Op.FLOOR, mul(a, number(3.0))),
        call(Op.MIN, a, b),
        call(Op.MAX, a, b),
        mul(ref("root"), a),
        ref("root"),
        sub(number(-1.5), number(-2.5)),
    ]
    values += [call(Op.SELECT, condition, a, b) for condition in conditions.values()]
    values += [call(Op.SELECT, conditions["less"], number(2.0), number(-2.0))]
    return function(
        "operations",
        (argument(domain("a", 1, (-9.0, 9.0))), argument(domain("b", 1, (-9.0, 9.0)))),
        (
            output("value", (len(values),), [((i,), value) for i, value in enumerate(values)]),
            output("constant", (2,), [((1,), number(7.0))]),
        ),
        shared=[
            ir.Statement("two", number(2.0)),
            ir.Statement("root", call(Op.SQRT, ref("two")), "a constant that never becomes code"),
        ],
    )


def frame_map() -> ir.Function:
    """A vector turned by a matrix that is an input, so that orthonormality is guarded."""
    matrix: list[list[ir.Expression]] = [
        [ir.Load("turn", 3 * i + j) for j in range(3)] for i in range(3)
    ]
    own = domain("turn", 9, (-1.1, 1.1), kind=ir.Kind.MATRIX, unit="1", tolerance=1e-6)
    turned = rotated(matrix, [x(0), x(1), x(2)])
    return function(
        "frame_map",
        (X, argument(own)),
        (
            output("value", (3,), list(zip([(0,), (1,), (2,)], turned, strict=True))),
            output(
                "jacobian",
                (3, ERROR_SIZE),
                [((i, j), matrix[i][j]) for i in range(3) for j in range(3)],
            ),
        ),
    )


def retract() -> ir.Function:
    """Adds the error; the quaternion takes half the angle as its vector part, to first order."""
    d = [ir.Load("d", n) for n in range(ERROR_SIZE)]
    w, i, j, k = (x(n) for n in range(3, 7))
    a, b, c = (mul(number(0.5), d[n]) for n in range(3, 6))
    turned = [
        sub(w, add(mul(i, a), mul(j, b), mul(k, c))),
        add(i, sub(add(mul(w, a), mul(j, c)), mul(k, b))),
        add(j, sub(add(mul(w, b), mul(k, a)), mul(i, c))),
        add(k, sub(add(mul(w, c), mul(i, b)), mul(j, a))),
    ]
    values = [add(x(n), d[n]) for n in range(3)] + turned
    values += [add(x(n), d[n - 1]) for n in range(7, SIZE)]
    return function(
        "retract",
        (X, argument(domain("d", ERROR_SIZE, (-1e3, 1e3)))),
        (output("value", (SIZE,), [((n,), value) for n, value in enumerate(values)]),),
        role=ir.Role.RETRACT,
    )


def local() -> ir.Function:
    """The error that ``retract`` adds, to first order."""
    y = [ir.Load("y", n) for n in range(SIZE)]
    w, i, j, k = (x(n) for n in range(3, 7))
    two = number(2.0)
    turned = [
        mul(two, sub(add(mul(w, y[4]), mul(k, y[5])), add(mul(i, y[3]), mul(j, y[6])))),
        mul(two, sub(add(mul(w, y[5]), mul(i, y[6])), add(mul(j, y[3]), mul(k, y[4])))),
        mul(two, sub(add(mul(w, y[6]), mul(j, y[4])), add(mul(k, y[3]), mul(i, y[5])))),
    ]
    values = [sub(y[n], x(n)) for n in range(3)] + turned
    values += [sub(y[n], x(n)) for n in range(7, SIZE)]
    return function(
        "local",
        (X, ir.Argument("y", SIZE, False, False, STATE_DOMAINS)),
        (output("value", (ERROR_SIZE,), [((n,), value) for n, value in enumerate(values)]),),
        role=ir.Role.LOCAL,
    )


def choice() -> ir.Function:
    """One of two elements of the state, by a number that is an integer."""
    chosen = call(Op.EQ, ir.Load("k", 0), number(0.0))
    value = call(Op.SELECT, chosen, x(0), x(1))
    own = domain("k", 1, (0.0, 1.0), kind=ir.Kind.INTEGER, unit="1")
    return function("choice", (X, argument(own)), (output("value", (1,), [((0,), value)]),))


def chain() -> ir.Function:
    """Twenty steps, each of which reads the one before; two are results."""
    steps = [ir.Statement("t0", add(x(0), x(1)))]
    steps += [ir.Statement(f"t{n}", mul(ref(f"t{n - 1}"), x(2))) for n in range(1, 20)]
    results = [((0,), ref("t18")), ((1,), ref("t19"))]
    return function("chain", (X,), (output("value", (2,), results),), shared=steps)


def module(*functions: ir.Function, name: str = "rover") -> ir.Module:
    """A module of the state's maps and some functions; all of them when none is given."""
    strict = ranges("strict", ir.Items.REJECT)
    chosen = functions or (gps(), ranges(), strict, operations(), frame_map())
    return ir.Module(
        name=name,
        scalar=ir.Scalar.DOUBLE,
        state=state(),
        functions=(retract(), local(), *chosen),
        digest="1" * 64,
        generator="symnav 0",
    )


def unguarded(function: ir.Function) -> ir.Function:
    """The same without its checks."""
    return replace(function, guards=ir.Guards.ASSUME)
