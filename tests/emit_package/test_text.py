"""Laying out Python source: data, expressions, docstrings and documentation."""

from __future__ import annotations

import ast
from dataclasses import replace

import pytest

from symnav import errors, ir, naming
from symnav.emit.python import text
from symnav.emit.python.documentation import documentation
from symnav.emit.python.interface import interface
from symnav.emit.python.names import result_names
from tests.emit_numpy import modules, records


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (1.0, "1.0"), (-0.5, "-0.5"), (1e5, "1e5"), (-1e5, "-1e5"), (6378137.0, "6378137.0"),
        (1e-06, "1e-6"), (float("inf"), "math.inf"), (float("-inf"), "-math.inf"), (0.0, "0.0"),
    ],
)  # fmt: skip
def test_floats_are_short_and_exact(value: float, expected: str) -> None:
    """Every literal reads back as the number."""
    assert text.literal(value) == expected
    assert "math" in expected or ast.literal_eval(expected) == value


def test_tuples_of_numbers() -> None:
    """Equal floats are said once, runs of integers by their ends."""
    assert str(text.numbers((1.5, 1.5, 1.5))) == "(1.5,) * 3"
    assert str(text.numbers((1.5,))) == "(1.5,)"
    assert str(text.numbers((1.0, 2.0))) == "(1.0, 2.0)"
    assert str(text.integers((0, 1, 2, 3))) == "tuple(range(4))"
    assert str(text.integers((5, 6, 7, 8))) == "tuple(range(5, 9))"
    assert str(text.integers((0, 1, 2))) == "(0, 1, 2)"
    assert str(text.integers((0, 2, 3, 4))) == "(0, 2, 3, 4)"
    assert str(text.integers(())) == "()"


@pytest.mark.parametrize("value", ['say "x"', "back\\slash", "line\nbreak", "degree \u00b0", "'''"])
def test_strings_read_back(value: str) -> None:
    """Whatever a title or a label holds stays text."""
    assert ast.literal_eval(text.quoted(value)) == value


@pytest.mark.parametrize("line", ['ends """ early', "\\x41 and \\", 'quote at the end"'])
def test_docstrings_cannot_be_left(line: str) -> None:
    """A description cannot become code."""
    source = "\n".join(text.docstring([line, "second line", line]))
    (statement,) = ast.parse(source).body
    assert isinstance(statement, ast.Expr)
    single = ast.parse("\n".join(text.docstring([line])) + "\n").body
    assert len(single) == 1


def test_data_fits_the_page() -> None:
    """One line where it fits, then one line inside, then one line each; never too wide."""
    short = text.call("Domain", '"a"', "1")
    assert text.lay_out(short, before="x = ") == ['x = Domain("a", 1)']
    middle = text.call("Domain", *[f'"a long part {n}"' for n in range(5)])
    assert len(text.lay_out(middle, before="a_rather_long_name_to_begin_with = ")) == 3
    wide = text.call("Domain", *[f'"a very long part {n} {"x" * 30}"' for n in range(5)])
    assert len(text.lay_out(wide, after=",", depth=1)) == 7
    many = text.tuple_of([str(number) for number in range(200)])
    lines = text.lay_out(text.call("Output", many), depth=2)
    assert max(map(len, lines)) <= text.WIDTH
    assert eval_tuple(lines) == tuple(range(200))


def eval_tuple(lines: list[str]) -> object:
    """The first argument of a laid-out call."""
    tree = ast.parse("\n".join(line[8:] for line in lines), mode="eval")
    assert isinstance(tree.body, ast.Call)
    return ast.literal_eval(tree.body.args[0])


def test_long_expressions_wrap_before_operators() -> None:
    """A statement wider than the page goes into brackets."""
    expression = " + ".join(f"some_rather_long_name_{n} * {n}.5" for n in range(8))
    lines = text.assignment("total", expression, remark="the sum of it all")
    assert lines[0] == "    # the sum of it all"
    assert max(map(len, lines)) <= text.WIDTH
    assert all(line.strip().startswith("+") for line in lines[3:-1])
    tree = ast.parse("\n".join(line[4:] for line in lines))
    assert ast.dump(tree.body[0]) == ast.dump(ast.parse(f"total = {expression}").body[0])


