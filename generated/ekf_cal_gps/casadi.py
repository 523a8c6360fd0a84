"""The functions of ``ekf_cal_gps`` in CasADi's own C.

Generated from the undifferentiated equation, they are an independent witness of the other back
ends; they loop in Python and are not made for speed.
Importing this module fails, and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path

from . import _calls, _extension, _foreign, _interface

_module = _extension.load_extension(Path(__file__).parent, "casadi")

gps = _calls.publish(_foreign.ForeignFunction(_module, "ekf_cal_gps", _interface.GPS), __name__)
gps_known_antenna = _calls.publish(
    _foreign.ForeignFunction(_module, "ekf_cal_gps", _interface.GPS_KNOWN_ANTENNA), __name__
)
local_fix = _calls.publish(
    _foreign.ForeignFunction(_module, "ekf_cal_gps", _interface.LOCAL_FIX), __name__
)
