"""Bundles of specifications at the edges: no state, one function, awkward names and words."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from symnav import pipeline
from symnav.export.documents import provenance
from symnav.spec import Spec, loads
from tests.export.bundles import files, run

pytestmark = pytest.mark.skipif(
    shutil.which("gcc") is None or shutil.which("make") is None, reason="needs gcc and make"
)

WITHOUT_STATE = """
name = "turns"
[[input]]
name = "omega"
size = 3
unit = "rad/s"
frame = "b"
range = [-10.0, 10.0]
[[measurement]]
name = "speed"
equation = ["norm(omega)"]
"""
ORBIT = """
name = "orbits"
[[measurement]]
name = "orbit"
model = "broadcast_orbit"
system = "gps"
""" + "\n".join(
    f'{role} = "input"'
    for role in (
        *("time", "toe", "toc", "sqrt_a", "eccentricity", "mean_anomaly", "cuc", "cus", "crc"),
        *("mean_motion_difference", "inclination", "inclination_rate", "right_ascension", "crs"),
        *("right_ascension_rate", "argument_of_perigee", "cic", "cis", "af0", "af1", "af2"),
        "group_delay",
    )
)
ONE = """
name = "{name}"
description = "{description}"
[[state]]
name = "position"
kind = "vector"
size = 3
unit = "m"
frame = "n"
[[measurement]]
name = "sensor"
equation = ["position"]
guards = "{guards}"
"""


def one(name: str = "one", description: str = "", guards: str = "status") -> Spec:
    return loads(ONE.format(name=name, description=description, guards=guards))


def check(folder: Path) -> str:
    """What ``make check`` and the example print; afterwards the folder is as it was written."""
    output = run(["make", "-s", "check"], folder) + run(["make", "-s", "example"], folder)
    assert pipeline.check(folder).state == "fresh"
    return output


@pytest.mark.parametrize("scalar", ["double", "float"])
def test_without_a_state(scalar: str, tmp_path: Path) -> None:
    done = pipeline.export(loads(WITHOUT_STATE), tmp_path, scalar=scalar)
    assert "value[0] = " in check(tmp_path)
    assert [functions for _, _, functions in done.trees] == [("speed",)]
    assert "The library has no state" in (tmp_path / "docs/ICD.md").read_text()


def test_nothing_can_be_single(tmp_path: Path) -> None:
    """The tree of single precision is empty, and the bundle still builds and says what it has."""
    pipeline.export(loads(ORBIT), tmp_path, scalar="float")
    assert "position[0] = " in check(tmp_path)
    text = (tmp_path / "README.md").read_text()
    assert "`orbits_orbit` | double" in text
    assert "Nothing in this library" in text


@pytest.mark.skipif(shutil.which("cmake") is None, reason="needs cmake")
def test_a_name_that_cmake_has_taken(tmp_path: Path) -> None:
    pipeline.export(one(name="test"), tmp_path)
    check(tmp_path)
    run(["cmake", "-S", ".", "-B", "build"], tmp_path)
    run(["cmake", "--build", "build"], tmp_path)


@pytest.mark.parametrize("words", [r"a \"quoted\" $HOME */ `x` | 100%", "naïve ±1 m", "$$(@)"])
def test_words_that_mean_something_elsewhere(words: str, tmp_path: Path) -> None:
    pipeline.export(one(description=words), tmp_path)
    check(tmp_path)
    if shutil.which("cmake"):
        run(["cmake", "-S", ".", "-B", "build"], tmp_path)
    json.loads((tmp_path / "library.json").read_text())
    json.loads((tmp_path / provenance.BILL).read_text())
    for path in ("zephyr/Kconfig", "library.properties", "one.pc.in", "CMakeLists.txt"):
        text = (tmp_path / path).read_text()
        assert "HOME" not in text or "$HOME" not in text
        assert '"quoted"' not in text


def test_left_out_guards_are_said(tmp_path: Path) -> None:
    pipeline.export(one(guards="assume"), tmp_path)
    assert "value[0] = " in check(tmp_path)
    assert "**Generated without guards**" in (tmp_path / "docs/ICD.md").read_text()
    text = (tmp_path / "docs/trace.csv").read_text()
    assert "\ninput,one_sensor,position[0]" in text or "\ninput,one_sensor,x[0]" in text


def test_old_files_go_and_made_ones_stay(tmp_path: Path) -> None:
    """Another specification in the same folder leaves nothing of the first behind."""
    pipeline.export(one(name="first"), tmp_path)
    run(["make", "-s"], tmp_path)
    pipeline.export(one(name="second"), tmp_path, force=True)
    assert not any("first" in path for path in files(tmp_path) if not path.startswith("build/"))
    assert (tmp_path / "build/libfirst.a").is_file()
    check(tmp_path)
