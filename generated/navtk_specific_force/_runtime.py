"""What every generated package shares: descriptions, argument checks, results and errors.

Nothing here depends on the model; ``_interface.py`` holds the descriptions of this package's
functions, and each back end (``numpy.py``, ``native.py``, ``casadi.py``) evaluates them.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum, IntEnum
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

Array = Any
"""An array of the caller's library; of NumPy unless the ``numpy`` back end is given another."""


class Status(IntEnum):
    """What a function reports; the values are those of the C interface."""

    OK = 0
    NULL = 1
    RANGE = 2
    DOMAIN = 3
    QNORM = 4
    COUNT = 5
    INDEX = 6
    PARTIAL = 7


class GuardError(ValueError):
    """Raised by a call for one epoch whose guard failed; outputs are left untouched.

    Attributes:
        status: why.
        argument: name of the argument that failed, or empty.
        index: element of that argument.
        value: what was given there.
        bounds: the declared range of that element.
    """

    def __init__(
        self,
        status: Status,
        message: str,
        argument: str = "",
        index: tuple[int, ...] = (),
        value: float = math.nan,
        bounds: tuple[float, float] = (-math.inf, math.inf),
    ) -> None:
        super().__init__(message)
        self.status = status
        self.argument = argument
        self.index = index
        self.value = value
        self.bounds = bounds

    def __reduce__(self) -> tuple[Any, ...]:
        message, where = str(self), (self.argument, self.index, self.value, self.bounds)
        return type(self), (self.status, message, *where)


class Kind(Enum):
    """What the elements of a domain mean to the guards."""

    REAL = "real"
    QUATERNION = "quaternion"
    MATRIX = "matrix"
    INTEGER = "integer"
    UNREAD = "unread"


@dataclass(frozen=True)
class Domain:
    """A run of elements of an argument that share a meaning and a guard."""

    name: str
    start: int
    size: int
    kind: Kind
    lower: tuple[float, ...]
    upper: tuple[float, ...]
    unit: str
    frame: str
    labels: tuple[str, ...]
    tolerance: float = 0.0


@dataclass(frozen=True)
class Argument:
    """An input: ``size`` elements, for each item when ``item``; no last axis when ``scalar``."""

    name: str
    size: int
    domains: tuple[Domain, ...]
    item: bool = False
    integer: bool = False
    scalar: bool = False

    @cached_property
    def shape(self) -> tuple[str, ...]:
        """The trailing axes, as text."""
        return (*(("n",) if self.item else ()), *(() if self.scalar else (str(self.size),)))

    @cached_property
    def rank(self) -> int:
        """How many trailing axes belong to one epoch."""
        return self.item + (not self.scalar)


@dataclass(frozen=True)
class Slot:
    """The place of a non-zero that depends on a run-time index.

    It stands at ``base + stride * index`` of the flattened output, where ``index`` is element
    ``element`` of argument ``argument`` (None where it is scalar), from ``lower`` to ``upper``.
    """

    base: int
    stride: int
    argument: str
    element: int | None
    lower: int
    upper: int


@dataclass(frozen=True, eq=False)
class Output:
    """A result: shape of one item (or of one epoch) and places of its structural non-zeros.

    A place is a position in the flattened output, or a ``Slot``.
    """

    name: str
    shape: tuple[int, ...]
    places: tuple[int | Slot, ...]
    item: bool = False

    @cached_property
    def jacobian(self) -> bool:
        """True for a Jacobian."""
        return self.name.startswith("jacobian")

    @cached_property
    def size(self) -> int:
        """Elements in all."""
        return math.prod(self.shape)


@dataclass(frozen=True)
class Condition:
    """A guard on an intermediate value; what it means is all that is known outside the kernel."""

    status: Status
    lower: float
    upper: float
    meaning: str


