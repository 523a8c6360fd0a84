"""What single precision cannot hold is a mistake of the specification, for every way to ask."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from symnav import pipeline
from symnav.cli import main
from symnav.errors import SpecError
from symnav.spec import loads

SPEC = """
name = "tiny"
{scalars}
[[frame]]
name = "n"
axes = "ned"
[[frame]]
name = "b"
axes = "free"
[[state]]
name = "position"
kind = "vector"
size = 3
unit = "m"
frame = "n"
range = {state}
[[state]]
name = "attitude"
kind = "rotation"
maps = "b -> n"
[[input]]
name = "height"
unit = "m"
range = {input}
[[measurement]]
name = "pos"
model = "gnss_position"
position = "position"
attitude = "attitude"
lever_arm = {arm}
[[measurement]]
name = "above"
{only}
equation = ["height - position[2] * {factor}"]
"""


def text(
    state: str = "[-1e4, 1e4]",
    given: str = "[0.0, 1e4]",
    arm: str = "[0.0, 0.1, -0.3]",
    factor: str = "1.0",
    scalars: str = "",
    only: str = "",
) -> str:
    """A specification with one thing that may be lost."""
    return SPEC.format(state=state, input=given, arm=arm, factor=factor, scalars=scalars, only=only)


def refusal(spec: str) -> str:
    """What the bundle in single precision says."""
    with pytest.raises(SpecError) as caught:
        pipeline.bundle(loads(spec), "float")
    return str(caught.value)


@pytest.mark.parametrize(
    ("declared", "said"),
    [
        ("[1e-50, 2e-50]", "[1e-50, 2e-50] of x, y, z holds no number"),
        ("[-2e-50, -1e-50]", "holds no number"),
        ("[16777216.2, 16777216.8]", "[16777216.2, 16777216.8] of x, y, z holds no number"),
        ("[0.1, 0.10000000001]", "holds no number"),
        ("[0.0, 1e-46]", "holds only one number of single precision, 0; widen"),
        ("[16777216.0, 16777217.9]", "holds only one number of single precision, 16777216; "),
        ("[-1e39, 1e39]", "[-1e+39, 1e+39] of x, y, z reaches beyond the largest number"),
        ("[-1e39, 1e39]", "3.40282e+38; narrow the range"),
    ],
)
def test_ranges_of_states(declared: str, said: str) -> None:
    """The block, its range, its elements, and that it is about single precision."""
    told = refusal(text(declared))
    assert told.startswith("tiny in single precision (float): 1 problem\n")
    assert "  state position.range: " in told and said in told
    assert told.endswith("rescale the quantity or use double")


def test_ranges_of_inputs_and_elements() -> None:
    """Each element on its own, states and inputs together."""
    told = refusal(text("[[0.0, 1.0], [0.0, 1.0], [5e-60, 6e-60]]", "[0.3, 0.30000000001]"))
    assert "tiny in single precision (float): 2 problems" in told
    assert "state position.range: [5e-60, 6e-60] of z holds no number" in told
    assert "input height.range: [0.3, 0.30000000001] holds no number" in told


@pytest.mark.parametrize(
    ("element", "said"),
    [
        ("1e-60", "the constant 1e-60 would become zero"),
        ("-1e-40", "the constant -1e-40 would lose digits"),
        ("1e39", "the constant 1e+39 is beyond the largest number of single precision"),
    ],
)
def test_constants(element: str, said: str) -> None:
    """The quantity and the element; said once, not of the arithmetic as well."""
    told = refusal(text(arm=f"[0.0, {element}, 0.1]"))
    assert "tiny in single precision (float): 1 problem" in told
    assert f"  measurement pos.lever_arm[1]: {said}" in told
    assert told.endswith("; rescale the quantity or use double")


@pytest.mark.parametrize(("factor", "said"), [("1e-60", "become zero"), ("1e-39", "lose digits")])
def test_numbers_of_equations(factor: str, said: str) -> None:
    """What a user's equation says is lost the same way."""
    told = refusal(text(factor=factor))
    assert "measurement above: the number " in told and said in told


@pytest.mark.parametrize(
    "declared",
    [
        "[1e-300, 1.0]",  # anything above zero
        "[16777216.0, 16777218.0]",
        "[-3.4028235e38, 0.0]",  # the largest float as people write it
    ],
)
def test_ranges_that_survive(declared: str) -> None:
    """Ends need not be numbers of the type, as long as there is something between them."""
    spec = loads(text(given=declared))
    assert pipeline.bundle(spec, "float").trees[0].module.scalar.value == "float"


def test_double_holds_them_all() -> None:
    """Nothing is refused where nothing is lost: in double, or in a function that stays double."""
    narrow = text(given="[1e-50, 2e-50]", factor="1e-60")
    assert pipeline.bundle(loads(narrow), "double").trees
    kept = text(given="[1e-50, 2e-50]", factor="1e-60", scalars='scalars = ["double", "float"]',
                only='scalar = "double"')  # fmt: skip
    spec = loads(kept)
    assert pipeline.emit(spec, pipeline.derive(spec))


def test_both_verbs_refuse_before_anything_is_written(tmp_path: Path) -> None:
    """Exit code 2, one message, no folder, no warning."""
    file = tmp_path / "tiny.toml"
    file.write_text(text("[-1e39, 1e39]", scalars='scalars = ["double", "float"]'))
    folder = str(tmp_path / "out")
    for words in (
        ["export", str(file), "--to", folder, "--scalar", "float"],
        ["generate", str(file), "--out", folder],
    ):
        result = CliRunner().invoke(main, words)
        assert result.exit_code == 2, result.output
        said = " ".join(result.output.split())
        assert "state position.range: [-1e+39, 1e+39] of x, y, z" in said
        assert not Path(folder).exists()
