"""The functions of ``ekf_cal_online`` in CasADi's own C.

Generated from the undifferentiated equation, they are an independent witness of the other back
ends; they loop in Python and are not made for speed.
Importing this module fails, and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path

from . import _calls, _extension, _foreign, _interface

_module = _extension.load_extension(Path(__file__).parent, "casadi")

gps_1 = _calls.publish(
    _foreign.ForeignFunction(_module, "ekf_cal_online", _interface.GPS_1), __name__
)
gps_2 = _calls.publish(
    _foreign.ForeignFunction(_module, "ekf_cal_online", _interface.GPS_2), __name__
)
