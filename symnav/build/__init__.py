"""Compile a generated package: its own C, and CasADi's where present, into importable extensions.

The extension is compiled from the very files that are exported for flight. Its foreign
declarations come from the exported headers as well: everything between the two interface marks of
a header is plain C that cffi reads as it stands, once comments are gone.

An extension is named after a digest of all it depends on (sources, flags, compiler, interpreter),
so that two builds never mix and a second build has nothing to do. A user cache keyed by that name
makes regenerating a package elsewhere as quick.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import cffi
from cffi.recompiler import make_c_source

from symnav.build.compiler import (
    ADVICE,
    DISPATCH_FLAG,
    FLAGS,
    LIGHT_FLAGS,
    NATIVE_FLAG,
    WINDOWS,
    WINDOWS_FLAGS,
    Compiler,
    dispatch_flags,
    find_compiler,
    flags_of,
    machine_macros,
    native_flags,
)
from symnav.build.straight import FOLDER, Straight, find_straight
from symnav.emit.caching import cache_directory
from symnav.errors import BuildError

__all__ = [
    "DISPATCH_FLAG",
    "FLAGS",
    "NATIVE_FLAG",
    "BuildResult",
    "Compiler",
    "build",
    "cache_directory",
    "compile_with_setuptools",
    "declarations",
    "dispatch_flags",
    "find_compiler",
]

Log = Callable[[str], None]

_BEGINS, _ENDS = "/* Interface begins. */", "/* Interface ends. */"
_SUFFIX = sysconfig.get_config_var("EXT_SUFFIX") or ".so"


@dataclass(frozen=True, slots=True)
class BuildResult:
    """What a build left behind.

    Attributes:
        package: the package directory.
        modules: path of each extension, by ``native`` and ``casadi``.
        compiled: the extensions that were compiled; the others were there or came from the cache.
    """

    package: Path
    modules: Mapping[str, Path]
    compiled: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Extension:
    """One extension to build: where its sources are and how they are seen by the compiler.

    ``straight`` is what else it holds: straight ways from NumPy's arrays into the sources.
    """

    key: str
    package: Path
    sources: tuple[Path, ...]
    headers: tuple[Path, ...]
    include: Path
    straight: Straight | None = None

    @property
    def preamble(self) -> str:
        names = [header.relative_to(self.include).as_posix() for header in self.headers]
        names += [header.name for header in self.straight.headers] if self.straight else []
        return "".join(f'#include "{name}"\n' for name in names)

    @property
    def declarations(self) -> str:
        headers = [*self.headers, *(self.straight.headers if self.straight else ())]
        return "\n".join(declarations(header.read_text(encoding="utf-8")) for header in headers)


def build(package: Path, *, native: bool = False, log: Log | None = None) -> BuildResult:
    """Compile the extensions of a generated package.

    Args:
        package: its directory, with ``c/`` and perhaps ``casadi/`` in it.
        native: compile for this very machine.
        log: called with every line worth telling.

    Returns:
        Where the extensions are and which of them were compiled now.

    Raises:
        BuildError: when there is no compiler or it refuses a file; the log is ``_build.log``.
    """
    package = Path(package).resolve()
    tell = log or (lambda line: None)
    extensions = list(_extensions(package))
    if not extensions:
        raise BuildError(f"{package} holds no C to compile; generate the package first")
    compiler = find_compiler()
    flags = [*(WINDOWS_FLAGS if WINDOWS else FLAGS)]
    flags += native_flags(compiler) if native else dispatch_flags(compiler)
    digests = {
        path.relative_to(package).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in _inputs(package)
    }
    modules: dict[str, Path] = {}
    compiled: list[str] = []
    for extension in extensions:
        name = _module_name(extension, digests, compiler, flags)
        modules[extension.key] = package / f"{name}{_SUFFIX}"
        if _provide(extension, name, compiler, flags, tell):
            compiled.append(extension.key)
    record = {
        "native": _stem(modules.get("native")),
        "casadi": _stem(modules.get("casadi")),
        "sources": digests,
        "compiler": compiler.identity,
        "flags": flags,
    }
    _replace(package / "_build.json", (json.dumps(record, indent=2) + "\n").encode())
    _remove_others(package, modules.values())
    return BuildResult(package, modules, tuple(compiled))


def declarations(header: str) -> str:
    """The part of a header that cffi reads: what it declares, and integer macros.

    Args:
        header: text of a generated header; the whole of it counts where it has no marks.
    """
    marked = [part.partition(_ENDS)[0] for part in header.split(_BEGINS)[1:]]
    text = re.sub(r"/\*.*?\*/", " ", "\n".join(marked) if marked else header, flags=re.DOTALL)
    text = re.sub(r"(?<=\[)\w+_RESTRICT\b", "", text)
    text = re.sub(r"\bstatic const (\w+ \w+\[\w+\]) = \{[^}]*\};", r"extern const \1;", text)
    lines = (line.rstrip() for line in text.splitlines())
    return "\n".join(line for line in lines if line.strip()) + "\n"


def _extensions(package: Path) -> Iterator[_Extension]:
    """The native extension holds the trees of both scalar types; CasADi's C stands apart."""
    own = sorted((package / "c" / "src").glob("*.c"))
    if own:
        include = package / "c" / "include"
        headers = sorted(include.glob("*/*.h"), key=lambda path: (path.parent, -len(path.name)))
        straight = find_straight(package)
        yield _Extension("native", package, tuple(own), tuple(headers), include, straight)
    casadi = package / "casadi"
    if foreign := sorted(casadi.glob("*.c")):
        yield _Extension(
            "casadi", package, tuple(foreign), tuple(sorted(casadi.glob("*.h"))), casadi
        )


