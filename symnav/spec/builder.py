"""Specifications from Python: the same tables as in TOML, composed from small pieces.

``build("rover", frame("n", "ned"), vector("position", 3, "m", frame="n"), ...)`` reads like the
file and ends in the same validation. Pieces are frozen values: they may be kept, shared between
specifications and put together in any way that Python offers. An equation may be a Python function
``f(q) -> Quantity`` over ``q.<state or input>`` instead of text.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from symnav.spec.loading import from_table
from symnav.spec.records import Spec

Equation = str | Sequence[str] | Callable[[Any], Any]


@dataclass(frozen=True)
class Piece:
    """One table of a specification.

    Attributes:
        section: ``frame``, ``state``, ``input``, ``measurement`` or ``correction``.
        fields: its keys and values, as TOML would give them.
    """

    section: str
    fields: Mapping[str, Any]


def frame(name: str, axes: str) -> Piece:
    """A frame with axes ``ned``, ``enu``, ``ecef`` or ``free``."""
    return Piece("frame", {"name": name, "axes": axes})


def vector(name: str, size: int, unit: str, **fields: Any) -> Piece:
    """A state block of several elements; ``frame``, ``error_frame``, ``error_sign``, ``range``."""
    return _state("vector", name=name, size=size, unit=unit, **fields)


def scalar(name: str, unit: str, **fields: Any) -> Piece:
    """A state block of one element; ``error_sign``, ``range``."""
    return _state("scalar", name=name, unit=unit, **fields)


def rotation(name: str, maps: str, **fields: Any) -> Piece:
    """A rotation block; ``storage``, ``error``, ``normalise``, ``norm_tolerance``."""
    return _state("rotation", name=name, maps=maps, **fields)


def heading(name: str, maps: str, **fields: Any) -> Piece:
    """A rotation about one axis; ``axis``, ``range``."""
    return _state("heading", name=name, maps=maps, **fields)


def geodetic(name: str, frame: str, error_frame: str, **fields: Any) -> Piece:
    """Latitude, longitude and height; ``attitude_frame``, ``range``."""
    return _state("geodetic", name=name, frame=frame, error_frame=error_frame, **fields)


def argument(name: str, **fields: Any) -> Piece:
    """A run-time argument, with the keys of ``[[input]]``; what is left out is implied."""
    return Piece("input", _plain({"name": name, **fields}))


def measurement(
    name: str, model: str | None = None, *, equation: Equation | None = None, **fields: Any
) -> Piece:
    """A measurement: a model of the library with bindings and options, or an equation."""
    return _entry("measurement", name, model, equation, fields)


def correction(
    name: str, model: str | None = None, *, equation: Equation | None = None, **fields: Any
) -> Piece:
    """A correction: a model of the library with bindings and options, or an equation."""
    return _entry("correction", name, model, equation, fields)


def table(name: str, pieces: Iterable[Piece], **head: Any) -> dict[str, Any]:
    """The table that the pieces make, as TOML would give it."""
    result: dict[str, Any] = {"name": name, **_plain(head)}
    for piece in pieces:
        result.setdefault(piece.section, []).append(dict(piece.fields))
    return result


def build(name: str, *pieces: Piece, **head: Any) -> Spec:
    """Validate the pieces; states keep their order, which is the order of memory.

    Args:
        name: prefix of every C symbol and name of the package.
        *pieces: frames, states, inputs, measurements and corrections.
        **head: ``scalar`` or ``scalars``, ``description``.

    Raises:
        SpecError: when there are mistakes; all of them are listed.
    """
    return from_table(table(name, pieces, **head), name)


def _state(kind: str, **fields: Any) -> Piece:
    return Piece("state", _plain({"kind": kind, **fields}))


def _entry(
    section: str,
    name: str,
    model: str | None,
    equation: Equation | None,
    fields: Mapping[str, Any],
) -> Piece:
    given = {"name": name, "model": model, "equation": equation, **fields}
    if isinstance(equation, str):
        given["equation"] = [equation]
    return Piece(section, _plain({key: v for key, v in given.items() if v is not None}))


def _plain(value: Any) -> Any:
    """Tuples as lists, all the way down; TOML knows no others."""
    if isinstance(value, Mapping):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(entry) for entry in value]
    return value
