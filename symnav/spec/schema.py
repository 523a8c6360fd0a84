"""The tables of a specification as pydantic models: shapes and types, nothing about meaning.

This is the only module that imports pydantic; everything behind it reads frozen records. The
published JSON Schema comes from these models, so field descriptions are written for users.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, Any, Literal

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    PlainValidator,
    ValidationError,
    WithJsonSchema,
)

from symnav.figures import readable

Pair = tuple[float, float]
ErrorSign = Literal["true_minus_estimate", "estimate_minus_true"]
ErrorConvention = Literal[
    "right", "left", "left_negative", "right_negative", "rotation_vector", "storage"
]
ScalarType = Literal["double", "float"]
BindingValue = str | float | tuple[float, ...] | dict[str, str] | bool


def _number(value: object) -> float:
    """A finite number; booleans are not numbers here."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ValueError(f"{value!r} is not a number")
    try:
        number = float(value)
    except OverflowError:
        raise ValueError("the integer is too large") from None
    if not math.isfinite(number):
        raise ValueError(f"{value!r} is not finite")
    return number


def _tolerance(value: object) -> float:
    number = _number(value)
    if not 0.0 < number < 1.0:
        raise ValueError(f"{value!r} is not a tolerance between 0 and 1")
    return number


def _pair(value: list[object]) -> Pair:
    if len(value) != 2:
        raise ValueError(f"{value!r} is not a pair [lower, upper]")
    lower, upper = (_number(bound) for bound in value)
    if not lower < upper:
        low, high = readable(lower), readable(upper)
        raise ValueError(f"lower bound {low} is not below upper bound {high}")
    return lower, upper


def _range(value: object) -> tuple[Pair, ...] | None:
    """One pair, or one pair per element."""
    if value is None:
        return None
    if not isinstance(value, list) or not value:
        raise ValueError(f"{value!r} is not a range; write [lower, upper] or a list of such pairs")
    if all(isinstance(entry, list) for entry in value):
        return tuple(_pair(entry) for entry in value)
    return (_pair(value),)


def _binding(value: object) -> BindingValue:
    """A name, a number, a list of numbers, or a table of names; options may be booleans."""
    if isinstance(value, (str, bool)):
        return value
    if isinstance(value, int):
        _number(value)
        return value
    if isinstance(value, float):
        return _number(value)
    if isinstance(value, list) and value:
        return tuple(_number(entry) for entry in value)
    if isinstance(value, dict) and value and all(isinstance(v, str) for v in value.values()):
        return dict(value)
    raise ValueError(
        f"{value!r} is not a binding; write a state or input by name, 'input', 'none', a number, "
        "a list of numbers or a table of names"
    )


def _equation(value: object) -> tuple[str, ...] | Callable[[Any], Any]:
    """Expressions, or a Python function where the specification comes from Python."""
    if callable(value):
        return value
    if isinstance(value, list) and value and all(isinstance(entry, str) for entry in value):
        return tuple(value)
    raise ValueError(f"{value!r} is not an equation; write a list of expressions in quotes")


_NUMBER_SCHEMA = {"type": "number"}
_PAIR_SCHEMA = {"type": "array", "items": _NUMBER_SCHEMA, "minItems": 2, "maxItems": 2}

Tolerance = Annotated[
    float,
    PlainValidator(_tolerance),
    WithJsonSchema({**_NUMBER_SCHEMA, "exclusiveMinimum": 0, "exclusiveMaximum": 1}),
]
Range = Annotated[
    tuple[Pair, ...] | None,
    PlainValidator(_range),
    WithJsonSchema(
        {"anyOf": [_PAIR_SCHEMA, {"type": "array", "items": _PAIR_SCHEMA, "minItems": 1}]}
    ),
]
Binding = Annotated[
    BindingValue,
    PlainValidator(_binding),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": ["string", "number", "boolean"]},
                {"type": "array", "items": _NUMBER_SCHEMA, "minItems": 1},
                {"type": "object", "additionalProperties": {"type": "string"}},
            ]
        }
    ),
]
Equation = Annotated[
    tuple[str, ...] | Callable[[Any], Any],
    PlainValidator(_equation),
    WithJsonSchema({"type": "array", "items": {"type": "string"}, "minItems": 1}),
]


