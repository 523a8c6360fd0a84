"""The intermediate representation: plain frozen records that every later stage reads.

Both routes (CasADi to C, SymPy to NumPy) lower a derivation into these records, and everything
after that (passes, emission, build, documentation) reads nothing else. The records hold no
behaviour beyond names for what they say, and no text of any target language.

A function is evaluated in two bodies. ``shared`` runs once per call; ``item`` runs once per
satellite (or whatever the items are) and may refer to targets of ``shared``. A function that is
not mapped over items has an empty ``item`` body and ``maximum = None``.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum, StrEnum


class Status(IntEnum):
    """What a generated function returns; the values are part of the C interface."""

    OK = 0
    NULL = 1
    RANGE = 2
    DOMAIN = 3
    QNORM = 4
    COUNT = 5
    INDEX = 6
    PARTIAL = 7


class Operation(StrEnum):
    """Arithmetic the representation knows.

    ``OWN_SIN`` and ``OWN_COS`` are sine and cosine of an angle that is known to lie within
    ``trigonometry.LIMIT``: emitted code evaluates them itself instead of calling a library.

    Comparisons stand only inside the first operand of a ``SELECT`` or inside ``AND``, ``OR`` and
    ``NOT``; they are never stored in a local.
    """

    ADD = "add"
    SUB = "sub"
    MUL = "mul"
    DIV = "div"
    NEG = "neg"
    SQRT = "sqrt"
    SIN = "sin"
    COS = "cos"
    OWN_SIN = "own_sin"
    OWN_COS = "own_cos"
    TAN = "tan"
    ASIN = "asin"
    ACOS = "acos"
    ATAN = "atan"
    ATAN2 = "atan2"
    EXP = "exp"
    LOG = "log"
    ABS = "abs"
    FLOOR = "floor"
    MIN = "min"
    MAX = "max"
    SELECT = "select"
    LT = "lt"
    LE = "le"
    EQ = "eq"
    NE = "ne"
    AND = "and"
    OR = "or"
    NOT = "not"


CONDITIONS = frozenset(
    {
        Operation.LT,
        Operation.LE,
        Operation.EQ,
        Operation.NE,
        Operation.AND,
        Operation.OR,
        Operation.NOT,
    }
)


@dataclass(frozen=True, slots=True)
class Number:
    """A literal."""

    value: float


@dataclass(frozen=True, slots=True)
class Ref:
    """The value of an earlier statement or check, by its target's name."""

    name: str


@dataclass(frozen=True, slots=True)
class Load:
    """Element ``index`` of an argument; of the current item where the argument is per item.

    The index is an ``Offset`` where a run-time slot chooses the element of the state.
    """

    argument: str
    index: int | Offset


@dataclass(frozen=True, slots=True)
class Call:
    """An operation on operands, in mathematical order: ``SUB(a, b)`` is a - b."""

    operation: Operation
    operands: tuple[Expression, ...]


Expression = Number | Ref | Load | Call


@dataclass(frozen=True, slots=True)
class Statement:
    """``target = value``; every target is assigned once."""

    target: str
    value: Expression
    comment: str = ""


@dataclass(frozen=True, slots=True)
class Check:
    """A guard on a temporary: ``target = value`` inside the bounds, else ``substitute``.

    A failed check raises ``status`` (for the item, inside an item body). What follows reads the
    target, so that a square root or a division never sees a bad operand.
    """

    target: str
    value: Expression
    lower: float
    upper: float
    substitute: float
    status: Status
    comment: str


Step = Statement | Check


class Kind(StrEnum):
    """What the elements of an argument mean to the guards."""

    REAL = "real"
    QUATERNION = "quaternion"
    MATRIX = "matrix"
    INTEGER = "integer"
    UNREAD = "unread"


@dataclass(frozen=True, slots=True)
class Domain:
    """A run of elements of one argument that share a meaning and a check.

    Attributes:
        name: the state block or the input.
        start: first element.
        size: number of elements.
        kind: REAL (range check), QUATERNION (4, unit norm), MATRIX (9, row-major, a rotation)
            INTEGER (range check; passed to C as ``int32_t``), or UNREAD: the function reads no
            element of it, so a bad value there is none of its business.
        lower: one bound per element.
        upper: one bound per element.
        tolerance: on the squared norm, or on each product of columns; only QUATERNION, MATRIX.
        unit: SI symbol, ``"1"`` when dimensionless.
        frame: frame the elements are resolved in, or a map such as ``"b -> n"``, or empty.
        labels: one label per element, such as ``("x", "y", "z")``.
        description: one sentence for documentation.
    """

    name: str
    start: int
    size: int
    kind: Kind
    lower: tuple[float, ...]
    upper: tuple[float, ...]
    tolerance: float
    unit: str
    frame: str
    labels: tuple[str, ...]
    description: str


@dataclass(frozen=True, slots=True)
class Argument:
    """An input of a generated function.

    Attributes:
        name: identifier in C and Python; the state is always ``x``.
        size: elements per item (or in all, where not per item).
        item: True when there is one row of ``size`` elements for each item.
        integer: True when the elements are ``int32_t``.
        domains: consecutive, covering ``size``; the state has one per block.
    """

    name: str
    size: int
    item: bool
    integer: bool
    domains: tuple[Domain, ...]


