"""Valid specifications: what defaults, implied inputs and frames come out as."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from symnav.blocks import GeodeticBlock, HeadingBlock, RotationBlock, VectorBlock
from symnav.derive import derive
from symnav.errors import InputError, SpecError
from symnav.spec import Spec, from_table, load, loads
from symnav.spec.declarations import HALF_TURN
from symnav.spec.records import BySlot, BySystem, ToConstant, ToInput, ToState

VALID = Path(__file__).parents[1] / "data" / "valid"

POSITION = {"name": "position", "kind": "vector", "size": 3, "unit": "m", "frame": "n"}
ATTITUDE = {"name": "attitude", "kind": "rotation", "maps": "b -> n"}
ANTENNA = {"name": "antenna", "kind": "vector", "size": 3, "unit": "m", "frame": "b"}
GPS = {"name": "gps", "model": "gnss_position", "position": "position"}


def spec(*states: dict[str, Any], **sections: Any) -> Spec:
    """A specification of a few tables."""
    frames = [{"name": "n", "axes": "ned"}, {"name": "e", "axes": "ecef"}]
    return from_table({"name": "rover", "frame": frames, "state": list(states), **sections})


@pytest.mark.parametrize("path", sorted(VALID.glob("*.toml")), ids=lambda path: path.stem)
def test_valid_files_load_and_derive(path: Path) -> None:
    loaded = load(path)
    for entry in loaded.entries:
        derivation = derive(loaded, entry, frozenset())
        assert derivation.outputs[0].name == "value"


def test_the_rover_reads_as_it_is_written() -> None:
    rover = load(VALID / "rover.toml")
    assert [block.name for block in rover.layout.blocks] == ["position", "attitude", "antenna"]
    assert (rover.layout.size, rover.layout.error_size) == (10, 9)
    gps, imu = rover.entries
    assert gps.bindings == {
        "position": ToState("position"),
        "attitude": ToState("attitude"),
        "lever_arm": ToState("antenna"),
    }
    assert gps.frames["body"] == "b"
    assert imu.options["samples"] == 2
    assert imu.bindings["dt"] == ToInput("dt")
    angles = rover.inputs["delta_theta"].block
    assert isinstance(angles, VectorBlock)
    assert (angles.size, angles.frame, angles.lower) == (6, "b", (-0.5,) * 6)
    assert rover.scalars == ("double",)


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("antenna", ToState("antenna")),
        ("input", ToInput("lever_arm")),
        ([0.1, 0, -0.3], ToConstant((0.1, 0.0, -0.3))),
        ("none", None),
    ],
)
def test_one_word_moves_a_quantity(word: object, expected: object) -> None:
    entry = {**GPS, "attitude": "attitude", "lever_arm": word}
    built = spec(POSITION, ATTITUDE, ANTENNA, measurement=[entry])
    assert built.entries[0].bindings.get("lever_arm") == expected


def test_an_implied_rotation_maps_between_the_frames_of_what_it_connects() -> None:
    entry = {**GPS, "attitude": "input", "lever_arm": "antenna"}
    block = spec(POSITION, ANTENNA, measurement=[entry]).inputs["attitude"].block
    assert isinstance(block, RotationBlock)
    assert block.maps == "b -> n"


def test_a_declared_matrix_and_a_heading_serve_as_attitudes() -> None:
    entry = {**GPS, "attitude": "attitude", "lever_arm": "antenna", "heading": "turn"}
    inputs = [
        {"name": "attitude", "maps": "n -> b", "storage": "dcm"},
        {"name": "turn", "maps": "n -> g", "axis": "z"},
    ]
    built = spec(POSITION, ANTENNA, measurement=[entry], input=inputs)
    matrix, turn = built.inputs["attitude"].block, built.inputs["turn"].block
    assert isinstance(matrix, RotationBlock)
    assert matrix.storage_size == 9
    assert isinstance(turn, HeadingBlock)
    assert (turn.lower, turn.upper) == ((-HALF_TURN,), (HALF_TURN,))
    assert built.entries[0].frames["observer"] == "g"


def test_what_an_input_leaves_out_comes_from_the_quantity() -> None:
    entry = {**GPS, "attitude": "attitude", "lever_arm": "arm"}
    narrow = [{"name": "arm", "range": [[-1, 1], [-2, 2], [0, 3]]}]
    block = spec(POSITION, ATTITUDE, measurement=[entry], input=narrow).inputs["arm"].block
    assert isinstance(block, VectorBlock)
    assert (block.unit, block.frame, block.size) == ("m", "b", 3)
    assert (block.lower, block.upper) == ((-1.0, -2.0, 0.0), (1.0, 2.0, 3.0))


def test_a_state_without_range_takes_that_of_its_quantity() -> None:
    entry = {**GPS, "attitude": "attitude", "lever_arm": "antenna"}
    places = spec(POSITION, ATTITUDE, ANTENNA, measurement=[entry]).layout.places
    assert places["antenna"].block.upper == (100.0,) * 3
    assert places["position"].block.upper == (1e7,) * 3


def test_an_optional_quantity_is_not_bound_by_its_name_alone() -> None:
    offset = {"name": "offset", "kind": "scalar", "unit": "m"}
    depth = {"name": "depth", "equation": ["position[2] + offset"]}
    built = spec(POSITION, measurement=[GPS, depth], input=[offset])
    assert set(built.entries[0].bindings) == {"position"}
    with pytest.raises(SpecError, match="write offset = 'offset' where it is wanted"):
        spec(POSITION, measurement=[GPS], input=[offset])


def test_entries_share_the_frames_of_their_inputs() -> None:
    first = {"name": "one", "model": "gnss_position", "position": "fix"}
    second = {**GPS, "name": "two", "offset": "fix"}
    fix = {"name": "fix", "size": 3}
    built = spec(POSITION, measurement=[first, second], input=[fix])
    assert built.inputs["fix"].block.frames[0] == "n"
    assert built.entries[0].frames["state"] == "n"


def test_clocks_by_system_and_states_by_slot() -> None:
    satellites = load(VALID / "satellites.toml")
    bindings = satellites.entries[0].bindings
    assert bindings["clock_bias"] == BySystem(
        (("gps", ToState("b_gps")), ("galileo", ToState("b_gal"))), "system"
    )
    assert bindings["ionosphere"] == BySlot("iono", "slot")
    system, slot = satellites.inputs["system"], satellites.inputs["slot"]
    assert system.integer
    assert system.item
    assert system.block.upper == (1.0,)
    assert slot.block.upper == (39.0,)
    assert isinstance(satellites.layout.places["place"].block, GeodeticBlock)
    assert satellites.scalars == ("double", "float")
    assert satellites.entries[0].scalars == ("double",)


def test_residuals_add_the_measured_value_in_the_unit_of_the_output() -> None:
    satellites = load(VALID / "satellites.toml")
    measured = satellites.inputs["measured"]
    assert measured.item
    assert measured.block.units[0] == "m"
    assert satellites.entries[0].bindings["measured"] == ToInput("measured")
    with pytest.raises(SpecError, match="residual = 'measured_two'"):
        spec(
            POSITION,
            measurement=[
                {**GPS, "residual": True},
                {"name": "two", "equation": ["position[0]"], "residual": True},
            ],
        )


def test_a_user_equation_over_items_is_mapped() -> None:
    beacons = load(VALID / "satellites.toml").entries[2]
    assert beacons.model.mapped
    assert beacons.maximum == 32
    assert beacons.model.role("beacon").item


def test_text_and_function_make_the_same_equation() -> None:
    def height(q: Any) -> Any:
        return -q.position[2]

    written = spec(POSITION, measurement=[{"name": "height", "equation": ["-position[2]"]}])
    called = spec(POSITION, measurement=[{"name": "height", "equation": height}])
    texts = [derive(s, s.entries[0], frozenset()).outputs for s in (written, called)]
    assert texts[0] == texts[1]


def test_a_function_keeps_its_digest_when_it_is_rewritten() -> None:
    def one(q: Any) -> Any:
        return q.position + q.velocity * q.delay

    def other(state: Any) -> Any:
        """Advanced by the delay."""
        moved = state.velocity * state.delay
        return state.position + moved

    def wrong(q: Any) -> Any:
        return q.position - q.velocity * q.delay

    velocity = {**POSITION, "name": "velocity", "unit": "m/s"}
    delay = {"name": "delay", "kind": "scalar", "unit": "s"}

    def text(equation: Callable[[Any], Any]) -> str:
        entry = {"name": "late", "equation": equation}
        return spec(POSITION, velocity, measurement=[entry], input=[delay]).text

    assert text(one) == text(other)
    assert text(one) != text(wrong)


def test_a_function_with_mistakes_is_reported_in_place() -> None:
    def sum_of_apples_and_pears(q: Any) -> Any:
        return q.position + q.clock

    clock = {"name": "clock", "kind": "scalar", "unit": "s"}
    for equation, reason in (
        (sum_of_apples_and_pears, "cannot be added to a scalar in s"),
        (lambda q: q.positon, "'positon' is not a state block or an input"),
        (lambda _q: 3.0, "returns float; a Quantity is needed"),
    ):
        with pytest.raises(SpecError) as caught:
            spec(POSITION, clock, measurement=[{"name": "z", "equation": equation}])
        (problem,) = caught.value.problems
        assert problem.path == "measurement[0].equation"
        assert reason in problem.message


def test_unit_and_frame_of_a_result_are_checked() -> None:
    for key, value, path in (("unit", "s", "unit"), ("frame", "b", "frame")):
        entry = {"name": "z", "equation": ["position"], key: value}
        with pytest.raises(SpecError) as caught:
            spec(POSITION, measurement=[entry])
        assert [p.path for p in caught.value.problems] == [f"measurement[0].{path}"]
    entry = {"name": "z", "equation": ["position[0]", "position[1]", "position[2]"], "frame": "n"}
    built = spec(POSITION, measurement=[entry])
    assert derive(built, built.entries[0], frozenset()).outputs[0].frame == "n"


def test_the_text_does_not_depend_on_formatting() -> None:
    text = (VALID / "rover.toml").read_text(encoding="utf-8")
    spaced = text.replace(" = ", "=").replace("[-1e5, 1e5]", "[-100000,\n 1.0E5]  # metres")
    assert loads(spaced).text == loads(text).text
    assert json.loads(loads(text).text)["name"] == "rover"
    changed = text.replace("samples = 2", "samples = 3")
    assert loads(changed).text != loads(text).text


def test_the_text_is_the_same_under_any_hash_seed() -> None:
    code = (
        "import sys, pathlib, symnav.spec as s;"
        "print(s.load(pathlib.Path(sys.argv[1])).text)"
    )  # fmt: skip
    texts = {
        subprocess.run(
            [sys.executable, "-c", code, str(VALID / "satellites.toml")],
            env={"PYTHONHASHSEED": seed, "PYTHONPATH": str(Path(__file__).parents[2])},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("0", "1")
    }
    assert len(texts) == 1


def test_records_come_without_pydantic_and_nothing_comes_with_casadi() -> None:
    code = (
        "import sys, symnav.spec; assert 'pydantic' not in sys.modules;"
        "symnav.spec.loads; assert 'pydantic' in sys.modules;"
        "assert 'casadi' not in sys.modules"
    )
    root = str(Path(__file__).parents[2])
    subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": root}, check=True)


def test_unreadable_files_say_so(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"cannot be read: No such file"):
        load(tmp_path / "absent.toml")
    binary = tmp_path / "binary.toml"
    binary.write_bytes(b"\xff\xfe")
    with pytest.raises(SpecError, match="not UTF-8 text"):
        load(binary)
    with pytest.raises(SpecError, match="not TOML: nested too deeply"):
        loads("a = " + "[" * 100_000)


def test_what_an_equation_refuses_is_reported_where_it_stands() -> None:
    wide = [{"name": "delta_theta", "range": [-3, 3]}]
    imu = {"name": "imu", "model": "specific_force", "rotation": "exact"}
    with pytest.raises(SpecError) as caught:
        spec(correction=[imu], input=wide)
    (problem,) = caught.value.problems
    assert problem.path == "correction[0]"
    assert "declare a range whose norm stays below pi" in problem.message


def numbers(built: Spec, at: dict[str, float]) -> dict[str, dict[tuple[int, int], float]]:
    """Outputs of the only entry at one state, by substitution."""
    derivation = derive(built, built.entries[0], frozenset())
    known: dict[Any, Any] = {symbol: at[symbol.name] for symbol in derivation.origins}
    for definition in derivation.definitions:
        known[definition.symbol] = definition.expression.subs(known)
    return {
        output.name: {place: float(e.subs(known)) for place, e in output.entries.items()}
        for output in derivation.outputs
    }


@pytest.mark.parametrize("maps", ["b -> n", "n -> b"])
@pytest.mark.parametrize("error", ["right", "left_negative", "storage"])
def test_a_written_equation_equals_the_library(maps: str, error: str) -> None:
    attitude = {**ATTITUDE, "maps": maps, "error": error}
    states = (POSITION, attitude, ANTENNA)
    library = {**GPS, "attitude": "attitude", "lever_arm": "antenna"}
    terms = {"arm": "rotate(attitude, antenna)"}
    own = {"name": "gps", "equation": ["arm + position"], "let": terms, "unit": "m", "frame": "n"}
    labels = [f"{n}_{axis}" for n in ("position", "antenna") for axis in "xyz"]
    at = {label: 0.7 * k - 1.3 for k, label in enumerate(labels)}
    at |= {"attitude_w": 0.5, "attitude_x": -0.1, "attitude_y": 0.7, "attitude_z": 0.5}
    expected, found = (numbers(spec(*states, measurement=[e]), at) for e in (library, own))
    for name in ("value", "jacobian"):
        assert set(expected[name]) == set(found[name])
        for place, value in expected[name].items():
            assert found[name][place] == pytest.approx(value, rel=1e-12, abs=1e-12)


def test_an_input_that_only_an_error_frame_needs() -> None:
    spec = loads(
        """
        name = "rover"
        [[state]]
        name = "position"
        kind = "vector"
        size = 3
        unit = "m"
        frame = "n"
        error_frame = "b"
        [[input]]
        name = "attitude"
        kind = "rotation"
        maps = "b -> n"
        [[measurement]]
        name = "gps"
        model = "gnss_position"
        position = "position"
        """
    )
    assert list(spec.inputs) == ["attitude"]


def test_a_byte_order_mark_is_read_over(tmp_path: Path) -> None:
    text = "name = 'rover'\n[[state]]\nname = 'clock'\nkind = 'scalar'\nunit = 'm'\n"
    (tmp_path / "rover.toml").write_text(text, encoding="utf-8-sig")
    assert load(tmp_path / "rover.toml").name == "rover"
    assert loads(f"\ufeff{text}").name == "rover"
