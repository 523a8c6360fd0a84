"""The functions of ``ekf_cal_gps`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime, _straight

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "ekf_cal_gps", "float64")
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
                value = _empty(22)
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
                value = _empty(21)
            else:
                (value,) = _outputs(out, 1, 2)
            given = (_array, x, y, value)
            if not _local_straight(_id(given)):
                return _tuple(_interface.LocalResult, (value, _OK))
    except _UNFIT:
        pass
    return _local_function.call((x,), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_gps_function = _compiled.CompiledFunction(_library, _interface.GPS)
_gps_straight = _library.straight("gps")


def _gps_call(x: Any = None, /, *, measured: Any = None, out: Any = None, **_other: Any) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(3)
                residual = _empty(3)
                jacobian = _empty((3, 21))
            else:
                (value, residual, jacobian) = _outputs(out, 3, 4)
            given = (_array, x, measured, value, residual, jacobian)
            if not _gps_straight(_id(given)):
                return _tuple(_interface.GpsResult, (value, residual, jacobian, _OK))
    except _UNFIT:
        pass
    return _gps_function.call((x,), {"measured": measured, **_other}, out)


gps = _calls.publish(_gps_function, __name__, _gps_call)


_gps_known_antenna_function = _compiled.CompiledFunction(_library, _interface.GPS_KNOWN_ANTENNA)
_gps_known_antenna_straight = _library.straight("gps_known_antenna")


def _gps_known_antenna_call(
    x: Any = None, /, *, lever_arm: Any = None, measured: Any = None, out: Any = None, **_other: Any
) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(3)
                residual = _empty(3)
                jacobian = _empty((3, 21))
            else:
                (value, residual, jacobian) = _outputs(out, 3, 4)
            given = (_array, x, lever_arm, measured, value, residual, jacobian)
            if not _gps_known_antenna_straight(_id(given)):
                return _tuple(_interface.GpsKnownAntennaResult, (value, residual, jacobian, _OK))
    except _UNFIT:
        pass
    return _gps_known_antenna_function.call(
        (x,), {"lever_arm": lever_arm, "measured": measured, **_other}, out
    )


gps_known_antenna = _calls.publish(_gps_known_antenna_function, __name__, _gps_known_antenna_call)


_local_fix_function = _compiled.CompiledFunction(_library, _interface.LOCAL_FIX)
_local_fix_straight = _library.straight("local_fix")


def _local_fix_call(
    *,
    heading: Any = None,
    fix: Any = None,
    reference: Any = None,
    covariance: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if not _other and fix.ndim == 1:
            if out is None:
                value = _empty(3)
                jacobian_fix = _empty((3, 3))
                value_covariance = _empty(9)
            else:
                (value, jacobian_fix, value_covariance) = _outputs(out, 3, 4)
            given = (
                _array, heading, fix, reference, covariance, value, jacobian_fix, value_covariance
            )
            if not _local_fix_straight(_id(given)):
                return _tuple(
                    _interface.LocalFixResult, (value, jacobian_fix, value_covariance, _OK)
                )
    except _UNFIT:
        pass
    return _local_fix_function.call(
        (),
        {"heading": heading, "fix": fix, "reference": reference, "covariance": covariance,
        **_other},
        out,
    )


local_fix = _calls.publish(_local_fix_function, __name__, _local_fix_call)
