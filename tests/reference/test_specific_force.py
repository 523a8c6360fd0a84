"""The specific-force correction against the integrated motion of a turning body.

C' = C [w x], v' = C f with rates that are polynomials in time, solved by Taylor's method: exact to
the last digit.
"""

from random import Random
from typing import Any

import pytest
from mpmath import mp, mpf

from .algebra import (
    Quantities,
    Vector,
    add,
    conjugate,
    cross,
    exponential,
    length,
    multiply,
    sandwich,
    scale,
    subtract,
)
from .drawing import far, numbers, quaternion, vector
from .specific_force import value

Series = list[Vector]
ZERO = [mpf(0)] * 3


def at(series: Series, t: mpf) -> Vector:
    """Evaluate a vector polynomial."""
    return add(*(scale(t**k, c) for k, c in enumerate(series)))


def integrated(series: Series) -> Series:
    """Integrate a vector polynomial from zero."""
    return [ZERO, *(scale(mpf(1) / (k + 1), c) for k, c in enumerate(series))]


def times(p: Series, vectors: Series) -> Series:
    """Multiply a quaternion series with a vector series, to the order of the former."""
    return [
        add(*(multiply(p[k - j], [mpf(0), *v]) for j, v in enumerate(vectors) if j <= k))
        for k in range(len(p))
    ]


def flown(omega: Series, force: Series, end: mpf) -> tuple[Vector, Vector]:
    """Integrate attitude and velocity from rest, by Taylor's recurrence."""
    attitude: Series = [[mpf(1), mpf(0), mpf(0), mpf(0)]]
    while (
        sum(length(c) * end ** (len(attitude) - 1) for c in attitude[-4:]) > mp.eps * mpf(10) ** -12
    ):
        k = len(attitude)
        terms = (multiply(attitude[k - 1 - j], [mpf(0), *w]) for j, w in enumerate(omega) if j < k)
        attitude.append(scale(1 / mpf(2 * k), add(*terms)))
    pushed = times(attitude, force)
    velocity = ZERO
    for i, p in enumerate(pushed):
        for k, q in enumerate(attitude[: len(attitude) - i]):
            power = i + k + 1
            part = multiply(p, conjugate(q))[1:]
            velocity = add(velocity, scale(end**power / power, part))
    return add(*(scale(end**k, c) for k, c in enumerate(attitude))), velocity


def sampled(omega: Series, force: Series, start: mpf, end: mpf, n: int) -> tuple[Vector, Vector]:
    """Give the flat increments that an ideal sensor puts out."""
    marks = [start + (end - start) * k / n for k in range(n + 1)]
    flat: list[Vector] = []
    for series in (omega, force):
        whole = integrated(series)
        ends = [at(whole, mark) for mark in marks]
        flat.append([x for k in range(n) for x in subtract(ends[k + 1], ends[k])])
    return flat[0], flat[1]


def increments(omega: Series, force: Series, end: mpf, n: int) -> dict[str, dict[str, Any]]:
    """Describe the quantities of one interval."""
    angles, velocities = sampled(omega, force, mpf(0), end, n)
    return {
        "delta_theta": vector(angles, "b"),
        "delta_velocity": vector(velocities, "b"),
        "dt": vector([end]),
    }


def sculling_of(motion: tuple[Series, Series], end: mpf) -> Vector:
    """Give what of the velocity is linear in the rotation, beyond 1/2 theta x dv."""
    omega, force = motion
    with mp.workdps(120):
        small = mpf(10) ** -30
        plus, minus = (
            flown([scale(sign * small, w) for w in omega], force, end)[1] for sign in (1, -1)
        )
        linear = scale(1 / (2 * small), subtract(plus, minus))
        theta, dv = at(integrated(omega), end), at(integrated(force), end)
        return subtract(linear, scale(mpf(1) / 2, cross(theta, dv)))


def sculling_term(q: Quantities, **options: object) -> Vector:
    """Isolate the sculling term of the reference."""
    base = {"rotation": "none", "output": "delta_velocity", **options}
    return subtract(value(q, base)["value"], value(q, base | {"sculling": "none"})["value"])


