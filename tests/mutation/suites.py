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
#: Folders and files of ``tests`` that could notice a mutant no quick test sees.
_FULL = (
    "core",
    "spec",
    "reference",
    "oracles",
    "models",
    "demo",
    "examples",
    "test_pipeline.py",
    "test_verify.py",
    "test_random_layouts.py",
)
#: The same for what turns derivations into text.
_EMISSION = (
    "passes",
    "emit_numpy",
    "emit_c",
    "emit_package",
    "build",
    "test_guards.py",
    "test_strict_c.py",
)
#: What is no use here. Tests that compare bytes notice every change, the right ones too; those of
#: bundles take minutes; the others are about what no mutant touches, or are no tests.
LEFT_OUT = (
    "data",
    "export",
    "golden",
    "mutation",
    "performance",
    "test_bench.py",
    "test_benchmark_lines.py",
    "test_ci.py",
    "test_cli.py",
    "test_generated.py",
    "test_golden.py",
    "test_house.py",
    "test_readme.py",
    "test_unread.py",
    "test_wheel.py",
)


def quick(root: Path, file: str) -> list[str]:
    """A few seconds of tests, in process and without a compiler."""
    if file.startswith("symnav/emit/"):
        return _paths(root, ("core/test_printers.py",))
    if file.startswith("symnav/lower/passes/"):
        return _paths(root, ("core/test_passes.py", "core/test_budgets.py", "passes"))
    best = max((key for key in _QUICK if file.startswith(key)), key=len)
    return _paths(root, [f"core/test_{name}.py" for name in dict.fromkeys(_QUICK[best])])


def full(root: Path, file: str) -> list[str]:
    """Everything that runs the file or what it generates."""
    emitted = file.startswith(("symnav/lower/", "symnav/emit/"))
    return _paths(root, (*_FULL, *(_EMISSION if emitted else ())))


def listed() -> set[str]:
    """Folders and files of ``tests`` that some mutant meets."""
    return {*_FULL, *_EMISSION}


def _paths(root: Path, names: Sequence[str]) -> list[str]:
    """Paths below the root.

    Raises:
        FileNotFoundError: when one is not there, so that no mutant is spared by a misspelt name.
    """
    for name in names:
        if not (root / "tests" / name).exists():
            raise FileNotFoundError(f"tests/mutation/suites.py lists {name}, which tests has not")
    return [f"tests/{name}" for name in names]
