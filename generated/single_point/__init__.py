"""Measurements and corrections of the navigation state ``single_point``.

``BACKEND`` names the back end behind these functions: ``native``, the compiled C, where it was
built for this interpreter, else ``numpy``. Every back end can be imported on its own as well;
importing ``native`` says what is missing.

``State`` describes the state vector and its error, packs, unpacks, retracts and compares.
"""

from __future__ import annotations

from importlib import import_module as _import
from types import ModuleType as _Module

from . import _interface, _state
from ._interface import (
    BroadcastOrbitResult,
    LocalResult,
    PseudorangeResult,
    PseudorangeWithoutSagnacResult,
    RetractResult,
    StateBlocks,
)
from ._lanes import Blocks
from ._runtime import GuardError, Status

try:
    _backend = _import(".native", __name__)
except ImportError:
    _backend = _import(".numpy", __name__)

BACKEND = _backend.__name__.rpartition(".")[2]

retract = _backend.retract
local = _backend.local
pseudorange = _backend.pseudorange
pseudorange_without_sagnac = _backend.pseudorange_without_sagnac
broadcast_orbit = _backend.broadcast_orbit
State = _state.StateVector(
    _interface._BLOCKS, _interface._DIGEST, StateBlocks, retract.value, local.value
)

__all__ = [
    "BACKEND",
    "Blocks",
    "BroadcastOrbitResult",
    "GuardError",
    "LocalResult",
    "PseudorangeResult",
    "PseudorangeWithoutSagnacResult",
    "RetractResult",
    "State",
    "StateBlocks",
    "Status",
    "broadcast_orbit",
    "local",
    "pseudorange",
    "pseudorange_without_sagnac",
    "retract",
]


def __getattr__(name: str) -> _Module:
    if name in ("casadi", "native", "numpy"):
        return _import(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
