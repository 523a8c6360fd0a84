"""Short ways to write records of the intermediate representation by hand."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from symnav import ir

Op = ir.Operation
INF = float("inf")


def call(operation: ir.Operation, *operands: ir.Expression) -> ir.Call:
    """An operation."""
    return ir.Call(operation, operands)


def add(*terms: ir.Expression) -> ir.Expression:
    """A sum, from the left."""
    total, *rest = terms
    for term in rest:
        total = call(Op.ADD, total, term)
    return total


def mul(left: ir.Expression, right: ir.Expression) -> ir.Expression:
    """A product."""
    return call(Op.MUL, left, right)


def sub(left: ir.Expression, right: ir.Expression) -> ir.Expression:
    """A difference."""
    return call(Op.SUB, left, right)


def ref(name: str) -> ir.Ref:
    """An earlier step."""
    return ir.Ref(name)


def number(value: float) -> ir.Number:
    """A literal."""
    return ir.Number(value)


def domain(
    name: str,
    size: int,
    bounds: tuple[float, float],
    *,
    start: int = 0,
    kind: ir.Kind = ir.Kind.REAL,
    unit: str = "m",
    frame: str = "",
    tolerance: float = 0.0,
) -> ir.Domain:
    """A domain with one pair of bounds for all its elements."""
    labels = {1: ("",), 3: ("x", "y", "z"), 4: ("w", "x", "y", "z")}
    return ir.Domain(
        name=name,
        start=start,
        size=size,
        kind=kind,
        lower=(bounds[0],) * size,
        upper=(bounds[1],) * size,
        tolerance=tolerance,
        unit=unit,
        frame=frame,
        labels=labels.get(size, tuple(str(n) for n in range(size))),
        description=f"The {name.replace('_', ' ')}.",
    )


def argument(own: ir.Domain, *, item: bool = False) -> ir.Argument:
    """An input that is one domain."""
    return ir.Argument(own.name, own.size, item, own.kind is ir.Kind.INTEGER, (own,))


def section(name: str, start: int, size: int) -> ir.Section:
    """A section with numbered labels."""
    return ir.Section(name, start, size, "m", tuple(str(n) for n in range(size)))


def output(
    name: str,
    shape: tuple[int, ...],
    entries: Iterable[tuple[tuple[int | ir.Offset, ...], ir.Expression]],
    *,
    item: bool = False,
) -> ir.Output:
    """An output with one section along each axis."""
    return ir.Output(
        name=name,
        shape=shape,
        item=item,
        entries=tuple(ir.Entry(index, value) for index, value in entries),
        rows=(section("row", 0, shape[0] if shape else 1),),
        columns=(section("error", 0, shape[-1]),) if name.startswith("jacobian") else (),
        unit="" if name.startswith("jacobian") else "m",
        frame="",
        description=f"The {name}.",
    )


def function(
    name: str,
    arguments: Sequence[ir.Argument],
    outputs: Sequence[ir.Output],
    *,
    shared: Sequence[ir.Step] = (),
    item: Sequence[ir.Step] = (),
    role: ir.Role = ir.Role.MEASUREMENT,
    maximum: int | None = None,
    items: ir.Items = ir.Items.SKIP,
    single_difference: bool = False,
) -> ir.Function:
    """A guarded function stored by row."""
    return ir.Function(
        name=name,
        role=role,
        title=f"The function {name}",
        equation=f"{name} = f(x)",
        source="A textbook, equation 1",
        conventions=("Angles are in radians.",),
        arguments=tuple(arguments),
        shared=tuple(shared),
        item=tuple(item),
        outputs=tuple(outputs),
        maximum=maximum,
        items=items,
        guards=ir.Guards.STATUS,
        column_major=False,
        single_difference=single_difference,
    )
