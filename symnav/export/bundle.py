"""From trees of C to the files of a bundle.

Every part is a module of this room with one function ``files(bundle)`` that returns text by path;
no part reads what another wrote. What lists the files of the others comes last.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from symnav.export import (
    building,
    documents,
    error_bounds,
    glue,
    proofs,
    provenance,
    targets,
    testing,
)  # fmt: skip
from symnav.export.records import Bundle

Part = Callable[[Bundle], Mapping[str, str]]

PARTS: tuple[Part, ...] = (
    building.files, documents.files, glue.files, testing.files, targets.files, error_bounds.files,
    proofs.files, provenance.files,
)  # fmt: skip


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
    for part in PARTS:
        progress(part.__module__.rpartition(".")[2])
        made = part(bundle)
        repeated = sorted(text.keys() & made.keys())
        if repeated:
            raise AssertionError(f"two parts of the bundle write {', '.join(repeated)}")
        text.update(made)
    progress("bill of materials")
    return {**text, **provenance.bill(bundle, text)}
