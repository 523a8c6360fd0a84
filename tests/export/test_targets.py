"""Bundles on a bare Cortex-M under QEMU, and the start-up code that gets them there."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from symnav import pipeline
from symnav.build.objects import Binutils, stack_bytes
from symnav.cli import main
from symnav.emit.templates import directory
from symnav.errors import BuildError
from symnav.export.building.targets import FOLDER
from symnav.export.runners import emulation
from symnav.export.runners.emulation import TARGETS, Called, Emulated, Unit
from tests.export.bundles import bundle_of

MODELS = [name for name, _ in pipeline.shipped()]
SUPPORT = directory() / "export" / FOLDER
on_target = pytest.mark.skipif(
    bool(emulation.missing()), reason=f"needs {', '.join(emulation.missing())}"
)
CPUS = pytest.mark.parametrize("cpu", TARGETS)


def exported(model: str, scalar: str, folder: Path) -> Path:
    """A bundle, as a user gets it."""
    command = ["export", model, "--to", str(folder), "--scalar", scalar]
    done = CliRunner().invoke(main, command)
    assert done.exit_code == 0, done.output
    return folder


def bare(text: str, cpu: str, folder: Path) -> Path:
    """A program of one file and the start-up code."""
    source, program = folder / "main.c", folder / "main.elf"
    source.write_text(text, encoding="utf-8")
    support = [str(SUPPORT / name) for name in ("startup.c", "semihost.c")]
    command = [
        "arm-none-eabi-gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", *TARGETS[cpu].flags,
        "-ffreestanding", f"-I{SUPPORT}", "-nostartfiles", "-T", str(SUPPORT / "mps2.ld"),
        str(source), *support, "-lm", "-o", str(program),
    ]  # fmt: skip
    subprocess.run(command, check=True)
    return program


@on_target
@CPUS
def test_memory_and_numbers_are_ready_before_main(cpu: str, tmp_path: Path) -> None:
    program = bare(
        """
        #include <stdio.h>
        static int filled = 7, cleared;
        static volatile float two = 2.0F;
        int main(void)
        {
            const float root = __builtin_sqrtf(two);
            printf("%d %i %u|%5d|%05d|%x %08lx|%c%s%%\\n", filled, cleared, 4294967295U, -42, -42,
                   255U, 0xBEEFUL, 'a', "bc");
            printf("%zu %d %s\\n", sizeof(long), (int)(1e6F * root),
                   "a text longer than the buffer, which has to be handed over in more than "
                   "one part, and nothing is lost: 0123456789012345678901234567890123456789");
            return (root == 1.41421354F) ? 0 : 1;
        }
        """,
        cpu,
        tmp_path,
    )
    first, second = TARGETS[cpu].emulated(program).splitlines()
    assert first == "7 0 4294967295|  -42|-0042|ff 0000beef|abc%"
    assert second.startswith("4 1414213 a text longer") and second.endswith("0123456789" * 4)


ENDINGS = {
    "failure": "return 3;",
    "null": "((void (*)(void))0x90000000)(); return 0;",
    "stack": "return deep(1);",
    "printf": 'printf("%f\\n", 1.0); return 0;',
}


@on_target
@CPUS
@pytest.mark.parametrize("ending", ENDINGS)
def test_what_goes_wrong_fails(ending: str, cpu: str, tmp_path: Path) -> None:
    """A status, a jump to nowhere, an endless recursion, a conversion that is not known."""
    program = bare(
        f"""
        #include <stdio.h>
        int deep(int n);
        __attribute__((noinline)) int deep(int n)
        {{
            volatile char room[512] = {{0}};
            return (n > 0) ? deep(n + 1) + room[n & 511] : 0;
        }}
        int main(void)
        {{
            {ENDINGS[ending]}
        }}
        """,
        cpu,
        tmp_path,
    )
    with pytest.raises(BuildError, match="qemu-system-arm"):
        TARGETS[cpu].emulated(program)


@on_target
def test_a_bundle_on_a_target(tmp_path: Path) -> None:
    """Tests pass, bits are the host's, nothing is needed from elsewhere."""
    record = emulation.run(exported("reference_relative", "float", tmp_path), "cortex-m4")
    assert record.findings == ()
    assert "0 failures" in record.tests
    calls = {call.symbol: call for call in record.calls}
    dense, sparse = (calls[f"reference_relative_f32_range{form}"] for form in ("", "_nz"))
    assert dense.exact and dense.ulps == 0.0
    assert 100 < sparse.instructions < dense.instructions < 5000
    assert 100 < sparse.flash < dense.flash < 5000
    assert {unit.scalar for unit in record.units} == {"float"}


@on_target
def test_other_flags_make_everything_again_for_a_target(tmp_path: Path) -> None:
    """What other flags left is not run."""
    folder = quick(tmp_path)

    def made(*words: str) -> subprocess.CompletedProcess[str]:
        command = ["make", "check-m4", *words]
        return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)

    first, again, other = made(), made(), made("CFLAGS=-O1")
    assert "emulated cortex-m4 with arm-none-eabi-gcc" in first.stdout
    assert "-c" not in again.stdout.split() and "passed" in again.stdout
    assert other.stdout.split().count("-c") == first.stdout.split().count("-c") > 3
    missing = made("CROSS=no-such-")
    assert missing.returncode != 0 and "passed" not in missing.stdout


