"""What every emitter is."""

from __future__ import annotations

from typing import Protocol

from symnav import ir


class Emitter(Protocol):
    """A target language: one folder of ``symnav.emit``, which offers one pure function."""

    def emit(self, module: ir.Module) -> dict[str, str]:
        """Render every file of this target.

        Args:
            module: what to emit, for one scalar type.

        Returns:
            Text by path, relative to the generated package, with forward slashes. The same
            module gives the same bytes.
        """
        ...
