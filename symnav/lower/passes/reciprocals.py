"""One reciprocal for a divisor that is used twice or more.

A division costs as much as a dozen multiplications and does not pipeline. CasADi turns products
with a reciprocal back into quotients, so this is done on the representation. ``a / d`` becomes
``a * (1 / d)``, which differs from the quotient by one unit in the last place at most.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from symnav import ir
from symnav.lower.passes.walk import nodes, per_item, references

_ONE = ir.Number(1.0)


def share_reciprocals(function: ir.Function) -> ir.Function:
    """Divide once by every divisor that occurs at least twice.

    A divisor known before the items are visited is divided by there, even when a single quotient
    in the item body uses it: once in the item body is once for every item.
    """
    counter: Counter[ir.Expression] = Counter()
    for expression, in_items in _expressions(function):
        for divisor in _divisors(expression):
            counter[divisor] += 2 if in_items and not _is_per_item(function, divisor) else 1
    repeated = [divisor for divisor, count in counter.items() if count >= 2]
    if not repeated:
        return function
    names = _names(function, repeated)
    shared = [divisor for divisor in names if not _is_per_item(function, divisor)]
    own = [divisor for divisor in names if _is_per_item(function, divisor)]
    return replace(
        function,
        shared=_with_reciprocals(function.shared, shared, names),
        item=_with_reciprocals(function.item, own, names),
        outputs=tuple(_output(output, names) for output in function.outputs),
    )


def _expressions(function: ir.Function) -> Iterator[tuple[ir.Expression, bool]]:
    """Every expression, and whether it is evaluated once per item."""
    yield from ((step.value, False) for step in function.shared)
    yield from ((step.value, True) for step in function.item)
    for output in function.outputs:
        yield from ((entry.value, per_item(function, output)) for entry in output.entries)


def _divisors(expression: ir.Expression) -> Iterator[ir.Expression]:
    """Divisors other than numbers, of which the compiler makes the best by itself."""
    for node in nodes(expression):
        if isinstance(node, ir.Call) and node.operation is ir.Operation.DIV:
            divisor = node.operands[1]
            if not isinstance(divisor, ir.Number):
                yield divisor


def _is_per_item(function: ir.Function, divisor: ir.Expression) -> bool:
    """True when a divisor is not known before the items are visited."""
    own = {step.target for step in function.item}
    rows = {argument.name for argument in function.arguments if argument.item}
    loads = [node for node in nodes(divisor) if isinstance(node, ir.Load)]
    read = {load.argument for load in loads}
    read |= {load.index.slot.argument for load in loads if isinstance(load.index, ir.Offset)}
    return not own.isdisjoint(references(divisor)) or not rows.isdisjoint(read)


def _names(function: ir.Function, divisors: Sequence[ir.Expression]) -> dict[ir.Expression, str]:
    """A new target for every reciprocal, called after what it divides by; the simplest first."""
    taken = {step.target for step in (*function.shared, *function.item)}
    names: dict[ir.Expression, str] = {}
    for divisor in sorted(divisors, key=lambda divisor: len(list(nodes(divisor)))):
        meaning = _meaning(function, divisor)
        stem = f"inverse_{meaning}" if meaning else "inverse"
        name, count = stem, 2
        while name in taken:
            name, count = f"{stem}_{count}", count + 1
        taken.add(name)
        names[divisor] = name
    return names


def _meaning(function: ir.Function, divisor: ir.Expression) -> str:
    """What a divisor is called, where it has a name."""
    if isinstance(divisor, ir.Ref):
        return divisor.name
    if isinstance(divisor, ir.Load) and isinstance(divisor.index, int):
        single = any(a.name == divisor.argument and a.size == 1 for a in function.arguments)
        return divisor.argument if single else f"{divisor.argument}_{divisor.index}"
    return ""


def _with_reciprocals(
    steps: Sequence[ir.Step], divisors: Sequence[ir.Expression], names: Mapping[ir.Expression, str]
) -> tuple[ir.Step, ...]:
    """The steps of a body with each reciprocal right after the last step it needs."""
    places = {step.target: position for position, step in enumerate(steps)}
    after: dict[int, list[ir.Step]] = {}
    for divisor in divisors:
        needed = [places[name] for name in references(divisor) if name in places]
        after.setdefault(max(needed, default=-1), []).append(_reciprocal(divisor, names))
    placed = list(after.get(-1, []))
    for position, step in enumerate(steps):
        placed.append(replace(step, value=_multiplied(step.value, names)))
        placed += after.get(position, [])
    return tuple(placed)


def _reciprocal(divisor: ir.Expression, names: Mapping[ir.Expression, str]) -> ir.Statement:
    value = ir.Call(ir.Operation.DIV, (_ONE, _multiplied(divisor, names)))
    return ir.Statement(names[divisor], value, "shared reciprocal")


def _output(output: ir.Output, names: Mapping[ir.Expression, str]) -> ir.Output:
    entries = (replace(entry, value=_multiplied(entry.value, names)) for entry in output.entries)
    return replace(output, entries=tuple(entries))


def _multiplied(expression: ir.Expression, names: Mapping[ir.Expression, str]) -> ir.Expression:
    """The expression with products where it divided by something that has a reciprocal."""
    if not isinstance(expression, ir.Call):
        return expression
    operation, operands = expression.operation, expression.operands
    if operation is ir.Operation.DIV and operands[1] in names:
        inverse = ir.Ref(names[operands[1]])
        if operands[0] == _ONE:
            return inverse
        return ir.Call(ir.Operation.MUL, (_multiplied(operands[0], names), inverse))
    return ir.Call(operation, tuple(_multiplied(operand, names) for operand in operands))
