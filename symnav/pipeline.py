"""The whole flow, in order.

    load      Input: a TOML file, or the name of a shipped model.   Output: ``Spec``
    derive    Input: ``Spec``.                                      Output: ``Derivation`` each
    lower     Input: ``Derivation``, by two routes.                 Output: ``ir.Module`` each
    emit      Input: ``ir.Module``.                                 Output: text by path
    write     Input: text by path.                                  Output: a package on disk
    build     Input: a package.                                     Output: its extension
    verify    Input: ``Spec`` and the imported package.             Output: ``ProofSheet``
    export    Input: ``Spec`` and its C by route of CasADi.         Output: a bundle on disk

``generate`` runs the stages from derive to write, ``verify`` all up to its own, and ``export``
those up to lower, then its own.
"""

from __future__ import annotations

import importlib
import importlib.util
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from importlib.resources import files
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, TypeVar

from symnav.errors import InputError

if TYPE_CHECKING:
    from symnav import ir
    from symnav.build import BuildResult
    from symnav.derive import Derivation
    from symnav.emit.manifest import CheckReport
    from symnav.export import Bundle, Tolerance, Tree
    from symnav.export.proofs.proving import Proven
    from symnav.spec.records import Spec
    from symnav.verify.sheet import Finding, ProofSheet

Progress = Callable[[str], None]
T = TypeVar("T")


def _silent(_stage: str) -> None:
    """Report nothing."""


@dataclass(frozen=True)
class Generated:
    """What generation did.

    Attributes:
        package: directory of the generated package.
        written: relative paths of the files that were new or different.
        unchanged: True when the package was already current.
        seconds: time per stage.
    """

    package: Path
    written: tuple[str, ...]
    unchanged: bool
    seconds: Mapping[str, float]


@dataclass(frozen=True)
class Derived:
    """The derivations of a spec: its entries, and retract and local where there is a state."""

    entries: tuple[Derivation, ...]
    layout: tuple[Derivation, ...]


@dataclass(frozen=True)
class Exported:
    """What an export did.

    Attributes:
        folder: the bundle.
        written: relative paths of the files that were new or different.
        unchanged: True when the bundle was already current.
        name: of the library.
        trees: prefix of its symbols and files, scalar type and functions of every tree of C.
        proven: what the proofs said, where they were asked for.
    """

    folder: Path
    written: tuple[str, ...]
    unchanged: bool
    name: str
    trees: tuple[tuple[str, str, tuple[str, ...]], ...]
    proven: Proven | None = None


def shipped() -> list[tuple[str, str]]:
    """Names and titles of the shipped models, in alphabetical order."""
    found = []
    for path in sorted(_models().iterdir(), key=lambda p: p.name):
        if path.name.endswith(".toml"):
            first = path.read_text(encoding="utf-8").splitlines()[0]
            found.append((path.name.removesuffix(".toml"), first.lstrip("# ").strip()))
    return found


def load(spec: str | Path) -> Spec:
    """Read a specification: a file, or the name of a shipped model; folders do not count.

    Raises:
        SpecError: with every mistake of the specification.
        InputError: when there is no such file or model.
    """
    from symnav import spec as specification

    path = Path(spec)
    if path.suffix == ".toml" or (path.exists() and not path.is_dir()):
        return specification.load(path)
    shipped_path = _models() / f"{spec}.toml"
    if path.name != str(spec) or not shipped_path.is_file():
        names = ", ".join(name for name, _ in shipped())
        raise InputError(f"{spec}: neither a file nor a shipped model; the models are {names}")
    return specification.load(Path(str(shipped_path)))


def derive(spec: Spec) -> Derived:
    """Derive every entry of a spec, and retract and local of its layout if it has blocks."""
    from symnav import derive as derivation
    from symnav.naming import RESERVED

    reserved = RESERVED | spec.inputs.keys()
    maps = (derivation.derive_retract, derivation.derive_local) if spec.layout.blocks else ()
    return Derived(
        tuple(derivation.derive(spec, entry, reserved) for entry in spec.entries),
        tuple(derive_map(spec, reserved) for derive_map in maps),
    )


def emit(spec: Spec, derived: Derived) -> dict[str, str]:
    """Lower by both routes and emit every file of the package except its manifest."""
    from symnav import ir
    from symnav.emit import c, numpy, python
    from symnav.lower import casadi_witness, sympy
    from symnav.lower.module import module

    everything = (*derived.layout, *derived.entries)
    c_functions = c_route(spec, derived)
    numpy_functions = [sympy.lower(spec, derivation) for derivation in everything]
    double = module(spec, c_functions)
    vectorised = module(spec, numpy_functions)
    single = module(spec, c_functions, ir.Scalar.FLOAT) if "float" in spec.scalars else None
    text = {**c.emit(double), **numpy.emit(vectorised), **python.emit(double, single)}
    if single is not None:
        text |= c.emit(single)
    return text | casadi_witness.sources(spec, derived.entries)