@dataclass(frozen=True)
class Signature:
    """A function as its callers see it."""

    name: str
    documentation: str
    result: type[tuple[Any, ...]]
    arguments: tuple[Argument, ...]
    outputs: tuple[Output, ...]
    conditions: tuple[Condition, ...] = ()
    maximum: int | None = None
    reject: bool = False
    guarded: bool = True
    column_major: bool = False
    single_difference: bool = False
    lanes: int = 0

    @cached_property
    def mapped(self) -> bool:
        """True when the function is evaluated for each of n items."""
        return self.maximum is not None

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the arguments."""
        return tuple(argument.name for argument in self.arguments)

    @cached_property
    def values(self) -> tuple[Output, ...]:
        """Outputs that are not Jacobians."""
        return tuple(output for output in self.outputs if not output.jacobian)

    @cached_property
    def jacobians(self) -> tuple[Output, ...]:
        """Jacobians."""
        return tuple(output for output in self.outputs if output.jacobian)


class Part(Enum):
    """Which outputs a call asks for."""

    ALL = "all"
    VALUE = "value"
    JACOBIAN = "jacobian"
    NONZEROS = "nonzeros"


class Extent(NamedTuple):
    """The leading axes of a call and its number of items (None when not mapped)."""

    batch: tuple[int, ...]
    items: int | None


def outputs_of(signature: Signature, part: Part) -> tuple[Output, ...]:
    """The outputs that belong to a part."""
    if part is Part.ALL:
        return signature.outputs
    return signature.values if part is Part.VALUE else signature.jacobians


def output_shape(output: Output, part: Part, extent: Extent) -> tuple[int, ...]:
    """The whole shape of an output in a call."""
    items = (extent.items,) if output.item and extent.items is not None else ()
    own = (len(output.places),) if part is Part.NONZEROS else output.shape
    return (*extent.batch, *items, *own)


def collect(signature: Signature, given: Sequence[Any], inputs: Mapping[str, Any]) -> list[Any]:
    """Puts the arguments of a call in order; a missing or unknown name is a TypeError."""
    names = signature.names
    allowed = 1 if names[:1] == ("x",) else 0
    if len(given) == allowed and len(inputs) == len(names) - allowed:
        values = [*given, *map(inputs.get, names[allowed:])]
        if all(value is not None for value in values):
            return values
    if len(given) > allowed:
        raise TypeError(
            f"{signature.name}() takes {'x' if allowed else 'nothing'} by position and the rest by "
            f"name ({', '.join(names[allowed:]) or 'nothing'}); got {len(given)} positions"
        )
    if names[:1] == ("x",) and "x" in inputs and any(value is not None for value in given):
        raise TypeError(f"{signature.name}() got x both by position and by name")
    known = {**dict(zip(names, given, strict=False)), **inputs}
    for name in known:
        if name not in names:
            raise TypeError(_unknown(f"{signature.name}()", name, names))
    missing = [name for name in names if known.get(name) is None]
    if missing:
        wanted = "; ".join(_expectation(a) for a in signature.arguments if a.name in missing)
        raise TypeError(f"{signature.name}() needs {wanted}")
    return [known[name] for name in names]


def _unknown(function: str, name: str, names: Sequence[str]) -> str:
    near = difflib.get_close_matches(name, names, n=1, cutoff=0.5)
    advice = f"did you mean {near[0]!r}?" if near else f"it takes {', '.join(names)}"
    return f"{function} has no argument {name!r}; {advice}"


def _expectation(argument: Argument) -> str:
    """An argument with its shape, and with its blocks when there are several."""
    shape = ", ".join(("...", *argument.shape))
    blocks = " ".join(f"{domain.name}[{domain.size}]" for domain in argument.domains)
    return f"{argument.name}: expected ({shape})" + (
        f" = {blocks}" if argument.name == "x" or len(argument.domains) > 1 else ""
    )


def as_numbers(argument: Argument, value: Any, real: np.dtype[Any], complex_: bool) -> Array:
    """Converts an argument to an array of the back end's type; refuses what would lose meaning.

    The array is aligned in memory, as C expects of whatever it is given.
    """
    array = _as_array(argument, value)
    if array.dtype == (np.int32 if argument.integer else real):
        return array if array.flags.aligned else array.copy()
    kind = array.dtype.kind
    if argument.integer:
        if kind not in "iu" and array.size:
            raise TypeError(f"{argument.name}: expected integers, got {array.dtype}")
        limits = np.iinfo(np.int32)
        # A value that int32 cannot hold saturates, so that the range guard still refuses it.
        held = np.clip(array, limits.min, limits.max)  # a scalar, of an array without axes
        return np.asarray(held, dtype=np.int32)
    if kind == "c" and complex_:
        return array
    if kind not in "biuf":
        hint = "; use the numpy back end for complex steps" if kind == "c" else ""
        raise TypeError(f"{argument.name}: expected real numbers, got {array.dtype}{hint}")
    # What a shorter type cannot hold becomes infinite, which the range guard refuses.
    with np.errstate(over="ignore"):
        return array.astype(real, copy=False)


def _as_array(argument: Argument, value: Any) -> Array:
    """A plain array of NumPy's, of any type."""
    if type(value) is np.ndarray:
        return value
    if isinstance(value, np.ndarray) and np.ma.is_masked(value):
        raise TypeError(f"{argument.name}: some elements are masked; fill them or leave them out")
    try:
        return np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{_expectation(argument)}; {error}") from None