@dataclass(frozen=True, slots=True)
class Entry:
    """One structural non-zero of an output: its indices (per item) and its value.

    An index is an integer, or ``Offset`` where it depends on a run-time slot.
    """

    index: tuple[int | Offset, ...]
    value: Expression


@dataclass(frozen=True, slots=True)
class Offset:
    """``base`` plus the integer element ``slot`` of the current item."""

    base: int
    slot: Load


@dataclass(frozen=True, slots=True)
class Section:
    """A named run of rows or columns of an output, for labels, documentation and proof sheets."""

    name: str
    start: int
    size: int
    unit: str
    labels: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Rounding:
    """What rounding can do to one entry of an output, over the declared ranges of the inputs.

    Attributes:
        bound: on |computed - exact|.
        smooth: the same without those inputs where rounding decides a comparison or a floor the
            other way; equal to ``bound`` where nothing is decided.
        largest: bound on |computed|.
    """

    bound: float
    smooth: float
    largest: float


@dataclass(frozen=True, slots=True)
class Output:
    """A result of a generated function.

    Attributes:
        name: ``value``, ``jacobian``, ``jacobian_<input>``, ``residual`` ...
        shape: per item; ``()`` for a scalar per item, ``(3,)``, ``(3, N)``; an item axis of
            length n comes in front where the function is mapped and ``item`` is True.
        item: True when there is one block of ``shape`` per item.
        entries: structural non-zeros in row-major order; every element not named is zero.
        rows: sections along the first axis of ``shape`` (one section of size 1 for a scalar).
        columns: sections along the second axis (of a scalar's Jacobian row: along its only axis).
        unit: SI symbol of the value; empty for a Jacobian (its sections hold the units).
        frame: as for ``Domain``.
        description: one sentence.
        rounding: of every entry; empty where it was not asked for.
    """

    name: str
    shape: tuple[int, ...]
    item: bool
    entries: tuple[Entry, ...]
    rows: tuple[Section, ...]
    columns: tuple[Section, ...]
    unit: str
    frame: str
    description: str
    rounding: tuple[Rounding, ...] = ()


class Role(StrEnum):
    """What a function is for."""

    MEASUREMENT = "measurement"
    CORRECTION = "correction"
    RETRACT = "retract"
    LOCAL = "local"


class Guards(StrEnum):
    """Where the checks of a function stand; the names are those of the specification.

    Attributes:
        STATUS: every call checks its inputs and the intermediate values that can be singular.
        OUTER: a function of its own checks the inputs, for the caller to call where data enter;
            a call checks the intermediate values.
        ASSUME: nothing is checked but what keeps a call inside its arrays.
    """

    STATUS = "status"
    OUTER = "outer"
    ASSUME = "assume"


class Items(StrEnum):
    """What a mapped function does with an item that fails its checks."""

    SKIP = "skip"
    REJECT = "reject"


@dataclass(frozen=True, slots=True)
class Function:
    """One generated function.

    Attributes:
        name: identifier without the package prefix.
        role: what it is for.
        title: one line, such as ``Position of a GNSS antenna``.
        equation: the equation in plain text, one or more lines.
        source: where the equation comes from.
        conventions: one sentence each, in the order they are to be read.
        arguments: the state first, then inputs.
        shared: steps evaluated once per call.
        item: steps evaluated once per item.
        outputs: ``value`` first, then Jacobians.
        maximum: most items in one call, or None when not mapped.
        items: what a failed item does; only meaningful when mapped.
        guards: where its checks stand.
        column_major: True when dense Jacobians are stored by column.
        single_difference: True when the differenced form is wanted as well.
    """

    name: str
    role: Role
    title: str
    equation: str
    source: str
    conventions: tuple[str, ...]
    arguments: tuple[Argument, ...]
    shared: tuple[Step, ...]
    item: tuple[Step, ...]
    outputs: tuple[Output, ...]
    maximum: int | None
    items: Items
    guards: Guards
    column_major: bool
    single_difference: bool

    @property
    def checks_inputs(self) -> bool:
        """True when every call looks at what it is given."""
        return self.guards is Guards.STATUS

    @property
    def checks_domain(self) -> bool:
        """True when a call refuses singular intermediate values."""
        return self.guards is not Guards.ASSUME

    @property
    def checks_at_border(self) -> bool:
        """True when a function of its own looks at the inputs."""
        return self.guards is Guards.OUTER


@dataclass(frozen=True, slots=True)
class StateBlock:
    """Where a block stands in the state vector and in its error vector."""

    name: str
    kind: str
    storage: Domain
    error_start: int
    error_size: int
    error_unit: str
    error_frame: str
    error_labels: tuple[str, ...]
    convention: str
    initial: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class State:
    """The layout: storage and error vectors, and the digest that identifies both."""

    blocks: tuple[StateBlock, ...]
    size: int
    error_size: int
    digest: str


class Scalar(StrEnum):
    """Floating-point type of the emitted C."""

    DOUBLE = "double"
    FLOAT = "float"


@dataclass(frozen=True, slots=True)
class Module:
    """Everything one generated package holds, for one scalar type.

    Attributes:
        name: leads every symbol.
        scalar: floating-point type of the C.
        state: the layout.
        functions: ``retract`` and ``local`` first, then in the order of the spec.
        digest: of the specification.
        generator: what made it.
        batches: False to leave out the entry points for many epochs.
    """

    name: str
    scalar: Scalar
    state: State
    functions: tuple[Function, ...]
    digest: str
    generator: str
    batches: bool = True
