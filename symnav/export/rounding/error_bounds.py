"""Bounds on rounding errors: filled in, written down, and held against a tolerance."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import replace

from symnav import errors, ir
from symnav.binding import STATE
from symnav.emit.c.kernel import entry_label
from symnav.emit.c.rounding import unit_of, upwards
from symnav.emit.c.store import is_jacobian
from symnav.export.records import Bundle, Tree
from symnav.export.rounding import bounded
from symnav.export.rounding.formats import FORMATS
from symnav.export.rounding.tolerances import Tolerance
from symnav.lower.passes.walk import nodes
from symnav.spec.records import Spec

PATH = "proof/error_bounds.json"
_DIGITS = 3
_WIDE = 1e8  # models and symnav itself give ranges as large as this to what has none

ASSUMPTIONS = (
    "Inputs are inside their declared ranges, quaternions and matrices pass their guards; the "
    "numbers the caller passes are exact.",
    "Exact means the same operations on the same inputs and the same constants without rounding; "
    "guarded intermediates are inside their bounds in exact arithmetic as well as computed.",
    "IEEE 754 binary arithmetic, rounding to nearest, gradual underflow (no flush to zero), every "
    "operation in the type of the tree (FLT_EVAL_METHOD 0) or fused with its neighbour.",
    "Square roots are correctly rounded.",
    "Sine, cosine, tangent, their inverses, exponential and logarithm are within 1 unit in the "
    "last place of the exact function of their argument.",
)


def with_bounds(module: ir.Module) -> ir.Module:
    """The module with the rounding of every entry of every output filled in."""
    functions = tuple(bounded(function, module.scalar) for function in module.functions)
    return replace(module, functions=functions)


def files(bundle: Bundle) -> Mapping[str, str]:
    """The bounds of every output, element by element."""
    content = {
        "about": "Bounds on |computed - exact| over the declared ranges, rounded upwards.",
        "assumptions": list(ASSUMPTIONS),
        "trees": [_tree(tree) for tree in bundle.trees],
    }
    return {PATH: json.dumps(content, indent=1, ensure_ascii=True) + "\n"}


def refuse_beyond(spec: Spec, modules: Sequence[ir.Module], tolerance: Tolerance) -> None:
    """Raise when a value of a measurement or a correction may err by more than its tolerance.

    Jacobians do not count: their errors change how well a filter uses a measurement, not what it
    predicts. Nor do retract and local, whose error arguments nobody declares. Inputs on the edge
    of a decision do not count either: a jump there is the equation's own, in any type.

    Raises:
        InputError: naming every such value, its bound and its unit.
    """
    beyond = [
        (module, function, output)
        for module in modules
        for function in module.functions
        if function.role in (ir.Role.MEASUREMENT, ir.Role.CORRECTION)
        for output in function.outputs
        if not is_jacobian(output) and not tolerance.accepts(function.name, _worst_of(output)[0])
    ]
    if beyond:
        lines = [_line(*one, tolerance) for one in beyond]
        advice = _advice(
            {module.scalar for module, _, _ in beyond},
            _relatives(spec, {function.name for _, function, _ in beyond}),
        )
        raise errors.InputError("\n".join([_head(lines, tolerance), *lines, advice]))


def _line(module: ir.Module, function: ir.Function, output: ir.Output, tolerance: Tolerance) -> str:
    """A value that may err by too much: its bound, a tolerance of its own, what has no range."""
    bound, unit = _worst_of(output)
    limit = f"{tolerance.limit(function.name):g} {unit}".rstrip()
    own = f"above {limit}" if function.name in tolerance.own else ""
    words = " ".join(filter(None, (upwards(bound), unit, own, _wide(function, output))))
    return f"  {module.name}_{function.name}, {output.name}: {words}"


def _wide(function: ir.Function, output: ir.Output) -> str:
    """What an output reads that may be very large, and where to say that it is not."""
    read = _read(function, output)
    names: dict[float, list[str]] = {}
    tables: dict[str, None] = {}
    for argument in function.arguments:
        for domain in argument.domains:
            largest = max(map(abs, domain.lower + domain.upper), default=0.0)
            is_read = not read.isdisjoint(_elements_of(argument, domain))
            if domain.kind is ir.Kind.REAL and largest >= _WIDE and is_read:
                names.setdefault(largest, []).append(domain.name)
                tables["[[state]]" if argument.name == STATE else "[[input]]"] = None
    if not names:
        return ""
    sizes = (f"{', '.join(some)} may be as large as {size:g}" for size, some in names.items())
    return f"({', '.join(sizes)}; declare a narrower range in {' and '.join(tables)})"


def _elements_of(argument: ir.Argument, domain: ir.Domain) -> set[tuple[str, int]]:
    return {(argument.name, domain.start + index) for index in range(domain.size)}


def _read(function: ir.Function, output: ir.Output) -> set[tuple[str, int]]:
    """Argument and element of everything that an output depends on, through every step.

    Of a run-time slot the first element it may choose stands for all: they are of one block.
    """
    steps = {step.target: step.value for step in (*function.shared, *function.item)}
    pending = [entry.value for entry in output.entries]
    found: set[tuple[str, int]] = set()
    while pending:
        for node in nodes(pending.pop()):
            if isinstance(node, ir.Load):
                index = node.index.base if isinstance(node.index, ir.Offset) else node.index
                found.add((node.argument, index))
            elif isinstance(node, ir.Ref) and node.name in steps:
                pending.append(steps.pop(node.name))
    return found


def _relatives(spec: Spec, names: Set[str]) -> list[str]:
    """Models that say the same as the equations of some functions relative to a reference."""
    models = (entry.model.relative for entry in spec.entries if entry.name in names)
    return list(dict.fromkeys(filter(None, models)))


def _advice(scalars: Set[ir.Scalar], relatives: Sequence[str]) -> str:
    """What can be done about it, of what would help here."""
    ways = ["Declare narrower ranges for what these read (range in [[state]] and [[input]])"]
    if relatives:
        ways.append(f"use the relative form of an equation ({', '.join(relatives)})")
    if ir.Scalar.FLOAT in scalars:
        ways.append("export in double")
    return (
        f"{', '.join(ways)}, or accept more with --tolerance, for one function with --tolerance "
        "FUNCTION=NUMBER. Nothing was written."
    )


def _head(beyond: Sequence[str], tolerance: Tolerance) -> str:
    values = "value" if len(beyond) == 1 else f"{len(beyond)} values"
    given = "its tolerance" if len(beyond) == 1 else "their tolerances"
    if tolerance.everywhere is not None and not tolerance.own:
        given = f"the tolerance of {tolerance.everywhere:g}"
    return f"rounding may move the following {values} by more than {given}:"


def _worst_of(output: ir.Output) -> tuple[float, str]:
    """The largest bound and its unit."""
    pairs = [
        (rounding.smooth, unit_of(output, entry))
        for entry, rounding in zip(output.entries, output.rounding, strict=True)
    ]
    return max(pairs, default=(0.0, ""))


def _tree(tree: Tree) -> dict[str, object]:
    kind = FORMATS[tree.module.scalar]
    return {
        "prefix": tree.prefix,
        "type": tree.module.scalar.value,
        "unit_roundoff": kind.rounding(1.0),
        "library_ulp": kind.ulps,
        "functions": [_function(tree, function) for function in tree.module.functions],
    }


def _function(tree: Tree, function: ir.Function) -> dict[str, object]:
    return {
        "function": f"{tree.prefix}_{function.name}",
        "outputs": [_output(output) for output in function.outputs],
    }


def _output(output: ir.Output) -> dict[str, object]:
    elements = list(_elements(output))
    return {
        "output": output.name,
        "unit": output.unit,
        "bound": _number(max((r.bound for r in output.rounding), default=0.0)),
        "bound_where_decisions_agree": _number(
            max((r.smooth for r in output.rounding), default=0.0)
        ),
        "elements": elements,
    }


def _elements(output: ir.Output) -> Iterator[dict[str, object]]:
    for entry, rounding in zip(output.entries, output.rounding, strict=True):
        yield {
            "element": entry_label(output, entry) or output.name,
            "unit": unit_of(output, entry),
            "bound": _number(rounding.bound),
            "bound_where_decisions_agree": _number(rounding.smooth),
            "largest": _number(rounding.largest),
        }


def _number(value: float) -> float | None:
    """A bound in three digits, rounded upwards; None where there is none."""
    return None if math.isinf(value) else float(upwards(value, _DIGITS))
