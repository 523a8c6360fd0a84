"""What a contestant is: a candidate for one problem, and where its results stand."""

from __future__ import annotations

from dataclasses import dataclass

from benchmarks.problems import Problem
from symnav.bench.candidate import Candidate


@dataclass(frozen=True, kw_only=True)
class Contestant:
    """Code that evaluates one problem.

    Attributes:
        problem: what it evaluates.
        candidate: the code.
        order: where in its output every element of the problem's results stands, epoch by epoch.
        text: the source a reviewer reads; nothing where it is no contestant.
        functions: names of the functions in it that compute the model.
    """

    problem: Problem
    candidate: Candidate
    order: tuple[int, ...]
    text: str = ""
    functions: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """As reported."""
        return self.candidate.name


def symbol_of(problem: Problem, name: str) -> str:
    """Name of the adapter of a contestant."""
    return f"bench_{problem.name}_{name}"


def natural(problem: Problem) -> tuple[int, ...]:
    """The order of a contestant that writes values, then non-zeros by row."""
    return tuple(range(problem.rows + len(problem.pattern)))
