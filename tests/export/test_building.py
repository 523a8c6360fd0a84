"""A new user follows the README of a bundle: builds, checks, links it, from C, CMake and C++."""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from symnav.export.building import build_files
from symnav.export.documents import pages
from symnav.export.runners.emulation import missing
from tests.export.bundles import QUICK, bundle_of, cases, files, records_of, run

FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)

needs_make = pytest.mark.skipif(shutil.which("make") is None, reason="needs make")
needs_cmake = pytest.mark.skipif(shutil.which("cmake") is None, reason="needs cmake")
needs_pkg_config = pytest.mark.skipif(shutil.which("pkg-config") is None, reason="needs pkg-config")
pytestmark = pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")

ONE = QUICK[:1]
COMPILERS = {"clang": ("clang", "clang-19", "clang-14"), "tcc": ("tcc",), "g++": ("g++",)}
FLAGS = {
    "tcc": ("CFLAGS=-std=c99", "WARNINGS=-Wall -Werror"),
    "g++": ("CFLAGS=-std=c++17 -O2 -ffp-contract=off",),
}
CLANGS = ("clang", "clang-19")
X86 = platform.machine() == "x86_64"
WIDE = ("-march=x86-64-v3", "-march=x86-64-v4") if X86 else ("-march=native",)
"""Not the processor at hand: of features that a hypervisor left out of it, clang warns as well."""
ON_TARGET = ("check-m4", "build/m4")
"""What in a command says that it is for the emulated processor."""

CONSUMER = """\
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES {language})
{find}
add_executable(consumer {source})
target_link_libraries(consumer PRIVATE {name}::{name})
"""


@pytest.fixture
def bundle(model: str, scalar: str, tmp_path: Path) -> Path:
    """A copy that may be built in."""
    return Path(shutil.copytree(bundle_of(model, scalar), tmp_path / "bundle"))


def fences(folder: Path, language: str) -> list[str]:
    text = (folder / "README.md").read_text()
    return [body for found, body in FENCE.findall(text) if found == language]


def values(output: str) -> list[float]:
    """The numbers the example prints, each finite."""
    found = [float(text) for text in re.findall(r"^value\[\d+\] = (\S+)$", output, re.MULTILINE)]
    assert found and all(abs(value) < 1e12 for value in found), output
    return found


@needs_make
@pytest.mark.parametrize(("model", "scalar"), cases())
def test_commands_of_the_readme(model: str, scalar: str, bundle: Path) -> None:
    before = files(bundle)
    output = ""
    for block in fences(bundle, "console"):
        for line in block.splitlines():
            if missing() and any(word in line for word in ON_TARGET):
                continue  # tests of targets name what is not installed
            output += run(["sh", "-c", line.removeprefix("$ ")], bundle)
    assert "sources without a warning" in output
    assert any(values(output))
    assert values(output) == values(run(["make", "-s", "example"], bundle))
    run(["make", "clean"], bundle)
    assert files(bundle) == before


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_program_of_the_readme(model: str, scalar: str, bundle: Path) -> None:
    (program,) = fences(bundle, "c")
    assert program == (bundle / pages.EXAMPLE).read_text()
    assert len(program.splitlines()) < 60
    strict = build_files.WARNINGS
    run(["gcc", "-std=c99", *strict, "-Iinclude", "-c", "example/example.c", "-o", "x.o"], bundle)
    program = re.sub(r"(DIGEST != 0x)(.)", lambda m: m[1] + ("0" if m[2] != "0" else "1"), program)
    (bundle / "moved.c").write_text(program)
    refused = subprocess.run(
        ["gcc", "-std=c99", "-Iinclude", "-fsyntax-only", "moved.c"],
        cwd=bundle,
        capture_output=True,
        text=True,
        check=False,
    )
    assert refused.returncode != 0 and "state layout" in refused.stderr


@needs_make
@pytest.mark.parametrize(("model", "scalar"), cases(ONE))
@pytest.mark.parametrize("compiler", COMPILERS)
def test_other_compilers(model: str, scalar: str, compiler: str, bundle: Path) -> None:
    found = next(filter(None, map(shutil.which, COMPILERS[compiler])), None)
    if found is None:
        pytest.skip(f"needs {compiler}")
    usual = values(run(["make", "-s", "example"], bundle))
    run(["make", "clean"], bundle)
    known = FLAGS.get(compiler, ())
    run(["make", "-s", "check", f"CC={found}", *known], bundle)
    other = values(run(["make", "-s", "example", f"CC={found}", *known], bundle))
    assert other == pytest.approx(usual, rel=1e-6 if scalar == "float" else 1e-14)


