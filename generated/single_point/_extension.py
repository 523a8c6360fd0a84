"""The extension module that ``symnav build`` makes from the C of this package.

The extension carries a name made from what it was compiled from; ``_build.json`` says which one
belongs to this package and lists the digest of every source, so that a module compiled from other
sources is refused.
"""

from __future__ import annotations

import hashlib
import json
import operator
import os
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from importlib.machinery import EXTENSION_SUFFIXES, ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_file_location
from itertools import pairwise
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from ._runtime import Array, Status

_BUILD = "_build.json"
_LEAST = 512  # epochs that are worth a thread
UNFIT = -1  # what straight ways answer where only the general way leads on


def load_extension(package: Path, key: str) -> ModuleType:
    """Imports the extension that ``_build.json`` names under ``key``.

    Raises:
        ImportError: when nothing was built, when the sources changed since, or when the extension
            does not belong to this interpreter; the message says what to run.
    """
    record = package / _BUILD
    command = f"symnav build {_shown(package)}"
    if not record.is_file():
        raise ImportError(
            f"{package.name}: not compiled yet; run: {command} (needs a C compiler: apt install "
            "gcc libc6-dev python3-dev, dnf install gcc python3-devel, xcode-select --install, or "
            "the Build Tools for Visual Studio)"
        )
    try:
        build = json.loads(record.read_text(encoding="utf-8"))
        sources, name = build["sources"], build[key]
    except (KeyError, TypeError, ValueError):
        raise ImportError(f"{package.name}: {_BUILD} cannot be read; run: {command}") from None
    changed = sorted(set(sources.items()) ^ set(_digests(package).items()))
    if changed:
        raise ImportError(
            f"{package.name}: sources changed since the build ({changed[0][0]}); run: {command}"
        )
    if not name:
        raise ImportError(f"{package.name}: no {key} extension was built; run: {command}")
    for suffix in EXTENSION_SUFFIXES:
        path = package / f"{name}{suffix}"
        if path.is_file():
            return _load(name, path)
    raise ImportError(f"{package.name}: {name} was built for another Python; run: {command}")


def _shown(package: Path) -> str:
    """The directory as one would type it."""
    here = Path.cwd()
    return str(package.relative_to(here) if package.is_relative_to(here) else package)


def _digests(package: Path) -> dict[str, str]:
    """Digests of the C as it is now."""
    return {
        path.relative_to(package).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for folder in ("c", "casadi", "straight")
        for path in (package / folder).rglob("*")
        if path.suffix in (".c", ".h")
    }


def _load(name: str, path: Path) -> ModuleType:
    spec = spec_from_file_location(name, path, loader=ExtensionFileLoader(name, str(path)))
    assert spec is not None and spec.loader is not None
    try:
        module = module_from_spec(spec)
    except ModuleNotFoundError as error:
        if error.name != "_cffi_backend":
            raise
        raise ImportError(
            "compiled back ends need the cffi runtime; run: python -m pip install cffi"
        ) from None
    spec.loader.exec_module(module)
    return module


