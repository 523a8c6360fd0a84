"""What is compared with the libraries: named implementations, each a table of capabilities.

``<model>``
    ``(quantities, options) -> {output: flat array}``, quantities as in :mod:`tests.reference`, with
    floats.
``<model>.jacobian``
    ``(quantities, options, errors) -> array`` of ``value`` toward a sequence of
    :class:`tests.reference.jacobian.Error`.
``retract``, ``local``
    ``(kind, convention, x, d or y) -> array``.
``ecef``
    ``(llh) -> array``.

Another implementation is another entry of ``IMPLEMENTATIONS``; a comparison runs for every one that
offers what it needs, so an entry may leave capabilities out.
"""

import importlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf
from numpy.typing import NDArray

from tests.reference import blocks, earth
from tests.reference.jacobian import Error, jacobian

Array = NDArray[np.float64]
Implementation = Mapping[str, Callable[..., Any]]

DIGITS = 40
MODELS = (
    "broadcast_orbit",
    "gnss_position",
    "gnss_position_to_state_frame",
    "local_from_geodetic",
    "pseudorange",
    "pseudorange_relative",
    "specific_force",
)


def lift(data: Any) -> Any:
    """Turn every number of nested quantities into multiple precision, exactly."""
    if isinstance(data, Mapping):
        return {key: lift(part) for key, part in data.items()}
    if isinstance(data, str) or data is None:
        return data
    if isinstance(data, Sequence | np.ndarray):
        return [lift(part) for part in data]
    return mpf(float(data))


def lower(numbers: Any) -> Array:
    """Round nested numbers to double precision."""
    return np.array(mp.matrix(numbers).tolist() if isinstance(numbers[0], list) else numbers, float)


def reference_value(model: str) -> Callable[..., dict[str, Array]]:
    """Give the reference of a model on floats."""
    module = importlib.import_module(f"tests.reference.{model}")

    def value(quantities: Mapping[str, Any], options: Mapping[str, Any]) -> dict[str, Array]:
        with mp.workdps(DIGITS):
            outputs = module.value(lift(quantities), options)
            return {name: lower(numbers) for name, numbers in outputs.items()}

    return value


def reference_jacobian(model: str) -> Callable[..., Array]:
    """Give the Jacobian of a reference on floats."""
    module = importlib.import_module(f"tests.reference.{model}")

    def differentiate(
        quantities: Mapping[str, Any], options: Mapping[str, Any], errors: Sequence[Error]
    ) -> Array:
        with mp.workdps(DIGITS):
            lifted = [
                replace(e, setting=replace(e.setting, rotation=lift(e.setting.rotation)))
                for e in errors
            ]
            return lower(jacobian(module.value, lift(quantities), options, lifted))

    return differentiate


def in_floats(function: Callable[..., Any]) -> Callable[..., Array]:
    """Let a function of multiple-precision vectors take and give floats."""

    def rounded(*arguments: Any) -> Array:
        with mp.workdps(DIGITS):
            return lower(function(*(lift(argument) for argument in arguments)))

    return rounded


def reference() -> Implementation:
    """Collect the references, with everything they offer."""
    capabilities: dict[str, Callable[..., Any]] = {
        "retract": in_floats(blocks.retract),
        "local": in_floats(blocks.local),
        "ecef": in_floats(earth.ecef),
    }
    for model in MODELS:
        capabilities[model] = reference_value(model)
        capabilities[f"{model}.jacobian"] = reference_jacobian(model)
    return capabilities


IMPLEMENTATIONS: dict[str, Implementation] = {"reference": reference()}


def offering(*capabilities: str) -> pytest.MarkDecorator:
    """Parametrise a test over all implementations that offer what it needs."""
    chosen = {
        name: table for name, table in IMPLEMENTATIONS.items() if set(capabilities) <= set(table)
    }
    return pytest.mark.parametrize("implementation", chosen.values(), ids=chosen.keys())