@pytest.mark.parametrize("compiler", CLANGS)
@pytest.mark.parametrize(("model", "scalar"), cases())
def test_clang_says_nothing(model: str, scalar: str, compiler: str, bundle: Path) -> None:
    """Outside the Makefile as well, and of loops it does not vectorise, whatever the processor."""
    if shutil.which(compiler) is None:
        pytest.skip(f"needs {compiler}")
    warnings = ["-Wall", "-Wextra", "-Wpass-failed", "-Werror"]
    sources = sorted(f"src/{path.name}" for path in (bundle / "src").glob("*.c"))
    wide = [("-O3", processor) for processor in WIDE]
    for flags in (("-O2",), *wide, ("-O2", *build_files.ARITHMETIC)):
        run([compiler, "-std=c99", *flags, *warnings, "-Iinclude", "-c", *sources], bundle)


@needs_make
@pytest.mark.parametrize(("model", "scalar"), cases(ONE, ()))
def test_built_elsewhere(model: str, scalar: str, bundle: Path, tmp_path: Path) -> None:
    """As a build directory of a larger project: by its whole path, with nothing left here."""
    before = files(bundle)
    where = f"BUILD={tmp_path / 'elsewhere'}"
    assert "without a warning" in run(["make", "-s", "check", where], bundle)
    assert any(values(run(["make", "-s", "example", where], bundle)))
    assert files(bundle) == before


@needs_make
@pytest.mark.parametrize(("model", "scalar"), cases(ONE, ()))
def test_a_warning_fails_the_check(model: str, scalar: str, bundle: Path) -> None:
    source = sorted((bundle / "src").glob("*.c"))[0]
    source.write_text(source.read_text() + "\nstatic int unused;\n")
    words = ["make", "-s", "check"]
    done = subprocess.run(words, cwd=bundle, capture_output=True, text=True, check=False)
    assert done.returncode != 0 and "unused" in done.stderr
    run(["make", "-s"], bundle)  # which a user's build is not stopped by


@needs_make
@pytest.mark.parametrize(("model", "scalar"), cases(ONE, ()))
def test_another_compiler_or_other_flags_make_everything_again(
    model: str, scalar: str, bundle: Path
) -> None:
    """What an earlier compiler left is neither tested nor kept."""
    last = run(["make", "-s", "check"], bundle).splitlines()[-1]
    assert last.endswith("1 test programs passed with cc")
    assert "-c" not in run(["make", "check"], bundle).split()
    optimised = run(["make", "check", "CFLAGS=-std=c99 -O1 -DTEXT='a b'"], bundle).split()
    sources = len(build_files.sources(records_of(model, scalar)))
    assert optimised.count("-c") == sources
    words = ["make", "-s", "check", "CC=no-such-compiler"]
    done = subprocess.run(words, cwd=bundle, capture_output=True, text=True, check=False)
    assert done.returncode != 0 and "passed" not in done.stdout
    run(["make", "-s"], bundle)
    words = ["make", "-s", "AR=no-such-archiver"]
    assert subprocess.run(words, cwd=bundle, capture_output=True, check=False).returncode != 0
    assert run(["make"], bundle).split().count("-c") == sources
    assert "Nothing to be done" in run(["make"], bundle)


@needs_make
@pytest.mark.parametrize(("model", "scalar"), cases(ONE, ()))
def test_a_failed_test_program_fails_the_check(model: str, scalar: str, bundle: Path) -> None:
    (bundle / "test").mkdir(exist_ok=True)
    for code in (0, 1):  # whatever the program after it says
        for name, result in (("test_0", code), ("test_z", 0)):
            program = f"int main(void);\nint main(void)\n{{\n    return {result};\n}}\n"
            (bundle / f"test/{name}.c").write_text(program)
        words = ["make", "-s", "check"]
        done = subprocess.run(words, cwd=bundle, capture_output=True, text=True, check=False)
        assert (done.returncode != 0) == bool(code)
        assert ("passed" in done.stdout) != bool(code)


@pytest.mark.parametrize(("model", "scalar"), cases(ONE))
def test_headers_and_sources_are_cpp_as_well(model: str, scalar: str, bundle: Path) -> None:
    if shutil.which("g++") is None:
        pytest.skip("needs g++")
    objects = []
    for source in build_files.sources(records_of(model, scalar)):
        objects.append(Path(source).with_suffix(".o").name)
        flags = ["-std=c++17", "-Wall", "-Wextra", "-Werror", "-Iinclude", "-x", "c++"]
        run(["g++", *flags, "-c", source, "-o", objects[-1]], bundle)
    headers = [h for t in records_of(model, scalar).trees for h in build_files.public_headers(t)]
    including = "".join(f'#include "{path.removeprefix("include/")}"\n' for path in headers)
    (bundle / "all.cpp").write_text(f"{including}int main() {{ return 0; }}\n")
    run(["g++", "-std=c++17", "-Wall", "-Werror", "-Iinclude", "all.cpp", "-o", "all"], bundle)