class Library:
    """The functions of one extension, for one floating-point type."""

    def __init__(self, extension: ModuleType, prefix: str, real: str) -> None:
        self.ffi: Any = extension.ffi
        self.lib: Any = extension.lib
        self.prefix = prefix
        self.real = np.dtype(real)
        self.reals = self.ffi.typeof("double[]" if real == "float64" else "float[]")
        self.integers = self.ffi.typeof("int32_t[]")
        self.bytes = self.ffi.typeof("uint8_t[]")
        self._kinds = {"f": self.reals, "i": self.integers, "u": self.bytes}
        self._buffer = self.ffi.from_buffer
        self._has_straight = _reads_arrays(self.lib, prefix)
        self._pool: ThreadPoolExecutor | None = None
        self._process = os.getpid()
        self.threads = 1

    def entry(self, name: str) -> Callable[..., int]:
        """An entry point by its name without the prefix."""
        found: Callable[..., int] = getattr(self.lib, f"{self.prefix}_{name}")
        return found

    def straight(self, name: str) -> Callable[..., int]:
        """The straight way to an entry point; one that declines everything where there is none."""
        found: Callable[..., int] = _decline
        if self._has_straight:
            found = getattr(self.lib, f"straight_{self.prefix}_{name}", _decline)
        return found

    def call(self, name: str, result: type | None = None) -> Callable[..., Any]:
        """The call for one epoch: given arguments in order and ``out``, its result, or None.

        Args:
            name: of the function, or with a dot and a form behind it.
            result: type of the result; without it, the array or a tuple of arrays.
        """
        return self._opened(name, (np.ndarray, result, Status.OK, Status.PARTIAL)) or _decline_call

    def bound(
        self, name: str, memory: Sequence[Any], result: Any, otherwise: Callable[[int], Any]
    ) -> Callable[[], Any] | None:
        """A call for one epoch over the same arguments every time, where there is one.

        Args:
            name: of the function.
            memory: inputs, outputs and the statuses of items.
            result: what it returns when all went well.
            otherwise: called with the status when not.
        """
        return self._opened(f"{name}.bind", (np.ndarray, *memory, result, otherwise))

    def _opened(self, name: str, kept: tuple[Any, ...]) -> Callable[..., Any] | None:
        """A call of the extension that keeps something; nothing where it has none."""
        place: list[Any] = [kept]
        if not self._has_straight:
            return None
        opened = getattr(self.lib, f"straight_{self.prefix}__open")
        return place[0] if opened(id(place), name.encode()) else None

    def pointer(self, array: Array) -> Any:
        """The memory of a contiguous array, which stays alive with the pointer."""
        return self._buffer(self._kinds[array.dtype.kind], array)

    def set_threads(self, count: int) -> None:
        """Sets how many threads share the epochs of a batch; 1, the default, starts none.

        Results are the same bits for any number. Calls that are bound keep what was set before.
        """
        number = operator.index(count)
        if number < 1:
            raise ValueError(f"set_threads: count = {number}, expected 1 or more")
        if number != self.threads:
            # Nobody shuts the old pool down: another thread may be handing it work. Its threads
            # end when nothing holds it any more.
            self.threads = number
            self._pool = self._make_pool()

    def _make_pool(self) -> ThreadPoolExecutor | None:
        """Threads of this very process."""
        self._process = os.getpid()
        return ThreadPoolExecutor(self.threads) if self.threads > 1 else None

    def shares(self, parts: int, epochs: int = 1) -> list[tuple[int, int]]:
        """First part and number of parts of every thread; few epochs are not shared.

        Args:
            parts: what is shared out.
            epochs: how many epochs a part has.
        """
        if self.threads == 1:
            return [(0, parts)]
        count = min(self.threads, max(parts * epochs // _LEAST, 1))
        ends = [parts * share // count for share in range(count + 1)]
        return [(first, last - first) for first, last in pairwise(ends)]

    def run(self, calls: Sequence[Callable[[], Any]]) -> list[Any]:
        """Runs calls side by side; the C they call releases the interpreter.

        None of them runs any more afterwards, whatever one of them raised.
        """
        if self._process != os.getpid():  # a forked process inherits the pool, but no threads
            self._pool = self._make_pool()
        pool = self._pool
        if len(calls) == 1 or pool is None:
            return [call() for call in calls]
        started: list[Future[Any]] = []
        try:
            for call in calls:
                started.append(pool.submit(call))
            return [future.result() for future in started]
        finally:
            wait(started)


def _reads_arrays(lib: Any, prefix: str) -> bool:
    """True when C can read the arrays of this very NumPy at the addresses this Python gives.

    Without the interpreter's lock, others could change a list or an array while it is read.
    """
    layout = getattr(lib, f"straight_{prefix}__layout", None)
    locked = getattr(sys, "_is_gil_enabled", lambda: True)()
    if layout is None or sys.implementation.name != "cpython" or not locked:
        return False
    return bool(layout() == int(np.__version__.partition(".")[0]))


def _decline_call(*_given: Any) -> None:
    """What calls answer to arrays they cannot read."""


def _decline(*_given: Any) -> int:
    """What straight ways answer to arrays they cannot read."""
    return UNFIT
