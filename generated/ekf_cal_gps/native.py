"""The functions of ``ekf_cal_gps`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _calls, _compiled, _extension, _interface

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "ekf_cal_gps", "float64")
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


def _gps_call(
    x: Any = None, /, *_more: Any, measured: Any = None, out: Any = None, **_other: Any
) -> Any:
    _found = None if _more or _other else _gps_straight(x, measured, out)
    if _found is not None:
        return _found
    return _gps_function.call((x, *_more), {"measured": measured, **_other}, out)


gps = _calls.publish(_gps_function, __name__, _gps_call)


_gps_known_antenna_function = _compiled.CompiledFunction(_library, _interface.GPS_KNOWN_ANTENNA)
_gps_known_antenna_straight = _library.call("gps_known_antenna", _interface.GpsKnownAntennaResult)


def _gps_known_antenna_call(
    x: Any = None,
    /,
    *_more: Any,
    lever_arm: Any = None,
    measured: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _gps_known_antenna_straight(x, lever_arm, measured, out)
    if _found is not None:
        return _found
    return _gps_known_antenna_function.call(
        (x, *_more), {"lever_arm": lever_arm, "measured": measured, **_other}, out
    )


gps_known_antenna = _calls.publish(_gps_known_antenna_function, __name__, _gps_known_antenna_call)


_local_fix_function = _compiled.CompiledFunction(_library, _interface.LOCAL_FIX)
_local_fix_straight = _library.call("local_fix", _interface.LocalFixResult)


def _local_fix_call(
    *_more: Any,
    heading: Any = None,
    fix: Any = None,
    reference: Any = None,
    covariance: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _local_fix_straight(
        heading, fix, reference, covariance, out
    )
    if _found is not None:
        return _found
    return _local_fix_function.call(
        _more,
        {"heading": heading, "fix": fix, "reference": reference, "covariance": covariance,
        **_other},
        out,
    )


local_fix = _calls.publish(_local_fix_function, __name__, _local_fix_call)
