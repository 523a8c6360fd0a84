"""Random specifications: any blocks in any order, any conventions, any bindings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from hypothesis import strategies as st

CONVENTIONS = ("right", "left", "left_negative", "right_negative", "rotation_vector", "storage")
NAMES = ("alpha", "beta", "gamma_block", "delta", "epsilon_1", "zeta9", "Eta", "thruster", "pad")

Table = dict[str, Any]


def _vector(name: str, frame: str, unit: str, bound: float) -> Table:
    return {
        "name": name, "kind": "vector", "size": 3, "unit": unit, "frame": frame,
        "range": [-bound, bound],
    }  # fmt: skip


@st.composite
def tables(draw: st.DrawFn) -> Table:
    """A whole specification as the table a TOML file would give."""
    position_kind = draw(st.sampled_from(["local", "ecef", "geodetic"]))
    states = [_position(draw, position_kind), _attitude(draw)]
    states += _padding(draw)
    bindings = _arm(draw, states)
    clock = draw(st.sampled_from(["state", "input", "none"]))
    if clock == "state":
        unit = draw(st.sampled_from(["m", "s"]))
        bound = 1e6 if unit == "m" else 1e-3
        states.append({"name": "clock", "kind": "scalar", "unit": unit, "range": [-bound, bound]})
    table: Table = {
        "name": "sample",
        "frame": [
            {"name": "n", "axes": draw(st.sampled_from(["ned", "enu"]))},
            {"name": "b", "axes": "free"},
            {"name": "e", "axes": "ecef"},
            {"name": "g", "axes": "free"},
        ],
        "state": draw(st.permutations(states)),
        "measurement": [
            _gnss(draw, bindings if position_kind != "ecef" else {}, position_kind),
            _range(draw, bindings, position_kind, clock),
        ],
    }
    imu = _imu(draw)
    if imu is not None:
        table["correction"] = [imu]
    return table


def _position(draw: st.DrawFn, kind: str) -> Table:
    if kind == "geodetic":
        return {
            "name": "place", "kind": "geodetic", "frame": "e", "error_frame": "n",
            "attitude_frame": draw(st.sampled_from(["fixed", "moving"])),
            "range": [[-1.5, 1.5], [-3.14, 3.14], [-1e3, 1e4]],
        }  # fmt: skip
    frame, bound = ("n", 1e4) if kind == "local" else ("e", 6.4e6)
    block = _vector("place", frame, "m", bound)
    if kind == "local" and draw(st.booleans()):
        block["error_frame"] = "b"
    block["error_sign"] = draw(st.sampled_from(["true_minus_estimate", "estimate_minus_true"]))
    return block


def _attitude(draw: st.DrawFn) -> Table:
    return {
        "name": "posture", "kind": "rotation", "maps": draw(st.sampled_from(["b -> n", "n -> b"])),
        "storage": draw(st.sampled_from(["wxyz", "xyzw"])),
        "error": draw(st.sampled_from(CONVENTIONS)),
        "normalise": draw(st.booleans()),
    }  # fmt: skip


def _padding(draw: st.DrawFn) -> list[Table]:
    names = draw(st.lists(st.sampled_from(NAMES), unique_by=str.lower, max_size=4))
    sizes = [draw(st.integers(1, 12)) for _ in names]
    return [
        {"name": name, "kind": "vector", "size": size, "unit": "1", "range": [-1.0, 1.0]}
        for name, size in zip(names, sizes, strict=True)
    ]


def _arm(draw: st.DrawFn, states: list[Table]) -> Mapping[str, Any]:
    choice = draw(st.sampled_from(["state", "input", "constant", "none"]))
    if choice == "none":
        return {}
    if choice == "constant":
        return {"lever_arm": [0.3, -0.2, 1.1], "attitude": "posture"}
    if choice == "input":
        return {"lever_arm": "input", "attitude": "posture"}
    states.append(_vector("antenna", "b", "m", 5.0))
    return {"lever_arm": "antenna", "attitude": "posture"}


def _gnss(draw: st.DrawFn, bindings: Mapping[str, Any], kind: str) -> Table:
    entry: Table = {"name": "fix", "model": "gnss_position", "position": "place", **bindings}
    entry["order"] = draw(st.sampled_from(["row", "column"]))
    if kind == "local" and draw(st.booleans()):
        entry["offset"] = draw(st.sampled_from(["input", [1.0, 2.0, -3.0]]))
    if draw(st.booleans()):
        entry["observer_attitude"] = "input"
        if draw(st.booleans()):
            entry["origin"] = "input"
    return entry


def _range(draw: st.DrawFn, bindings: Mapping[str, Any], kind: str, clock: str) -> Table:
    entry: Table = {
        "name": "ranges", "model": "pseudorange", "position": "place",
        "satellite_position": "input", "maximum": draw(st.integers(1, 40)),
        "sagnac": draw(st.sampled_from(["none", "first_order", "rotate_once", "exact"])),
        "items": draw(st.sampled_from(["skip", "reject"])), **bindings,
    }  # fmt: skip
    if kind == "local" or (kind == "ecef" and bindings):
        entry["nav_to_ecef"] = "input"
    if kind == "local":
        entry["origin"] = "input"
    if clock != "none":
        entry["clock_bias"] = "clock" if clock == "state" else "input"
    for name in ("satellite_clock", "troposphere", "ionosphere"):
        if draw(st.booleans()):
            entry[name] = "input"
    return entry


def _imu(draw: st.DrawFn) -> Table | None:
    samples = draw(st.integers(0, 4))
    if samples == 0:
        return None
    return {
        "name": "force", "model": "specific_force", "attitude": "posture", "samples": samples,
        "delta_theta": "input", "delta_velocity": "input", "dt": "input",
        "accelerometer_bias": "input", "gyro_bias": "input",
        "rotation": draw(st.sampled_from(["half", "exact", "none"])),
        "sculling": draw(st.sampled_from(["polynomial", "harmonic", "none"])),
        "epoch": draw(st.sampled_from(["start", "mid", "end"])),
        "output": draw(st.sampled_from(["specific_force", "delta_velocity"])),
        "jacobians": draw(st.lists(st.sampled_from(["delta_theta", "delta_velocity", "dt",
                          "accelerometer_bias", "gyro_bias"]), unique=True, max_size=3)),
    }  # fmt: skip
