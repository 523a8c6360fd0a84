"""Rules that the C of a bundle departs from, and why: one place for document, proofs and tests.

The rules are those of MISRA C:2012 as cppcheck's addon checks them. Their texts are not repeated
here; what a rule is about is said in words of our own.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Deviation:
    """An advisory rule that is departed from on purpose.

    Attributes:
        rule: its number.
        about: what it asks for, in short.
        where: what in the bundle departs from it.
        reason: why.
        safeguard: what keeps the risk the rule guards against away.
    """

    rule: str
    about: str
    where: str
    reason: str
    safeguard: str


DEVIATIONS: tuple[Deviation, ...] = (
    Deviation(
        "2.5",
        "A macro that nothing uses is to go.",
        "Digests, versions and numbers of non-zeros in the public headers.",
        "They are there for the caller: to assert the layout at compile time and to size arrays. "
        "Inside the library nothing needs them.",
        "Each is an integer or a string, none has arguments, and the interface control document "
        "names them.",
    ),
    Deviation(
        "5.9",
        "A name with internal linkage is to stand for one thing in the whole project.",
        "Constant tables and inline functions of headers, which every translation unit that "
        "includes them has a copy of.",
        "A table of constants in a header needs no definition elsewhere and can be folded; an "
        "inline function has to be visible where it is inlined.",
        "The copies come from one text. Two trees in one bundle never share a translation unit.",
    ),
    Deviation(
        "8.7",
        "A function that only one translation unit uses is not to have external linkage.",
        "Every entry point of the library.",
        "Entry points are called by the user's program, which is not part of what is analysed.",
        "What is not an entry point is static.",
    ),
    Deviation(
        "19.2",
        "A union is not to be used.",
        "The union in the check header by which a check reads the bits of a number.",
        "The bits of magnitudes are in the order of the magnitudes, NaN above all of them: one "
        "comparison of integers, or the sign of their difference, is a check, without a library "
        "call where a processor has no arithmetic of that type.",
        "Both members are of one size, and one function of three statements uses the union. C99 "
        "defines what reading the other member gives; compilers of C++ that take this code do so "
        "too. Frama-C proves the comparisons in its place, which tests hold against it.",
    ),
)
"""In the order of the rules. Tests find an entry for every finding, a finding for every entry."""
