"""The functions of ``farrell_tightly_coupled`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime, _straight

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "farrell_tightly_coupled", "float64")
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
                value = _empty(18)
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
                value = _empty(17)
            else:
                (value,) = _outputs(out, 1, 2)
            given = (_array, x, y, value)
            if not _local_straight(_id(given)):
                return _tuple(_interface.LocalResult, (value, _OK))
    except _UNFIT:
        pass
    return _local_function.call((x,), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_pseudorange_function = _compiled.CompiledFunction(_library, _interface.PSEUDORANGE)
_pseudorange_straight = _library.straight("pseudorange")


def _pseudorange_call(
    x: Any = None,
    /,
    *,
    c_n_e: Any = None,
    origin: Any = None,
    satellite_position: Any = None,
    measured: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if not _other and x.ndim == 1:
            n = len(satellite_position)
            if out is None:
                value = _empty(n)
                residual = _empty(n)
                jacobian = _empty((n, 17))
            else:
                (value, residual, jacobian) = _outputs(out, 3, 5)
            item_status = _empty(n, _byte)
            given = (
                _array, x, c_n_e, origin, satellite_position, measured, value, residual, jacobian,
                item_status,
            )
            if not _pseudorange_straight(_id(given)):
                return _tuple(
                    _interface.PseudorangeResult, (value, residual, jacobian, _OK, item_status)
                )
    except _UNFIT:
        pass
    return _pseudorange_function.call(
        (x,),
        {"c_n_e": c_n_e, "origin": origin, "satellite_position": satellite_position, "measured":
        measured, **_other},
        out,
    )


pseudorange = _calls.publish(_pseudorange_function, __name__, _pseudorange_call)


_pseudorange_lever_arm_function = _compiled.CompiledFunction(
    _library, _interface.PSEUDORANGE_LEVER_ARM
)
_pseudorange_lever_arm_straight = _library.straight("pseudorange_lever_arm")


def _pseudorange_lever_arm_call(
    x: Any = None,
    /,
    *,
    c_n_e: Any = None,
    origin: Any = None,
    lever_arm: Any = None,
    satellite_position: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if not _other and x.ndim == 1:
            n = len(satellite_position)
            if out is None:
                value = _empty(n)
                jacobian = _empty((n, 17))
            else:
                (value, jacobian) = _outputs(out, 2, 4)
            item_status = _empty(n, _byte)
            given = (
                _array, x, c_n_e, origin, lever_arm, satellite_position, value, jacobian,
                item_status,
            )
            if not _pseudorange_lever_arm_straight(_id(given)):
                return _tuple(
                    _interface.PseudorangeLeverArmResult, (value, jacobian, _OK, item_status)
                )
    except _UNFIT:
        pass
    return _pseudorange_lever_arm_function.call(
        (x,),
        {"c_n_e": c_n_e, "origin": origin, "lever_arm": lever_arm, "satellite_position":
        satellite_position, **_other},
        out,
    )


pseudorange_lever_arm = _calls.publish(
    _pseudorange_lever_arm_function, __name__, _pseudorange_lever_arm_call
)