def test_remarks_stand_beside_what_is_short() -> None:
    """Two spaces, as everywhere."""
    assert text.assignment("a", "b", remark="why\nnot") == ["    a = b  # why not"]


def test_documentation_says_what_matters() -> None:
    """Equation, shapes, units, frames, ranges, items, conventions and source."""
    words = " ".join("\n".join(documentation(modules.ranges(), "RangesResult")).split())
    for phrase in (
        "The function ranges. ranges = f(x) Parameters",
        "x : array_like, shape (..., 13)",
        "- [3:7] attitude (map b -> n, unit quaternion w x y z)",
        "- [7] bias_gps (m, range [-1e6, 1e6])",
        "height : array_like, shape (...)",
        "satellite : array_like, shape (..., n, 3) The satellite; m, frame e, range",
        "slot : integers, shape (..., n) The slot; range [0, 3].",
        "value : array, shape (..., n), m The value.",
        "jacobian : array, shape (..., n, 12)",
        "one that fails has zero rows and makes its epoch PARTIAL",
        "``ranges.single_difference`` (less the item ``reference``)",
        "At most 8 items. Angles are in radians. Source: A textbook, equation 1.",
    ):
        assert phrase in words, phrase
    assert max(map(len, documentation(modules.ranges(), "RangesResult"))) <= text.WIDTH - 8


def test_documentation_of_variants() -> None:
    """Rejecting functions, matrices, and functions without guards or equations."""
    strict = "\n".join(documentation(modules.ranges("s", ir.Items.REJECT), "R"))
    assert "one that fails refuses its epoch" in strict
    assert "rotation matrix, row by row" in "\n".join(documentation(modules.frame_map(), "R"))
    bare = replace(modules.unguarded(modules.gps()), equation="", source="", conventions=())
    lines = documentation(bare, "R")
    assert "Raises" not in lines
    assert lines[1:3] == ["", "Parameters"]
    assert "Generated without guards: arguments are not checked." in lines
    assert not any("Source" in line for line in lines)


def test_result_types_never_share_a_name() -> None:
    """``gps_2`` and ``gps2`` would; they keep their underscore."""
    functions = [replace(modules.gps(), name=name) for name in ("gps2", "gps_2", "range_rate")]
    assert result_names(functions) == {
        "gps2": "Gps2Result",
        "gps_2": "Gps_2Result",
        "range_rate": "RangeRateResult",
    }


def test_names_the_package_needs_are_refused() -> None:
    """Parameters, attributes of the state object and modules; before anything is emitted."""
    for name, use in (
        ("guards", naming.Use.INPUT),
        ("xp", naming.Use.INPUT),
        ("slices", naming.Use.STATE),
        ("conventions", naming.Use.STATE),
        ("native_f32", naming.Use.FUNCTION),
        ("casadi", naming.Use.FUNCTION),
    ):
        assert naming.fault(name, use) is not None, name


def test_two_moving_indices_are_refused() -> None:
    """An element may depend on one run-time index."""
    slot = ir.Load("slot", 0)
    own = records.argument(records.domain("slot", 1, (0.0, 2.0), kind=ir.Kind.INTEGER))
    twice = records.output(
        "value", (3, 3), [((ir.Offset(0, slot), ir.Offset(0, slot)), records.number(1.0))]
    )
    with pytest.raises(errors.InputError, match="odd: an element of value is placed by two"):
        interface(modules.module(records.function("odd", (own,), (twice,))))


def test_slots_reach_no_further_than_the_output() -> None:
    """A declared range wider than the block is cut to what exists."""
    (ranges,) = (f for f in modules.module().functions if f.name == "ranges")
    *rest, slot = ranges.arguments
    (own,) = slot.domains
    wide = replace(slot, domains=(replace(own, lower=(-5.0,), upper=(float("inf"),)),))
    source = interface(modules.module(replace(ranges, arguments=(*rest, wide))))
    assert 'Slot(8, 1, "slot", None, -8, 3)' in source or "None, -5, 3)" in source
