"""The test program of a bundle: it passes on every host, reaches everything, and finds mistakes."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from symnav import pipeline
from symnav.errors import ProofError
from symnav.export.runners import coverage
from symnav.spec import from_table
from tests.export.bundles import OUTER
from tests.export.conftest import Exported
from tests.export.hosts import HOSTS, Host

EVERYTHING = [(name, scalar) for name, _ in pipeline.shipped() for scalar in ("double", "float")]
FEW = [
    *(("reference_relative", "float", host) for host in HOSTS),
    *(("rover", "float", host) for host in ("gcc", "tcc")),
    (*OUTER, "gcc"),
    ("farrell_tightly_coupled", "double", "tcc"),
]
REACHED = [("rover", "float"), OUTER, ("reference_relative", "float")]
SUMMARY = re.compile(r"(\w+): (\d+) checks, (\d+) failures")
#: Builds in no time; where it is missing, gcc does.
PLAIN = HOSTS["tcc"] if shutil.which("tcc") else Host(("gcc", "-std=c99", "-O0", "-w"))


def passes(host: Host, folder: Path, tmp_path: Path) -> None:
    host.skip_without_tools()
    host.build(folder, tmp_path / "tests")
    ran = host.run(tmp_path / "tests")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    found = SUMMARY.findall(ran.stdout)
    assert {name for name, _, _ in found} == {p.name for p in (folder / "include").iterdir()}
    assert all(int(checks) > 50 and failures == "0" for _, checks, failures in found)


@pytest.mark.parametrize(("model", "scalar", "host"), FEW)
def test_passes(model: str, scalar: str, host: str, bundle: Exported, tmp_path: Path) -> None:
    passes(HOSTS[host], bundle(model, scalar), tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize(("model", "scalar"), EVERYTHING)
def test_passes_for_all(
    host: str, model: str, scalar: str, bundle: Exported, tmp_path: Path
) -> None:
    passes(HOSTS[host], bundle(model, scalar), tmp_path)


def reaches_everything(folder: Path) -> None:
    if not coverage.available():
        pytest.skip("needs clang-19 and llvm-19")
    found = coverage.measure(folder)
    assert [file for file in found.files if not file.is_complete] == []
    assert found.is_complete
    assert {Path(file.path).suffix for file in found.files} == {".c", ".h"}
    assert found.total.conditions.total > 40 and found.total.branches.total > 150


@pytest.mark.parametrize(("model", "scalar"), REACHED)
def test_reaches_everything(model: str, scalar: str, bundle: Exported) -> None:
    reaches_everything(bundle(model, scalar))


@pytest.mark.slow
@pytest.mark.parametrize(("model", "scalar"), [pair for pair in EVERYTHING if pair not in REACHED])
def test_reaches_everything_for_all(model: str, scalar: str, bundle: Exported) -> None:
    reaches_everything(bundle(model, scalar))


def test_coverage_sees_what_is_not_reached(bundle: Exported, tmp_path: Path) -> None:
    if not coverage.available():
        pytest.skip("needs clang-19 and llvm-19")
    folder = copied(bundle("reference_relative", "float"), tmp_path)
    cases = folder / "test" / "reference_relative_f32_checks.h"
    text = cases.read_text()
    call = "test_reference_relative_f32_call_cases(f, &f->entry[k]);"
    assert call in text
    cases.write_text(text.replace(call, f"(void){call.partition('(')[0]};"))
    found = coverage.measure(folder)
    total = found.total
    assert not found.is_complete and not total.branches.is_complete
    assert not total.conditions.is_complete and total.conditions.percent < 60.0


def test_coverage_of_failing_tests(bundle: Exported, tmp_path: Path) -> None:
    if not coverage.available():
        pytest.skip("needs clang-19 and llvm-19")
    folder = copied(bundle("reference_relative", "float"), tmp_path)
    broken(folder, "src/reference_relative_f32_retract_kernel.h", r" \+ ", " - ")
    with pytest.raises(ProofError, match="FAILED reference_relative_f32_retract"):
        coverage.measure(folder)


def copied(folder: Path, tmp_path: Path) -> Path:
    shutil.copytree(folder, tmp_path / "copy")
    return tmp_path / "copy"


def broken(folder: Path, path: str, pattern: str, by: str) -> None:
    """Change the first place in a file that a pattern matches."""
    file = folder / path
    text, count = re.subn(pattern, by, file.read_text(), count=1, flags=re.DOTALL)
    assert count == 1, pattern
    file.write_text(text)


MISTAKES = {
    "sign in a kernel": (
        "rover_f32_gps_kernel.h",
        r"\(in->antenna_y \* attitude_01\) \+",
        "(in->antenna_y * attitude_01) -",
    ),
    "coefficient of a series": ("rover_f32_retract_kernel.h", r"- 0\.0208", "+ 0.0208"),
    "series of a logarithm": (
        "rover_f32_local_kernel.h",
        r"(attitude_log_series = 1\.0F \+ \(attitude_log_tangent_squared) \*",
        r"\1 /",
    ),
    "index of an input": (
        "rover_f32_gps_kernel.h",
        r"antenna_y = x\[17\]",
        "antenna_y = x[16]",
    ),
    "bound, by its last place": (
        "rover_f32_gps_kernel.h",
        r"(in->antenna_z), 10\.0F",
        r"\1, 9.999999F",
    ),
    "norm is not looked at": (
        "rover_f32_gps_kernel.h",
        r"skewed \|= bounded \?",
        "skewed |= true ?",
    ),
    "element of a run is forgotten": (
        "rover_f32_check.h",
        r"is_centred\(b, bound\) && (is_centred\(c)",
        r"\1",
    ),
    "range of a call is forgotten": (
        "rover_f32_gps_kernel.h",
        r"inside = inside && are_three_centred\([^;]*;\n",
        "",
    ),
    "range is forgotten": (
        "rover_range_kernel.h",
        r"outside \|= (read_value\(troposphere)",
        r"(void)\1",
    ),
    "geometry is not looked at": (
        "rover_range_kernel.h",
        r"range_squared_ok \? \(rover_flag_t\)ROVER_OK : \(rover_flag_t\)ROVER_DOMAIN",
        "(rover_flag_t)ROVER_OK",
    ),
    "wrong status": (
        "rover_range_kernel.h",
        r"\(rover_flag_t\)ROVER_RANGE \* outside",
        "(rover_flag_t)ROVER_DOMAIN * outside",
    ),
    "pointer": ("rover_f32_imu.c", r"\(dt != NULL\) &&\s+", ""),
    "count": ("rover_range.c", r"n <= ROVER_RANGE_MAX_ITEMS", "n <= (ROVER_RANGE_MAX_ITEMS + 1)"),
    "bad item is not cleared": (
        "rover_range.c",
        r"\n +range_clear_residual\(&residual\[i\]\);",
        "",
    ),
    "bad item passes": ("rover_range.c", r"status = ROVER_PARTIAL;", ""),
    "one item too few": ("rover_range.c", r"lane < count", "lane < (count - 1)"),
    "stride": ("rover_f32_gps.c", r"nonzeros\[3 \* stride\] = ", "nonzeros[4 * stride] = "),
    "place": (
        "rover_f32_gps.c",
        r"dense\[7\] = nonzeros\[2 \* stride\]",
        "dense[7] = nonzeros[3 * stride]",
    ),
    "structural zero": ("rover_f32_gps.c", r"dense\[9\] = 0\.0F", "dense[9] = 1.0e-30F"),
    "outputs of a refused call": (
        "rover_f32_gps.c",
        r"(status = ROVER_F32_NULL;\n)",
        r"\1    if (value != NULL) { value[0] = 0.0F; }\n",
    ),
    "column table": (
        "../include/rover_f32/rover_f32.h",
        r"columns\[21\] = \{\n    0, 6",
        "columns[21] = {\n    0, 5",
    ),
    "constant": ("rover_range_kernel.h", r"299792458\.0", "299792458.5"),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_finds(mistake: str, bundle: Exported, tmp_path: Path) -> None:
    PLAIN.skip_without_tools()
    folder = copied(bundle("rover", "float"), tmp_path)
    path, pattern, by = MISTAKES[mistake]
    broken(folder, f"src/{path}", pattern, by)
    PLAIN.build(folder, tmp_path / "tests")
    ran = PLAIN.run(tmp_path / "tests")
    # A null pointer that is not looked at ends the program.
    assert ran.returncode == (-11 if mistake == "pointer" else 1), ran.stdout


BORDER_MISTAKES = {
    "bound": ("rover_gps_check.c", r"(x\[18\]), 10\.0", r"\1, 9.99999999999"),
    "norm is not looked at": ("rover_gps_check.c", r"skewed \|= bounded \?", "skewed |= true ?"),
    "item is not looked at": ("rover_range_check.c", r"item_status\[i\] = \(uint8_t\)loaded;", ""),
    "bad item passes": ("rover_range_check.c", r"failed \|= loaded", "failed |= 0U"),
    "count": (
        "rover_range_check.c",
        r"n <= ROVER_RANGE_MAX_ITEMS",
        "n <= ROVER_RANGE_MAX_ITEMS + 1",
    ),
    "integer is not looked at": (
        "rover_range_kernel.h",
        r"outside \|= take_index",
        "(void)take_index",
    ),
    "geometry is not looked at": (
        "rover_range_kernel.h",
        r"range_squared_ok \? \(rover_flag_t\)ROVER_OK : \(rover_flag_t\)ROVER_DOMAIN",
        "(rover_flag_t)ROVER_OK",
    ),
}


@pytest.mark.parametrize("mistake", BORDER_MISTAKES)
def test_finds_at_the_border(mistake: str, bundle: Exported, tmp_path: Path) -> None:
    PLAIN.skip_without_tools()
    folder = copied(bundle(*OUTER), tmp_path)
    path, pattern, by = BORDER_MISTAKES[mistake]
    broken(folder, f"src/{path}", pattern, by)
    PLAIN.build(folder, tmp_path / "tests")
    assert PLAIN.run(tmp_path / "tests").returncode == 1


DIFFERENCE_MISTAKES = {
    "sign of the reference": (r"- reference\[0\]", "+ reference[0]"),
    "row of the differences": (r"\(i < reference\) \? i : \(i - 1\)", "i"),
    "index of the reference": (r"reference >= n", "reference > n"),
    "matrix": (r"\? -1\.0 : 0\.0", "? 1.0 : 0.0"),
    "variance of the reference": (r"common \+ own", "own"),
    "deviation is not looked at": (r"outside \|= take_value\(sigma", "(void)take_value(sigma"),
}


@pytest.mark.parametrize("mistake", DIFFERENCE_MISTAKES)
def test_finds_in_differences(mistake: str, bundle: Exported, tmp_path: Path) -> None:
    PLAIN.skip_without_tools()
    folder = copied(bundle("farrell_tightly_coupled", "double"), tmp_path)
    broken(folder, "src/farrell_tightly_coupled_pseudorange.c", *DIFFERENCE_MISTAKES[mistake])
    PLAIN.build(folder, tmp_path / "tests")
    assert PLAIN.run(tmp_path / "tests").returncode == 1


def test_vectors_of_another_layout_do_not_compile(bundle: Exported, tmp_path: Path) -> None:
    PLAIN.skip_without_tools()
    folder = copied(bundle("reference_relative", "float"), tmp_path)
    header = "include/reference_relative_f32/reference_relative_f32_types.h"
    broken(folder, header, r"(LAYOUT_DIGEST 0x)\w+U", r"\g<1>12345678U")
    with pytest.raises(AssertionError, match="another state layout"):
        PLAIN.build(folder, tmp_path / "tests")


def test_is_c_alone(bundle: Exported) -> None:
    folder = bundle("rover", "float")
    text = (folder / "test" / "test_rover_f32.c").read_text()
    assert "int main(void)" in text
    everything = "".join(path.read_text() for path in (folder / "test").glob("*.[ch]"))
    for word in ("malloc", "fopen", "argv", "time("):
        assert word not in everything


def test_passes_where_a_guard_is_shared_by_all_items(tmp_path: Path) -> None:
    """A quaternion that is normalised here may be anything but zero."""
    spec = from_table(
        {
            "name": "shared",
            "frame": [{"name": "e", "axes": "ecef"}, {"name": "b", "axes": "free"}],
            "state": [
                {"name": "place", "kind": "vector", "size": 3, "unit": "m", "frame": "e"},
                {"name": "posture", "kind": "rotation", "maps": "b -> e", "normalise": True},
            ],
            "measurement": [
                {
                    "name": "ranges",
                    "model": "pseudorange",
                    "position": "place",
                    "attitude": "posture",
                    "lever_arm": [0.3, -0.2, 1.1],
                    "satellite_position": "input",
                    "sagnac": "none",
                    "items": "skip",
                    "maximum": 20,
                }
            ],
        },
        "shared",
    )
    pipeline.export(spec, tmp_path / "bundle")
    golden = (tmp_path / "bundle" / "test" / "shared_golden.h").read_text()
    assert re.search(r"ranges_shared\[\d+\] = \{\n    (0U, )+3U", golden)
    passes(PLAIN, tmp_path / "bundle", tmp_path)
