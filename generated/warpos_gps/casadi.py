"""The functions of ``warpos_gps`` in CasADi's own C.

Generated from the undifferentiated equation, they are an independent witness of the other back
ends; they loop in Python and are not made for speed.
Importing this module fails, and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path

from . import _calls, _extension, _foreign, _interface

_module = _extension.load_extension(Path(__file__).parent, "casadi")

measurement = _calls.publish(
    _foreign.ForeignFunction(_module, "warpos_gps", _interface.MEASUREMENT), __name__
)
measurement_by_column = _calls.publish(
    _foreign.ForeignFunction(_module, "warpos_gps", _interface.MEASUREMENT_BY_COLUMN), __name__
)
observed = _calls.publish(
    _foreign.ForeignFunction(_module, "warpos_gps", _interface.OBSERVED), __name__
)
observed_by_column = _calls.publish(
    _foreign.ForeignFunction(_module, "warpos_gps", _interface.OBSERVED_BY_COLUMN), __name__
)
to_state_frame = _calls.publish(
    _foreign.ForeignFunction(_module, "warpos_gps", _interface.TO_STATE_FRAME), __name__
)
