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
        x : array_like, shape (..., 18)
            - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
              plane
            - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
            - [4:7] dv (m/s, frame n, range [-1e9, 1e9]): Velocity
            - [7] b_u_dot (m/s, range [-1e9, 1e9]): Receiver clock drift
            - [8:12] drho (map b -> n, unit quaternion w x y z): Attitude, whose error the book
              calls rho
            - [12:15] x_a (m/s^2, frame b, range [-1e9, 1e9]): Accelerometer bias
            - [15:18] x_g (rad/s, frame b, range [-1e9, 1e9]): Gyro bias
        d : array_like, shape (..., 17)
            - [0:3] dp (m, frame n, range [-1e9, 1e9]): Error of dp
            - [3] b_u (m, range [-1e9, 1e9]): Error of b_u
            - [4:7] dv (m/s, frame n, range [-1e9, 1e9]): Error of dv
            - [7] b_u_dot (m/s, range [-1e9, 1e9]): Error of b_u_dot
            - [8:11] drho (rad, frame n, range [-6, 6]): Error of drho
            - [11:14] x_a (m/s^2, frame b, range [-1e9, 1e9]): Error of x_a
            - [14:17] x_g (rad/s, frame b, range [-1e9, 1e9]): Error of x_g
        out : RetractResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        RetractResult
            value : array, shape (..., 18)
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
        Products of unit quaternions drift from unit norm by rounding (drho): renormalise after
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
        x : array_like, shape (..., 18)
            - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
              plane
            - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
            - [4:7] dv (m/s, frame n, range [-1e9, 1e9]): Velocity
            - [7] b_u_dot (m/s, range [-1e9, 1e9]): Receiver clock drift
            - [8:12] drho (map b -> n, unit quaternion w x y z): Attitude, whose error the book
              calls rho
            - [12:15] x_a (m/s^2, frame b, range [-1e9, 1e9]): Accelerometer bias
            - [15:18] x_g (rad/s, frame b, range [-1e9, 1e9]): Gyro bias
        y : array_like, shape (..., 18)
            - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
              plane
            - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
            - [4:7] dv (m/s, frame n, range [-1e9, 1e9]): Velocity
            - [7] b_u_dot (m/s, range [-1e9, 1e9]): Receiver clock drift
            - [8:12] drho (map b -> n, unit quaternion w x y z): Attitude, whose error the book
              calls rho
            - [12:15] x_a (m/s^2, frame b, range [-1e9, 1e9]): Accelerometer bias
            - [15:18] x_g (rad/s, frame b, range [-1e9, 1e9]): Gyro bias
        out : LocalResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        LocalResult
            value : array, shape (..., 17)
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

class PseudorangeResult(NamedTuple):
    value: _Array
    residual: _Array
    jacobian: _Array
    status: Any
    item_status: NDArray[np.uint8]

