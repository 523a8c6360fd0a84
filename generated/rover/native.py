"""The functions of ``rover`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime, _straight

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "rover", "float64")
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


def _gps_call(x: Any = None, /, *, out: Any = None, **_other: Any) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 21))
            else:
                (value, jacobian) = _outputs(out, 2, 3)
            given = (_array, x, value, jacobian)
            if not _gps_straight(_id(given)):
                return _tuple(_interface.GpsResult, (value, jacobian, _OK))
    except _UNFIT:
        pass
    return _gps_function.call((x,), {**_other}, out)


gps = _calls.publish(_gps_function, __name__, _gps_call)


_range_function = _compiled.CompiledFunction(_library, _interface.RANGE)
_range_straight = _library.straight("range")


def _range_call(
    x: Any = None,
    /,
    *,
    nav_to_ecef: Any = None,
    origin: Any = None,
    system: Any = None,
    satellite_position: Any = None,
    satellite_clock: Any = None,
    troposphere: Any = None,
    ionosphere: Any = None,
    measured: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if not _other and x.ndim == 1:
            n = len(system)
            if out is None:
                value = _empty(n)
                residual = _empty(n)
                jacobian = _empty((n, 21))
            else:
                (value, residual, jacobian) = _outputs(out, 3, 5)
            item_status = _empty(n, _byte)
            given = (
                _array, x, nav_to_ecef, origin, system, satellite_position, satellite_clock,
                troposphere, ionosphere, measured, value, residual, jacobian, item_status,
            )
            if not _range_straight(_id(given)):
                return _tuple(_interface.RangeResult, (value, residual, jacobian, _OK, item_status))
    except _UNFIT:
        pass
    return _range_function.call(
        (x,),
        {"nav_to_ecef": nav_to_ecef, "origin": origin, "system": system, "satellite_position":
        satellite_position, "satellite_clock": satellite_clock, "troposphere": troposphere,
        "ionosphere": ionosphere, "measured": measured, **_other},
        out,
    )


range = _calls.publish(_range_function, __name__, _range_call)


_imu_function = _compiled.CompiledFunction(_library, _interface.IMU)
_imu_straight = _library.straight("imu")


def _imu_call(
    x: Any = None,
    /,
    *,
    delta_theta: Any = None,
    delta_velocity: Any = None,
    dt: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 21))
            else:
                (value, jacobian) = _outputs(out, 2, 3)
            given = (_array, x, delta_theta, delta_velocity, dt, value, jacobian)
            if not _imu_straight(_id(given)):
                return _tuple(_interface.ImuResult, (value, jacobian, _OK))
    except _UNFIT:
        pass
    return _imu_function.call(
        (x,),
        {"delta_theta": delta_theta, "delta_velocity": delta_velocity, "dt": dt, **_other},
        out,
    )


imu = _calls.publish(_imu_function, __name__, _imu_call)
