"""The functions of ``single_point`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as _np

from . import _calls, _compiled, _extension, _interface, _runtime, _straight

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "single_point", "float64")
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
                value = _empty(4)
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
                value = _empty(4)
            else:
                (value,) = _outputs(out, 1, 2)
            given = (_array, x, y, value)
            if not _local_straight(_id(given)):
                return _tuple(_interface.LocalResult, (value, _OK))
    except _UNFIT:
        pass
    return _local_function.call((x,), {"y": y, **_other}, out)


local = _calls.publish(_local_function, __name__, _local_call)


_pseudorange_function = _compiled.CompiledFunction(_library, _interface.PSEUDORANGE)
_pseudorange_straight = _library.straight("pseudorange")


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
        if not _other and x.ndim == 1:
            n = len(satellite_position)
            if out is None:
                value = _empty(n)
                jacobian = _empty((n, 4))
            else:
                (value, jacobian) = _outputs(out, 2, 4)
            item_status = _empty(n, _byte)
            given = (
                _array, x, satellite_position, satellite_clock, troposphere, ionosphere, value,
                jacobian, item_status,
            )
            if not _pseudorange_straight(_id(given)):
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
_pseudorange_without_sagnac_straight = _library.straight("pseudorange_without_sagnac")


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
        if not _other and x.ndim == 1:
            n = len(satellite_position)
            if out is None:
                value = _empty(n)
                jacobian = _empty((n, 4))
            else:
                (value, jacobian) = _outputs(out, 2, 4)
            item_status = _empty(n, _byte)
            given = (
                _array, x, satellite_position, satellite_clock, troposphere, ionosphere, value,
                jacobian, item_status,
            )
            if not _pseudorange_without_sagnac_straight(_id(given)):
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
_broadcast_orbit_straight = _library.straight("broadcast_orbit")


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
        if not _other:
            if out is None:
                position = _empty(3)
                clock = _empty(())
                velocity = _empty(3)
                clock_rate = _empty(())
            else:
                (position, clock, velocity, clock_rate) = _outputs(out, 4, 5)
            given = (
                _array, time, toe, toc, sqrt_a, eccentricity, mean_anomaly, mean_motion_difference,
                inclination, inclination_rate, right_ascension, right_ascension_rate,
                argument_of_perigee, cuc, cus, crc, crs, cic, cis, af0, af1, af2, group_delay,
                position, clock, velocity, clock_rate,
            )
            if not _broadcast_orbit_straight(_id(given)):
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
