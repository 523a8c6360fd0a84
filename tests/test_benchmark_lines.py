"""Lines of code are counted by one rule whoever wrote them."""

from __future__ import annotations

import pytest

from benchmarks.lines import lines_of_code

pytest.importorskip("clang_format", reason="needs clang-format")

SOURCE = """
#include <math.h>

/* A comment: f(x) { } */
static int f(int x);
static int f(
    int x) // the argument
{
    if (x > 0) {

        return 1; /* one
                     more */
    }
    return g(x);
}

int g(int x) { return x; }
"""


def test_head_and_body_without_blank_lines_and_comments() -> None:
    assert lines_of_code(SOURCE, ["f"]) == 7
    assert lines_of_code(SOURCE, ["g"]) == 4


def test_functions_add_up_and_unknown_ones_have_no_lines() -> None:
    assert lines_of_code(SOURCE, ["f", "g", "h"]) == 11
    assert lines_of_code(SOURCE, ["h"]) == 0


def test_layout_of_the_author_does_not_count() -> None:
    """The same statements on one line, on many, or longer than anybody reads."""
    terms = " + ".join(f"x{k}*y{k}" for k in range(60))
    long = f"double f(double a) {{ double b = {terms}; double c = 2*a; return b + c; }}"
    broken = long.replace("; ", ";\n\n  ").replace(" + ", "\n   + ").replace("(double", "(\ndouble")
    assert lines_of_code(long, ["f"]) == lines_of_code(broken, ["f"])
    assert lines_of_code(long, ["f"]) > 8
