"""Short ways to write records of the representation by hand, and the state they share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symnav import ir

Op = ir.Operation
Expression = ir.Expression


def call(operation: ir.Operation, *operands: Expression | float | str) -> ir.Call:
    """An operation; numbers and names stand for themselves."""
    return ir.Call(operation, tuple(_expression(operand) for operand in operands))


def _expression(operand: Expression | float | str) -> Expression:
    if isinstance(operand, str):
        return ir.Ref(operand)
    if isinstance(operand, int | float):
        return ir.Number(float(operand))
    return operand


def add(*terms: Expression | float | str) -> Expression:
    """A sum from the left."""
    total = _expression(terms[0])
    for term in terms[1:]:
        total = call(Op.ADD, total, term)
    return total


def sub(first: Expression | float | str, second: Expression | float | str) -> ir.Call:
    """A difference."""
    return call(Op.SUB, first, second)


def mul(first: Expression | float | str, second: Expression | float | str) -> ir.Call:
    """A product."""
    return call(Op.MUL, first, second)


def domain(name: str, start: int, labels: Sequence[str], bound: float, **more: object) -> ir.Domain:
    """A run of real elements in [-bound, bound]."""
    size = len(labels)
    plain = ir.Domain(
        name=name,
        start=start,
        size=size,
        kind=ir.Kind.REAL,
        lower=(-bound,) * size,
        upper=(bound,) * size,
        tolerance=0.0,
        unit="m",
        frame="n",
        labels=tuple(labels),
        description=f"The {name.replace('_', ' ')}.",
    )
    return replace(plain, **more)  # type: ignore[arg-type]


def integers(name: str, lower: float, upper: float) -> ir.Domain:
    """One integer in a closed range."""
    return ir.Domain(
        name=name,
        start=0,
        size=1,
        kind=ir.Kind.INTEGER,
        lower=(lower,),
        upper=(upper,),
        tolerance=0.0,
        unit="1",
        frame="",
        labels=("",),
        description=f"The {name}.",
    )


def argument(of: ir.Domain, *, item: bool = False) -> ir.Argument:
    """An argument of one domain."""
    return ir.Argument(of.name, of.size, item, of.kind is ir.Kind.INTEGER, (of,))


POSITION = domain("position", 0, "xyz", 1e5)
ATTITUDE = domain(
    "attitude",
    3,
    "wxyz",
    1.001,
    kind=ir.Kind.QUATERNION,
    tolerance=1e-3,
    unit="1",
    frame="b -> n",
)
CLOCK = domain("clock", 7, ["gps", "galileo"], 1e6, frame="")
SPARE = domain("spare", 9, [str(k) for k in range(11)], 1e3, unit="m/s")
STATE_DOMAINS = (POSITION, ATTITUDE, CLOCK, SPARE)
STATE_SIZE, ERROR_SIZE = 20, 19


def _block(of: ir.Domain, error_start: int, error_size: int) -> ir.StateBlock:
    return ir.StateBlock(
        name=of.name,
        kind="rotation" if of.kind is ir.Kind.QUATERNION else "vector",
        storage=of,
        error_start=error_start,
        error_size=error_size,
        error_unit="rad" if of.kind is ir.Kind.QUATERNION else of.unit,
        error_frame="b" if of.kind is ir.Kind.QUATERNION else of.frame,
        error_labels=tuple("xyz") if of.kind is ir.Kind.QUATERNION else of.labels,
        convention="q <- q * exp(d / 2)." if of.kind is ir.Kind.QUATERNION else "",
        initial=(0.0,) * of.size,
    )


STATE = ir.State(
    blocks=(
        _block(POSITION, 0, 3),
        _block(ATTITUDE, 3, 3),
        _block(CLOCK, 6, 2),
        _block(SPARE, 8, 11),
    ),
    size=STATE_SIZE,
    error_size=ERROR_SIZE,
    digest="89abcdef" * 8,
)
X = ir.Argument("x", STATE_SIZE, False, False, STATE_DOMAINS)
COLUMNS = tuple(
    ir.Section(
        block.name, block.error_start, block.error_size, block.error_unit, block.error_labels
    )
    for block in STATE.blocks
)


def x(index: int) -> ir.Load:
    """An element of the state."""
    return ir.Load("x", index)


def output(
    name: str,
    shape: tuple[int, ...],
    entries: Sequence[tuple[tuple[int | ir.Offset, ...], Expression | float | str]],
    *,
    item: bool = False,
) -> ir.Output:
    """An output whose rows are called after the function's value."""
    listed = tuple(ir.Entry(index, _expression(value)) for index, value in entries)
    jacobian = name.startswith("jacobian")
    length = shape[0] if len(shape) == (2 if jacobian else 1) else 1
    rows = (ir.Section("value", 0, length, "m", tuple(str(k) for k in range(length))),)
    return ir.Output(
        name=name,
        shape=shape,
        item=item,
        entries=listed,
        rows=rows,
        columns=COLUMNS if jacobian else (),
        unit="" if jacobian else "m",
        frame="" if jacobian else "n",
        description="Derivative with respect to the error state." if jacobian else "The value.",
    )


def function(name: str, arguments: Sequence[ir.Argument], **more: object) -> ir.Function:
    """A function with plain documentation."""
    plain = ir.Function(
        name=name,
        role=ir.Role.MEASUREMENT,
        title=f"Function {name}",
        equation="z = p + R(q) l\n  with R(q) from the unit quaternion",
        source="written for the tests, section 1",
        conventions=("Hamilton quaternions.", "Errors on the right: R <- R exp(d)."),
        arguments=tuple(arguments),
        shared=(),
        item=(),
        outputs=(),
        maximum=None,
        items=ir.Items.SKIP,
        guards=ir.Guards.STATUS,
        column_major=False,
        single_difference=False,
    )
    return replace(plain, **more)  # type: ignore[arg-type]
