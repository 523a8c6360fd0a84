"""Quaternions that are fed back: what the documentation of a retraction says of their norms."""

from __future__ import annotations

import numpy as np
import pytest

from symnav import ir, pipeline
from symnav.export.arithmetic.evaluation import evaluate
from symnav.export.testing.golden import dense
from symnav.spec import from_table


def retraction(error: str, **more: bool) -> ir.Function:
    """The function of a layout with one attitude."""
    state = {"name": "attitude", "kind": "rotation", "maps": "b -> n", "error": error, **more}
    loaded = from_table({"name": "rover", "state": [state]})
    made = pipeline.c_route(loaded, pipeline.derive(loaded))
    return next(function for function in made if function.name == "retract")


def updates(function: ir.Function, *, renormalise: bool, most: int = 600) -> int:
    """Updates by the same small error until a call ends in QNORM."""
    y = np.array([[0.5, -0.5, 0.5, 0.5]], dtype=np.float32)
    d = np.full((1, 3), 1.1e-3, dtype=np.float32)
    for count in range(most):
        outcome = evaluate(function, ir.Scalar.FLOAT, {"x": y, "d": d})
        if outcome.status.any():
            assert outcome.status[0] == ir.Status.QNORM
            return count
        y = dense(function.outputs[0], outcome)
        if renormalise:
            y = (y * (np.float32(1.5) - np.float32(0.5) * np.sum(y * y))).astype(np.float32)
    return most


@pytest.mark.parametrize("error", ["right", "left", "left_negative", "right_negative"])
def test_products_drift_and_renormalising_is_enough(error: str) -> None:
    """As the convention says."""
    function = retraction(error)
    assert "q *= 1.5 - 0.5 |q|^2" in " ".join(function.conventions)
    assert updates(function, renormalise=False) < 600
    assert updates(function, renormalise=True) == 600


def test_what_is_renewed_by_every_update_says_nothing() -> None:
    """The exponential of a sum is of unit norm; with a division no norm is judged."""
    function = retraction("rotation_vector")
    assert function.conventions == () and updates(function, renormalise=False) == 600
    assert retraction("right", normalise=True).conventions == ()


def test_sums_are_to_be_divided_by_their_norms() -> None:
    """A step of Newton's is not enough for them."""
    (said,) = retraction("storage").conventions
    assert "divide it by its norm" in said
