"""The functions of a package as their callers use them, whatever evaluates them."""

from __future__ import annotations

import inspect
import operator
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from . import _lanes
from ._explain import explain
from ._runtime import (
    Argument,
    Array,
    Extent,
    GuardError,
    Output,
    Part,
    Signature,
    Slot,
    Status,
    as_numbers,
    collect,
    forbid_overlap,
    measure,
    targets,
)


class Evaluation(NamedTuple):
    """What a back end hands back.

    Attributes:
        outputs: in the order of the part that was asked for.
        status: a ``Status`` for one epoch of NumPy arrays, else an array over the leading axes.
        item_status: one per item; None where the function is not mapped.
    """

    outputs: Sequence[Array]
    status: Any
    item_status: Array | None


class Function(ABC):
    """One function on one back end."""

    real: np.dtype[Any] = np.dtype(np.float64)

    def __init__(self, signature: Signature) -> None:
        self.signature = signature

    def prepare(self, values: Sequence[Any]) -> list[Array]:
        """Real arrays of NumPy of the back end's type; complex numbers are refused."""
        pairs = zip(self.signature.arguments, values, strict=True)
        return [as_numbers(argument, value, self.real, False) for argument, value in pairs]

    def type_of(self, _arrays: Sequence[Array]) -> np.dtype[Any]:
        """The type of the outputs of NumPy's arrays."""
        return self.real

    @abstractmethod
    def evaluate(
        self, part: Part, arrays: Sequence[Array], extent: Extent, out: list[Array] | None
    ) -> Evaluation:
        """Computes a part of the outputs; writes rows that pass into ``out`` when it is given."""

    @abstractmethod
    def difference(
        self, arrays: Sequence[Array], extent: Extent, reference: int, out: list[Array] | None
    ) -> Evaluation:
        """Computes all outputs as differences to the item ``reference``."""

    def bound(self, arrays: Sequence[Array], extent: Extent, out: list[Array]) -> Callable[[], Any]:
        """A function without arguments that reads and writes the same arrays every time."""

        def call() -> Any:
            return self.result(self.evaluate(Part.ALL, arrays, extent, out), arrays)

        return call

    def evaluate_blocks(
        self,
        arrays: Sequence[Array],
        epochs: int,
        outputs: Mapping[str, Array],
        status: Array,
    ) -> None:
        """Computes epochs that lie side by side in blocks; what fails stays untouched."""
        _lanes.evaluate_rows(self, arrays, epochs, outputs, status)

    def bound_blocks(
        self,
        arrays: Sequence[Array],
        epochs: int,
        outputs: Mapping[str, Array],
        status: Array,
    ) -> Callable[[], Any]:
        """The same as a function without arguments."""
        return partial(self.evaluate_blocks, arrays, epochs, outputs, status)

    def call(self, state: Sequence[Any], inputs: Mapping[str, Any], out: Any = None) -> Any:
        """All outputs, as the function's result type."""
        arrays, evaluation = self._run(Part.ALL, state, inputs, out)
        return self.result(evaluation, arrays)

    def select(
        self, part: Part, state: Sequence[Any], inputs: Mapping[str, Any], out: Any = None
    ) -> Any:
        """The arrays of one part; a single one is not wrapped in a tuple."""
        arrays, evaluation = self._run(part, state, inputs, out)
        self._refuse(evaluation, arrays)
        outputs = tuple(evaluation.outputs)
        return outputs[0] if len(outputs) == 1 else outputs

    def selector(self, part: Part) -> Callable[..., Any]:
        """``select`` for one part, by the quickest way there is."""
        return partial(self.select, part)

    def single_difference(
        self, state: Sequence[Any], inputs: Mapping[str, Any], reference: int, out: Any = None
    ) -> Any:
        """All outputs with the reference item's rows subtracted and removed."""
        arrays = self.prepare(collect(self.signature, state, inputs))
        extent = measure(self.signature, arrays)
        count = extent.items or 0
        chosen = reference_item(self.signature.name, reference, count)
        written = self._written(Part.ALL, arrays, Extent(extent.batch, count - 1), out)
        return self.result(self.difference(arrays, extent, chosen, written), arrays)

    def bind(self, state: Sequence[Any], inputs: Mapping[str, Any], out: Any = None) -> Any:
        """Checks the arguments once and returns a call that repeats the evaluation."""
        values = collect(self.signature, state, inputs)
        arrays = self.prepare(values)
        for argument, value, array in zip(self.signature.arguments, values, arrays, strict=True):
            _require_lasting(argument, value, array)
        extent = measure(self.signature, arrays)
        if out is None:
            out = self.evaluate(Part.ALL, arrays, extent, None).outputs
        written = self._written(Part.ALL, arrays, extent, out)
        return self.bound(arrays, extent, written or [])

    def result(self, evaluation: Evaluation, arrays: Sequence[Array]) -> Any:
        """The result tuple of an evaluation of all outputs."""
        self._refuse(evaluation, arrays)
        items = () if evaluation.item_status is None else (evaluation.item_status,)
        fields = (*evaluation.outputs, evaluation.status, *items)
        return tuple.__new__(self.signature.result, fields)

    def _refuse(self, evaluation: Evaluation, arrays: Sequence[Array]) -> None:
        """Raises the guard of an epoch that failed on its own."""
        status = evaluation.status
        if isinstance(status, Status) and status not in (Status.OK, Status.PARTIAL):
            raise explain(self.signature, status, arrays)

    def _run(
        self, part: Part, state: Sequence[Any], inputs: Mapping[str, Any], out: Any
    ) -> tuple[list[Array], Evaluation]:
        arrays = self.prepare(collect(self.signature, state, inputs))
        extent = measure(self.signature, arrays)
        written = self._written(part, arrays, extent, out)
        return arrays, self.evaluate(part, arrays, extent, written)

    def _written(
        self, part: Part, arrays: Sequence[Array], extent: Extent, out: Any
    ) -> list[Array] | None:
        if out is None:
            return None
        if not all(isinstance(array, np.ndarray) for array in arrays):
            raise TypeError(f"out: {self.signature.name} writes to it only from NumPy's arrays")
        written = targets(self.signature, part, extent, out, self.type_of(arrays))
        forbid_overlap(self.signature, arrays, written)
        return written


