"""The functions of ``warpos_gps`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime, _straight

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "warpos_gps", "float64")
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
                value = _empty(15)
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


_measurement_function = _compiled.CompiledFunction(_library, _interface.MEASUREMENT)
_measurement_straight = _library.straight("measurement")


def _measurement_call(x: Any = None, /, *, out: Any = None, **_other: Any) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 15))
            else:
                (value, jacobian) = _outputs(out, 2, 3)
            given = (_array, x, value, jacobian)
            if not _measurement_straight(_id(given)):
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
_observed_straight = _library.straight("observed")


def _observed_call(
    x: Any = None, /, *, observer_attitude: Any = None, out: Any = None, **_other: Any
) -> Any:
    try:
        if not _other and x.ndim == 1:
            if out is None:
                value = _empty(3)
                jacobian = _empty((3, 15))
            else:
                (value, jacobian) = _outputs(out, 2, 3)
            given = (_array, x, observer_attitude, value, jacobian)
            if not _observed_straight(_id(given)):
                return _tuple(_interface.ObservedResult, (value, jacobian, _OK))
    except _UNFIT:
        pass
    return _observed_function.call((x,), {"observer_attitude": observer_attitude, **_other}, out)


observed = _calls.publish(_observed_function, __name__, _observed_call)


_observed_by_column_function = _compiled.CompiledFunction(_library, _interface.OBSERVED_BY_COLUMN)
observed_by_column = _calls.publish(_observed_by_column_function, __name__)


_to_state_frame_function = _compiled.CompiledFunction(_library, _interface.TO_STATE_FRAME)
_to_state_frame_straight = _library.straight("to_state_frame")


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
        if not _other and observer_attitude.ndim == 1:
            if out is None:
                value = _empty(3)
                value_covariance = _empty(9)
            else:
                (value, value_covariance) = _outputs(out, 2, 3)
            given = (
                _array, observer_attitude, receiver_position, origin_offset, attitude, lever_arm,
                covariance, value, value_covariance,
            )
            if not _to_state_frame_straight(_id(given)):
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