def profile(seed: int, degree: int) -> tuple[Series, Series]:
    """Draw polynomial rates."""
    rng = Random(seed)
    return [numbers(rng) for _ in range(degree + 1)], [
        numbers(rng, 3, 10) for _ in range(degree + 1)
    ]


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5])
@pytest.mark.parametrize("seed", range(3))
def test_polynomial_sculling_is_exact(n: int, seed: int) -> None:
    """With n increments, rates of degree n - 1 leave no error linear in the rotation; n does."""
    end = mpf("0.3")
    for degree, smallest, largest in ((n - 1, 0, mpf("1e-40")), (n, mpf("1e-9"), 1)):
        motion = profile(seed, degree)
        term = sculling_term(increments(*motion, end, n))
        assert smallest <= far(term, sculling_of(motion, end)) < largest


def test_previous_increment_is_exact_for_linear_rates() -> None:
    """One increment and its predecessor of the same length."""
    motion, end = profile(7, 1), mpf("0.2")
    angles, velocities = sampled(*motion, -end, mpf(0), 1)
    q = increments(*motion, end, 1)
    q["previous_delta_theta"] = vector(angles, "b")
    q["previous_delta_velocity"] = vector(velocities, "b")
    for kind in ("polynomial", "harmonic"):
        term = sculling_term(q, samples="previous", sculling=kind)
        assert far(term, sculling_of(motion, end)) < mpf("1e-40")


def test_rates_are_exact_for_linear_rates() -> None:
    """Rates at both ends."""
    (omega, force), end = profile(8, 1), mpf("0.2")
    q = {
        "angular_rate_start": vector(at(omega, mpf(0)), "b"),
        "angular_rate_end": vector(at(omega, end), "b"),
        "specific_force_start": vector(at(force, mpf(0)), "b"),
        "specific_force_end": vector(at(force, end), "b"),
        "dt": vector([end]),
    }
    term = sculling_term(q, input="rates")
    assert far(term, sculling_of((omega, force), end)) < mpf("1e-40")
    by_increments = value(increments(omega, force, end, 2), {})["value"]
    assert far(value(q, {"input": "rates"})["value"], by_increments) < mpf("1e-45")


@pytest.mark.parametrize("n", [2, 3, 5])
def test_harmonic_sculling(n: int) -> None:
    """The classical rule is exact for linear rates, worse than n = 2 for quadratic ones."""
    end = mpf("0.04")
    motion = profile(9, 1)
    term = sculling_term(increments(*motion, end, n), sculling="harmonic")
    assert far(term, sculling_of(motion, end)) < mpf("1e-40")
    motion = profile(9, 2)
    truth = sculling_of(motion, end)
    two = far(sculling_term(increments(*motion, end, 2)), truth)
    many = far(sculling_term(increments(*motion, end, n), sculling="harmonic"), truth)
    assert many == two if n == 2 else many > 10 * two


@pytest.mark.parametrize("epoch", ["start", "mid", "end"])
@pytest.mark.parametrize("angle", ["0", "1e-20", "1e-6", "0.3", "2.5", "7"])
def test_exact_rotation_for_steady_rates(epoch: str, angle: str) -> None:
    """With steady rates the exact correction is the motion, seen from the epoch's attitude."""
    rng, end = Random(10), mpf("0.5")
    direction = numbers(rng)
    motion = [scale(mpf(angle), direction)], [numbers(rng, 3, 10)]
    q = increments(*motion, end, 1)
    _, velocity = flown(*motion, end)
    part = {"start": 0, "mid": mpf(1) / 2, "end": 1}[epoch]
    epoch_attitude = exponential(scale(part, q["delta_theta"]["value"]))
    seen = sandwich(conjugate(epoch_attitude), velocity)
    options = {"rotation": "exact", "epoch": epoch, "output": "delta_velocity"}
    assert far(value(q, options)["value"], seen) < mpf("1e-44")


@pytest.mark.parametrize("epoch", ["start", "mid", "end"])
def test_closed_form_of_exact_rotation(epoch: str) -> None:
    """The power series sums to the closed forms."""
    rng = Random(11)
    theta, dv = numbers(rng), numbers(rng)
    a = mp.sqrt(mp.fdot(theta, theta))
    once, twice = cross(theta, dv), cross(theta, cross(theta, dv))
    c2, c3 = (1 - mp.cos(a)) / a**2, (a - mp.sin(a)) / a**3
    k = (1 - mp.sin(a / 2) / (a / 2)) / a**2
    first, second = {"start": (c2, c3), "mid": (mpf(0), k), "end": (-c2, c3)}[epoch]
    closed = add(dv, scale(first, once), scale(second, twice))
    q = {"delta_theta": vector(theta), "delta_velocity": vector(dv), "dt": vector([mpf(1)])}
    assert far(value(q, {"rotation": "exact", "epoch": epoch})["value"], closed) < mpf("1e-45")


