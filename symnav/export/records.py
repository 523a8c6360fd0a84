"""What every part of a bundle is made from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from symnav import ir
from symnav.derive import Derivation
from symnav.export.rounding.tolerances import Tolerance
from symnav.spec.records import Spec


@dataclass(frozen=True, slots=True)
class Options:
    """What the caller of ``export`` chose.

    Attributes:
        scalar: type the functions are wanted in.
        tolerance: largest rounding error of a value that is accepted, in the value's unit.
        batches: True for entry points over many epochs as well.
        guards: where checks stand, instead of what the specification says; None to follow it.
    """

    scalar: ir.Scalar
    tolerance: Tolerance = field(default_factory=Tolerance)
    batches: bool = False
    guards: ir.Guards | None = None

    @property
    def plain(self) -> Mapping[str, object]:
        """For a manifest."""
        return {
            "scalar": self.scalar.value,
            "tolerance": self.tolerance.plain,
            "batches": self.batches,
            "guards": None if self.guards is None else self.guards.value,
        }


@dataclass(frozen=True, slots=True)
class Tree:
    """The C of one scalar type.

    Attributes:
        module: what its files were emitted from.
        files: text by path inside the bundle: ``include/<prefix>/...`` and ``src/...``.
    """

    module: ir.Module
    files: Mapping[str, str]

    @property
    def prefix(self) -> str:
        """Leads every symbol and file name."""
        return self.module.name

    @property
    def sources(self) -> tuple[str, ...]:
        """Paths of its translation units, in order."""
        return tuple(sorted(path for path in self.files if path.endswith(".c")))

    @property
    def headers(self) -> tuple[str, ...]:
        """Paths of its public headers, in order."""
        return tuple(sorted(path for path in self.files if path.startswith("include/")))


@dataclass(frozen=True, slots=True)
class Bundle:
    """One bundle before its files are written.

    Attributes:
        spec: what it was made from.
        derivations: retract and local, then the entries, as the trees' functions name them.
        trees: the tree of the type that was asked for, then, in a bundle of single precision, the
            tree of those functions that must be double.
        options: what the caller chose.
    """

    spec: Spec
    derivations: tuple[Derivation, ...]
    trees: tuple[Tree, ...]
    options: Options

    @property
    def name(self) -> str:
        """Name of the library and of its folder below ``include``: the first tree's prefix."""
        return self.trees[0].prefix

    def functions(self) -> Iterator[tuple[Tree, ir.Function]]:
        """Every function with the tree it belongs to."""
        for tree in self.trees:
            for function in tree.module.functions:
                yield tree, function
