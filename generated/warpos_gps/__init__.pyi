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
        x : array_like, shape (..., 15)
            - [0:4] leading (range [-1e9, 1e9])
            - [4:7] position (m, frame f, range [-1e9, 1e9])
            - [7:15] trailing (range [-1e9, 1e9])
        d : array_like, shape (..., 15)
            - [0:4] leading (range [-1e9, 1e9]): Error of leading
            - [4:7] position (m, frame f, range [-1e9, 1e9]): Error of position
            - [7:15] trailing (range [-1e9, 1e9]): Error of trailing
        out : RetractResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        RetractResult
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
        Other forms, with the same arguments: ``retract.value`` (value), ``retract.bind`` (a call
        without arguments over the same arrays), ``retract.blocks`` (epochs side by side, see
        ``retract.to_lanes``).
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
        x : array_like, shape (..., 15)
            - [0:4] leading (range [-1e9, 1e9])
            - [4:7] position (m, frame f, range [-1e9, 1e9])
            - [7:15] trailing (range [-1e9, 1e9])
        y : array_like, shape (..., 15)
            - [0:4] leading (range [-1e9, 1e9])
            - [4:7] position (m, frame f, range [-1e9, 1e9])
            - [7:15] trailing (range [-1e9, 1e9])
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

class MeasurementResult(NamedTuple):
    value: _Array
    jacobian: _Array
    status: Any

class _Measurement(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        out: MeasurementResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> MeasurementResult:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 15)
            - [0:4] leading (not read)
            - [4:7] position (m, frame f, range [-1e9, 1e9])
            - [7:15] trailing (not read)
        out : MeasurementResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        MeasurementResult
            value : array, shape (..., 3), m, frame f
                Value of the equation.
            jacobian : array, shape (..., 3, 15)
                Derivative of the value by the error of the state.
                Columns: leading[4] position[3] trailing[8].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``measurement.value`` (value),
        ``measurement.jacobian`` (jacobian), ``measurement.nonzeros`` (what is not zero by
        structure), ``measurement.bind`` (a call without arguments over the same arrays),
        ``measurement.blocks`` (epochs side by side, see ``measurement.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        out: MeasurementResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], MeasurementResult]: ...
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

measurement: _Measurement

class MeasurementByColumnResult(NamedTuple):
    value: _Array
    jacobian: _Array
    status: Any

class _Measurement_By_Column(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        out: MeasurementByColumnResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> MeasurementByColumnResult:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 15)
            - [0:4] leading (not read)
            - [4:7] position (m, frame f, range [-1e9, 1e9])
            - [7:15] trailing (not read)
        out : MeasurementByColumnResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        MeasurementByColumnResult
            value : array, shape (..., 3), m, frame f
                Value of the equation.
            jacobian : array, shape (..., 3, 15)
                Derivative of the value by the error of the state.
                Columns: leading[4] position[3] trailing[8].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``measurement_by_column.value`` (value),
        ``measurement_by_column.jacobian`` (jacobian), ``measurement_by_column.nonzeros`` (what is
        not zero by structure), ``measurement_by_column.bind`` (a call without arguments over the
        same arrays), ``measurement_by_column.blocks`` (epochs side by side, see
        ``measurement_by_column.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        out: MeasurementByColumnResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], MeasurementByColumnResult]: ...
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

measurement_by_column: _Measurement_By_Column

class ObservedResult(NamedTuple):
    value: _Array
    jacobian: _Array
    status: Any

class _Observed(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        out: ObservedResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> ObservedResult:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 15)
            - [0:4] leading (not read)
            - [4:7] position (m, frame f, range [-1e9, 1e9])
            - [7:15] trailing (not read)
        observer_attitude : array_like, shape (..., 4)
            C, attitude of the observer's frame; map ref -> f, unit quaternion w x y z.
        out : ObservedResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        ObservedResult
            value : array, shape (..., 3), m, frame ref
                Value of the equation.
            jacobian : array, shape (..., 3, 15)
                Derivative of the value by the error of the state.
                Columns: leading[4] position[3] trailing[8].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``observed.value`` (value), ``observed.jacobian``
        (jacobian), ``observed.nonzeros`` (what is not zero by structure), ``observed.bind`` (a call
        without arguments over the same arrays), ``observed.blocks`` (epochs side by side, see
        ``observed.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        out: ObservedResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], ObservedResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
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
        observer_attitude: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

observed: _Observed

class ObservedByColumnResult(NamedTuple):
    value: _Array
    jacobian: _Array
    status: Any

