from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import casadi as casadi
from . import native as native
from . import numpy as numpy
from ._lanes import Blocks as Blocks
from ._runtime import GuardError as GuardError
from ._runtime import Status as Status

BACKEND: str
_Array: TypeAlias = NDArray[np.float64]

class RetractResult(NamedTuple):
    value: _Array
    status: Any

class _Retract(Protocol):
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        d: ArrayLike,
        out: RetractResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> RetractResult:
        """State moved by an error.

            value = x (+) d

        Parameters
        ----------
        x : array_like, shape (..., 16)
            - [0:3] position (m, frame n, range [-1e9, 1e9])
            - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
            - [6:10] attitude (map s -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame s, range [-1, 1])
            - [13:16] gyro_bias (rad/s, frame s, range [-0.1, 0.1])
        d : array_like, shape (..., 15)
            - [0:3] position (m, frame n, range [-1e9, 1e9]): Error of position
            - [3:6] velocity (m/s, frame n, range [-1e9, 1e9]): Error of velocity
            - [6:9] attitude (rad, frame n, range [-6, 6]): Error of attitude
            - [9:12] accelerometer_bias (m/s^2, frame s, range [-1e9, 1e9]): Error of
              accelerometer_bias
            - [12:15] gyro_bias (rad/s, frame s, range [-1e9, 1e9]): Error of gyro_bias
        out : RetractResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        RetractResult
            value : array, shape (..., 16)
                Value of the equation.
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``retract.value`` (value), ``retract.bind`` (a call
        without arguments over the same arrays), ``retract.blocks`` (epochs side by side, see
        ``retract.to_lanes``).
        Products of unit quaternions drift from unit norm by rounding (attitude): renormalise after
        every update, for which q *= 1.5 - 0.5 |q|^2 is enough; else calls end in QNORM, in single
        precision after some hundred.
        Source: the error conventions of the blocks.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        d: ArrayLike,
        out: RetractResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], RetractResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        d: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        x: ArrayLike,
        /,
        *,
        d: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        d: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

retract: _Retract

class LocalResult(NamedTuple):
    value: _Array
    status: Any

class _Local(Protocol):
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        y: ArrayLike,
        out: LocalResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> LocalResult:
        """Error between two states.

            value = y (-) x, so that x (+) value = y

        Parameters
        ----------
        x : array_like, shape (..., 16)
            - [0:3] position (m, frame n, range [-1e9, 1e9])
            - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
            - [6:10] attitude (map s -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame s, range [-1, 1])
            - [13:16] gyro_bias (rad/s, frame s, range [-0.1, 0.1])
        y : array_like, shape (..., 16)
            - [0:3] position (m, frame n, range [-1e9, 1e9])
            - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
            - [6:10] attitude (map s -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame s, range [-1, 1])
            - [13:16] gyro_bias (rad/s, frame s, range [-0.1, 0.1])
        out : LocalResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        LocalResult
            value : array, shape (..., 15)
                Value of the equation.
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``local.value`` (value), ``local.bind`` (a call
        without arguments over the same arrays), ``local.blocks`` (epochs side by side, see
        ``local.to_lanes``).
        Source: the error conventions of the blocks.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        y: ArrayLike,
        out: LocalResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], LocalResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        y: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        x: ArrayLike,
        /,
        *,
        y: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        y: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

local: _Local

class CalcForceResult(NamedTuple):
    value: _Array
    jacobian_dcm: _Array
    jacobian_delta_theta: _Array
    jacobian_delta_velocity: _Array
    jacobian_dt: _Array
    status: Any