def measure(signature: Signature, arrays: Sequence[Array]) -> Extent:
    """Checks every shape and finds the leading axes and the number of items."""
    leading: list[tuple[int, ...]] = []
    count: int | None = None
    counter = ""
    for argument, array in zip(signature.arguments, arrays, strict=True):
        shape = tuple(array.shape)
        rank = argument.rank
        if len(shape) < rank or not (argument.scalar or shape[-1] == argument.size):
            raise ValueError(f"{_expectation(argument)}; got {shape}")
        leading.append(shape[: len(shape) - rank])
        if argument.item:
            items = shape[len(shape) - rank]
            if count is not None and items != count:
                raise ValueError(
                    f"{_expectation(argument)}; got {shape}, but {counter} has n = {count}"
                )
            count, counter = items, argument.name
    if count is not None and signature.maximum is not None and count > signature.maximum:
        raise GuardError(
            Status.COUNT,
            f"{signature.name}: COUNT: {counter} has n = {count}, the declared maximum is "
            f"{signature.maximum}",
            counter,
            value=float(count),
            bounds=(0.0, float(signature.maximum)),
        )
    if len(set(leading)) == 1:
        return Extent(leading[0], count)
    try:
        return Extent(np.broadcast_shapes(*leading), count)
    except ValueError:
        shapes = ", ".join(
            f"{name} {axes}" for name, axes in zip(signature.names, leading, strict=True)
        )
        raise ValueError(f"{signature.name}: leading axes do not broadcast: {shapes}") from None


def targets(
    signature: Signature, part: Part, extent: Extent, out: Any, real: np.dtype[Any]
) -> list[Array]:
    """Checks the arrays given as ``out`` and returns them in the order of the outputs."""
    wanted = outputs_of(signature, part)
    names = [output.name for output in wanted]
    given = _named(signature, part, names, out)
    for output, name in zip(wanted, names, strict=True):
        array, shape = given[name], output_shape(output, part, extent)
        if not isinstance(array, np.ndarray):
            raise TypeError(f"out: {name} must be a NumPy array, got {type(array).__name__}")
        if array.shape != shape or array.dtype != real:
            raise ValueError(
                f"out: {name} must be {real} of shape {shape}; got {array.dtype} {array.shape}"
            )
        if not array.flags.writeable:
            raise ValueError(f"out: {name} is read-only")
        columns = part is Part.NONZEROS and output.item and extent.items is not None
        if not (array.flags.c_contiguous or (columns and array.mT.flags.c_contiguous)):
            raise ValueError(f"out: {name} must be contiguous in memory, row by row")
        if not array.flags.aligned:
            raise ValueError(f"out: {name} must be aligned in memory")
    return [given[name] for name in names]


def _named(signature: Signature, part: Part, names: list[str], out: Any) -> Mapping[str, Any]:
    if isinstance(out, Mapping):
        for name in out:
            if name not in names:
                raise TypeError(_unknown("out", str(name), names))
        missing = [name for name in names if name not in out]
        if missing:
            raise TypeError(f"out: {signature.name} also writes {', '.join(missing)}")
        return out
    if not isinstance(out, Iterable):
        raise TypeError(f"out: expected arrays for {', '.join(names)}; got {type(out).__name__}")
    given = (out,) if isinstance(out, np.ndarray) else tuple(out)
    fields = len(names) + (1 + signature.mapped if part is Part.ALL else 0)
    if len(given) not in (len(names), fields):
        raise TypeError(f"out: {signature.name} writes {', '.join(names)}; got {len(given)} arrays")
    return dict(zip(names, given, strict=False))


def forbid_overlap(signature: Signature, arrays: Sequence[Array], written: Sequence[Array]) -> None:
    """Refuses an output that shares memory with an argument or with another output."""
    named = [*zip(signature.names, arrays, strict=True)]
    for number, target in enumerate(written):
        for name, array in [*named, *(("another output", a) for a in written[:number])]:
            if np.may_share_memory(target, array):
                raise ValueError(f"out: an output shares memory with {name}")
