"""The functions of ``single_point`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "single_point", "float64")
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
            and len(x) == 4
            and d.dtype is _real
            and d.ndim == 1
            and len(d) == 4
        ):
            if out is None:
                value = _empty(4)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (d.base is None or _apart(d, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 4
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
            and len(x) == 4
            and y.dtype is _real
            and y.ndim == 1
            and len(y) == 4
        ):
            if out is None:
                value = _empty(4)
            else:
                written = out[:1]
                (value,) = written
                if not (
                    len(out) in (1, 2)
                    and (x.base is None or _apart(x, written))
                    and (y.base is None or _apart(y, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == 4
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


_pseudorange_function = _compiled.CompiledFunction(_library, _interface.PSEUDORANGE)
_pseudorange_entry = _library.entry("pseudorange")


def _pseudorange_call(
    x: Any = None,
    /,
    *,
    satellite_position: Any = None,
    satellite_clock: Any = None,
    troposphere: Any = None,
    ionosphere: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if (
            not _other
            and (n := len(satellite_position)) <= 32
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 4
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
        ):
            if out is None:
                value = _empty(n)
                jacobian = _empty((n, 4))
            else:
                written = out[:2]
                (value, jacobian) = written
                if not (
                    len(out) in (2, 4)
                    and (x.base is None or _apart(x, written))
                    and (satellite_position.base is None or _apart(satellite_position, written))
                    and (satellite_clock.base is None or _apart(satellite_clock, written))
                    and (troposphere.base is None or _apart(troposphere, written))
                    and (ionosphere.base is None or _apart(ionosphere, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == n
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not x
                    and value is not satellite_clock
                    and value is not troposphere
                    and value is not ionosphere
                    and jacobian.dtype is _real
                    and jacobian.shape == (n, 4)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _pseudorange_function.given(
                        out, (x, satellite_position, satellite_clock, troposphere, ionosphere), n
                    )
                    (value, jacobian) = written
            item_status = _empty(n, _byte)
            if not _pseudorange_entry(
                _pointer(_reals, x),
                n,
                _pointer(_reals, satellite_position),
                _pointer(_reals, satellite_clock),
                _pointer(_reals, troposphere),
                _pointer(_reals, ionosphere),
                _pointer(_reals, value),
                _pointer(_reals, jacobian),
                _pointer(_bytes, item_status),
            ):
                return _tuple(_interface.PseudorangeResult, (value, jacobian, _OK, item_status))
    except _UNFIT:
        pass
    return _pseudorange_function.call(
        (x,),
        {"satellite_position": satellite_position, "satellite_clock": satellite_clock,
        "troposphere": troposphere, "ionosphere": ionosphere, **_other},
        out,
    )


pseudorange = _calls.publish(_pseudorange_function, __name__, _pseudorange_call)


_pseudorange_without_sagnac_function = _compiled.CompiledFunction(
    _library, _interface.PSEUDORANGE_WITHOUT_SAGNAC
)
_pseudorange_without_sagnac_entry = _library.entry("pseudorange_without_sagnac")


def _pseudorange_without_sagnac_call(
    x: Any = None,
    /,
    *,
    satellite_position: Any = None,
    satellite_clock: Any = None,
    troposphere: Any = None,
    ionosphere: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if (
            not _other
            and (n := len(satellite_position)) <= 32
            and x.dtype is _real
            and x.ndim == 1
            and len(x) == 4
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
        ):
            if out is None:
                value = _empty(n)
                jacobian = _empty((n, 4))
            else:
                written = out[:2]
                (value, jacobian) = written
                if not (
                    len(out) in (2, 4)
                    and (x.base is None or _apart(x, written))
                    and (satellite_position.base is None or _apart(satellite_position, written))
                    and (satellite_clock.base is None or _apart(satellite_clock, written))
                    and (troposphere.base is None or _apart(troposphere, written))
                    and (ionosphere.base is None or _apart(ionosphere, written))
                    and value.dtype is _real
                    and value.ndim == 1
                    and len(value) == n
                    and (flags := value.flags).carray
                    and flags.owndata
                    and value is not x
                    and value is not satellite_clock
                    and value is not troposphere
                    and value is not ionosphere
                    and jacobian.dtype is _real
                    and jacobian.shape == (n, 4)
                    and (flags := jacobian.flags).carray
                    and flags.owndata
                ):
                    written = _pseudorange_without_sagnac_function.given(
                        out, (x, satellite_position, satellite_clock, troposphere, ionosphere), n
                    )
                    (value, jacobian) = written
            item_status = _empty(n, _byte)
            if not _pseudorange_without_sagnac_entry(
                _pointer(_reals, x),
                n,
                _pointer(_reals, satellite_position),
                _pointer(_reals, satellite_clock),
                _pointer(_reals, troposphere),
                _pointer(_reals, ionosphere),
                _pointer(_reals, value),
                _pointer(_reals, jacobian),
                _pointer(_bytes, item_status),
            ):
                return _tuple(
                    _interface.PseudorangeWithoutSagnacResult, (value, jacobian, _OK, item_status)
                )
    except _UNFIT:
        pass
    return _pseudorange_without_sagnac_function.call(
        (x,),
        {"satellite_position": satellite_position, "satellite_clock": satellite_clock,
        "troposphere": troposphere, "ionosphere": ionosphere, **_other},
        out,
    )


pseudorange_without_sagnac = _calls.publish(
    _pseudorange_without_sagnac_function, __name__, _pseudorange_without_sagnac_call
)


_broadcast_orbit_function = _compiled.CompiledFunction(_library, _interface.BROADCAST_ORBIT)
_broadcast_orbit_entry = _library.entry("broadcast_orbit")


def _broadcast_orbit_call(
    *,
    time: Any = None,
    toe: Any = None,
    toc: Any = None,
    sqrt_a: Any = None,
    eccentricity: Any = None,
    mean_anomaly: Any = None,
    mean_motion_difference: Any = None,
    inclination: Any = None,
    inclination_rate: Any = None,
    right_ascension: Any = None,
    right_ascension_rate: Any = None,
    argument_of_perigee: Any = None,
    cuc: Any = None,
    cus: Any = None,
    crc: Any = None,
    crs: Any = None,
    cic: Any = None,
    cis: Any = None,
    af0: Any = None,
    af1: Any = None,
    af2: Any = None,
    group_delay: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    try:
        if (
            not _other
            and type(time) is float
            and type(toe) is float
            and type(toc) is float
            and type(sqrt_a) is float
            and type(eccentricity) is float
            and type(mean_anomaly) is float
            and type(mean_motion_difference) is float
            and type(inclination) is float
            and type(inclination_rate) is float
            and type(right_ascension) is float
            and type(right_ascension_rate) is float
            and type(argument_of_perigee) is float
            and type(cuc) is float
            and type(cus) is float
            and type(crc) is float
            and type(crs) is float
            and type(cic) is float
            and type(cis) is float
            and type(af0) is float
            and type(af1) is float
            and type(af2) is float
            and type(group_delay) is float
        ):
            if out is None:
                position = _empty(3)
                clock = _empty(())
                velocity = _empty(3)
                clock_rate = _empty(())
            else:
                written = out[:4]
                (position, clock, velocity, clock_rate) = written
                if not (
                    len(out) in (4, 5)
                    and position.dtype is _real
                    and position.ndim == 1
                    and len(position) == 3
                    and (flags := position.flags).carray
                    and flags.owndata
                    and clock.dtype is _real
                    and clock.shape == ()
                    and (flags := clock.flags).carray
                    and flags.owndata
                    and velocity.dtype is _real
                    and velocity.ndim == 1
                    and len(velocity) == 3
                    and (flags := velocity.flags).carray
                    and flags.owndata
                    and velocity is not position
                    and clock_rate.dtype is _real
                    and clock_rate.shape == ()
                    and (flags := clock_rate.flags).carray
                    and flags.owndata
                    and clock_rate is not clock
                ):
                    written = _broadcast_orbit_function.given(out, ())
                    (position, clock, velocity, clock_rate) = written
            if not _broadcast_orbit_entry(
                _new(_reals, (time,)),
                _new(_reals, (toe,)),
                _new(_reals, (toc,)),
                _new(_reals, (sqrt_a,)),
                _new(_reals, (eccentricity,)),
                _new(_reals, (mean_anomaly,)),
                _new(_reals, (mean_motion_difference,)),
                _new(_reals, (inclination,)),
                _new(_reals, (inclination_rate,)),
                _new(_reals, (right_ascension,)),
                _new(_reals, (right_ascension_rate,)),
                _new(_reals, (argument_of_perigee,)),
                _new(_reals, (cuc,)),
                _new(_reals, (cus,)),
                _new(_reals, (crc,)),
                _new(_reals, (crs,)),
                _new(_reals, (cic,)),
                _new(_reals, (cis,)),
                _new(_reals, (af0,)),
                _new(_reals, (af1,)),
                _new(_reals, (af2,)),
                _new(_reals, (group_delay,)),
                _pointer(_reals, position),
                _pointer(_reals, clock),
                _pointer(_reals, velocity),
                _pointer(_reals, clock_rate),
            ):
                return _tuple(
                    _interface.BroadcastOrbitResult, (position, clock, velocity, clock_rate, _OK)
                )
    except _UNFIT:
        pass
    return _broadcast_orbit_function.call(
        (),
        {"time": time, "toe": toe, "toc": toc, "sqrt_a": sqrt_a, "eccentricity": eccentricity,
        "mean_anomaly": mean_anomaly, "mean_motion_difference": mean_motion_difference,
        "inclination": inclination, "inclination_rate": inclination_rate, "right_ascension":
        right_ascension, "right_ascension_rate": right_ascension_rate, "argument_of_perigee":
        argument_of_perigee, "cuc": cuc, "cus": cus, "crc": crc, "crs": crs, "cic": cic, "cis": cis,
        "af0": af0, "af1": af1, "af2": af2, "group_delay": group_delay, **_other},
        out,
    )


broadcast_orbit = _calls.publish(_broadcast_orbit_function, __name__, _broadcast_orbit_call)
