"""The functions of ``navtk_specific_force`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _calls, _compiled, _extension, _interface

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "navtk_specific_force", "float64")
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


_calc_force_function = _compiled.CompiledFunction(_library, _interface.CALC_FORCE)
_calc_force_straight = _library.call("calc_force", _interface.CalcForceResult)


def _calc_force_call(
    *_more: Any,
    dcm: Any = None,
    delta_theta: Any = None,
    delta_velocity: Any = None,
    dt: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _calc_force_straight(
        dcm, delta_theta, delta_velocity, dt, out
    )
    if _found is not None:
        return _found
    return _calc_force_function.call(
        _more,
        {"dcm": dcm, "delta_theta": delta_theta, "delta_velocity": delta_velocity, "dt": dt,
        **_other},
        out,
    )


calc_force = _calls.publish(_calc_force_function, __name__, _calc_force_call)


_force_function = _compiled.CompiledFunction(_library, _interface.FORCE)
_force_straight = _library.call("force", _interface.ForceResult)


def _force_call(
    x: Any = None,
    /,
    *_more: Any,
    delta_theta: Any = None,
    delta_velocity: Any = None,
    dt: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _force_straight(x, delta_theta, delta_velocity, dt, out)
    if _found is not None:
        return _found
    return _force_function.call(
        (x, *_more),
        {"delta_theta": delta_theta, "delta_velocity": delta_velocity, "dt": dt, **_other},
        out,
    )


force = _calls.publish(_force_function, __name__, _force_call)
