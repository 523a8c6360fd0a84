from . import (
    _Gps,
    _Imu,
    _Local,
    _Range,
    _Retract,
)

retract: _Retract
local: _Local
gps: _Gps
range: _Range
imu: _Imu

def set_threads(count: int) -> None: ...
