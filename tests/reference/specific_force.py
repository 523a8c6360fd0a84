"""Mean specific force, or velocity increment, over an interval during which the body turns.

The increment resolved in the axes of one epoch is the integral of Exp(rotation since that epoch) f
dt: to first order in the rotation it is dv + 1/2 dtheta x dv + S at the start, dv - 1/2 dtheta x dv
+ S at the end. The epoch ``mid`` means the attitude half the *total* rotation away from either end,
so the same S belongs to all three.
"""

from collections.abc import Sequence

from mpmath import mp, mpf

from .algebra import (
    Options,
    Outputs,
    Quantities,
    Vector,
    add,
    cross,
    exact,
    length,
    scale,
    subtract,
    turn,
)
from .sculling import Weights, harmonic_weights, polynomial_weights

ZERO = [mpf(0)] * 3
BEFORE = {"start": mpf(0), "mid": mpf(1) / 2, "end": mpf(1)}
"""Part of the interval that precedes the epoch of the attitude."""
FRAME_BEARERS = ("delta_velocity", "delta_theta", "specific_force_start", "angular_rate_start")


def triples(flat: Sequence[mpf]) -> list[Vector]:
    """Split a flat list into vectors of three."""
    return [list(flat[i : i + 3]) for i in range(0, len(flat), 3)]


def bias(q: Quantities, name: str) -> Vector:
    """Give a bias, zero where none is bound."""
    return list(q[name]["value"]) if name in q else ZERO


def interval(q: Quantities) -> mpf:
    """Give the length of the interval; zero where it is not bound, since nothing then scales it."""
    biased = "gyro_bias" in q or "accelerometer_bias" in q
    if "dt" not in q and biased:
        raise ValueError("biases act over an interval: dt must be bound")
    return q["dt"]["value"][0] if "dt" in q else mpf(0)


def steadily_turned(theta: Vector, dv: Vector, before: mpf) -> Vector:
    """Integrate Exp(theta (s - before)) dv over s from 0 to 1, as a power series in theta."""
    total, term, order = ZERO, dv, 0
    while True:
        part = ((1 - before) ** (order + 1) - (-before) ** (order + 1)) / mp.factorial(order + 1)
        total = add(total, scale(part, term))
        order += 1
        term = cross(theta, term)
        if length(term) / mp.factorial(order) <= mp.eps * length(dv) / 1000:
            return total


def rotated(theta: Vector, dv: Vector, options: Options) -> Vector:
    """Apply the rotation correction."""
    kind = options.get("rotation", "half")
    before = BEFORE[options.get("epoch", "start")]
    if kind == "none":
        return dv
    if kind == "half":
        return add(dv, scale(mpf(1) / 2 - before, cross(theta, dv)))
    if kind == "exact":
        with mp.extradps(10 + int(length(theta))):
            return steadily_turned(theta, dv, before)
    raise ValueError(f"unknown rotation option {kind!r}")


def bilinear(weights: Weights, angles: list[Vector], velocities: list[Vector]) -> Vector:
    """Sum K_ij a_i x v_j over all pairs."""
    terms = [
        scale(exact(weights[i][j]), cross(a, v))
        for i, a in enumerate(angles)
        for j, v in enumerate(velocities)
    ]
    return add(*terms)


def increments(q: Quantities, options: Options) -> tuple[Vector, Vector, Vector]:
    """Give total rotation, total velocity increment and sculling term from increments.

    Every sub-increment of the interval loses its share of the biases; a previous increment spans a
    whole interval of the same length and loses as much as that.
    """
    angles, velocities = triples(q["delta_theta"]["value"]), triples(q["delta_velocity"]["value"])
    n, dt = len(angles), interval(q)
    previous = options.get("samples") == "previous"
    memory = int(previous or "previous_delta_theta" in q)
    if len(velocities) != n or options.get("samples", n) not in (n, "previous"):
        raise ValueError("delta_theta, delta_velocity and the option samples do not agree")
    if memory and n != 1:
        raise ValueError("a previous increment goes with a single sample")
    share = dt / n
    angles = [subtract(a, scale(share, bias(q, "gyro_bias"))) for a in angles]
    velocities = [subtract(v, scale(share, bias(q, "accelerometer_bias"))) for v in velocities]
    theta, dv = add(*angles), add(*velocities)
    kind = options.get("sculling", "polynomial")
    if kind == "none":
        return theta, dv, ZERO
    if kind not in ("polynomial", "harmonic"):
        raise ValueError(f"unknown sculling option {kind!r}")
    if memory:
        earlier = q["previous_delta_theta"]["value"], q["previous_delta_velocity"]["value"]
        angles.insert(0, subtract(earlier[0], scale(dt, bias(q, "gyro_bias"))))
        velocities.insert(0, subtract(earlier[1], scale(dt, bias(q, "accelerometer_bias"))))
    by_fit = kind == "polynomial" or memory or n == 1
    weights = polynomial_weights(n, memory) if by_fit else harmonic_weights(n)
    return theta, dv, bilinear(weights, angles, velocities)


def rates(q: Quantities, options: Options) -> tuple[Vector, Vector, Vector]:
    """Give the same from rates at the two ends that vary linearly between them.

    The integrand of the sculling term is then a cubic in time, which Simpson's rule integrates
    exactly.
    """
    dt = q["dt"]["value"][0]
    w0, w1 = (
        subtract(q[f"angular_rate_{end}"]["value"], bias(q, "gyro_bias"))
        for end in ("start", "end")
    )
    f0, f1 = (
        subtract(q[f"specific_force_{end}"]["value"], bias(q, "accelerometer_bias"))
        for end in ("start", "end")
    )

    def rate(start: Vector, end: Vector, s: mpf) -> Vector:
        return add(scale(1 - s, start), scale(s, end))

    def reached(start: Vector, end: Vector, s: mpf) -> Vector:
        return scale(dt * s, rate(start, end, s / 2))

    def integrand(s: mpf) -> Vector:
        return subtract(
            cross(reached(w0, w1, s), rate(f0, f1, s)), cross(rate(w0, w1, s), reached(f0, f1, s))
        )

    sculling = ZERO
    if options.get("sculling", "polynomial") != "none":
        ends = add(integrand(mpf(0)), integrand(mpf(1)))
        sculling = scale(dt / 12, add(ends, scale(mpf(4), integrand(mpf(1) / 2))))
    return reached(w0, w1, mpf(1)), reached(f0, f1, mpf(1)), sculling


def body_frame(q: Quantities) -> str | None:
    """Name the sensor's frame; without a name on the data, ``b`` if the attitude knows it."""
    for name in FRAME_BEARERS:
        if name in q and q[name].get("frame") is not None:
            return str(q[name]["frame"])
    return "b" if "b" in q["attitude"]["maps"] else None


def value(q: Quantities, options: Options) -> Outputs:
    """Give the corrected specific force, or velocity increment, in the frame of the attitude."""
    source = rates if options.get("input", "increments") == "rates" else increments
    theta, dv, sculling = source(q, options)
    total = add(rotated(theta, dv, options), sculling)
    if "attitude" in q:
        form = options.get("quaternion", "homogeneous")
        total = turn(q["attitude"], total, body_frame(q), form)
    output = options.get("output", "specific_force")
    if output == "delta_velocity":
        return {"value": total}
    if output == "specific_force":
        return {"value": scale(1 / q["dt"]["value"][0], total)}
    raise ValueError(f"unknown output option {output!r}")
