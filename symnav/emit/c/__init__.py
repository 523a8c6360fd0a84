"""C99 for flight software: one kernel per function, entry points that load, evaluate and store."""

from symnav.emit.c.emitter import emit, sections

__all__ = ["emit", "sections"]
