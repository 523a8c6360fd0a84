"""Random specifications: any blocks in any order, any conventions, any bindings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from hypothesis import strategies as st

CONVENTIONS = ("right", "left", "left_negative", "right_negative", "rotation_vector", "storage")
NAMES = ("alpha", "beta", "gamma_block", "delta", "epsilon_1", "zeta9", "Eta", "thruster", "pad")
MAPS = ("b -> n", "n -> b")
INCREMENTS = ("delta_theta", "delta_velocity")
RATES = (
    "angular_rate_start", "angular_rate_end", "specific_force_start", "specific_force_end",
)  # fmt: skip

Table = dict[str, Any]


def _vector(name: str, frame: str, unit: str, bound: float, size: int = 3) -> Table:
    return {
        "name": name, "kind": "vector", "size": size, "unit": unit, "frame": frame,
        "range": [-bound, bound],
    }  # fmt: skip


def _scalar(name: str, unit: str, bound: float) -> Table:
    return {"name": name, "kind": "scalar", "unit": unit, "range": [-bound, bound]}


@st.composite
def tables(draw: st.DrawFn) -> Table:
    """A whole specification as the table a TOML file would give."""
    position_kind = draw(st.sampled_from(["local", "ecef", "geodetic"]))
    states = [_position(draw, position_kind)]
    inputs: list[Table] = []
    posture = _attitude(draw)
    (inputs if posture.get("storage") == "dcm" else states).append(posture)
    states += _padding(draw)
    arm = _arm(draw, states)
    maximum = draw(st.integers(1, 40))
    clock = _clock(draw, states, maximum)
    fix = _gnss(draw, arm if position_kind != "ecef" else {}, position_kind)
    ranges = _range(draw, arm, position_kind, {**clock, **_delays(draw, states, maximum)}, maximum)
    scalars = draw(st.sampled_from([["double"], ["double"], ["double", "float"]]))
    table: Table = {
        "name": "sample",
        "scalars": scalars,
        "frame": [
            {"name": "n", "axes": draw(st.sampled_from(["ned", "enu"]))},
            {"name": "b", "axes": "free"},
            {"name": "e", "axes": "ecef"},
            {"name": "g", "axes": "free"},
        ],
        "measurement": [fix, ranges],
        "input": inputs,
    }
    imu = _imu(draw, states)
    if imu is not None:
        table["correction"] = [imu]
    table["state"] = draw(st.permutations(states))
    read = repr([*table["measurement"], imu, [state.get("error_frame") for state in states]])
    if "posture" not in read and "'b'" not in read:
        inputs.clear()  # an input that nothing reads is refused
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
    """A quaternion of the state, a heading of the state, or a matrix that is given."""
    kind = draw(st.sampled_from(["quaternion", "quaternion", "heading", "matrix"]))
    table: Table = {"name": "posture", "maps": draw(st.sampled_from(MAPS))}
    if kind == "heading":
        return {**table, "kind": "heading", "axis": draw(st.sampled_from(["x", "y", "z"]))}
    if kind == "matrix":
        return {**table, "kind": "rotation", "storage": "dcm"}
    return {
        **table, "kind": "rotation", "storage": draw(st.sampled_from(["wxyz", "xyzw"])),
        "error": draw(st.sampled_from(CONVENTIONS)), "normalise": draw(st.booleans()),
    }  # fmt: skip


def _padding(draw: st.DrawFn) -> list[Table]:
    names = draw(st.lists(st.sampled_from(NAMES), unique_by=str.lower, max_size=4))
    sizes = [draw(st.integers(1, 12)) for _ in names]
    return [_vector(name, "", "1", 1.0, size) for name, size in zip(names, sizes, strict=True)]


def _arm(draw: st.DrawFn, states: list[Table]) -> Mapping[str, Any]:
    choice = draw(st.sampled_from(["state", "input", "constant", "none"]))
    if choice == "none":
        return {}
    if choice == "constant":
        return {"lever_arm": [0.3, -0.2, 1.1], "attitude": "posture"}
    if choice == "input":
        return {"lever_arm": "input", "attitude": "posture"}
    antenna = _vector("antenna", "b", "m", 5.0)
    if draw(st.booleans()):
        antenna["error_frame"] = "n"
    states.append(antenna)
    return {"lever_arm": "antenna", "attitude": "posture"}


def _clock(draw: st.DrawFn, states: list[Table], maximum: int) -> Mapping[str, Any]:
    """One for all items, one for each system, one for each item, or none."""
    choice = draw(st.sampled_from(["state", "input", "systems", "slots", "none"]))
    unit = draw(st.sampled_from(["m", "s"]))
    bound = 1e6 if unit == "m" else 1e-3
    if choice == "none":
        return {}
    if choice == "input":
        return {"clock_bias": "input"}
    if choice == "state":
        states.append(_scalar("clock", unit, bound))
        return {"clock_bias": "clock"}
    if choice == "slots":
        states.append(_vector("clocks", "", unit, bound, maximum))
        return {"clock_bias": {"block": "clocks"}}
    states += [_scalar("clock_gps", unit, bound), _scalar("clock_gal", unit, bound)]
    return {"clock_bias": {"gps": "clock_gps", "galileo": "clock_gal"}}


def _delays(draw: st.DrawFn, states: list[Table], maximum: int) -> Mapping[str, Any]:
    found: Table = {}
    for name in ("satellite_clock", "troposphere", "ionosphere"):
        choice = draw(st.sampled_from(["none", "input", "slots"]))
        if choice == "input" or (choice == "slots" and name == "satellite_clock"):
            found[name] = "input"
        elif choice == "slots":
            states.append(_vector(f"{name}_of_item", "", "m", 100.0, maximum))
            found[name] = {"block": f"{name}_of_item"}
    return found


def _gnss(draw: st.DrawFn, bindings: Mapping[str, Any], kind: str) -> Table:
    entry: Table = {"name": "fix", "model": "gnss_position", "position": "place", **bindings}
    entry["order"] = draw(st.sampled_from(["row", "column"]))
    entry["residual"] = draw(st.booleans())
    if kind == "geodetic":
        entry["scalar"] = "double"  # metres of the earth's radius are no numbers for floats
    if kind == "local" and draw(st.booleans()):
        entry["offset"] = draw(st.sampled_from(["input", [1.0, 2.0, -3.0]]))
    if draw(st.booleans()):
        entry[draw(st.sampled_from(["observer_attitude", "heading"]))] = "input"
        if draw(st.booleans()):
            entry["origin"] = "input"
    return entry


def _range(
    draw: st.DrawFn,
    bindings: Mapping[str, Any],
    kind: str,
    delays: Mapping[str, Any],
    maximum: int,
) -> Table:
    entry: Table = {
        "name": "ranges", "model": "pseudorange", "position": "place", "scalar": "double",
        "satellite_position": "input", "maximum": maximum,
        "sagnac": draw(st.sampled_from(["none", "first_order", "rotate_once", "exact"])),
        "items": draw(st.sampled_from(["skip", "reject"])), **bindings, **delays,
    }  # fmt: skip
    if draw(st.booleans()):
        entry["difference"] = "single"
    if kind == "local" or (kind == "ecef" and bindings):
        entry["nav_to_ecef"] = "input"
    if kind == "local":
        entry["origin"] = "input"
    return entry


def _imu(draw: st.DrawFn, states: list[Table]) -> Table | None:
    """Increments of one to five sub-samples, with the interval before, or rates."""
    given = draw(st.sampled_from(["increments", "previous", "rates", "nothing"]))
    if given == "nothing":
        return None
    roles = [*(RATES if given == "rates" else INCREMENTS), "dt"]
    sculling = ["polynomial", "none"] if given == "rates" else ["polynomial", "harmonic", "none"]
    if given == "previous":
        sculling = ["polynomial"]
        roles += [f"previous_{role}" for role in INCREMENTS]
    entry: Table = {
        "name": "force", "model": "specific_force", "attitude": "posture",
        "input": "rates" if given == "rates" else "increments",
        "samples": draw(st.integers(1, 5)) if given == "increments" else 1,
        "rotation": draw(st.sampled_from(["half", "exact", "none"])),
        "sculling": draw(st.sampled_from(sculling)),
        "epoch": draw(st.sampled_from(["start", "mid", "end"])),
        "output": draw(st.sampled_from(["specific_force", "delta_velocity"])),
    }  # fmt: skip
    biases = {"accelerometer_bias": ("m/s^2", 1.0), "gyro_bias": ("rad/s", 0.1)}
    for name, (unit, bound) in biases.items():
        choice = draw(st.sampled_from(["state", "input", "none"]))
        if choice == "state":
            states.append(_vector(name, "b", unit, bound))
            entry[name] = name
        elif choice == "input":
            roles.append(name)
    entry |= dict.fromkeys(roles, "input")
    entry["jacobians"] = draw(st.lists(st.sampled_from(roles), unique=True, max_size=3))
    return entry
