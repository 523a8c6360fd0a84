"""Rotations: quaternion to matrix, exponential and logarithm, products; all symbolic.

Quaternions are Hamilton and in the order w, x, y, z here, whatever the storage order of a block;
``R(q)`` maps vectors resolved in the quaternion's source frame to its target frame.
Source: J. Sola, Quaternion kinematics for the error-state Kalman filter, 2017, chapters 1 to 4.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import sympy as sp

from symnav.frames import series
from symnav.graph import Graph, Guard, Matrix, Row, rows_of
from symnav.quantities import horner

NAMES = tuple(f"{i}{j}" for i in range(3) for j in range(3))
#: Below this squared angle the series is used, above it the closed form.
SERIES_LIMIT = sp.Rational(1, 100)


def unit_quaternion_matrix(graph: Graph, name: str, q: Row) -> Row:
    """Nine entries of R(q) in the form 1 - 2(yy + zz), for a unit quaternion (24 operations)."""
    w, x, y, z = q
    x2, y2, z2 = graph.define(f"{name}_twice", [2 * x, 2 * y, 2 * z])
    xx, yy, zz, xy, xz, yz, wx, wy, wz = graph.define(
        f"{name}_twice",
        [x * x2, y * y2, z * z2, x * y2, x * z2, y * z2, w * x2, w * y2, w * z2],
        suffixes=("xx", "yy", "zz", "xy", "xz", "yz", "wx", "wy", "wz"),
    )
    return graph.define(
        name,
        [
            1 - (yy + zz), xy - wz, xz + wy,
            xy + wz, 1 - (xx + zz), yz - wx,
            xz - wy, yz + wx, 1 - (xx + yy),
        ],
        suffixes=NAMES,
    )  # fmt: skip


def homogeneous_entries(q: Row) -> Row:
    """Nine entries of |q|^2 R(q): the polynomial w^2 + x^2 - y^2 - z^2 and so on."""
    w, x, y, z = q
    return (
        w * w + x * x - y * y - z * z, 2 * x * y - 2 * w * z, 2 * x * z + 2 * w * y,
        2 * x * y + 2 * w * z, w * w - x * x + y * y - z * z, 2 * y * z - 2 * w * x,
        2 * x * z - 2 * w * y, 2 * y * z + 2 * w * x, w * w - x * x - y * y + z * z,
    )  # fmt: skip


def homogeneous_matrix(graph: Graph, name: str, q: Row) -> Row:
    """Named entries of the homogeneous form, which NavToolkit differentiates by raw elements."""
    return graph.define(name, homogeneous_entries(q), suffixes=NAMES)


def normalised_matrix(graph: Graph, name: str, q: Row, guard: Guard) -> tuple[Row, sp.Expr]:
    """Named entries of R(q / |q|) and the squared norm they were divided by."""
    (square,) = graph.define(f"{name}_squared_norm", [sp.Add(*(e * e for e in q))], guard=guard)
    raw = graph.define(f"{name}_raw", homogeneous_entries(q), suffixes=NAMES)
    return graph.define(name, [e / square for e in raw], suffixes=NAMES), square


def homogeneous_gradient(q: Row) -> Matrix:
    """d(entry of |q|^2 R(q))/dq: nine rows, columns w, x, y, z."""
    entries = homogeneous_entries(q)
    return tuple(tuple(sp.diff(entry, element) for element in q) for entry in entries)


def normalised_gradient(q: Row, matrix: Row, square: sp.Expr) -> Matrix:
    """d(entry of R(q/|q|))/dq by the quotient rule: (d entry - 2 R q) / |q|^2."""
    return tuple(
        tuple((slope - 2 * entry * element) / square for slope, element in zip(row, q, strict=True))
        for entry, row in zip(matrix, homogeneous_gradient(q), strict=True)
    )


def conjugate(q: Row) -> Row:
    """The inverse of a unit quaternion."""
    w, x, y, z = q
    return (w, -x, -y, -z)


def quaternion_product(a: Row, b: Row) -> Row:
    """Hamilton product; R(a b) = R(a) R(b)."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def exponential(graph: Graph, name: str, d: Row) -> Row:
    """Quaternion of the rotation vector d; series below 0.1 rad, closed form above.

    Both branches are finite everywhere: the closed form reads a safe angle, so that neither the
    value nor a derivative by another tool meets a division by zero.
    """
    (t,) = graph.define(f"{name}_angle_squared", [sp.Add(*(e * e for e in d))])
    small = sp.Lt(t, SERIES_LIMIT)
    (safe,) = graph.define(
        f"{name}_safe_squared", [sp.Piecewise((sp.Integer(1), small), (t, True))]
    )
    (a,) = graph.define(f"{name}_angle", [sp.sqrt(safe)])
    near = graph.define(
        f"{name}_near",
        [horner(_near(series.half_cosine), t), horner(_near(series.half_sinc), t)],
        suffixes=("cosine", "sinc"),
    )
    (half,) = graph.define(f"{name}_half", [a / 2])
    far = graph.define(f"{name}_far", [sp.cos(half), sp.sin(half) / a], suffixes=("cosine", "sinc"))
    w, s = graph.define(
        name,
        [sp.Piecewise((n, small), (f, True)) for n, f in zip(near, far, strict=True)],
        suffixes=("cosine", "sinc"),
    )
    return (w, *(s * e for e in d))


