"""The C of a function as IEEE 754 arithmetic: the bits that a conforming target must give.

``walk`` goes through the operations in the order of the C; here each is one correctly rounded
operation of the function's type. Where a function uses nothing but arithmetic and square roots,
any target that neither contracts nor widens gives exactly these bits. Functions of the C library
are rounded correctly, which libraries approach to a unit in the last place.

Everything is evaluated for many rows of inputs at once: one row per call, or per item of a call.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav import ir
from symnav.emit.c import literals
from symnav.export.arithmetic import rounded, sinusoids, walk

Real = NDArray[Any]
Condition = NDArray[np.bool_]
Rows = Mapping[str, NDArray[Any]]
Operation = ir.Operation

_ARITHMETIC: Mapping[Operation, Callable[..., Any]] = {
    Operation.ADD: np.add,
    Operation.SUB: np.subtract,
    Operation.MUL: np.multiply,
    Operation.DIV: np.divide,
    Operation.NEG: np.negative,
    Operation.SQRT: np.sqrt,
    Operation.ABS: np.abs,
    Operation.FLOOR: np.floor,
    Operation.LT: np.less,
    Operation.LE: np.less_equal,
    Operation.EQ: np.equal,
    Operation.NE: np.not_equal,
    Operation.AND: np.logical_and,
    Operation.OR: np.logical_or,
    Operation.NOT: np.logical_not,
    Operation.SELECT: np.where,
    # As the helpers of the check file: the second operand where a comparison with NaN fails.
    Operation.MIN: lambda a, b: np.where(a < b, a, b),
    Operation.MAX: lambda a, b: np.where(a > b, a, b),
    Operation.OWN_SIN: sinusoids.sine,
    Operation.OWN_COS: sinusoids.cosine,
}


def kind_of(scalar: ir.Scalar) -> Any:
    """The NumPy type of a scalar."""
    return np.dtype(np.float64 if scalar is ir.Scalar.DOUBLE else np.float32)


def constant(value: float, scalar: ir.Scalar) -> float:
    """What the C literal of a number is worth."""
    return float(literals.literal(value, scalar).removesuffix("F"))


def bounds(lower: float, upper: float, scalar: ir.Scalar) -> tuple[Real, Real]:
    """The range of a guard as the C writes it: in the type, rounded inwards."""
    low, high = literals.bounds(lower, upper, scalar)
    kind = kind_of(scalar)
    return kind.type(low.removesuffix("F")), kind.type(high.removesuffix("F"))


def declared(lower: float, upper: float, scalar: ir.Scalar) -> tuple[Real, Real]:
    """The range of an input as the C writes it: the numbers of the type nearest to its ends."""
    kind = kind_of(scalar)
    low, high = literals.declared_ends(lower, upper, scalar)
    return kind.type(low), kind.type(high)


@dataclass
class Ieee:
    """One type's arithmetic, and the guards that failed in it.

    Attributes:
        scalar: the type.
        guarded: False where the C leaves the guards of temporaries out.
        status: of every row so far: that of the first guard that failed.
    """

    scalar: ir.Scalar
    guarded: bool
    status: NDArray[np.int64]
    kind: Any = field(init=False)

    def __post_init__(self) -> None:
        self.kind = kind_of(self.scalar)

    def number(self, value: float) -> Real:
        """A literal in the type."""
        return np.asarray(constant(value, self.scalar), dtype=self.kind)

    def apply(self, operation: Operation, operands: Sequence[Real]) -> Real:
        """One operation, rounded once."""
        if operation in rounded.LIBRARY:
            return rounded.library(operation, list(operands))
        with np.errstate(all="ignore"):
            return np.asarray(_ARITHMETIC[operation](*operands))

    def check(self, step: ir.Check, value: Real) -> Real:
        """Select and flag."""
        if not self.guarded:
            return value
        low, high = bounds(step.lower, step.upper, self.scalar)
        passed = (value >= low) & (value <= high)
        self.flag(~passed, step.status)
        return np.where(passed, value, self.number(step.substitute))

    def flag(self, failed: Condition, status: ir.Status) -> None:
        """Note a failure where nothing failed before."""
        self.status = np.where((self.status == 0) & failed, int(status), self.status)


@dataclass(frozen=True)
class Outcome:
    """What a function does with rows of inputs.

    Attributes:
        status: (rows,) of what all items share; of the call where the function is not mapped.
        item: (rows,) of the item; zero where the function is not mapped.
        outputs: structural non-zeros by output name: (rows, count). Of a row that failed they are
            what the kernel computed with its substitutes, and are never stored.
        values: of every step, by its target.
        copies: of the inputs, as the kernel reads them.
    """

    status: NDArray[np.int64]
    item: NDArray[np.int64]
    outputs: Mapping[str, Real]
    values: Mapping[str, Real]
    copies: Rows

    @property
    def ok(self) -> Condition:
        """Rows that are stored."""
        passed: Condition = (self.status == 0) & (self.item == 0)
        return passed


def evaluate(function: ir.Function, scalar: ir.Scalar, rows: Rows) -> Outcome:
    """Run a function on rows of inputs.

    Args:
        function: as it was emitted.
        scalar: its type.
        rows: (rows, size) by argument, reals in the type; shared inputs repeated for every item.
    """
    count = len(next(iter(rows.values())))
    loading, loading_item = _blank(function, scalar, count), _blank(function, scalar, count)
    copies: dict[str, NDArray[Any]] = {}
    for argument in function.arguments:
        arithmetic = loading_item if argument.item else loading
        copies[argument.name] = _load(function, argument, rows[argument.name], arithmetic)
    # Norms are judged after all ranges of a call.
    for argument in function.arguments:
        arithmetic = loading_item if argument.item else loading
        _check_norms(function, argument, copies[argument.name], arithmetic)
    loads = loader(function, copies, kind_of(scalar))
    values = walk.run(function.shared, loads, {}, loading)
    values = walk.run(function.item, loads, values, loading_item)
    outputs = {
        output.name: _nonzeros(output, loads, values, loading, count) for output in function.outputs
    }
    return Outcome(loading.status, loading_item.status, outputs, values, copies)


def loader(function: ir.Function, copies: Rows, kind: Any) -> walk.Loads[Real]:
    """Elements of the copied inputs, integers converted as the C does."""
    integers = {argument.name for argument in function.arguments if argument.integer}

    def load(element: ir.Load) -> Real:
        column = chosen(copies[element.argument], element.index, copies)
        return column.astype(kind) if element.argument in integers else column

    return load


def chosen(array: NDArray[Any], index: int | ir.Offset, copies: Rows) -> NDArray[Any]:
    """A column of an argument, or of every row the one its slot says."""
    if isinstance(index, int):
        return array[:, index]
    places = positions(index, copies)
    return array[np.arange(len(array)), places]


def positions(index: int | ir.Offset, copies: Rows) -> NDArray[np.int64]:
    """An index of every row, slots resolved."""
    count = len(next(iter(copies.values())))
    if isinstance(index, int):
        return np.full(count, index, dtype=np.int64)
    assert isinstance(index.slot.index, int)
    slot = copies[index.slot.argument][:, index.slot.index]
    return index.base + slot.astype(np.int64)


def _blank(function: ir.Function, scalar: ir.Scalar, count: int) -> Ieee:
    return Ieee(scalar, function.checks_domain, np.zeros(count, dtype=np.int64))


def _load(
    function: ir.Function, argument: ir.Argument, given: NDArray[Any], arithmetic: Ieee
) -> NDArray[Any]:
    """The copy of an argument: a stand-in and a flag for what is outside its range."""
    copy = np.array(given)
    for domain in read_domains(argument):
        for place in range(domain.size):
            index = domain.start + place
            lower, upper = domain.lower[place], domain.upper[place]
            low: Any
            high: Any
            if argument.integer:
                low, high = (int(text) for text in literals.integer_bounds(lower, upper))
                stand_in: Any = low
            elif function.checks_inputs:
                low, high = declared(lower, upper, arithmetic.scalar)
                stand_in = arithmetic.kind.type(0.0) if low == -high else low
            else:
                continue
            inside = (given[:, index] >= low) & (given[:, index] <= high)
            copy[:, index] = np.where(inside, given[:, index], stand_in)
            arithmetic.flag(~inside, ir.Status.RANGE)
    return copy


def read_domains(argument: ir.Argument) -> Iterable[ir.Domain]:
    """Runs of elements that a function reads."""
    return (domain for domain in argument.domains if domain.kind is not ir.Kind.UNREAD)


def _check_norms(
    function: ir.Function, argument: ir.Argument, copy: NDArray[Any], arithmetic: Ieee
) -> None:
    if not function.checks_inputs:
        return
    for domain in read_domains(argument):
        elements = [copy[:, domain.start + place] for place in range(domain.size)]
        tolerance = arithmetic.number(domain.tolerance)
        if domain.kind is ir.Kind.QUATERNION:
            arithmetic.flag(~is_unit(elements, tolerance), ir.Status.QNORM)
        elif domain.kind is ir.Kind.MATRIX:
            arithmetic.flag(~is_rotation(elements, tolerance), ir.Status.QNORM)


def is_unit(q: list[Real], tolerance: Real) -> Condition:
    """Whether quaternions are of unit norm within a tolerance, in the order of the C."""
    one = tolerance.dtype.type(1.0)
    excess = (((q[0] * q[0] + q[1] * q[1]) + q[2] * q[2]) + q[3] * q[3]) - one
    passed: Condition = np.abs(excess) <= tolerance
    return passed


def is_rotation(m: list[Real], tolerance: Real) -> Condition:
    """Whether matrices are rotations: two orthonormal columns, their cross product the third."""
    one = tolerance.dtype.type(1.0)
    first, second, third = m[0::3], m[1::3], m[2::3]

    def dot(a: list[Real], b: list[Real]) -> Real:
        return np.asarray((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2])

    errors = [dot(first, first) - one, dot(second, second) - one, dot(first, second)]
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        errors.append((first[i] * second[j] - first[j] * second[i]) - third[k])
    passed: Condition = np.all([np.abs(error) <= tolerance for error in errors], axis=0)
    return passed


def _nonzeros(
    output: ir.Output,
    loads: walk.Loads[Real],
    values: Mapping[str, Real],
    arithmetic: Ieee,
    count: int,
) -> Real:
    columns = [walk.evaluate(entry.value, loads, values, arithmetic) for entry in output.entries]
    found = np.empty((count, len(columns)), dtype=arithmetic.kind)
    for k, column in enumerate(columns):
        found[:, k] = column
    return found
