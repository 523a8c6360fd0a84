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
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
            - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
            - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
            - [19:22] antenna (m, frame b, range [-50, 50])
        d : array_like, shape (..., 21)
            - [0:3] position (m, frame l, range [-1e9, 1e9]): Error of position
            - [3:6] velocity (m/s, frame l, range [-1e9, 1e9]): Error of velocity
            - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9]): Error of acceleration
            - [9:12] attitude (rad, frame b, range [-6, 6]): Error of attitude
            - [12:15] angular_rate (rad/s, frame l, range [-1e9, 1e9]): Error of angular_rate
            - [15:18] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9]): Error of
              angular_acceleration
            - [18:21] antenna (m, frame b, range [-1e9, 1e9]): Error of antenna
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
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
            - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
            - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
            - [19:22] antenna (m, frame b, range [-50, 50])
        y : array_like, shape (..., 22)
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, range [-1e9, 1e9])
            - [6:9] acceleration (m/s^2, frame l, range [-1e9, 1e9])
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, range [-1e9, 1e9])
            - [16:19] angular_acceleration (rad/s^2, frame l, range [-1e9, 1e9])
            - [19:22] antenna (m, frame b, range [-50, 50])
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
    residual: _Array
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
        measured: ArrayLike,
        out: GpsResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> GpsResult:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 22)
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, not read)
            - [6:9] acceleration (m/s^2, frame l, not read)
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, not read)
            - [16:19] angular_acceleration (rad/s^2, frame l, not read)
            - [19:22] antenna (m, frame b, range [-50, 50])
        measured : array_like, shape (..., 3)
            Measured value; m, frame l, range [-1e9, 1e9]; elements x y z.
        out : GpsResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        GpsResult
            value : array, shape (..., 3), m, frame l
                Value of the equation.
            residual : array, shape (..., 3), m, frame l
                Measured less predicted value.
            jacobian : array, shape (..., 3, 21)
                Derivative of the value by the error of the state.
                Columns: position[3] velocity[3] acceleration[3] attitude[3] angular_rate[3]
                angular_acceleration[3] antenna[3].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``gps.value`` (value, residual), ``gps.jacobian``
        (jacobian), ``gps.nonzeros`` (what is not zero by structure), ``gps.bind`` (a call without
        arguments over the same arrays), ``gps.blocks`` (epochs side by side, see ``gps.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        measured: ArrayLike,
        out: GpsResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], GpsResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        measured: ArrayLike,
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
        measured: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        measured: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

gps: _Gps

class GpsKnownAntennaResult(NamedTuple):
    value: _Array
    residual: _Array
    jacobian: _Array
    status: Any

class _Gps_Known_Antenna(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        lever_arm: ArrayLike,
        measured: ArrayLike,
        out: GpsKnownAntennaResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> GpsKnownAntennaResult:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 22)
            - [0:3] position (m, frame l, range [-1e6, 1e6])
            - [3:6] velocity (m/s, frame l, not read)
            - [6:9] acceleration (m/s^2, frame l, not read)
            - [9:13] attitude (map b -> l, unit quaternion w x y z)
            - [13:16] angular_rate (rad/s, frame l, not read)
            - [16:19] angular_acceleration (rad/s^2, frame l, not read)
            - [19:22] antenna (m, frame b, not read)
        lever_arm : array_like, shape (..., 3)
            Antenna from the body origin, in the body frame; m, frame b, range [-100, 100]; elements
            x y z.
        measured : array_like, shape (..., 3)
            Measured value; m, frame l, range [-1e9, 1e9]; elements x y z.
        out : GpsKnownAntennaResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        GpsKnownAntennaResult
            value : array, shape (..., 3), m, frame l
                Value of the equation.
            residual : array, shape (..., 3), m, frame l
                Measured less predicted value.
            jacobian : array, shape (..., 3, 21)
                Derivative of the value by the error of the state.
                Columns: position[3] velocity[3] acceleration[3] attitude[3] angular_rate[3]
                angular_acceleration[3] antenna[3].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``gps_known_antenna.value`` (value, residual),
        ``gps_known_antenna.jacobian`` (jacobian), ``gps_known_antenna.nonzeros`` (what is not zero
        by structure), ``gps_known_antenna.bind`` (a call without arguments over the same arrays),
        ``gps_known_antenna.blocks`` (epochs side by side, see ``gps_known_antenna.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        lever_arm: ArrayLike,
        measured: ArrayLike,
        out: GpsKnownAntennaResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], GpsKnownAntennaResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        lever_arm: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        lever_arm: ArrayLike,
        measured: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        lever_arm: ArrayLike,
        measured: ArrayLike,
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
        lever_arm: ArrayLike,
        measured: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        lever_arm: ArrayLike,
        measured: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

