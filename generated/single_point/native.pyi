from . import (
    _Broadcast_Orbit,
    _Local,
    _Pseudorange,
    _Pseudorange_Without_Sagnac,
    _Retract,
)

retract: _Retract
local: _Local
pseudorange: _Pseudorange
pseudorange_without_sagnac: _Pseudorange_Without_Sagnac
broadcast_orbit: _Broadcast_Orbit

def set_threads(count: int) -> None: ...
