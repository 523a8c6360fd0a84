"""Checks of what a call reads once: ranges run by run, and norms.

``inside`` says that every range holds, ``skewed`` is 1 where a norm is off. Elements of a rotation
bound each other: where the norm is off by less than half of what is tolerated, or a matrix by less
than a quarter, no element can be outside its range. Only beyond are ranges and norm looked at one
by one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.elements import Element
from symnav.emit.c.ranges import has_norm, runs_of
from symnav.emit.c.target import Target

_SPACINGS = 64
"""A tolerance of so many spacings of numbers at one is wide enough for roundings in a norm."""


@dataclass(frozen=True)
class Group:
    """The elements of a domain as a check reads them.

    Attributes:
        domain: what they are.
        elements: in order.
        texts: C text of each.
    """

    domain: ir.Domain
    elements: tuple[Element, ...]
    texts: tuple[str, ...]

    def norm(self, target: Target, test: str) -> str:
        """A call that looks at the norm."""
        arguments = [*self.texts, target.literal(self.domain.tolerance)]
        return f"{test}_{self.domain.kind.value}({', '.join(arguments)})"

    def skewed(self, target: Target, unless: str = "") -> list[str]:
        """The statement that flags a norm that is off, unless something known says it is not."""
        test = self.norm(target, "is_skewed")
        return comments.code(f"skewed |= {f'{unless} ? (flag_t)0U : {test}' if unless else test};")


@dataclass(frozen=True)
class Judgement:
    """Checks of several groups.

    Attributes:
        target: the tree.
        groups: what is looked at, in the order of the interface.
    """

    target: Target
    groups: tuple[Group, ...]

    def lines(self) -> list[list[str]]:
        """Paragraphs of statements, which set ``inside`` and may set ``skewed``."""
        norms = [line for group in self.groups for line in self._norm(group)]
        return [[*self._closeness(), *self._ranges()], norms]

    def helpers(self) -> set[str]:
        """Names of the check functions that are called."""
        names = {f"is_near_{group.domain.kind.value}" for group in self._bounded}
        names |= {f"is_skewed_{g.domain.kind.value}" for g in self.groups if has_norm(g.domain)}
        return names | {
            limits.condition(len(run))
            for group in self.groups
            for limits, run in runs_of(group.elements, self.target)
        }

    @cached_property
    def _bounded(self) -> tuple[Group, ...]:
        """Groups of which the norm is looked at first."""
        return tuple(group for group in self.groups if self._is_bounded(group))

    @cached_property
    def _others(self) -> tuple[Group, ...]:
        return tuple(group for group in self.groups if not self._is_bounded(group))

    def _is_bounded(self, group: Group) -> bool:
        """True where a norm that is close enough bounds the elements, whatever is rounded.

        Specifications declare 1 + tolerance; what else a module declares must not be narrower.
        """
        tolerance = group.domain.tolerance
        least = 1.0 + tolerance
        wide = tolerance >= _SPACINGS * 2.0 * self.target.unit_roundoff
        inside = all(e.lower <= -least and least <= e.upper for e in group.elements)
        return has_norm(group.domain) and wide and inside

    def _closeness(self) -> list[str]:
        """The statement that says whether all norms are so close that they bound the elements."""
        bounded = " && ".join(group.norm(self.target, "is_near") for group in self._bounded)
        return comments.code(f"const bool bounded = {bounded};") if bounded else []

    def _ranges(self) -> list[str]:
        """Statements that look at ranges, until one fails."""
        conditions = [" && ".join(self._tests(group)) for group in self._others]
        tests = [test for group in self._bounded for test in self._tests(group)]
        if tests:
            alone = tests[0] if len(tests) == 1 else f"({' && '.join(tests)})"
            conditions.append(f"(bounded || {alone})" if conditions else f"bounded || {alone}")
        lines: list[str] = []
        for condition in conditions:
            start = "inside = inside && " if lines else "bool inside = "
            lines += comments.code(f"{start}{condition};")
        return lines

    def _norm(self, group: Group) -> list[str]:
        """The statement that looks at a norm, if there is one."""
        if not has_norm(group.domain):
            return []
        return group.skewed(self.target, unless="bounded" if self._is_bounded(group) else "")

    def _tests(self, group: Group) -> Iterator[str]:
        texts = iter(group.texts)
        for limits, run in runs_of(group.elements, self.target):
            arguments = [*islice(texts, len(run)), limits.text]
            yield f"{limits.condition(len(run))}({', '.join(arguments)})"
