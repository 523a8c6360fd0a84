"""Identifiers: what is refused and why."""

from __future__ import annotations

import keyword
import re
import subprocess
import sysconfig
from pathlib import Path
from shutil import which

import pytest
from hypothesis import given
from hypothesis import strategies as st

from symnav import ir, naming
from symnav.equations import library
from symnav.naming import Use

ROOT = Path(__file__).parents[2]


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
        ("take_value", Use.INPUT, None),
        ("INT32_MAX", Use.STATE, None),
        ("M_PI", Use.INPUT, "declared by math.h"),
        ("status_t", Use.FUNCTION, "a name that the generated code gives itself"),
        ("len", Use.FUNCTION, "a name that the generated Python calls"),
        ("Sequence", Use.FUNCTION, "a name that the generated Python calls"),
        ("sequence", Use.FUNCTION, None),
        ("len", Use.INPUT, None),
        ("f0", Use.FUNCTION, "a name of CasADi's helpers"),
        ("S12", Use.FUNCTION, "a name of CasADi's helpers"),
        ("sq", Use.FUNCTION, "a name of CasADi's helpers"),
        ("f0", Use.STATE, None),
        ("f32", Use.FUNCTION, "leads the names of the single-precision C"),
        ("f32_gps", Use.FUNCTION, "leads the names of the single-precision C"),
        ("r", Use.PACKAGE, "'r' gives R_OK, a macro of unistd.h"),
        ("py_model", Use.PACKAGE, "leads names of the headers of Python and NumPy"),
        ("PyObject", Use.PACKAGE, "leads names of the headers of Python and NumPy"),
        ("npy", Use.PACKAGE, "leads names of the headers of Python and NumPy"),
        ("ROVER", Use.PACKAGE, "upper case, which C keeps for macros"),
        ("Rover", Use.PACKAGE, None),
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
    assert naming.entry_point_clash("gps_work", ["gps"]) == "gps"
    assert naming.entry_point_clash("gps_n_in", ["gps"]) == "gps"
    assert naming.step_clash("x_step", ["x"]) == "x"
    assert naming.step_clash("a_step", ["x"]) is None


def test_macros_and_symbols() -> None:
    assert naming.macro("rover", "gps", "max_items") == "ROVER_GPS_MAX_ITEMS"
    assert naming.symbol("rover", "gps", "nz") == "rover_gps_nz"


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


def test_helpers_are_those_of_the_templates() -> None:
    templates = ROOT / "templates" / "c"
    helpers = {path.stem for path in (templates / "helpers").glob("*.j2")}
    trigonometry = (templates / "trigonometry.h.j2").read_text(encoding="utf-8")
    helpers |= set(re.findall(r"^\S+_INLINE .* (\w+)\(", trigonometry, re.MULTILINE))
    helpers |= set(re.findall(r"_INLINE \S+ \S+ \S+ (\w+)\(", trigonometry))
    assert helpers | {"flag_t"} == naming.HELPER_NAMES


def test_names_of_casadi_are_refused() -> None:
    """Whatever CasADi's generator defines beside a function, no other function may be called."""
    sources = sorted(ROOT.glob("generated/*/casadi/*.c"))
    assert sources
    for source in sources:
        text = source.read_text(encoding="utf-8")
        for helper in re.findall(r"#define casadi_(\w+) CASADI_PREFIX", text):
            assert naming.fault(helper, Use.FUNCTION) is not None, helper
        functions = re.findall(r"^/\* (\w+):\(", text, re.MULTILINE)
        symbols = set(re.findall(r"^CASADI_SYMBOL_EXPORT .*?(\w+)\(", text, re.MULTILINE))
        lead = f"{source.stem}_"
        assert set(functions) < symbols
        for symbol in symbols - set(functions):
            name = symbol.removeprefix(lead)
            clash = naming.entry_point_clash(name, [f.removeprefix(lead) for f in functions])
            assert clash is not None or naming.fault(name, Use.FUNCTION) is not None, symbol


def macros_of(header: str, *options: str) -> set[str]:
    """The macros without parameters that a header brings."""
    command = ["gcc", "-dM", "-E", *options, "-include", header, "-x", "c", "/dev/null"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return {word for line in done.stdout.splitlines() if "(" not in (word := line.split()[1])}


@pytest.mark.skipif(which("gcc") is None, reason="needs gcc")
def test_macros_of_headers_are_refused_or_renamed() -> None:
    for header in ("stdint.h", "stddef.h", "stdbool.h", "float.h", "math.h"):
        for word in macros_of(header, "-std=c99", "-D_XOPEN_SOURCE=700"):
            if re.fullmatch(r"[A-Za-z]\w*", word) and "__" not in word:
                renamed = word in naming.STANDARD_NAMES
                assert renamed or naming.fault(word, Use.INPUT) is not None, word


@pytest.mark.skipif(which("gcc") is None, reason="needs gcc")
def test_no_package_has_macros_of_python() -> None:
    """The compiled wrapper includes Python.h and the generated headers together."""
    include = Path(sysconfig.get_path("include"))
    if not (include / "Python.h").is_file():
        pytest.skip("needs the headers of Python")
    macros = macros_of("Python.h", f"-I{include}")
    assert {"R_OK", "F_OK"} <= macros
    endings = [status.name for status in ir.Status]
    endings += ["H", "TYPES_H", "CHECK_H", "STATE_SIZE", "ERROR_SIZE", "RESTRICT", "INLINE"]
    for name in macros:
        for ending in endings:
            lead = name.removesuffix(f"_{ending}").lower()
            if name.endswith(f"_{ending}") and naming.fault(lead, Use.PACKAGE) is None:
                assert name != f"{lead}_{ending}".upper(), name
