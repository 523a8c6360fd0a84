from . import (
    _Broadcast_Orbit,
    _Pseudorange,
    _Pseudorange_Without_Sagnac,
)

pseudorange: _Pseudorange
pseudorange_without_sagnac: _Pseudorange_Without_Sagnac
broadcast_orbit: _Broadcast_Orbit
