"""Sine and cosine that the C evaluates itself, against the truth and bit for bit."""

from __future__ import annotations

import math
import shutil
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import pytest
from mpmath import mp

from symnav import ir, trigonometry
from symnav.emit import c
from symnav.export.arithmetic import sinusoids
from tests.emit_c import building
from tests.emit_c.building import Op, X, call
from tests.emit_c.modules import module

FLOAT, DOUBLE = ir.Scalar.FLOAT, ir.Scalar.DOUBLE
KINDS = {FLOAT: np.float32, DOUBLE: np.float64}
CLANG = next(filter(shutil.which, ("clang", "clang-19", "clang-14")), "")
needs_gcc = pytest.mark.skipif(not shutil.which("gcc"), reason="needs gcc")

LISTED = """
int main(void)
{
    real_t angle;

    while (fread(&angle, sizeof angle, 1, stdin) == 1U) {
        const real_t found[2] = {sine_of(angle), cosine_of(angle)};

        (void)fwrite(found, sizeof found, 1, stdout);
    }
    return 0;
}
"""

# The library's double precision judges floats, its extended precision judges doubles.
WORST = """
static double worst;

static double spacing(real_t value)
{
    return (double)(NEXTAFTER(FABS(value), (real_t)2.0) - FABS(value));
}

static void judge(real_t found, WIDE truth)
{
    const double error = (double)FABSW(truth - (WIDE)found) / spacing((real_t)truth);

    worst = (error > worst) ? error : worst;
    if (!(found >= (real_t)-1.0) || !(found <= (real_t)1.0)) {
        worst = HUGE_VAL;
    }
}

static void both(real_t angle)
{
    judge(sine_of(angle), SINW((WIDE)angle));
    judge(cosine_of(angle), COSW((WIDE)angle));
}
"""
FLOATS = """
#define NEXTAFTER nextafterf
#define FABS fabsf
#define WIDE double
#define FABSW fabs
#define SINW sin
#define COSW cos
"""
DOUBLES = """
#define NEXTAFTER nextafter
#define FABS fabs
#define WIDE long double
#define FABSW fabsl
#define SINW sinl
#define COSW cosl
"""
EVERY_FLOAT = """
int main(int count, char **given)
{
    const uint32_t step = (uint32_t)strtoul(given[count - 1], NULL, 10);

    for (float sign = -1.0F; sign < 2.0F; sign += 2.0F) {
        for (uint32_t bits = 0x39000000U; bits <= 0x42000000U; bits += step) {
            float angle;

            memcpy(&angle, &bits, sizeof angle);
            both(sign * angle);
        }
        step > 1U ? both(sign * 32.0F) : (void)0;
    }
    printf("%.4f", worst);
    return 0;
}
"""
MANY_DOUBLES = """
int main(int count, char **given)
{
    const long wanted = strtol(given[count - 1], NULL, 10);
    uint64_t state = 88172645463325252U;

    for (long k = 0; k < wanted; ++k) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        both(32.0 * ((double)(state >> 11) * 0x1p-52 - 1.0));
    }
    for (int turn = -20; turn <= 20; ++turn) { /* next to the zeros of both */
        double below = (double)(turn * (M_PIl / 2.0L)), above = below;

        for (int k = 0; k < 1000; ++k) {
            both(below);
            both(above);
            below = nextafter(below, -40.0);
            above = nextafter(above, 40.0);
        }
        for (double far = 1e-16; far < 1.0; far *= 1.01) {
            both((double)(turn * (M_PIl / 2.0L)) + far);
        }
    }
    printf("%.4f", worst);
    return 0;
}
"""


def program(folder: Path, scalar: ir.Scalar, text: str, *flags: str, compiler: str = "gcc") -> Path:
    """A program over the header of a tree that has sine and cosine."""
    waves = [((k,), call(op, ir.Load("x", 0))) for k, op in enumerate((Op.OWN_SIN, Op.OWN_COS))]
    function = building.function("f", [X], outputs=(building.output("value", (2,), waves),))
    tree = c.emit(module(function, scalar=scalar))
    prefix = next(Path(path).name for path in tree if path.endswith("_check.h"))[: -len("_check.h")]
    for path, content in tree.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(content, encoding="utf-8")
    headers = ["inttypes.h", "math.h", "stdint.h", "stdio.h", "stdlib.h", "string.h"]
    lines = ["#define _GNU_SOURCE", *(f"#include <{name}>" for name in headers)]
    lines += [f'#include "{prefix}_trigonometry.h"', f"typedef {prefix}_real_t real_t;"]
    (folder / "main.c").write_text("\n".join([*lines, text]), encoding="utf-8")
    command = [
        compiler,
        "-std=gnu99",
        "-Ic/include",
        "-Ic/src",
        *flags,
        "main.c",
        "-lm",
        "-o",
        "main",
    ]
    subprocess.run(command, cwd=folder, check=True)
    return folder / "main"


def evaluated(binary: Path, angles: np.ndarray) -> np.ndarray:
    """Sines and cosines, (2, count)."""
    done = subprocess.run([str(binary)], input=angles.tobytes(), capture_output=True, check=True)
    return np.frombuffer(done.stdout, dtype=angles.dtype).reshape(-1, 2).T


