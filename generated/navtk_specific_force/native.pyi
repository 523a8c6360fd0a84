from . import (
    _Calc_Force,
    _Force,
    _Local,
    _Retract,
)

retract: _Retract
local: _Local
calc_force: _Calc_Force
force: _Force

def set_threads(count: int) -> None: ...
