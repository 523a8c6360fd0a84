"""Specific force of an inertial unit from its increments or rates, corrected for rotation.

f = C (dv + rotation correction + sculling) / dt over one interval. Sources: Savage, Strapdown
inertial navigation integration algorithm design, part 2, 1998; Titterton and Weston, Strapdown
Inertial Navigation Technology, 11.4; NavToolkit ``calc_force_ned``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

import sympy as sp

from symnav.equations.bound import Bound, Results, parts
from symnav.equations.model import (
    Model,
    OptionValue,
    Role,
    Scene,
    choice,
    rotation,
    scalar,
    vector,
)
from symnav.frames import series
from symnav.graph import Guard
from symnav.quantities import (
    Quantity,
    cross,
    dot,
    let,
    named,
    over,
    rotate,
    total,
)
from symnav.quantities import series as polynomial

#: Weights of the earlier sub-samples against the last, exact for sustained sculling motion.
HARMONIC: Mapping[int, tuple[Fraction, ...]] = {
    1: (),
    2: (Fraction(2, 3),),
    3: (Fraction(9, 20), Fraction(27, 20)),
    4: (Fraction(54, 105), Fraction(92, 105), Fraction(214, 105)),
    5: (Fraction(250, 504), Fraction(525, 504), Fraction(650, 504), Fraction(1375, 504)),
}
SAMPLES = (1, 2, 3, 4, 5)


def specific_force(q: Bound) -> Results:
    """F = C (dv + c2 theta x dv + c3 theta x (theta x dv) + S) / dt."""
    source = _from_rates if q.options["input"] == "rates" else _from_increments
    theta, velocity, sculling = source(q)
    corrected = total(velocity, *_rotation(q, theta, velocity), sculling)
    attitude = q.rotation("attitude")
    if q.options["output"] == "specific_force":
        corrected = let("force", over(corrected, q.vector("dt")))
    if attitude is not None:
        corrected = rotate(attitude, let("corrected", corrected), "resolved")
    return Results({"value": corrected})


def _from_increments(q: Bound) -> tuple[Quantity, Quantity, Quantity | None]:
    """Total angle, total velocity increment and sculling from sub-samples, bias taken out."""
    count = int(q.options["samples"])
    angles = _debiased(q, "delta_theta", "gyro_bias", count, "a")
    velocities = _debiased(q, "delta_velocity", "accelerometer_bias", count, "v")
    theta = let("theta", total(*angles)) if count > 1 else angles[0]
    velocity = let("velocity", total(*velocities)) if count > 1 else velocities[0]
    if q.has("previous_delta_theta"):
        before = _debiased(q, "previous_delta_theta", "gyro_bias", 1, "a_before")[0]
        moved = _debiased(q, "previous_delta_velocity", "accelerometer_bias", 1, "v_before")[0]
        return theta, velocity, _twelfth(before, velocity, moved, theta)
    return theta, velocity, _sculling(q, angles, velocities)


def _debiased(q: Bound, role: str, bias_role: str, count: int, name: str) -> list[Quantity]:
    """Sub-increments less bias times sub-interval.

    Polynomial sculling has every one of them in a cross product of its own, so they have names.
    Otherwise only sums of them and the last one count, and a sum takes the bias once.
    """
    pieces = parts(q.vector(role))
    bias = q.optional(bias_role)
    if bias is None:
        return pieces
    dt = q.vector("dt")
    if count > 1:
        dt = let(f"{role}_dt", _fraction(Fraction(1, count)) * dt)
    step = let(f"{bias_role}_step", dt * bias)
    if count > 1 and q.options["sculling"] != "polynomial":
        return [piece - step for piece in pieces]
    names = [name] if count == 1 else [f"{name}{k}" for k in range(1, count + 1)]
    return [let(label, piece - step) for label, piece in zip(names, pieces, strict=True)]


def _sculling(
    q: Bound, angles: Sequence[Quantity], velocities: Sequence[Quantity]
) -> Quantity | None:
    """S = sum over i < j of W_ij (a_i x v_j + v_i x a_j)."""
    kind, count = q.options["sculling"], len(angles)
    if kind == "none" or count == 1:
        return None
    if kind == "harmonic":
        weights = HARMONIC[count]
        return _pair("harmonic", weights, angles, velocities, count - 1)
    table = polynomial_weights(count)
    return total(
        *(
            _pair(f"sculling{j + 1}", [table[i, j] for i in range(j)], angles, velocities, j)
            for j in range(1, count)
        )
    )


def _pair(
    name: str,
    weights: Sequence[Fraction],
    angles: Sequence[Quantity],
    velocities: Sequence[Quantity],
    j: int,
) -> Quantity:
    """(sum w_i a_i) x v_j + (sum w_i v_i) x a_j."""
    angle = let(f"{name}_angle", _weighted(weights, angles))
    velocity = let(f"{name}_velocity", _weighted(weights, velocities))
    a, v = (named(x[j], f"{letter}{j + 1}") for letter, x in (("a", angles), ("v", velocities)))
    return cross(angle, v) + cross(velocity, a)


def _weighted(weights: Sequence[Fraction], pieces: Sequence[Quantity]) -> Quantity:
    return total(*(_fraction(w) * p for w, p in zip(weights, pieces, strict=False)))


def polynomial_weights(count: int) -> dict[tuple[int, int], Fraction]:
    """W_ij from rates that are polynomials of degree count - 1 through the increments, exactly.

    With w = sum_k w_k and f = sum_k f_k over monomials of tau in [0, count],
    S = 1/2 integral (alpha x f - w x v); the (i, j) weight is the antisymmetric part of the
    bilinear form in the increments a_i and v_j.
    """
    degree = range(count)
    # increments[i][k]: increment of sub-interval i when the rate is tau^k.
    increments = [
        [Fraction((i + 1) ** (k + 1) - i ** (k + 1), k + 1) for k in degree] for i in degree
    ]
    rates = _inverse(increments)
    # form[k][m] of 1/2 integral (alpha_k x f_m - w_k x v_m), alpha_k = tau^(k+1)/(k+1).
    form = [[_moment(k, m, count) for m in degree] for k in degree]
    weights = {}
    for i in degree:
        for j in degree:
            if i < j:
                weights[i, j] = sum(
                    (rates[k][i] * form[k][m] * rates[m][j] for k in degree for m in degree),
                    Fraction(0),
                )
    return weights


def _moment(k: int, m: int, end: int) -> Fraction:
    """1/2 (1/(k+1) - 1/(m+1)) times the integral of tau^(k+m+1) from 0 to ``end``."""
    return Fraction((m - k) * end ** (k + m + 2), 2 * (k + 1) * (m + 1) * (k + m + 2))


def _inverse(matrix: Sequence[Sequence[Fraction]]) -> list[list[Fraction]]:
    """Inverse by Gauss-Jordan elimination in exact arithmetic."""
    size = len(matrix)
    rows = [[*row, *(Fraction(int(i == j)) for j in range(size))] for i, row in enumerate(matrix)]
    for pivot in range(size):
        best = next(r for r in range(pivot, size) if rows[r][pivot] != 0)
        rows[pivot], rows[best] = rows[best], rows[pivot]
        scale = rows[pivot][pivot]
        rows[pivot] = [e / scale for e in rows[pivot]]
        for r in range(size):
            if r != pivot:
                factor = rows[r][pivot]
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[pivot], strict=True)]
    return [row[size:] for row in rows]


def _twelfth(before: Quantity, velocity: Quantity, moved: Quantity, theta: Quantity) -> Quantity:
    """S = (a0 x v1 + v0 x a1) / 12, from the previous interval and this one."""
    twelfth = _fraction(Fraction(1, 12))
    return cross(let("a_twelfth", twelfth * before), velocity) + cross(
        let("v_twelfth", twelfth * moved), theta
    )


def _from_rates(q: Bound) -> tuple[Quantity, Quantity, Quantity | None]:
    """Trapezoidal increments from the rates at both ends, and S = dt^2/12 (w0 x df + f0 x dw)."""
    dt = q.vector("dt")
    gyro, accelerometer = q.optional("gyro_bias"), q.optional("accelerometer_bias")
    w0, w1 = _less(q, "angular_rate_start", gyro), _less(q, "angular_rate_end", gyro)
    f0 = _less(q, "specific_force_start", accelerometer)
    f1 = _less(q, "specific_force_end", accelerometer)
    half = let("half_dt", 0.5 * dt)
    theta = let("theta", half * let("rate_sum", w0 + w1))
    velocity = let("velocity", half * let("force_sum", f0 + f1))
    if q.options["sculling"] == "none":
        return theta, velocity, None
    factor = let("dt_squared_twelfth", _fraction(Fraction(1, 12)) * (dt * dt))
    turning = cross(w0, let("force_change", f1 - f0)) + cross(f0, let("rate_change", w1 - w0))
    return theta, velocity, factor * let("sculling_rate", turning)


def _less(q: Bound, role: str, bias: Quantity | None) -> Quantity:
    rate = q.vector(role)
    return rate if bias is None else let(f"{role}_true", rate - bias)


def _rotation(q: Bound, theta: Quantity, velocity: Quantity) -> tuple[Quantity, ...]:
    """The terms that the body's turning adds, by the epoch of the attitude."""
    kind, epoch = q.options["rotation"], q.options["epoch"]
    if kind == "none" or (kind == "half" and epoch == "mid"):
        return ()
    sign = {"start": 1.0, "mid": 0.0, "end": -1.0}[str(epoch)]
    if kind == "half":
        return (cross(let("half_theta", 0.5 * sign * theta), velocity),)
    bound, reachable = _largest_turn(q)
    guard = Guard(0.0, bound, 0.0, "squared rotation over the interval, bias taken out")
    t = let("theta_squared", dot(theta, theta), guard if reachable > bound else None)
    turned = let("theta_cross_velocity", cross(theta, velocity))
    twice = let("theta_cross_twice", cross(theta, turned))
    if epoch == "mid":
        k = polynomial("mid_coefficient", t, series.coefficients(series.mid_interval, bound))
        return (k * twice,)
    c2 = polynomial("c2", t, series.coefficients(series.one_minus_cosine, bound))
    c3 = polynomial("c3", t, series.coefficients(series.angle_minus_sine, bound))
    return (sign * (c2 * turned), c3 * twice)


