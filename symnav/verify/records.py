"""Samples as flat records, for programs that read their inputs from a file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symnav.derive import Derivation
from symnav.errors import ProofError
from symnav.spec.records import Spec
from symnav.verify.sampling import draw

COUNT = 256
"""Samples drawn for each function; those outside its domain are left out."""


def records(
    spec: Spec, derivations: Sequence[Derivation], functions: Any, items: int, seed: int = 1
) -> dict[str, NDArray[np.float64]]:
    """Inputs inside the domain of every function, one flat record a row.

    Args:
        spec: for layout and inputs.
        derivations: of the functions.
        functions: a generated back end that says which samples are inside the domain.
        items: of a mapped function.
        seed: of the samples.

    Raises:
        ProofError: when no sample of a function lies inside its domain.
    """
    found = {}
    for derivation in derivations:
        samples = draw(spec, derivation, COUNT, seed, items)
        given: dict[str, Any] = dict(samples.typed())
        for name, array in given.items():
            if name != "x" and spec.inputs[name].block.storage_size == 1:
                given[name] = array[..., 0]
        state = [given.pop("x")] if "x" in given else []
        status = getattr(functions, derivation.name)(*state, **given).status
        good = np.flatnonzero(np.asarray(status) == 0)
        if not good.size:
            raise ProofError(
                f"{derivation.name}: no sample inside the declared ranges lies in its domain"
            )
        parts = [array.reshape(samples.count, -1) for array in samples.arguments.values()]
        found[derivation.name] = np.hstack(parts)[good]
    return found
