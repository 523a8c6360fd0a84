"""Measurements and corrections of the navigation state ``ekf_cal_gps``.

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
    GpsKnownAntennaResult,
    GpsResult,
    LocalFixResult,
    LocalResult,
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
gps = _backend.gps
gps_known_antenna = _backend.gps_known_antenna
local_fix = _backend.local_fix
State = _state.StateVector(
    _interface._BLOCKS, _interface._DIGEST, StateBlocks, retract.value, local.value
)

__all__ = [
    "BACKEND",
    "Blocks",
    "GpsKnownAntennaResult",
    "GpsResult",
    "GuardError",
    "LocalFixResult",
    "LocalResult",
    "RetractResult",
    "State",
    "StateBlocks",
    "Status",
    "gps",
    "gps_known_antenna",
    "local",
    "local_fix",
    "retract",
]


def __getattr__(name: str) -> _Module:
    if name in ("casadi", "native", "numpy"):
        return _import(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
