"""Straight ways from NumPy's arrays into compiled C, where NumPy's headers are installed.

They are part of the extension alone. An extension without them does the same, only slower.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

FOLDER = "straight"


@dataclass(frozen=True, slots=True)
class Straight:
    """C that reads NumPy's arrays.

    Attributes:
        sources: one for each scalar type.
        headers: what they declare.
        include: folders of headers: their own, then NumPy's.
        numpy: generation of NumPy, which decides how its arrays are laid out.
    """

    sources: tuple[Path, ...]
    headers: tuple[Path, ...]
    include: tuple[Path, Path]
    numpy: str


def find_straight(package: Path) -> Straight | None:
    """The straight ways of a package; nothing where it has none or NumPy lacks its headers."""
    import numpy as np

    folder, headers = package / FOLDER, Path(np.get_include())
    sources = tuple(sorted(folder.glob("*_straight.c")))
    if not sources or not (headers / "numpy" / "arrayobject.h").is_file():
        return None
    declared = tuple(source.with_suffix(".h") for source in sources)
    generation = np.__version__.partition(".")[0]
    return Straight(sources, declared, (folder, headers), generation)