def _largest_turn(q: Bound) -> tuple[float, float]:
    """Squared rotation the series are made for, and the largest the declared ranges allow.

    The bias is taken out of the increments and may add to them. One that more than doubles the
    declared rotation, or takes it beyond pi, is left to a guard instead of to longer series.
    """
    longest = q.domains["dt"][0][1] if q.has("dt") else 0.0
    if q.options["input"] == "rates":
        rate = max(q.largest_square("angular_rate_start"), q.largest_square("angular_rate_end"))
        declared = rate**0.5 * longest
    else:
        declared = q.largest_square("delta_theta", int(q.options["samples"])) ** 0.5
    bias = q.largest_square("gyro_bias") ** 0.5 * longest if q.has("gyro_bias") else 0.0
    limit = min(declared + bias, max(declared, min(2.0 * declared, series.LARGEST_ANGLE)))
    return limit**2, (declared + bias) ** 2


def _fraction(value: Fraction) -> sp.Rational:
    return sp.Rational(value.numerator, value.denominator)


def _conventions(options: Mapping[str, OptionValue]) -> tuple[str, ...]:
    given = "rates at both ends of the interval" if options["input"] == "rates" else "increments"
    return (
        f"Input: {given}, {options['increments']}, resolved in the body frame.",
        f"The attitude is that at the {options['epoch']} of the interval; rotation correction "
        f"{options['rotation']}, sculling {options['sculling']}.",
        "Angles are with respect to inertial space; the rotation of the navigation frame over one "
        "interval is neglected.",
        f"Output: {str(options['output']).replace('_', ' ')}.",
    )


