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
        x : array_like, shape (..., 22)
            - [0:3] position (m, frame n, range [-100000, 100000])
            - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
            - [6:10] attitude (map b -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame b, range [-1, 1])
            - [13:16] gyro_bias (rad/s, frame b, range [-0.1, 0.1])
            - [16:19] antenna (m, frame b, range [-10, 10])
            - [19] b_gps (m, range [-1e6, 1e6])
            - [20] b_galileo (m, range [-1e6, 1e6])
            - [21] drift (m/s, range [-1e9, 1e9])
        d : array_like, shape (..., 21)
            - [0:3] position (m, frame n, range [-1e9, 1e9]): Error of position
            - [3:6] velocity (m/s, frame n, range [-1e9, 1e9]): Error of velocity
            - [6:9] attitude (rad, frame b, range [-6, 6]): Error of attitude
            - [9:12] accelerometer_bias (m/s^2, frame b, range [-1e9, 1e9]): Error of
              accelerometer_bias
            - [12:15] gyro_bias (rad/s, frame b, range [-1e9, 1e9]): Error of gyro_bias
            - [15:18] antenna (m, frame b, range [-1e9, 1e9]): Error of antenna
            - [18] b_gps (m, range [-1e9, 1e9]): Error of b_gps
            - [19] b_galileo (m, range [-1e9, 1e9]): Error of b_galileo
            - [20] drift (m/s, range [-1e9, 1e9]): Error of drift
        out : RetractResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        RetractResult
            value : array, shape (..., 22)
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
        x : array_like, shape (..., 22)
            - [0:3] position (m, frame n, range [-100000, 100000])
            - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
            - [6:10] attitude (map b -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame b, range [-1, 1])
            - [13:16] gyro_bias (rad/s, frame b, range [-0.1, 0.1])
            - [16:19] antenna (m, frame b, range [-10, 10])
            - [19] b_gps (m, range [-1e6, 1e6])
            - [20] b_galileo (m, range [-1e6, 1e6])
            - [21] drift (m/s, range [-1e9, 1e9])
        y : array_like, shape (..., 22)
            - [0:3] position (m, frame n, range [-100000, 100000])
            - [3:6] velocity (m/s, frame n, range [-1e9, 1e9])
            - [6:10] attitude (map b -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame b, range [-1, 1])
            - [13:16] gyro_bias (rad/s, frame b, range [-0.1, 0.1])
            - [16:19] antenna (m, frame b, range [-10, 10])
            - [19] b_gps (m, range [-1e6, 1e6])
            - [20] b_galileo (m, range [-1e6, 1e6])
            - [21] drift (m/s, range [-1e9, 1e9])
        out : LocalResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        LocalResult
            value : array, shape (..., 21)
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

class GpsResult(NamedTuple):
    value: _Array
    jacobian: _Array
    status: Any

class _Gps(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        out: GpsResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> GpsResult:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 22)
            - [0:3] position (m, frame n, range [-100000, 100000])
            - [3:6] velocity (m/s, frame n, not read)
            - [6:10] attitude (map b -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame b, not read)
            - [13:16] gyro_bias (rad/s, frame b, not read)
            - [16:19] antenna (m, frame b, range [-10, 10])
            - [19] b_gps (m, not read)
            - [20] b_galileo (m, not read)
            - [21] drift (m/s, not read)
        out : GpsResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        GpsResult
            value : array, shape (..., 3), m, frame n
                Value of the equation.
            jacobian : array, shape (..., 3, 21)
                Derivative of the value by the error of the state.
                Columns: position[3] velocity[3] attitude[3] accelerometer_bias[3] gyro_bias[3]
                antenna[3] b_gps[1] b_galileo[1] drift[1].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``gps.value`` (value), ``gps.jacobian`` (jacobian),
        ``gps.nonzeros`` (what is not zero by structure), ``gps.bind`` (a call without arguments
        over the same arrays), ``gps.blocks`` (epochs side by side, see ``gps.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        out: GpsResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], GpsResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
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
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

gps: _Gps

class RangeResult(NamedTuple):
    value: _Array
    residual: _Array
    jacobian: _Array
    status: Any
    item_status: NDArray[np.uint8]

