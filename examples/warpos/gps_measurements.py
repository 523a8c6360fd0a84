"""The two functions of WarpTwin's ``GPSMeasurements<N>`` over the generated package warpos_gps.

N, the start of the position and the order of the flat Jacobian are chosen at run time; value and
non-zeros come from the generated functions, and only their places are worked out here.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from generated import warpos_gps

MEASUREMENT_ELEMENTS = 3
OBSERVER_ELEMENTS = 4


class GPSMeasurements:
    """Position measured by a GPS receiver, of a state of ``n`` elements.

    Args:
        n: length of the state, the template argument N.
        state_pos_index: first element of the position.
        observer_quat_index: first element of the quaternion in the observer's state; it has four
            elements, so that only 0 leaves room.
        meas_pos_index: first element of the position in the measurement; it has three elements, so
            that only 0 leaves room.
        order: of the flat Jacobian, which the documentation leaves open: ``row`` puts element
            (i, j) at i n + j, ``column`` at 3 j + i.
        rotate_to_ref: False predicts in the state's frame F and does not read the observer's
            quaternion; True turns the prediction to the receiver's frame REF by the transpose of
            ``quat_F_REF``.

    Raises:
        ValueError: when an index leaves no room.
    """

    def __init__(
        self,
        n: int,
        state_pos_index: int,
        observer_quat_index: int = 0,
        meas_pos_index: int = 0,
        *,
        order: Literal["row", "column"] = "row",
        rotate_to_ref: bool = False,
    ) -> None:
        if not 0 <= state_pos_index <= n - MEASUREMENT_ELEMENTS:
            raise ValueError(
                f"state_pos_index: elements {state_pos_index} to {state_pos_index + 2} are not in "
                f"a state of {n}"
            )
        if observer_quat_index != 0:
            raise ValueError(
                f"observer_quat_index: {observer_quat_index} leaves no room for a quaternion in "
                f"{OBSERVER_ELEMENTS} elements; it can only be 0"
            )
        if meas_pos_index != 0:
            raise ValueError(
                f"meas_pos_index: {meas_pos_index} leaves no room for a position in "
                f"{MEASUREMENT_ELEMENTS} elements; it can only be 0"
            )
        if order not in ("row", "column"):
            raise ValueError(f"order: {order!r} is neither 'row' nor 'column'")
        self._n = n
        self._position = slice(state_pos_index, state_pos_index + MEASUREMENT_ELEMENTS)
        self._order: Literal["C", "F"] = "C" if order == "row" else "F"
        self._rotate = rotate_to_ref

    def calculate_measurements(
        self,
        time: float,
        tar_state: ArrayLike,
        obs_state: ArrayLike,
        expected_measurement: NDArray[np.float64],
    ) -> np.int16:
        """Predict the measurement.

        Args:
            time: not read.
            tar_state: state, ``n`` elements.
            obs_state: quat_F_REF, scalar first.
            expected_measurement: receives three elements.

        Returns:
            0, or the status of the generated function; the output then stays untouched.
        """
        try:
            value = self._call("value", tar_state, obs_state)
        except warpos_gps.GuardError as error:
            return np.int16(error.status)
        expected_measurement[:] = value
        return np.int16(0)

    def calculate_measurements_matrix(
        self,
        time: float,
        tar_state: ArrayLike,
        obs_state: ArrayLike,
        measurement_jacobian: NDArray[np.float64],
    ) -> np.int16:
        """Differentiate the measurement by the state.

        Args:
            time: not read.
            tar_state: state, ``n`` elements.
            obs_state: quat_F_REF, scalar first.
            measurement_jacobian: receives ``3 n`` elements, in the order chosen.

        Returns:
            0, or the status of the generated function; the output then stays untouched.
        """
        try:
            nonzeros = self._call("nonzeros", tar_state, obs_state)
        except warpos_gps.GuardError as error:
            return np.int16(error.status)
        function = warpos_gps.observed if self._rotate else warpos_gps.measurement
        shift = self._position.start - warpos_gps.State.error.position.start
        jacobian = np.zeros((MEASUREMENT_ELEMENTS, self._n))
        jacobian[function.jacobian_rows, function.jacobian_columns + shift] = nonzeros
        measurement_jacobian[:] = jacobian.ravel(self._order)
        return np.int16(0)

    def _call(
        self, form: Literal["value", "nonzeros"], tar_state: ArrayLike, obs_state: ArrayLike
    ) -> NDArray[np.float64]:
        """One form of the generated function at the position of the caller's state."""
        state = np.asarray(tar_state, dtype=np.float64)
        if state.shape != (self._n,):
            raise ValueError(f"tar_state: expected ({self._n},), got {state.shape}")
        x = np.zeros(warpos_gps.State.size)
        x[warpos_gps.State.position] = state[self._position]
        result: NDArray[np.float64]
        if self._rotate:
            result = getattr(warpos_gps.observed, form)(x, observer_attitude=obs_state)
        else:
            result = getattr(warpos_gps.measurement, form)(x)
        return result
