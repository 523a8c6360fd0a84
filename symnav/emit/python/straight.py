"""Straight ways from Python to compiled C: C that looks at NumPy's arrays and makes them.

The compiled extension has them beside the exported C, which knows nothing of Python. Each checks
kind, shape and memory of every array and calls an entry point, which takes less than a single
look at an array from Python. Those for one epoch are calls of Python's own, which make the arrays
of their results.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.python.shapes import is_jacobian, is_scalar, jacobians, values
from symnav.emit.templates import plain, render

_WIDTH = 96  # some are indented once more


@dataclass(frozen=True, slots=True)
class Way:
    """A straight way to one entry point.

    Attributes:
        name: of the form: ``gps``, ``gps.value``, ``gps.jacobian``, ``gps.nonzeros`` or
            ``gps.single_difference``.
        entry: the entry point.
        joint: True when it gives all outputs in full.
        inputs: how many rows of the table are inputs.
        idle: how many outputs after them no caller asked for.
        outputs: how many after those a caller may give.
        wanted: rows of the table of what must come in.
        passed: lines of what the entry point is given.
    """

    name: str
    entry: str
    joint: bool
    inputs: int
    idle: int
    outputs: int
    wanted: tuple[str, ...]
    passed: tuple[str, ...]

    @property
    def written(self) -> int:
        """How many arrays the entry point writes to."""
        return len(self.wanted) - self.inputs


def sources(module: ir.Module) -> dict[str, str]:
    """The C of a module's straight ways, by path."""
    ways = {
        "calls": [way for f in module.functions for way in _calls(module, f)],
        "batches": [way for f in module.functions for way in _batches(module, f)],
    }
    stem = f"straight/{module.name}_straight"
    return {
        f"{stem}.c": render("straight/functions.c.j2", prefix=module.name, **ways),
        f"{stem}.h": render("straight/functions.h.j2", prefix=module.name, **ways),
        "straight/straight.h": plain("straight/straight.h"),
        "straight/calls.h": plain("straight/calls.h"),
    }


def has_epoch(function: ir.Function) -> bool:
    """False where Jacobians of one epoch lie by column, in memory of their own."""
    return not function.column_major


def _calls(module: ir.Module, function: ir.Function) -> Iterator[Way]:
    """One epoch: all outputs, and parts of them where they have entry points of their own."""
    if not has_epoch(function):
        return
    yield _way(module, function, "", function.outputs)
    one, other = values(function), jacobians(function)
    if one and other:
        yield _way(module, function, "_value", one, form=".value")
        yield _way(module, function, "_jacobian", other, form=".jacobian")
    # Non-zeros of items lie in columns as long as the most items, which nobody wants to be given.
    stored = other and all(o.entries for o in other) and function.outputs == (*one, *other)
    if stored and function.maximum is None:
        yield _way(module, function, "_nz", function.outputs, form=".nonzeros", idle=len(one))
    if function.single_difference:
        yield _way(module, function, "_sd", function.outputs, form=".single_difference")


def _batches(module: ir.Module, function: ir.Function) -> Iterator[Way]:
    """Many epochs: all outputs in full, and with non-zeros of Jacobians."""
    yield _way(module, function, "_batch", function.outputs)
    if any(output.entries for output in jacobians(function)):
        stored = [o for o in function.outputs if o.entries or not is_jacobian(o)]
        yield _way(module, function, "_batch_nz", stored)


def _way(
    module: ir.Module,
    function: ir.Function,
    suffix: str,
    outputs: Sequence[ir.Output],
    *,
    form: str = "",
    idle: int = 0,
) -> Way:
    """The straight way to the entry point with a suffix, which writes some outputs."""
    mapped, many = function.maximum is not None, suffix.startswith("_batch")
    differenced = suffix == "_sd"
    real = ("NPY_DOUBLE", "8") if module.scalar is ir.Scalar.DOUBLE else ("NPY_FLOAT", "4")
    rows = []
    for argument in function.arguments:
        kind = ("NPY_INT32", "4") if argument.integer else real
        rows.append(_row(kind, _argument_axes(function, argument), written=False))
    if differenced:  # the reference, behind the first argument
        rows.insert(1, _row(("NPY_INT32", "4"), [], written=False))
    inputs = len(rows)
    for output in outputs:
        nonzeros = suffix.endswith("_nz") and is_jacobian(output)
        axes = _output_axes(function, output, nonzeros=nonzeros)
        if differenced:
            axes = ["OTHERS" if axis == "ITEMS" else axis for axis in axes]
        rows.append(_row(real, axes, written=True))
    byte = ("NPY_UINT8", "1")
    rows += [_row(byte, [], written=True)] if many else []
    rows += [_row(byte, ["ITEMS"], written=True)] if mapped else []
    return Way(
        name=function.name + form,
        entry=f"{module.name}_{function.name}{suffix}",
        joint=not form,
        inputs=inputs,
        idle=idle,
        outputs=len(outputs) - idle,
        wanted=tuple(rows),
        passed=tuple(_passed(inputs, rows, mapped=mapped, many=many, by_value=differenced)),
    )


def _row(kind: tuple[str, str], axes: Sequence[str], *, written: bool) -> str:
    """A row of the table: what one array must be."""
    name, size = kind
    flag = "true" if written else "false"
    return f"{{{name}, {size}, {flag}, {len(axes)}, {{{', '.join(axes) or '0'}}}}}"


def _argument_axes(function: ir.Function, argument: ir.Argument) -> list[str]:
    items = ["ITEMS"] if argument.item else []
    return [*items, *([] if is_scalar(function, argument) else [str(argument.size)])]


def _output_axes(function: ir.Function, output: ir.Output, *, nonzeros: bool) -> list[str]:
    items = ["ITEMS"] if output.item and function.maximum is not None else []
    if nonzeros:
        return [str(len(output.entries)), *items]
    return [*items, *map(str, output.shape)]


def _passed(
    inputs: int, rows: Sequence[str], *, mapped: bool, many: bool, by_value: bool
) -> Iterator[str]:
    """Lines of what the entry point is given, one argument after the other, wrapped.

    ``by_value`` is for the integer behind the first argument and the number of items.
    """
    passed = ["count"] if many else []
    for place in range(len(rows)):
        at = f"epoch_of(&taken[{place}], &wanted[{place}], first)"
        once = f"integer_of(&taken[{place}])" if by_value and place == 1 else f"taken[{place}].at"
        passed.append(at if many else once)
        if many and place < inputs:
            passed.append(f"(int32_t)taken[{place}].step")
        if mapped and place == 0:
            passed.append("(int32_t)extent.items")
    line = "       "
    for number, text in enumerate(passed):
        text += ");" if number == len(passed) - 1 else ","
        if len(line) + 1 + len(text) > _WIDTH:
            yield line
            line = "       "
        line = f"{line} {text}"
    yield line
