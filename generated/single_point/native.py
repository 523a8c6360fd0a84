"""The functions of ``single_point`` in compiled C.

The extension is made from the very files of ``c/`` that are exported. Importing this module fails,
and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _calls, _compiled, _extension, _interface

_module = _extension.load_extension(Path(__file__).parent, "native")
_library = _extension.Library(_module, "single_point", "float64")
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


_pseudorange_function = _compiled.CompiledFunction(_library, _interface.PSEUDORANGE)
_pseudorange_straight = _library.call("pseudorange", _interface.PseudorangeResult)


def _pseudorange_call(
    x: Any = None,
    /,
    *_more: Any,
    satellite_position: Any = None,
    satellite_clock: Any = None,
    troposphere: Any = None,
    ionosphere: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _pseudorange_straight(
        x, satellite_position, satellite_clock, troposphere, ionosphere, out
    )
    if _found is not None:
        return _found
    return _pseudorange_function.call(
        (x, *_more),
        {"satellite_position": satellite_position, "satellite_clock": satellite_clock,
        "troposphere": troposphere, "ionosphere": ionosphere, **_other},
        out,
    )


pseudorange = _calls.publish(_pseudorange_function, __name__, _pseudorange_call)


_pseudorange_without_sagnac_function = _compiled.CompiledFunction(
    _library, _interface.PSEUDORANGE_WITHOUT_SAGNAC
)
_pseudorange_without_sagnac_straight = _library.call(
    "pseudorange_without_sagnac", _interface.PseudorangeWithoutSagnacResult
)


def _pseudorange_without_sagnac_call(
    x: Any = None,
    /,
    *_more: Any,
    satellite_position: Any = None,
    satellite_clock: Any = None,
    troposphere: Any = None,
    ionosphere: Any = None,
    out: Any = None,
    **_other: Any,
) -> Any:
    _found = None if _more or _other else _pseudorange_without_sagnac_straight(
        x, satellite_position, satellite_clock, troposphere, ionosphere, out
    )
    if _found is not None:
        return _found
    return _pseudorange_without_sagnac_function.call(
        (x, *_more),
        {"satellite_position": satellite_position, "satellite_clock": satellite_clock,
        "troposphere": troposphere, "ionosphere": ionosphere, **_other},
        out,
    )


pseudorange_without_sagnac = _calls.publish(
    _pseudorange_without_sagnac_function, __name__, _pseudorange_without_sagnac_call
)


_broadcast_orbit_function = _compiled.CompiledFunction(_library, _interface.BROADCAST_ORBIT)
_broadcast_orbit_straight = _library.call("broadcast_orbit", _interface.BroadcastOrbitResult)


def _broadcast_orbit_call(
    *_more: Any,
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
    _found = None if _more or _other else _broadcast_orbit_straight(
        time, toe, toc, sqrt_a, eccentricity, mean_anomaly, mean_motion_difference, inclination,
        inclination_rate, right_ascension, right_ascension_rate, argument_of_perigee, cuc, cus, crc,
        crs, cic, cis, af0, af1, af2, group_delay, out,
    )
    if _found is not None:
        return _found
    return _broadcast_orbit_function.call(
        _more,
        {"time": time, "toe": toe, "toc": toc, "sqrt_a": sqrt_a, "eccentricity": eccentricity,
        "mean_anomaly": mean_anomaly, "mean_motion_difference": mean_motion_difference,
        "inclination": inclination, "inclination_rate": inclination_rate, "right_ascension":
        right_ascension, "right_ascension_rate": right_ascension_rate, "argument_of_perigee":
        argument_of_perigee, "cuc": cuc, "cus": cus, "crc": crc, "crs": crs, "cic": cic, "cis": cis,
        "af0": af0, "af1": af1, "af2": af2, "group_delay": group_delay, **_other},
        out,
    )


broadcast_orbit = _calls.publish(_broadcast_orbit_function, __name__, _broadcast_orbit_call)
