from . import (
    _Local,
    _Measurement,
    _Measurement_By_Column,
    _Observed,
    _Observed_By_Column,
    _Retract,
    _To_State_Frame,
)

retract: _Retract
local: _Local
measurement: _Measurement
measurement_by_column: _Measurement_By_Column
observed: _Observed
observed_by_column: _Observed_By_Column
to_state_frame: _To_State_Frame

def set_threads(count: int) -> None: ...
