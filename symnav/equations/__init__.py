"""The model library: one file per family of equations.

Adding a model is writing its function and its declaration in one of these files (or in a new one
listed in ``FAMILIES``); everything else reads the declaration.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import import_module

from symnav.equations.model import Model

FAMILIES = ("gnss_position", "pseudorange", "specific_force", "broadcast_orbit")


@cache
def library() -> Mapping[str, Model]:
    """Every model, by name, in the order of the families."""
    modules = [import_module(f"symnav.equations.{family}") for family in FAMILIES]
    return {model.name: model for module in modules for model in module.MODELS}
