"""The header with the sine and cosine that a tree evaluates itself."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

from symnav import ir, trigonometry
from symnav.emit.c.documentation import banner
from symnav.emit.c.target import Target
from symnav.emit.templates import render

_OF: dict[ir.Scalar, trigonometry.Coefficients] = {
    ir.Scalar.DOUBLE: trigonometry.DOUBLE,
    ir.Scalar.FLOAT: trigonometry.SINGLE,
}


def trigonometry_header(module: ir.Module, target: Target) -> str:
    """Text of ``<prefix>_trigonometry.h``: ``sine_of`` and ``cosine_of``, without a branch."""
    known = _OF[target.scalar]
    brief = "Sine and cosine of angles of a few turns: the same bits on every target."
    return render(
        "c/trigonometry.h.j2",
        banner=banner(module, f"{target.prefix}_trigonometry.h", brief),
        target=target,
        limit=f"{trigonometry.LIMIT:g}",
        half=target.literal(0.5),
        one=target.literal(1.0),
        two=target.literal(2.0),
        ones=target.literal(known.ones),
        fours=target.literal(4.0 * known.ones),
        fabs=target.function("fabs"),
        per_radian=target.literal(known.quarters_per_radian),
        parts=[target.literal(part) for part in known.parts],
        sine=_polynomial(known.sine, target),
        cosine=_polynomial(known.cosine, target),
    )


def _polynomial(coefficients: Sequence[float], target: Target) -> str:
    """A polynomial in ``square`` by pairs, which do not wait for each other, and ``fourth``."""
    pairs = [coefficients[k : k + 2] for k in range(0, len(coefficients), 2)]
    texts = [" + ".join(_term(pair, target)) for pair in reversed(pairs)]
    return reduce(lambda inner, outer: f"({outer}) + (fourth * ({inner}))", texts)


def _term(pair: Sequence[float], target: Target) -> list[str]:
    """``c0`` and ``(c1 * square)``, where there are two."""
    first, *second = (target.literal(coefficient) for coefficient in pair)
    return [first, *(f"({coefficient} * square)" for coefficient in second)]
