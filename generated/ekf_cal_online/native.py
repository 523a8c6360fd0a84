"""The functions of ``ekf_cal_online`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "ekf_cal_online", "float64")
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
            and len(x) == 26
            and d.dtype is _real
            and d.ndim == 1
            and len(d) == 25
        ):
            if out is None:
                value = _empty(26)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (d.base is None or _apart(d, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 26
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
            and len(x) == 26
            and y.dtype is _real
            and y.ndim == 1
            and len(y) == 26
        ):
            if out is None:
                value = _empty(25)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (y.base is None or _apart(y, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 25
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


_gps_1_function = _compiled.CompiledFunction(_library, _interface.GPS_1)
_gps_1_entry = _library.entry("gps_1")


def _gps_1_call(
    x: Any = None, /, *, origin: Any = None, measured: Any = None, out: Any = None, **_other: Any
) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 26
            and origin.dtype is _real
            and origin.ndim == 1
            and len(origin) == 3
            and measured.dtype is _real
            and measured.ndim == 1
            and len(measured) == 3
        ):
            if out is None:
                value = _empty(3)
                residual = _empty(3)
                jacobian = _empty((3, 25))
                jacobian_origin = _empty((3, 3))
            else:
                written = out[:4]
                (value, residual, jacobian, jacobian_origin) = written
                if not (
                    len(out) in (4, 5)
                    and (x.base is None or _apart(x, written))
                    and (origin.base is None or _apart(origin, written))
                    and (measured.base is None or _apart(measured, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not origin
                    and value is not measured
                    and residual.dtype is _real
                    and residual.ndim == 1
                    and len(residual) == 3
                    and (flags := residual.flags).carray
                    and flags.owndata
                    and residual is not origin
                    and residual is not measured
                    and residual is not value
                    and jacobian.dtype is _real
                    and jacobian.shape == (3, 25)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                    and jacobian_origin.dtype is _real
                    and jacobian_origin.shape == (3, 3)
                    and (flags := jacobian_origin.flags).carray
                    and flags.owndata
                ):
                    written = _gps_1_function.given(out, (x, origin, measured))
                    (value, residual, jacobian, jacobian_origin) = written
            if not _gps_1_entry(
                _pointer(_reals, x),
                _pointer(_reals, origin),
                _pointer(_reals, measured),
                _pointer(_reals, value),
                _pointer(_reals, residual),
                _pointer(_reals, jacobian),
                _pointer(_reals, jacobian_origin),
            ):
                return _tuple(
                    _interface.Gps1Result, (value, residual, jacobian, jacobian_origin, _OK)
                )
    except _UNFIT:
        pass
    return _gps_1_function.call((x,), {"origin": origin, "measured": measured, **_other}, out)


gps_1 = _calls.publish(_gps_1_function, __name__, _gps_1_call)


_gps_2_function = _compiled.CompiledFunction(_library, _interface.GPS_2)
_gps_2_entry = _library.entry("gps_2")


def _gps_2_call(
    x: Any = None, /, *, origin: Any = None, measured: Any = None, out: Any = None, **_other: Any
) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 26
            and origin.dtype is _real
            and origin.ndim == 1
            and len(origin) == 3
            and measured.dtype is _real
            and measured.ndim == 1
            and len(measured) == 3
        ):
            if out is None:
                value = _empty(3)
                residual = _empty(3)
                jacobian = _empty((3, 25))
                jacobian_origin = _empty((3, 3))
            else:
                written = out[:4]
                (value, residual, jacobian, jacobian_origin) = written
                if not (
                    len(out) in (4, 5)
                    and (x.base is None or _apart(x, written))
                    and (origin.base is None or _apart(origin, written))
                    and (measured.base is None or _apart(measured, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not origin
                    and value is not measured
                    and residual.dtype is _real
                    and residual.ndim == 1
                    and len(residual) == 3
                    and (flags := residual.flags).carray
                    and flags.owndata
                    and residual is not origin
                    and residual is not measured
                    and residual is not value
                    and jacobian.dtype is _real
                    and jacobian.shape == (3, 25)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                    and jacobian_origin.dtype is _real
                    and jacobian_origin.shape == (3, 3)
                    and (flags := jacobian_origin.flags).carray
                    and flags.owndata
                ):
                    written = _gps_2_function.given(out, (x, origin, measured))
                    (value, residual, jacobian, jacobian_origin) = written
            if not _gps_2_entry(
                _pointer(_reals, x),
                _pointer(_reals, origin),
                _pointer(_reals, measured),
                _pointer(_reals, value),
                _pointer(_reals, residual),
                _pointer(_reals, jacobian),
                _pointer(_reals, jacobian_origin),
            ):
                return _tuple(
                    _interface.Gps2Result, (value, residual, jacobian, jacobian_origin, _OK)
                )
    except _UNFIT:
        pass
    return _gps_2_function.call((x,), {"origin": origin, "measured": measured, **_other}, out)


gps_2 = _calls.publish(_gps_2_function, __name__, _gps_2_call)
