"""The flight-software bundle: sources, tests, build files, documents and proofs."""

from symnav.export.bundle import assemble
from symnav.export.records import Bundle, Options, Tree
from symnav.export.rounding.tolerances import Tolerance

__all__ = ["Bundle", "Options", "Tolerance", "Tree", "assemble"]
