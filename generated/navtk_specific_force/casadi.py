"""The functions of ``navtk_specific_force`` in CasADi's own C.

Generated from the undifferentiated equation, they are an independent witness of the other back
ends; they loop in Python and are not made for speed.
Importing this module fails, and says what to do, until ``symnav build`` has run on this machine.
"""

from __future__ import annotations

from pathlib import Path

from . import _calls, _extension, _foreign, _interface

_module = _extension.load_extension(Path(__file__).parent, "casadi")

calc_force = _calls.publish(
    _foreign.ForeignFunction(_module, "navtk_specific_force", _interface.CALC_FORCE), __name__
)
force = _calls.publish(
    _foreign.ForeignFunction(_module, "navtk_specific_force", _interface.FORCE), __name__
)
