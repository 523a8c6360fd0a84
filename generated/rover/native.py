"""The functions of ``rover`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "rover", "float64")
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


def _gps_call(x: Any = None, /, *, out: Any = None, **_other: Any) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 22
        ):
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 21))
            else:
                written = out[:2]
                (value, jacobian) = written
                if not (
                    len(out) in (2, 3)
                    and (x.base is None or _apart(x, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and jacobian.dtype is _real
                    and jacobian.shape == (3, 21)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _gps_function.given(out, (x,))
                    (value, jacobian) = written
            if not _gps_entry(
                _pointer(_reals, x), _pointer(_reals, value), _pointer(_reals, jacobian)
            ):
                return _tuple(_interface.GpsResult, (value, jacobian, _OK))
    except _UNFIT:
        pass
    return _gps_function.call((x,), {**_other}, out)


gps = _calls.publish(_gps_function, __name__, _gps_call)


_range_function = _compiled.CompiledFunction(_library, _interface.RANGE)
_range_entry = _library.entry("range")


def _range_call(
    x: Any = None,
    /,
    *,
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
    try:
        if (
            not _other
            and (n := len(system)) <= 32
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 22
            and nav_to_ecef.dtype is _real
            and nav_to_ecef.ndim == 1
            and len(nav_to_ecef) == 4
            and origin.dtype is _real
            and origin.ndim == 1
            and len(origin) == 3
            and system.dtype is _integer
            and system.ndim == 1
            and len(system) == n
            and satellite_position.dtype is _real
            and satellite_position.shape == (n, 3)
            and satellite_clock.dtype is _real
            and satellite_clock.ndim == 1
            and len(satellite_clock) == n
            and troposphere.dtype is _real
            and troposphere.ndim == 1
            and len(troposphere) == n
            and ionosphere.dtype is _real
            and ionosphere.ndim == 1
            and len(ionosphere) == n
            and measured.dtype is _real
            and measured.ndim == 1
            and len(measured) == n
        ):
            if out is None:
                value = _empty(n)
                residual = _empty(n)
                jacobian = _empty((n, 21))
            else:
                written = out[:3]
                (value, residual, jacobian) = written
                if not (
                    len(out) in (3, 5)
                    and (x.base is None or _apart(x, written))
                    and (nav_to_ecef.base is None or _apart(nav_to_ecef, written))
                    and (origin.base is None or _apart(origin, written))
                    and (system.base is None or _apart(system, written))
                    and (satellite_position.base is None or _apart(satellite_position, written))
                    and (satellite_clock.base is None or _apart(satellite_clock, written))
                    and (troposphere.base is None or _apart(troposphere, written))
                    and (ionosphere.base is None or _apart(ionosphere, written))
                    and (measured.base is None or _apart(measured, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == n
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not x
                    and value is not nav_to_ecef
                    and value is not origin
                    and value is not system
                    and value is not satellite_clock
                    and value is not troposphere
                    and value is not ionosphere
                    and value is not measured
                    and residual.dtype is _real
                    and residual.ndim == 1
                    and len(residual) == n
                    and (flags := residual.flags).carray
                    and flags.owndata
                    and residual is not x
                    and residual is not nav_to_ecef
                    and residual is not origin
                    and residual is not system
                    and residual is not satellite_clock
                    and residual is not troposphere
                    and residual is not ionosphere
                    and residual is not measured
                    and residual is not value
                    and jacobian.dtype is _real
                    and jacobian.shape == (n, 21)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _range_function.given(
                        out,
                        (x, nav_to_ecef, origin, system, satellite_position, satellite_clock,
                        troposphere, ionosphere, measured),
                        n,
                    )
                    (value, residual, jacobian) = written
            item_status = _empty(n, _byte)
            if not _range_entry(
                _pointer(_reals, x),
                n,
                _pointer(_reals, nav_to_ecef),
                _pointer(_reals, origin),
                _pointer(_integers, system),
                _pointer(_reals, satellite_position),
                _pointer(_reals, satellite_clock),
                _pointer(_reals, troposphere),
                _pointer(_reals, ionosphere),
                _pointer(_reals, measured),
                _pointer(_reals, value),
                _pointer(_reals, residual),
                _pointer(_reals, jacobian),
                _pointer(_bytes, item_status),
            ):
                return _tuple(_interface.RangeResult, (value, residual, jacobian, _OK, item_status))
    except _UNFIT:
        pass
    return _range_function.call(
        (x,),
        {"nav_to_ecef": nav_to_ecef, "origin": origin, "system": system, "satellite_position":
        satellite_position, "satellite_clock": satellite_clock, "troposphere": troposphere,
        "ionosphere": ionosphere, "measured": measured, **_other},
        out,
    )


range = _calls.publish(_range_function, __name__, _range_call)


_imu_function = _compiled.CompiledFunction(_library, _interface.IMU)
_imu_entry = _library.entry("imu")


def _imu_call(
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
            and len(x) == 22
            and delta_theta.dtype is _real
            and delta_theta.ndim == 1
            and len(delta_theta) == 6
            and delta_velocity.dtype is _real
            and delta_velocity.ndim == 1
            and len(delta_velocity) == 6
            and type(dt) is float
        ):
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 21))
            else:
                written = out[:2]
                (value, jacobian) = written
                if not (
                    len(out) in (2, 3)
                    and (x.base is None or _apart(x, written))
                    and (delta_theta.base is None or _apart(delta_theta, written))
                    and (delta_velocity.base is None or _apart(delta_velocity, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and jacobian.dtype is _real
                    and jacobian.shape == (3, 21)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _imu_function.given(out, (x, delta_theta, delta_velocity))
                    (value, jacobian) = written
            if not _imu_entry(
                _pointer(_reals, x),
                _pointer(_reals, delta_theta),
                _pointer(_reals, delta_velocity),
                _new(_reals, (dt,)),
                _pointer(_reals, value),
                _pointer(_reals, jacobian),
            ):
                return _tuple(_interface.ImuResult, (value, jacobian, _OK))
    except _UNFIT:
        pass
    return _imu_function.call(
        (x,),
        {"delta_theta": delta_theta, "delta_velocity": delta_velocity, "dt": dt, **_other},
        out,
    )


imu = _calls.publish(_imu_function, __name__, _imu_call)
