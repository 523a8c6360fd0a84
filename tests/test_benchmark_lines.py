"""Lines of code are counted by one rule whoever wrote them."""

from __future__ import annotations

from benchmarks.lines import lines_of_code

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
    assert lines_of_code(SOURCE, ["f"]) == 8
    assert lines_of_code(SOURCE, ["g"]) == 1


def test_functions_add_up_and_unknown_ones_have_no_lines() -> None:
    assert lines_of_code(SOURCE, ["f", "g", "h"]) == 9
