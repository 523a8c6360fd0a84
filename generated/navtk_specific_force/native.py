"""The functions of ``navtk_specific_force`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "navtk_specific_force", "float64")
set_threads = _library.set_threads
_new = _library.ffi.new
_pointer = _library.ffi.from_buffer
_reals, _integers, _bytes = _library.reals, _library.integers, _library.bytes
_apart = _compiled.apart
_empty, _tuple = _np.empty, tuple.__new__
_real, _integer, _byte = _library.real, _np.dtype(_np.int32), _np.dtype(_np.uint8)
_OK = _runtime.Status.OK
_UNFIT = (AttributeError, BufferError, OverflowError, TypeError, ValueError)


_retract_function = _compiled.CompiledFunction(_library, _interface.RETRACT)
_retract_entry = _library.entry("retract")


def _retract_call(x: Any = None, /, *, d: Any = None, out: Any = None, **_other: Any) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 16
            and d.dtype is _real
            and d.ndim == 1
            and len(d) == 15
        ):
            if out is None:
                value = _empty(16)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (d.base is None or _apart(d, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 16
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not x
                ):
                    written = _retract_function.given(out, (x, d))
                    (value,) = written
            if not _retract_entry(
                _pointer(_reals, x), _pointer(_reals, d), _pointer(_reals, value)
            ):
                return _tuple(_interface.RetractResult, (value, _OK))
    except _UNFIT:
        pass
    return _retract_function.call((x,), {"d": d, **_other}, out)


retract = _calls.publish(_retract_function, __name__, _retract_call)


_local_function = _compiled.CompiledFunction(_library, _interface.LOCAL)
_local_entry = _library.entry("local")


def _local_call(x: Any = None, /, *, y: Any = None, out: Any = None, **_other: Any) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 16
            and y.dtype is _real
            and y.ndim == 1
            and len(y) == 16
        ):
            if out is None:
                value = _empty(15)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (y.base is None or _apart(y, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 15
                    and (flags := value.flags).carray
                    and flags.owndata
                ):
                    written = _local_function.given(out, (x, y))
                    (value,) = written
            if not _local_entry(_pointer(_reals, x), _pointer(_reals, y), _pointer(_reals, value)):
                return _tuple(_interface.LocalResult, (value, _OK))
    except _UNFIT:
        pass
    return _local_function.call((x,), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_calc_force_function = _compiled.CompiledFunction(_library, _interface.CALC_FORCE)
_calc_force_entry = _library.entry("calc_force")


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
        if (
            not _other
            and dcm.dtype is _real
            and dcm.ndim == 1
            and len(dcm) == 9
            and delta_theta.dtype is _real
            and delta_theta.ndim == 1
            and len(delta_theta) == 3
            and delta_velocity.dtype is _real
            and delta_velocity.ndim == 1
            and len(delta_velocity) == 3
            and type(dt) is float
        ):
            if out is None:
                value = _empty(3)
                jacobian_dcm = _empty((3, 3))
                jacobian_delta_theta = _empty((3, 3))
                jacobian_delta_velocity = _empty((3, 3))
                jacobian_dt = _empty((3, 1))
            else:
                written = out[:5]
                (
                    value, jacobian_dcm, jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt
                ) = written
                if not (
                    len(out) in (5, 6)
                    and (dcm.base is None or _apart(dcm, written))
                    and (delta_theta.base is None or _apart(delta_theta, written))
                    and (delta_velocity.base is None or _apart(delta_velocity, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not delta_theta
                    and value is not delta_velocity
                    and jacobian_dcm.dtype is _real
                    and jacobian_dcm.shape == (3, 3)
                    and (flags := jacobian_dcm.flags).carray
                    and flags.owndata
                    and jacobian_delta_theta.dtype is _real
                    and jacobian_delta_theta.shape == (3, 3)
                    and (flags := jacobian_delta_theta.flags).carray
                    and flags.owndata
                    and jacobian_delta_theta is not jacobian_dcm
                    and jacobian_delta_velocity.dtype is _real
                    and jacobian_delta_velocity.shape == (3, 3)
                    and (flags := jacobian_delta_velocity.flags).carray
                    and flags.owndata
                    and jacobian_delta_velocity is not jacobian_dcm
                    and jacobian_delta_velocity is not jacobian_delta_theta
                    and jacobian_dt.dtype is _real
                    and jacobian_dt.shape == (3, 1)
                    and (flags := jacobian_dt.flags).carray
                    and flags.owndata
                ):
                    written = _calc_force_function.given(out, (dcm, delta_theta, delta_velocity))
                    (
                        value,
                        jacobian_dcm,
                        jacobian_delta_theta,
                        jacobian_delta_velocity,
                        jacobian_dt,
                    ) = written
            if not _calc_force_entry(
                _pointer(_reals, dcm),
                _pointer(_reals, delta_theta),
                _pointer(_reals, delta_velocity),
                _new(_reals, (dt,)),
                _pointer(_reals, value),
                _pointer(_reals, jacobian_dcm),
                _pointer(_reals, jacobian_delta_theta),
                _pointer(_reals, jacobian_delta_velocity),
                _pointer(_reals, jacobian_dt),
            ):
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
_force_entry = _library.entry("force")


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
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 16
            and delta_theta.dtype is _real
            and delta_theta.ndim == 1
            and len(delta_theta) == 3
            and delta_velocity.dtype is _real
            and delta_velocity.ndim == 1
            and len(delta_velocity) == 3
            and type(dt) is float
        ):
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 15))
                jacobian_delta_theta = _empty((3, 3))
                jacobian_delta_velocity = _empty((3, 3))
                jacobian_dt = _empty((3, 1))
            else:
                written = out[:5]
                (
                    value, jacobian, jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt
                ) = written
                if not (
                    len(out) in (5, 6)
                    and (x.base is None or _apart(x, written))
                    and (delta_theta.base is None or _apart(delta_theta, written))
                    and (delta_velocity.base is None or _apart(delta_velocity, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not delta_theta
                    and value is not delta_velocity
                    and jacobian.dtype is _real
                    and jacobian.shape == (3, 15)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                    and jacobian_delta_theta.dtype is _real
                    and jacobian_delta_theta.shape == (3, 3)
                    and (flags := jacobian_delta_theta.flags).carray
                    and flags.owndata
                    and jacobian_delta_velocity.dtype is _real
                    and jacobian_delta_velocity.shape == (3, 3)
                    and (flags := jacobian_delta_velocity.flags).carray
                    and flags.owndata
                    and jacobian_delta_velocity is not jacobian_delta_theta
                    and jacobian_dt.dtype is _real
                    and jacobian_dt.shape == (3, 1)
                    and (flags := jacobian_dt.flags).carray
                    and flags.owndata
                ):
                    written = _force_function.given(out, (x, delta_theta, delta_velocity))
                    (
                        value, jacobian, jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt
                    ) = written
            if not _force_entry(
                _pointer(_reals, x),
                _pointer(_reals, delta_theta),
                _pointer(_reals, delta_velocity),
                _new(_reals, (dt,)),
                _pointer(_reals, value),
                _pointer(_reals, jacobian),
                _pointer(_reals, jacobian_delta_theta),
                _pointer(_reals, jacobian_delta_velocity),
                _pointer(_reals, jacobian_dt),
            ):
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
