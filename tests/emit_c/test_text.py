"""The emitted text: what compilers say about it, that it is reproducible, and how it reads."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

from symnav import errors, ir, naming
from symnav.emit import c
from symnav.emit.c import comments
from symnav.emit.c.arguments import LOCALS
from symnav.emit.c.names import RESERVED, Names, identifier
from symnav.emit.protocol import Emitter
from tests.emit_c import building, modules
from tests.emit_c.harness import write_package

STRICT = shlex.split(
    "-std=c99 -O2 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wstrict-prototypes "
    "-Wmissing-prototypes -Wshadow -Wfloat-equal -Wcast-qual -Wundef -Wvla -Wswitch-default "
    "-Wformat=2 -Wlogical-op -Wduplicated-cond -Wredundant-decls -Werror"
)

gcc = pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
gxx = pytest.mark.skipif(shutil.which("g++") is None, reason="needs g++")


def run(*command: str | Path) -> subprocess.CompletedProcess[str]:
    """Run a command and show its output when it fails."""
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done


def sources(package: Path, prefix: str) -> list[Path]:
    """Source files of one tree."""
    other = "rover_f32" if prefix == "rover" else "none"
    found = sorted((package / "c" / "src").glob(f"{prefix}_*.c"))
    return [path for path in found if not path.name.startswith(other)]


@gcc
@pytest.mark.parametrize("prefix", ["rover", "rover_f32"])
def test_no_warnings(package: Path, prefix: str) -> None:
    """Not one from a strict set, in either type."""
    strict = [*STRICT, "-Wunsuffixed-float-constants"] if prefix == "rover_f32" else STRICT
    include = f"-I{package / 'c' / 'include'}"
    commands = [
        ("gcc", *strict, include, "-c", path, "-o", os.devnull) for path in sources(package, prefix)
    ]
    functions = modules.all_functions()
    assert len(commands) == len(functions) + sum(f.checks_at_border for f in functions)
    with ThreadPoolExecutor(os.cpu_count() or 1) as workers:
        list(workers.map(lambda command: run(*command), commands))


@gcc
@pytest.mark.parametrize("prefix", ["rover", "rover_f32"])
def test_headers_stand_alone(package: Path, prefix: str, tmp_path: Path) -> None:
    """Each header compiles without anything in front of it."""
    for header in sorted((package / "c" / "include" / prefix).glob("*.h")):
        lone = tmp_path / f"{header.stem}.c"
        lone.write_text(f'#include "{prefix}/{header.name}"\nint main(void) {{ return 0; }}\n')
        include = f"-I{package / 'c' / 'include'}"
        run("gcc", *STRICT, include, "-c", lone, "-o", os.devnull)


@gxx
def test_callable_from_cpp(package: Path, tmp_path: Path) -> None:
    """A C++17 program includes both headers, links with the C and gets the value."""
    program = tmp_path / "main.cpp"
    program.write_text(
        """
        #include "rover/rover.h"
        #include "rover_f32/rover_f32.h"
        int main()
        {
            static_assert(ROVER_STATE_SIZE == 20 && ROVER_E_ATTITUDE == 3, "layout");
            static_assert(ROVER_LAYOUT_DIGEST == 0x89ABCDEFU, "digest");
            double x[ROVER_STATE_SIZE] = {}, arm[3] = {1.0, 0.0, 0.0}, value[4];
            x[ROVER_X_POSITION] = 2.0;
            x[ROVER_X_ATTITUDE] = 1.0;
            float xf[ROVER_F32_STATE_SIZE] = {}, armf[3] = {1.0F, 0.0F, 0.0F}, valuef[4];
            xf[ROVER_F32_X_ATTITUDE] = 1.0F;
            const rover_status_t one = rover_gps_value(x, arm, value);
            const rover_f32_status_t two = rover_f32_gps_value(xf, armf, valuef);
            const bool ok = one == ROVER_OK && two == ROVER_F32_OK;
            return ok && value[0] > 2.9 && value[0] < 3.1 && valuef[0] > 0.9F ? 0 : 1;
        }
        """
    )
    include = f"-I{package / 'c' / 'include'}"
    objects = []
    for name in ("rover_gps", "rover_f32_gps"):
        objects.append(tmp_path / f"{name}.o")
        run("gcc", "-c", include, package / "c" / "src" / f"{name}.c", "-o", objects[-1])
    strict = ("-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")
    run("g++", *strict, include, program, *objects, "-lm", "-o", tmp_path / "main")
    run(tmp_path / "main")


@gcc
@pytest.mark.parametrize("name", ["rover_gps", "rover_f32_gps"])
@pytest.mark.parametrize(
    ("flag", "told"),
    [
        ("-ffast-math", "-ffast-math"),
        ("-funsafe-math-optimizations", "-funsafe-math-optimizations"),
        ("-ffinite-math-only", "comparisons with NaN"),
        ("-mfpmath=387", "evaluated in itself"),
    ],
)
def test_liberties_with_arithmetic_are_refused(
    package: Path, name: str, flag: str, told: str
) -> None:
    """Guards and sines would mean nothing."""
    source = package / "c" / "src" / f"{name}.c"
    include = f"-I{package / 'c' / 'include'}"
    command = ["gcc", "-O2", flag, include, "-c", str(source), "-o", os.devnull]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert told in done.stderr


def test_same_bytes_under_any_hash_seed(tmp_path: Path) -> None:
    """Nothing depends on the order of a set."""
    script = (
        "import hashlib; from tests.emit_c import modules as m; from symnav.emit import c; "
        "files = c.emit(m.module(*m.all_functions())); "
        "print(hashlib.sha256(repr(list(files.items())).encode()).hexdigest())"
    )
    root = Path(__file__).parents[2]
    digests = {
        subprocess.run(
            [sys.executable, "-c", script],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(root)},
            capture_output=True,
            text=True,
            check=True,
            cwd=tmp_path,
        ).stdout
        for seed in ("0", "1", "2")
    }
    assert len(digests) == 1


def test_lines_are_short_and_plain() -> None:
    """No line beyond 100 columns, no trailing blanks, no tabs, one newline at the end."""
    files = c.emit(modules.module(*modules.all_functions(), scalar=ir.Scalar.FLOAT))
    for path, text in files.items():
        assert text.endswith("\n") and not text.endswith("\n\n"), path
        for line in text.splitlines():
            assert len(line) <= comments.WIDTH, (path, line)
            assert line == line.rstrip() and "\t" not in line, (path, line)
        assert "\n\n\n" not in text, path


def test_float_tree_holds_no_double() -> None:
    """No double arithmetic: neither type nor literal nor function."""
    files = c.emit(modules.module(*modules.all_functions(), scalar=ir.Scalar.FLOAT))
    code = re.sub(r"/\*.*?\*/", "", "\n".join(files.values()), flags=re.DOTALL)
    assert not re.search(r"\bdouble\b", code)
    assert not re.search(r"\b\d+\.\d+(e[-+]\d+)?(?![\dF])\b", code)
    assert not re.search(r"\b(sqrt|sin|cos|tan|asin|acos|atan|atan2|exp|log|fabs|floor)\(", code)


def test_no_memory_but_the_stack() -> None:
    """No heap, no static variable, no recursion by name."""
    files = c.emit(modules.module(*modules.all_functions()))
    code = re.sub(r"/\*.*?\*/", "", "\n".join(files.values()), flags=re.DOTALL)
    assert not re.search(r"\b(malloc|calloc|realloc|free|alloca)\b", code)
    variables = re.findall(r"\bstatic (?!inline|__forceinline)[^(;{=]*[;=]", code)
    assert all(variable.startswith("static const int32_t") for variable in variables)


def test_unguarded_kernels_read_inputs_where_they_need_them() -> None:
    """Only what a slot chooses from is copied; every other element is read once, by no item."""
    files = c.emit(modules.module(*modules.all_functions()))
    for name in ("gps_bare", "bare"):
        text = files[f"c/src/rover_{name}_kernel.h"]
        start = text.index(f"{name}_load(")
        loader = text[start : text.index("return", start)]
        assert "in->x = x;" in loader
        copies = re.findall(r"in->(\S+) = \w+\[\d+\];", loader)
        assert all("_by_slot[" in copy for copy in copies)
        reads = re.findall(r"= in->\w+\[\d+\];", text)
        assert len(reads) == len(set(reads)) > 0
    assert not re.search(r"in->x\[", text[text.index("bare_item(") :])


def test_structural_zeros_are_written_once() -> None:
    """Every element of a dense row is stored exactly once."""
    text = c.emit(modules.module(modules.antenna()))["c/src/rover_gps.c"]
    body = text.partition("gps_fill_jacobian(")[2].partition("\n}\n")[0]
    stores = [int(index) for index in re.findall(r"dense\[(\d+)\] =", body)]
    for first, last in re.findall(r"k = (\d+); k <= (\d+);", body):
        stores += range(int(first), int(last) + 1)
    assert sorted(stores) == list(range(4 * building.ERROR_SIZE))


def test_a_comment_cannot_be_closed_from_outside() -> None:
    """Text of the user stays inside its comment and gives Doxygen no command."""
    evil = "end */ int evil; /* begin\nnext \\param @file"
    function = modules.antenna(title=evil, equation=evil, source=evil, conventions=(evil,))
    step = replace(function.shared[0], comment=evil)
    files = c.emit(modules.module(replace(function, shared=(step, *function.shared[1:]))))
    for text in files.values():
        code = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
        assert "evil" not in code and "begin" not in code
        assert "\\param" not in text


def test_emitter_protocol() -> None:
    """The folder is an emitter."""
    emitter: Emitter = c
    assert "c/include/rover/rover.h" in emitter.emit(modules.module(modules.antenna()))


def test_two_functions_with_one_symbol() -> None:
    """It is an error, not a surprise at link time."""
    both = modules.module(modules.antenna(), modules.antenna(name="gps_nz"))
    with pytest.raises(errors.InputError, match="rover_gps_nz"):
        c.emit(both)


def test_slot_beyond_its_output() -> None:
    """The declared range of a slot may not reach past the row it addresses."""
    function = modules.pseudorange()
    wide = building.argument(building.integers("slot", 0.0, 11.0), item=True)
    function = replace(function, arguments=(*function.arguments[:-1], wide))
    with pytest.raises(errors.InputError, match="slot reaches beyond"):
        c.emit(modules.module(function))


DECLARED = re.compile(
    r"^ +(?:const )?(?:\w+_t|bool) \*?(?:\w+_RESTRICT )?(\w+)(?=[\[;,) ])"
    r"|[(,] ?(?:const )?\w+_t \*?(?:\w+_RESTRICT )?(\w+)(?=[\[,)])"
    r"|\((?:int32_t|ptrdiff_t) (\w+) =",
    re.MULTILINE,
)
"""A name that is declared: as a local, a parameter, or the count of a loop."""

APART = {"deviation", "reference_slot"}
"""Of functions that no input of the caller is visible in."""


def test_locals_are_known() -> None:
    """Names that the source files declare are kept from inputs, or are the function's own."""
    functions = modules.all_functions()
    own = {f"{a.name}{end}" for f in functions for a in f.arguments for end in ("", "_step")}
    own |= {f"{o.name}{end}" for f in functions for o in f.outputs for end in ("", "_nz")}
    text = "".join(
        t for path, t in c.emit(modules.module(*functions)).items() if path.endswith(".c")
    )
    found = {name for match in DECLARED.findall(text) for name in match if name}
    assert {"codes", "failures", "lane", "epoch", "inside"} <= found
    assert found - own - LOCALS == APART


