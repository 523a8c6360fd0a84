"""The exceptions symnav raises.

Every exception carries one message that says what is wrong, where, what was expected and what to
do next. ``exit_code`` is what the command line returns when the exception reaches it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar


class SymnavError(Exception):
    """Base of every error symnav raises on purpose; never raised itself."""

    exit_code: ClassVar[int] = 1


class InputError(SymnavError):
    """Raised when something the user wrote cannot be used; change the input the message names."""

    exit_code: ClassVar[int] = 2


@dataclass(frozen=True, slots=True)
class Problem:
    """One mistake in a specification.

    Attributes:
        path: where it stands, for instance ``measurement[0].lever_arm``.
        message: what is wrong, what is allowed and what to do.
    """

    path: str
    message: str

    def __str__(self) -> str:
        return f"{self.path}: {self.message}" if self.path else self.message


class SpecError(InputError):
    """Raised when a specification has mistakes; all of them are listed in ``problems``."""

    def __init__(self, problems: Iterable[Problem], source: str = "specification") -> None:
        self.problems = tuple(problems)
        self.source = source
        count = len(self.problems)
        head = f"{source}: {count} problem{'s' if count != 1 else ''}"
        super().__init__("\n".join([head, *(f"  {problem}" for problem in self.problems)]))


class EquationError(InputError):
    """Raised inside an equation when units, frames or sizes do not fit; names the operation."""


class BuildError(SymnavError):
    """Raised when the C compiler is missing or refuses the generated code; the log is named."""


class ProofError(SymnavError):
    """Raised when a verification fails; the proof sheet names the output and the worst input."""

    exit_code: ClassVar[int] = 3


class StaleError(SymnavError):
    """Raised when a generated package no longer matches its specification; generate it again."""

    exit_code: ClassVar[int] = 4


class HandEditedError(SymnavError):
    """Raised when a generated file was changed by hand; regenerate it or keep a copy elsewhere."""

    exit_code: ClassVar[int] = 5
