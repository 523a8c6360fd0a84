"""What builds a bundle: Makefile, CMake package, pkg-config, and headers that name its versions."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping

from symnav import __version__
from symnav.emit.c.border import SUFFIX as BORDER
from symnav.emit.templates import render
from symnav.export.records import Bundle, Tree

ARITHMETIC = ("-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off")
"""Flags that decide how the compiler may treat floating-point operations."""

FLAGS = ("-std=c99", "-O2", *ARITHMETIC)
"""What the Makefile compiles with unless told otherwise."""

WARNINGS = (
    *("-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Wsign-conversion"),
    *("-Wfloat-conversion", "-Wdouble-promotion", "-Wstrict-prototypes", "-Wmissing-prototypes"),
    *("-Wundef", "-Wcast-qual", "-Wcast-align", "-Wwrite-strings", "-Wvla", "-Werror"),
)
"""What ``make check`` adds."""

# Targets that CMake makes itself.
_TAKEN = frozenset(
    (
        *("all", "clean", "depend", "edit_cache", "help", "install", "package", "package_source"),
        *("rebuild_cache", "test"),
    )
)


def files(bundle: Bundle) -> Mapping[str, str]:
    """Build files at the top of the bundle and one more header beside those of every tree."""
    name, library = bundle.name, library_name(bundle)
    context = {
        "name": name,
        "library": library,
        "macro": name.upper(),
        "version": version(),
        "trees": [
            {"prefix": tree.prefix, "headers": public_headers(tree)} for tree in bundle.trees
        ],
        "headers": sorted(
            {path for tree in bundle.trees for path in (*tree.files, version_header(tree))}
            - set(sources(bundle))
        ),
        "sources": sources(bundle),
        "flags": " ".join(FLAGS),
        "arithmetic": ARITHMETIC,
        "warnings": " ".join(WARNINGS),
        "description": plain_summary(bundle),
    }
    templates = {
        "Makefile": "Makefile.j2",
        "CMakeLists.txt": "CMakeLists.txt.j2",
        f"cmake/{name}Config.cmake.in": "cmake/Config.cmake.in.j2",
        f"{name}.pc.in": "pc.in.j2",
    }
    text = {path: render(f"export/build/{each}", **context) for path, each in templates.items()}
    return text | {version_header(tree): _version_header(tree) for tree in bundle.trees}


def library_name(bundle: Bundle) -> str:
    """Name of the library and of its CMake target; another than the bundle's where CMake has it."""
    return f"{bundle.name}_lib" if bundle.name in _TAKEN else bundle.name


def version() -> str:
    """Version of the library: that of its generator, in three numbers."""
    return ".".join([*__version__.split("+")[0].split("."), "0", "0"][:3])


def summary(bundle: Bundle) -> str:
    """One line that says what the library is."""
    described = str(json.loads(bundle.spec.text)["description"]).strip().rstrip(".")
    return " ".join(described.split()) or f"Navigation equations of {bundle.spec.name}"


def plain_summary(bundle: Bundle) -> str:
    """The same line for build files, in whose languages quotes and dollars have a meaning."""
    return " ".join(re.sub(r"[^A-Za-z0-9 ,.;:()/+-]", " ", summary(bundle)).split())


def sources(bundle: Bundle) -> tuple[str, ...]:
    """Paths of all translation units."""
    return tuple(path for tree in bundle.trees for path in tree.sources)


def public_headers(tree: Tree) -> tuple[str, ...]:
    """Paths of what a user of a tree includes."""
    return tuple(sorted({*tree.headers, version_header(tree)}))


def version_header(tree: Tree) -> str:
    """Path of the header that names versions and digests."""
    return f"include/{tree.prefix}/{tree.prefix}_version.h"


def model_digest(tree: Tree, function: str) -> str:
    """SHA-256 of a function's kernel, its banner left out because that names the package.

    ``sed -n '/^#ifndef/,$p' FILE | sha256sum`` gives the same.
    """
    text = tree.files[kernel_path(tree, function)]
    return hashlib.sha256(text[text.index("#ifndef") :].encode()).hexdigest()


def kernel_path(tree: Tree, function: str) -> str:
    """Path of the file that holds a function's kernel."""
    return f"src/{tree.prefix}_{function}_kernel.h"


def border_path(tree: Tree, function: str) -> str:
    """Path of the file that checks a function's inputs, where they are checked on their own."""
    return f"src/{tree.prefix}_{function}{BORDER}.c"


def _version_header(tree: Tree) -> str:
    module = tree.module
    return render(
        "export/build/version.h.j2",
        prefix=tree.prefix,
        macro=tree.prefix.upper(),
        generator=module.generator,
        version=version(),
        parts=version().split("."),
        layout=module.state.digest,
        specification=module.digest,
        functions=[
            {"symbol": f"{tree.prefix}_{f.name}", "digest": model_digest(tree, f.name)}
            for f in module.functions
        ],
    )
