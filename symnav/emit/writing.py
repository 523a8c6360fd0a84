"""The write stage: text to files, with the manifest that tells them from what others wrote."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from symnav.emit import manifest
from symnav.emit.storing import store
from symnav.errors import HandEditedError, InputError


def write(folder: Path, text: Mapping[str, str], origin: manifest.Origin) -> tuple[str, ...]:
    """Write files and their manifest; remove those an earlier generation wrote and this does not.

    Args:
        folder: what the paths are relative to.
        text: by path.
        origin: what the files are and were made from.

    Returns:
        Paths of what was new, different or removed; nothing was touched where there are none.
        Records of proofs go with what they were of.
    """
    complete = {**text, **manifest.emit(origin, text)}
    changed = [path for path, content in complete.items() if not _same(folder / path, content)]
    stale = [path for path in manifest.listed(folder) if path not in complete]
    if changed or stale:
        # What was proven of the files before is not known of these.
        stale += manifest.results(folder)
        _replace(folder, complete, stale)
    return tuple(sorted([*changed, *stale]))


def protect(folder: Path, holds: str) -> None:
    """Refuse to write over what somebody else wrote, or over another package or bundle.

    Args:
        folder: where to write.
        holds: what is going to be there.

    Raises:
        HandEditedError: when files there were changed by hand.
        InputError: when the folder holds files but no manifest, or something else.
    """
    if not folder.exists() or not any(folder.iterdir()):
        return
    if not (folder / manifest.MANIFEST).is_file():
        raise InputError(
            f"{folder}: holds files but was not generated; choose another folder, or use "
            "--force to write into it"
        )
    present = manifest.holds(folder)
    if present and present != holds:
        raise InputError(
            f"{folder}: holds the {present}; choose another folder for the {holds}, or use "
            "--force to replace what is there"
        )
    report = manifest.check(folder, None)
    if report.state == "hand-edited":
        raise HandEditedError(
            f"{folder}: changed by hand ({'; '.join(report.reasons[:3])}); keep a copy elsewhere, "
            "then use --force to write over it"
        )


def _same(path: Path, content: str) -> bool:
    return path.is_file() and path.read_bytes() == content.encode()


def _replace(folder: Path, complete: Mapping[str, str], stale: Sequence[str]) -> None:
    """Every file whole; the manifest last."""
    order = sorted(complete, key=lambda path: path == manifest.MANIFEST)
    for path in order:
        store(folder / path, complete[path].encode())
    for path in stale:
        (folder / path).unlink(missing_ok=True)
    for path in stale:
        _prune(folder, (folder / path).parent)


def _prune(folder: Path, emptied: Path) -> None:
    """Remove directories inside a folder that nothing is left in."""
    while emptied != folder and emptied.is_dir() and not any(emptied.iterdir()):
        emptied.rmdir()
        emptied = emptied.parent
