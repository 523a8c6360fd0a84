"""The functions of ``rover`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _calls, _compiled, _extension, _interface

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "rover", "float64")
set_threads = _library.set_threads


_retract_function = _compiled.CompiledFunction(_library, _interface.RETRACT)
_retract_straight = _library.call("retract", _interface.RetractResult)


def _retract_call(
    x: Any = None, /, *_more: Any, d: Any = None, out: Any = None, **_other: Any
) -> Any:
    _found = None if _more or _other else _retract_straight(x, d, out)
    if _found is not None:
        return _found
    return _retract_function.call((x, *_more), {"d": d, **_other}, out)


retract = _calls.publish(_retract_function, __name__, _retract_call)


_local_function = _compiled.CompiledFunction(_library, _interface.LOCAL)
_local_straight = _library.call("local", _interface.LocalResult)


def _local_call(
    x: Any = None, /, *_more: Any, y: Any = None, out: Any = None, **_other: Any
) -> Any:
    _found = None if _more or _other else _local_straight(x, y, out)
    if _found is not None:
        return _found
    return _local_function.call((x, *_more), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_gps_function = _compiled.CompiledFunction(_library, _interface.GPS)
_gps_straight = _library.call("gps", _interface.GpsResult)


def _gps_call(x: Any = None, /, *_more: Any, out: Any = None, **_other: Any) -> Any:
    _found = None if _more or _other else _gps_straight(x, out)
    if _found is not None:
        return _found
    return _gps_function.call((x, *_more), {**_other}, out)


gps = _calls.publish(_gps_function, __name__, _gps_call)


_range_function = _compiled.CompiledFunction(_library, _interface.RANGE)
_range_straight = _library.call("range", _interface.RangeResult)


def _range_call(
    x: Any = None,
    /,
    *_more: Any,
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
    _found = None if _more or _other else _range_straight(
        x, nav_to_ecef, origin, system, satellite_position, satellite_clock, troposphere,
        ionosphere, measured, out,
    )
    if _found is not None:
        return _found
    return _range_function.call(
        (x, *_more),
        {"nav_to_ecef": nav_to_ecef, "origin": origin, "system": system, "satellite_position":
        satellite_position, "satellite_clock": satellite_clock, "troposphere": troposphere,
        "ionosphere": ionosphere, "measured": measured, **_other},
        out,
    )


range = _calls.publish(_range_function, __name__, _range_call)


_imu_function = _compiled.CompiledFunction(_library, _interface.IMU)
_imu_straight = _library.call("imu", _interface.ImuResult)


def _imu_call(
    x: Any = None,
    /,
    *_more: Any,
    delta_theta: Any = None,
    delta_velocity: Any = None,
    dt: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _imu_straight(x, delta_theta, delta_velocity, dt, out)
    if _found is not None:
        return _found
    return _imu_function.call(
        (x, *_more),
        {"delta_theta": delta_theta, "delta_velocity": delta_velocity, "dt": dt, **_other},
        out,
    )


imu = _calls.publish(_imu_function, __name__, _imu_call)
