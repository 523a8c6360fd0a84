from . import (
    _Pseudorange,
    _Pseudorange_Lever_Arm,
)

pseudorange: _Pseudorange
pseudorange_lever_arm: _Pseudorange_Lever_Arm
