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
        x : array_like, shape (..., 26)
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
            - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
            - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
            - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
            - [20:23] antenna_1 (m, frame b, range [-50, 50])
            - [23:26] antenna_2 (m, frame b, range [-50, 50])
        d : array_like, shape (..., 25)
            - [0:3] position (m, frame l, range [-1e9, 1e9]): Error of position
            - [3:6] velocity (m/s, frame l, range [-1e9, 1e9]): Error of velocity
            - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9]): Error of acceleration
            - [9:12] attitude (rad, frame b, range [-6, 6]): Error of attitude
            - [12:15] angular_rate (rad/s, frame l, range [-1e9, 1e9]): Error of angular_rate
            - [15:18] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9]): Error of
              angular_acceleration
            - [18] heading (rad, range [-6, 6]): Error of heading
            - [19:22] antenna_1 (m, frame b, range [-1e9, 1e9]): Error of antenna_1
            - [22:25] antenna_2 (m, frame b, range [-1e9, 1e9]): Error of antenna_2
        out : RetractResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        RetractResult
            value : array, shape (..., 26)
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
        x : array_like, shape (..., 26)
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
            - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
            - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
            - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
            - [20:23] antenna_1 (m, frame b, range [-50, 50])
            - [23:26] antenna_2 (m, frame b, range [-50, 50])
        y : array_like, shape (..., 26)
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
            - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
            - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
            - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
            - [20:23] antenna_1 (m, frame b, range [-50, 50])
            - [23:26] antenna_2 (m, frame b, range [-50, 50])
        out : LocalResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        LocalResult
            value : array, shape (..., 25)
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

class Gps1Result(NamedTuple):
    value: _Array
    residual: _Array
    jacobian: _Array
    jacobian_origin: _Array
    status: Any

class _Gps_1(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    jacobian_origin_rows: NDArray[np.int32]
    jacobian_origin_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: Gps1Result | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Gps1Result:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 26)
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, not read)
            - [6:9] acceleration (m/s^2, frame l, not read)
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, not read)
            - [16:19] angular_acceleration (rad/s^2, frame l, not read)
            - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
            - [20:23] antenna_1 (m, frame b, range [-50, 50])
            - [23:26] antenna_2 (m, frame b, not read)
        origin : array_like, shape (..., 3)
            Position of the local frame's origin in the observer's frame (p_L^G); m, frame g, range
            [-1e7, 1e7]; elements x y z.
        measured : array_like, shape (..., 3)
            Measured value; m, frame g, range [-1e9, 1e9]; elements x y z.
        out : Gps1Result, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        Gps1Result
            value : array, shape (..., 3), m, frame g
                Value of the equation.
            residual : array, shape (..., 3), m, frame g
                Measured less predicted value.
            jacobian : array, shape (..., 3, 25)
                Derivative of the value by the error of the state.
                Columns: position[3] velocity[3] acceleration[3] attitude[3] angular_rate[3]
                angular_acceleration[3] heading[1] antenna_1[3] antenna_2[3].
            jacobian_origin : array, shape (..., 3, 3)
                Derivative of the value by origin.
                Columns: origin[3].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``gps_1.value`` (value, residual), ``gps_1.jacobian``
        (jacobian, jacobian_origin), ``gps_1.nonzeros`` (what is not zero by structure),
        ``gps_1.bind`` (a call without arguments over the same arrays), ``gps_1.blocks`` (epochs
        side by side, see ``gps_1.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: Gps1Result | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Gps1Result]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

gps_1: _Gps_1

class Gps2Result(NamedTuple):
    value: _Array
    residual: _Array
    jacobian: _Array
    jacobian_origin: _Array
    status: Any

class _Gps_2(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    jacobian_origin_rows: NDArray[np.int32]
    jacobian_origin_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: Gps2Result | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Gps2Result:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 26)
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, not read)
            - [6:9] acceleration (m/s^2, frame l, not read)
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, not read)
            - [16:19] angular_acceleration (rad/s^2, frame l, not read)
            - [19] heading (rad, map g -> l, range [-3.1416, 3.1416])
            - [20:23] antenna_1 (m, frame b, not read)
            - [23:26] antenna_2 (m, frame b, range [-50, 50])
        origin : array_like, shape (..., 3)
            Position of the local frame's origin in the observer's frame (p_L^G); m, frame g, range
            [-1e7, 1e7]; elements x y z.
        measured : array_like, shape (..., 3)
            Measured value; m, frame g, range [-1e9, 1e9]; elements x y z.
        out : Gps2Result, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        Gps2Result
            value : array, shape (..., 3), m, frame g
                Value of the equation.
            residual : array, shape (..., 3), m, frame g
                Measured less predicted value.
            jacobian : array, shape (..., 3, 25)
                Derivative of the value by the error of the state.
                Columns: position[3] velocity[3] acceleration[3] attitude[3] angular_rate[3]
                angular_acceleration[3] heading[1] antenna_1[3] antenna_2[3].
            jacobian_origin : array, shape (..., 3, 3)
                Derivative of the value by origin.
                Columns: origin[3].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``gps_2.value`` (value, residual), ``gps_2.jacobian``
        (jacobian, jacobian_origin), ``gps_2.nonzeros`` (what is not zero by structure),
        ``gps_2.bind`` (a call without arguments over the same arrays), ``gps_2.blocks`` (epochs
        side by side, see ``gps_2.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: Gps2Result | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Gps2Result]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        origin: ArrayLike,
        measured: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

gps_2: _Gps_2

class StateBlocks(NamedTuple):
    position: _Array
    velocity: _Array
    acceleration: _Array
    attitude: _Array
    angular_rate: _Array
    angular_acceleration: _Array
    heading: _Array
    antenna_1: _Array
    antenna_2: _Array

class _Vector:
    size: int
    names: tuple[str, ...]
    labels: tuple[str, ...]
    units: Mapping[str, str]
    frames: Mapping[str, str]
    slices: Mapping[str, slice]
    position: slice
    velocity: slice
    acceleration: slice
    attitude: slice
    angular_rate: slice
    angular_acceleration: slice
    heading: slice
    antenna_1: slice
    antenna_2: slice

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
        acceleration: ArrayLike = ...,
        attitude: ArrayLike = ...,
        angular_rate: ArrayLike = ...,
        angular_acceleration: ArrayLike = ...,
        heading: ArrayLike = ...,
        antenna_1: ArrayLike = ...,
        antenna_2: ArrayLike = ...,
    ) -> _Array: ...
    def unpack(self, x: ArrayLike) -> StateBlocks: ...
    def retract(self, x: ArrayLike, d: ArrayLike) -> _Array: ...
    def local(self, x: ArrayLike, y: ArrayLike) -> _Array: ...

State: _State
