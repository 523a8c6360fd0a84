"""Building a generated package: declarations, names, cache, failures."""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import sysconfig
from pathlib import Path

import cffi
import numpy as np
import pytest

from symnav import build, errors, ir
from tests.emit_c import modules
from tests.emit_c.harness import Library, load_extension, write_package
from tests.emit_c.samples import draw

needs_compiler = pytest.mark.skipif(
    all(shutil.which(name) is None for name in ("cc", "gcc", "clang")), reason="needs a C compiler"
)
pytestmark = needs_compiler


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A cache of its own for every test."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("SYMNAV_CACHE_DIR", str(folder))
    return folder


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A small package."""
    return write_package(tmp_path / "generated", modules.module(modules.two_rows()))


def record(package: Path) -> dict[str, object]:
    """The build record."""
    read: dict[str, object] = json.loads((package / "_build.json").read_text(encoding="utf-8"))
    return read


def test_record_names_what_was_built(package: Path) -> None:
    """Module, sources with their digests, flags and compiler."""
    result = build.build(package)
    written = record(package)
    assert result.compiled == ("native",)
    assert re.fullmatch(r"_rover_[0-9a-f]{16}", str(written["native"]))
    assert written["casadi"] is None
    assert result.modules["native"].name.startswith(str(written["native"]) + ".")
    flags = written["flags"]
    assert isinstance(flags, list)
    assert [flag for flag in flags if flag != build.DISPATCH_FLAG] == list(build.FLAGS)
    assert "-ffast-math" not in build.FLAGS
    sources = written["sources"]
    assert isinstance(sources, dict)
    assert set(sources) == {
        path.relative_to(package).as_posix() for path in (package / "c").rglob("*.[ch]")
    }
    for path, digest in sources.items():
        assert hashlib.sha256((package / path).read_bytes()).hexdigest() == digest
    assert "." in str(written["compiler"])


def test_built_functions_work(package: Path) -> None:
    """The extension computes, from an interpreter of its own."""
    library = Library(load_extension(build.build(package)), "rover", np.float64)
    function = modules.two_rows()
    inputs = draw(function, 1, 2)
    inputs["x"][:2] = 10.0
    inputs["anchor"][:] = 4.0
    found = library.evaluate(function, inputs, 2)
    assert found.status is ir.Status.OK
    assert list(found["value"][:4]) == [6.0, 36.0, 6.0, 36.0]


def test_second_build_does_nothing(package: Path) -> None:
    """The same file stays, and the log says so."""
    first = build.build(package).modules["native"]
    before = first.stat().st_mtime_ns
    lines: list[str] = []
    second = build.build(package, log=lines.append)
    assert second.compiled == ()
    assert second.modules["native"] == first
    assert first.stat().st_mtime_ns == before
    assert any("up to date" in line for line in lines)


def test_cache_serves_another_directory(package: Path, tmp_path: Path, own_cache: Path) -> None:
    """The same sources elsewhere are not compiled again; without the cache they are."""
    name = build.build(package).modules["native"].name
    assert [path.name for path in own_cache.iterdir()] == [name]
    elsewhere = tmp_path / "elsewhere" / "rover"
    shutil.copytree(package / "c", elsewhere / "c")
    result = build.build(elsewhere)
    assert result.compiled == ()
    assert result.modules["native"].read_bytes() == (package / name).read_bytes()
    shutil.rmtree(own_cache)
    result.modules["native"].unlink()
    assert build.build(elsewhere).compiled == ("native",)


def test_cache_that_cannot_be_written(
    package: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is reported and the build goes on."""
    file = tmp_path / "file"
    file.write_text("in the way")
    monkeypatch.setenv("SYMNAV_CACHE_DIR", str(file / "cache"))
    lines: list[str] = []
    assert build.build(package, log=lines.append).modules["native"].is_file()
    assert any(line.startswith("not cached") for line in lines)


