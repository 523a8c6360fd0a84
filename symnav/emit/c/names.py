"""Identifiers inside the C: unique without regard to case, and never a word C or math.h owns."""

from __future__ import annotations

import re
from collections.abc import Iterable

from symnav import naming

# Functions that -Wshadow knows without a declaration.
_OTHER = frozenset(
    ("index", "time", "signal", "main", "exp10", "pow10", "sincos", "remove", "rename")
)

RESERVED = frozenset(
    name.lower()
    for name in (
        *naming.C_KEYWORDS,
        *naming.CPP_KEYWORDS,
        *naming.MATH_NAMES,
        *naming.C_MACROS,
        *naming.STANDARD_NAMES,
        *naming.HELPER_NAMES,
        *_OTHER,
    )
)


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
