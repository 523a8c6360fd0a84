"""What single precision cannot hold: refused where the module of that type is made.

Input: a spec and the functions that are to be float. A range whose numbers are all lost would give
C that refuses everything, or accepts what was never declared; a constant that becomes zero, or
infinite, would give another equation. Both are mistakes of the specification, told all at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby

from symnav import ir, single
from symnav.errors import Problem, SpecError
from symnav.figures import readable
from symnav.lower.passes.walk import expressions, nodes
from symnav.spec.records import Entry, Spec, ToConstant

_REMEDY = "rescale the quantity or use double"
_BEYOND = f"beyond the largest number of single precision, {single.LARGEST:.6g}"


def refuse_lost(spec: Spec, functions: Sequence[ir.Function]) -> None:
    """Raise where a declared range or a constant does not survive single precision.

    Args:
        spec: what was declared.
        functions: those that are to be emitted in single precision.

    Raises:
        SpecError: naming every such range and constant, and what to do.
    """
    names = {function.name for function in functions}
    entries = [entry for entry in spec.entries if entry.name in names]
    problems = [*_ranges(spec, functions), *(p for entry in entries for p in _constants(entry))]
    bad = {problem.path.partition(".")[0] for problem in problems}
    problems += [
        problem
        for function in functions
        if (path := _path(function)) not in bad
        for problem in _numbers(function, path)
    ]
    if problems:
        raise SpecError(problems, f"{spec.name} in single precision (float)")


# -- ranges --------------------------------------------------------------------------------------


def _ranges(spec: Spec, functions: Iterable[ir.Function]) -> list[Problem]:
    """Every lost range of a state block or an input, once."""
    domains = (
        domain
        for function in functions
        for argument in function.arguments
        for domain in argument.domains
        if domain.kind is not ir.Kind.INTEGER and not _is_error(function, argument)
    )
    return list(dict.fromkeys(p for domain in domains for p in _of_domain(spec, domain)))


def _is_error(function: ir.Function, argument: ir.Argument) -> bool:
    """True for what ``retract`` adds, whose range is nobody's declaration."""
    return function.role is ir.Role.RETRACT and argument.name == "d"


def _of_domain(spec: Spec, domain: ir.Domain) -> Iterator[Problem]:
    what = "state" if domain.name in spec.layout.places else "input"
    pairs = zip(domain.lower, domain.upper, domain.labels, strict=True)
    for (lower, upper), run in groupby(pairs, lambda element: element[:2]):
        fault = _fault_of_range(lower, upper)
        if fault is not None:
            labels = ", ".join(label for _, _, label in run if label)
            shown = f"[{readable(lower)}, {readable(upper)}]{f' of {labels}' if labels else ''}"
            message = f"{shown} {fault}, {_REMEDY}"
            yield Problem(f"{what} {domain.name}.range", message)


def _fault_of_range(lower: float, upper: float) -> str | None:
    """What is wrong with a range, whose ends differ, and what to do with it; or None."""
    if _overflows(lower, upper):
        return f"reaches {_BEYOND}; narrow the range"
    first, last = single.not_below(lower), single.not_above(upper)
    if first > last:
        return "holds no number of single precision; widen the range"
    if first == last:
        return f"holds only one number of single precision, {readable(first)}; widen the range"
    return None


# -- constants -----------------------------------------------------------------------------------


def _constants(entry: Entry) -> Iterator[Problem]:
    """Every lost element of the constants that quantities of an entry are bound to."""
    for role, binding in entry.bindings.items():
        if not isinstance(binding, ToConstant):
            continue
        for index, value in enumerate(binding.values):
            fault = _fault_of_number(value)
            if fault is not None:
                place = f"[{index}]" if len(binding.values) > 1 else ""
                path = f"{entry.model.section} {entry.name}.{role}{place}"
                yield Problem(path, f"the constant {readable(value)} {fault}; {_REMEDY}")


def _numbers(function: ir.Function, path: str) -> Iterator[Problem]:
    """Every lost number of the arithmetic itself: of a user's equation, or of folded constants."""
    every = (node for expression in expressions(function) for node in nodes(expression))
    for value in dict.fromkeys(node.value for node in every if isinstance(node, ir.Number)):
        fault = _fault_of_number(value)
        if fault is not None:
            yield Problem(path, f"the number {readable(value)} of its equation {fault}; {_REMEDY}")


def _path(function: ir.Function) -> str:
    return f"{function.role.value} {function.name}"


def _fault_of_number(value: float) -> str | None:
    """What single precision makes of a number, where that is not what was meant, or None."""
    if _overflows(value):
        return f"is {_BEYOND}"
    number = single.nearest(value)
    if value == 0.0 or abs(number) >= single.SMALLEST:
        return None
    lost = "become zero" if number == 0.0 else "lose digits"
    return f"would {lost}: single precision needs {single.SMALLEST:.6g} at least"


def _overflows(*values: float) -> bool:
    """True when one of the numbers would become infinite."""
    try:
        for value in values:
            single.nearest(value)
    except OverflowError:
        return True
    return False
