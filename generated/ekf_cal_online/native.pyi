from . import (
    _Gps_1,
    _Gps_2,
    _Local,
    _Retract,
)

retract: _Retract
local: _Local
gps_1: _Gps_1
gps_2: _Gps_2

def set_threads(count: int) -> None: ...
