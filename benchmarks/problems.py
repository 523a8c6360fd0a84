"""The models every contestant evaluates, written once over any algebra.

A problem takes one flat record of inputs and gives its values followed by the structural
non-zeros of its Jacobian toward the error state, row by row. The equation is written with plain
arithmetic, so that CasADi, SymPy and SymForce symbols and 50-digit numbers all pass through it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

SPECS = Path(__file__).parent / "specs"

Vector = list[Any]
Given = Mapping[str, Vector]


@dataclass(frozen=True)
class Functions:
    """The elementary functions of an algebra."""

    sqrt: Callable[[Any], Any]
    sin: Callable[[Any], Any]
    cos: Callable[[Any], Any]


@dataclass(frozen=True)
class Problem:
    """One model in tangent form.

    Attributes:
        name: as reported.
        package: the specification it comes from, and its package.
        state: blocks in order: name and size of the storage; ``q`` is a quaternion w, x, y, z.
        inputs: the arguments after the state: name and size (per item where in ``per_item``).
        equation: value from the inputs.
        nonzeros: columns of the structural non-zeros of one row, or of every row.
        items: satellites, or 0 where the function is not mapped over any.
        per_item: inputs that have one row per item.
    """

    name: str
    package: str
    state: tuple[tuple[str, int], ...]
    inputs: tuple[tuple[str, int], ...]
    equation: Callable[[Given, Functions], Vector]
    nonzeros: tuple[tuple[int, ...], ...]
    items: int = 0
    per_item: tuple[str, ...] = ()

    @property
    def spec(self) -> Path:
        """Its specification."""
        return SPECS / f"{self.package}.toml"

    @property
    def sizes(self) -> dict[str, int]:
        """Elements of every part of the flat input record, in order."""
        counted = {name: size * self._count(name) for name, size in self.inputs}
        return {**dict(self.state), **counted}

    @property
    def offsets(self) -> dict[str, int]:
        """Where every part of the flat input record starts; ``x`` is the state."""
        found, at = {"x": 0}, 0
        for name, size in self.sizes.items():
            found[name] = at
            at += size
        return found

    @property
    def record(self) -> int:
        """Length of the flat input record."""
        return sum(self.sizes.values())

    @property
    def rows(self) -> int:
        """Elements of the value."""
        return self.items or len(self.nonzeros)

    @property
    def columns(self) -> int:
        """Elements of the error state."""
        return sum(3 if name == "q" else size for name, size in self.state)

    @property
    def pattern(self) -> list[tuple[int, int]]:
        """Row and column of every structural non-zero, by row."""
        return [
            (row, column)
            for row in range(self.rows)
            for column in self.nonzeros[row if len(self.nonzeros) > 1 else 0]
        ]

    def split(self, record: Sequence[Any]) -> dict[str, Vector]:
        """The parts of a flat record by name."""
        return {
            name: list(record[self.offsets[name] : self.offsets[name] + size])
            for name, size in self.sizes.items()
        }

    def moved(self, given: Given, error: Sequence[Any]) -> dict[str, Vector]:
        """The inputs with the state moved by a first-order error; the quaternion turns right."""
        moved, at = dict(given), 0
        for name, size in self.state:
            if name == "q":
                moved[name] = turned(given[name], error[at : at + 3])
                at += 3
            else:
                moved[name] = [a + d for a, d in zip(given[name], error[at:], strict=False)]
                at += size
        return moved

    def _count(self, name: str) -> int:
        return self.items if name in self.per_item else 1


def turned(q: Vector, d: Sequence[Any]) -> Vector:
    """The product q [1, d / 2]: a right rotation by a small vector."""
    w, x, y, z = q
    a, b, c = (e / 2 for e in d)
    return [
        w - x * a - y * b - z * c,
        x + w * a + y * c - z * b,
        y + w * b + z * a - x * c,
        z + w * c + x * b - y * a,
    ]


def matrix(q: Vector) -> list[Vector]:
    """Rotation matrix of a Hamilton quaternion w, x, y, z."""
    w, x, y, z = q
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def times(m: list[Vector], v: Sequence[Any]) -> Vector:
    """Matrix times vector."""
    return [sum((a * b for a, b in zip(row[1:], v[1:], strict=True)), row[0] * v[0]) for row in m]


def cross(a: Sequence[Any], b: Sequence[Any]) -> Vector:
    """Cross product."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(*vectors: Sequence[Any]) -> Vector:
    """Sum of vectors."""
    first, *rest = vectors
    result = list(first)
    for vector in rest:
        result = [a + b for a, b in zip(result, vector, strict=True)]
    return result