class Table(BaseModel):
    """A table without unknown keys; nothing is converted."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


class FrameTable(Table):
    """A declared frame."""

    name: str = Field(description="Name used by frame, maps and error_frame.")
    axes: Literal["ned", "enu", "ecef", "free"] = Field(
        description="Directions of the axes: local-level, earth-fixed or free."
    )


class _Named(Table):
    name: str = Field(description="Identifier in C and Python.")
    description: str = Field("", description="One sentence for the documentation.")


class _Ranged(_Named):
    range: Range = Field(
        None,
        description="Least and greatest value, or one such pair per element; guards, tests and "
        "proofs use it.",
    )


class VectorTable(_Ranged):
    """Elements with an additive error."""

    kind: Literal["vector"]
    size: int = Field(ge=1, le=1000, description="Number of elements.")
    unit: str = Field(description="SI unit of every element, such as 'm/s^2'.")
    frame: str = Field("", description="Frame a 3-vector is resolved in.")
    error_frame: str = Field("", description="Frame its error is resolved in, if another.")
    error_sign: ErrorSign = Field("true_minus_estimate", description="Sign of the additive error.")


class ScalarTable(_Ranged):
    """One element with an additive error."""

    kind: Literal["scalar"]
    unit: str = Field(description="SI unit.")
    error_sign: ErrorSign = Field("true_minus_estimate", description="Sign of the additive error.")


class RotationTable(_Named):
    """A rotation stored as a Hamilton quaternion."""

    kind: Literal["rotation"]
    maps: str = Field(description="'b -> n': takes vectors from b to n.")
    storage: Literal["wxyz", "xyzw", "dcm"] = Field(
        "wxyz", description="Order of the elements; 'dcm' (9, row-major) for inputs only."
    )
    error: ErrorConvention = Field("right", description="How the error enters.")
    normalise: bool = Field(False, description="Divide by the norm instead of trusting it.")
    norm_tolerance: Tolerance = Field(
        1e-5, description="Largest deviation of the squared norm from one."
    )


class HeadingTable(_Ranged):
    """A rotation about one axis by one angle."""

    kind: Literal["heading"]
    maps: str = Field(description="'L -> G': takes vectors from L to G.")
    axis: Literal["x", "y", "z"] = Field("z", description="Axis both frames share.")


class GeodeticTable(_Ranged):
    """Latitude, longitude and height on WGS-84, with an error in metres."""

    kind: Literal["geodetic"]
    frame: str = Field(description="Declared earth-fixed frame (axes 'ecef').")
    error_frame: str = Field(description="Declared local-level frame (axes 'ned' or 'enu').")
    attitude_frame: Literal["fixed", "moving"] = Field(
        "fixed", description="Whether the local-level axes turn with the position error."
    )


StateTable = VectorTable | ScalarTable | RotationTable | HeadingTable | GeodeticTable
STATE_TABLES: dict[str, type[StateTable]] = {
    "vector": VectorTable,
    "scalar": ScalarTable,
    "rotation": RotationTable,
    "heading": HeadingTable,
    "geodetic": GeodeticTable,
}


class InputTable(_Ranged):
    """A run-time argument; what is left out comes from the quantity it is bound to."""

    kind: Literal["vector", "scalar", "rotation", "heading", "geodetic"] | None = None
    size: int | None = Field(None, ge=1, le=1000, description="Number of elements.")
    unit: str | None = Field(None, description="SI unit of every element.")
    frame: str | None = Field(None, description="Frame a 3-vector is resolved in.")
    error_frame: str | None = Field(None, description="Frame its error is resolved in.")
    error_sign: ErrorSign | None = None
    maps: str | None = Field(None, description="'b -> n', of a rotation or heading.")
    storage: Literal["wxyz", "xyzw", "dcm"] | None = None
    error: ErrorConvention | None = None
    normalise: bool | None = None
    norm_tolerance: Tolerance | None = None
    axis: Literal["x", "y", "z"] | None = None
    attitude_frame: Literal["fixed", "moving"] | None = None
    item: bool | None = Field(None, description="True when each item has its own value.")


class EntryTable(Table):
    """A measurement or correction: a model with its bindings and options, or an equation."""

    model_config = ConfigDict(extra="allow", strict=True, frozen=True)
    __pydantic_extra__: dict[str, Binding]

    name: str = Field(description="Name of the generated function.")
    model: str | None = Field(None, description="Name of a model of the library.")
    equation: Equation | None = Field(None, description="Components of the user's own equation.")
    let: dict[str, str] = Field(
        default_factory=dict, description="Named terms of the equation, in order."
    )
    unit: str | None = Field(None, description="Unit the equation's result must have.")
    frame: str | None = Field(None, description="Frame the equation's result must have.")
    description: str = Field("", description="One line for the documentation.")
    jacobians: list[str] = Field(
        default_factory=list, description="Inputs whose Jacobians are wanted."
    )
    residual: bool | str = Field(
        False,
        description="Adds an input 'measured' (or of the name given) and the output measured "
        "minus predicted.",
    )
    maximum: int | None = Field(None, ge=1, le=100_000, description="Most items in one call.")
    items: Literal["skip", "reject"] = Field("skip", description="What a failed item does.")
    difference: Literal["single"] | None = Field(
        None, description="Adds the form differenced against one item."
    )
    order: Literal["row", "column"] = Field("row", description="Order of dense Jacobians.")
    guards: Literal["status", "assume"] = Field(
        "status", description="'assume' leaves the checks out."
    )
    scalar: ScalarType | None = Field(None, description="Scalar type of this function.")
    scalars: list[ScalarType] | None = Field(None, min_length=1)


class SpecTable(Table):
    """A whole specification."""

    name: str = Field(description="Prefix of every C symbol and name of the package.")
    description: str = Field("", description="One sentence for the documentation.")
    scalar: ScalarType | None = Field(None, description="Scalar type of the emitted C.")
    scalars: list[ScalarType] | None = Field(
        None, min_length=1, description="Scalar types of the emitted C."
    )
    frame: list[FrameTable] = Field(default_factory=list)
    state: list[Annotated[StateTable, Field(discriminator="kind")]] = Field(default_factory=list)
    input: list[InputTable] = Field(default_factory=list)
    measurement: list[EntryTable] = Field(default_factory=list)
    correction: list[EntryTable] = Field(default_factory=list)


#: Tables that stand in lists, by section.
SECTIONS: dict[str, type[Table]] = {
    "frame": FrameTable,
    "input": InputTable,
    "measurement": EntryTable,
    "correction": EntryTable,
}


def json_schema() -> dict[str, Any]:
    """The JSON Schema of a specification, for editors."""
    schema = SpecTable.model_json_schema()
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


__all__ = [
    "SECTIONS",
    "STATE_TABLES",
    "EntryTable",
    "FrameTable",
    "GeodeticTable",
    "HeadingTable",
    "InputTable",
    "RotationTable",
    "ScalarTable",
    "SpecTable",
    "StateTable",
    "Table",
    "ValidationError",
    "VectorTable",
    "json_schema",
]
