"""The functions of ``ekf_cal_gps`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "ekf_cal_gps", "float64")
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
            and len(x) == 22
            and d.dtype is _real
            and d.ndim == 1
            and len(d) == 21
        ):
            if out is None:
                value = _empty(22)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (d.base is None or _apart(d, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 22
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
            and len(x) == 22
            and y.dtype is _real
            and y.ndim == 1
            and len(y) == 22
        ):
            if out is None:
                value = _empty(21)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (y.base is None or _apart(y, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 21
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


_gps_function = _compiled.CompiledFunction(_library, _interface.GPS)
_gps_entry = _library.entry("gps")


def _gps_call(x: Any = None, /, *, measured: Any = None, out: Any = None, **_other: Any) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 22
            and measured.dtype is _real
            and measured.ndim == 1
            and len(measured) == 3
        ):
            if out is None:
                value = _empty(3)
                residual = _empty(3)
                jacobian = _empty((3, 21))
            else:
                written = out[:3]
                (value, residual, jacobian) = written
                if not (
                    len(out) in (3, 4)
                    and (x.base is None or _apart(x, written))
                    and (measured.base is None or _apart(measured, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not measured
                    and residual.dtype is _real
                    and residual.ndim == 1
                    and len(residual) == 3
                    and (flags := residual.flags).carray
                    and flags.owndata
                    and residual is not measured
                    and residual is not value
                    and jacobian.dtype is _real
                    and jacobian.shape == (3, 21)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _gps_function.given(out, (x, measured))
                    (value, residual, jacobian) = written
            if not _gps_entry(
                _pointer(_reals, x),
                _pointer(_reals, measured),
                _pointer(_reals, value),
                _pointer(_reals, residual),
                _pointer(_reals, jacobian),
            ):
                return _tuple(_interface.GpsResult, (value, residual, jacobian, _OK))
    except _UNFIT:
        pass
    return _gps_function.call((x,), {"measured": measured, **_other}, out)


gps = _calls.publish(_gps_function, __name__, _gps_call)


_gps_known_antenna_function = _compiled.CompiledFunction(_library, _interface.GPS_KNOWN_ANTENNA)
_gps_known_antenna_entry = _library.entry("gps_known_antenna")


def _gps_known_antenna_call(
    x: Any = None, /, *, lever_arm: Any = None, measured: Any = None, out: Any = None, **_other: Any
) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 22
            and lever_arm.dtype is _real
            and lever_arm.ndim == 1
            and len(lever_arm) == 3
            and measured.dtype is _real
            and measured.ndim == 1
            and len(measured) == 3
        ):
            if out is None:
                value = _empty(3)
                residual = _empty(3)
                jacobian = _empty((3, 21))
            else:
                written = out[:3]
                (value, residual, jacobian) = written
                if not (
                    len(out) in (3, 4)
                    and (x.base is None or _apart(x, written))
                    and (lever_arm.base is None or _apart(lever_arm, written))
                    and (measured.base is None or _apart(measured, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not lever_arm
                    and value is not measured
                    and residual.dtype is _real
                    and residual.ndim == 1
                    and len(residual) == 3
                    and (flags := residual.flags).carray
                    and flags.owndata
                    and residual is not lever_arm
                    and residual is not measured
                    and residual is not value
                    and jacobian.dtype is _real
                    and jacobian.shape == (3, 21)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _gps_known_antenna_function.given(out, (x, lever_arm, measured))
                    (value, residual, jacobian) = written
            if not _gps_known_antenna_entry(
                _pointer(_reals, x),
                _pointer(_reals, lever_arm),
                _pointer(_reals, measured),
                _pointer(_reals, value),
                _pointer(_reals, residual),
                _pointer(_reals, jacobian),
            ):
                return _tuple(_interface.GpsKnownAntennaResult, (value, residual, jacobian, _OK))
    except _UNFIT:
        pass
    return _gps_known_antenna_function.call(
        (x,), {"lever_arm": lever_arm, "measured": measured, **_other}, out
    )


gps_known_antenna = _calls.publish(_gps_known_antenna_function, __name__, _gps_known_antenna_call)


_local_fix_function = _compiled.CompiledFunction(_library, _interface.LOCAL_FIX)
_local_fix_entry = _library.entry("local_fix")


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
        if (
            not _other
            and type(heading) is float
            and fix.dtype is _real
            and fix.ndim == 1
            and len(fix) == 3
            and reference.dtype is _real
            and reference.ndim == 1
            and len(reference) == 3
            and covariance.dtype is _real
            and covariance.ndim == 1
            and len(covariance) == 9
        ):
            if out is None:
                value = _empty(3)
                jacobian_fix = _empty((3, 3))
                value_covariance = _empty(9)
            else:
                written = out[:3]
                (value, jacobian_fix, value_covariance) = written
                if not (
                    len(out) in (3, 4)
                    and (fix.base is None or _apart(fix, written))
                    and (reference.base is None or _apart(reference, written))
                    and (covariance.base is None or _apart(covariance, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not fix
                    and value is not reference
                    and jacobian_fix.dtype is _real
                    and jacobian_fix.shape == (3, 3)
                    and (flags := jacobian_fix.flags).carray
                    and flags.owndata
                    and value_covariance.dtype is _real
                    and value_covariance.ndim == 1
                    and len(value_covariance) == 9
                    and (flags := value_covariance.flags).carray
                    and flags.owndata
                    and value_covariance is not covariance
                ):
                    written = _local_fix_function.given(out, (fix, reference, covariance))
                    (value, jacobian_fix, value_covariance) = written
            if not _local_fix_entry(
                _new(_reals, (heading,)),
                _pointer(_reals, fix),
                _pointer(_reals, reference),
                _pointer(_reals, covariance),
                _pointer(_reals, value),
                _pointer(_reals, jacobian_fix),
                _pointer(_reals, value_covariance),
            ):
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
