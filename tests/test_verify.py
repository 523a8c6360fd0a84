"""What ``symnav verify`` says and how it ends, on specifications that are easy and on hard ones."""

from __future__ import annotations

import json
import stat
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from symnav import ir
from symnav.cli import main
from symnav.emit import c

SMALL = """
name = "small"
[[state]]
name = "bias"
kind = "scalar"
unit = "m"
range = [-10.0, 10.0]
[[measurement]]
name = "twice"
equation = ["2.0 * bias"]
"""

Verify = Callable[..., Result]


@pytest.fixture
def verify(tmp_path: Path) -> Verify:
    """Verifies the text of a specification by the command line, in this process."""

    def run(text: str, *words: str) -> Result:
        path = tmp_path / "spec.toml"
        path.write_text(text, encoding="utf-8")
        return CliRunner().invoke(main, ["verify", str(path), *words])

    return run


class TestCompiler:
    """Only a compiler that is not there may be passed over."""

    def test_refused_c_is_no_proof(
        self, verify: Verify, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        """NumPy alone would pass; what the compiler says is told."""
        compiler = tmp_path / "refusing"
        compiler.write_text('#!/bin/sh\necho "rows.c:7:1: error: no such thing" >&2\nexit 1\n')
        compiler.chmod(compiler.stat().st_mode | stat.S_IXUSR)
        monkeypatch.setenv("CC", str(compiler))
        shown = verify(SMALL, "--samples", "8")
        assert shown.exit_code == 3, shown.output
        assert "FAIL" in shown.stdout and "rows.c:7:1: error: no such thing" in shown.stdout
        told = verify(SMALL, "--samples", "8", "--json")
        assert told.exit_code == 3
        assert any("no such thing" in text for text in json.loads(told.stdout)["failures"])

    def test_no_compiler_is_a_note(self, verify: Verify, monkeypatch: pytest.MonkeyPatch) -> None:
        """NumPy is proven, and the sheet says what was not."""
        monkeypatch.delenv("CC", raising=False)
        monkeypatch.setenv("PATH", "")
        told = verify(SMALL, "--samples", "8", "--json")
        assert told.exit_code == 0, told.output
        sheet = json.loads(told.stdout)
        assert any("native was not available" in note for note in sheet["notes"])
        assert {row["comparison"].split()[0] for row in sheet["rows"]} == {"numpy"}


def test_the_sheet_says_how_many_states_were_judged(verify: Verify) -> None:
    """By function, in text and in JSON; four edges of one number, and eight others."""
    sheet = json.loads(verify(SMALL, "--samples", "20", "--json").stdout)
    assert sheet["judged"] == {"twice": 12}
    shown = verify(SMALL, "--samples", "20")
    assert "States judged with 50 digits" in shown.stdout and "twice 12" in shown.stdout
    told = " ".join(CliRunner().invoke(main, ["verify", "--help"]).stdout.split())
    assert "With 50 digits, at one state for every edge and at eight others" in told


VECTOR = """
name = "vectors"
[[state]]
name = "p"
kind = "vector"
size = 3
unit = "m^2"
range = [{low}, {high}]
[[measurement]]
name = "f"
equation = ["{equation}"]
{more}
"""


class TestDomain:
    """Equations that have no value in parts of the declared ranges, or in all of them."""

    @pytest.mark.parametrize("equation", ["norm(p - p)", "acos(dot(p, p) / (norm(p) * norm(p)))"])
    def test_nowhere_inside(self, verify: Verify, equation: str) -> None:
        """Nothing was compared, so nothing is proven; no traceback."""
        told = verify(
            VECTOR.format(low=-1e3, high=1e3, equation=equation, more=""),
            "--samples",
            "8",
            "--json",
        )
        assert told.exit_code == 3, told.output
        (failure,) = json.loads(told.stdout)["failures"]
        assert "no state inside the declared ranges could be evaluated" in failure

    def test_without_guards(self, verify: Verify) -> None:
        """The proof stays where the equation has a value and says that the code does not look."""
        text = VECTOR.format(low=-1e3, high=1e3, equation="sqrt(p[0])", more='guards = "assume"')
        told = verify(text, "--samples", "40", "--json")
        assert told.exit_code == 0, told.output
        sheet = json.loads(told.stdout)
        assert any("f leaves its guards out" in note for note in sheet["notes"])
        assert 0 < sheet["judged"]["f"] < 40

    def test_the_widest_range(self, verify: Verify) -> None:
        """Almost every double; a difference beside 1e308 needs digits for both."""
        text = VECTOR.format(low="-1e308", high="1e308", equation="p[0]", more="")
        assert verify(text, "--samples", "40").exit_code == 0


RAW = """
name = "raw"
[[frame]]
name = "n"
axes = "ned"
[[frame]]
name = "b"
axes = "free"
[[state]]
name = "place"
kind = "vector"
size = 3
unit = "m"
frame = "n"
range = [-1e4, 1e4]
[[state]]
name = "posture"
kind = "rotation"
maps = "b -> n"
error = "storage"
[[state]]
name = "antenna"
kind = "vector"
size = 3
unit = "m"
frame = "b"
error_frame = "n"
range = [-5.0, 5.0]
[[measurement]]
name = "fix"
model = "gnss_position"
position = "place"
attitude = "posture"
lever_arm = "antenna"
"""


@pytest.mark.parametrize("seed", ["1", "8"])
def test_a_product_that_is_almost_the_identity(verify: Verify, seed: str) -> None:
    """Sums that cancel are known to the rounding of what they add up."""
    told = verify(RAW, "--seed", seed, "--json")
    assert told.exit_code == 0, json.loads(told.stdout)["failures"]


GEODETIC = """
name = "earthly"
[[frame]]
name = "e"
axes = "ecef"
[[frame]]
name = "n"
axes = "{axes}"
[[frame]]
name = "b"
axes = "free"
[[state]]
name = "place"
kind = "geodetic"
frame = "e"
error_frame = "n"
range = [[-1.5, 1.5], [-3.1, 3.1], [-100.0, 10000.0]]
[[state]]
name = "attitude"
kind = "rotation"
maps = "b -> n"
[[measurement]]
name = "fix"
model = "gnss_position"
position = "place"
attitude = "attitude"
lever_arm = "input"
[[measurement]]
name = "range"
model = "pseudorange"
position = "place"
attitude = "attitude"
lever_arm = "input"
satellite_position = "input"
maximum = 8
"""
REFERENCES = Path(__file__).parent / "reference"


class TestReferences:
    """The folder of references, and what they are given."""

    @pytest.mark.parametrize("axes", ["ned", "enu"])
    def test_lever_arm_at_a_geodetic_position(self, verify: Verify, axes: str) -> None:
        """The references find the local-level axes at the position by themselves."""
        told = verify(
            GEODETIC.format(axes=axes), "--samples", "20", "--json", "--reference", str(REFERENCES)
        )
        assert told.exit_code == 0, told.output
        rows = json.loads(told.stdout)["rows"]
        compared = {r["function"] for r in rows if r["comparison"] == "numpy vs reference"}
        assert compared == {"fix", "range"}

    def test_a_folder_without_any(self, verify: Verify, tmp_path: Path) -> None:
        """Said at once: what a reference is, and what it may be called."""
        (tmp_path / "empty").mkdir()
        told = verify(SMALL, "--reference", str(tmp_path / "empty"))
        assert told.exit_code == 2, told.output
        assert "holds no reference" in told.stderr and "gnss_position" in told.stderr

    def test_plain_files_will_do(self, verify: Verify, tmp_path: Path) -> None:
        """No package is asked for; what has no reference is noted."""
        text = "def value(q, options):\n    return {'value': list(q['position']['value'])}\n"
        (tmp_path / "gnss_position.py").write_text(text)
        plain = RAW.replace('lever_arm = "antenna"', 'lever_arm = "none"')
        told = verify(plain, "--samples", "8", "--reference", str(tmp_path), "--json")
        assert told.exit_code == 0, told.output
        assert "numpy vs reference" in {r["comparison"] for r in json.loads(told.stdout)["rows"]}
        noted = verify(SMALL, "--samples", "8", "--reference", str(tmp_path), "--json")
        assert "twice: no reference for equation" in json.loads(noted.stdout)["notes"]


RANGES = """
name = "ranges"
[[frame]]
name = "e"
axes = "ecef"
[[state]]
name = "p"
kind = "vector"
size = 3
unit = "m"
frame = "e"
range = [-7e6, 7e6]
[[state]]
name = "clock"
kind = "scalar"
unit = "m"
range = [-1e6, 1e6]
[[measurement]]
name = "range"
model = "pseudorange"
position = "p"
clock_bias = "clock"
satellite_position = "input"
maximum = {maximum}
difference = "single"
{more}
"""


class TestSingleDifferences:
    """The differenced form is proven where a specification asks for it."""

    @pytest.mark.parametrize("more", ['items = "skip"', 'items = "reject"', 'order = "column"'])
    def test_it_is_compared_with_rows(self, verify: Verify, more: str) -> None:
        """In both back ends, every output, to the last bit."""
        told = verify(RANGES.format(maximum=6, more=more), "--samples", "20", "--json")
        assert told.exit_code == 0, told.output
        rows = [row for row in json.loads(told.stdout)["rows"] if "vs rows" in row["comparison"]]
        found = {(row["comparison"].split()[0], row["block"]) for row in rows}
        assert found >= {(b, o) for b in ("native", "numpy") for o in ("value", "d/d p")}
        assert all(row["samples"] > 40 and row["absolute"] == 0.0 for row in rows)
        shown = verify(RANGES.format(maximum=6, more=more), "--samples", "20").stdout
        assert (
            "Single differences of C and NumPy, against differences of rows: range; 0.00" in shown
        )

    def test_nothing_to_subtract(self, verify: Verify) -> None:
        """One item at most: no rows are left, and none are missed."""
        assert verify(RANGES.format(maximum=1, more=""), "--samples", "8").exit_code == 0

    def test_outside_of_the_domain_nothing_is_proven(self, verify: Verify) -> None:
        """Code without guards has no verdict on items; the proof stays where there is a value."""
        text = RANGES.format(maximum=6, more='guards = "assume"')
        told = verify(text, "--samples", "40", "--json")
        assert told.exit_code == 0, told.output
        assert "outside the domain" in " ".join(json.loads(told.stdout)["notes"])

    @pytest.mark.parametrize(
        ("right", "wrong"),
        [
            ("nonzeros[0] - reference[0]", "nonzeros[0] + reference[0]"),
            ("(i < reference) ? i : (i - 1)", "(i < reference) ? (n - 2) : (i - 1)"),
            ("const int32_t row = ", "const int32_t row = (reference == 1) ? 0 : "),
            ("const int32_t row = ", "const int32_t row = (first > 0) ? 0 : "),
            ("3 * first], &block", "0], &block"),
            (f"{' ' * 24}status = RANGES_PARTIAL;", ""),
            ("item_status[reference] = ", "item_status[reference] = 7; (void)"),
            ("status = (ranges_status_t)item_status[reference];", "status = RANGES_OK;"),
            (
                "    if (status == RANGES_OK) {\n        range_block_t",
                "    {\n        range_block_t",
            ),
            ("   range_clear_value(&value[row]);", ""),
        ],
    )
    def test_what_is_wrong_is_found(
        self, verify: Verify, monkeypatch: pytest.MonkeyPatch, right: str, wrong: str
    ) -> None:
        """C that subtracts otherwise, puts a row elsewhere, or hands on another verdict."""
        emit = c.emit

        def spoiled(module: ir.Module) -> dict[str, str]:
            text = emit(module)
            path = "c/src/ranges_range.c"
            assert right in text[path]
            return {**text, path: text[path].replace(right, wrong)}

        monkeypatch.setattr(c, "emit", spoiled)
        told = verify(RANGES.format(maximum=32, more='items = "skip"'), "--samples", "8", "--json")
        assert told.exit_code == 3, told.output
        failures = json.loads(told.stdout)["failures"]
        assert any("difference" in one for one in failures), failures

    def test_the_status_of_the_whole_is_compared(
        self, verify: Verify, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        """Items agree, but the C does not say that some of them failed."""
        emit = c.emit

        def spoiled(module: ir.Module) -> dict[str, str]:
            text = emit(module)
            return {
                path: one.replace("RANGES_PARTIAL;", "RANGES_OK;") for path, one in text.items()
            }

        monkeypatch.setattr(c, "emit", spoiled)
        told = verify(RANGES.format(maximum=6, more=""), "--samples", "8", "--json")
        assert told.exit_code == 3
        assert "status of native is 0, of numpy 7" in json.loads(told.stdout)["failures"][0]