@pytest.mark.slow
@on_target
@CPUS
@pytest.mark.parametrize("scalar", ["float", "double"])
@pytest.mark.parametrize("model", MODELS)
def test_every_bundle_on_every_target(model: str, scalar: str, cpu: str, tmp_path: Path) -> None:
    record = emulation.run(exported(model, scalar, tmp_path), cpu)
    assert record.findings == ()
    assert "0 failures" in record.tests
    assert any(call.scalar == scalar for call in record.calls)
    single = [unit for unit in record.units if unit.scalar == "float"]
    assert not any(name.startswith("__aeabi_") for unit in single for name in unit.undefined)


def quick(folder: Path) -> Path:
    """A small bundle whose tests pass whatever it computes."""
    exported("reference_relative", "float", folder)
    test = folder / "test" / "test_reference_relative_f32.c"
    test.write_text("int main(void)\n{\n    return 0;\n}\n")
    return folder


@on_target
def test_a_double_in_single_precision_is_found(tmp_path: Path) -> None:
    folder = quick(tmp_path)
    source = folder / "src" / "reference_relative_f32_range.c"
    wide = "double wide(double x);\ndouble wide(double x)\n{\n    return sqrt(x) * x;\n}\n"
    source.write_text(source.read_text() + wide)
    record = emulation.run(folder, "cortex-m4")
    assert record.findings == (f"src/{source.name}: __aeabi_dmul, sqrt",)


@on_target
def test_other_arithmetic_on_the_target_is_found(tmp_path: Path) -> None:
    """What is rounded less often there differs in bits that are prescribed."""
    folder = quick(tmp_path)
    kernel = folder / "src" / "reference_relative_f32_range_kernel.h"
    changed = kernel.read_text().replace("const reference_relative_f32_real_t ", "REAL ")
    assert changed.count("REAL ") > 10
    kernel.write_text(
        "#if defined(__arm__)\n#define REAL const double\n#else\n"
        f"#define REAL const reference_relative_f32_real_t\n#endif\n{changed}"
    )
    record = emulation.run(folder, "cortex-m7")
    call = next(c for c in record.calls if c.symbol == "reference_relative_f32_range")
    assert call.exact and call.ulps > 0.0
    assert any(finding.startswith(f"{call.symbol}: ") for finding in record.findings)


@on_target
def test_failing_tests_leave_no_record(tmp_path: Path) -> None:
    folder = exported("reference_relative", "float", tmp_path)
    source = folder / "src" / "reference_relative_f32_range.c"
    text = source.read_text()
    assert "(value != NULL)" in text
    source.write_text(text.replace("(value != NULL)", "true", 1))
    with pytest.raises(BuildError, match="FAILED reference_relative_f32_range"):
        emulation.run(folder, "cortex-m4")


@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
@pytest.mark.parametrize(
    "model", [m if m == "rover" else pytest.param(m, marks=pytest.mark.slow) for m in MODELS]
)
def test_counting_runs_on_the_host(model: str, tmp_path: Path) -> None:
    """Inputs are good for every function, and the program is clean C."""
    folder = exported(model, "float", tmp_path)
    sources = sorted(str(path) for path in (folder / "src").glob("*.c"))
    command = [
        "gcc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror",
        f"-I{folder / 'include'}", str(folder / FOLDER / "count.c"), *sources, "-lm",
        "-o", str(tmp_path / "count"),
    ]  # fmt: skip
    subprocess.run(command, check=True)
    printed = subprocess.run([str(tmp_path / "count")], check=True, capture_output=True, text=True)
    found = emulation._printed(printed.stdout)
    headers = "".join(path.read_text() for path in (folder / "include").rglob("*.h"))
    assert found.forms and all(f"{symbol}(" in headers for symbol in found.forms)
    for symbol, form in found.forms.items():
        assert set(form.statuses) == {0}, symbol
        assert len(form.blocks) == len(form.rows[0])
        assert all(np.isfinite(row).all() and row.any() for row in form.rows), symbol


@on_target
@pytest.mark.skipif(shutil.which("cmake") is None, reason="needs cmake")
@CPUS
def test_toolchain_file_for_cmake(cpu: str, tmp_path: Path) -> None:
    """CMake builds for the target and ctest runs what it built."""
    (tmp_path / "main.c").write_text("int main(void)\n{\n    return 0;\n}\n")
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.13)\nproject(bare C)\nenable_testing()\n"
        f"add_executable(bare main.c {SUPPORT}/startup.c {SUPPORT}/semihost.c)\n"
        "add_test(NAME bare COMMAND bare)\n"
    )
    toolchain = f"-DCMAKE_TOOLCHAIN_FILE={SUPPORT / 'toolchain-arm-none-eabi.cmake'}"
    build = tmp_path / "build"
    configure = ["cmake", "-S", str(tmp_path), "-B", str(build), toolchain, f"-DSEMIHOST_CPU={cpu}"]
    for command in (configure, ["cmake", "--build", str(build)]):
        subprocess.run(command, check=True, capture_output=True)
    done = subprocess.run(["ctest"], cwd=build, capture_output=True, text=True, check=True)
    assert "100% tests passed" in done.stdout
    about = subprocess.run(["arm-none-eabi-readelf", "-A", str(build / "bare")],
                           capture_output=True, text=True, check=True).stdout  # fmt: skip
    assert {"cortex-m4": "v7E-M", "cortex-m7": "v7E-M"}[cpu] in about
    assert "Tag_ABI_VFP_args: VFP registers" in about


