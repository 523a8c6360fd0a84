from . import (
    _Gps,
    _Gps_Known_Antenna,
    _Local,
    _Local_Fix,
    _Retract,
)

retract: _Retract
local: _Local
gps: _Gps
gps_known_antenna: _Gps_Known_Antenna
local_fix: _Local_Fix

def set_threads(count: int) -> None: ...
