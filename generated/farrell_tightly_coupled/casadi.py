"""The functions of ``farrell_tightly_coupled`` in CasADi's own C.

Generated from the undifferentiated equation, they are an independent witness of the other back
ends; they loop in Python and are not made for speed.
Importing this module fails, and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path

from . import _calls, _extension, _foreign, _interface

_module = _extension.load_extension(Path(__file__).parent, "casadi")

pseudorange = _calls.publish(
    _foreign.ForeignFunction(_module, "farrell_tightly_coupled", _interface.PSEUDORANGE), __name__
)
pseudorange_lever_arm = _calls.publish(
    _foreign.ForeignFunction(_module, "farrell_tightly_coupled", _interface.PSEUDORANGE_LEVER_ARM),
    __name__,
)