@pytest.mark.parametrize("epoch", ["start", "mid", "end"])
@pytest.mark.parametrize(("rotation", "order"), [("half", 3), ("exact", 4)])
def test_order_with_sculling(epoch: str, rotation: str, order: int) -> None:
    """Two samples of linear rates: what is left falls with the order it should."""
    motion = profile(12, 1)
    errors = []
    for end in (mpf("1e-5"), mpf("5e-6")):
        q = increments(*motion, end, 2)
        _, velocity = flown(*motion, end)
        theta = at(integrated(motion[0]), end)
        part = {"start": 0, "mid": mpf(1) / 2, "end": 1}[epoch]
        seen = sandwich(conjugate(exponential(scale(part, theta))), velocity)
        options = {"rotation": rotation, "epoch": epoch, "output": "delta_velocity"}
        errors.append(far(value(q, options)["value"], seen))
    assert abs(mp.log(errors[0] / errors[1], 2) - order) < mpf("0.01")


def test_biases_are_removed_from_every_increment() -> None:
    """A biased sensor with its biases given yields what an ideal one does, in every mode."""
    rng = Random(13)
    gyro, accelerometer, dt = numbers(rng), numbers(rng), mpf("0.02")
    biases = {"gyro_bias": vector(gyro, "b"), "accelerometer_bias": vector(accelerometer, "b")}
    cases: list[tuple[dict[str, int], dict[str, object]]] = [
        ({"delta_theta": 3, "delta_velocity": 3}, {"sculling": "harmonic"}),
        (
            dict.fromkeys(
                (
                    "delta_theta",
                    "delta_velocity",
                    "previous_delta_theta",
                    "previous_delta_velocity",
                ),
                1,
            ),
            {"samples": "previous"},
        ),
        (
            dict.fromkeys(
                (f"{k}_{e}" for k in ("angular_rate", "specific_force") for e in ("start", "end")),
                0,
            ),
            {"input": "rates"},
        ),
    ]
    for names, options in cases:
        ideal, biased = {"dt": vector([dt])}, {"dt": vector([dt]), **biases}
        for name, count in names.items():
            drawn = numbers(rng, 3 * max(count, 1))
            b = gyro if "theta" in name or "angular" in name else accelerometer
            share = scale(dt / count if count else mpf(1), b)
            ideal[name] = vector(drawn, "b")
            biased[name] = vector(add(drawn, share * max(count, 1)), "b")
        assert far(value(ideal, options)["value"], value(biased, options)["value"]) < mpf("1e-46")


def test_attitude_by_frames() -> None:
    """An attitude stored the other way round, or as a matrix, gives the same force."""
    rng = Random(14)
    q = increments(*profile(14, 1), mpf("0.1"), 2)
    attitude = quaternion(rng)
    one = value({**q, "attitude": {"wxyz": attitude, "maps": ("b", "n")}}, {})["value"]
    other = value({**q, "attitude": {"wxyz": conjugate(attitude), "maps": ("n", "b")}}, {})["value"]
    units = [[mpf(int(i == j)) for i in range(3)] for j in range(3)]
    columns = [sandwich(attitude, unit) for unit in units]
    matrix = [columns[j][i] for i in range(3) for j in range(3)]
    third = value({**q, "attitude": {"matrix": matrix, "maps": ("b", "n")}}, {})["value"]
    body = value(q, {"output": "delta_velocity"})["value"]
    assert far(one, scale(10, sandwich(attitude, body))) < mpf("1e-46")
    assert far(one, other) < mpf("1e-46")
    assert far(one, third) < mpf("1e-46")


def test_interval_is_optional() -> None:
    """Without biases a velocity increment needs no interval; with them it does."""
    q = increments(*profile(15, 1), mpf("0.1"), 2)
    options = {"output": "delta_velocity"}
    with_interval = value(q, options)["value"]
    del q["dt"]
    assert value(q, options)["value"] == with_interval
    with pytest.raises(ValueError, match="dt"):
        value({**q, "gyro_bias": vector([mpf(1)] * 3)}, options)
