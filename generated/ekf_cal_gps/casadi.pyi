from . import (
    _Gps,
    _Gps_Known_Antenna,
    _Local_Fix,
)

gps: _Gps
gps_known_antenna: _Gps_Known_Antenna
local_fix: _Local_Fix
