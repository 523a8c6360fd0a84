"""What a bundle says about its rounding errors, and the tolerance that refuses."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

from symnav import ir, pipeline
from symnav.cli import main
from symnav.emit.c.rounding import rounding_text, upwards
from symnav.errors import InputError
from symnav.export import Tolerance
from symnav.spec import loads
from symnav.spec.records import Spec

NARROW = """
name = "lander"
[[frame]]
name = "n"
axes = "ned"
[[state]]
name = "position"
kind = "vector"
size = 3
unit = "m"
frame = "n"
range = [-1000.0, 1000.0]
[[state]]
name = "attitude"
kind = "rotation"
maps = "b -> n"
[[measurement]]
name = "gps"
model = "gnss_position"
position = "position"
attitude = "attitude"
lever_arm = [0.5, 0.0, -0.2]
"""


def exported(model: str, folder: Path, scalar: str) -> tuple[dict[str, Any], str]:
    """The record of the bounds, and the text of every header."""
    pipeline.export(pipeline.load(model), folder, scalar=scalar)
    record = json.loads((folder / "proof" / "error_bounds.json").read_text())
    headers = "\n".join(p.read_text() for p in sorted(folder.glob("include/*/*.h")))
    return record, " ".join(re.sub(r"\n \*", " ", headers).split())


def output_of(record: dict[str, Any], function: str, output: str) -> dict[str, Any]:
    found = [
        out
        for tree in record["trees"]
        for one in tree["functions"]
        if one["function"] == function
        for out in one["outputs"]
        if out["output"] == output
    ]
    assert len(found) == 1
    return dict(found[0])


def test_guards_that_refuse_everything_are_named(tmp_path: Path) -> None:
    """Of a vector too short for its direction, whatever it is inside its range."""
    text = NARROW.replace("[-1000.0, 1000.0]", "[1e-30, 2e-30]")
    text += '[[measurement]]\nname = "length"\nequation = ["norm(position)"]\n'
    (tmp_path / "lander.toml").write_text(text)
    words = ["export", str(tmp_path / "lander.toml"), "--to", str(tmp_path / "out")]
    for scalar in ("double", "float"):
        result = CliRunner().invoke(main, [*words, "--scalar", scalar])
        assert result.exit_code == 2 and not (tmp_path / "out").exists()
        assert "length: nothing inside the declared ranges" in result.output
        assert "squared length in [1e-12, 1e+30]" in result.output


def test_record_and_header_say_the_same(tmp_path: Path) -> None:
    record, header = exported("rover", tmp_path, "float")
    position = output_of(record, "rover_f32_gps", "value")
    assert position["unit"] == "m" and 0.0039 < position["bound"] < 0.004
    assert f"rounding error at most {upwards(position['bound'])} m over the declared" in header
    jacobian = output_of(record, "rover_f32_gps", "jacobian")
    worst = upwards(jacobian["bound"])
    assert f"by row; rounding error at most {worst} in any element over the declared" in header
    assert len(jacobian["elements"]) == 21
    assert max(e["bound"] for e in jacobian["elements"]) == jacobian["bound"]
    labels = [element["element"] for element in jacobian["elements"]]
    assert labels[:2] == ["value x, position x", "value x, attitude x"]
    assert [tree["type"] for tree in record["trees"]] == ["float", "double"]
    assert output_of(record, "rover_range", "value")["bound"] < 1e-6
    assert any("nearest" in text for text in record["assumptions"])


def test_units_of_a_state_are_told_apart(tmp_path: Path) -> None:
    record, header = exported("rover", tmp_path, "double")
    elements = output_of(record, "rover_local", "value")["elements"]
    units = {element["element"]: element["unit"] for element in elements}
    assert units["position x"] == "m" and units["attitude z"] == "rad"
    jump = next(e for e in elements if e["element"] == "attitude x")
    assert jump["bound"] > 6.28 and jump["bound_where_decisions_agree"] < 1e-13
    assert "rad (6.3 rad where rounding decides a comparison) in attitude" in header


def test_differences_of_rows_have_bounds_of_their_own(tmp_path: Path) -> None:
    record, header = exported("farrell_tightly_coupled", tmp_path, "double")
    row = output_of(record, "farrell_tightly_coupled_pseudorange", "value")["bound"]
    said = re.findall(r"value +\[n - 1\] m: [^;]*; rounding error at most (\S+) m", header)
    assert said and all(2.0 * row < float(number) < 3.0 * row for number in said)


def test_packages_say_nothing_about_rounding(tmp_path: Path) -> None:
    package = pipeline.generate(pipeline.load("rover"), tmp_path).package
    header = (package / "c" / "include" / "rover" / "rover.h").read_text()
    assert "rounding error" not in header


def test_every_output_of_every_bundle_is_recorded(tmp_path: Path) -> None:
    for model in ("reference_relative", "warpos_gps"):
        record, _ = exported(model, tmp_path / model, "double")
        for tree in record["trees"]:
            for function in tree["functions"]:
                assert function["outputs"]
                for output in function["outputs"]:
                    assert output["bound"] is not None and math.isfinite(output["bound"])


def run(*arguments: str) -> Any:
    return CliRunner().invoke(main, ["export", *arguments])


def test_tolerance_names_every_value_beyond_it_and_writes_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "bundle"
    result = run("rover", "--to", str(folder), "--scalar", "float", "--tolerance", "0.001")
    assert result.exit_code == 2
    assert not folder.exists()
    text = " ".join(result.output.split())
    assert "rover_f32_gps, value: 0.004 m" in text
    assert "rover_f32_imu, value: " in text and "m/s^2" in text
    for remedy in ("narrower ranges", "range in [[state]] and [[input]]", "export in double"):
        assert remedy in text
    # There is no relative form of either equation.
    assert "relative form" not in text
    # Jacobians, and what the user has no say in, do not count; the range is in double.
    assert "jacobian" not in text and "retract" not in text and "rover_range" not in text


def test_tolerance_names_what_has_no_range(tmp_path: Path) -> None:
    result = run(
        "ekf_cal_gps", "--to", str(tmp_path / "a"), "--scalar", "float", "--tolerance", "1"
    )
    assert result.exit_code == 2
    text = " ".join(result.output.split())
    wide = "(measured may be as large as 1e+09; declare a narrower range in [[input]])"
    assert f"ekf_cal_gps_f32_gps, residual: 33 m {wide}" in text
    assert "gps, value" not in text


def refused(spec: Spec, scalar: str, number: float) -> tuple[dict[str, str], str]:
    """What the refusal says of each value of the measurement ``range``, and its advice."""
    with pytest.raises(InputError) as caught:
        pipeline.bundle(spec, scalar, Tolerance(None, {"range": number}))
    head, *lines, advice = str(caught.value).splitlines()
    assert head.startswith("rounding may move")
    return dict(line.split(", ", 1)[1].split(": ", 1) for line in lines), advice


def test_hints_name_what_the_value_reads() -> None:
    """The measured value is no business of the predicted one."""
    text = (pipeline._models() / "reference_relative.toml").read_text(encoding="utf-8")
    said, _ = refused(loads(text.replace("range = [-2e5, 2e5]", "range = [-1e9, 1e9]")), "float", 1)
    assert list(said) == ["residual"] and "measured may be as large as 1e+09" in said["residual"]
    wide = text.replace("range = [-4.6e7, 4.6e7]", "range = [-1e8, 1e8]")
    said, _ = refused(loads(wide.replace("range = [1.7e7,", "range = [1e3,")), "float", 1e-9)
    hint = "(satellite_difference, satellite_xy may be as large as 1e+08; declare a narrower range"
    assert hint in said["value"] and "measured" not in said["value"]
    wide = text.replace("range = [-3e4, 3e4]", "range = [-1e8, 1e8]")
    said, _ = refused(loads(wide), "float", 1e-9)
    hint = "(position may be as large as 1e+08; declare a narrower range in [[state]])"
    assert said["value"].endswith(hint)


def test_what_helps_depends_on_what_is_refused() -> None:
    """Only a plain pseudorange has a relative form; double is no way out of double."""
    said, advice = refused(pipeline.load("reference_relative"), "float", 1e-9)
    assert said["value"] == "0.2 m above 1e-09 m"
    assert "relative form" not in advice and "export in double" in advice
    assert "(range in [[state]] and [[input]])" in advice
    said, advice = refused(pipeline.load("rover"), "double", 1e-12)
    assert "the relative form of an equation (pseudorange_relative)" in advice
    assert "export in double" not in advice


def test_a_tolerance_that_is_kept_changes_nothing(tmp_path: Path) -> None:
    spec = tmp_path / "lander.toml"
    spec.write_text(NARROW)
    result = run(str(spec), "--to", str(tmp_path / "a"), "--scalar", "float", "--tolerance", "1e-4")
    assert result.exit_code == 0, result.output
    again = run(str(spec), "--to", str(tmp_path / "b"), "--scalar", "float")
    assert again.exit_code == 0
    told = {
        "README.md",
        "manifest.json",
        "sbom.spdx.json",
    }  # the command, and digests of what says it
    for path in (tmp_path / "a").rglob("*"):
        if path.is_file() and path.name not in told:
            assert (
                path.read_bytes()
                == (tmp_path / "b" / path.relative_to(tmp_path / "a")).read_bytes()
            )
    refused = run(
        str(spec), "--to", str(tmp_path / "c"), "--scalar", "float", "--tolerance", "1e-5"
    )
    assert refused.exit_code == 2 and not (tmp_path / "c").exists()


def test_a_tolerance_of_one_function_is_its_own(tmp_path: Path) -> None:
    arguments = ("rover", "--to", str(tmp_path / "a"), "--scalar", "float", "--tolerance")
    refused = run(*arguments, "0.01", "--tolerance", "imu=50")
    assert refused.exit_code == 2 and not (tmp_path / "a").exists()
    text = " ".join(refused.output.split())
    assert "more than its tolerance: rover_f32_imu, value: 52 m/s^2 above 50 m/s^2" in text
    done = run(*arguments, "imu=60", "--tolerance", "0.01")
    assert done.exit_code == 0, done.output
    chosen = json.loads((tmp_path / "a/manifest.json").read_text())["options"]
    assert chosen["tolerance"] == ["0.01", "imu=60.0"]
    assert "--tolerance 0.01 --tolerance imu=60.0" in (tmp_path / "a/README.md").read_text()


def test_functions_without_a_tolerance_may_err(tmp_path: Path) -> None:
    arguments = ("rover", "--to", str(tmp_path / "a"), "--scalar", "float", "--tolerance")
    assert run(*arguments, "gps=0.01").exit_code == 0
    assert run(*arguments, "gps=0.001").exit_code == 2


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("nan",), "finite number above 0"),
        (("inf",), "finite number above 0"),
        (("0",), "finite number above 0"),
        (("-1",), "finite number above 0"),
        (("gps=nan",), "the tolerance of gps is nan"),
        (("gps=-inf",), "the tolerance of gps is -inf"),
        (("gps",), "neither a number nor FUNCTION=NUMBER"),
        (("gps=",), "neither a number nor FUNCTION=NUMBER"),
        (("=1",), "names no function"),
        (("1", "2"), "is given twice"),
        (("gps=1", "gps=2"), "gps is given twice"),
        (("gsp=1",), "did you mean 'gps'?"),
        (("retract=1",), "choose 'gps', 'range' or 'imu'"),
    ],
    ids=" ".join,
)
def test_what_is_no_tolerance_is_refused_at_once(
    words: tuple[str, ...], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pipeline, "derive", None)
    options = [part for word in words for part in ("--tolerance", word)]
    refused = run("rover", "--to", str(tmp_path / "a"), *options)
    assert refused.exit_code == 2, refused.output
    assert said in " ".join(refused.output.replace("│", " ").split())
    assert not (tmp_path / "a").exists()


def test_a_tolerance_in_python_is_checked_as_well(tmp_path: Path) -> None:
    for number in (math.nan, math.inf, 0.0):
        with pytest.raises(InputError, match="finite number above 0"):
            pipeline.export(pipeline.load("rover"), tmp_path / "a", tolerance=number)
    assert Tolerance.read(("imu=60", "0.01")).words == ("0.01", "imu=60.0")
    assert Tolerance.read(Tolerance(1e-9, {"a": 1e300}).words) == Tolerance(1e-9, {"a": 1e300})


def test_a_refused_export_leaves_an_older_bundle_alone(tmp_path: Path) -> None:
    spec = pipeline.load("rover")
    pipeline.export(spec, tmp_path, scalar="float")
    before = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()}
    with pytest.raises(InputError, match="tolerance of 1e-06"):
        pipeline.export(spec, tmp_path, scalar="float", tolerance=1e-6)
    assert {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()} == before


@settings(max_examples=100, deadline=None)
@given(st.floats(1e-300, 1e300), st.integers(1, 4))
def test_printed_bounds_are_never_smaller(value: float, digits: int) -> None:
    shown = float(upwards(value, digits))
    assert value <= shown <= value * (1.0 + 10.0 ** (1 - digits) * 1.001)


def test_text_of_special_cases() -> None:
    def output(*rounding: ir.Rounding, name: str = "value") -> ir.Output:
        entries = tuple(ir.Entry((k,), ir.Number(0.0)) for k in range(len(rounding)))
        rows = (ir.Section("value", 0, len(rounding), "m", ("",) * len(rounding)),)
        shape = (len(rounding),)
        return ir.Output(name, shape, False, entries, rows, (), "m", "", "", rounding)

    assert rounding_text(output(), 0.5) == ""
    assert rounding_text(output(ir.Rounding(0.0, 0.0, 1.0)), 0.5) == "free of rounding errors"
    unbounded = rounding_text(output(ir.Rounding(math.inf, math.inf, 1.0)), 0.5)
    assert "(no bound)" in unbounded
    jump = rounding_text(output(ir.Rounding(5.0, 0.0, 5.0)), 0.5)
    assert jump.startswith("rounding error at most 0 m (5 m where rounding decides")
