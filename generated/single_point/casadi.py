"""The functions of ``single_point`` in CasADi's own C.

Generated from the undifferentiated equation, they are an independent witness of the other back
ends; they loop in Python and are not made for speed.
Importing this module fails, and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path

from . import _calls, _extension, _foreign, _interface

_module = _extension.load_extension(Path(__file__).parent, "casadi")

pseudorange = _calls.publish(
    _foreign.ForeignFunction(_module, "single_point", _interface.PSEUDORANGE), __name__
)
pseudorange_without_sagnac = _calls.publish(
    _foreign.ForeignFunction(_module, "single_point", _interface.PSEUDORANGE_WITHOUT_SAGNAC),
    __name__,
)
broadcast_orbit = _calls.publish(
    _foreign.ForeignFunction(_module, "single_point", _interface.BROADCAST_ORBIT), __name__
)