def logarithm(graph: Graph, name: str, q: Row) -> Row:
    """Rotation vector of a quaternion, of length below pi; q and -q give the same.

    The series serves where the vector part is small, atan2 elsewhere, half turns included.
    """
    q = graph.define(f"{name}_of", q, suffixes=("w", "x", "y", "z"))
    (sign,) = graph.define(
        f"{name}_sign", [sp.Piecewise((sp.Integer(-1), sp.Lt(q[0], 0)), (sp.Integer(1), True))]
    )
    (w,) = graph.define(f"{name}_w", [sign * q[0]])
    (t,) = graph.define(f"{name}_sine_squared", [sp.Add(*(e * e for e in q[1:]))])
    small = sp.Lt(t, SERIES_LIMIT)
    (safe,) = graph.define(
        f"{name}_safe_squared", [sp.Piecewise((sp.Integer(1), small), (t, True))]
    )
    (sine,) = graph.define(f"{name}_sine", [sp.sqrt(safe)])
    # Where the series is read w is near 1; asking w itself shows that nothing divides by zero.
    large = sp.Lt(sp.Rational(1, 2), w)
    (cosine,) = graph.define(f"{name}_cosine", [sp.Piecewise((w, large), (sp.Integer(1), True))])
    (u,) = graph.define(f"{name}_tangent_squared", [t / (cosine * cosine)])
    (inner,) = graph.define(f"{name}_series", [horner(_near(series.arctangent), u)])
    near = 2 * inner / cosine
    (far,) = graph.define(f"{name}_far", [2 * sp.atan2(sine, w) / sine])
    (scale,) = graph.define(f"{name}_scale", [sp.Piecewise((near, small), (far, True))])
    (scaled,) = graph.define(f"{name}_signed_scale", [sign * scale])
    return tuple(scaled * e for e in q[1:])


def right_jacobian(graph: Graph, name: str, theta: Row) -> Matrix:
    """Jr(theta) = I - c2 [theta]x + c3 [theta]x^2: Exp(theta + d) = Exp(theta) Exp(Jr d)."""
    x, y, z = theta
    (t,) = graph.define(f"{name}_squared", [x * x + y * y + z * z])
    bound = series.LARGEST_ANGLE**2
    c2, c3 = graph.define(
        name,
        [
            horner(series.coefficients(series.one_minus_cosine, bound), t),
            horner(series.coefficients(series.angle_minus_sine, bound), t),
        ],
        suffixes=("c2", "c3"),
    )
    flat = [
        1 - c3 * (y * y + z * z), c2 * z + c3 * x * y, -c2 * y + c3 * x * z,
        -c2 * z + c3 * x * y, 1 - c3 * (x * x + z * z), c2 * x + c3 * y * z,
        c2 * y + c3 * x * z, -c2 * x + c3 * y * z, 1 - c3 * (x * x + y * y),
    ]  # fmt: skip
    return rows_of(graph.define(name, flat, suffixes=NAMES), 3)


def wrap(angle: sp.Expr) -> sp.Expr:
    """The angle in (-pi, pi]; computed, it may be beyond either end by its rounding."""
    turn = sp.Float(6.283185307179586, 17)
    return angle + turn * sp.floor(sp.Rational(1, 2) - angle / turn)


def _near(term: series.Term) -> Sequence[Fraction]:
    return series.coefficients(term, float(SERIES_LIMIT) * 1.05)
