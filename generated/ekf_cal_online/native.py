"""The functions of ``ekf_cal_online`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime, _straight

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "ekf_cal_online", "float64")
set_threads = _library.set_threads
_outputs = _straight.outputs
_empty, _tuple, _id, _array = _np.empty, tuple.__new__, id, _np.ndarray
_real, _byte = _library.real, _np.dtype(_np.uint8)
_OK = _runtime.Status.OK
_UNFIT = (AttributeError, LookupError, MemoryError, TypeError, ValueError)


_retract_function = _compiled.CompiledFunction(_library, _interface.RETRACT)
_retract_straight = _library.straight("retract")


def _retract_call(x: Any = None, /, *, d: Any = None, out: Any = None, **_other: Any) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(26)
            else:
                (value,) = _outputs(out, 1, 2)
            given = (_array, x, d, value)
            if not _retract_straight(_id(given)):
                return _tuple(_interface.RetractResult, (value, _OK))
    except _UNFIT:
        pass
    return _retract_function.call((x,), {"d": d, **_other}, out)


retract = _calls.publish(_retract_function, __name__, _retract_call)


_local_function = _compiled.CompiledFunction(_library, _interface.LOCAL)
_local_straight = _library.straight("local")


def _local_call(x: Any = None, /, *, y: Any = None, out: Any = None, **_other: Any) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(25)
            else:
                (value,) = _outputs(out, 1, 2)
            given = (_array, x, y, value)
            if not _local_straight(_id(given)):
                return _tuple(_interface.LocalResult, (value, _OK))
    except _UNFIT:
        pass
    return _local_function.call((x,), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_gps_1_function = _compiled.CompiledFunction(_library, _interface.GPS_1)
_gps_1_straight = _library.straight("gps_1")


def _gps_1_call(
    x: Any = None, /, *, origin: Any = None, measured: Any = None, out: Any = None, **_other: Any
) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(3)
                residual = _empty(3)
                jacobian = _empty((3, 25))
                jacobian_origin = _empty((3, 3))
            else:
                (value, residual, jacobian, jacobian_origin) = _outputs(out, 4, 5)
            given = (_array, x, origin, measured, value, residual, jacobian, jacobian_origin)
            if not _gps_1_straight(_id(given)):
                return _tuple(
                    _interface.Gps1Result, (value, residual, jacobian, jacobian_origin, _OK)
                )
    except _UNFIT:
        pass
    return _gps_1_function.call((x,), {"origin": origin, "measured": measured, **_other}, out)


gps_1 = _calls.publish(_gps_1_function, __name__, _gps_1_call)


_gps_2_function = _compiled.CompiledFunction(_library, _interface.GPS_2)
_gps_2_straight = _library.straight("gps_2")


def _gps_2_call(
    x: Any = None, /, *, origin: Any = None, measured: Any = None, out: Any = None, **_other: Any
) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(3)
                residual = _empty(3)
                jacobian = _empty((3, 25))
                jacobian_origin = _empty((3, 3))
            else:
                (value, residual, jacobian, jacobian_origin) = _outputs(out, 4, 5)
            given = (_array, x, origin, measured, value, residual, jacobian, jacobian_origin)
            if not _gps_2_straight(_id(given)):
                return _tuple(
                    _interface.Gps2Result, (value, residual, jacobian, jacobian_origin, _OK)
                )
    except _UNFIT:
        pass
    return _gps_2_function.call((x,), {"origin": origin, "measured": measured, **_other}, out)


gps_2 = _calls.publish(_gps_2_function, __name__, _gps_2_call)
