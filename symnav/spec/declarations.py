"""Second stage: declared frames, state blocks and inputs become named frames and blocks.

A block whose range was not declared has empty bounds until the quantities that it is bound to are
known (``ranges``).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from symnav import naming, units
from symnav.blocks import (
    Block,
    GeodeticBlock,
    HeadingBlock,
    RotationBlock,
    ScalarBlock,
    VectorBlock,
    connecting,
    frame_map,
)
from symnav.errors import EquationError
from symnav.naming import Use
from symnav.spec.problems import Problems, choices
from symnav.spec.reading import Tables
from symnav.spec.records import Frame, Input
from symnav.spec.schema import (
    FrameTable,
    GeodeticTable,
    HeadingTable,
    Pair,
    RotationTable,
    ScalarTable,
    StateTable,
    VectorTable,
)

#: Latitudes beyond this are refused by default: local-level axes turn too fast near the poles.
LATITUDE_LIMIT = math.radians(89.9)
#: Rounded to either type it is still short of pi/2.
QUARTER_TURN = 1.570796
HEIGHTS = (-1e4, 1e7)
LOWEST_HEIGHT = -6e6

#: End of the range of an angle that a retraction wraps. It wraps to (-pi, pi] up to rounding, in
#: single precision to 3.1415927, which is more than pi: a range that ended at pi would refuse it.
HALF_TURN = 3.1416
#: An end of a declared range so near to pi is pi, written with a few digits.
NEARLY_PI = 1e-4

LOCAL_LEVEL = ("ned", "enu")


@dataclass
class Frames:
    """Declared frames, and the spelling of every frame met so far."""

    declared: Mapping[str, Frame]
    problems: Problems
    _met: dict[str, str] = field(default_factory=dict)

    def use(self, name: str, path: str) -> None:
        """Check the spelling of a frame that is mentioned."""
        reason = naming.fault(name, Use.FRAME)
        if reason is not None:
            self.problems.add(path, reason)
            return
        known = self._met.setdefault(name.lower(), name)
        if known != name:
            self.problems.add(path, f"frame {name!r} differs from {known!r} only in case")

    def require(self, name: str, path: str, allowed: tuple[str, ...]) -> None:
        """Check that a frame is declared with one of the axes allowed."""
        self.use(name, path)
        axes = self.declared[name].axes if name in self.declared else None
        if axes is None:
            self.problems.add(
                path, f"frame {name!r} is not declared; add [[frame]] with axes {choices(allowed)}"
            )
        elif axes not in allowed:
            self.problems.add(
                path, f"frame {name!r} has axes {axes!r}; axes {choices(allowed)} are needed here"
            )

    def axes(self, name: str) -> str:
        """Axes of a frame; undeclared ones are free."""
        return self.declared[name].axes if name in self.declared else "free"


def declared_frames(tables: Tables, problems: Problems) -> Frames:
    """The frames of the specification."""
    declared: dict[str, Frame] = {}
    frames = Frames(declared, problems)
    for row in tables.frames:
        table: FrameTable = row.table
        if table.name in declared:
            problems.add(f"{row.path}.name", f"frame {table.name!r} is declared twice")
            continue
        frames.use(table.name, f"{row.path}.name")
        declared[table.name] = Frame(table.name, table.axes)
    return frames


@dataclass
class Names:
    """Names of one kind given so far: each once, whatever its case."""

    problems: Problems
    taken: dict[str, str] = field(default_factory=dict)

    def give(self, name: str, use: Use, path: str) -> bool:
        """Record a name; False when another thing has it already."""
        reason = naming.fault(name, use)
        if reason is not None:
            self.problems.add(path, reason)
        other = naming.clash(name, self.taken)
        if other == name:
            self.problems.add(path, f"{name!r} is also the name of {self.taken[name]}")
            return False
        if other is not None:
            self.problems.add(
                path, f"{name!r} differs only in case from the name of {self.taken[other]}"
            )
        self.taken[name] = path.removesuffix(".name")
        return True


def state_blocks(tables: Tables, frames: Frames, names: Names) -> dict[str, Block]:
    """State blocks by name, in the order of memory."""
    blocks: dict[str, Block] = {}
    for row in tables.states:
        table: StateTable = row.table
        path = row.path
        if isinstance(table, RotationTable) and table.storage == "dcm":
            names.problems.add(
                f"{path}.storage", "'dcm' is for inputs; a state stores 'wxyz' or 'xyzw'"
            )
            table = table.model_copy(update={"storage": "wxyz"})
        if names.give(table.name, Use.STATE, f"{path}.name"):
            blocks[table.name] = block_of(table, path, frames)
            _check_wrapped(blocks[table.name], path, names.problems)
    return blocks


def _check_wrapped(block: Block, path: str, problems: Problems) -> None:
    """A stored angle is wrapped, so a range beyond half a turn would never be reached."""
    if isinstance(block, HeadingBlock):
        what, ends = "heading", (*block.lower, *block.upper)
    elif isinstance(block, GeodeticBlock):
        what, ends = "longitude", (block.lower[1], block.upper[1])
    else:
        return
    if ends and max(map(abs, ends)) > HALF_TURN:
        problems.add(
            f"{path}.range",
            f"a stored {what} is wrapped to (-pi, pi]; its range stays within +-pi (up to "
            f"+-{HALF_TURN} for rounding), not {min(ends)!r} to {max(ends)!r}",
        )


def block_of(table: StateTable, path: str, frames: Frames) -> Block:
    """The block a table describes; its mistakes are recorded."""
    return _BUILDERS[type(table)](table, path, frames)


def _vector(table: VectorTable, path: str, frames: Frames) -> Block:
    problems = frames.problems
    unit = check_unit(table.unit, f"{path}.unit", problems)
    if table.frame:
        frames.use(table.frame, f"{path}.frame")
        if table.size % 3:
            problems.add(
                f"{path}.frame", f"{table.size} elements have no frame; only 3-vectors have one"
            )
    if table.error_frame:
        frames.use(table.error_frame, f"{path}.error_frame")
        if not table.frame or table.size != 3:
            problems.add(f"{path}.error_frame", "only a 3-vector with a frame has an error frame")
    lower, upper = _bounds(table.range, table.size, f"{path}.range", problems)
    return VectorBlock(
        table.name, lower, upper, table.description, table.size, unit, table.frame,
        table.error_frame, table.error_sign,
    )  # fmt: skip


def _scalar(table: ScalarTable, path: str, frames: Frames) -> Block:
    unit = check_unit(table.unit, f"{path}.unit", frames.problems)
    lower, upper = _bounds(table.range, 1, f"{path}.range", frames.problems)
    return ScalarBlock(
        table.name, lower, upper, table.description, 1, unit, error_sign=table.error_sign
    )


def _rotation(table: RotationTable, path: str, frames: Frames) -> Block:
    maps = check_maps(table.maps, f"{path}.maps", frames)
    count = 9 if table.storage == "dcm" else 4
    bound = 1.0 + table.norm_tolerance
    return RotationBlock(
        table.name, (-bound,) * count, (bound,) * count, table.description, maps, table.storage,
        table.error, table.normalise, table.norm_tolerance,
    )  # fmt: skip


def _heading(table: HeadingTable, path: str, frames: Frames) -> Block:
    maps = check_maps(table.maps, f"{path}.maps", frames)
    declared = tuple(map(_half_turns, table.range or ((-math.pi, math.pi),)))
    lower, upper = _bounds(declared, 1, f"{path}.range", frames.problems)
    if lower and not (lower[0] >= -2 * math.pi and upper[0] <= 2 * math.pi):
        frames.problems.add(f"{path}.range", "a heading stays within one turn, +-2 pi")
    return HeadingBlock(table.name, lower, upper, table.description, maps, table.axis)


def _geodetic(table: GeodeticTable, path: str, frames: Frames) -> Block:
    frames.require(table.frame, f"{path}.frame", ("ecef",))
    frames.require(table.error_frame, f"{path}.error_frame", LOCAL_LEVEL)
    axes = frames.axes(table.error_frame)
    lower, upper = geodetic_bounds(table.range, f"{path}.range", frames.problems)
    return GeodeticBlock(
        table.name, lower, upper, table.description, table.frame, table.error_frame,
        axes if axes in LOCAL_LEVEL else "ned", table.attitude_frame,
    )  # fmt: skip


def geodetic_bounds(
    pairs: tuple[Pair, ...] | None, path: str, problems: Problems
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Bounds of latitude, longitude and height; the defaults where nothing usable is declared."""
    default = ((-LATITUDE_LIMIT, LATITUDE_LIMIT), (-math.pi, math.pi), HEIGHTS)
    if pairs is not None and len(pairs) != 3:
        problems.add(path, "write three pairs: latitude, longitude (rad) and height (m)")
        pairs = None
    latitude, longitude, height = pairs or default
    longitude = _half_turns(longitude)
    if not max(map(abs, latitude)) <= QUARTER_TURN:
        problems.add(path, f"latitude stays inside +-pi/2 (radians): up to +-{QUARTER_TURN}")
    if not max(map(abs, longitude)) <= 2 * math.pi:
        problems.add(path, "longitude stays within one turn, +-2 pi (radians)")
    if height[0] < LOWEST_HEIGHT:
        problems.add(path, f"height stays above {LOWEST_HEIGHT:g} m")
    lower, upper = zip(latitude, longitude, height, strict=True)
    return lower, upper


