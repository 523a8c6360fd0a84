"""Frames of a model's quantities: the roles "body", "nav" ... get the names of the user's frames.

Vectors whose frame is known fix their role first; rotations then carry what is known from one end
to the other, read in whichever direction fits. A rotation bound to none makes both its ends one
frame. A geodetic point brings its own rotation between its local-level and its earth-fixed frame.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from symnav.blocks import Block, GeodeticBlock, HeadingBlock, RotationBlock, VectorBlock, frame_map
from symnav.equations.model import Model, Role

Ends = tuple[str, str]

LOCAL_LEVEL = ("ned", "enu")

#: The frame role that library models give to earth-fixed quantities.
EARTH = "ecef"


@dataclass(frozen=True)
class Held:
    """What a role is bound to, as far as frames go.

    Attributes:
        label: in words, such as ``block 'antenna'``.
        frame: of a vector or point; None while it is not known.
        ends: source and target of a rotation; None while they are not known.
        level: local-level and earth-fixed frame of a geodetic point.
    """

    label: str
    frame: str | None = None
    ends: Ends | None = None
    level: Ends | None = None


@dataclass(frozen=True)
class Resolution:
    """Frame role -> frame, for the roles that could be fixed, and mistakes by role name."""

    frames: Mapping[str, str]
    problems: tuple[tuple[str, str], ...] = ()


def held_by(label: str, block: Block) -> Held:
    """The frames of a block."""
    if isinstance(block, (RotationBlock, HeadingBlock)):
        return Held(label, ends=frame_map(block.maps))
    if isinstance(block, GeodeticBlock):
        return Held(label, block.frame or None, level=(block.error_frame, block.frame))
    frame = block.frame if isinstance(block, VectorBlock) else ""
    return Held(label, frame or None)


def resolve(model: Model, held: Mapping[str, Held], axes: Mapping[str, str]) -> Resolution:
    """Find the frame of every role that the bindings determine.

    Args:
        model: its roles.
        held: by role name; roles bound to none are absent.
        axes: axes of the declared frames.
    """
    solver = _Solver(model, held, axes)
    solver.run()
    return Resolution(solver.frames, tuple(solver.problems))


def complete(
    model: Model, held: Mapping[str, Held], frames: Mapping[str, str], axes: Mapping[str, str]
) -> dict[str, str]:
    """Every frame role of a model: what is not determined keeps the role's own name."""
    completed = dict(frames)
    point = _point(model)
    if point is not None and point.frame not in completed:
        own = {name: name for name in _frame_roles(model) if name not in completed}
        completed[point.frame] = (
            _point_frame(model, point, own, axes) if point.frame not in _turned(model) else None
        ) or point.frame
        completed = {**model.frame_rule(completed, axes, None), **completed}
    for group in _same_frame(model, held):
        shared = next((completed[name] for name in group if name in completed), group[-1])
        for name in group:
            completed.setdefault(name, shared)
    for name in _frame_roles(model):
        completed.setdefault(name, name)
    return completed


def _point(model: Model) -> Role | None:
    """The position of a model that has one."""
    return next((role for role in model.roles if role.kind == "point"), None)


def _turned(model: Model) -> set[str]:
    """Frame roles that a rotation of the model leads from or to."""
    return {end for r in model.roles if r.kind in ROTATIONS for end in frame_map(r.frame)}


def _point_frame(
    model: Model, point: Role, known: Mapping[str, str], axes: Mapping[str, str]
) -> str | None:
    """A frame for the point from which the model's own rule gives what is known already."""
    for frame_role, frame in known.items():
        told = model.frame_rule({**known, point.frame: frame}, axes, None)
        if told.get(frame_role) == frame:
            return frame
    return None


def _same_frame(model: Model, held: Mapping[str, Held]) -> list[list[str]]:
    """Frame roles that rotations bound to none make one frame."""
    groups: list[list[str]] = []
    for role in model.roles:
        if role.kind not in ROTATIONS or role.name in held:
            continue
        ends = frame_map(role.frame)
        if _joined(model, held, *ends):
            continue
        touched = [group for group in groups if not set(group).isdisjoint(ends)]
        members = [name for group in touched for name in group]
        groups = [group for group in groups if group not in touched]
        groups.append(list(dict.fromkeys([*members, *ends])))
    return groups


ROTATIONS = ("rotation", "orientation")


def _frame_roles(model: Model) -> Iterator[str]:
    for role in model.roles:
        if role.kind in ROTATIONS:
            yield from frame_map(role.frame)
        elif role.frame:
            yield role.frame


def _joined(model: Model, held: Mapping[str, Held], source: str, target: str) -> bool:
    """True when bound rotations connect two frame roles."""
    reached = {source}
    while True:
        more = {
            end
            for role in model.roles
            if role.kind in ROTATIONS and role.name in held
            for pair in (frame_map(role.frame),)
            if not reached.isdisjoint(pair)
            for end in pair
        }
        if more <= reached:
            return target in reached
        reached |= more


