"""Range checks: which helper judges an element or a run of elements, and with what limits.

What a call reads once is judged by one condition, run by run: a comparison and a branch that is
never taken cost a processor less than selecting a harmless number in its place, and nothing is
evaluated after a condition that failed. Elements of items are flagged one by one, so that
neighbouring items may run side by side whatever each of them holds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

from symnav import ir
from symnav.emit.c.elements import Element
from symnav.emit.c.literals import integer_bounds
from symnav.emit.c.target import Target

_NUMBERS = {1: "is", 2: "are_two", 3: "are_three", 4: "are_four"}
LONGEST = max(_NUMBERS)
"""Elements that one helper judges at most."""


@dataclass(frozen=True, slots=True)
class Limits:
    """The declared range of an element as the C says it.

    Attributes:
        kind: ``index``, ``centred`` (from -bound to bound) or ``value``.
        text: arguments that hold it.
    """

    kind: str
    text: str

    def take(self, *, selects: bool = True) -> str:
        """Helper that copies an element and flags it.

        Args:
            selects: True when a harmless number is to stand for one outside the range.
        """
        return f"{'take' if selects or self.kind == 'index' else 'read'}_{self.kind}"

    @property
    def test(self) -> str:
        """Helper that flags an element."""
        return {"index": "is_index_outside", "centred": "is_beyond"}.get(self.kind, "is_outside")

    def condition(self, count: int) -> str:
        """Helper that is true when so many elements are inside."""
        return f"{_NUMBERS[count]}_{'centred' if self.kind == 'centred' else 'within'}"


def limits_of(element: Element, target: Target) -> Limits:
    """The declared range of an element."""
    if element.argument.integer:
        return Limits("index", ", ".join(integer_bounds(element.lower, element.upper)))
    low, high = target.declared(element.lower, element.upper)
    return Limits("centred", high) if low == f"-{high}" else Limits("value", f"{low}, {high}")


def runs_of(elements: Sequence[Element], target: Target) -> Iterator[tuple[Limits, list[Element]]]:
    """Elements that one helper can judge together: neighbours of the same range."""
    for limits, run in groupby(elements, lambda element: limits_of(element, target)):
        listed = list(run)
        for first in range(0, len(listed), LONGEST):
            yield limits, listed[first : first + LONGEST]


def verdict(target: Target, *, flagged: bool, judged: bool, skewed: bool) -> str:
    """C text of the status of a load.

    Args:
        target: the tree.
        flagged: True when ``outside`` is 1 for an element outside its range, else 0.
        judged: True when ``inside`` says that elements are inside.
        skewed: True when ``skewed`` is 1 for a norm that is off, else 0.
    """
    ok, range_, norm = map(target.flag, (ir.Status.OK, ir.Status.RANGE, ir.Status.QNORM))
    if flagged and not judged:
        # By arithmetic: to select by what was selected becomes a branch around the loads that come
        # last, and compilers then do not run neighbours side by side.
        text = f"{range_} * outside"
        return f"({text}) + ({norm} * (skewed & ~outside))" if skewed else text
    text = f"(skewed != 0U) ? {norm} : {ok}" if skewed else ok
    if not judged:
        return text
    fault = "((outside != 0U) || !inside)" if flagged else "(!inside)"
    return f"{fault} ? {range_} : {f'({text})' if skewed else text}"


def judged_loads(function: ir.Function) -> set[ir.Load]:
    """Elements whose copies are what a check reads.

    A condition reads copies, which are made whatever came before: were it to read the caller's
    memory, compilers would not run neighbouring epochs side by side.
    """
    return {
        ir.Load(argument.name, index)
        for argument in function.arguments
        for domain in argument.domains
        if function.checks_inputs and (has_norm(domain) or _is_read_once(argument, domain))
        for index in range(domain.start, domain.start + domain.size)
    }


def has_norm(domain: ir.Domain) -> bool:
    """True for elements whose norm, or whose orthonormality, is checked."""
    return domain.kind in (ir.Kind.QUATERNION, ir.Kind.MATRIX)


def _is_read_once(argument: ir.Argument, domain: ir.Domain) -> bool:
    return domain.kind is ir.Kind.REAL and not argument.item
