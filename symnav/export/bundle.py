"""From trees of C to the files of a bundle.

Every part is a module of this room with one function ``files(bundle)`` that returns text by path;
no part reads what another wrote. What lists the files of the others comes last.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from symnav.export.building import build_files, glue, targets
from symnav.export.documents import pages, provenance
from symnav.export.proofs import inputs
from symnav.export.records import Bundle
from symnav.export.rounding import error_bounds
from symnav.export.testing import program

Part = Callable[[Bundle], Mapping[str, str]]

PARTS: Mapping[str, Part] = {
    "build files": build_files.files,
    "documents": pages.files,
    "glue": glue.files,
    "test program": program.files,
    "targets": targets.files,
    "error bounds": error_bounds.files,
    "proofs": inputs.files,
    "provenance": provenance.files,
}


def _silent(_part: str) -> None:
    """Report nothing."""


def assemble(bundle: Bundle, progress: Callable[[str], None] = _silent) -> dict[str, str]:
    """Every file of a bundle except its manifest, by path.

    The same bundle gives the same bytes: no clock, no path of this machine, no hash order.

    Args:
        bundle: what to write.
        progress: told each part as it begins.
    """
    text = {path: content for tree in bundle.trees for path, content in tree.files.items()}
    for name, part in PARTS.items():
        progress(name)
        made = part(bundle)
        repeated = sorted(text.keys() & made.keys())
        if repeated:
            raise AssertionError(f"two parts of the bundle write {', '.join(repeated)}")
        text.update(made)
    progress("bill of materials")
    return {**text, **provenance.bill(bundle, text)}
