"""Vectors, quaternions and derivatives in multiple precision.

Rotations act by the quaternion sandwich product; a rotation matrix is formed only where one is
given. Derivatives are central differences taken at three times the working precision, which leaves
no visible error.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from mpmath import mp, mpf

Vector = list[mpf]
Matrix = list[Vector]
Quantities = Mapping[str, Mapping[str, Any]]
Options = Mapping[str, Any]
Outputs = dict[str, Vector]

AXES = {"x": 0, "y": 1, "z": 2}


def exact(number: Fraction | int) -> mpf:
    """Round a rational to the precision in force, which need not be that of import time."""
    fraction = Fraction(number)
    return mpf(fraction.numerator) / fraction.denominator


def add(*vectors: Sequence[mpf]) -> Vector:
    """Sum vectors."""
    return [mp.fsum(parts) for parts in zip(*vectors, strict=True)]


def scale(factor: mpf, vector: Sequence[mpf]) -> Vector:
    """Multiply a vector by a number."""
    return [factor * part for part in vector]


def subtract(left: Sequence[mpf], right: Sequence[mpf]) -> Vector:
    """Subtract ``right`` from ``left``."""
    return [a - b for a, b in zip(left, right, strict=True)]


def dot(left: Sequence[mpf], right: Sequence[mpf]) -> mpf:
    """Form the scalar product."""
    return mp.fdot(left, right)


def length(vector: Sequence[mpf]) -> mpf:
    """Give the Euclidean length."""
    return mp.sqrt(dot(vector, vector))


def cross(left: Sequence[mpf], right: Sequence[mpf]) -> Vector:
    """Form the vector product, as the vector part of a product of pure quaternions."""
    zero = mpf(0)
    return multiply([zero, *left], [zero, *right])[1:]


def multiply(p: Sequence[mpf], q: Sequence[mpf]) -> Vector:
    """Multiply two quaternions, scalar first, Hamilton (i j = k)."""
    (a, b, c, d), (w, x, y, z) = p, q
    return [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]


def conjugate(q: Sequence[mpf]) -> Vector:
    """Reverse the vector part of a quaternion."""
    return [q[0], -q[1], -q[2], -q[3]]


def exponential(rotation_vector: Sequence[mpf]) -> Vector:
    """Give the quaternion of a rotation vector by the power series of the exponential.

    The argument is halved until it is small and the result squared as often: no sine, no cosine, no
    special case at the zero rotation.
    """
    halvings = max(1, int(mp.ceil(mp.log(1 + length(rotation_vector), 2))) + 4)
    with mp.extradps(halvings + 5):
        small = [mpf(0), *scale(mpf(2) ** -halvings, rotation_vector)]
        term = total = [mpf(1), mpf(0), mpf(0), mpf(0)]
        order = 0
        while length(term) > mp.eps:
            order += 1
            term = scale(mpf(1) / order, multiply(term, small))
            total = add(total, term)
        # A quaternion holds half the angle: one of the halvings is never squared away.
        for _ in range(halvings - 1):
            total = multiply(total, total)
    return [+part for part in total]


def logarithm(q: Sequence[mpf]) -> Vector:
    """Give the rotation vector, of length at most pi, of a quaternion of any non-zero length."""
    w, *vector = q if q[0] >= 0 else scale(mpf(-1), q)
    sine = length(vector)
    if sine == 0:
        return [mpf(0)] * 3
    return scale(2 * mp.atan2(sine, w) / sine, vector)


def about(axis: str, angle: mpf) -> Vector:
    """Give the quaternion of the active rotation by ``angle`` about a coordinate axis."""
    vector = [mpf(0)] * 3
    vector[AXES[axis]] = mp.sin(angle / 2)
    return [mp.cos(angle / 2), *vector]


def sandwich(q: Sequence[mpf], vector: Sequence[mpf], form: str = "homogeneous") -> Vector:
    """Rotate a vector by a quaternion.

    The forms agree for unit quaternions and differ off the unit sphere, which matters for
    derivatives toward the four stored components and nowhere else.

    Args:
        q: Quaternion, scalar first.
        vector: Vector to rotate.
        form: ``homogeneous``: q v q*, which scales by abs(q)^2; ``unit``:
            v + 2 u x (w v + u x v), the matrix with its diagonal counted from one;
            ``normalised``: q v q^-1, free of the length.
    """
    if form == "unit":
        w, u = q[0], q[1:]
        return add(vector, scale(mpf(2), cross(u, add(scale(w, vector), cross(u, vector)))))
    turned = multiply(multiply(q, [mpf(0), *vector]), conjugate(q))[1:]
    if form == "homogeneous":
        return turned
    if form == "normalised":
        return scale(1 / dot(q, q), turned)
    raise ValueError(f"unknown quaternion form {form!r}")


def far_end(rotation: Mapping[str, Any], near: str | None) -> str:
    """Name the frame at the other end of a rotation; with no frame given, the one it maps to."""
    source, target = rotation["maps"]
    if near in (source, None):
        return str(target)
    if near == target:
        return str(source)
    raise ValueError(f"a rotation between {source!r} and {target!r} does not touch frame {near!r}")


def turn(
    rotation: Mapping[str, Any], vector: Sequence[mpf], near: str | None, form: str = "homogeneous"
) -> Vector:
    """Resolve a vector given in frame ``near`` in the frame at the other end of a rotation.

    The direction follows from the frames: the same quantity serves both ways.
    """
    forward = far_end(rotation, near) == rotation["maps"][1]
    if "matrix" in rotation:
        rows = [rotation["matrix"][3 * i : 3 * i + 3] for i in range(3)]
        return apply(rows if forward else transpose(rows), vector)
    q = about(rotation["axis"], rotation["angle"]) if "angle" in rotation else rotation["wxyz"]
    return sandwich(q if forward else conjugate(q), vector, form)


def apply(matrix: Sequence[Sequence[mpf]], vector: Sequence[mpf]) -> Vector:
    """Multiply a matrix, given by rows, with a vector."""
    return [dot(row, vector) for row in matrix]


def transpose(matrix: Sequence[Sequence[mpf]]) -> Matrix:
    """Exchange rows and columns."""
    return [list(column) for column in zip(*matrix, strict=True)]


def images(linear: Callable[[Vector], Vector], size: int = 3) -> Matrix:
    """Give the rows of the matrix of a linear map, from the images of the unit vectors."""
    units = [[mpf(int(i == j)) for i in range(size)] for j in range(size)]
    return transpose([linear(unit) for unit in units])


def propagate(matrix: Matrix, covariance: Sequence[mpf]) -> Vector:
    """Carry a row-major covariance through a linear map.

    Both indices are mapped, one after the other.
    """
    size = len(matrix[0])
    rows = [list(covariance[size * i : size * i + size]) for i in range(size)]
    half = transpose([apply(matrix, column) for column in transpose(rows)])
    return [entry for row in half for entry in apply(matrix, row)]


def derivative(function: Callable[[Vector], Vector], point: Sequence[mpf]) -> Matrix:
    """Differentiate a vector function at a point; rows are outputs.

    With D digits of working precision the step is 10^-D of the size of the argument and the
    arithmetic carries 3 D digits: truncation and cancellation both stay near 2 D digits.
    """
    digits = mp.dps
    columns = []
    with mp.workdps(3 * digits + 10):
        for index, centre in enumerate(point):
            step = max(abs(centre), mpf(1)) * mpf(10) ** -digits
            ends = []
            for sign in (1, -1):
                moved = list(point)
                moved[index] = centre + sign * step
                ends.append(function(moved))
            columns.append(scale(1 / (2 * step), subtract(*ends)))
    return [[+entry for entry in row] for row in transpose(columns)]