@needs_gcc
@pytest.mark.parametrize("flags", [("-O2",), ("-O3", "-march=native")], ids=["O2", "native"])
@pytest.mark.parametrize("scalar", KINDS)
def test_bits_are_those_of_plain_arithmetic(
    scalar: ir.Scalar, flags: Sequence[str], tmp_path: Path
) -> None:
    """What tests of bundles expect is what every compiler makes of it, beyond the limit too."""
    kind = KINDS[scalar]
    rng = np.random.default_rng(7)
    special = np.array([0.0, -0.0, 1e-30, 1e-44, math.inf, math.nan])
    quarters = 0.5 * math.pi * np.arange(-20, 21)
    angles = (rng.uniform(-32.0, 32.0, 20_000), rng.uniform(-900.0, 900.0, 200), quarters, special)
    given = np.concatenate(angles).astype(kind)
    sines, cosines = evaluated(
        program(tmp_path, scalar, LISTED, "-ffp-contract=off", *flags), given
    )
    with np.errstate(invalid="ignore"):
        expected = sinusoids.sine(given), sinusoids.cosine(given)
    assert expected[0].dtype == kind
    np.testing.assert_array_equal(sines, expected[0])
    np.testing.assert_array_equal(cosines, expected[1])
    assert np.isnan(sines[-2:]).all() and np.isnan(cosines[-2:]).all()


@needs_gcc
@pytest.mark.parametrize("contract", ["off", "fast"])
def test_floats_are_within_one_unit_in_the_last_place(contract: str, tmp_path: Path) -> None:
    """A thousandth of all floats from 2**-13 to the limit, of both signs, fused or not."""
    flags = ("-O2", "-march=native", f"-ffp-contract={contract}")
    binary = program(tmp_path, FLOAT, FLOATS + WORST + EVERY_FLOAT, *flags)
    worst = float(subprocess.run([str(binary), "997"], capture_output=True, check=True).stdout)
    assert 0.5 < worst < 1.0


@pytest.mark.slow
@needs_gcc
def test_every_float_is_within_one_unit_in_the_last_place(tmp_path: Path) -> None:
    """All of them: 300 million angles."""
    flags = ("-O2", "-ffp-contract=off")
    binary = program(tmp_path, FLOAT, FLOATS + WORST + EVERY_FLOAT, *flags)
    worst = float(subprocess.run([str(binary), "1"], capture_output=True, check=True).stdout)
    assert 0.5 < worst < 1.0


@needs_gcc
@pytest.mark.skipif(np.finfo(np.longdouble).nmant < 63, reason="needs a wider type to judge with")
@pytest.mark.parametrize("contract", ["off", "fast"])
def test_doubles_are_within_one_unit_in_the_last_place(contract: str, tmp_path: Path) -> None:
    """A million of them, and the neighbours of every zero."""
    flags = ("-O2", "-march=native", f"-ffp-contract={contract}")
    binary = program(tmp_path, DOUBLE, DOUBLES + WORST + MANY_DOUBLES, *flags)
    worst = float(subprocess.run([str(binary), "1000000"], capture_output=True, check=True).stdout)
    assert 0.5 < worst < 1.0


@pytest.mark.skipif(not CLANG, reason="needs clang")
def test_sums_are_not_regrouped_by_clang(tmp_path: Path) -> None:
    """It tells nobody that it may; a turn regrouped is no turn at all."""
    flags = ("-O2", "-funsafe-math-optimizations", "-ffp-contract=off")
    text = FLOATS + WORST + EVERY_FLOAT
    binary = program(tmp_path, FLOAT, text, *flags, compiler=CLANG)
    worst = float(subprocess.run([str(binary), "9973"], capture_output=True, check=True).stdout)
    assert worst < 4.0


@pytest.mark.parametrize(
    ("known", "bits"),
    [(trigonometry.DOUBLE, 56), (trigonometry.SINGLE, 26)],
    ids=["double", "single"],
)
def test_polynomials_are_what_they_stand_for(known: trigonometry.Coefficients, bits: int) -> None:
    """Their own errors, in 50 digits: relative for the sine, absolute for the cosine."""

    def polynomial(coefficients: Sequence[float], square: mp.mpf) -> mp.mpf:
        return mp.polyval([mp.mpf(k) for k in reversed(coefficients)], square)

    def sine(r: mp.mpf) -> mp.mpf:
        return (r + r**3 * polynomial(known.sine, r * r)) / mp.sin(r) - 1

    def cosine(r: mp.mpf) -> mp.mpf:
        return 1 - r * r / 2 + r**4 * polynomial(known.cosine, r * r) - mp.cos(r)

    with mp.workdps(50):
        rests = [mp.pi / 4 * k / 400 for k in range(1, 401)]
        forms: tuple[Callable[[mp.mpf], mp.mpf], ...] = (sine, cosine)
        for error in forms:
            assert max(abs(error(rest)) for rest in rests) < mp.mpf(2) ** -bits


@pytest.mark.parametrize(
    ("known", "kind", "digits"),
    [(trigonometry.DOUBLE, np.float64, 53), (trigonometry.SINGLE, np.float32, 24)],
    ids=["double", "single"],
)
def test_products_of_quarter_turns_are_exact(
    known: trigonometry.Coefficients, kind: type[np.floating], digits: int
) -> None:
    """Every number of quarter turns within the limit times the first two parts of pi/2."""
    most = round(trigonometry.LIMIT * known.quarters_per_radian)
    for part in known.parts[:2]:
        for quarters in range(most + 1):
            assert float(kind(quarters) * kind(part)) == quarters * part
            mantissa, _ = math.frexp(quarters * part)
            assert float(mantissa * 2.0**digits).is_integer()
    with mp.workdps(60):
        left = mp.pi / 2 - sum(mp.mpf(part) for part in known.parts)
        assert abs(left) < mp.mpf(known.parts[2]) * 2.0**-digits
    numbers = (known.quarters_per_radian, known.ones, *known.parts, *known.sine, *known.cosine)
    assert all(float(kind(number)) == number for number in numbers)
