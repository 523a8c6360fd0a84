"""One file on its way to the disk: whole or not at all, and an error says which file it was."""

from __future__ import annotations

from pathlib import Path


def store(target: Path, content: bytes) -> None:
    """Write a file through a temporary name in its folder, which is made where it is missing.

    Raises:
        OSError: with the path of the file. A full disk is noticed while writing, where the system
            knows of no name; what was written of the file until then is removed.
    """
    target.parent.mkdir(parents=True, exist_ok=True)
    partial = target.with_name(f".{target.name}.partial")
    try:
        partial.write_bytes(content)
    except OSError as error:
        partial.unlink(missing_ok=True)
        raise OSError(error.errno, error.strerror, str(target)) from error
    partial.replace(target)
