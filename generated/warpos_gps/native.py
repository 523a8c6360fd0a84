"""The functions of ``warpos_gps`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "warpos_gps", "float64")
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
            and len(x) == 15
            and d.dtype is _real
            and d.ndim == 1
            and len(d) == 15
        ):
            if out is None:
                value = _empty(15)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (d.base is None or _apart(d, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 15
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not x
                    and value is not d
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
            and len(x) == 15
            and y.dtype is _real
            and y.ndim == 1
            and len(y) == 15
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
                    and value is not x
                    and value is not y
                ):
                    written = _local_function.given(out, (x, y))
                    (value,) = written
            if not _local_entry(_pointer(_reals, x), _pointer(_reals, y), _pointer(_reals, value)):
                return _tuple(_interface.LocalResult, (value, _OK))
    except _UNFIT:
        pass
    return _local_function.call((x,), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_measurement_function = _compiled.CompiledFunction(_library, _interface.MEASUREMENT)
_measurement_entry = _library.entry("measurement")


def _measurement_call(x: Any = None, /, *, out: Any = None, **_other: Any) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 15
        ):
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 15))
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
                    and jacobian.shape == (3, 15)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _measurement_function.given(out, (x,))
                    (value, jacobian) = written
            if not _measurement_entry(
                _pointer(_reals, x), _pointer(_reals, value), _pointer(_reals, jacobian)
            ):
                return _tuple(_interface.MeasurementResult, (value, jacobian, _OK))
    except _UNFIT:
        pass
    return _measurement_function.call((x,), {**_other}, out)


measurement = _calls.publish(_measurement_function, __name__, _measurement_call)


_measurement_by_column_function = _compiled.CompiledFunction(
    _library, _interface.MEASUREMENT_BY_COLUMN
)
measurement_by_column = _calls.publish(_measurement_by_column_function, __name__)


_observed_function = _compiled.CompiledFunction(_library, _interface.OBSERVED)
_observed_entry = _library.entry("observed")


def _observed_call(
    x: Any = None, /, *, observer_attitude: Any = None, out: Any = None, **_other: Any
) -> Any:
    try:
        if (
            not _other
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 15
            and observer_attitude.dtype is _real
            and observer_attitude.ndim == 1
            and len(observer_attitude) == 4
        ):
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 15))
            else:
                written = out[:2]
                (value, jacobian) = written
                if not (
                    len(out) in (2, 3)
                    and (x.base is None or _apart(x, written))
                    and (observer_attitude.base is None or _apart(observer_attitude, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and jacobian.dtype is _real
                    and jacobian.shape == (3, 15)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _observed_function.given(out, (x, observer_attitude))
                    (value, jacobian) = written
            if not _observed_entry(
                _pointer(_reals, x),
                _pointer(_reals, observer_attitude),
                _pointer(_reals, value),
                _pointer(_reals, jacobian),
            ):
                return _tuple(_interface.ObservedResult, (value, jacobian, _OK))
    except _UNFIT:
        pass
    return _observed_function.call((x,), {"observer_attitude": observer_attitude, **_other}, out)


observed = _calls.publish(_observed_function, __name__, _observed_call)


_observed_by_column_function = _compiled.CompiledFunction(_library, _interface.OBSERVED_BY_COLUMN)
observed_by_column = _calls.publish(_observed_by_column_function, __name__)


_to_state_frame_function = _compiled.CompiledFunction(_library, _interface.TO_STATE_FRAME)
_to_state_frame_entry = _library.entry("to_state_frame")


def _to_state_frame_call(
    *,
    observer_attitude: Any = None,
    receiver_position: Any = None,
    origin_offset: Any = None,
    attitude: Any = None,
    lever_arm: Any = None,
    covariance: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if (
            not _other
            and observer_attitude.dtype is _real
            and observer_attitude.ndim == 1
            and len(observer_attitude) == 4
            and receiver_position.dtype is _real
            and receiver_position.ndim == 1
            and len(receiver_position) == 3
            and origin_offset.dtype is _real
            and origin_offset.ndim == 1
            and len(origin_offset) == 3
            and attitude.dtype is _real
            and attitude.ndim == 1
            and len(attitude) == 4
            and lever_arm.dtype is _real
            and lever_arm.ndim == 1
            and len(lever_arm) == 3
            and covariance.dtype is _real
            and covariance.ndim == 1
            and len(covariance) == 9
        ):
            if out is None:
                value = _empty(3)
                value_covariance = _empty(9)
            else:
                written = out[:2]
                (value, value_covariance) = written
                if not (
                    len(out) in (2, 3)
                    and (observer_attitude.base is None or _apart(observer_attitude, written))
                    and (receiver_position.base is None or _apart(receiver_position, written))
                    and (origin_offset.base is None or _apart(origin_offset, written))
                    and (attitude.base is None or _apart(attitude, written))
                    and (lever_arm.base is None or _apart(lever_arm, written))
                    and (covariance.base is None or _apart(covariance, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 3
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not receiver_position
                    and value is not origin_offset
                    and value is not lever_arm
                    and value_covariance.dtype is _real
                    and value_covariance.ndim == 1
                    and len(value_covariance) == 9
                    and (flags := value_covariance.flags).carray
                    and flags.owndata
                    and value_covariance is not covariance
                ):
                    written = _to_state_frame_function.given(
                        out,
                        (observer_attitude, receiver_position, origin_offset, attitude, lever_arm,
                        covariance),
                    )
                    (value, value_covariance) = written
            if not _to_state_frame_entry(
                _pointer(_reals, observer_attitude),
                _pointer(_reals, receiver_position),
                _pointer(_reals, origin_offset),
                _pointer(_reals, attitude),
                _pointer(_reals, lever_arm),
                _pointer(_reals, covariance),
                _pointer(_reals, value),
                _pointer(_reals, value_covariance),
            ):
                return _tuple(_interface.ToStateFrameResult, (value, value_covariance, _OK))
    except _UNFIT:
        pass
    return _to_state_frame_function.call(
        (),
        {"observer_attitude": observer_attitude, "receiver_position": receiver_position,
        "origin_offset": origin_offset, "attitude": attitude, "lever_arm": lever_arm, "covariance":
        covariance, **_other},
        out,
    )


to_state_frame = _calls.publish(_to_state_frame_function, __name__, _to_state_frame_call)
