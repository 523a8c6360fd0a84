"""Glue for frameworks: a few lines each that name the bundle's sources where they are."""

from __future__ import annotations

import json
from collections.abc import Mapping

from symnav import ir
from symnav.emit.templates import render
from symnav.export.building import build_files
from symnav.export.records import Bundle


def files(bundle: Bundle) -> Mapping[str, str]:
    """cFS, F Prime, Zephyr, ESP-IDF, PlatformIO and Arduino.

    Frameworks that take a module's name from its folder get a folder of that name.
    """
    name = bundle.name
    sources = build_files.sources(bundle)
    context = {
        "name": name,
        "macro": name.upper(),
        "version": build_files.version(),
        "summary": build_files.plain_summary(bundle),
        "quoted": json.dumps(build_files.plain_summary(bundle)),
        "generator": bundle.trees[0].module.generator,
        "zephyr": zephyr_option(bundle),
        "double": any(tree.module.scalar is ir.Scalar.DOUBLE for tree in bundle.trees),
        "arithmetic": build_files.ARITHMETIC,
        "headers": [f"{tree.prefix}/{tree.prefix}.h" for tree in bundle.trees],
        "up": [f"../../{path}" for path in sources],
        "beside": [f"../{path}" for path in sources],
        "absolute": [f'"${{bundle}}/{path}"' for path in sources],
    }
    templates = {
        f"cfs/{name}_lib/CMakeLists.txt": "cfs/CMakeLists.txt.j2",
        f"cfs/{name}_lib/{name}_lib.c": "cfs/lib.c.j2",
        "cfs/cfe_es_startup.scr": "cfs/cfe_es_startup.scr.j2",
        "fprime/library.cmake": "fprime/library.cmake.j2",
        f"fprime/{name}/CMakeLists.txt": "fprime/CMakeLists.txt.j2",
        "zephyr/module.yml": "zephyr/module.yml.j2",
        "zephyr/Kconfig": "zephyr/Kconfig.j2",
        "zephyr/CMakeLists.txt": "zephyr/CMakeLists.txt.j2",
        f"esp-idf/{name}/CMakeLists.txt": "esp-idf/CMakeLists.txt.j2",
        f"esp-idf/{name}/idf_component.yml": "esp-idf/idf_component.yml.j2",
        "library.properties": "library.properties.j2",
    }
    text = {path: render(f"export/glue/{each}", **context) for path, each in templates.items()}
    return text | {"library.json": _platformio(bundle)}


def zephyr_option(bundle: Bundle) -> str:
    """The Kconfig symbol that switches the library on."""
    return f"{bundle.name.upper()}_LIBRARY"


def _platformio(bundle: Bundle) -> str:
    """The manifest of PlatformIO.

    It names no licence: PlatformIO compares that with a list it fetches, and packing a library
    must not need a network.
    """
    content = {
        "name": bundle.name,
        "version": build_files.version(),
        "description": build_files.summary(bundle),
        "frameworks": "*",
        "platforms": "*",
        "headers": [f"{tree.prefix}/{tree.prefix}.h" for tree in bundle.trees],
        "build": {"srcDir": "src", "includeDir": "include", "flags": list(build_files.ARITHMETIC)},
    }
    return json.dumps(content, indent=2, ensure_ascii=False) + "\n"
