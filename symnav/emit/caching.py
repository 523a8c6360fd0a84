"""Where what takes time to make is kept between runs; all of it can be made again."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

import jinja2
from jinja2.bccache import Bucket


def cache_directory() -> Path:
    """``SYMNAV_CACHE_DIR``, or ``~/.cache/symnav``."""
    chosen = os.environ.get("SYMNAV_CACHE_DIR")
    return Path(chosen) if chosen else Path.home() / ".cache" / "symnav"


class CompiledTemplates(jinja2.BytecodeCache):
    """Templates as Jinja has compiled them, which takes a tenth of a generation.

    Jinja compares a digest of the template, so that a change of one is never missed. A folder
    that cannot be written is no reason to fail.
    """

    def load_bytecode(self, bucket: Bucket) -> None:
        """Read what an earlier run has written."""
        with contextlib.suppress(OSError), self._file(bucket).open("rb") as file:
            bucket.load_bytecode(file)

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Write for later runs, so that nobody ever reads half of it."""
        place = self._file(bucket)
        partial = place.with_name(f"{place.name}.{os.getpid()}")
        with contextlib.suppress(OSError):
            place.parent.mkdir(parents=True, exist_ok=True)
            with partial.open("wb") as file:
                bucket.write_bytecode(file)
            partial.replace(place)

    @staticmethod
    def _file(bucket: Bucket) -> Path:
        return cache_directory() / "templates" / f"{bucket.key}.jinja"
