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
        x : array_like, shape (..., 4)
            - [0:3] position (m, frame e, range [-1e7, 1e7])
            - [3] clock_bias (m, range [-1e8, 1e8])
        d : array_like, shape (..., 4)
            - [0:3] position (m, frame e, range [-1e9, 1e9]): Error of position
            - [3] clock_bias (m, range [-1e9, 1e9]): Error of clock_bias
        out : RetractResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        RetractResult
            value : array, shape (..., 4)
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
        x : array_like, shape (..., 4)
            - [0:3] position (m, frame e, range [-1e7, 1e7])
            - [3] clock_bias (m, range [-1e8, 1e8])
        y : array_like, shape (..., 4)
            - [0:3] position (m, frame e, range [-1e7, 1e7])
            - [3] clock_bias (m, range [-1e8, 1e8])
        out : LocalResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        LocalResult
            value : array, shape (..., 4)
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
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: PseudorangeResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> PseudorangeResult:
        """Pseudoranges from the antenna to satellites.

            rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 4)
            - [0:3] position (m, frame e, range [-1e7, 1e7])
            - [3] clock_bias (m, range [-1e8, 1e8])
        satellite_position : array_like, shape (..., n, 3)
            Satellite, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y z.
        satellite_clock : array_like, shape (..., n)
            Satellite clock offset; s, range [-0.1, 0.1].
        troposphere : array_like, shape (..., n)
            Tropospheric delay; m, range [-100, 1000].
        ionosphere : array_like, shape (..., n)
            Ionospheric delay; m, range [-1000, 1000].
        out : PseudorangeResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        PseudorangeResult
            value : array, shape (..., n), m
                Value of the equation.
            jacobian : array, shape (..., n, 4)
                Derivative of the value by the error of the state.
                Columns: position[3] clock_bias[1].
            status : Status for one epoch, array of them over leading axes
            item_status : array, shape (..., n)
                Status of every item; one that fails refuses its epoch.

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``pseudorange.value`` (value),
        ``pseudorange.jacobian`` (jacobian), ``pseudorange.nonzeros`` (what is not zero by
        structure), ``pseudorange.bind`` (a call without arguments over the same arrays).
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
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: PseudorangeResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], PseudorangeResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...

pseudorange: _Pseudorange

class PseudorangeWithoutSagnacResult(NamedTuple):
    value: _Array
    jacobian: _Array
    status: Any
    item_status: NDArray[np.uint8]

class _Pseudorange_Without_Sagnac(Protocol):
    jacobian_rows: NDArray[np.int32]
    jacobian_columns: NDArray[np.int32]
    def __call__(
        self,
        x: ArrayLike,
        /,
        *,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: PseudorangeWithoutSagnacResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> PseudorangeWithoutSagnacResult:
        """Pseudoranges from the antenna to satellites.

            rho = |s - a| (with earth rotation) + b - c dt_s + T + I;  a = p0 + C (p + R l)

        Parameters
        ----------
        x : array_like, shape (..., 4)
            - [0:3] position (m, frame e, range [-1e7, 1e7])
            - [3] clock_bias (m, range [-1e8, 1e8])
        satellite_position : array_like, shape (..., n, 3)
            Satellite, earth-fixed; m, frame e, range [-1e8, 1e8]; elements x y z.
        satellite_clock : array_like, shape (..., n)
            Satellite clock offset; s, range [-0.1, 0.1].
        troposphere : array_like, shape (..., n)
            Tropospheric delay; m, range [-100, 1000].
        ionosphere : array_like, shape (..., n)
            Ionospheric delay; m, range [-1000, 1000].
        out : PseudorangeWithoutSagnacResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        PseudorangeWithoutSagnacResult
            value : array, shape (..., n), m
                Value of the equation.
            jacobian : array, shape (..., n, 4)
                Derivative of the value by the error of the state.
                Columns: position[3] clock_bias[1].
            status : Status for one epoch, array of them over leading axes
            item_status : array, shape (..., n)
                Status of every item; one that fails refuses its epoch.

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``pseudorange_without_sagnac.value`` (value),
        ``pseudorange_without_sagnac.jacobian`` (jacobian), ``pseudorange_without_sagnac.nonzeros``
        (what is not zero by structure), ``pseudorange_without_sagnac.bind`` (a call without
        arguments over the same arrays).
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
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: PseudorangeWithoutSagnacResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], PseudorangeWithoutSagnacResult]: ...
    def value(
        self,
        x: ArrayLike,
        /,
        *,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def jacobian(
        self,
        x: ArrayLike,
        /,
        *,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...
    def nonzeros(
        self,
        x: ArrayLike,
        /,
        *,
        satellite_position: ArrayLike,
        satellite_clock: ArrayLike,
        troposphere: ArrayLike,
        ionosphere: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> _Array: ...

pseudorange_without_sagnac: _Pseudorange_Without_Sagnac

class BroadcastOrbitResult(NamedTuple):
    position: _Array
    clock: _Array
    velocity: _Array
    clock_rate: _Array
    status: Any

class _Broadcast_Orbit(Protocol):
    def __call__(
        self,
        *,
        time: ArrayLike,
        toe: ArrayLike,
        toc: ArrayLike,
        sqrt_a: ArrayLike,
        eccentricity: ArrayLike,
        mean_anomaly: ArrayLike,
        mean_motion_difference: ArrayLike,
        inclination: ArrayLike,
        inclination_rate: ArrayLike,
        right_ascension: ArrayLike,
        right_ascension_rate: ArrayLike,
        argument_of_perigee: ArrayLike,
        cuc: ArrayLike,
        cus: ArrayLike,
        crc: ArrayLike,
        crs: ArrayLike,
        cic: ArrayLike,
        cis: ArrayLike,
        af0: ArrayLike,
        af1: ArrayLike,
        af2: ArrayLike,
        group_delay: ArrayLike,
        out: BroadcastOrbitResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> BroadcastOrbitResult:
        """Satellite position, velocity and clock from a broadcast ephemeris.

            E - e sin E = M;  r, u, i with harmonic corrections;  R_z(Omega) R_x(i)

        Parameters
        ----------
        time : array_like, shape (...)
            Time of week; may pass its ends by an hour; s, range [-3600, 608400].
        toe : array_like, shape (...)
            Reference time of the ephemeris; s, range [0, 604800].
        toc : array_like, shape (...)
            Reference time of the clock; s, range [0, 604800].
        sqrt_a : array_like, shape (...)
            Square root of the semi-major axis; m^1/2, range [4000, 7000].
        eccentricity : array_like, shape (...)
            Eccentricity; range [0, 0.1].
        mean_anomaly : array_like, shape (...)
            Mean anomaly at the reference time; rad, range [-3.2, 3.2].
        mean_motion_difference : array_like, shape (...)
            Correction of the mean motion; rad/s, range [-1e-6, 1e-6].
        inclination : array_like, shape (...)
            Inclination at the reference time; rad, range [-3.2, 3.2].
        inclination_rate : array_like, shape (...)
            Rate of the inclination; rad/s, range [-1e-6, 1e-6].
        right_ascension : array_like, shape (...)
            Longitude of the node at the week's start; rad, range [-3.2, 3.2].
        right_ascension_rate : array_like, shape (...)
            Rate of the right ascension; rad/s, range [-1e-6, 1e-6].
        argument_of_perigee : array_like, shape (...)
            Argument of perigee; rad, range [-3.2, 3.2].
        cuc : array_like, shape (...)
            Cosine correction of the argument of latitude; rad, range [-0.001, 0.001].
        cus : array_like, shape (...)
            Sine correction of the argument of latitude; rad, range [-0.001, 0.001].
        crc : array_like, shape (...)
            Cosine correction of the radius; m, range [-10000, 10000].
        crs : array_like, shape (...)
            Sine correction of the radius; m, range [-10000, 10000].
        cic : array_like, shape (...)
            Cosine correction of the inclination; rad, range [-0.001, 0.001].
        cis : array_like, shape (...)
            Sine correction of the inclination; rad, range [-0.001, 0.001].
        af0 : array_like, shape (...)
            Clock offset; s, range [-0.1, 0.1].
        af1 : array_like, shape (...)
            Clock drift; range [-1e-6, 1e-6].
        af2 : array_like, shape (...)
            Clock drift rate; 1/s, range [-1e-9, 1e-9].
        group_delay : array_like, shape (...)
            TGD or BGD of the signal; s, range [-1e-5, 1e-5].
        out : BroadcastOrbitResult, tuple or dict of arrays, optional
            Contiguous arrays to write to instead of new ones; what fails stays untouched.

        Returns
        -------
        BroadcastOrbitResult
            position : array, shape (..., 3), m
                Position.
            clock : array, shape (...), s
                Clock.
            velocity : array, shape (..., 3), m/s
                Velocity.
            clock_rate : array, shape (...)
                Clock rate.
            status : Status for one epoch, array of them over leading axes

        Raises
        ------
        GuardError
            When a guard fails in a call for one epoch. With leading axes, ``status`` tells, and the
            rows of epochs that fail are NaN.

        Notes
        -----
        Other forms, with the same arguments: ``broadcast_orbit.value`` (position, clock, velocity,
        clock_rate), ``broadcast_orbit.bind`` (a call without arguments over the same arrays),
        ``broadcast_orbit.blocks`` (epochs side by side, see ``broadcast_orbit.to_lanes``).
        GM = 3.986005000e+14 m^3/s^2 of gps; the other system's value costs metres after two hours.
        Earth-fixed axes at the time given, which is the time of transmission for a pseudorange.
        Kepler's equation by 4 Newton steps: error below 1e-16 rad for eccentricities up to 0.1.
        group_delay is TGD or BGD of the signal: the clock is that of the signal.
        Source: IS-GPS-200, table 20-IV and 20.3.3.3.3.1; Galileo OS SIS ICD 5.1.
        """
    def bind(
        self,
        *,
        time: ArrayLike,
        toe: ArrayLike,
        toc: ArrayLike,
        sqrt_a: ArrayLike,
        eccentricity: ArrayLike,
        mean_anomaly: ArrayLike,
        mean_motion_difference: ArrayLike,
        inclination: ArrayLike,
        inclination_rate: ArrayLike,
        right_ascension: ArrayLike,
        right_ascension_rate: ArrayLike,
        argument_of_perigee: ArrayLike,
        cuc: ArrayLike,
        cus: ArrayLike,
        crc: ArrayLike,
        crs: ArrayLike,
        cic: ArrayLike,
        cis: ArrayLike,
        af0: ArrayLike,
        af1: ArrayLike,
        af2: ArrayLike,
        group_delay: ArrayLike,
        out: BroadcastOrbitResult | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> Callable[[], BroadcastOrbitResult]: ...
    def value(
        self,
        *,
        time: ArrayLike,
        toe: ArrayLike,
        toc: ArrayLike,
        sqrt_a: ArrayLike,
        eccentricity: ArrayLike,
        mean_anomaly: ArrayLike,
        mean_motion_difference: ArrayLike,
        inclination: ArrayLike,
        inclination_rate: ArrayLike,
        right_ascension: ArrayLike,
        right_ascension_rate: ArrayLike,
        argument_of_perigee: ArrayLike,
        cuc: ArrayLike,
        cus: ArrayLike,
        crc: ArrayLike,
        crs: ArrayLike,
        cic: ArrayLike,
        cis: ArrayLike,
        af0: ArrayLike,
        af1: ArrayLike,
        af2: ArrayLike,
        group_delay: ArrayLike,
        out: _Array | Sequence[_Array] | Mapping[str, _Array] | None = None,
    ) -> tuple[_Array, _Array, _Array, _Array]: ...
    lanes: int
    def to_lanes(self, rows: ArrayLike) -> _Array: ...
    def from_lanes(self, blocked: ArrayLike, epochs: int | None = None) -> _Array: ...
    def blocks(
        self,
        *,
        time: ArrayLike,
        toe: ArrayLike,
        toc: ArrayLike,
        sqrt_a: ArrayLike,
        eccentricity: ArrayLike,
        mean_anomaly: ArrayLike,
        mean_motion_difference: ArrayLike,
        inclination: ArrayLike,
        inclination_rate: ArrayLike,
        right_ascension: ArrayLike,
        right_ascension_rate: ArrayLike,
        argument_of_perigee: ArrayLike,
        cuc: ArrayLike,
        cus: ArrayLike,
        crc: ArrayLike,
        crs: ArrayLike,
        cic: ArrayLike,
        cis: ArrayLike,
        af0: ArrayLike,
        af1: ArrayLike,
        af2: ArrayLike,
        group_delay: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Blocks: ...
    def bind_blocks(
        self,
        *,
        time: ArrayLike,
        toe: ArrayLike,
        toc: ArrayLike,
        sqrt_a: ArrayLike,
        eccentricity: ArrayLike,
        mean_anomaly: ArrayLike,
        mean_motion_difference: ArrayLike,
        inclination: ArrayLike,
        inclination_rate: ArrayLike,
        right_ascension: ArrayLike,
        right_ascension_rate: ArrayLike,
        argument_of_perigee: ArrayLike,
        cuc: ArrayLike,
        cus: ArrayLike,
        crc: ArrayLike,
        crs: ArrayLike,
        cic: ArrayLike,
        cis: ArrayLike,
        af0: ArrayLike,
        af1: ArrayLike,
        af2: ArrayLike,
        group_delay: ArrayLike,
        epochs: int | None = None,
        out: Blocks | Mapping[str, _Array] | None = None,
    ) -> Callable[[], Blocks]: ...

broadcast_orbit: _Broadcast_Orbit

class StateBlocks(NamedTuple):
    position: _Array
    clock_bias: _Array

class _Vector:
    size: int
    names: tuple[str, ...]
    labels: tuple[str, ...]
    units: Mapping[str, str]
    frames: Mapping[str, str]
    slices: Mapping[str, slice]
    position: slice
    clock_bias: slice

class _State(_Vector):
    error: _Vector
    error_size: int
    digest: str
    initial: _Array
    conventions: Mapping[str, str]
    def pack(self, *, position: ArrayLike = ..., clock_bias: ArrayLike = ...) -> _Array: ...
    def unpack(self, x: ArrayLike) -> StateBlocks: ...
    def retract(self, x: ArrayLike, d: ArrayLike) -> _Array: ...
    def local(self, x: ArrayLike, y: ArrayLike) -> _Array: ...

State: _State
