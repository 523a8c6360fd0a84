"""Names of what a generated package defines, and names it must keep for itself."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from symnav import errors, ir

ARGUMENTS = frozenset({"guards", "out", "reference", "xp"})
"""Parameters of generated functions beside their arguments."""

BLOCKS = frozenset({"conventions", "slices"})
"""Attributes of the state object that are not blocks."""

FUNCTIONS = frozenset({"casadi", "native", "native_f32", "numpy"})
"""Modules of the package."""


def refuse_reserved(module: ir.Module) -> None:
    """Refuse names that would hide what the package itself defines.

    Raises:
        InputError: with the name and what it was given to.
    """
    given = [("function", function.name, FUNCTIONS) for function in module.functions]
    given += [("state block", block.name, BLOCKS) for block in module.state.blocks]
    given += [
        ("input", argument.name, ARGUMENTS)
        for function in module.functions
        for argument in function.arguments
    ]
    for what, name, reserved in given:
        if name in reserved:
            raise errors.InputError(
                f"no {what} can be called {name!r}: the generated package uses that name itself; "
                "choose another"
            )


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
