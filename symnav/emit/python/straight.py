"""Straight ways from Python to compiled C: C that looks at NumPy's arrays and makes them.

The compiled extension has them beside the exported C, which knows nothing of Python. Each checks
kind, shape and memory of every array and calls an entry point, which takes less than a single
look at an array from Python. For one epoch there is a call of Python's own as well, which makes
the arrays of its result.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.python.shapes import is_jacobian, is_scalar, jacobians
from symnav.emit.templates import plain, render

_WIDTH = 96  # some are indented once more


@dataclass(frozen=True, slots=True)
class Way:
    """One of the functions.

    Attributes:
        name: of the function.
        entry: the entry point it leads to.
        inputs: how many rows of the table are inputs.
        outputs: how many after them a caller may give.
        wanted: rows of the table of what must come in.
        passed: lines of what the entry point is given.
    """

    name: str
    entry: str
    inputs: int
    outputs: int
    wanted: tuple[str, ...]
    passed: tuple[str, ...]

    @property
    def results(self) -> int:
        """How many arrays the result has."""
        return len(self.wanted) - self.inputs


def sources(module: ir.Module) -> dict[str, str]:
    """The C of a module's straight ways, by path."""
    once = [f for f in module.functions if has_epoch(f)]
    ways = {
        "calls": [_way(module, f, "", f.outputs) for f in once],
        "batches": [way for f in module.functions for way in _batches(module, f)],
    }
    stem = f"straight/{module.name}_straight"
    return {
        f"{stem}.c": render("straight/functions.c.j2", prefix=module.name, **ways),
        f"{stem}.h": render("straight/functions.h.j2", prefix=module.name, **ways),
        "straight/straight.h": plain("straight/straight.h"),
    }


def has_epoch(function: ir.Function) -> bool:
    """False where Jacobians of one epoch lie by column, in memory of their own."""
    return not function.column_major


def _batches(module: ir.Module, function: ir.Function) -> Iterator[Way]:
    yield _way(module, function, "_batch", function.outputs)
    if any(output.entries for output in jacobians(function)):
        stored = [o for o in function.outputs if o.entries or not is_jacobian(o)]
        yield _way(module, function, "_batch_nz", stored)


def _way(
    module: ir.Module, function: ir.Function, suffix: str, outputs: Sequence[ir.Output]
) -> Way:
    """A straight way to one entry point."""
    mapped, many = function.maximum is not None, bool(suffix)
    real = ("NPY_DOUBLE", "8") if module.scalar is ir.Scalar.DOUBLE else ("NPY_FLOAT", "4")
    rows = []
    for argument in function.arguments:
        kind = ("NPY_INT32", "4") if argument.integer else real
        rows.append(_row(kind, _argument_axes(function, argument), written=False))
    for output in outputs:
        nonzeros = suffix.endswith("_nz") and is_jacobian(output)
        rows.append(_row(real, _output_axes(function, output, nonzeros=nonzeros), written=True))
    byte = ("NPY_UINT8", "1")
    rows += [_row(byte, [], written=True)] if many else []
    rows += [_row(byte, ["ITEMS"], written=True)] if mapped else []
    entry = f"{module.name}_{function.name}{suffix}"
    return Way(
        name=function.name,
        entry=entry,
        inputs=len(function.arguments),
        outputs=len(outputs),
        wanted=tuple(rows),
        passed=tuple(_passed(len(function.arguments), len(rows), mapped=mapped, many=many)),
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


def _passed(arguments: int, rows: int, *, mapped: bool, many: bool) -> Iterator[str]:
    """Lines of what the entry point is given, one argument after the other, wrapped."""
    passed = ["count"] if many else []
    for place in range(rows):
        at = f"epoch_of(&taken[{place}], &wanted[{place}], first)"
        passed.append(at if many else f"taken[{place}].at")
        if many and place < arguments:
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
