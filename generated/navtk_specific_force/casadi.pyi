from . import (
    _Calc_Force,
    _Force,
)

calc_force: _Calc_Force
force: _Force
