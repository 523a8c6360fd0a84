from . import (
    _Gps_1,
    _Gps_2,
)

gps_1: _Gps_1
gps_2: _Gps_2