class _Pseudorange(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        satellite_position: ArrayLike,
        measured: ArrayLike,
        out: PseudorangeResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> PseudorangeResult:
        """Pseudoranges from the antenna to satellites.

            rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 18)
            - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
              plane
            - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
            - [4:7] dv (m/s, frame n, not read): Velocity
            - [7] b_u_dot (m/s, not read): Receiver clock drift
            - [8:12] drho (map b -> n, not read): Attitude, whose error the book calls rho
            - [12:15] x_a (m/s^2, frame b, not read): Accelerometer bias
            - [15:18] x_g (rad/s, frame b, not read): Gyro bias
        c_n_e : array_like, shape (..., 9)
            Attitude of the navigation frame in the earth-fixed frame; map n -> e, rotation matrix,
            row by row.
        origin : array_like, shape (..., 3)
            Origin of the navigation frame, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y
            z.
        satellite_position : array_like, shape (..., n, 3)
            Satellite, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y z.
        measured : array_like, shape (..., n)
            Measured value; m, range [-1e9, 1e9].
        out : PseudorangeResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        PseudorangeResult
            value : array, shape (..., n), m
                Value of the equation.
            residual : array, shape (..., n), m
                Measured less predicted value.
            jacobian : array, shape (..., n, 17)
                Derivative of the value by the error of the state.
                Columns: dp[3] b_u[1] dv[3] b_u_dot[1] drho[3] x_a[3] x_g[3].
            status : Status for one epoch, array of them over leading axes
            item_status : array, shape (..., n)
                Status of every item; one that fails has zero rows and makes its epoch PARTIAL.

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``pseudorange.value`` (value, residual),
        ``pseudorange.jacobian`` (jacobian), ``pseudorange.nonzeros`` (what is not zero by
        structure), ``pseudorange.bind`` (a call without arguments over the same arrays),
        ``pseudorange.single_difference`` (less the item ``reference``).
        At most 32 items.
        h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of
        the range by the antenna position.
        No earth rotation: the satellite is given in the axes at reception.
        A positive receiver clock bias and every delay lengthen the pseudorange; a positive
        satellite clock shortens it.
        Source: Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        satellite_position: ArrayLike,
        measured: ArrayLike,
        out: PseudorangeResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], PseudorangeResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        satellite_position: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        satellite_position: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        satellite_position: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def single_difference(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        satellite_position: ArrayLike,
        measured: ArrayLike,
        reference: int,
        out: PseudorangeResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> PseudorangeResult: ...
    def difference_matrix(self, count: int, reference: int) -> _Array: ...
    def difference_covariance(self, sigma: ArrayLike, reference: int) -> _Array: ...

pseudorange: _Pseudorange

class PseudorangeLeverArmResult(NamedTuple):
    value: _Array
    jacobian: _Array
    status: Any
    item_status: NDArray[np.uint8]

class _Pseudorange_Lever_Arm(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        lever_arm: ArrayLike,
        satellite_position: ArrayLike,
        out: PseudorangeLeverArmResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> PseudorangeLeverArmResult:
        """Pseudoranges from the antenna to satellites.

            rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 18)
            - [0:3] dp (m, frame n, range [-1e6, 1e6]): Position from the origin of the tangent
              plane
            - [3] b_u (m, range [-1e8, 1e8]): Receiver clock bias
            - [4:7] dv (m/s, frame n, not read): Velocity
            - [7] b_u_dot (m/s, not read): Receiver clock drift
            - [8:12] drho (map b -> n, unit quaternion w x y z): Attitude, whose error the book
              calls rho
            - [12:15] x_a (m/s^2, frame b, not read): Accelerometer bias
            - [15:18] x_g (rad/s, frame b, not read): Gyro bias
        c_n_e : array_like, shape (..., 9)
            Attitude of the navigation frame in the earth-fixed frame; map n -> e, rotation matrix,
            row by row.
        origin : array_like, shape (..., 3)
            Origin of the navigation frame, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y
            z.
        lever_arm : array_like, shape (..., 3)
            Antenna from the body origin, in the body frame; m, frame b, range [-100, 100]; elements
            x y z.
        satellite_position : array_like, shape (..., n, 3)
            Satellite, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y z.
        out : PseudorangeLeverArmResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        PseudorangeLeverArmResult
            value : array, shape (..., n), m
                Value of the equation.
            jacobian : array, shape (..., n, 17)
                Derivative of the value by the error of the state.
                Columns: dp[3] b_u[1] dv[3] b_u_dot[1] drho[3] x_a[3] x_g[3].
            status : Status for one epoch, array of them over leading axes
            item_status : array, shape (..., n)
                Status of every item; one that fails has zero rows and makes its epoch PARTIAL.

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``pseudorange_lever_arm.value`` (value),
        ``pseudorange_lever_arm.jacobian`` (jacobian), ``pseudorange_lever_arm.nonzeros`` (what is
        not zero by structure), ``pseudorange_lever_arm.bind`` (a call without arguments over the
        same arrays), ``pseudorange_lever_arm.single_difference`` (less the item ``reference``).
        At most 32 items.
        h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of
        the range by the antenna position.
        No earth rotation: the satellite is given in the axes at reception.
        A positive receiver clock bias and every delay lengthen the pseudorange; a positive
        satellite clock shortens it.
        Source: Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        lever_arm: ArrayLike,
        satellite_position: ArrayLike,
        out: PseudorangeLeverArmResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], PseudorangeLeverArmResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        lever_arm: ArrayLike,
        satellite_position: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        lever_arm: ArrayLike,
        satellite_position: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        lever_arm: ArrayLike,
        satellite_position: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def single_difference(
        self,
        x: ArrayLike,
        /,
        *,
        c_n_e: ArrayLike,
        origin: ArrayLike,
        lever_arm: ArrayLike,
        satellite_position: ArrayLike,
        reference: int,
        out: PseudorangeLeverArmResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> PseudorangeLeverArmResult: ...
    def difference_matrix(self, count: int, reference: int) -> _Array: ...
    def difference_covariance(self, sigma: ArrayLike, reference: int) -> _Array: ...

pseudorange_lever_arm: _Pseudorange_Lever_Arm

class StateBlocks(NamedTuple):
    dp: _Array
    b_u: _Array
    dv: _Array
    b_u_dot: _Array
    drho: _Array
    x_a: _Array
    x_g: _Array

class _Vector:
    size: int
    names: tuple[str, ...]
    labels: tuple[str, ...]
    units: Mapping[str, str]
    frames: Mapping[str, str]
    slices: Mapping[str, slice]
    dp: slice
    b_u: slice
    dv: slice
    b_u_dot: slice
    drho: slice
    x_a: slice
    x_g: slice

class _State(_Vector):
    error: _Vector
    error_size: int
    digest: str
    initial: _Array
    conventions: Mapping[str, str]
    def pack(
        self,
        *,
        dp: ArrayLike = ...,
        b_u: ArrayLike = ...,
        dv: ArrayLike = ...,
        b_u_dot: ArrayLike = ...,
        drho: ArrayLike = ...,
        x_a: ArrayLike = ...,
        x_g: ArrayLike = ...,
    ) -> _Array: ...
    def unpack(self, x: ArrayLike) -> StateBlocks: ...
    def retract(self, x: ArrayLike, d: ArrayLike) -> _Array: ...
    def local(self, x: ArrayLike, y: ArrayLike) -> _Array: ...

State: _State