def _require_lasting(argument: Argument, value: Any, array: Array) -> None:
    """Refuses an argument whose later changes a bound call would not see."""
    if isinstance(value, (int, float)) and argument.scalar:
        return
    if array is not value or not isinstance(array, np.ndarray) or not array.flags.c_contiguous:
        kind = np.dtype(np.int32) if argument.integer else array.dtype
        raise TypeError(
            f"bind: {argument.name} must be a contiguous NumPy array of {kind}, aligned in memory, "
            "so that later changes to it are seen"
        )


#: Largest standard deviation whose square does not overflow, as in the C.
_LARGEST = {np.dtype(np.float64): 1e150, np.dtype(np.float32): 1e18}


def reference_item(function: str, reference: Any, count: int) -> int:
    """The reference item of a difference, checked."""
    try:
        number = operator.index(reference)
    except TypeError:
        raise TypeError(
            f"{function}: reference is the index of an item, an integer; got {reference!r}"
        ) from None
    if not 0 <= number < count:
        raise GuardError(
            Status.INDEX,
            f"{function}: INDEX: reference = {number}, but there are {count} items",
            "reference",
            value=float(number),
            bounds=(0.0, float(count - 1)),
        )
    return number


def _check_count(signature: Signature, name: str, count: int) -> None:
    maximum = signature.maximum
    if maximum is not None and not 0 <= count <= maximum:
        raise GuardError(
            Status.COUNT,
            f"{signature.name}: COUNT: {name} has n = {count}, the declared maximum is {maximum}",
            name,
            value=float(count),
            bounds=(0.0, float(maximum)),
        )


def _check_deviations(signature: Signature, sigma: Array, largest: float) -> None:
    failed = np.argwhere(~((sigma >= 0.0) & (sigma <= largest)))
    if signature.guarded and len(failed):
        index = tuple(int(k) for k in failed[0])
        value = float(sigma[index])
        place = "".join(f"[{k}]" for k in index)
        raise GuardError(
            Status.RANGE,
            f"{signature.name}: RANGE: sigma{place} = {value!r} is outside the range "
            f"[0, {largest:g}]",
            "sigma",
            index,
            value,
            (0.0, largest),
        )


def _differences(function: Function) -> dict[str, Callable[..., Any]]:
    """The constant matrix of single differences, and the covariance it makes."""
    signature, largest = function.signature, _LARGEST[function.real]

    def difference_matrix(count: int, reference: int) -> Array:
        """The (n - 1) by n matrix that subtracts the reference row and removes it."""
        _check_count(signature, "count", count)
        chosen = reference_item(signature.name, reference, count)
        matrix = np.delete(np.eye(count), chosen, axis=0)
        matrix[:, chosen] = -1.0
        return matrix

    def difference_covariance(sigma: Any, reference: int) -> Array:
        """The covariance of single differences of items with independent noise.

        Args:
            sigma: standard deviations, shape (..., n).
            reference: the item that is subtracted.

        Returns:
            Shape (..., n - 1, n - 1): variances plus the reference's variance everywhere.
        """
        deviations = np.asarray(sigma, dtype=np.float64)
        if not deviations.ndim:
            raise ValueError(f"{signature.name}: sigma: expected (..., n); got ()")
        _check_count(signature, "sigma", deviations.shape[-1])
        matrix = difference_matrix(deviations.shape[-1], reference)
        _check_deviations(signature, deviations, largest)
        variances = np.square(deviations)
        covariance: Array = (matrix * variances[..., None, :]) @ matrix.T
        return covariance

    return {
        "difference_matrix": difference_matrix,
        "difference_covariance": difference_covariance,
    }


