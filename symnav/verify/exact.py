"""Fifty-digit truth: the undifferentiated equation, and its central differences on the manifold.

Nothing here reads the structured derivation or its Jacobian. The equation's own definitions are
evaluated with 50 digits at a state moved by ``retraction.retract``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from mpmath import mp

from symnav.binding import STATE, Origin, Source
from symnav.blocks import Block, HeadingBlock, RotationBlock, frame_map
from symnav.blocks.heading import AXES
from symnav.derive import Derivation
from symnav.spec.records import Spec
from symnav.verify import closures
from symnav.verify.numbers import ManyDigits
from symnav.verify.retraction import Vector, retract, rotation_entries

DIGITS = 50
#: Differences are formed with more digits, so that truncation and rounding stay below 1e-45.
DIFFERENCE_DIGITS = 80
STEP = mp.mpf(10) ** -25
#: Largest argument for which those digits are enough; beyond it come as many as it is larger.
LARGEST = 1e10
#: Digits that a difference of two results may have to itself: all but these are their rounding.
SPARE_DIGITS = 10

Arguments = Mapping[str, Sequence[Any]]


@dataclass(frozen=True)
class _Step:
    symbol: sp.Symbol
    value: closures.Closure
    reads: frozenset[sp.Basic]
    frozen: bool


class Exact:
    """One equation with fifty digits.

    Args:
        spec: for the layout and the inputs.
        derivation: only its undifferentiated equation and origins are used.
    """

    def __init__(self, spec: Spec, derivation: Derivation) -> None:
        self._spec = spec
        self._derivation = derivation
        equation = derivation.equation
        system = ManyDigits()
        wanted: set[sp.Basic] = set().union(
            *(e.free_symbols for elements in equation.outputs.values() for e in elements),
            *(e.free_symbols for _, es in equation.covariances.values() for e in es),
        )
        steps = []
        for definition in reversed(equation.definitions):
            if definition.symbol in wanted:
                wanted |= definition.expression.free_symbols
                value = closures.closure(definition.expression, system)
                reads = frozenset(definition.expression.free_symbols)
                steps.append(_Step(definition.symbol, value, reads, definition.frozen))
        self._steps = steps[::-1]
        self._outputs = {
            name: [closures.closure(e, system) for e in elements]
            for name, elements in equation.outputs.items()
        }
        self._covariances = {
            name: [closures.closure(e, system) for e in elements]
            for name, (_, elements) in equation.covariances.items()
        }
        self._moving = [o for s, o in derivation.origins.items() if s in wanted]

    def outputs(self, arguments: Arguments) -> dict[str, Vector]:
        """Every output at the arguments given (one item), Jacobians by differences.

        Args:
            arguments: stored elements by argument name, as mpmath numbers; of one item.

        Returns:
            elements by output name, Jacobians row-major.
        """
        results = self.values(arguments)
        with mp.workdps(_difference_digits(arguments)):
            results |= self._derived(self._on_manifold(arguments))
        return results

    def _derived(self, arguments: Arguments) -> dict[str, Vector]:
        """Jacobians, rates and mapped covariances."""
        equation = self._derivation.equation
        nominal = self._nominal(arguments)
        results: dict[str, Vector] = {}
        first = next(iter(equation.outputs))
        for output in self._derivation.outputs:
            if output.kind == "jacobian":
                results[output.name] = self._jacobian(arguments, nominal, first, output.by)
        for name, (source_output, source) in equation.rates.items():
            results[name] = self._column(arguments, nominal, source_output, source, 0)
        for name, (source, _) in equation.covariances.items():
            covariance = [f(nominal) for f in self._covariances[name]]
            columns = [
                self._column(arguments, nominal, first, source, j) for j in range(source.size)
            ]
            results[name] = _sandwich(columns, covariance)
        return results

    def values(self, arguments: Arguments) -> dict[str, Vector]:
        """The outputs that need no derivative."""
        env = self._nominal(arguments)
        return {name: [f(env) for f in elements] for name, elements in self._outputs.items()}

    def _nominal(self, arguments: Arguments) -> closures.Environment:
        """Every term at the arguments given."""
        env = loaded(self._derivation.origins, arguments)
        for step in self._steps:
            env[step.symbol] = step.value(env)
        return env

    def _moved_terms(
        self, arguments: Arguments, nominal: closures.Environment
    ) -> closures.Environment:
        """Every term at moved arguments: what the move does not reach keeps its nominal value.

        Frozen terms keep it by convention, although the move would reach them.
        """
        env = dict(nominal)
        dirty: set[sp.Basic] = set()
        for symbol, value in loaded(self._derivation.origins, arguments).items():
            if value is not nominal[symbol]:
                env[symbol] = value
                dirty.add(symbol)
        for step in self._steps:
            if not step.frozen and not dirty.isdisjoint(step.reads):
                env[step.symbol] = step.value(env)
                dirty.add(step.symbol)
        return env

    def _jacobian(
        self, arguments: Arguments, nominal: closures.Environment, output: str, by: str
    ) -> Vector:
        """Row-major derivative by the error of the state, or of the input ``by``."""
        rows = len(self._outputs[output])
        layout = self._spec.layout
        width = layout.error_size
        if by:
            (source,) = [s for s in self._derivation.equation.sources if s.name == by]
            columns = [
                self._column(arguments, nominal, output, source, j) for j in range(source.size)
            ]
            return [columns[j][i] for i in range(rows) for j in range(source.size)]
        zero = mp.mpf(0)
        dense = [[zero] * width for _ in range(rows)]
        for place in layout.places.values():
            if not self._touches(place.start, place.block.storage_size):
                continue
            source = Source("", place.block.name, True, place.error_start, place.block.error_size)
            for j in range(source.size):
                column = self._column(arguments, nominal, output, source, j)
                for i in range(rows):
                    dense[i][source.start + j] = column[i]
        return [e for row in dense for e in row]

    def _touches(self, start: int, size: int) -> bool:
        """True when the equation reads any element of a block."""
        for origin in self._moving:
            if origin.argument != STATE:
                continue
            reach = range(origin.index, origin.index + 1)
            if origin.slot is not None or start <= reach.start < start + size:
                return True
        return False

    def _column(
        self,
        arguments: Arguments,
        nominal: closures.Environment,
        output: str,
        source: Source,
        j: int,
    ) -> Vector:
        ends = []
        for step in (STEP, -STEP):
            moved = self._moved(arguments, source, j, step)
            env = self._moved_terms(moved, nominal)
            ends.append([f(env) for f in self._outputs[output]])
        return [_quotient(a, b) for a, b in zip(*ends, strict=True)]

    def _on_manifold(self, arguments: Arguments) -> Arguments:
        """Quaternions made unit to the last digit, where the convention trusts them to be.

        A stored quaternion is a unit one rounded to double; the tangent of its error is that of
        the unit one.
        """
        exact = {name: list(x) for name, x in arguments.items()}
        for place in self._spec.layout.places.values():
            if STATE in exact and _trusted(place.block):
                exact[STATE][place.storage] = _unit(exact[STATE][place.storage])
        for name, declared in self._spec.inputs.items():
            if name in exact and _trusted(declared.block):
                exact[name] = _unit(exact[name])
        return exact

    def _moved(self, arguments: Arguments, source: Source, j: int, step: Any) -> Arguments:
        d = [mp.mpf(0)] * (source.size if source.slot is None else 1)
        d[j] = step
        if not source.state:
            block = self._spec.inputs[source.name].block
            x = list(arguments[source.name])
            raw = source.name in self._derivation.equation.raw
            y = [a + b for a, b in zip(x, d, strict=True)] if raw else retract(
                block, x, d, lambda s, t: self.matrix(arguments, s, t)
            )  # fmt: skip
            return {**arguments, source.name: y}
        place = self._spec.layout.places[source.name]
        x = list(arguments[STATE])
        d = [mp.mpf(0)] * place.block.error_size
        d[j] = step
        x[place.storage] = retract(
            place.block, x[place.storage], d, lambda s, t: self.matrix(arguments, s, t)
        )
        return {**arguments, STATE: x}

    def matrix(self, arguments: Arguments, source: str, target: str) -> Vector:
        """The rotation between two frames at the nominal state, from a block or an input."""
        for block, x in self._rotations(arguments):
            ends = frame_map(block.maps)
            if set(ends) != {source, target}:
                continue
            m = (
                rotation_entries(block, x)
                if isinstance(block, RotationBlock)
                else _heading_entries(block, x[0])
            )
            return m if ends[0] == source else [m[3 * j + i] for i in range(3) for j in range(3)]
        raise AssertionError(f"no rotation between {source} and {target}")

    def _rotations(
        self, arguments: Arguments
    ) -> list[tuple[RotationBlock | HeadingBlock, Sequence[Any]]]:
        found: list[tuple[RotationBlock | HeadingBlock, Sequence[Any]]] = []
        for place in self._spec.layout.places.values():
            if isinstance(place.block, (RotationBlock, HeadingBlock)) and STATE in arguments:
                found.append((place.block, list(arguments[STATE])[place.storage]))
        for name, declared in self._spec.inputs.items():
            if isinstance(declared.block, (RotationBlock, HeadingBlock)) and name in arguments:
                found.append((declared.block, arguments[name]))
        return found


def loaded(origins: Mapping[sp.Symbol, Origin], arguments: Arguments) -> closures.Environment:
    """Argument symbols with their numbers; a slot says which element of its block it is."""
    env: closures.Environment = {}
    for symbol, origin in origins.items():
        if origin.argument in arguments:
            index = origin.index
            if origin.slot is not None:
                index += int(arguments[origins[origin.slot].argument][0])
            env[symbol] = arguments[origin.argument][index]
    return env


def _heading_entries(block: HeadingBlock, angle: Any) -> Vector:
    """R_axis(angle) column by column: e_i cos + e_axis x e_i sin."""
    axis = AXES.index(block.axis)
    m = [mp.mpf(0)] * 9
    i, j = (axis + 1) % 3, (axis + 2) % 3
    m[4 * axis] = mp.mpf(1)
    m[4 * i] = m[4 * j] = mp.cos(angle)
    m[3 * j + i] = mp.sin(angle)
    m[3 * i + j] = -mp.sin(angle)
    return m


def _sandwich(columns: Sequence[Vector], covariance: Vector) -> Vector:
    """J P J^T from the columns of J, row-major."""
    size, rows = len(columns), len(columns[0])
    j = [[columns[k][i] for k in range(size)] for i in range(rows)]
    p = [covariance[k * size : (k + 1) * size] for k in range(size)]
    half = [[sum(j[i][k] * p[k][m] for k in range(size)) for m in range(size)] for i in range(rows)]
    return [
        sum(half[i][m] * j[n][m] for m in range(size)) for i in range(rows) for n in range(rows)
    ]


def _difference_digits(arguments: Arguments) -> int:
    """Digits with which a step beside the largest argument is still seen."""
    largest = max(abs(e) for x in arguments.values() for e in x)
    if largest <= LARGEST:
        return DIFFERENCE_DIGITS
    return DIFFERENCE_DIGITS + int(mp.ceil(mp.log10(largest / LARGEST)))


def _quotient(ahead: Any, behind: Any) -> Any:
    """The slope; zero where the difference is nothing but rounding."""
    difference = ahead - behind
    rounding = mp.mpf(10) ** (SPARE_DIGITS - mp.dps)
    if abs(difference) < rounding * (abs(ahead) + abs(behind)):
        return mp.mpf(0)
    return difference / (2 * STEP)


def _trusted(block: Block) -> bool:
    """True for a quaternion that kernels take as unit."""
    if not isinstance(block, RotationBlock) or block.storage == "dcm":
        return False
    return not block.normalise and block.error != "storage"


def _unit(q: Sequence[Any]) -> Vector:
    length = mp.sqrt(sum(e * e for e in q))
    return [e / length for e in q]