def _check(
    options: Mapping[str, OptionValue], bound: frozenset[str]
) -> tuple[tuple[str, str], ...]:
    problems = []
    rates = options["input"] == "rates"
    wanted = RATE_ROLES if rates else INCREMENT_ROLES
    problems += [
        (role, f"input = {options['input']!r} needs {role} bound")
        for role in wanted
        if role not in bound
    ]
    problems += [
        (role, f"input = {options['input']!r} does not use {role}; leave it out")
        for role in (INCREMENT_ROLES if rates else RATE_ROLES)
        if role in bound
    ]
    previous = {"previous_delta_theta", "previous_delta_velocity"} & bound
    if len(previous) == 1:
        problems.append((next(iter(previous)), "bind both previous increments or neither"))
    if previous and (options["samples"] != 1 or rates):
        problems.append(("samples", "the previous increment goes with samples = 1"))
    if previous and options["sculling"] == "none":
        problems.append(
            ("sculling", "previous increments serve sculling; leave them out or ask for it")
        )
    corrected = [key for key in ("rotation", "sculling") if options[key] != "none"]
    pairs = options["samples"] != 1 or rates  # what sculling works on
    corrected = [key for key in corrected if key == "rotation" or pairs]
    if options["increments"] == "compensated" and (corrected or previous):
        problems.append(
            (
                "increments",
                "double correction: compensated increments already hold the rotation and "
                "sculling corrections; set rotation = 'none' and sculling = 'none', or "
                "increments = 'raw'",
            )
        )
    if rates and options["samples"] != 1:
        problems.append(
            ("samples", "rates are those at the ends of the interval; they have no sub-samples")
        )
    if previous and options["sculling"] == "harmonic":
        problems.append(
            ("sculling", "harmonic sculling needs sub-samples; the previous increments use "
             "'polynomial'")
        )  # fmt: skip
    if options["sculling"] == "harmonic" and rates:
        problems.append(("sculling", "harmonic sculling needs sub-samples; rates use 'polynomial'"))
    needs_dt = options["output"] == "specific_force" or rates
    needs_dt = needs_dt or bool({"gyro_bias", "accelerometer_bias"} & bound)
    if needs_dt and "dt" not in bound:
        problems.append(("dt", "the interval is needed here: bind dt"))
    return tuple(problems)


