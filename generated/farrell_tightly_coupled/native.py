"""The functions of ``farrell_tightly_coupled`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _calls, _compiled, _extension, _interface

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "farrell_tightly_coupled", "float64")
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


_pseudorange_function = _compiled.CompiledFunction(_library, _interface.PSEUDORANGE)
_pseudorange_straight = _library.call("pseudorange", _interface.PseudorangeResult)


def _pseudorange_call(
    x: Any = None,
    /,
    *_more: Any,
    c_n_e: Any = None,
    origin: Any = None,
    satellite_position: Any = None,
    measured: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _pseudorange_straight(
        x, c_n_e, origin, satellite_position, measured, out
    )
    if _found is not None:
        return _found
    return _pseudorange_function.call(
        (x, *_more),
        {"c_n_e": c_n_e, "origin": origin, "satellite_position": satellite_position, "measured":
        measured, **_other},
        out,
    )


pseudorange = _calls.publish(_pseudorange_function, __name__, _pseudorange_call)


_pseudorange_lever_arm_function = _compiled.CompiledFunction(
    _library, _interface.PSEUDORANGE_LEVER_ARM
)
_pseudorange_lever_arm_straight = _library.call(
    "pseudorange_lever_arm", _interface.PseudorangeLeverArmResult
)


def _pseudorange_lever_arm_call(
    x: Any = None,
    /,
    *_more: Any,
    c_n_e: Any = None,
    origin: Any = None,
    lever_arm: Any = None,
    satellite_position: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _pseudorange_lever_arm_straight(
        x, c_n_e, origin, lever_arm, satellite_position, out
    )
    if _found is not None:
        return _found
    return _pseudorange_lever_arm_function.call(
        (x, *_more),
        {"c_n_e": c_n_e, "origin": origin, "lever_arm": lever_arm, "satellite_position":
        satellite_position, **_other},
        out,
    )


pseudorange_lever_arm = _calls.publish(
    _pseudorange_lever_arm_function, __name__, _pseudorange_lever_arm_call
)
