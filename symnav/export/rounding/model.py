"""Numbers that know how far the computed value may be from the exact one."""

from __future__ import annotations

from dataclasses import dataclass, replace

from symnav.export.rounding.intervals import INFINITY, Interval, up_product, up_quotient


@dataclass(frozen=True, slots=True)
class Number:
    """Exact and computed value of one node over a set of inputs.

    Attributes:
        real: encloses the exact values.
        computed: encloses what the C computes.
        error: bound on |computed - exact|, input by input.
        turned: bound on the distance of computed - exact from a multiple of 2 pi: an angle that
            jumps from one end of its range to the other is as good for a sine.
        relative: bound on |computed - exact| / |exact|, which products and quotients of widely
            ranging factors hand on unharmed.
    """

    real: Interval
    computed: Interval
    error: float
    turned: float
    relative: float = INFINITY

    def settled(self) -> Number:
        """The same with everything each attribute says about the others.

        Raises:
            Empty: when they contradict each other.
        """
        error = min(self.error, self.real.farthest(self.computed))
        if error == INFINITY:
            return replace(self, error=error)
        if self.relative < INFINITY:
            error = min(error, up_product(self.relative, self.real.magnitude))
        real = self.real.meet(self.computed.widened(error))
        computed = self.computed.meet(self.real.widened(error))
        relative = self.relative
        if real.mignitude > 0.0:
            relative = min(relative, up_quotient(error, real.mignitude))
        return Number(real, computed, error, min(self.turned, error), relative)

    def within(self, real: Interval, computed: Interval) -> Number:
        """What is left of it when the values are known to be inside.

        Raises:
            Empty: when nothing is.
        """
        return replace(self, real=self.real.meet(real), computed=self.computed.meet(computed))


@dataclass(frozen=True, slots=True)
class Truth:
    """Whether a condition holds in exact arithmetic, and as computed; None where it may or not.

    Attributes:
        real: in exact arithmetic.
        computed: as computed.
        same: True when both always agree.
    """

    real: bool | None
    computed: bool | None
    same: bool

    def negated(self) -> Truth:
        """The opposite."""
        flip = {True: False, False: True, None: None}
        return Truth(flip[self.real], flip[self.computed], self.same)

    def both(self, other: Truth) -> Truth:
        """The conjunction."""
        same = self.same and other.same
        return Truth(_and(self.real, other.real), _and(self.computed, other.computed), same)


def _and(a: bool | None, b: bool | None) -> bool | None:
    if a is False or b is False:
        return False
    return True if a and b else None