def _drift(q: Bound) -> Quantity | None:
    """Increments that are the bias alone: nothing is left of them once it is taken out."""
    bias, dt = q.optional("gyro_bias"), q.optional("dt")
    if bias is None or dt is None:
        return None
    count = int(q.options["samples"])
    step = _fraction(Fraction(1, count)) * (dt * bias)
    return Quantity(q.graph, step.elements * count, step.unit, step.frame)


INCREMENT_ROLES = ("delta_theta", "delta_velocity")
RATE_ROLES = (
    "angular_rate_start",
    "angular_rate_end",
    "specific_force_start",
    "specific_force_end",
)


def _rate(name: str, unit: str, bound: float, description: str) -> Role:
    return vector(name, unit, "body", bound, description, optional=True)


MODELS = (
    Model(
        name="specific_force",
        section="correction",
        title="Specific force corrected for rotation and sculling",
        equation="f = C (dv + c2 theta x dv + c3 theta x (theta x dv) + S) / dt",
        source="Savage 1998 part 2; Titterton and Weston 11.4; NavToolkit calc_force_ned",
        roles=(
            rotation("attitude", "body -> nav", "C, attitude of the body at the epoch.",
                     optional=True),
            vector("delta_theta", "rad", "body", 0.2, "Angle increments, oldest sub-sample first.",
                   size="3*samples", optional=True),
            vector("delta_velocity", "m/s", "body", 50.0, "Velocity increments, oldest sub-sample "
                   "first.", size="3*samples", optional=True),
            vector("previous_delta_theta", "rad", "body", 0.2, "Angle increment of the interval "
                   "before.", optional=True),
            vector("previous_delta_velocity", "m/s", "body", 50.0, "Velocity increment of the "
                   "interval before.", optional=True),
            _rate("angular_rate_start", "rad/s", 20.0, "Angular rate at the start."),
            _rate("angular_rate_end", "rad/s", 20.0, "Angular rate at the end."),
            _rate("specific_force_start", "m/s^2", 500.0, "Specific force at the start."),
            _rate("specific_force_end", "m/s^2", 500.0, "Specific force at the end."),
            scalar("dt", "s", 1e-5, 0.05, "Length of the interval.", optional=True, positive=True),
            vector("accelerometer_bias", "m/s^2", "body", 10.0, "Accelerometer bias.",
                   optional=True),
            vector("gyro_bias", "rad/s", "body", 0.2, "Gyroscope bias.", optional=True),
        ),
        options=(
            choice("samples", SAMPLES, "Sub-samples per interval."),
            choice("input", ("increments", "rates"), "What the inertial unit gives."),
            choice("rotation", ("half", "exact", "none"), "Rotation correction."),
            choice("sculling", ("polynomial", "harmonic", "none"), "Sculling correction."),
            choice("epoch", ("start", "mid", "end"), "End of the interval the attitude is of."),
            choice("increments", ("raw", "compensated"), "Whether they are already corrected."),
            choice("output", ("specific_force", "delta_velocity"), "Result."),
        ),
        mapped=False,
        always_double=False,
        function=specific_force,
        conventions=_conventions,
        check=_check,
        scenes=(Scene("delta_theta", "no rotation beside the bias", _drift),),
    ),
)  # fmt: skip