gps_known_antenna: _Gps_Known_Antenna

class LocalFixResult(NamedTuple):
    value: _Array
    jacobian_fix: _Array
    value_covariance: _Array
    status: Any

class _Local_Fix(Protocol):
    jacobian_fix_rows: NDArray[np.int32]
    jacobian_fix_columns: NDArray[np.int32]
    def __call__(
        self,
        *,
        heading: ArrayLike,
        fix: ArrayLike,
        reference: ArrayLike,
        covariance: ArrayLike,
        out: LocalFixResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> LocalFixResult:
        """Local-level position of a geodetic fix.

            p = C_e^n(reference) (ecef(fix) - ecef(reference))

        Parameters
        ----------
        heading : array_like, shape (...)
            Heading of the local frame; rad, map g -> l, range [-3.1416, 3.1416].
        fix : array_like, shape (..., 3)
            Latitude, longitude, height of the fix; rad, range [-1.5690509975429023,
            1.5690509975429023], [-3.1416, 3.1416], [-10000, 1e7]; elements latitude longitude
            height.
        reference : array_like, shape (..., 3)
            Latitude, longitude, height of the local origin; rad, range [-1.5690509975429023,
            1.5690509975429023], [-3.1416, 3.1416], [-10000, 1e7]; elements latitude longitude
            height.
        covariance : array_like, shape (..., 9)
            Covariance of latitude, longitude (rad^2), height (m^2), row-major; range [-1e12, 1e12].
        out : LocalFixResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        LocalFixResult
            value : array, shape (..., 3), m, frame l
                Value of the equation.
            jacobian_fix : array, shape (..., 3, 3)
                Derivative of the value by fix.
                Columns: fix[3].
            value_covariance : array, shape (..., 9), m^2
                Covariance of the value, row-major.
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``local_fix.value`` (value, value_covariance),
        ``local_fix.jacobian`` (jacobian_fix), ``local_fix.nonzeros`` (what is not zero by
        structure), ``local_fix.bind`` (a call without arguments over the same arrays),
        ``local_fix.blocks`` (epochs side by side, see ``local_fix.to_lanes``).
        Latitude and longitude in radians on WGS-84; the Jacobian by the fix, when asked for, is by
        latitude, longitude and height: the map of their noise.
        Local-level axes are enu at the reference.
        Source: Groves 2013, section 2.4; NIMA TR8350.2.
        """
    def bind(
        self,
        *,
        heading: ArrayLike,
        fix: ArrayLike,
        reference: ArrayLike,
        covariance: ArrayLike,
        out: LocalFixResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], LocalFixResult]: ...
    def value(
        self,
        *,
        heading: ArrayLike,
        fix: ArrayLike,
        reference: ArrayLike,
        covariance: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    def jacobian(
        self,
        *,
        heading: ArrayLike,
        fix: ArrayLike,
        reference: ArrayLike,
        covariance: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        *,
        heading: ArrayLike,
        fix: ArrayLike,
        reference: ArrayLike,
        covariance: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        *,
        heading: ArrayLike,
        fix: ArrayLike,
        reference: ArrayLike,
        covariance: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        *,
        heading: ArrayLike,
        fix: ArrayLike,
        reference: ArrayLike,
        covariance: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

local_fix: _Local_Fix

class StateBlocks(NamedTuple):
    position: _Array
    velocity: _Array
    acceleration: _Array
    attitude: _Array
    angular_rate: _Array
    angular_acceleration: _Array
    antenna: _Array

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
    antenna: slice

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
        antenna: ArrayLike = ...,
    ) -> _Array: ...
    def unpack(self, x: ArrayLike) -> StateBlocks: ...
    def retract(self, x: ArrayLike, d: ArrayLike) -> _Array: ...
    def local(self, x: ArrayLike, y: ArrayLike) -> _Array: ...

State: _State
