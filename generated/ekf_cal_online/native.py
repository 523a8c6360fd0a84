"""The functions of ``ekf_cal_online`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _calls, _compiled, _extension, _interface

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "ekf_cal_online", "float64")
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


_gps_1_function = _compiled.CompiledFunction(_library, _interface.GPS_1)
_gps_1_straight = _library.call("gps_1", _interface.Gps1Result)


def _gps_1_call(
    x: Any = None,
    /,
    *_more: Any,
    origin: Any = None,
    measured: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _gps_1_straight(x, origin, measured, out)
    if _found is not None:
        return _found
    return _gps_1_function.call(
        (x, *_more), {"origin": origin, "measured": measured, **_other}, out
    )


gps_1 = _calls.publish(_gps_1_function, __name__, _gps_1_call)


_gps_2_function = _compiled.CompiledFunction(_library, _interface.GPS_2)
_gps_2_straight = _library.call("gps_2", _interface.Gps2Result)


def _gps_2_call(
    x: Any = None,
    /,
    *_more: Any,
    origin: Any = None,
    measured: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _gps_2_straight(x, origin, measured, out)
    if _found is not None:
        return _found
    return _gps_2_function.call(
        (x, *_more), {"origin": origin, "measured": measured, **_other}, out
    )


gps_2 = _calls.publish(_gps_2_function, __name__, _gps_2_call)
