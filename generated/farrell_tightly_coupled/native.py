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
            and len(x) == 18
            and d.dtype is _real
            and d.ndim == 1
            and len(d) == 17
        ):
            if out is None:
                value = _empty(18)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (d.base is None or _apart(d, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 18
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
            and len(x) == 18
            and y.dtype is _real
            and y.ndim == 1
            and len(y) == 18
        ):
            if out is None:
                value = _empty(17)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (y.base is None or _apart(y, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 17
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
            not _other
            and (n := len(satellite_position)) <= 32
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 18
            and c_n_e.dtype is _real
            and c_n_e.ndim == 1
            and len(c_n_e) == 9
            and origin.dtype is _real
            and origin.ndim == 1
            and len(origin) == 3
            and satellite_position.dtype is _real
            and satellite_position.shape == (n, 3)
            and measured.dtype is _real
            and measured.ndim == 1
            and len(measured) == n
        ):
            if out is None:
                value = _empty(n)
                residual = _empty(n)
                jacobian = _empty((n, 17))
            else:
                written = out[:3]
                (value, residual, jacobian) = written
                if not (
                    len(out) in (3, 5)
                    and (x.base is None or _apart(x, written))
                    and (c_n_e.base is None or _apart(c_n_e, written))
                    and (origin.base is None or _apart(origin, written))
                    and (satellite_position.base is None or _apart(satellite_position, written))
                    and (measured.base is None or _apart(measured, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == n
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not x
                    and value is not c_n_e
                    and value is not origin
                    and value is not measured
                    and residual.dtype is _real
                    and residual.ndim == 1
                    and len(residual) == n
                    and (flags := residual.flags).carray
                    and flags.owndata
                    and residual is not x
                    and residual is not c_n_e
                    and residual is not origin
                    and residual is not measured
                    and residual is not value
                    and jacobian.dtype is _real
                    and jacobian.shape == (n, 17)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _pseudorange_function.given(
                        out, (x, c_n_e, origin, satellite_position, measured), n
                    )
                    (value, residual, jacobian) = written
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
            not _other
            and (n := len(satellite_position)) <= 32
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 18
            and c_n_e.dtype is _real
            and c_n_e.ndim == 1
            and len(c_n_e) == 9
            and origin.dtype is _real
            and origin.ndim == 1
            and len(origin) == 3
            and lever_arm.dtype is _real
            and lever_arm.ndim == 1
            and len(lever_arm) == 3
            and satellite_position.dtype is _real
            and satellite_position.shape == (n, 3)
        ):
            if out is None:
                value = _empty(n)
                jacobian = _empty((n, 17))
            else:
                written = out[:2]
                (value, jacobian) = written
                if not (
                    len(out) in (2, 4)
                    and (x.base is None or _apart(x, written))
                    and (c_n_e.base is None or _apart(c_n_e, written))
                    and (origin.base is None or _apart(origin, written))
                    and (lever_arm.base is None or _apart(lever_arm, written))
                    and (satellite_position.base is None or _apart(satellite_position, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == n
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not x
                    and value is not c_n_e
                    and value is not origin
                    and value is not lever_arm
                    and jacobian.dtype is _real
                    and jacobian.shape == (n, 17)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _pseudorange_lever_arm_function.given(
                        out, (x, c_n_e, origin, lever_arm, satellite_position), n
                    )
                    (value, jacobian) = written
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
