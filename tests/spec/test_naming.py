"""Identifiers: what is refused and why."""

from __future__ import annotations

import keyword
import re
import subprocess
from pathlib import Path
from shutil import which

import pytest
from hypothesis import given
from hypothesis import strategies as st

from symnav import naming
from symnav.equations import library
from symnav.naming import Use


@pytest.mark.parametrize(
    ("name", "use", "reason"),
    [
        ("position", Use.STATE, None),
        ("delta_t", Use.INPUT, None),
        ("b_gps", Use.STATE, None),
        ("_x", Use.STATE, "starts with an underscore"),
        ("a__b", Use.STATE, "double underscore"),
        ("a_", Use.STATE, "ends with an underscore"),
        ("2a", Use.STATE, "not an identifier"),
        ("a-b", Use.STATE, "not an identifier"),
        ("höhe", Use.STATE, "not an identifier"),
        ("a\n", Use.STATE, "not an identifier"),
        ("", Use.STATE, "not an identifier"),
        ("a" * 32, Use.STATE, "32 characters; 31 are allowed"),
        ("restrict", Use.INPUT, "a keyword of C;"),
        ("class", Use.INPUT, "a keyword of C\\+\\+"),
        ("yield", Use.INPUT, "a keyword of Python"),
        ("y1", Use.INPUT, "declared by math.h"),
        ("sinf", Use.INPUT, "declared by math.h"),
        ("errno", Use.INPUT, "the C library or a compiler"),
        ("none", Use.STATE, "a word of the specification"),
        ("x", Use.STATE, "a name that the generated code gives itself"),
        ("N", Use.INPUT, "a name that the generated code gives itself"),
        ("jacobian_arm", Use.INPUT, "a name that the generated code gives itself"),
        ("pack", Use.STATE, "a name that the generated code gives itself"),
        ("pack", Use.INPUT, None),
        ("state", Use.FUNCTION, "a name that the generated code gives itself"),
        ("retract", Use.FUNCTION, "a name that the generated code gives itself"),
        ("symnav", Use.PACKAGE, "a name that the generated code gives itself"),
        ("double", Use.FRAME, None),
        ("b-frame", Use.FRAME, "not an identifier"),
    ],
)
def test_faults(name: str, use: Use, reason: str | None) -> None:
    found = naming.fault(name, use)
    if reason is None:
        assert found is None
    else:
        assert found is not None
        assert reason.replace("\\", "") in found


@given(
    st.sampled_from(keyword.kwlist), st.sampled_from([use for use in Use if use is not Use.FRAME])
)
def test_no_keyword_of_python_passes(word: str, use: Use) -> None:
    assert naming.fault(word, use) is not None


def test_every_quantity_of_the_library_may_be_an_input() -> None:
    for model in library().values():
        for role in model.roles:
            assert naming.fault(role.name, Use.INPUT) is None, (model.name, role.name)


def test_clashes() -> None:
    assert naming.clash("Gps", ["imu", "gps"]) == "gps"
    assert naming.clash("gps", ["imu"]) is None
    assert naming.entry_point_clash("gps_batch", ["gps"]) == "gps"
    assert naming.entry_point_clash("gps", ["gps"]) is None
    assert naming.step_clash("x_step", ["x"]) == "x"
    assert naming.step_clash("a_step", ["x"]) is None


def test_macros_and_symbols() -> None:
    assert naming.macro("rover", "gps", "max_items") == "ROVER_GPS_MAX_ITEMS"
    assert naming.symbol("rover", "gps", "nz") == "rover_gps_nz"
    assert naming.include_guard("rover/rover_types.h") == "ROVER_ROVER_TYPES_H"


@pytest.mark.skipif(which("gcc") is None or which("g++") is None, reason="needs gcc and g++")
def test_compilers_agree(tmp_path: Path) -> None:
    """Every word called a keyword is refused by a compiler; ordinary names pass both."""

    def compiles(word: str, compiler: str, suffix: str, standard: str) -> bool:
        source = tmp_path / f"word.{suffix}"
        source.write_text(f"double {word} = 1.0;\n")
        command = [compiler, f"-std={standard}", "-fsyntax-only", str(source)]
        return subprocess.run(command, capture_output=True, check=False).returncode == 0

    for word in ("restrict", "inline", "register", "int", "while"):
        assert word in naming.C_KEYWORDS
        assert not compiles(word, "gcc", "c", "c99")
    for word in ("template", "and", "static_cast", "noexcept", "this"):
        assert word in naming.CPP_KEYWORDS
        assert not compiles(word, "g++", "cpp", "c++17")
    for word in ("position", "clock_bias", "b_gps"):
        assert naming.fault(word, Use.INPUT) is None
        assert compiles(word, "gcc", "c", "c99")
        assert compiles(word, "g++", "cpp", "c++17")


@pytest.mark.skipif(which("gcc") is None, reason="needs gcc")
def test_math_names_are_those_of_math_h(tmp_path: Path) -> None:
    """What the C library's math.h declares and a user could write is in the list."""
    source = tmp_path / "math.c"
    source.write_text("#include <math.h>\n")
    command = ["gcc", "-std=gnu99", "-aux-info", str(tmp_path / "names"), "-fsyntax-only",
               str(source)]  # fmt: skip
    subprocess.run(command, capture_output=True, check=True)
    listing = (tmp_path / "names").read_text()
    declared = set(re.findall(r"\b([a-z]\w*) \(", listing))
    assert {"acos", "hypot", "lgamma", "y0f", "scalbln"} <= declared
    assert "gamma" in declared
    # GNU extensions and long variants that a user would not write by accident.
    foreign = {name for name in declared if re.search(r"_|\d{2,}x?$|^exp10|^pow10|^sincos", name)}
    assert {name for name in declared - foreign if naming.fault(name, Use.INPUT) is None} == set()
