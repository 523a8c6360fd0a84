"""The functions of ``warpos_gps`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _calls, _compiled, _extension, _interface

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "warpos_gps", "float64")
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


_measurement_function = _compiled.CompiledFunction(_library, _interface.MEASUREMENT)
_measurement_straight = _library.call("measurement", _interface.MeasurementResult)


def _measurement_call(x: Any = None, /, *_more: Any, out: Any = None, **_other: Any) -> Any:
    _found = None if _more or _other else _measurement_straight(x, out)
    if _found is not None:
        return _found
    return _measurement_function.call((x, *_more), {**_other}, out)


measurement = _calls.publish(_measurement_function, __name__, _measurement_call)


_measurement_by_column_function = _compiled.CompiledFunction(
    _library, _interface.MEASUREMENT_BY_COLUMN
)
measurement_by_column = _calls.publish(_measurement_by_column_function, __name__)


_observed_function = _compiled.CompiledFunction(_library, _interface.OBSERVED)
_observed_straight = _library.call("observed", _interface.ObservedResult)


def _observed_call(
    x: Any = None, /, *_more: Any, observer_attitude: Any = None, out: Any = None, **_other: Any
) -> Any:
    _found = None if _more or _other else _observed_straight(x, observer_attitude, out)
    if _found is not None:
        return _found
    return _observed_function.call(
        (x, *_more), {"observer_attitude": observer_attitude, **_other}, out
    )


observed = _calls.publish(_observed_function, __name__, _observed_call)


_observed_by_column_function = _compiled.CompiledFunction(_library, _interface.OBSERVED_BY_COLUMN)
observed_by_column = _calls.publish(_observed_by_column_function, __name__)


_to_state_frame_function = _compiled.CompiledFunction(_library, _interface.TO_STATE_FRAME)
_to_state_frame_straight = _library.call("to_state_frame", _interface.ToStateFrameResult)


def _to_state_frame_call(
    *_more: Any,
    observer_attitude: Any = None,
    receiver_position: Any = None,
    origin_offset: Any = None,
    attitude: Any = None,
    lever_arm: Any = None,
    covariance: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _to_state_frame_straight(
        observer_attitude, receiver_position, origin_offset, attitude, lever_arm, covariance, out
    )
    if _found is not None:
        return _found
    return _to_state_frame_function.call(
        _more,
        {"observer_attitude": observer_attitude, "receiver_position": receiver_position,
        "origin_offset": origin_offset, "attitude": attitude, "lever_arm": lever_arm, "covariance":
        covariance, **_other},
        out,
    )


to_state_frame = _calls.publish(_to_state_frame_function, __name__, _to_state_frame_call)
