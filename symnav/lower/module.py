"""Lowered functions to modules: one per route and scalar type, through the passes it wants."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence

from symnav import __version__, ir
from symnav.derive import Derivation
from symnav.lower import signature
from symnav.lower.precision import refuse_lost
from symnav.spec.records import Spec

Lower = Callable[[Spec, Derivation], ir.Function]
Pass = Callable[[ir.Function], ir.Function]


def module(
    spec: Spec,
    functions: Sequence[ir.Function],
    scalar: ir.Scalar = ir.Scalar.DOUBLE,
) -> ir.Module:
    """Collect lowered functions; the single-precision module leaves out what must be double.

    Raises:
        SpecError: when a declared range or a constant does not survive single precision.
    """
    name = spec.name
    chosen = tuple(functions)
    if scalar is ir.Scalar.FLOAT:
        name = f"{spec.name}_f32"
        only_double = {e.name for e in spec.entries if scalar.value not in e.scalars}
        chosen = tuple(f for f in functions if f.name not in only_double)
        refuse_lost(spec, chosen)
    return ir.Module(
        name, scalar, signature.state(spec), chosen, digest(spec), f"symnav {__version__}"
    )


def digest(spec: Spec) -> str:
    """SHA-256 of the canonical text of a spec."""
    return hashlib.sha256(spec.text.encode()).hexdigest()


def through(functions: Sequence[ir.Function], *passes: Pass) -> tuple[ir.Function, ...]:
    """Every function through every pass, in order."""
    result = tuple(functions)
    for transform in passes:
        result = tuple(transform(function) for function in result)
    return result
