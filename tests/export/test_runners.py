"""Runners say passed where a bundle is sound and failed where it is not."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from symnav.export.runners import RUNNERS, Record, Runner, Verdict
from symnav.export.runners.compilers import Analyser, Stack, Warnings
from symnav.export.runners.linters import ClangTidy, Cppcheck, Lizard
from tests.export.bundles import MODELS, SCALARS, copy_of, replace_in
from tests.export.bundles import run as shell

QUICK: tuple[Runner, ...] = (Warnings(), Stack(), Lizard(), ClangTidy())
AS_GCC = Cppcheck(defined=("-D__GNUC__",))
SOURCE = "src/reference_relative_range.c"


def run(runner: Runner, folder: Path) -> Record:
    """The record of a runner; the test is skipped where its tool is missing."""
    reason = runner.missing()
    if reason:
        pytest.skip(reason)
    return runner.run(folder)


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """The bundle of a small model in double."""
    return copy_of("reference_relative", "double", tmp_path)


@pytest.mark.parametrize("runner", QUICK, ids=lambda runner: runner.name)
@pytest.mark.parametrize("scalar", SCALARS)
@pytest.mark.parametrize("model", MODELS)
def test_quick_proofs_of_every_model(
    model: str, scalar: str, runner: Runner, tmp_path: Path
) -> None:
    record = run(runner, copy_of(model, scalar, tmp_path))
    assert record.verdict is Verdict.PASSED, record.findings
    assert record.version and record.command and record.shown


@pytest.mark.parametrize("model", MODELS)
def test_misra_budget_of_every_model(model: str, tmp_path: Path) -> None:
    """In single precision, where a bundle may hold two trees, and as gcc sees it."""
    record = run(AS_GCC, copy_of(model, "float", tmp_path))
    assert record.verdict is Verdict.PASSED, record.findings
    counts = record.details["by_rule"]
    assert isinstance(counts, dict) and counts.keys() == {"2.5", "5.9", "8.7", "19.2"}


@pytest.mark.slow
@pytest.mark.parametrize("model", ["rover", "farrell_tightly_coupled"])
def test_misra_budget_in_all_configurations(model: str, tmp_path: Path) -> None:
    record = run(Cppcheck(), copy_of(model, "float", tmp_path))
    assert record.verdict is Verdict.PASSED, record.findings


@pytest.mark.slow
@pytest.mark.parametrize("model", MODELS)
def test_path_analysis_of_every_model(model: str, tmp_path: Path) -> None:
    record = run(Analyser(), copy_of(model, "float", tmp_path))
    assert record.verdict is Verdict.PASSED, record.findings


def test_a_warning_fails(small: Path) -> None:
    replace_in(small / SOURCE, "int32_t count;\n", "int32_t count;\n        int32_t unused;\n")
    record = run(Warnings(), small)
    assert record.verdict is Verdict.FAILED
    assert any("unused variable" in finding for finding in record.findings)


def test_a_number_without_suffix_fails_in_single_precision_only(tmp_path: Path) -> None:
    single = copy_of("reference_relative", "float", tmp_path)
    source = single / "src/reference_relative_f32_range.c"
    replace_in(source, "dense[0] = 0.0F;", "dense[0] = (reference_relative_f32_real_t)0.0;")
    record = run(Warnings(), single)
    assert record.verdict is Verdict.FAILED
    assert any("unsuffixed" in finding for finding in record.findings)


@pytest.mark.parametrize(
    ("model", "scalar"),
    [("reference_relative", "double"), ("reference_relative", "float"), ("rover", "float")],
)
def test_the_command_has_the_flags_of_the_record(model: str, scalar: str, tmp_path: Path) -> None:
    """What is asked of single precision alone as well, and it covers every source."""
    folder = copy_of(model, scalar, tmp_path)
    record = run(Warnings(), folder)
    flags = record.details["flags"]
    assert isinstance(flags, list)
    words = record.command.split()
    assert {word for word in words if word.startswith("-W")} == set(flags)
    assert ("-Wunsuffixed-float-constants" in flags) == (scalar == "float")
    assert f"under {len(flags)} flags" in record.shown
    shell(["sh", "-c", record.command], folder)
    sources = {path.stem for path in (folder / "src").glob("*.c")}
    assert {path.stem for path in folder.glob("*.o")} == sources


def test_what_does_not_compile_fails(small: Path) -> None:
    (small / SOURCE).write_text("this is no C\n")
    for runner in (Warnings(), Analyser(), Stack()):
        assert run(runner, small).verdict is Verdict.FAILED


def test_a_null_dereference_fails_the_analyser(small: Path) -> None:
    with (small / SOURCE).open("a") as file:
        file.write("int32_t probe(void);\nint32_t probe(void)\n{\n")
        file.write("    const int32_t *p = NULL;\n    return *p;\n}\n")
    record = run(Analyser(), small)
    assert record.verdict is Verdict.FAILED
    assert any("NULL" in finding for finding in record.findings)


def test_the_stack_of_every_entry_point_is_counted(small: Path) -> None:
    """Those that are compiled more than once, or for narrow vectors, as well."""
    header = "include/reference_relative/reference_relative.h"
    text = (small / header).read_text(encoding="utf-8")
    declared = re.findall(r"^reference_relative_status_t (\w+)\(", text, re.MULTILINE)
    counted = run(Stack(), small).details["bytes"]
    assert isinstance(counted, dict) and declared and set(counted) == set(declared)


def test_recursion_and_deep_stacks_fail(small: Path) -> None:
    deep = run(Stack(limit=16), small)
    assert deep.verdict is Verdict.FAILED
    assert any("above 16" in finding for finding in deep.findings)
    with (small / SOURCE).open("a") as file:
        file.write(
            "reference_relative_status_t again(int32_t n);\n"
            "reference_relative_status_t again(int32_t n)\n{\n"
            "    volatile int32_t k = n;\n"
            "    return (k > 0) ? (reference_relative_status_t)(again(k - 1) + again(k - 2)) :\n"
            "        REFERENCE_RELATIVE_OK;\n}\n"
        )
    record = run(Stack(), small)
    assert record.verdict is Verdict.FAILED
    assert any("calls itself" in finding for finding in record.findings)


def test_a_function_that_decides_too_much_fails(small: Path) -> None:
    record = run(Lizard(complexity=2), small)
    assert record.verdict is Verdict.FAILED and record.findings


def test_required_rules_have_no_budget(small: Path) -> None:
    replace_in(
        small / SOURCE, "nonzeros[0] = out->value[0];", "if (out) nonzeros[0] = out->value[0];"
    )
    record = run(AS_GCC, small)
    assert record.verdict is Verdict.FAILED
    assert any("misra-c2012-15.6" in finding for finding in record.findings)


def test_cppcheck_findings_have_no_budget(small: Path) -> None:
    with (small / SOURCE).open("a") as file:
        file.write("static int32_t probe(void)\n{\n    int32_t a[2] = {0, 0};\n")
        file.write("    return a[3];\n}\n")
    record = run(AS_GCC, small)
    assert any("arrayIndexOutOfBounds" in finding for finding in record.findings)


def test_clang_tidy_findings_fail(small: Path) -> None:
    broken = "const int32_t n = 7; dense[0] = n / 2;"
    replace_in(small / SOURCE, "dense[0] = nonzeros[0];", broken)
    record = run(ClangTidy(), small)
    assert record.verdict is Verdict.FAILED
    assert any("bugprone-integer-division" in finding for finding in record.findings)
    assert all(str(small) not in finding for finding in record.findings)


def test_names_are_different() -> None:
    names = [runner.name for runner in RUNNERS]
    assert len(set(names)) == len(names)
