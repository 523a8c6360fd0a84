"""Names of the types a generated package defines."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from symnav import ir


def result_names(functions: Sequence[ir.Function]) -> dict[str, str]:
    """The name of every function's result type, by function.

    Underscores go (``gps_position`` returns a ``GpsPositionResult``), except where two functions
    would end up with the same name.
    """
    short = {function.name: _camel(function.name, "") for function in functions}
    counts = Counter(short.values())
    return {
        name: f"{wish if counts[wish] == 1 else _camel(name, '_')}Result"
        for name, wish in short.items()
    }


def form_name(function: ir.Function) -> str:
    """The name of the type of the function itself, in stubs."""
    return f"_{_camel(function.name, '_')}"


def _camel(name: str, joint: str) -> str:
    return joint.join(word[:1].upper() + word[1:] for word in name.split("_"))