def _inputs(package: Path) -> list[Path]:
    return sorted(
        path
        for folder in ("c", "casadi", FOLDER)
        for path in (package / folder).rglob("*")
        if path.suffix in (".c", ".h")
    )


def _module_name(
    extension: _Extension, digests: Mapping[str, str], compiler: Compiler, flags: Sequence[str]
) -> str:
    """``_<package>_<digest>``, or with ``_casadi`` in between."""
    own = extension.include.relative_to(extension.package).parts[0]
    folders = {own, FOLDER} if extension.straight else {own}
    basis = {
        "sources": {path: digests[path] for path in digests if path.partition("/")[0] in folders},
        "flags": [*flags, *LIGHT_FLAGS],
        "compiler": [compiler.identity, *compiler.command[1:]],
        "machine": machine_macros(compiler) if NATIVE_FLAG in flags else "",
        "abi": _SUFFIX,
        "cffi": cffi.__version__,
        "numpy": extension.straight.numpy if extension.straight else "",
    }
    digest = hashlib.sha256(json.dumps(basis, sort_keys=True).encode()).hexdigest()[:16]
    middle = "_casadi" if extension.key == "casadi" else ""
    return f"_{extension.package.name}{middle}_{digest}"


def _provide(
    extension: _Extension, name: str, compiler: Compiler, flags: Sequence[str], tell: Log
) -> bool:
    """Put an extension in place; True when it had to be compiled."""
    place = extension.package / f"{name}{_SUFFIX}"
    kept = cache_directory() / place.name
    if place.is_file():
        tell(f"{place.name} is up to date")
        return False
    if kept.is_file():
        _replace(place, kept.read_bytes())
        tell(f"{place.name} from the cache")
        return False
    tell(f"compiling {place.name} with {compiler.identity}")
    # Outside the package: a build that is killed leaves nothing in it.
    with tempfile.TemporaryDirectory(prefix="symnav-build-", ignore_cleanup_errors=True) as folder:
        content = _compile(extension, name, compiler, flags, Path(folder)).read_bytes()
    _replace(place, content)
    _keep(kept, content, tell)
    return True


def _keep(kept: Path, content: bytes, tell: Log) -> None:
    """A cache that cannot be written is no reason to fail."""
    try:
        kept.parent.mkdir(parents=True, exist_ok=True)
        _replace(kept, content)
    except OSError as error:
        tell(f"not cached: {error}")


def _compile(
    extension: _Extension, name: str, compiler: Compiler, flags: Sequence[str], folder: Path
) -> Path:
    """Compile an extension in a folder of its own."""
    wrapper = _declared(extension)
    if WINDOWS:
        return compile_with_setuptools(wrapper, name, extension.preamble, extension, flags, folder)
    python = Path(sysconfig.get_path("include"))
    if not (python / "Python.h").is_file():
        raise BuildError(f"the headers of Python are missing ({python}); {ADVICE}")
    wrapper_source = folder / f"{name}.c"
    make_c_source(wrapper, name, extension.preamble, str(wrapper_source))
    include = f"-I{extension.include}"
    position = ["-fPIC", "-fvisibility=hidden"]
    pythons = [f"-I{python}", f"-I{sysconfig.get_path('platinclude')}"]
    jobs = [([*compiler.command, "-O1", *position, include, *pythons], wrapper_source)]
    if extension.straight:
        places = [f"-I{place}" for place in extension.straight.include]
        lightly = [*compiler.command, "-O2", *position, include, *places, *pythons]
        jobs[0][0].extend(places[:1])
        jobs += [(lightly, source) for source in extension.straight.sources]
    for source in sorted(extension.sources, key=lambda path: -path.stat().st_size):
        jobs.append(([*compiler.command, *flags_of(source, flags), *position, include], source))
    objects = _run_jobs(jobs, folder, extension.package)
    made = folder / f"{name}{_SUFFIX}"
    shared = (
        ["-bundle", "-undefined", "dynamic_lookup"] if sys.platform == "darwin" else ["-shared"]
    )
    _run(
        [*compiler.command, *shared, "-o", str(made), *map(str, objects), "-lm"], extension.package
    )
    return made