@gcc
def test_inputs_may_be_called_like_locals(tmp_path: Path) -> None:
    """Every name that the C uses itself is free for an input, and for a named term."""
    names = sorted(LOCALS - {"i", "n"} | naming.HELPER_NAMES | naming.STANDARD_NAMES)
    arguments = [
        building.argument(building.domain(name, 0, ("x", "y"), 1.0), item=position % 2 == 0)
        for position, name in enumerate(names)
    ]
    total = building.add(*(ir.Load(argument.name, 1) for argument in arguments))
    check = ir.Check("value", total, 0.5, 9.0, 1.0, ir.Status.DOMAIN, "")
    function = building.function(
        "busy",
        [building.X, *arguments],
        shared=(
            ir.Statement("status", ir.Load(names[1], 0)),
            ir.Statement("is_within", building.add("status", 1.0)),
            ir.Statement("INT32_MAX", building.mul("is_within", "status")),
        ),
        item=(check,),
        outputs=(
            building.output("value", (), [((), building.mul("value", "INT32_MAX"))], item=True),
            building.output("jacobian", (19,), [((2,), "value")], item=True),
        ),
        maximum=5,
        single_difference=True,
    )
    package = write_package(tmp_path, modules.module(function))
    path = package / "c" / "src" / "rover_busy.c"
    run("gcc", *STRICT, f"-I{package / 'c' / 'include'}", "-c", path, "-o", os.devnull)


