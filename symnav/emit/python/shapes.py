"""Shapes as a caller of the Python package sees them, and what a function's outputs are."""

from __future__ import annotations

import math

from symnav import errors, ir


def entries(module: ir.Module) -> tuple[ir.Function, ...]:
    """The measurements and corrections of a module, without the maps of the state."""
    return tuple(function for function in module.functions if not is_map(function))


def is_map(function: ir.Function) -> bool:
    """True for retract and local, the maps of the state."""
    return function.role in (ir.Role.RETRACT, ir.Role.LOCAL)


def is_scalar(function: ir.Function, argument: ir.Argument) -> bool:
    """True for an input of one element, which is passed without an axis of its own.

    States and errors are vectors even when they have one element.
    """
    vectors = ("x", "d", "y") if is_map(function) else ("x",)
    return argument.size == 1 and argument.name not in vectors


def argument_shape(function: ir.Function, argument: ir.Argument) -> str:
    """The shape of an argument, leading axes as an ellipsis."""
    axes = ["...", *(["n"] if argument.item else [])]
    axes += [] if is_scalar(function, argument) else [str(argument.size)]
    return f"({', '.join(axes)})"


def output_shape(function: ir.Function, output: ir.Output) -> str:
    """The shape of an output, leading axes as an ellipsis."""
    items = ["n"] if output.item and function.maximum is not None else []
    return f"({', '.join(['...', *items, *map(str, output.shape)])})"


def is_jacobian(output: ir.Output) -> bool:
    """True for the derivative of another output."""
    return output.name.startswith("jacobian")


def values(function: ir.Function) -> tuple[ir.Output, ...]:
    """Outputs that are not Jacobians."""
    return tuple(output for output in function.outputs if not is_jacobian(output))


def jacobians(function: ir.Function) -> tuple[ir.Output, ...]:
    """Jacobians."""
    return tuple(output for output in function.outputs if is_jacobian(output))


def argument_of(function: ir.Function, name: str) -> ir.Argument:
    """An argument by its name."""
    return next(argument for argument in function.arguments if argument.name == name)


def slot_element(offset: ir.Offset) -> int:
    """The element of an integer argument that a run-time index stands in."""
    index = offset.slot.index
    if isinstance(index, ir.Offset):
        raise errors.InputError(
            f"{offset.slot.argument}: an index that is itself chosen by an index is not supported"
        )
    return index


def slot_range(function: ir.Function, offset: ir.Offset, length: int) -> tuple[int, int]:
    """The smallest and largest index allowed: by its declared range and by what it points into."""
    argument, element = argument_of(function, offset.slot.argument), slot_element(offset)
    domain = next(d for d in argument.domains if d.start <= element < d.start + d.size)
    lower = max(domain.lower[element - domain.start], -offset.base)
    upper = min(domain.upper[element - domain.start], length - 1 - offset.base)
    return math.ceil(lower), math.floor(upper)


def signature_name(function: ir.Function) -> str:
    """Where a back end finds the description of a function."""
    return f"_interface.{function.name.upper()}"