class _Range(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        nav_to_ecef: ArrayLike,
        origin: ArrayLike,
        system: ArrayLike,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        measured: ArrayLike,
        out: RangeResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> RangeResult:
        """Pseudoranges from the antenna to satellites.

            rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 22)
            - [0:3] position (m, frame n, range [-100000, 100000])
            - [3:6] velocity (m/s, frame n, not read)
            - [6:10] attitude (map b -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame b, not read)
            - [13:16] gyro_bias (rad/s, frame b, not read)
            - [16:19] antenna (m, frame b, range [-10, 10])
            - [19] b_gps (m, range [-1e6, 1e6])
            - [20] b_galileo (m, range [-1e6, 1e6])
            - [21] drift (m/s, not read)
        nav_to_ecef : array_like, shape (..., 4)
            Attitude of the navigation frame in the earth-fixed frame; map n -> ecef, unit
            quaternion w x y z.
        origin : array_like, shape (..., 3)
            Origin of the navigation frame, earth-fixed; m, frame ecef, range [-1e8, 1e8]; elements
            x y z.
        system : integers, shape (..., n)
            Satellite system: 0 gps, 1 galileo; range [0, 1].
        satellite_position : array_like, shape (..., n, 3)
            Satellite, earth-fixed; m, frame ecef, range [-1e8, 1e8]; elements x y z.
        satellite_clock : array_like, shape (..., n)
            Satellite clock offset; s, range [-0.1, 0.1].
        troposphere : array_like, shape (..., n)
            Tropospheric delay; m, range [-100, 1000].
        ionosphere : array_like, shape (..., n)
            Ionospheric delay; m, range [-1000, 1000].
        measured : array_like, shape (..., n)
            Measured value; m, range [-1e9, 1e9].
        out : RangeResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        RangeResult
            value : array, shape (..., n), m
                Value of the equation.
            residual : array, shape (..., n), m
                Measured less predicted value.
            jacobian : array, shape (..., n, 21)
                Derivative of the value by the error of the state.
                Columns: position[3] velocity[3] attitude[3] accelerometer_bias[3] gyro_bias[3]
                antenna[3] b_gps[1] b_galileo[1] drift[1].
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
        Other forms, with the same arguments: ``range.value`` (value, residual), ``range.jacobian``
        (jacobian), ``range.nonzeros`` (what is not zero by structure), ``range.bind`` (a call
        without arguments over the same arrays).
        At most 32 items.
        h is the unit vector from the satellite to the receiver (Farrell 3.45): the derivative of
        the range by the antenna position.
        Earth rotation by the first-order term (w/c)(s_x a_y - s_y a_x); the satellite is given in
        the axes at transmission.
        A positive receiver clock bias and every delay lengthen the pseudorange; a positive
        satellite clock shortens it.
        Source: Farrell, Autonomous Mobile Robots ch. 3, (3.44); IS-GPS-200, 20.3.3.4.3.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        nav_to_ecef: ArrayLike,
        origin: ArrayLike,
        system: ArrayLike,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        measured: ArrayLike,
        out: RangeResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], RangeResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        nav_to_ecef: ArrayLike,
        origin: ArrayLike,
        system: ArrayLike,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        nav_to_ecef: ArrayLike,
        origin: ArrayLike,
        system: ArrayLike,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        nav_to_ecef: ArrayLike,
        origin: ArrayLike,
        system: ArrayLike,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...

range: _Range

class ImuResult(NamedTuple):
    value: _Array
    jacobian: _Array
    status: Any

class _Imu(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
        out: ImuResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> ImuResult:
        """Specific force corrected for rotation and sculling.

            f = C (dv + c2 theta x dv + c3 theta x (theta x dv) + S) / dt

        Parameters
        ----------
        x : array_like, shape (..., 22)
            - [0:3] position (m, frame n, not read)
            - [3:6] velocity (m/s, frame n, not read)
            - [6:10] attitude (map b -> n, unit quaternion w x y z)
            - [10:13] accelerometer_bias (m/s^2, frame b, range [-1, 1])
            - [13:16] gyro_bias (rad/s, frame b, range [-0.1, 0.1])
            - [16:19] antenna (m, frame b, not read)
            - [19] b_gps (m, not read)
            - [20] b_galileo (m, not read)
            - [21] drift (m/s, not read)
        delta_theta : array_like, shape (..., 6)
            Angle increments, oldest sub-sample first; rad, frame b, range [-0.5, 0.5].
        delta_velocity : array_like, shape (..., 6)
            Velocity increments, oldest sub-sample first; m/s, frame b, range [-50, 50].
        dt : array_like, shape (...)
            Length of the interval; s, range [1e-5, 0.05].
        out : ImuResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        ImuResult
            value : array, shape (..., 3), m/s^2, frame n
                Value of the equation.
            jacobian : array, shape (..., 3, 21)
                Derivative of the value by the error of the state.
                Columns: position[3] velocity[3] attitude[3] accelerometer_bias[3] gyro_bias[3]
                antenna[3] b_gps[1] b_galileo[1] drift[1].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``imu.value`` (value), ``imu.jacobian`` (jacobian),
        ``imu.nonzeros`` (what is not zero by structure), ``imu.bind`` (a call without arguments
        over the same arrays), ``imu.blocks`` (epochs side by side, see ``imu.to_lanes``).
        Input: increments, raw, resolved in the body frame.
        The attitude is that at the start of the interval; rotation correction half, sculling
        polynomial.
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
        out: ImuResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], ImuResult]: ...
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
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        delta_theta: ArrayLike,
        delta_velocity: ArrayLike,
        dt: ArrayLike,
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

imu: _Imu

class StateBlocks(NamedTuple):
    position: _Array
    velocity: _Array
    attitude: _Array
    accelerometer_bias: _Array
    gyro_bias: _Array
    antenna: _Array
    b_gps: _Array
    b_galileo: _Array
    drift: _Array

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
    antenna: slice
    b_gps: slice
    b_galileo: slice
    drift: slice

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
        antenna: ArrayLike = ...,
        b_gps: ArrayLike = ...,
        b_galileo: ArrayLike = ...,
        drift: ArrayLike = ...,
    ) -> _Array: ...
    def unpack(self, x: ArrayLike) -> StateBlocks: ...
    def retract(self, x: ArrayLike, d: ArrayLike) -> _Array: ...
    def local(self, x: ArrayLike, y: ArrayLike) -> _Array: ...

State: _State
