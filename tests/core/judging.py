"""What an equation must give: value and Jacobian from the references, at random points.

The references know neither layouts nor blocks; what a block stores is described to them as a
quantity, and its error as the retract they know by name. Numbers have many digits throughout, so
that no tolerance hides a missing term.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from random import Random
from typing import Any

from mpmath import mp, mpf

from symnav.blocks import Block, GeodeticBlock, HeadingBlock, RotationBlock, VectorBlock, frame_map
from symnav.spec.records import BySlot, BySystem, Entry, Spec, ToConstant, ToInput, ToState
from tests.core.interpreter import DIGITS, Interpreter
from tests.core.specs import ROUTES, Case, derived
from tests.reference.algebra import (
    Matrix,
    Options,
    Outputs,
    Quantities,
    Vector,
    images,
    sandwich,
    scale,
    transpose,
)
from tests.reference.blocks import Setting, scalar_first, stored, unit
from tests.reference.drawing import number, numbers, quaternion
from tests.reference.earth import to_local
from tests.reference.jacobian import Error, jacobian

Numbers = dict[str, Vector]
Model = Callable[[Quantities, Options], Outputs]
#: Literals are doubles: every one may be off by one part in 2^53.
TOLERANCE = mpf("4e-15")


# -- points --------------------------------------------------------------------------------------


def draw(spec: Spec, seed: int = 1, **given: Sequence[float]) -> Numbers:
    """Stored elements of the state and of every input; ``given`` replaces what is drawn."""
    rng = Random(seed)
    state: Vector = []
    for block in spec.layout.blocks:
        state += draw_block(block, rng, given)
    drawn = {"x": state}
    for name, declared in spec.inputs.items():
        drawn[name] = draw_block(declared.block, rng, given)
    return drawn


def draw_block(block: Block, rng: Random, given: Mapping[str, Sequence[float]]) -> Vector:
    """Stored elements of one block."""
    if block.name in given:
        return [mpf(e) for e in given[block.name]]
    if isinstance(block, RotationBlock):
        q = quaternion(rng)
        if block.storage == "dcm":
            return [e for row in images(lambda v: sandwich(q, v)) for e in row]
        return stored(scale(mpf("1.2") if block.normalise else mpf(1), q), block.storage)
    middle = [(mpf(a) + mpf(b)) / 2 for a, b in zip(block.lower, block.upper, strict=True)]
    reach = [(mpf(b) - mpf(a)) / 2 for a, b in zip(block.lower, block.upper, strict=True)]
    return [m + r * number(rng) for m, r in zip(middle, reach, strict=True)]


# -- quantities ----------------------------------------------------------------------------------


def described(block: Block, x: Vector) -> dict[str, Any]:
    """What a block stores, in the words of the references."""
    if isinstance(block, RotationBlock):
        if block.storage == "dcm":
            return {"wxyz": quaternion_of(x), "maps": frame_map(block.maps)}
        return {"wxyz": scalar_first(x, block.storage), "maps": frame_map(block.maps)}
    if isinstance(block, HeadingBlock):
        return {"angle": x[0], "axis": block.axis, "maps": frame_map(block.maps)}
    if isinstance(block, GeodeticBlock):
        return {"llh": x, "frame": block.frame}
    frame, _ = block.frames
    return {"value": x, "frame": frame or None, "unit": block.units[0]}


def quaternion_of(matrix: Vector) -> Vector:
    """The unit quaternion of a rotation matrix, from its trace and its antisymmetric part."""
    m = [matrix[3 * i : 3 * i + 3] for i in range(3)]
    w = mp.sqrt(1 + m[0][0] + m[1][1] + m[2][2]) / 2
    return unit([w, *((m[i][j] - m[j][i]) / (4 * w) for i, j in ((2, 1), (0, 2), (1, 0)))])


@dataclass(frozen=True)
class Judge:
    """The reference of one entry at one point.

    Attributes:
        spec: with the entry as its only one.
        numbers: stored elements by argument.
    """

    spec: Spec
    numbers: Numbers

    @property
    def entry(self) -> Entry:
        """The entry."""
        return self.spec.entries[0]

    def quantities(self) -> dict[str, Any]:
        """Every bound quantity by role."""
        return {role: self._quantity(role) for role in self.entry.bindings}

    def outputs(self) -> Outputs:
        """Values, rates and covariances."""
        return self._model()(self.quantities(), self._options())

    def jacobian(self) -> Matrix:
        """Rows over the whole error vector of the state."""
        found = [(self._error(role), self._columns(role)) for role in self.entry.bindings]
        active = [(error, columns) for error, columns in found if error and columns]
        dense = self._differences([error for error, _ in active if error])
        width = self.spec.layout.error_size
        rows = [[mpf(0)] * width for _ in dense]
        for row, differences in zip(rows, dense, strict=True):
            for column, value in zip((c for _, cs in active for c in cs), differences, strict=True):
                row[column] += value
        return rows

    def input_jacobian(self, name: str) -> Matrix:
        """Rows over the error of an input."""
        (role,) = [r for r, b in self.entry.bindings.items() if b == ToInput(name)]
        block = self.spec.inputs[name].block
        return self._differences([_error(self, role, block)])

    def _differences(self, errors: Sequence[Error]) -> Matrix:
        first = next(iter(self.outputs()))
        return jacobian(self._model(), self.quantities(), self._options(), errors, first)

    def _quantity(self, role: str) -> dict[str, Any]:
        binding = self.entry.bindings[role]
        if isinstance(binding, ToConstant):
            return self._constant(role, binding)
        if isinstance(binding, BySlot):
            place = self.spec.layout.places[binding.block]
            slot = place.start + int(self.numbers[binding.slot][0])
            return {"value": [self.numbers["x"][slot]], "frame": None, "unit": place.block.units[0]}
        binding = self._chosen(role)
        if isinstance(binding, ToState):
            place = self.spec.layout.places[binding.block]
            return described(place.block, self.numbers["x"][place.storage])
        assert isinstance(binding, ToInput)
        return described(self.spec.inputs[binding.name].block, self.numbers[binding.name])

    def _chosen(self, role: str) -> Any:
        binding = self.entry.bindings[role]
        if isinstance(binding, BySystem):
            return binding.choices[int(self.numbers[binding.selector][0])][1]
        return binding

    def _constant(self, role: str, binding: ToConstant) -> dict[str, Any]:
        declared = self.entry.model.role(role)
        values = [mpf(v) for v in binding.values]
        if declared.kind == "rotation":
            source, target = frame_map(declared.frame)
            maps = (self.entry.frames[source], self.entry.frames[target])
            return {"wxyz": unit(values), "maps": maps}
        if declared.kind == "geodetic":
            return {"llh": values, "frame": None}
        return {"value": values, "frame": self.entry.frames.get(declared.frame)}

    def _error(self, role: str) -> Error | None:
        binding = self.entry.bindings[role]
        if isinstance(binding, BySlot):
            return Error(role)
        binding = self._chosen(role)
        if not isinstance(binding, ToState):
            return None
        return _error(self, role, self.spec.layout.places[binding.block].block)

    def _columns(self, role: str) -> list[int]:
        binding = self.entry.bindings[role]
        if isinstance(binding, BySlot):
            start = self.spec.layout.places[binding.block].error_start
            return [start + int(self.numbers[binding.slot][0])]
        binding = self._chosen(role)
        if not isinstance(binding, ToState):
            return []
        place = self.spec.layout.places[binding.block]
        columns = list(range(place.error.start, place.error.stop))
        if isinstance(place.block, RotationBlock) and place.block.error == "storage":
            # The references order the components w, x, y, z.
            return [columns[place.block.storage.index(part)] for part in "wxyz"]
        return columns

    def _options(self) -> dict[str, Any]:
        blocks = [*self.spec.layout.blocks, *(i.block for i in self.spec.inputs.values())]
        rotations = [b for b in blocks if isinstance(b, RotationBlock)]
        normalised = any(b.normalise for b in rotations)
        form = "normalised" if normalised else "homogeneous"
        level = self.entry.frames.get("level")
        return {**self.entry.options, "quaternion": form, "axes_frame": level}

    def _model(self) -> Model:
        """The reference; a geodetic position brings the attitude of its local-level axes."""
        module = importlib.import_module(f"tests.reference.{self.entry.model.name}")
        reference: Model = module.value
        place = self._geodetic()
        if place is None:
            return reference

        def with_level(q: Quantities, options: Options) -> Outputs:
            moving = place.attitude_frame == "moving"
            llh = (q if moving else self.quantities())["position"]["llh"]
            axes = images(lambda v: to_local(llh, v, place.error_axes))
            level = {
                "matrix": [e for row in transpose(axes) for e in row],
                "maps": (place.error_frame, place.frame),
            }
            return reference({**q, "nav_to_ecef": level}, options)

        return with_level

    def _geodetic(self) -> GeodeticBlock | None:
        binding = self.entry.bindings.get("position")
        if isinstance(binding, ToState):
            block = self.spec.layout.places[binding.block].block
        elif isinstance(binding, ToInput):
            block = self.spec.inputs[binding.name].block
        else:
            return None
        return block if isinstance(block, GeodeticBlock) else None


def _error(judge: Judge, role: str, block: Block) -> Error:
    """The error of a block in the words of the references."""
    if isinstance(block, RotationBlock):
        return Error(role, "rotation", block.error)
    if isinstance(block, HeadingBlock):
        return Error(role, "heading")
    if isinstance(block, GeodeticBlock):
        return Error(role, "geodetic", block.error_axes)
    assert isinstance(block, VectorBlock)
    if not block.error_frame or block.error_frame == block.frame:
        return Error(role, setting=Setting(error_sign=block.error_sign))
    return Error(
        role,
        setting=Setting(
            error_sign=block.error_sign,
            rotation=rotation_between(judge.spec, judge.numbers, block.error_frame, block.frame),
            frames=(block.error_frame, block.frame),
        ),
    )


def rotation_between(spec: Spec, drawn: Numbers, source: str, target: str) -> dict[str, Any]:
    """The block or input that connects two frames, as a quantity."""
    stores = [(p.block, drawn["x"][p.storage]) for p in spec.layout.places.values()]
    stores += [(i.block, drawn[name]) for name, i in spec.inputs.items()]
    for block, x in stores:
        if isinstance(block, (RotationBlock, HeadingBlock)):
            item = described(block, x)
            if set(item["maps"]) == {source, target}:
                return item
    raise ValueError(f"nothing connects {source} and {target}")


# -- comparison ----------------------------------------------------------------------------------


def check(case: Case, seed: int = 1, absolute: str | None = None, **given: Sequence[float]) -> None:
    """Both routes against the reference: every output, every Jacobian, every zero.

    Args:
        case: model, layout and bindings.
        seed: of the point.
        absolute: largest error of the first output, where that is less than the default.
        given: elements of blocks that are not to be drawn.
    """
    spec = case.spec()
    derivation = derived(spec)
    point = draw(spec, seed, **given)
    judge = Judge(spec, point)
    outputs = judge.outputs()
    first = next(iter(outputs))
    for route, lower in ROUTES.items():
        function = lower(spec, derivation)
        result = Interpreter(function, DIGITS).run(point)
        assert not result.failed, (route, result.failed)
        for output in derivation.outputs:
            where = f"{route}: {output.name}"
            if output.kind == "jacobian":
                rows = judge.input_jacobian(output.by) if output.by else judge.jacobian()
                expected = [e for row in rows for e in row]
                actual = result.dense(output.name, output.rows, output.columns)
                assert_close(actual, expected, where)
            else:
                name = output.name.removeprefix("value_")
                expected = outputs[first if name == "value" else name]
                limit = absolute if output is derivation.outputs[0] else None
                assert_close(result.dense(output.name, output.rows), expected, where, limit)


def assert_close(
    actual: Sequence[Any], expected: Sequence[Any], where: str, absolute: str | None = None
) -> None:
    """Compare element by element; a tolerance in units, or relative to the largest element."""
    assert len(actual) == len(expected), where
    size = max([mpf(1), *(abs(e) for e in expected)])
    limit = mpf(absolute) if absolute is not None else TOLERANCE * size
    worst = max(abs(a - b) for a, b in zip(actual, expected, strict=True))
    assert worst <= limit, f"{where}: off by {mp.nstr(worst, 3)}, allowed {mp.nstr(limit, 3)}"


def random_error(spec: Spec, seed: int, size: float) -> Vector:
    """An error vector."""
    return numbers(Random(seed), spec.layout.error_size, size)


def product_of(*groups: Iterable[Any]) -> list[tuple[Any, ...]]:
    """Every combination, as parameters of a test."""
    import itertools

    return list(itertools.product(*groups))
