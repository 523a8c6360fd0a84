"""How much rounding may move a value: one number for every function, others for some of them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from symnav.errors import InputError
from symnav.spec.problems import choices, suggestion


@dataclass(frozen=True, slots=True)
class Tolerance:
    """The largest rounding error that is accepted, in the unit of each value.

    Attributes:
        everywhere: of the functions that have none of their own; None for any.
        own: of single functions, by their name in the specification.
    """

    everywhere: float | None = None
    own: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        everywhere = {} if self.everywhere is None else {"": self.everywhere}
        for name, number in (everywhere | dict(self.own)).items():
            if not 0.0 < number < math.inf:
                of = f" of {name}" if name else ""
                raise InputError(f"the tolerance{of} is {number:g}; give a finite number above 0")

    @staticmethod
    def of(given: float | Tolerance | None) -> Tolerance:
        """A number, which holds for every function, or nothing, as a tolerance.

        Raises:
            InputError: when the number is no tolerance.
        """
        return given if isinstance(given, Tolerance) else Tolerance(given)

    @staticmethod
    def read(words: Iterable[str]) -> Tolerance:
        """What the words ``NUMBER`` and ``FUNCTION=NUMBER`` mean together.

        Raises:
            InputError: when a word is neither, or something is said twice.
        """
        found: dict[str, float] = {}
        for word in words:
            name, _, number = word.rpartition("=")
            name = name.strip()
            if "=" in word and not name:
                raise InputError(f"{word!r} names no function; write FUNCTION=NUMBER")
            if name in found:
                raise InputError(f"{name or 'the tolerance of every function'} is given twice")
            try:
                found[name] = float(number)
            except ValueError:
                raise InputError(
                    f"{word!r} is neither a number nor FUNCTION=NUMBER, such as 0.01 or gps=0.01"
                ) from None
        return Tolerance(found.pop("", None), found)

    def check(self, functions: Iterable[str]) -> None:
        """Refuse names that no function has.

        Args:
            functions: names of all measurements and corrections.

        Raises:
            InputError: naming the first of them.
        """
        known = tuple(functions)
        for name in self.own:
            if name not in known:
                hint = suggestion(name, known) or (
                    f"; choose {choices(known)}" if known else "; there is none"
                )
                raise InputError(
                    f"{name!r} has a tolerance and is no measurement or correction{hint}"
                )

    def limit(self, function: str) -> float:
        """Of one function; infinite where everything is accepted."""
        number = self.own.get(function, self.everywhere)
        return math.inf if number is None else number

    def accepts(self, function: str, bound: float) -> bool:
        """Whether a value of a function may err by a bound, which need not be a number."""
        limit = self.limit(function)
        return limit == math.inf or bound <= limit

    @property
    def words(self) -> tuple[str, ...]:
        """What ``read`` understands, one for each option on a command line."""
        everywhere = () if self.everywhere is None else (repr(self.everywhere),)
        return (*everywhere, *(f"{name}={number!r}" for name, number in sorted(self.own.items())))

    @property
    def plain(self) -> float | list[str] | None:
        """For a manifest: the number of every function, or the words where it is not one."""
        return list(self.words) if self.own else self.everywhere