@on_target
@pytest.mark.skipif(shutil.which("cmake") is None, reason="needs cmake")
@CPUS
def test_the_bundle_itself_for_cmake(cpu: str, tmp_path: Path) -> None:
    """Its own CMakeLists.txt brings the start-up code of its tests."""
    folder = bundle_of("rover", "float")
    toolchain = f"-DCMAKE_TOOLCHAIN_FILE={folder / FOLDER / 'toolchain-arm-none-eabi.cmake'}"
    build = tmp_path / "build"
    configure = ["cmake", "-S", str(folder), "-B", str(build), toolchain, f"-DSEMIHOST_CPU={cpu}"]
    for command in (configure, ["cmake", "--build", str(build), "-j2"]):
        subprocess.run(command, check=True, capture_output=True)
    words = ["ctest", "--output-on-failure"]
    done = subprocess.run(words, cwd=build, capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "100% tests passed" in done.stdout, done.stdout


def record_of(unit: Unit, call: Called) -> Emulated:
    return Emulated("cortex-m4", "mps2-an386", "gcc", "qemu", (), "", (unit,), (call,))


UNIT = Unit("src/a.c", "float", ("memcpy", "sinf", "sqrtf"))
CALL = Called("a", "float", 100.0, 100, 8, exact=True, ulps=0.0)


@pytest.mark.parametrize(
    ("unit", "call", "finding"),
    [
        (UNIT, CALL, None),
        (replace(UNIT, undefined=("sin",)), CALL, "src/a.c: sin"),
        (replace(UNIT, undefined=("__aeabi_dadd",)), CALL, "src/a.c: __aeabi_dadd"),
        (replace(UNIT, undefined=("malloc",)), CALL, "src/a.c: malloc"),
        (Unit("src/a.c", "double", ("__aeabi_dadd", "sin")), CALL, None),
        (Unit("src/a.c", "double", ("printf",)), CALL, "src/a.c: printf"),
        (UNIT, replace(CALL, ulps=0.5), "a: 0.5 ULP from the host"),
        (UNIT, replace(CALL, exact=False, ulps=2.0), None),
        (UNIT, replace(CALL, exact=False, ulps=2.5), "a: 2.5 ULP from the host"),
        (UNIT, replace(CALL, ulps=float("nan")), "a: nan ULP from the host"),
    ],
)
def test_findings(unit: Unit, call: Called, finding: str | None) -> None:
    assert record_of(unit, call).findings == (() if finding is None else (finding,))


def printed(status: int, *values: float) -> emulation._Form:
    words = " ".join(f"{word:x}" for word in np.array(values, np.float32).view(np.uint32))
    text = f"f blocks 0 0 1\nf float 0 {status} {words}\nf takes 30 in 2\nnothing takes 10 in 2\n"
    found = emulation._printed(text)
    assert found.instructions("f") == 400.0
    return found.forms["f"]


def test_differences_are_measured_in_their_block() -> None:
    """Of what shares a unit the largest decides; a status or a number that is none is endless."""
    one = printed(0, 1.0, 1e-3, 1e6)
    assert emulation._difference(one, one) == 0.0
    near = printed(0, 1.0, 1e-3 + 2.0**-22, 1e6)
    assert emulation._difference(one, near) == pytest.approx(2.0, abs=1e-3)
    assert emulation._difference(one, printed(0, 1.0, 1e-3, 1e6 + 0.0625)) == 1.0
    assert emulation._difference(one, printed(2, 1.0, 1e-3, 1e6)) == float("inf")
    assert emulation._difference(one, printed(0, 1.0, float("nan"), 1e6)) == float("inf")
    assert emulation._difference(printed(0, 0.0, 1.0, 1.0), printed(0, -0.0, 1.0, 1.0)) == 0.0


def test_copies_of_the_compiler_count_for_the_stack(tmp_path: Path) -> None:
    account = tmp_path / "a.su"
    account.write_text(
        "a.c:1:1:load.isra\t16\tstatic\na.c:9:1:f\t8\tstatic\na.c:3:1:g\t4\tstatic\n"
    )
    assert stack_bytes(account, frozenset({"f", "load.isra.0"})) == 24


def test_missing_tools_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert emulation.missing() == emulation.TOOLS
    with pytest.raises(BuildError, match="arm-none-eabi-nm is needed"):
        Binutils("arm-none-eabi-").undefined(tmp_path / "a.o")