class _Calc_Force(Protocol):
    jacobian_dcm_rows: NDArray[np.int32]
    jacobian_dcm_columns: NDArray[np.int32]
    jacobian_delta_theta_rows: NDArray[np.int32]
    jacobian_delta_theta_columns: NDArray[np.int32]
    jacobian_delta_velocity_rows: NDArray[np.int32]
    jacobian_delta_velocity_columns: NDArray[np.int32]
    jacobian_dt_rows: NDArray[np.int32]
    jacobian_dt_columns: NDArray[np.int32]
    def __call__(
        self,
        *,
        dcm: ArrayLike,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: CalcForceResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> CalcForceResult:
        """Specific force corrected for rotation and sculling.

            f = C (dv + c2 theta x dv + c3 theta x (theta x dv) + S) / dt

        Parameters
        ----------
        dcm : array_like, shape (..., 9)
            C, attitude of the body at the epoch; map s -> n, rotation matrix, row by row.
        delta_theta : array_like, shape (..., 3)
            Angle increments, oldest sub-sample first; rad, frame s, range [-0.5, 0.5]; elements x y
            z.
        delta_velocity : array_like, shape (..., 3)
            Velocity increments, oldest sub-sample first; m/s, frame s, range [-50, 50]; elements x
            y z.
        dt : array_like, shape (...)
            Length of the interval; s, range [1e-5, 0.05].
        out : CalcForceResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        CalcForceResult
            value : array, shape (..., 3), m/s^2, frame n
                Value of the equation.
            jacobian_dcm : array, shape (..., 3, 3)
                Derivative of the value by dcm.
                Columns: dcm[3].
            jacobian_delta_theta : array, shape (..., 3, 3)
                Derivative of the value by delta_theta.
                Columns: delta_theta[3].
            jacobian_delta_velocity : array, shape (..., 3, 3)
                Derivative of the value by delta_velocity.
                Columns: delta_velocity[3].
            jacobian_dt : array, shape (..., 3, 1)
                Derivative of the value by dt.
                Columns: dt[1].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``calc_force.value`` (value), ``calc_force.jacobian``
        (jacobian_dcm, jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt),
        ``calc_force.nonzeros`` (what is not zero by structure), ``calc_force.bind`` (a call without
        arguments over the same arrays), ``calc_force.blocks`` (epochs side by side, see
        ``calc_force.to_lanes``).
        Input: increments, raw, resolved in the body frame.
        The attitude is that at the start of the interval; rotation correction half, sculling none.
        Angles are with respect to inertial space; the rotation of the navigation frame over one
        interval is neglected.
        Output: specific force.
        Source: Savage 1998 part 2; Titterton and Weston 11.4; NavToolkit calc_force_ned.
        """
    def bind(
        self,
        *,
        dcm: ArrayLike,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: CalcForceResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], CalcForceResult]: ...
    def value(
        self,
        *,
        dcm: ArrayLike,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def jacobian(
        self,
        *,
        dcm: ArrayLike,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array, _Array, _Array]: ...
    def nonzeros(
        self,
        *,
        dcm: ArrayLike,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array, _Array, _Array]: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        *,
        dcm: ArrayLike,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        *,
        dcm: ArrayLike,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

calc_force: _Calc_Force

class ForceResult(NamedTuple):
    value: _Array
    jacobian: _Array
    jacobian_delta_theta: _Array
    jacobian_delta_velocity: _Array
    jacobian_dt: _Array
    status: Any

class _Force(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    jacobian_delta_theta_rows: NDArray[np.int32]
    jacobian_delta_theta_columns: NDArray[np.int32]
    jacobian_delta_velocity_rows: NDArray[np.int32]
    jacobian_delta_velocity_columns: NDArray[np.int32]
    jacobian_dt_rows: NDArray[np.int32]
    jacobian_dt_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: ForceResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> ForceResult:
        """Specific force corrected for rotation and sculling.

            f = C (dv + c2 theta x dv + c3 theta x (theta x dv) + S) / dt

        Parameters
        ----------
        x : array_like, shape (..., 16)
            - [0:3] position (m, frame n, not read)
            - [3:6] velocity (m/s, frame n, not read)
            - [6:10] attitude (map s -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame s, range [-1, 1])
            - [13:16] gyro_bias (rad/s, frame s, range [-0.1, 0.1])
        delta_theta : array_like, shape (..., 3)
            Angle increments, oldest sub-sample first; rad, frame s, range [-0.5, 0.5]; elements x y
            z.
        delta_velocity : array_like, shape (..., 3)
            Velocity increments, oldest sub-sample first; m/s, frame s, range [-50, 50]; elements x
            y z.
        dt : array_like, shape (...)
            Length of the interval; s, range [1e-5, 0.05].
        out : ForceResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        ForceResult
            value : array, shape (..., 3), m/s^2, frame n
                Value of the equation.
            jacobian : array, shape (..., 3, 15)
                Derivative of the value by the error of the state.
                Columns: position[3] velocity[3] attitude[3] accelerometer_bias[3] gyro_bias[3].
            jacobian_delta_theta : array, shape (..., 3, 3)
                Derivative of the value by delta_theta.
                Columns: delta_theta[3].
            jacobian_delta_velocity : array, shape (..., 3, 3)
                Derivative of the value by delta_velocity.
                Columns: delta_velocity[3].
            jacobian_dt : array, shape (..., 3, 1)
                Derivative of the value by dt.
                Columns: dt[1].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``force.value`` (value), ``force.jacobian`` (jacobian,
        jacobian_delta_theta, jacobian_delta_velocity, jacobian_dt), ``force.nonzeros`` (what is not
        zero by structure), ``force.bind`` (a call without arguments over the same arrays),
        ``force.blocks`` (epochs side by side, see ``force.to_lanes``).
        Input: increments, raw, resolved in the body frame.
        The attitude is that at the start of the interval; rotation correction half, sculling none.
        Angles are with respect to inertial space; the rotation of the navigation frame over one
        interval is neglected.
        Output: specific force.
        Source: Savage 1998 part 2; Titterton and Weston 11.4; NavToolkit calc_force_ned.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: ForceResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], ForceResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array, _Array, _Array]: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array, _Array, _Array]: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

force: _Force

class StateBlocks(NamedTuple):
    position: _Array
    velocity: _Array
    attitude: _Array
    accelerometer_bias: _Array
    gyro_bias: _Array

class _Vector:
    size: int
    names: tuple[str, ...]
    labels: tuple[str, ...]
    units: Mapping[str, str]
    frames: Mapping[str, str]
    slices: Mapping[str, slice]
    position: slice
    velocity: slice
    attitude: slice
    accelerometer_bias: slice
    gyro_bias: slice

class _State(_Vector):
    error: _Vector
    error_size: int
    digest: str
    initial: _Array
    conventions: Mapping[str, str]
    def pack(
        self,
        *,
        position: ArrayLike = ...,
        velocity: ArrayLike = ...,
        attitude: ArrayLike = ...,
        accelerometer_bias: ArrayLike = ...,
        gyro_bias: ArrayLike = ...,
    ) -> _Array: ...
    def unpack(self, x: ArrayLike) -> StateBlocks: ...
    def retract(self, x: ArrayLike, d: ArrayLike) -> _Array: ...
    def local(self, x: ArrayLike, y: ArrayLike) -> _Array: ...

State: _State