def publish(function: Function, module: str, joint: Callable[..., Any] | None = None) -> Any:
    """Makes the public function: a plain Python function that carries its other forms.

    Args:
        function: evaluates.
        module: name of the back end, for documentation and pickling.
        joint: a quicker way into the same evaluation, when the back end has one.
    """
    signature = function.signature

    def call(*state: Any, out: Any = None, **inputs: Any) -> Any:
        return function.call(state, inputs, out)

    public = _describe(joint or call, function, module, signature.name)
    public.__doc__ = inspect.cleandoc(signature.documentation)
    public.__dict__.update(
        {name: _describe(form, function, module, name) for name, form in _forms(function).items()}
    )
    for output in signature.jacobians:
        rows, columns = _indices(output)
        public.__dict__.update({f"{output.name}_rows": rows, f"{output.name}_columns": columns})
    if signature.single_difference:
        for name, form in _differences(function).items():
            public.__dict__[name] = _name(form, function, module, name)
    if not signature.mapped:
        public.__dict__.update(lanes=signature.lanes, from_lanes=_lanes.from_lanes)
        public.__dict__["to_lanes"] = _name(
            _lanes.to_lanes_of(signature.lanes), function, module, "to_lanes"
        )
        for name, form in _lanes.forms(function).items():
            public.__dict__[name] = _describe(form, function, module, name)
    return public


def _forms(function: Function) -> dict[str, Callable[..., Any]]:
    """The forms of a function beside the joint call."""
    select_value, select_jacobian, select_nonzeros = map(
        function.selector, (Part.VALUE, Part.JACOBIAN, Part.NONZEROS)
    )

    def value(*state: Any, out: Any = None, **inputs: Any) -> Any:
        """Outputs that are not Jacobians: the array, or a tuple of arrays."""
        return select_value(state, inputs, out)

    def jacobian(*state: Any, out: Any = None, **inputs: Any) -> Any:
        """Jacobians: the array, or a tuple of arrays."""
        return select_jacobian(state, inputs, out)

    def nonzeros(*state: Any, out: Any = None, **inputs: Any) -> Any:
        """Structural non-zeros of the Jacobians along the last axis, in the order of the tables."""
        return select_nonzeros(state, inputs, out)

    def bind(*state: Any, out: Any = None, **inputs: Any) -> Any:
        """A function without arguments over these very arrays; see the joint call for the rest."""
        return function.bind(state, inputs, out)

    def single_difference(*state: Any, reference: int, out: Any = None, **inputs: Any) -> Any:
        """All outputs as differences to the item ``reference``, whose row is removed."""
        return function.single_difference(state, inputs, reference, out)

    forms: dict[str, Callable[..., Any]] = {"value": value, "bind": bind}
    if function.signature.jacobians:
        forms.update(jacobian=jacobian, nonzeros=nonzeros)
    if function.signature.single_difference:
        forms.update(single_difference=single_difference)
    return forms


def _describe(
    call: Callable[..., Any], function: Function, module: str, name: str
) -> Callable[..., Any]:
    """Gives a function the name and signature a reader expects."""
    kinds = inspect.Parameter
    parameters = [
        kinds(argument, kinds.POSITIONAL_ONLY if argument == "x" else kinds.KEYWORD_ONLY)
        for argument in function.signature.names
    ]
    if name == "single_difference":
        parameters.append(kinds("reference", kinds.KEYWORD_ONLY))
    if name in ("blocks", "bind_blocks"):
        parameters.append(kinds("epochs", kinds.KEYWORD_ONLY, default=None))
    parameters.append(kinds("out", kinds.KEYWORD_ONLY, default=None))
    call.__dict__["__signature__"] = inspect.Signature(parameters)
    return _name(call, function, module, name)


def _name(
    call: Callable[..., Any], function: Function, module: str, name: str
) -> Callable[..., Any]:
    """Gives a function the name by which it is found, and pickled."""
    own = function.signature.name
    call.__module__ = module
    call.__name__ = name
    call.__qualname__ = own if name == own else f"{own}.{name}"
    return call


def _indices(output: Output) -> tuple[Array, Array]:
    """Rows and columns of the non-zeros; those of a slot are given for index zero."""
    bases = [place.base if isinstance(place, Slot) else place for place in output.places]
    columns = output.shape[-1] if output.shape else 1
    rows_columns = np.divmod(np.array(bases, dtype=np.int32), np.int32(columns))
    for table in rows_columns:
        table.flags.writeable = False
    return rows_columns
