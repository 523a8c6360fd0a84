"""Docstrings of generated functions, in the numpydoc form."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Sequence

from symnav import ir
from symnav.emit.python.shapes import (
    argument_shape,
    is_jacobian,
    jacobians,
    output_shape,
    values,
)
from symnav.emit.python.text import WIDTH, shown

_INDENT = "    "


def documentation(function: ir.Function, result: str) -> list[str]:
    """Lines of the docstring of a function.

    Args:
        function: what is described.
        result: name of its result type.
    """
    title = function.title.rstrip(".") + "."
    lines = _fill(title, "")
    if function.equation.strip():
        equation = function.equation.strip("\n").splitlines()
        lines += ["", *(f"{_INDENT}{line}".rstrip() for line in equation)]
    lines += ["", *_section("Parameters", _parameters(function, result))]
    lines += ["", *_section("Returns", _returns(function, result))]
    if function.checks_inputs:
        lines += ["", *_section("Raises", _raises())]
    notes = list(_notes(function))
    if notes:
        lines += ["", *_section("Notes", notes)]
    return lines


def parameter_text(domain: ir.Domain) -> str:
    """Unit, frame and range of a domain, in words."""
    return ", ".join(filter(None, [_unit(domain.unit), _frame(domain.frame), _range(domain)]))


def _section(title: str, lines: Iterable[str]) -> list[str]:
    return [title, "-" * len(title), *lines]


def _parameters(function: ir.Function, result: str) -> Iterator[str]:
    for argument in function.arguments:
        kind = "integers" if argument.integer else "array_like"
        yield f"{argument.name} : {kind}, shape {argument_shape(function, argument)}"
        if argument.name == "x" or len(argument.domains) > 1:
            yield from (line for domain in argument.domains for line in _block(domain))
        else:
            (domain,) = argument.domains
            words = [domain.description.rstrip("."), parameter_text(domain), _labels(domain)]
            yield from _fill("; ".join(filter(None, words)) + ".", _INDENT)
    yield f"out : {result}, tuple or dict of arrays, optional"
    text = "Contiguous arrays to write to instead of new ones; what fails stays untouched."
    yield from _fill(text, _INDENT)


def _labels(domain: ir.Domain) -> str:
    """The order of the elements, where their labels say more than their number."""
    if domain.size == 1 or domain.kind is not ir.Kind.REAL:
        return ""
    labels = [label for label in domain.labels if label.strip() and not label.isdigit()]
    return f"elements {' '.join(labels)}" if len(labels) == domain.size else ""


def _block(domain: ir.Domain) -> list[str]:
    stop = domain.start + domain.size
    place = f"{domain.start}" if domain.size == 1 else f"{domain.start}:{stop}"
    text = f"[{place}] {domain.name} ({parameter_text(domain)})"
    if domain.description:
        text += f": {domain.description.rstrip('.')}"
    return [f"{_INDENT}- {line}" if first else f"{_INDENT}  {line}" for first, line in _mark(text)]


def _mark(text: str) -> Iterator[tuple[bool, str]]:
    for number, line in enumerate(textwrap.wrap(text, width=WIDTH - 14)):
        yield number == 0, line


def _returns(function: ir.Function, result: str) -> Iterator[str]:
    yield result
    for output in function.outputs:
        unit = ", ".join(filter(None, [_unit(output.unit), _frame(output.frame)]))
        shape = output_shape(function, output)
        yield f"{_INDENT}{output.name} : array, shape {shape}{f', {unit}' if unit else ''}"
        yield from _fill(output.description.rstrip(".") + ".", _INDENT * 2)
        if is_jacobian(output) and output.columns:
            columns = " ".join(f"{section.name}[{section.size}]" for section in output.columns)
            yield from _fill(f"Columns: {columns}.", _INDENT * 2)
    yield f"{_INDENT}status : Status for one epoch, array of them over leading axes"
    if function.maximum is not None:
        yield f"{_INDENT}item_status : array, shape (..., n)"
        yield from _fill(_item_rule(function), _INDENT * 2)


def _item_rule(function: ir.Function) -> str:
    if function.items is ir.Items.REJECT:
        return "Status of every item; one that fails refuses its epoch."
    return "Status of every item; one that fails has zero rows and makes its epoch PARTIAL."


def _raises() -> Iterator[str]:
    yield "GuardError"
    text = (
        "When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the "
        "rows of epochs that fail are NaN."
    )
    yield from _fill(text, _INDENT)


def _notes(function: ir.Function) -> Iterator[str]:
    name = function.name
    forms = [f"``{name}.value`` ({_listed(values(function))})"]
    if jacobians(function):
        forms.append(f"``{name}.jacobian`` ({_listed(jacobians(function))})")
        forms.append(f"``{name}.nonzeros`` (what is not zero by structure)")
    forms.append(f"``{name}.bind`` (a call without arguments over the same arrays)")
    if function.maximum is None:
        forms.append(f"``{name}.blocks`` (epochs side by side, see ``{name}.to_lanes``)")
    if function.single_difference:
        forms.append(f"``{name}.single_difference`` (less the item ``reference``)")
    yield from _fill(f"Other forms, with the same arguments: {', '.join(forms)}.", "")
    if function.maximum is not None:
        yield from _fill(f"At most {function.maximum} items.", "")
    if not function.checks_inputs:
        yield from _fill("Generated without guards: arguments are not checked.", "")
    yield from (line for text in function.conventions for line in _fill(text, ""))
    if function.source.strip():
        yield from _fill(f"Source: {function.source.strip().rstrip('.')}.", "")


def _listed(outputs: Sequence[ir.Output]) -> str:
    return ", ".join(output.name for output in outputs)


def _unit(unit: str) -> str:
    return "" if unit in ("", "1") else unit


def _frame(frame: str) -> str:
    if not frame:
        return ""
    return f"map {frame}" if "->" in frame else f"frame {frame}"


def _range(domain: ir.Domain) -> str:
    if domain.kind is ir.Kind.QUATERNION:
        return f"unit quaternion {' '.join(domain.labels)}"
    if domain.kind is ir.Kind.UNREAD:
        return "not read"
    if domain.kind is ir.Kind.MATRIX:
        return "rotation matrix, row by row"
    pairs = list(dict.fromkeys(zip(domain.lower, domain.upper, strict=True)))
    return "range " + ", ".join(f"[{shown(low)}, {shown(high)}]" for low, high in pairs)


def _fill(text: str, indent: str) -> list[str]:
    return textwrap.wrap(
        text,
        width=WIDTH - 8,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )
