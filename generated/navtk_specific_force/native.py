"""The functions of ``navtk_specific_force`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime, _straight

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "navtk_specific_force", "float64")
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
                value = _empty(16)
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
                value = _empty(15)
            else:
                (value,) = _outputs(out, 1, 2)
            given = (_array, x, y, value)
            if not _local_straight(_id(given)):
                return _tuple(_interface.LocalResult, (value, _OK))
    except _UNFIT:
        pass
    return _local_function.call((x,), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_calc_force_function = _compiled.CompiledFunction(_library, _interface.CALC_FORCE)
_calc_force_straight = _library.straight("calc_force")


def _calc_force_call(
    *,
    dcm: Any = None,
    delta_theta: Any = None,
    delta_velocity: Any = None,
    dt: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if not _other and dcm.ndim == 1:
            if out is None:
                value = _empty(3)
                jacobian_dcm = _empty((3, 3))
                jacobian_delta_theta = _empty((3, 3))
                jacobian_delta_velocity = _empty((3, 3))
                jacobian_dt = _empty((3, 1))
            else:
                (value, jacobian_dcm, jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt) = _outputs(
                    out, 5, 6
                )
            given = (
                _array, dcm, delta_theta, delta_velocity, dt, value, jacobian_dcm,
                jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt,
            )
            if not _calc_force_straight(_id(given)):
                return _tuple(
                    _interface.CalcForceResult,
                    (
                        value,
                        jacobian_dcm,
                        jacobian_delta_theta,
                        jacobian_delta_velocity,
                        jacobian_dt,
                        _OK,
                    ),
                )
    except _UNFIT:
        pass
    return _calc_force_function.call(
        (),
        {"dcm": dcm, "delta_theta": delta_theta, "delta_velocity": delta_velocity, "dt": dt,
        **_other},
        out,
    )


calc_force = _calls.publish(_calc_force_function, __name__, _calc_force_call)


_force_function = _compiled.CompiledFunction(_library, _interface.FORCE)
_force_straight = _library.straight("force")


def _force_call(
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
                jacobian = _empty((3, 15))
                jacobian_delta_theta = _empty((3, 3))
                jacobian_delta_velocity = _empty((3, 3))
                jacobian_dt = _empty((3, 1))
            else:
                (value, jacobian, jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt) = _outputs(
                    out, 5, 6
                )
            given = (
                _array, x, delta_theta, delta_velocity, dt, value, jacobian, jacobian_delta_theta,
                jacobian_delta_velocity, jacobian_dt,
            )
            if not _force_straight(_id(given)):
                return _tuple(
                    _interface.ForceResult,
                    (
                        value,
                        jacobian,
                        jacobian_delta_theta,
                        jacobian_delta_velocity,
                        jacobian_dt,
                        _OK,
                    ),
                )
    except _UNFIT:
        pass
    return _force_function.call(
        (x,),
        {"delta_theta": delta_theta, "delta_velocity": delta_velocity, "dt": dt, **_other},
        out,
    )


force = _calls.publish(_force_function, __name__, _force_call)
