"""Mistakes of a specification, gathered so that all of them are reported at once."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass, field

from symnav.errors import Problem, SpecError


@dataclass
class Problems:
    """The mistakes found so far, in the order of the specification's stages."""

    found: list[Problem] = field(default_factory=list)

    def add(self, path: str, message: str) -> None:
        """Record one mistake; the same mistake is recorded once."""
        problem = Problem(path, message)
        if problem not in self.found:
            self.found.append(problem)

    def raise_if_any(self, source: str) -> None:
        """Raise what was found.

        Raises:
            SpecError: when anything was found.
        """
        if self.found:
            raise SpecError(self.found, source)


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name that a misspelled one probably means."""
    by_folded = {other.lower(): other for other in known}
    close = difflib.get_close_matches(name.lower(), by_folded, n=1, cutoff=0.6)
    return by_folded[close[0]] if close else None


def suggestion(name: str, known: Iterable[str]) -> str:
    """``; did you mean 'position'?`` or nothing."""
    close = nearest(name, known)
    return f"; did you mean {close!r}?" if close is not None else ""


def choices(allowed: Iterable[object]) -> str:
    """The allowed values in words: ``'a', 'b' or 'c'``."""
    words = [repr(value) for value in allowed]
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} or {words[-1]}"
