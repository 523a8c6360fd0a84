"""What every emitter is."""

from __future__ import annotations

from typing import Protocol

from symnav import ir


class Emitter(Protocol):
    """A pure function from a module to files.

    The keys of the result are paths relative to the generated package, with forward slashes; the
    values are the whole text of each file. The same module gives the same bytes.
    """

    def __call__(self, module: ir.Module) -> dict[str, str]:
        """Render every file of this target."""
        ...