@needs_cmake
@pytest.mark.parametrize(("model", "scalar"), cases(ONE, QUICK))
@pytest.mark.parametrize("language", ["C", "CXX"])
def test_add_subdirectory(
    model: str, scalar: str, language: str, bundle: Path, tmp_path: Path
) -> None:
    name, source = records_of(model, scalar).name, "main.c" if language == "C" else "main.cpp"
    (tmp_path / source).write_text((bundle / pages.EXAMPLE).read_text())
    languages = "C" if language == "C" else "C CXX"
    text = CONSUMER.format(
        language=languages, find="add_subdirectory(bundle)", source=source, name=name
    )
    (tmp_path / "CMakeLists.txt").write_text(text)
    run(["cmake", "-S", ".", "-B", "out"], tmp_path)
    run(["cmake", "--build", "out", "-j2"], tmp_path)
    assert any(values(run(["out/consumer"], tmp_path)))
    run(["cmake", "--install", "out", "--prefix", "away"], tmp_path)
    assert not (tmp_path / "away").exists()  # a consumer installs what it wants itself


@needs_cmake
@pytest.mark.parametrize(("model", "scalar"), cases(ONE, QUICK))
def test_find_package_and_ctest(model: str, scalar: str, bundle: Path, tmp_path: Path) -> None:
    name = records_of(model, scalar).name
    (bundle / "test").mkdir(exist_ok=True)
    (bundle / "test/test_mine.c").write_text("int main(void) { return 0; }\n")
    run(["cmake", "-S", ".", "-B", "build"], bundle)
    run(["cmake", "--build", "build", "-j2"], bundle)
    told = run(["ctest", "--test-dir", "build"], bundle)
    assert "test_mine" in told and "100% tests passed" in told
    run(["cmake", "--install", "build", "--prefix", tmp_path / "prefix"], bundle)
    shutil.copy(bundle / pages.EXAMPLE, tmp_path / "main.c")
    shutil.rmtree(bundle)  # what was installed stands on its own
    find = f"find_package({name} {build_files.version()} REQUIRED)"
    text = CONSUMER.format(language="C", find=find, source="main.c", name=name)
    (tmp_path / "CMakeLists.txt").write_text(text)
    run(["cmake", "-S", ".", "-B", "out", f"-DCMAKE_PREFIX_PATH={tmp_path / 'prefix'}"], tmp_path)
    run(["cmake", "--build", "out"], tmp_path)
    assert any(values(run(["out/consumer"], tmp_path)))
    if shutil.which("pkg-config"):
        assert any(values(by_pkg_config(name, tmp_path)))


def by_pkg_config(name: str, folder: Path) -> str:
    """Output of the example built with what pkg-config says."""
    (where,) = (folder / "prefix").rglob("pkgconfig")
    search = {"PKG_CONFIG_PATH": str(where)}
    flags = run(["pkg-config", "--cflags", "--libs", name], folder, search).split()
    assert (
        run(["pkg-config", "--modversion", name], folder, search).strip() == build_files.version()
    )
    run(["gcc", "-std=c99", "main.c", *flags, "-o", "by_pkg_config"], folder)
    return run(["./by_pkg_config"], folder)


@needs_make
@needs_pkg_config
@pytest.mark.parametrize(("model", "scalar"), cases(ONE, QUICK))
def test_make_install_and_pkg_config(model: str, scalar: str, bundle: Path, tmp_path: Path) -> None:
    run(["make", "-s", "install", f"PREFIX={tmp_path / 'prefix'}"], bundle)
    shutil.copy(bundle / pages.EXAMPLE, tmp_path / "main.c")
    shutil.rmtree(bundle)
    assert any(values(by_pkg_config(records_of(model, scalar).name, tmp_path)))


@pytest.mark.parametrize(("model", "scalar"), cases())
def test_digests_of_the_version_header(model: str, scalar: str, bundle: Path) -> None:
    """The shell line of the comment, and the macros as the preprocessor sees them."""
    record = records_of(model, scalar)
    for tree in record.trees:
        macros = run(["gcc", "-dM", "-E", "-Iinclude", build_files.version_header(tree)], bundle)
        (specification,) = re.findall(r"_SPECIFICATION_DIGEST (0x\w+)U", macros)
        told = run(["sha256sum", "spec.json"], bundle)
        assert int(specification, 16) == int(told[:8], 16)
        for function in tree.module.functions:
            kernel = build_files.kernel_path(tree, function.name)
            told = run(["sh", "-c", f"sed -n '/^#ifndef/,$p' {kernel} | sha256sum"], bundle)
            symbol = f"{tree.prefix}_{function.name}".upper()
            assert f"#define {symbol}_MODEL_DIGEST 0x{told[:8].upper()}U\n" in macros