def c_route(spec: Spec, derived: Derived) -> tuple[ir.Function, ...]:
    """Every function as its C is written: through CasADi's graph and the passes that follow."""
    from symnav.lower import casadi
    from symnav.lower.module import through
    from symnav.lower.passes.angles import own_sinusoids
    from symnav.lower.passes.inline import inline
    from symnav.lower.passes.ranges import drop_idle_checks
    from symnav.lower.passes.reciprocals import share_reciprocals

    everything = (*derived.layout, *derived.entries)
    lowered = [casadi.lower(spec, derivation) for derivation in everything]
    return through(lowered, share_reciprocals, inline, drop_idle_checks, own_sinusoids)


def generate(
    spec: Spec, out: Path, progress: Progress = _silent, *, force: bool = False
) -> Generated:
    """Write the package of a spec below ``out``; nothing is written when a stage fails.

    Args:
        spec: what to generate.
        out: the package goes to ``out/<name>``.
        progress: told each stage.
        force: write over changes made by hand.

    Raises:
        HandEditedError: when files of the package there were changed by hand.
        InputError: when the folder there is not a generated package.
    """
    return _generate(spec, out, progress, force)[0]


def _generate(
    spec: Spec, out: Path, progress: Progress, force: bool = False
) -> tuple[Generated, Derived]:
    from symnav.emit import manifest, writing
    from symnav.lower.module import digest

    seconds: dict[str, float] = {}
    if not force:
        writing.protect(out / spec.name, f"package {spec.name}")
    derived = _timed("derive", seconds, progress, lambda: derive(spec))
    text = _timed("emit", seconds, progress, lambda: emit(spec, derived))
    package = out / spec.name
    origin = manifest.Origin(f"package {spec.name}", digest(spec), tuple(spec.scalars))
    written = _timed("write", seconds, progress, lambda: writing.write(package, text, origin))
    return Generated(package, written, not written, seconds), derived


def build(package: Path, native: bool = False, progress: Progress = _silent) -> BuildResult:
    """Compile the extensions of a package.

    Raises:
        BuildError: when there is no compiler, or it refuses the code.
    """
    from symnav import build as building

    return building.build(package, native=native, log=progress)


def check(package: Path, spec: Spec | None = None) -> CheckReport:
    """Say whether a package is fresh, stale or hand-edited."""
    from symnav.emit import manifest
    from symnav.lower.module import digest

    return manifest.check(package, None if spec is None else digest(spec))


def verify(
    spec: Spec,
    *,
    samples: int = 200,
    seed: int = 1,
    reference: Path | None = None,
    out: Path | None = None,
    progress: Progress = _silent,
) -> ProofSheet:
    """Generate, build and import the package of a spec, and prove it.

    Args:
        spec: what to verify.
        samples: per function.
        seed: of the samples.
        reference: directory of references written from the book.
        out: where the package goes; a temporary directory by default.
        progress: told each stage.
    """
    import tempfile

    if out is not None:
        return _verify_in(spec, out, samples, seed, reference, progress)
    with tempfile.TemporaryDirectory(prefix="symnav-") as folder:
        return _verify_in(spec, Path(folder), samples, seed, reference, progress)


def _verify_in(
    spec: Spec, out: Path, samples: int, seed: int, reference: Path | None, progress: Progress
) -> ProofSheet:
    from symnav.verify.proof import prove
    from symnav.verify.references import References

    judge = None if reference is None else References(reference)
    generated, derived = _generate(spec, out, progress)
    package = generated.package
    refused = _refused(package, progress)
    imported = import_package(package)
    sheet = prove(
        spec, derived.entries, derived.layout, imported,
        samples=samples, seed=seed, reference=judge, progress=progress,
    )  # fmt: skip
    return replace(sheet, findings=(*refused, *sheet.findings))


def export(
    spec: Spec,
    folder: Path,
    *,
    scalar: str = "double",
    tolerance: float | Tolerance | None = None,
    batches: bool = False,
    guards: str | None = None,
    proofs: bool = False,
    force: bool = False,
    progress: Progress = _silent,
) -> Exported:
    """Write the flight-software bundle of a spec; nothing is written when a stage fails.

    Args:
        spec: what to export.
        folder: becomes the bundle.
        scalar: ``double`` or ``float``.
        tolerance: largest rounding error that is accepted, in each value's unit; of all functions
            or of each.
        batches: entry points for many epochs as well.
        guards: ``status``, ``outer`` or ``assume``: where the checks of every function stand,
            instead of where the specification says.
        proofs: run every proof whose tool is installed over what was written.
        force: write over changes made by hand.
        progress: told each stage.

    Raises:
        HandEditedError: when files of the bundle there were changed by hand.
        InputError: when the folder there is no bundle, or a value may err by too much.
    """
    from symnav.emit import manifest, writing
    from symnav.export import assemble
    from symnav.export.proofs.proving import prove
    from symnav.lower.module import digest

    if not force:
        writing.protect(folder, f"bundle {spec.name}")
    made = bundle(spec, scalar, tolerance, batches=batches, guards=guards, progress=progress)
    text = assemble(made, progress)
    progress("write")
    scalars = tuple(tree.module.scalar.value for tree in made.trees)
    origin = manifest.Origin(f"bundle {spec.name}", digest(spec), scalars, made.options.plain)
    written = writing.write(folder, text, origin)
    contents = tuple(
        (tree.prefix, tree.module.scalar.value, tuple(f.name for f in tree.module.functions))
        for tree in made.trees
    )
    proven = prove(folder, progress=progress) if proofs else None
    return Exported(folder, written, not written, made.name, contents, proven)


