"""The demonstration on generated code: as shipped, over another layout, and without a compiler."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from symnav import pipeline
from symnav.cli import main
from symnav.demo import wiring
from symnav.demo.results import DemoResult

SAMPLES = "8"
SHIPPED = Path(pipeline.__file__).parent / "models" / "single_point.toml"


def demo(*words: str) -> dict[str, Any]:
    """Runs the verb in the working directory with few samples and reads its JSON."""
    result = CliRunner().invoke(main, ["demo", *words, "--samples", SAMPLES, "--json"])
    assert result.exit_code in {0, 3}, result.output
    told: dict[str, Any] = json.loads(result.stdout)
    assert told["passed"] is (result.exit_code == 0)
    return told


def median(told: dict[str, Any]) -> float:
    """The median error with all corrections."""
    return float(told["positioning"]["full"]["accuracy"]["median_error_3d"])


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty working directory."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """The demonstration as shipped, run once."""
    return demo("--out", str(tmp_path_factory.mktemp("shipped")))


def test_generated_code_is_the_book(told: dict[str, Any], result: DemoResult) -> None:
    """Generated code reaches what the equations written by hand reach, variant by variant."""
    assert told["passed"]
    assert told["backend"] == "native"
    assert (Path(told["package"]) / "__init__.py").is_file()
    ours = [told["positioning"]["full"], *told["positioning"]["ablations"]]
    for mine, book in zip(ours, (result.full, *result.ablations), strict=True):
        assert book.accuracy is not None
        assert mine["name"] == book.name
        assert mine["accuracy"]["median_error_3d"] == pytest.approx(
            book.accuracy.median_error_3d, abs=1e-4, rel=1e-6
        )


def test_text_ends_with_the_line_of_figures(folder: Path) -> None:
    """The proof sheet, the table and one line that says it all."""
    shown = CliRunner().invoke(main, ["demo", "--samples", SAMPLES])
    assert shown.exit_code == 0, shown.output
    assert shown.stderr == ""
    assert (folder / "generated" / "single_point" / "__init__.py").is_file()
    assert "Proof sheet of single_point: PASS" in shown.stdout
    line = shown.stdout.splitlines()[-1]
    assert line.startswith("real data: 60 of 60 epochs")
    assert all(words in line for words in ("without Sagnac", "without TGD", "without satellite"))


def test_another_layout(folder: Path, told: dict[str, Any]) -> None:
    """Clock first, padding in between, other names, an input under another name: same positions."""
    blocks = SHIPPED.read_text(encoding="utf-8").split("[[state]]\n")
    head, position, rest = blocks
    clock, measurements = rest.split("\n# Satellites", 1)
    padding = 'name = "padding"\nkind = "vector"\nsize = 5\nunit = "1"\nrange = [-1.0, 1.0]\n\n'
    text = "[[state]]\n".join([head, clock, padding, position]) + "\n# Satellites" + measurements
    text = text.replace('name = "single_point"', 'name = "mine"')
    text = text.replace('name = "position"', 'name = "antenna"')
    text = text.replace('position = "position"', 'position = "antenna"')
    text = text.replace('troposphere = "input"', 'troposphere = "wet_and_dry"')
    text += (
        '\n[[input]]\nname = "wet_and_dry"\nkind = "scalar"\nunit = "m"\n'
        "range = [-100.0, 1000.0]\nitem = true\n"
    )
    Path("mine.toml").write_text(text, encoding="utf-8")
    mine = demo("mine.toml", "--out", "elsewhere")
    assert mine["passed"]
    assert (folder / "elsewhere" / "mine").is_dir()
    assert median(mine) == pytest.approx(median(told), abs=1e-6)


def test_without_a_compiler_numpy_does_it(
    folder: Path, told: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same figures from the NumPy back end, and no word of an extension."""
    monkeypatch.setenv("CC", "no-such-compiler")
    bare = demo("--out", "bare")
    assert (bare["backend"], bare["compiled"]) == ("numpy", None)
    assert bare["passed"]
    assert median(bare) == pytest.approx(median(told), abs=1e-6)


def test_a_promise_not_kept_ends_in_three(
    folder: Path, result: DemoResult, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A proof that holds is not enough when the positions are bad."""
    assert result.full.accuracy is not None
    bad = replace(result.full.accuracy, median_error_3d=2.6)
    worse = replace(result, full=replace(result.full, accuracy=bad))
    run: Callable[..., DemoResult] = lambda *_args: worse  # noqa: E731 (a stand-in)
    monkeypatch.setattr(wiring, "run", run)
    shown = CliRunner().invoke(main, ["demo", "--samples", SAMPLES])
    assert shown.exit_code == 3
    assert "promise not kept: the median 3-D error is 2.60 m" in shown.stderr


@pytest.mark.parametrize(
    ("old", "new", "lacking"),
    [
        ('system = "gps"', 'system = "galileo"', "broadcast_orbit for gps"),
        ('sagnac = "none"', 'sagnac = "exact"', "sagnac = 'none'"),
        ('sagnac = "first_order"', 'sagnac = "none"', "with the Sagnac term"),
        ('ionosphere = "input"', 'ionosphere = "none"', "as inputs"),
        ("[-1e8, 1e8]", '[-1e8, 1e8]\nerror_sign = "estimate_minus_true"', "in the state"),
        ('unit = "m"\nrange = [-1e8', 'unit = "s"\nrange = [-1e8', "clock bias in metres"),
    ],
)
def test_what_a_specification_lacks(folder: Path, old: str, new: str, lacking: str) -> None:
    """Each condition of positioning is named before anything is generated."""
    text = SHIPPED.read_text(encoding="utf-8")
    assert old in text
    Path("mine.toml").write_text(text.replace(old, new), encoding="utf-8")
    refused = CliRunner().invoke(main, ["demo", "mine.toml"])
    assert refused.exit_code == 2
    assert "the demonstration lacks" in refused.stderr
    assert lacking in refused.stderr
    assert [path.name for path in folder.iterdir()] == ["mine.toml"]
