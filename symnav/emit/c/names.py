"""Identifiers inside the C: unique without regard to case, and never a word C or math.h owns."""

from __future__ import annotations

import re
from collections.abc import Iterable

_KEYWORDS = frozenset(
    """
    auto break case char const continue default do double else enum extern float for goto if
    inline int long register restrict return short signed sizeof static struct switch typedef
    union unsigned void volatile while bool true false null asm typeof
    alignas alignof and and_eq bitand bitor catch class compl constexpr delete explicit export
    friend mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected
    public template this throw try typeid typename using virtual xor xor_eq
    """.split()
)

# Functions and macros of <math.h> and types of <stdint.h>, and the compilers' built-in names that
# -Wshadow reports.
_LIBRARY = frozenset(
    """
    acos asin atan atan2 cos sin tan cosh sinh tanh acosh asinh atanh exp exp2 expm1 frexp ilogb
    ldexp log log10 log1p log2 logb modf scalbn scalbln cbrt fabs hypot pow sqrt erf erfc lgamma
    tgamma ceil floor nearbyint rint lrint llrint round lround llround trunc fmod remainder remquo
    copysign nan nextafter nexttoward fdim fmax fmin fma gamma signgam j0 j1 jn y0 y1 yn div abs
    infinity huge_val int32_t uint32_t uint8_t size_t ptrdiff_t index time signal stdin stdout main
    drem significand finite isnan isinf isfinite signbit exp10 pow10 sincos
    """.split()
)

RESERVED = _KEYWORDS | _LIBRARY | frozenset(f"{name}f" for name in _LIBRARY)


class Names:
    """Hands out identifiers of one scope; the same requests give the same identifiers."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = {name.lower() for name in taken} | RESERVED

    def claim(self, wish: str) -> str:
        """The identifier nearest to a wish that nobody has yet."""
        stem = identifier(wish)
        name, count = stem, 2
        while name.lower() in self._taken:
            name, count = f"{stem}_{count}", count + 1
        self._taken.add(name.lower())
        return name


def identifier(text: str) -> str:
    """Letters, digits and single inner underscores of a text, starting with a letter."""
    words = re.findall(r"[A-Za-z0-9]+", text)
    joined = "_".join(words) or "value"
    return joined if joined[0].isalpha() else f"v{joined}"
