"""Arguments whose names the entry points need themselves get another name in the C."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeVar

from symnav import ir
from symnav.emit.c.names import Names
from symnav.naming import words

# Parameters and locals of the entry points and of the functions they call.
LOCALS = words(
    """
    base block bounded codes common count covariance dense epoch epochs evaluated failed failure
    failures first i in inside item item_status k lane loaded matrix minus n next nonzeros out
    outcome outside own passed reference rest result row shared sigma skewed status stride
    """
)

Holder = TypeVar("Holder", bound=ir.Step | ir.Entry)


def with_free_names(function: ir.Function) -> ir.Function:
    """The function with every argument's name usable beside the locals and the outputs."""
    outputs = {output.name for output in function.outputs}
    outputs |= {f"{name}_nz" for name in outputs}
    given = [argument.name for argument in function.arguments]
    steps = {f"{name}_step" for name in given}
    names = Names(LOCALS | outputs | steps)
    renamed = {name: names.claim(name) for name in given}
    if all(new == old for old, new in renamed.items()):
        return function
    return replace(
        function,
        arguments=tuple(
            replace(argument, name=renamed[argument.name]) for argument in function.arguments
        ),
        shared=tuple(_holder(step, renamed) for step in function.shared),
        item=tuple(_holder(step, renamed) for step in function.item),
        outputs=tuple(
            replace(output, entries=tuple(_entry(entry, renamed) for entry in output.entries))
            for output in function.outputs
        ),
    )


def _holder(holder: Holder, renamed: Mapping[str, str]) -> Holder:
    return replace(holder, value=_expression(holder.value, renamed))


def _entry(entry: ir.Entry, renamed: Mapping[str, str]) -> ir.Entry:
    index = tuple(_index(step, renamed) for step in entry.index)
    return replace(_holder(entry, renamed), index=index)


def _index(index: int | ir.Offset, renamed: Mapping[str, str]) -> int | ir.Offset:
    if isinstance(index, ir.Offset):
        return replace(index, slot=_load(index.slot, renamed))
    return index


def _expression(expression: ir.Expression, renamed: Mapping[str, str]) -> ir.Expression:
    if isinstance(expression, ir.Load):
        return _load(expression, renamed)
    if isinstance(expression, ir.Call):
        operands = tuple(_expression(operand, renamed) for operand in expression.operands)
        return replace(expression, operands=operands)
    return expression


def _load(load: ir.Load, renamed: Mapping[str, str]) -> ir.Load:
    return ir.Load(renamed[load.argument], _index(load.index, renamed))