def test_name_depends_on_all_that_matters(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Sources, headers, flags, compiler, its own arguments: another name; the old file goes."""
    seen = {build.build(package).modules["native"].name}
    for path in ("c/src/rover_rows.c", "c/include/rover/rover.h"):
        file = package / path
        file.write_text(file.read_text(encoding="utf-8") + "\n/* changed */\n", encoding="utf-8")
        seen.add(build.build(package).modules["native"].name)
    seen.add(build.build(package, native=True).modules["native"].name)
    assert build.NATIVE_FLAG in str(record(package)["flags"])
    real = build.find_compiler()
    other = build.Compiler(real.command, "some other compiler 1.0")
    monkeypatch.setattr(build, "find_compiler", lambda: other)
    seen.add(build.build(package).modules["native"].name)
    more = build.Compiler((*real.command, "-DSYMNAV_TEST=1"), "some other compiler 1.0")
    monkeypatch.setattr(build, "find_compiler", lambda: more)
    seen.add(build.build(package).modules["native"].name)
    assert len(seen) == 6
    assert len(list(package.glob("_rover_*"))) == 1


def test_native_build_gives_the_same_bits(tmp_path: Path) -> None:
    """Wider vectors, but no operation is fused: a batch is still one call after the other."""
    function = modules.antenna(guards=ir.Guards.ASSUME)
    package = write_package(tmp_path, modules.module(function))
    samples = [draw(function, seed) for seed in range(40)]
    plain, native = (
        Library(load_extension(build.build(package, native=wanted)), "rover", np.float64)
        for wanted in (False, True)
    )
    stacked = native.batch(function, samples)
    for place, inputs in enumerate(samples):
        one, same = plain.evaluate(function, inputs), native.evaluate(function, inputs)
        for key, array in one.outputs.items():
            np.testing.assert_array_equal(same[key], array)
            np.testing.assert_array_equal(stacked[key][place].ravel(), array)


@pytest.mark.skipif(
    build.DISPATCH_FLAG not in build.dispatch_flags(build.find_compiler()),
    reason="needs gcc for x86-64 and the GNU C library",
)
def test_dispatch_gives_the_same_bits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Loops for wide registers are there, the loader picks, and nothing changes but the time."""
    function = modules.antenna(guards=ir.Guards.ASSUME)
    package = write_package(tmp_path, modules.module(function))
    samples = [draw(function, seed) for seed in range(40)]
    wide = Library(load_extension(build.build(package)), "rover", np.float64)
    module = build.build(package).modules["native"]
    code = subprocess.run(["objdump", "-d", module], capture_output=True, text=True, check=True)
    assert "ymm" in code.stdout
    assert "fmadd" not in code.stdout
    batch = wide.batch(function, samples)
    monkeypatch.setattr(build, "dispatch_flags", lambda _compiler: [])
    narrow = Library(load_extension(build.build(package)), "rover", np.float64)
    for key, array in narrow.batch(function, samples).outputs.items():
        np.testing.assert_array_equal(batch[key], array)


def test_other_files_stay(package: Path) -> None:
    """Only earlier extensions of this very package are removed."""
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    kept = [package / f"_rover_notes{suffix}", package / f"_other_{'0' * 16}{suffix}"]
    gone = package / f"_rover_{'0' * 16}{suffix}"
    for path in (*kept, gone):
        path.write_bytes(b"")
    build.build(package)
    assert all(path.is_file() for path in kept)
    assert not gone.exists()


def test_both_trees_share_one_extension(tmp_path: Path) -> None:
    """Double and single precision side by side."""
    function = modules.antenna()
    both = [modules.module(function, scalar=scalar) for scalar in ir.Scalar]
    package = write_package(tmp_path, *both)
    extension = load_extension(build.build(package))
    inputs = draw(function, 3, 0, np.float32)
    double = Library(extension, "rover", np.float64).evaluate(function, inputs)
    single = Library(extension, "rover_f32", np.float32).evaluate(function, inputs)
    assert double.status is single.status is ir.Status.OK
    np.testing.assert_allclose(single["value"], double["value"], rtol=1e-6)
    assert single["value"].dtype == np.float32


def test_casadi_stands_apart(package: Path) -> None:
    """Its C becomes an extension of its own, next to the other."""
    folder = package / "casadi"
    folder.mkdir()
    (folder / "rover_casadi.h").write_text(
        "/* prototypes */\nint twice(const double **a, double **r);\n"
    )
    (folder / "rover_casadi.c").write_text(
        "int twice(const double **a, double **r) { r[0][0] = 2.0 * a[0][0]; return 0; }\n"
    )
    result = build.build(package)
    assert set(result.modules) == {"native", "casadi"}
    assert re.fullmatch(r"_rover_casadi_[0-9a-f]{16}", str(record(package)["casadi"]))
    extension = load_extension(result, "casadi")
    argument, output = (extension.ffi.new("double *", value) for value in (21.0, 0.0))
    arguments = extension.ffi.new("const double *[]", [argument])
    outputs = extension.ffi.new("double *[]", [output])
    assert extension.lib.twice(arguments, outputs) == 0
    assert output[0] == 42.0
    own = result.modules["native"].name
    (folder / "rover_casadi.c").write_text("int twice(const double **a, double **r);\n")
    assert build.build(package, log=None).modules["native"].name == own


def test_refused_source_leaves_nothing_half_built(package: Path, own_cache: Path) -> None:
    """The message names what the compiler said, the log holds all of it."""
    before = build.build(package)
    kept = (package / "_build.json").read_bytes()
    (package / "c" / "src" / "rover_rows.c").write_text("int broken(void) { return nowhere; }\n")
    with pytest.raises(errors.BuildError, match="nowhere") as caught:
        build.build(package)
    log = package / "_build.log"
    assert str(log) in str(caught.value)
    assert "rover_rows.c" in log.read_text(encoding="utf-8")
    assert (package / "_build.json").read_bytes() == kept
    assert [path for path in package.iterdir() if path.is_dir() and path.name != "c"] == []
    assert len(list(own_cache.iterdir())) == 1
    assert before.modules["native"].is_file()


def test_no_compiler(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One line says how to get one, on every system."""
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", "")
    with pytest.raises(errors.BuildError) as caught:
        build.build(package)
    for remedy in ("apt install", "dnf install", "xcode-select --install", "Visual Studio"):
        assert remedy in str(caught.value)
    assert "\n" not in str(caught.value)
    assert not (package / "_build.json").exists()


def test_compiler_of_the_environment(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """``CC`` decides, with arguments; a wrong one is named."""
    monkeypatch.setenv("CC", "no-such-compiler -m64")
    with pytest.raises(errors.BuildError, match="'no-such-compiler' that CC names"):
        build.build(package)
    real = build.Compiler(("gcc",), "").command[0] if shutil.which("gcc") else "cc"
    monkeypatch.setenv("CC", f"{real} -DSYMNAV_TEST=1")
    assert build.find_compiler().command == (real, "-DSYMNAV_TEST=1")


def test_missing_python_headers(
    package: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They come in a package of their own on most systems."""
    monkeypatch.setattr(sysconfig, "get_path", lambda name: str(tmp_path / "nowhere"))
    with pytest.raises(errors.BuildError, match=r"headers of Python are missing.*python3-dev"):
        build.build(package)


def test_nothing_to_compile(tmp_path: Path) -> None:
    """A directory that is no package."""
    with pytest.raises(errors.BuildError, match="no C to compile"):
        build.build(tmp_path)


def test_setuptools_route_gives_the_same_bits(package: Path, tmp_path: Path) -> None:
    """The route for Visual Studio compiles the same files."""
    (extension,) = build._extensions(package)
    wrapper = cffi.FFI()
    wrapper.cdef(extension.declarations)
    folder = tmp_path / "work"
    folder.mkdir()
    flags = list(build.FLAGS)[2:]
    made = build.compile_with_setuptools(
        wrapper, "_rover_slow", extension.preamble, extension, flags, folder
    )
    own = build.build(package)
    function = modules.two_rows()
    inputs = draw(function, 5, 7)
    inputs["x"][:2] *= 1e-3
    both = [
        Library(load_extension(result), "rover", np.float64).evaluate(function, inputs, 7)
        for result in (own, build.BuildResult(package, {"native": made}, ()))
    ]
    assert both[0].status is both[1].status
    for key, array in both[0].outputs.items():
        np.testing.assert_array_equal(array, both[1][key])


def test_builds_at_the_same_time(package: Path) -> None:
    """Two processes that build one package leave one good extension."""
    script = (
        "import sys; from pathlib import Path; from symnav.build import build; "
        "print(build(Path(sys.argv[1])).modules['native'].name)"
    )
    root = Path(build.__file__).parents[2]
    command = [sys.executable, "-c", script, str(package)]
    running = [
        subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=root) for _ in range(2)
    ]
    names = {process.communicate()[0].strip() for process in running}
    assert all(process.returncode == 0 for process in running)
    assert len(names) == 1
    assert {path.name for path in package.iterdir()} == {"c", "_build.json", *names}


class TestDeclarations:
    """What cffi reads of a header."""

    def test_only_what_stands_between_the_marks(self) -> None:
        """Conditionals and the C++ wrapper are outside."""
        header = """
            #ifdef __cplusplus
            extern "C" {
            #endif
            /* Interface begins. */
            typedef double p_real_t; /* a comment
                over lines */
            #define P_COUNT 12
            static const int32_t p_rows[3] = {
                0, 1,
                2
            };
            void f(const p_real_t x[P_RESTRICT P_COUNT], p_real_t y[P_RESTRICT]);
            /* Interface ends. */
            #ifdef __cplusplus
            }
            #endif
        """
        lines = [line.strip() for line in build.declarations(header).splitlines()]
        assert lines == [
            "typedef double p_real_t;",
            "#define P_COUNT 12",
            "extern const int32_t p_rows[3];",
            "void f(const p_real_t x[ P_COUNT], p_real_t y[]);",
        ]

    def test_a_header_without_marks_counts_whole(self) -> None:
        """As CasADi's prototypes."""
        assert build.declarations("/* x */\nint f(void);\n") == "int f(void);\n"

    def test_constants_and_tables_arrive(self, package: Path) -> None:
        """Enumerators, macros, sizes and tables are those of the header."""
        lib = load_extension(build.build(package)).lib
        assert lib.ROVER_STATE_SIZE == 20
        assert lib.ROVER_E_ATTITUDE == 3
        assert lib.ROVER_PARTIAL == ir.Status.PARTIAL
        assert lib.ROVER_LAYOUT_DIGEST == 0x89ABCDEF
        assert lib.ROVER_ROWS_MAX_ITEMS == 33
        assert list(lib.rover_rows_jacobian_rows) == [0, 1, 1]
        assert list(lib.rover_rows_jacobian_columns) == [0, 0, 1]


def test_declarations_that_cffi_cannot_read(package: Path) -> None:
    """One message that names the headers and the log, whatever cffi raises."""
    header = next((package / "c" / "include").glob("*/rover.h"))
    text = header.read_text(encoding="utf-8")
    for clash in ("int rover_real_t(int a);", "int twice(int a);\nint twice(double a);"):
        marked = text.replace("/* Interface ends. */", f"{clash}\n/* Interface ends. */")
        header.write_text(marked, encoding="utf-8")
        with pytest.raises(errors.BuildError, match="cffi cannot read the declarations"):
            build.build(package)
        assert clash.partition("\n")[0] in (package / "_build.log").read_text(encoding="utf-8")


def test_a_killed_build_leaves_the_package_as_it_was(package: Path, tmp_path: Path) -> None:
    """The compiler stops the whole build while it works; nothing foreign stays in the package."""
    before = set(package.rglob("*"))
    script = tmp_path / "cc"
    script.write_text(
        f"#!{sys.executable}\n"
        "import os, signal, subprocess, sys\n"
        "if '-c' in sys.argv:\n"
        "    os.kill(os.getppid(), signal.SIGKILL)\n"
        "sys.exit(subprocess.call(['gcc', *sys.argv[1:]]))\n",
        encoding="utf-8",
    )
    script.chmod(0o755)
    command = "import sys; from pathlib import Path; from symnav import build;"
    command += f"build.build(Path({str(package)!r}))"
    done = subprocess.run(
        [sys.executable, "-c", command],
        env={**os.environ, "CC": str(script), "TMPDIR": str(tmp_path)},
        check=False,
    )
    assert done.returncode == -signal.SIGKILL
    assert set(package.rglob("*")) == before


def test_only_the_mark_of_an_array_is_dropped() -> None:
    """A state block may be called RESTRICT."""
    text = "enum {\n    A_X_RESTRICT = 0,\n};\nint f(const double x[A_RESTRICT 3]);\n"
    assert build.declarations(text) == text.replace("A_RESTRICT ", " ")