class _Observed_By_Column(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        out: ObservedByColumnResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> ObservedByColumnResult:
        """Position of a GNSS antenna.

            z = origin + C (offset + p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 15)
            - [0:4] leading (not read)
            - [4:7] position (m, frame f, range [-1e9, 1e9])
            - [7:15] trailing (not read)
        observer_attitude : array_like, shape (..., 4)
            C, attitude of the observer's frame; map ref -> f, unit quaternion w x y z.
        out : ObservedByColumnResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        ObservedByColumnResult
            value : array, shape (..., 3), m, frame ref
                Value of the equation.
            jacobian : array, shape (..., 3, 15)
                Derivative of the value by the error of the state.
                Columns: leading[4] position[3] trailing[8].
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``observed_by_column.value`` (value),
        ``observed_by_column.jacobian`` (jacobian), ``observed_by_column.nonzeros`` (what is not
        zero by structure), ``observed_by_column.bind`` (a call without arguments over the same
        arrays), ``observed_by_column.blocks`` (epochs side by side, see
        ``observed_by_column.to_lanes``).
        The lever arm points from the body origin to the antenna, resolved in the body frame.
        C and R are used in the direction their declared maps and the frames of the vectors need.
        Source: WarpTwin GPSMeasurements documentation; ekf_cal documentation, GPS filtering.
        """
    def bind(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        out: ObservedByColumnResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], ObservedByColumnResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
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
        observer_attitude: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        x: ArrayLike,
        /,
        *,
        observer_attitude: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

observed_by_column: _Observed_By_Column

class ToStateFrameResult(NamedTuple):
    value: _Array
    value_covariance: _Array
    status: Any

class _To_State_Frame(Protocol):
    def __call__(
        self,
        *,
        observer_attitude: ArrayLike,
        receiver_position: ArrayLike,
        origin_offset: ArrayLike,
        attitude: ArrayLike,
        lever_arm: ArrayLike,
        covariance: ArrayLike,
        out: ToStateFrameResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> ToStateFrameResult:
        """Receiver position transformed to the state's frame and origin.

            pos_B_F__F = R_F_REF pos_GPS_I__REF - pos_F_I__F - R_F_B pos_GPS_B__B

        Parameters
        ----------
        observer_attitude : array_like, shape (..., 4)
            C, attitude of the observer's frame; map ref -> f, unit quaternion w x y z.
        receiver_position : array_like, shape (..., 3)
            Fix of the receiver in its reporting frame (pos_GPS_I__REF); m, frame ref, range [-1e9,
            1e9]; elements x y z.
        origin_offset : array_like, shape (..., 3)
            Origin of the state frame from the reporting frame's, in the state frame (pos_F_I__F);
            m, frame f, range [-1e9, 1e9]; elements x y z.
        attitude : array_like, shape (..., 4)
            Attitude of the body (quat_F_B); map body -> f, unit quaternion w x y z.
        lever_arm : array_like, shape (..., 3)
            Antenna from the body origin, in the body frame; m, frame body, range [-100, 100];
            elements x y z.
        covariance : array_like, shape (..., 9)
            Covariance of the fix, row-major; m^2, range [-1e12, 1e12].
        out : ToStateFrameResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        ToStateFrameResult
            value : array, shape (..., 3), m, frame f
                Value of the equation.
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
        Other forms, with the same arguments: ``to_state_frame.value`` (value, value_covariance),
        ``to_state_frame.bind`` (a call without arguments over the same arrays),
        ``to_state_frame.blocks`` (epochs side by side, see ``to_state_frame.to_lanes``).
        The covariance leaves out the uncertainty of the attitude that rotates the lever arm; where
        the attitude is estimated, prefer gnss_position with a lever arm.
        Source: WarpTwin GPSMeasurements documentation, note on the measurement.
        """
    def bind(
        self,
        *,
        observer_attitude: ArrayLike,
        receiver_position: ArrayLike,
        origin_offset: ArrayLike,
        attitude: ArrayLike,
        lever_arm: ArrayLike,
        covariance: ArrayLike,
        out: ToStateFrameResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], ToStateFrameResult]: ...
    def value(
        self,
        *,
        observer_attitude: ArrayLike,
        receiver_position: ArrayLike,
        origin_offset: ArrayLike,
        attitude: ArrayLike,
        lever_arm: ArrayLike,
        covariance: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array]: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        *,
        observer_attitude: ArrayLike,
        receiver_position: ArrayLike,
        origin_offset: ArrayLike,
        attitude: ArrayLike,
        lever_arm: ArrayLike,
        covariance: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        *,
        observer_attitude: ArrayLike,
        receiver_position: ArrayLike,
        origin_offset: ArrayLike,
        attitude: ArrayLike,
        lever_arm: ArrayLike,
        covariance: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

to_state_frame: _To_State_Frame

class StateBlocks(NamedTuple):
    leading: _Array
    position: _Array
    trailing: _Array

class _Vector:
    size: int
    names: tuple[str, ...]
    labels: tuple[str, ...]
    units: Mapping[str, str]
    frames: Mapping[str, str]
    slices: Mapping[str, slice]
    leading: slice
    position: slice
    trailing: slice

class _State(_Vector):
    error: _Vector
    error_size: int
    digest: str
    initial: _Array
    conventions: Mapping[str, str]
    def pack(
        self, *, leading: ArrayLike = ..., position: ArrayLike = ..., trailing: ArrayLike = ...
    ) -> _Array: ...
    def unpack(self, x: ArrayLike) -> StateBlocks: ...
    def retract(self, x: ArrayLike, d: ArrayLike) -> _Array: ...
    def local(self, x: ArrayLike, y: ArrayLike) -> _Array: ...

State: _State
