"""From trees of C to the files of a bundle.

Every part is a module of this room with one function ``files(bundle)`` that returns text by path;
no part reads what another wrote. What lists the files of the others comes last.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from symnav.export import proofs
from symnav.export.records import Bundle

Part = Callable[[Bundle], Mapping[str, str]]

PARTS: tuple[Part, ...] = (proofs.files,)


def assemble(bundle: Bundle) -> dict[str, str]:
    """Every file of a bundle except its manifest, by path.

    The same bundle gives the same bytes: no clock, no path of this machine, no hash order.
    """
    text = {path: content for tree in bundle.trees for path, content in tree.files.items()}
    for part in PARTS:
        made = part(bundle)
        repeated = sorted(text.keys() & made.keys())
        if repeated:
            raise AssertionError(f"two parts of the bundle write {', '.join(repeated)}")
        text.update(made)
    return text