def bundle(
    spec: Spec,
    scalar: str = "double",
    tolerance: float | Tolerance | None = None,
    *,
    batches: bool = False,
    guards: str | None = None,
    progress: Progress = _silent,
) -> Bundle:
    """What ``export`` writes, before its files are assembled; see there.

    Raises:
        InputError: when a value may err by more than the tolerance.
    """
    from symnav import ir
    from symnav.export import Bundle, Options, Tolerance
    from symnav.export.rounding.error_bounds import refuse_beyond, with_bounds

    where = None if guards is None else ir.Guards(guards)
    accepted = Tolerance.of(tolerance)
    accepted.check(entry.name for entry in spec.entries)
    progress("derive")
    derived = derive(spec if where is None else _guarded_by(spec, where))
    progress("lower")
    modules = _modules(spec, derived, ir.Scalar(scalar))
    if where is not None:
        modules = [_all_guarded_by(module, where) for module in modules]
    progress("bound")
    modules = [replace(with_bounds(module), batches=batches) for module in modules]
    refuse_beyond(spec, modules, accepted)
    progress("emit")
    trees = tuple(_tree(module) for module in modules)
    derivations = (*derived.layout, *derived.entries)
    return Bundle(spec, derivations, trees, Options(ir.Scalar(scalar), accepted, batches, where))


def _modules(spec: Spec, derived: Derived, scalar: ir.Scalar) -> list[ir.Module]:
    """What a bundle holds: one module, in single precision a second of what must be double."""
    from symnav import ir
    from symnav.lower.module import module

    functions = c_route(spec, derived)
    if scalar is ir.Scalar.DOUBLE:
        return [module(spec, functions)]
    wide = {e.name for e in spec.entries if e.model.always_double}
    kept = tuple(f for f in functions if f.name in wide)
    single = module(_in_float(spec), functions, scalar)
    return [single, module(spec, kept)] if kept else [single]


def _guarded_by(spec: Spec, guards: ir.Guards) -> Spec:
    """A spec whose checks stand where they are wanted."""
    return replace(spec, entries=tuple(replace(e, guards=guards.value) for e in spec.entries))


def _all_guarded_by(module: ir.Module, guards: ir.Guards) -> ir.Module:
    """The same of a module, with what comes from the layout and has no entry in a spec."""
    return replace(module, functions=tuple(replace(f, guards=guards) for f in module.functions))


def _tree(module: ir.Module) -> Tree:
    """The C of a module."""
    from symnav.emit import c
    from symnav.export import Tree

    return Tree(module, {path.removeprefix("c/"): text for path, text in c.emit(module).items()})


def _in_float(spec: Spec) -> Spec:
    """A spec in which everything that may be single precision is."""
    entries = tuple(
        e if e.model.always_double else replace(e, scalars=("double", "float"))
        for e in spec.entries
    )
    return replace(spec, entries=entries)


def _refused(package: Path, progress: Progress) -> tuple[Finding, ...]:
    """Build a package that is to be proven; what speaks against it.

    Where there is no compiler NumPy is proven alone, and the sheet notes it. C that a compiler
    refuses is a failed proof.
    """
    from symnav import build as building
    from symnav.errors import BuildError
    from symnav.verify.sheet import Finding

    try:
        building.find_compiler()
    except BuildError as error:
        progress(f"no extension: {error}")
        return ()
    try:
        build(package, progress=progress)
    except BuildError as error:
        # The log goes where a temporary package goes: it is told instead of named.
        message, _, log = str(error).partition("; its whole output is in ")
        said = f"\n{Path(log).read_text(encoding='utf-8').strip()}" if log else ""
        return (Finding(package.name, f"the generated C was not built: {message}{said}"),)
    return ()


def import_package(package: Path) -> ModuleType:
    """Import a generated package from its directory, whatever the search path."""
    path = package.resolve()
    name = f"_symnav_{abs(hash(str(path))):x}_{path.name}"
    for loaded in [n for n in sys.modules if n == name or n.startswith(f"{name}.")]:
        del sys.modules[loaded]
    importlib.invalidate_caches()
    found = importlib.util.spec_from_file_location(
        name, path / "__init__.py", submodule_search_locations=[str(path)]
    )
    if found is None or found.loader is None or not (path / "__init__.py").is_file():
        raise InputError(f"{package}: not a generated package; run symnav generate first")
    module = importlib.util.module_from_spec(found)
    sys.modules[name] = module
    found.loader.exec_module(module)
    return module


def _models() -> Path:
    return Path(str(files("symnav") / "models"))


def _timed(stage: str, seconds: dict[str, float], progress: Progress, run: Callable[[], T]) -> T:
    progress(stage)
    start = time.perf_counter()
    result = run()
    seconds[stage] = time.perf_counter() - start
    return result
