"""Bounds on rounding errors: filled in, written down, and held against a tolerance."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from symnav import errors, ir
from symnav.emit.c.kernel import entry_label
from symnav.emit.c.rounding import unit_of, upwards
from symnav.emit.c.store import is_jacobian
from symnav.export.records import Bundle, Tree
from symnav.export.rounding import bounded
from symnav.export.rounding.formats import FORMATS
from symnav.export.rounding.tolerances import Tolerance

PATH = "proof/error_bounds.json"
_DIGITS = 3
_WIDE = 1e9  # the range of what has none

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


def refuse_beyond(modules: Sequence[ir.Module], tolerance: Tolerance) -> None:
    """Raise when a value of a measurement or a correction may err by more than its tolerance.

    Jacobians do not count: their errors change how well a filter uses a measurement, not what it
    predicts. Nor do retract and local, whose error arguments nobody declares. Inputs on the edge
    of a decision do not count either: a jump there is the equation's own, in any type.

    Raises:
        InputError: naming every such value, its bound and its unit.
    """
    beyond = [
        f"  {module.name}_{function.name}, {output.name}: "
        f"{' '.join(filter(None, (upwards(bound), unit, _own(function, tolerance, unit))))}"
        for module in modules
        for function in module.functions
        if function.role in (ir.Role.MEASUREMENT, ir.Role.CORRECTION)
        for output in function.outputs
        if not is_jacobian(output)
        for bound, unit in [_worst_of(output)]
        if not tolerance.accepts(function.name, bound)
    ]
    if beyond:
        raise errors.InputError("\n".join([_head(beyond, tolerance), *beyond, _ADVICE]))


_ADVICE = (
    "Declare narrower ranges for what these read, use the relative form of an equation, export in "
    "double, or accept more with --tolerance, for one function with --tolerance FUNCTION=NUMBER. "
    "Nothing was written."
)


def _own(function: ir.Function, tolerance: Tolerance, unit: str) -> str:
    """What the other values do not share: a tolerance of its own, and what has no range."""
    limit = f"{tolerance.limit(function.name):g} {unit}".rstrip()
    own = f"above {limit}" if function.name in tolerance.own else ""
    return " ".join(filter(None, (own, _wide(function))))


def _wide(function: ir.Function) -> str:
    """What a function reads that nobody said anything about."""
    names = [
        domain.name
        for argument in function.arguments
        for domain in argument.domains
        if domain.kind is ir.Kind.REAL and max(*map(abs, domain.lower + domain.upper)) >= _WIDE
    ]
    return f"({', '.join(names)} may be as large as {_WIDE:g})" if names else ""


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