def _half_turns(pair: Pair) -> Pair:
    """The range of an angle, its ends at -pi and pi moved out to where rounding may wrap to."""
    lower, upper = (
        math.copysign(HALF_TURN, end) if abs(abs(end) - math.pi) <= NEARLY_PI else end
        for end in pair
    )
    return lower, upper


_BUILDERS: Mapping[type[StateTable], Callable[..., Block]] = {
    VectorTable: _vector,
    ScalarTable: _scalar,
    RotationTable: _rotation,
    HeadingTable: _heading,
    GeodeticTable: _geodetic,
}


def check_unit(unit: str, path: str, problems: Problems) -> str:
    """The unit, or ``1`` when it cannot be read."""
    try:
        units.parse(unit)
    except EquationError as error:
        problems.add(path, str(error))
        return "1"
    return unit


def check_maps(maps: str, path: str, frames: Frames) -> str:
    """The frame map in its normal form, or a stand-in when it cannot be read."""
    try:
        source, target = frame_map(maps)
    except EquationError as error:
        frames.problems.add(path, str(error))
        return "a -> b"
    frames.use(source, path)
    frames.use(target, path)
    return f"{source} -> {target}"


def _bounds(
    pairs: tuple[Pair, ...] | None, size: int, path: str, problems: Problems
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    if pairs is None:
        return (), ()
    if len(pairs) not in (1, size):
        problems.add(path, f"{len(pairs)} pairs for {size} elements; write one pair or {size}")
        return (), ()
    repeated = pairs * size if len(pairs) == 1 else pairs
    lower, upper = zip(*repeated, strict=True)
    return lower, upper


def check_error_frames(
    states: Mapping[str, Block],
    inputs: Mapping[str, Input],
    paths: Mapping[str, str],
    problems: Problems,
) -> frozenset[str]:
    """Every error frame needs one rotation, state block or input, that reaches it.

    Returns:
        The inputs that error frames need.
    """
    shared = [given.block for given in inputs.values() if not given.item]
    blocks = {**states, **{name: given.block for name, given in inputs.items()}}
    needed: set[str] = set()
    for name, block in blocks.items():
        if not isinstance(block, VectorBlock) or block.error_frame in ("", block.frame):
            continue
        ends = f"{block.error_frame!r} and {block.frame!r}"
        found = connecting(states.values(), shared, block.error_frame, block.frame)
        needed |= {rotation.name for rotation in found}
        if not found:
            problems.add(
                f"{paths[name]}.error_frame",
                f"no rotation connects {ends}; declare one with "
                f"maps = '{block.error_frame} -> {block.frame}'",
            )
        elif len(found) > 1:
            listed = " and ".join(repr(rotation.name) for rotation in found)
            problems.add(
                f"{paths[name]}.error_frame",
                f"{listed} connect {ends}, and the error needs one of them; give the others "
                "frames of their own",
            )
    return frozenset(needed & inputs.keys())


def with_bounds(block: Block, lower: float, upper: float) -> Block:
    """The block with the same bounds for every element."""
    count = block.storage_size
    return replace(block, lower=(lower,) * count, upper=(upper,) * count)
