from . import (
    _Gps,
    _Imu,
    _Range,
)

gps: _Gps
range: _Range
imu: _Imu