@gcc
def test_slots_of_the_reference_have_names_of_their_own(tmp_path: Path) -> None:
    """Also where an input is called as the slot of the reference would be."""
    slots = ("slot", "reference_slot", "reference_reference_slot")
    arguments = [building.argument(building.integers(name, 0.0, 2.0), item=True) for name in slots]
    places = [ir.Offset(3 * k, ir.Load(name, 0)) for k, name in enumerate(slots)]
    function = building.function(
        "placed",
        [building.X, *arguments],
        item=(ir.Statement("half", building.mul(ir.Load("x", 0), 0.5)),),
        outputs=(
            building.output("value", (), [((), "half")], item=True),
            building.output(
                "jacobian",
                (19,),
                [((place,), float(k)) for k, place in enumerate(places)],
                item=True,
            ),
        ),
        maximum=5,
        single_difference=True,
    )
    package = write_package(tmp_path, modules.module(function))
    path = package / "c" / "src" / "rover_placed.c"
    run("gcc", *STRICT, f"-I{package / 'c' / 'include'}", "-c", path, "-o", os.devnull)


def test_names_are_unique_without_regard_to_case() -> None:
    """And none is a word of C or of math.h."""
    names = Names(["in"])
    wishes = ["in", "IN", "a", "A", "double", "y1", "sqrtf", "a b", "1st", "__x__"]
    claimed = [names.claim(wish) for wish in wishes]
    assert claimed == [
        "in_2",
        "IN_3",
        "a",
        "A_2",
        "double_2",
        "y1_2",
        "sqrtf_2",
        "a_b",
        "v1st",
        "x",
    ]
    assert not RESERVED & {name.lower() for name in claimed}
    assert identifier("") == "value"
