from . import (
    _Local,
    _Pseudorange,
    _Pseudorange_Lever_Arm,
    _Retract,
)

retract: _Retract
local: _Local
pseudorange: _Pseudorange
pseudorange_lever_arm: _Pseudorange_Lever_Arm

def set_threads(count: int) -> None: ...
