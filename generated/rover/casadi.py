"""The functions of ``rover`` in CasADi's own C.

Generated from the undifferentiated equation, they are an independent witness of the other back
ends; they loop in Python and are not made for speed.
Importing this module fails, and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path

from . import _calls, _extension, _foreign, _interface

_module = _extension.load_extension(Path(__file__).parent, "casadi")

gps = _calls.publish(_foreign.ForeignFunction(_module, "rover", _interface.GPS), __name__)
range = _calls.publish(_foreign.ForeignFunction(_module, "rover", _interface.RANGE), __name__)
imu = _calls.publish(_foreign.ForeignFunction(_module, "rover", _interface.IMU), __name__)
