"""``manifest.json``: what a package was made from and what it holds, and whether that still is so.

It names the generator, the specification and every file by digest; no clock and no path, so that
the same specification gives the same bytes anywhere.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path, PurePosixPath

from symnav import __version__
from symnav.emit.storing import store
from symnav.errors import InputError

MANIFEST = "manifest.json"
RESULTS = "proof/results.json"
"""Lists what proofs of the files said, by digest, and the digest of the manifest they are of."""

_GENERATOR = f"symnav {__version__}"
_BUILT = frozenset({MANIFEST, "_build.json", "_build.log"})
_BUILD_FOLDER = "build"  # where the build files of a bundle put everything they make
_BINARIES = frozenset({".so", ".pyd", ".dylib", ".pyc"})


class State(StrEnum):
    """What a package is, compared with what made it."""

    FRESH = "fresh"
    STALE = "stale"
    HAND_EDITED = "hand-edited"


@dataclass(frozen=True, slots=True)
class CheckReport:
    """What a check found.

    Attributes:
        state: hand-edited files outweigh staleness.
        files: those that were changed, removed or added by hand, by path inside the package.
        reasons: one sentence for each finding.
    """

    state: State
    files: tuple[str, ...]
    reasons: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Origin:
    """What the files of a folder are, and what they were made from.

    Attributes:
        holds: kind and name, as in ``package rover``.
        specification: digest of its canonical text.
        scalars: floating-point types of the C.
        options: what else decided about the files, where anything did.
    """

    holds: str
    specification: str
    scalars: tuple[str, ...]
    options: Mapping[str, object] = field(default_factory=dict)


def emit(origin: Origin, text: Mapping[str, str]) -> dict[str, str]:
    """Render the manifest of a package.

    Args:
        origin: what it is and was made from.
        text: every other file of the package by path.
    """
    content: dict[str, object] = {
        "generator": _GENERATOR,
        "holds": origin.holds,
        "specification": origin.specification,
        "scalars": list(origin.scalars),
        **({"options": dict(origin.options)} if origin.options else {}),
        "files": {path: _digest(text[path].encode()) for path in sorted(text)},
    }
    return {MANIFEST: json.dumps(content, indent=2) + "\n"}


def holds(package: Path) -> str:
    """What a folder holds by its manifest; empty where that does not say.

    Raises:
        InputError: when there is no manifest, or one that cannot be read.
    """
    return _read(package).holds


def listed(package: Path) -> tuple[str, ...]:
    """The files a package's manifest lists, itself included.

    None where there is no manifest or it cannot be read: then nobody knows what may be removed.
    """
    try:
        return (*_read(package).files, MANIFEST)
    except InputError:
        return ()


def results(package: Path) -> tuple[str, ...]:
    """The records of proofs a package holds, their list included."""
    try:
        return (*_read_results(package).files, RESULTS) if (package / RESULTS).is_file() else ()
    except InputError:
        return (RESULTS,)


def write_results(package: Path, text: Mapping[str, str]) -> None:
    """Write records of proofs and their list; remove records of earlier proofs.

    Args:
        package: what was proven; it holds a manifest.
        text: records by path.
    """
    for path in results(package):
        (package / path).unlink(missing_ok=True)
    for path, record in text.items():
        store(package / path, record.encode())
    content = {
        "proven": _digest((package / MANIFEST).read_bytes()),
        "files": {path: _digest(text[path].encode()) for path in sorted(text)},
    }
    store(package / RESULTS, f"{json.dumps(content, indent=2)}\n".encode())


def check(package: Path, spec_digest: str | None) -> CheckReport:
    """Compare a package with its manifest.

    Args:
        package: its directory.
        spec_digest: of the specification it should be made from, where that is known.

    Raises:
        InputError: when the directory holds no manifest, or one that cannot be read.
    """
    manifest = _read(package)
    proven = _read_results(package)
    differences = dict(_differences(package, {**manifest.files, **proven.files}))
    if differences:
        reasons = tuple(f"{path} was {what}" for path, what in differences.items())
        return CheckReport(State.HAND_EDITED, tuple(differences), reasons)
    reasons = tuple(_staleness(package, manifest, proven, spec_digest))
    return CheckReport(State.STALE if reasons else State.FRESH, (), reasons)


@dataclass(frozen=True, slots=True)
class _Manifest:
    """What a manifest says."""

    generator: str
    holds: str
    specification: str
    files: Mapping[str, str]


def _read(package: Path) -> _Manifest:
    path = package / MANIFEST
    if not path.is_file():
        raise InputError(f"{package} holds no {MANIFEST}; it is not a generated package")
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        files = {_inside(str(name)): str(digest) for name, digest in content["files"].items()}
        generator, specification = str(content["generator"]), str(content["specification"])
        return _Manifest(generator, str(content.get("holds", "")), specification, files)
    except (AttributeError, ValueError, KeyError, TypeError) as error:
        raise InputError(
            f"{path} cannot be read; write the package again with symnav generate --force"
        ) from error


@dataclass(frozen=True, slots=True)
class _Results:
    """What a list of results says; nothing where there is none."""

    proven: str
    files: Mapping[str, str]


def _read_results(package: Path) -> _Results:
    path = package / RESULTS
    if not path.is_file():
        return _Results("", {})
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        files = {_inside(str(name)): str(digest) for name, digest in content["files"].items()}
        return _Results(str(content["proven"]), files)
    except (AttributeError, ValueError, KeyError, TypeError) as error:
        raise InputError(f"{path} cannot be read; remove it, or prove the bundle again") from error


def _inside(name: str) -> str:
    """A path that stays inside the package: a manifest may come from anywhere.

    Raises:
        ValueError: for an absolute path or one with "..".
    """
    path = PurePosixPath(name)
    if path.is_absolute() or ".." in path.parts or "\\" in name:
        raise ValueError(name)
    return name


def _differences(package: Path, expected: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Paths and what happened to them: changed, removed or added."""
    for path, digest in expected.items():
        file = package / path
        if not file.is_file():
            yield path, "removed"
        elif _digest(file.read_bytes()) != digest:
            yield path, "changed"
    for file in sorted(package.rglob("*")):
        path = file.relative_to(package).as_posix()
        if file.is_file() and path not in expected and not _is_built(file.relative_to(package)):
            yield path, "added"


def _is_built(path: Path) -> bool:
    """True for what building and running leave behind, and for hidden files."""
    hidden = any(part.startswith(".") or part == "__pycache__" for part in path.parts)
    known = path.as_posix() in _BUILT or path.as_posix() == RESULTS
    return hidden or known or path.parts[0] == _BUILD_FOLDER or path.suffix in _BINARIES


def _staleness(
    package: Path, manifest: _Manifest, proven: _Results, spec_digest: str | None
) -> Iterator[str]:
    if spec_digest is not None and manifest.specification != spec_digest:
        yield "the specification changed since the package was generated"
    if manifest.generator != _GENERATOR:
        yield f"the package was generated by {manifest.generator}, this is {_GENERATOR}"
    if proven.proven and proven.proven != _digest((package / MANIFEST).read_bytes()):
        yield "the proofs were of other files: prove again"


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()
