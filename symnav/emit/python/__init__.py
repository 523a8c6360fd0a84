"""The Python package around the back ends: descriptions, state, stubs and the compiled doors."""

from symnav.emit.python.package import emit

__all__ = ["emit"]
