"""The functions of ``farrell_tightly_coupled`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "farrell_tightly_coupled", "float64")
_new = _library.ffi.new
_pointer = _library.ffi.from_buffer
_reals, _integers, _bytes = _library.reals, _library.integers, _library.bytes
_empty, _tuple = _np.empty, tuple.__new__
_real, _integer, _byte = _library.real, _np.dtype(_np.int32), _np.dtype(_np.uint8)
_OK = _runtime.Status.OK
_UNFIT = (AttributeError, BufferError, OverflowError, TypeError, ValueError)


_retract_function = _compiled.CompiledFunction(_library, _interface.RETRACT)
_retract_entry = _library.entry("retract")


def _retract_call(x: Any = None, /, *, d: Any = None, out: Any = None, **_other: Any) -> Any:
    try:
        if (
            out is None
            and not _other
            and x.dtype is _real
            and x.shape == (18,)
            and d.dtype is _real
            and d.shape == (17,)
        ):
            value = _empty(18)
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
            out is None
            and not _other
            and x.dtype is _real
            and x.shape == (18,)
            and y.dtype is _real
            and y.shape == (18,)
        ):
            value = _empty(17)
            if not _local_entry(_pointer(_reals, x), _pointer(_reals, y), _pointer(_reals, value)):
                return _tuple(_interface.LocalResult, (value, _OK))
    except _UNFIT:
        pass
    return _local_function.call((x,), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_pseudorange_function = _compiled.CompiledFunction(_library, _interface.PSEUDORANGE)
_pseudorange_entry = _library.entry("pseudorange")


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
        if (
            out is None
            and not _other
            and (n := len(satellite_position)) <= 32
            and x.dtype is _real
            and x.shape == (18,)
            and c_n_e.dtype is _real
            and c_n_e.shape == (9,)
            and origin.dtype is _real
            and origin.shape == (3,)
            and satellite_position.dtype is _real
            and satellite_position.shape == (n, 3)
            and measured.dtype is _real
            and measured.shape == (n,)
        ):
            value = _empty(n)
            residual = _empty(n)
            jacobian = _empty((n, 17))
            item_status = _empty(n, _byte)
            if not _pseudorange_entry(
                _pointer(_reals, x),
                n,
                _pointer(_reals, c_n_e),
                _pointer(_reals, origin),
                _pointer(_reals, satellite_position),
                _pointer(_reals, measured),
                _pointer(_reals, value),
                _pointer(_reals, residual),
                _pointer(_reals, jacobian),
                _pointer(_bytes, item_status),
            ):
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
_pseudorange_lever_arm_entry = _library.entry("pseudorange_lever_arm")


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
        if (
            out is None
            and not _other
            and (n := len(satellite_position)) <= 32
            and x.dtype is _real
            and x.shape == (18,)
            and c_n_e.dtype is _real
            and c_n_e.shape == (9,)
            and origin.dtype is _real
            and origin.shape == (3,)
            and lever_arm.dtype is _real
            and lever_arm.shape == (3,)
            and satellite_position.dtype is _real
            and satellite_position.shape == (n, 3)
        ):
            value = _empty(n)
            jacobian = _empty((n, 17))
            item_status = _empty(n, _byte)
            if not _pseudorange_lever_arm_entry(
                _pointer(_reals, x),
                n,
                _pointer(_reals, c_n_e),
                _pointer(_reals, origin),
                _pointer(_reals, lever_arm),
                _pointer(_reals, satellite_position),
                _pointer(_reals, value),
                _pointer(_reals, jacobian),
                _pointer(_bytes, item_status),
            ):
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
