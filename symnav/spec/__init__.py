"""Specifications: TOML or Python to validated, frozen records.

``load`` and ``loads`` read TOML, ``build`` composes the same from Python (``symnav.spec.builder``),
``json_schema`` describes the format for editors. The records are what every later stage reads;
importing them alone imports no validation library.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from symnav.spec import records
from symnav.spec.records import Spec

if TYPE_CHECKING:
    from symnav.spec.builder import build
    from symnav.spec.loading import from_table, load, loads
    from symnav.spec.schema import json_schema

_LAZY = {
    "build": "builder",
    "from_table": "loading",
    "load": "loading",
    "loads": "loading",
    "json_schema": "schema",
}


def __getattr__(name: str) -> Any:
    """Import the validation when it is first asked for."""
    if name not in _LAZY:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_LAZY[name]}"), name)


__all__ = ["Spec", "build", "from_table", "json_schema", "load", "loads", "records"]