@dataclass
class _Solver:
    model: Model
    held: Mapping[str, Held]
    axes: Mapping[str, str]
    frames: dict[str, str] = field(default_factory=dict)
    problems: list[tuple[str, str]] = field(default_factory=list)
    _fixed_by: dict[str, str] = field(default_factory=dict)
    _blamed: set[str] = field(default_factory=set)

    def run(self) -> None:
        """Fix what can be fixed, one rule after the other, until nothing changes."""
        for role in self._vectors():
            self._fix(role.frame, self.held[role.name].frame or "", role.name)
        waiting = [r for r in self._rotations() if self.held[r.name].ends is not None]
        while True:
            if self._rule():
                continue
            self._carry(waiting)
            if self._rule() or self._merge():
                continue
            if waiting:
                if not self._guess(waiting[0]):
                    waiting.pop(0)
            elif not self._infer_point():
                break
        for role in self._vectors():
            self._check_vector(role)
        self._check_earth()

    def _vectors(self) -> Iterator[Role]:
        for role in self.model.roles:
            held = self.held.get(role.name)
            framed = role.frame and role.kind not in ROTATIONS
            if framed and held is not None and held.frame is not None:
                yield role

    def _rotations(self) -> Iterator[Role]:
        return (r for r in self.model.roles if r.kind in ROTATIONS and r.name in self.held)

    def _fix(self, frame_role: str, frame: str, by: str) -> None:
        if frame_role not in self.frames:
            self.frames[frame_role] = frame
            self._fixed_by[frame_role] = by

    def _carry(self, waiting: list[Role]) -> None:
        """Rotations with a known end fix the other; those done leave ``waiting``."""
        progress = True
        while progress:
            progress = False
            for role in tuple(waiting):
                if any(end in self.frames for end in frame_map(role.frame)):
                    waiting.remove(role)
                    self._through(role)
                    progress = True

    def _through(self, role: Role) -> None:
        """Apply one rotation in the direction that fits better."""
        roles, ends = frame_map(role.frame), self._ends(role)
        pairs = self._direction(role, roles, ends)
        wrong = [(r, f) for r, f in pairs if self._fit(r, f) < 0]
        if len(wrong) == len([r for r in roles if r in self.frames]):
            self._disconnected(role, roles, f"; {self.held[role.name].label} maps {_map(ends)}")
            return
        for frame_role, frame in wrong:
            if not self._blame(role, frame_role, frame, ends):
                self._disconnected(role, roles, f"; {self.held[role.name].label} maps {_map(ends)}")
            self.frames[frame_role] = frame
        for frame_role, frame in pairs:
            self._fix(frame_role, frame, role.name)

    def _direction(self, role: Role, roles: Ends, ends: Ends) -> tuple[tuple[str, str], ...]:
        """Pairs (frame role, frame) of the direction that fits; as written where both do."""
        forward = tuple(zip(roles, ends, strict=True))
        backward = tuple(zip(roles, ends[::-1], strict=True))

        def worth(pairs: tuple[tuple[str, str], ...]) -> tuple[int, int]:
            return sum(self._fit(r, f) for r, f in pairs), self._likeness(pairs)

        return backward if worth(backward) > worth(forward) else forward

    def _fit(self, frame_role: str, frame: str) -> int:
        if frame_role not in self.frames:
            return 0
        return 1 if self.frames[frame_role] == frame else -1

    def _likeness(self, pairs: Iterable[tuple[str, str]]) -> int:
        """How much frames look like their roles, by name and by declared axes."""
        points = 0
        for frame_role, frame in pairs:
            axes = self.axes.get(frame, "free")
            points += 4 * (frame.lower() == frame_role) + (frame.lower() == frame_role[0])
            points += 4 * (frame_role == EARTH and axes == "ecef")
            points += 4 * (frame_role in ("nav", "level") and axes in LOCAL_LEVEL)
            points -= 8 * (frame_role == "body" and axes != "free")
        return points

    def _guess(self, role: Role) -> bool:
        """Fix a rotation with neither end known by its looks; ambiguity is a mistake."""
        roles, ends = frame_map(role.frame), self._ends(role)
        forward = self._likeness(zip(roles, ends, strict=True))
        backward = self._likeness(zip(roles, ends[::-1], strict=True))
        if forward == backward:
            self.problems.append(
                (
                    role.name,
                    f"{self.held[role.name].label} maps {_map(ends)}, and nothing tells which of "
                    f"the two is the {roles[0]} frame of {self.model.name}; declare an input it "
                    "reads with its frame",
                )
            )
            return False
        source = ends[0] if forward > backward else ends[1]
        self._fix(roles[0], source, role.name)
        return True

    def _rule(self) -> bool:
        """The model's own rule: what the frame of its point says of the other frames."""
        point = _point(self.model)
        if point is None or point.frame not in self.frames:
            return False
        told = self._told(point)
        for frame_role, frame in told.items():
            if self._fit(frame_role, frame) < 0 and point.name not in self._blamed:
                by = self._fixed_by[frame_role]
                self._misplaced(point.name, self.frames[frame_role], f"that of {by}")
        added = [name for name in told if name not in self.frames]
        for name in added:
            self._fix(name, told[name], self._fixed_by[point.frame])
        return bool(added)

    def _told(self, point: Role) -> Mapping[str, str]:
        held = self.held.get(point.name)
        level = held.level[0] if held is not None and held.level is not None else None
        return self.model.frame_rule(dict(self.frames), self.axes, level)

    def _infer_point(self) -> bool:
        """A point without a frame takes the one that agrees with what is known."""
        point = _point(self.model)
        if point is None or point.name not in self.held or point.frame in self.frames:
            return False
        frame = _point_frame(self.model, point, self.frames, self.axes)
        if frame is not None:
            self._fix(point.frame, frame, point.name)
        return frame is not None

    def _merge(self) -> bool:
        """Rotations bound to none: both ends are one frame."""
        for role in self.model.roles:
            if role.kind not in ROTATIONS or role.name in self.held:
                continue
            ends = frame_map(role.frame)
            if _joined(self.model, self.held, *ends) or self._level_joins(ends):
                continue
            known = [end for end in ends if end in self.frames]
            if len(known) == 1:
                other = ends[1] if known[0] == ends[0] else ends[0]
                self._fix(other, self.frames[known[0]], self._fixed_by[known[0]])
                return True
            if len(known) == 2 and role.name not in self._blamed:
                a, b = (self.frames[end] for end in ends)
                if a != b:
                    self._disconnected(role, ends, f"; bind {role.name} to a rotation between them")
                    self._blamed.add(role.name)
        return False

    def _level_joins(self, ends: Ends) -> bool:
        """True when a geodetic point brings the rotation between two frame roles itself."""
        point = _point(self.model)
        if point is None or point.name not in self.held or self.held[point.name].level is None:
            return False
        return {*ends} <= {*self._told(point)}

    def _check_vector(self, role: Role) -> None:
        held, frame = self.held[role.name], self.frames[role.frame]
        if held.frame == frame or role.name in self._blamed:
            return
        by = self._fixed_by[role.frame]
        self._misplaced(role.name, frame, f"that of {by}")

    def _check_earth(self) -> None:
        """Earth-fixed frames where the model needs them, and no rotation from one to another."""
        frame = self.frames.get(EARTH)
        if frame is not None and self.axes.get(frame) in LOCAL_LEVEL:
            by, axes = self._fixed_by[EARTH], self.axes[frame]
            self.problems.append(
                (
                    by,
                    f"{self.held[by].label} leads to frame {frame!r} with axes {axes!r}, where "
                    f"{self.model.name} needs an earth-fixed frame",
                )
            )
        for role in self._rotations():
            source, target = frame_map(role.frame)
            start = self.frames.get(source)
            if target == EARTH and start is not None and self.axes.get(start) == "ecef":
                self.problems.append(
                    (role.name, f"frame {start!r} is earth-fixed already; leave {role.name} out")
                )

    def _blame(self, rotation: Role, frame_role: str, frame: str, ends: Ends) -> bool:
        """Report the vectors that put a frame role where a rotation does not lead."""
        wrong = [r for r in self._vectors() if r.frame == frame_role]
        wrong = [r for r in wrong if self.held[r.name].frame != frame]
        for role in wrong:
            self._misplaced(role.name, frame, f"{rotation.name} maps {_map(ends)}")
        return bool(wrong)

    def _misplaced(self, name: str, frame: str, why: str) -> None:
        held = self.held[name]
        self._blamed.add(name)
        self.problems.append(
            (
                name,
                f"{held.label} is in frame {held.frame!r}, but {self.model.name} needs it in frame "
                f"{frame!r} ({why})",
            )
        )

    def _disconnected(self, role: Role, ends: Ends, remedy: str) -> None:
        known = [
            f"{self.frames[end]!r} ({self._fixed_by[end]})" for end in ends if end in self.frames
        ]
        what = " and ".join(known) if len(known) == 2 else f"{known[0]} and another frame"
        self.problems.append((role.name, f"no rotation connects {what}{remedy}"))

    def _ends(self, role: Role) -> Ends:
        ends = self.held[role.name].ends
        assert ends is not None
        return ends


def _map(ends: Ends) -> str:
    return f"{ends[0]} -> {ends[1]}"