def scaled(factor: Any, vector: Sequence[Any]) -> Vector:
    """Number times vector."""
    return [factor * a for a in vector]


def position(given: Given, _functions: Functions) -> Vector:
    """Position of the antenna, p + R l."""
    return plus(given["p"], times(matrix(given["q"]), given["l"]))


def calibrated_position(given: Given, functions: Functions) -> Vector:
    """Position in the calibrated frame, pL + Rz(psi) (p + R l)."""
    s, c = functions.sin(given["psi"][0]), functions.cos(given["psi"][0])
    x, y, z = position(given, functions)
    return plus(given["pL"], [c * x - s * y, s * x + c * y, z])


def ranges(given: Given, functions: Functions) -> Vector:
    """|p + C R l - s| + b for every satellite."""
    c = given["C"]
    arm = times([c[0:3], c[3:6], c[6:9]], times(matrix(given["q"]), given["l"]))
    antenna = plus(given["p"], arm)
    found = []
    for i in range(len(given["s"]) // 3):
        x, y, z = (a - s for a, s in zip(antenna, given["s"][3 * i : 3 * i + 3], strict=True))
        found.append(functions.sqrt(x * x + y * y + z * z) + given["b"][0])
    return found


SCULLING = {1: (), 4: (54, 92, 214)}
"""The classical table for sustained sculling, over 105."""


def specific_force(given: Given, _functions: Functions) -> Vector:
    """R (v + a x v / 2 + sculling) / dt from bias-corrected increments."""
    samples = len(given["delta_theta"]) // 3
    dt = given["dt"][0]
    part = dt / samples
    theta = corrected(given["delta_theta"], given["bg"], part)
    velocity = corrected(given["delta_velocity"], given["ba"], part)
    a, v = plus(*theta), plus(*velocity)
    u = plus(v, [c / 2 for c in cross(a, v)])
    weights = [w / 105 for w in SCULLING[samples]]
    if weights:
        pairs = zip(weights, theta, velocity, strict=False)
        weighted = [(scaled(w, t), scaled(w, f)) for w, t, f in pairs]
        turned_sum = plus(*(t for t, _ in weighted))
        moved_sum = plus(*(f for _, f in weighted))
        u = plus(u, cross(turned_sum, velocity[-1]), cross(moved_sum, theta[-1]))
    return [c / dt for c in times(matrix(given["q"]), u)]


def corrected(increments: Vector, bias: Vector, part: Any) -> list[Vector]:
    """The increments of each sub-sample less the bias."""
    rows = [increments[i : i + 3] for i in range(0, len(increments), 3)]
    return [[a - b * part for a, b in zip(row, bias, strict=True)] for row in rows]


def _inertial(samples: int) -> Problem:
    return Problem(
        f"imu{samples}", f"imu{samples}", (("q", 4), ("bg", 3), ("ba", 3)),
        (("delta_theta", 3 * samples), ("delta_velocity", 3 * samples), ("dt", 1)),
        specific_force, (tuple(range(9)),) * 3,
    )  # fmt: skip


def _ranges(items: int) -> Problem:
    return Problem(
        f"pr{items}", "pr", (("p", 3), ("q", 4), ("b", 1)), (("l", 3), ("C", 9), ("s", 3)),
        ranges, (tuple(range(7)),), items, ("s",),
    )  # fmt: skip


PROBLEMS: tuple[Problem, ...] = (
    Problem(
        "gps", "gps", (("p", 3), ("q", 4)), (("l", 3),),
        position, tuple((row, 3, 4, 5) for row in range(3)),
    ),
    Problem(
        "ekfcal", "ekfcal", (("p", 3), ("q", 4), ("l", 3), ("pL", 3), ("psi", 1)), (),
        calibrated_position,
        (
            (0, 1, 3, 4, 5, 6, 7, 8, 9, 12),
            (0, 1, 3, 4, 5, 6, 7, 8, 10, 12),
            (2, 3, 4, 5, 6, 7, 8, 11),
        ),
    ),
    _ranges(8),
    _ranges(32),
    _inertial(1),
    _inertial(4),
    Problem(
        "filter", "filter",
        (("p", 3), ("v", 3), ("q", 4), ("ba", 3), ("bg", 3), ("b", 1), ("drift", 1), ("rest", 83)),
        (("l", 3), ("C", 9), ("s", 3)), ranges, ((0, 1, 2, 6, 7, 8, 15),), 32, ("s",),
    ),
)  # fmt: skip
"""The six models of the comparison, and one of filter size: a state of 100, 32 satellites."""
