"""Which tests look at which file: the quick ones of each, and everything that could notice."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

_MODELS = ("elimination", "equations", "pseudorange", "specific_force")
#: File or folder -> tests of the core that look at it, the most telling first.
_QUICK: dict[str, tuple[str, ...]] = {
    "symnav/graph.py": ("graph", "elimination", "quantities"),
    "symnav/quantities": ("quantities", "elimination", "tangents", "equations"),
    "symnav/elimination.py": ("elimination", "budgets", *_MODELS),
    "symnav/binding.py": ("tangents", "equations", "pseudorange", "elimination"),
    "symnav/derive.py": ("equations", "blocks", "pseudorange", "elimination", "broadcast_orbit"),
    "symnav/equations/gnss_position.py": ("equations", "declarations"),
    "symnav/equations/pseudorange.py": ("pseudorange", "declarations"),
    "symnav/equations/specific_force.py": ("specific_force", "declarations"),
    "symnav/equations/broadcast_orbit.py": ("broadcast_orbit", "declarations"),
    "symnav/equations": ("declarations", *_MODELS),
    "symnav/blocks": ("blocks", "tangents", "equations"),
    "symnav/frames": ("frames", "blocks", "tangents", "specific_force", "broadcast_orbit"),
    "symnav/lower/casadi_witness.py": ("witness",),
    "symnav/lower/signature.py": ("blocks", "declarations"),
    "symnav/lower": ("lowering", "elimination", "blocks", "budgets"),
}
#: Folders and files of ``tests`` that could notice a mutant no quick test sees. Tests that compare
#: bytes are not among them: they notice every change, the right ones too.
_FULL = (
    "core",
    "spec",
    "oracles",
    "verify",
    "models",
    "test_pipeline.py",
    "test_random_layouts.py",
)
#: The same for what turns derivations into text.
_EMISSION = ("passes", "lower", "emit_numpy", "emit_c", "build")


def quick(root: Path, file: str) -> list[str]:
    """A few seconds of tests, in process and without a compiler."""
    if file.startswith("symnav/emit/"):
        return _existing(root, ("core/test_printers.py",))
    if file.startswith("symnav/lower/passes/"):
        return _existing(root, ("core/test_passes.py", "core/test_budgets.py", "passes"))
    best = max((key for key in _QUICK if file.startswith(key)), key=len)
    return _existing(root, dict.fromkeys(f"core/test_{name}.py" for name in _QUICK[best]))


def full(root: Path, file: str) -> list[str]:
    """Everything that runs the file or what it generates."""
    emitted = file.startswith(("symnav/lower/", "symnav/emit/"))
    return _existing(root, (*_FULL, *(_EMISSION if emitted else ())))


def _existing(root: Path, names: Sequence[str] | dict[str, None]) -> list[str]:
    return [f"tests/{name}" for name in names if (root / "tests" / name).exists()]