def _declared(extension: _Extension) -> cffi.FFI:
    """The declarations of the headers, as cffi reads them."""
    wrapper = cffi.FFI()
    try:
        wrapper.cdef(extension.declarations)
    except (cffi.CDefError, cffi.FFIError) as error:
        log = extension.package / "_build.log"
        log.write_text(f"{error}\n\n{extension.declarations}", encoding="utf-8")
        first = str(error).partition("\n")[0]
        raise BuildError(
            f"cffi cannot read the declarations of {extension.include}: {first}; generate the "
            f"package again, under other names where one clashes; all that was read is in {log}"
        ) from error
    return wrapper


def compile_with_setuptools(
    wrapper: cffi.FFI,
    name: str,
    preamble: str,
    extension: _Extension,
    flags: Sequence[str],
    folder: Path,
) -> Path:
    """Compile an extension through setuptools, which knows where Visual Studio keeps itself."""
    from setuptools.errors import CCompilerError, PlatformError

    straight = extension.straight
    wrapper.set_source(
        name,
        preamble,
        sources=[str(p) for p in (*extension.sources, *(straight.sources if straight else ()))],
        include_dirs=[str(extension.include), *(map(str, straight.include) if straight else ())],
        extra_compile_args=list(flags),
    )
    try:
        return Path(wrapper.compile(tmpdir=str(folder)))
    except (CCompilerError, PlatformError, cffi.VerificationError) as error:
        raise _refusal(extension.package, str(error)) from error


def _run_jobs(
    jobs: Sequence[tuple[Sequence[str], Path]], folder: Path, package: Path
) -> list[Path]:
    """Compile every file, as many at a time as there are processors."""
    objects = [folder / f"{source.stem}.o" for _, source in jobs]
    commands = [
        [*command, "-c", str(source), "-o", str(place)]
        for (command, source), place in zip(jobs, objects, strict=True)
    ]
    with ThreadPoolExecutor(os.cpu_count() or 1) as workers:
        list(workers.map(lambda command: _run(command, package), commands))
    return objects


def _run(command: Sequence[str], package: Path) -> None:
    done = subprocess.run(
        command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL
    )
    if done.returncode != 0:
        raise _refusal(package, f"{shlex.join(command)}\n{done.stdout}{done.stderr}")


def _refusal(package: Path, output: str) -> BuildError:
    """The error for a compiler that refused something; its whole output goes to the log."""
    log = package / "_build.log"
    log.write_text(output, encoding="utf-8")
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    telling = next((line for line in lines if re.search(r"\berror\b", line)), lines[-1])
    return BuildError(f"the C compiler refused: {telling}; its whole output is in {log}")


def _replace(place: Path, content: bytes) -> None:
    """Write a file so that nobody ever sees half of it."""
    handle, temporary = tempfile.mkstemp(prefix=".build-", dir=place.parent)
    with os.fdopen(handle, "wb") as file:
        file.write(content)
    os.chmod(temporary, 0o644)
    os.replace(temporary, place)


def _remove_others(package: Path, modules: Iterable[Path]) -> None:
    """Earlier extensions for this interpreter; one that is loaded elsewhere may stay on Windows."""
    current = set(modules)
    pattern = re.compile(rf"_{re.escape(package.name)}(_casadi)?_[0-9a-f]{{16}}")
    for path in package.glob(f"_{package.name}_*{_SUFFIX}"):
        if path not in current and pattern.fullmatch(path.name.removesuffix(_SUFFIX)):
            try:
                path.unlink()
            except PermissionError:
                continue


def _stem(path: Path | None) -> str | None:
    return path.name.removesuffix(_SUFFIX) if path else None
