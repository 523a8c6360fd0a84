"""Glue builds where functions of the frameworks' names are there; no framework is run.

The stand-ins do what the frameworks' functions do with their arguments, as far as paths and names
go: they make static libraries. So this shows that the glue finds the sources and headers, and
nothing about the frameworks.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from symnav.export.building import build_files
from symnav.export.documents import pages
from tests.export.bundles import QUICK, bundle_of, cases, records_of, run

pytestmark = pytest.mark.skipif(shutil.which("cmake") is None, reason="needs cmake")

HEAD = """\
cmake_minimum_required(VERSION 3.16)
project(stand_in LANGUAGES C)
"""
TAIL = """
add_executable(consumer main.c)
target_link_libraries(consumer PRIVATE {library} m)
"""

CFS = """
function(add_cfe_app name)
  add_library(${name} STATIC ${ARGN})
endfunction()
include_directories(cfe)
add_subdirectory(${CMAKE_CURRENT_SOURCE_DIR}/libs/bundle/cfs/@NAME@_lib)
"""
CFE_H = "#include <stdint.h>\ntypedef int32_t int32;\n#define CFE_SUCCESS ((int32)0)\n"

FPRIME_OLD = """
function(register_fprime_module)
  if(NOT DEFINED SOURCE_FILES)
    message(FATAL_ERROR "SOURCE_FILES")
  endif()
  add_library(${ARGV0} STATIC ${SOURCE_FILES})
endfunction()
"""
FPRIME_NEW = """
function(register_fprime_module)
  cmake_parse_arguments(PARSE_ARGV 1 given "" "" "SOURCES;DEPENDS")
  add_library(${ARGV0} STATIC ${given_SOURCES})
endfunction()
"""
FPRIME = """
function(add_fprime_subdirectory folder)
  get_filename_component(last "${folder}" NAME)
  add_subdirectory("${folder}" "${last}")
endfunction()
include(libs/bundle/fprime/library.cmake)
"""

ZEPHYR = """
macro(zephyr_library_named name)
  set(ZEPHYR_CURRENT_LIBRARY ${name})
  add_library(${name} STATIC)
endmacro()
function(zephyr_include_directories)
  foreach(folder ${ARGN})
    get_filename_component(whole ${folder} ABSOLUTE)
    include_directories(${whole})
    set_property(GLOBAL APPEND PROPERTY zephyr_folders ${whole})
  endforeach()
endfunction()
function(zephyr_library_compile_options)
  target_compile_options(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()
function(zephyr_library_sources)
  foreach(source ${ARGN})
    get_filename_component(whole ${source} ABSOLUTE)
    target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${whole})
  endforeach()
endfunction()
set(CONFIG_OPTION y)
add_subdirectory(libs/bundle/zephyr)
get_property(folders GLOBAL PROPERTY zephyr_folders)
include_directories(${folders})
"""

ESP_IDF = """
macro(idf_component_register)
  cmake_parse_arguments(given "" "" "SRCS;INCLUDE_DIRS" ${ARGN})
  get_filename_component(COMPONENT_LIB ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  add_library(${COMPONENT_LIB} STATIC ${given_SRCS})
  target_include_directories(${COMPONENT_LIB} PUBLIC ${given_INCLUDE_DIRS})
endmacro()
add_subdirectory(libs/bundle/esp-idf/@NAME@)
"""

FRAMEWORKS = {
    "cfs": CFS,
    "fprime-3": FPRIME_OLD + FPRIME,
    "fprime-4": FPRIME_NEW + FPRIME,
    "zephyr": ZEPHYR,
    "esp-idf": ESP_IDF,
}


@pytest.mark.parametrize("framework", FRAMEWORKS)
@pytest.mark.parametrize(("model", "scalar"), cases(QUICK[1:], ()))
def test_glue_builds(model: str, scalar: str, framework: str, tmp_path: Path) -> None:
    name = records_of(model, scalar).name
    bundle = shutil.copytree(bundle_of(model, scalar), tmp_path / "libs/bundle")
    shutil.copy(bundle / pages.EXAMPLE, tmp_path / "main.c")
    (tmp_path / "cfe").mkdir()
    (tmp_path / "cfe/cfe.h").write_text(CFE_H)
    (option,) = re.findall(r"^config (\w+)$", (bundle / "zephyr/Kconfig").read_text(), re.MULTILINE)
    glue = (
        FRAMEWORKS[framework].replace("@NAME@", name).replace("CONFIG_OPTION", f"CONFIG_{option}")
    )
    library = f"{name}_lib" if framework == "cfs" else name
    (tmp_path / "CMakeLists.txt").write_text(HEAD + glue + TAIL.format(library=library))
    run(["cmake", "-S", ".", "-B", "out"], tmp_path)
    run(["cmake", "--build", "out", "-j2"], tmp_path)
    assert "value[0] = " in run(["out/consumer"], tmp_path)
    compiled = {path.name for path in (tmp_path / "out").rglob("*.o")}
    expected = {Path(path).name + ".o" for path in build_files.sources(records_of(model, scalar))}
    assert expected <= compiled


@pytest.mark.parametrize(("model", "scalar"), cases(QUICK[1:], ()))
def test_cfs_start_up_line_names_a_symbol(model: str, scalar: str, tmp_path: Path) -> None:
    bundle, name = bundle_of(model, scalar), records_of(model, scalar).name
    kind, module, symbol, *_ = (bundle / "cfs/cfe_es_startup.scr").read_text().split(", ")
    assert (kind, module) == ("CFE_LIB", f"{name}_lib")
    (tmp_path / "cfe.h").write_text(CFE_H)
    strict = ["-std=c99", *build_files.WARNINGS, f"-I{tmp_path}"]
    source = bundle / f"cfs/{name}_lib/{name}_lib.c"
    run(["gcc", *strict, "-c", source, "-o", "lib.o"], tmp_path)
    assert f" T {symbol}\n" in run(["nm", "lib.o"], tmp_path)


@pytest.mark.parametrize(("model", "scalar"), cases(QUICK[1:], ()))
def test_manifests_of_frameworks(model: str, scalar: str) -> None:
    bundle, record = bundle_of(model, scalar), records_of(model, scalar)
    platformio = json.loads((bundle / "library.json").read_text())
    assert platformio["name"] == record.name and platformio["version"] == build_files.version()
    for key in ("srcDir", "includeDir"):
        assert (bundle / platformio["build"][key]).is_dir()
    for header in platformio["headers"]:
        assert (bundle / "include" / header).is_file()
    module = (bundle / "zephyr/module.yml").read_text()
    for path in (module.split("cmake: ")[1].split()[0] + "/CMakeLists.txt", "zephyr/Kconfig"):
        assert (bundle / path).is_file()
    component = (bundle / f"esp-idf/{record.name}/idf_component.yml").read_text()
    assert f'version: "{build_files.version()}"' in component


@pytest.mark.parametrize(("model", "scalar"), cases(QUICK[1:], ()))
def test_arduino_layout(model: str, scalar: str, tmp_path: Path) -> None:
    """Only ``src`` of the library is on the include path, and everything below it is compiled."""
    name = records_of(model, scalar).name
    bundle = shutil.copytree(bundle_of(model, scalar), tmp_path / "bundle")
    run(["make", "-s", "arduino"], bundle)
    library = bundle / f"build/arduino/{name}"
    properties = dict(
        line.split("=", 1) for line in (library / "library.properties").read_text().splitlines()
    )
    assert properties["name"] == name and properties["version"] == build_files.version()
    assert all((library / "src" / one).is_file() for one in properties["includes"].split(","))
    sources = sorted((library / "src").rglob("*.c"))
    example = bundle / pages.EXAMPLE
    run(["gcc", "-std=c99", "-I", library / "src", example, *sources, "-lm", "-o", "x"], tmp_path)
    assert "value[0] = " in run(["./x"], tmp_path)


@pytest.mark.parametrize(("model", "scalar"), cases(QUICK[1:], ()))
def test_glue_copies_no_source(model: str, scalar: str) -> None:
    """Five to ten lines each, apart from the list of sources."""
    bundle, name = bundle_of(model, scalar), records_of(model, scalar).name
    for folder in ("cfs", "fprime", "zephyr", "esp-idf"):
        for path in (bundle / folder).rglob("*"):
            if path.is_file():
                lines = path.read_text().splitlines()
                own = [line for line in lines if "/src/" not in line]
                assert len(own) <= 10, path
                assert path.suffix != ".c" or path.name == f"{name}_lib.c"
